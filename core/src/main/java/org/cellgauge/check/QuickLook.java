package org.cellgauge.check;

import io.reactivex.rxjava3.core.Flowable;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.IntSupplier;
import org.cellgauge.estimate.IntrinsicsEstimate;
import org.cellgauge.estimate.ModeEstimate;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.PointEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.estimate.ImageEllipses;
import org.cellgauge.internal.laplace.CameraFit;
import org.cellgauge.internal.laplace.LinearModel;
import org.cellgauge.internal.laplace.ObjectFit;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.placement.ReferenceCheck;
import org.jspecify.annotations.Nullable;

/**
 * The third stage of a check: the poses that explain a photo best, with Laplace's approximation of their uncertainty,
 * and the way from there to the chains. Immutable.
 */
public final class QuickLook {
    final CellModes modes;
    private final CheckUpdate update;

    private QuickLook(CellModes modes, CellEstimate estimate) {
        this.modes = modes;
        update = new CheckUpdate(CheckUpdate.Phase.QUICK_LOOK, estimate, 0, null);
    }

    /**
     * Laplace's approximation at the modes of a photo.
     *
     * @param modes poses that explain it best
     * @return the quick look
     */
    static QuickLook of(CellModes modes) {
        return new QuickLook(modes, estimate(modes));
    }

    CellEstimate estimate() {
        return update.estimate();
    }

    /**
     * What it says.
     *
     * @return an update of the phase {@link CheckUpdate.Phase#QUICK_LOOK}; its camera pose is the heaviest mode
     */
    public CheckUpdate update() {
        return update;
    }

    /**
     * Standard deviation of each corner coordinate that was assumed or estimated.
     *
     * @return px
     */
    public double pixelStdPx() {
        return modes.observed.errors.usualStdPx(modes.camera.noiseLevel);
    }

    /**
     * Whether the references fit together, and what explains it where they do not: no chain is needed for it.
     *
     * @return the same as that of the result
     */
    public ReferenceCheck referenceCheck() {
        return modes.references();
    }

    /**
     * The rest of the check: running statistics, the result last.
     *
     * <dl>
     * <dt><b>Backpressure:</b></dt>
     * <dd>Latest value: a slow subscriber misses updates but always gets the newest and the result.</dd>
     * <dt><b>Scheduler:</b></dt>
     * <dd>Works on the thread that subscribes; chains step on threads of their own.</dd>
     * <dt><b>Error handling:</b></dt>
     * <dd>{@link org.cellgauge.cell.InputRefusedException} where no chain can start; anything else is a fault of the
     * program. Cancelling stops the chains at once.</dd>
     * </dl>
     *
     * @param threads asked again and again how many threads to step the chains on, at least 1; no figure depends on it
     * @return updates; each subscription runs the chains anew, with the same draws
     */
    public Flowable<CheckUpdate> chains(IntSupplier threads) {
        return Flowable.defer(() -> new ChainRun(this).stream(threads)).onBackpressureLatest();
    }

    private static CellEstimate estimate(CellModes cell) {
        CameraFit camera = cell.camera;
        LinearModel linear = new LinearModel(camera);
        PoseEstimate cameraPose = linear.cameraPose();
        @Nullable IntrinsicsEstimate intrinsics = null;
        CameraState state = camera.mode().state();
        if (camera.intrinsicsPrior.count() > 0) {
            List<String> names = new ArrayList<>();
            double[] mean = new double[camera.intrinsicsPrior.count()];
            double[] priorMean = new double[mean.length];
            double[] priorStd = new double[mean.length];
            for (int i = 0; i < mean.length; i++) {
                names.add(state.lens.parameterNames().get(camera.intrinsicsPrior.index(i)));
                mean[i] = state.intrinsics[camera.intrinsicsPrior.index(i)];
                priorMean[i] = camera.intrinsicsPrior.mean(i);
                priorStd[i] = camera.intrinsicsPrior.std(i);
            }
            intrinsics = new IntrinsicsEstimate(names, mean, linear.intrinsicsCovariance(), priorMean, priorStd,
                    camera.intrinsicsPrior.estimatedCount());
        }
        PinholeCamera lens = ImageEllipses.camera(camera.lens, camera.intrinsicsPrior, intrinsics);
        List<ObjectEstimate> list = new ArrayList<>();
        for (ObjectFit object : cell.objects) {
            List<ModeEstimate> modes = new ArrayList<>();
            double[] weights = weights(object.modes);
            LinearModel.ObjectLink link = linear.new ObjectLink(object, 0);
            PoseEstimate pose = link.poseEstimate();
            modes.add(new ModeEstimate(weights[0], pose));
            for (int k = 1; k < weights.length; k++) {
                modes.add(new ModeEstimate(weights[k], linear.new ObjectLink(object, k).poseEstimate()));
            }
            PointEstimate grip = link.grip();
            double[] gripMm = object.marker.gripMm();
            list.add(new ObjectEstimate(object.marker, pose, grip, link.budgetWhenAsked(new double[3]),
                    gripMm == null ? null : link.budgetWhenAsked(gripMm),
                    ImageEllipses.of(lens, cameraPose, pose.meanTransform().translationMm(),
                            pose.positionCovarianceMm2()),
                    grip == null ? null
                            : ImageEllipses.of(lens, cameraPose, grip.meanMm(), grip.covarianceMm2()),
                    modes));
        }
        return new CellEstimate(cameraPose, Collections.singletonList(new ModeEstimate(1, cameraPose)), intrinsics,
                list);
    }

    private static double[] weights(List<PoseMode> modes) {
        double[] weights = new double[modes.size()];
        double sum = 0;
        for (int k = 0; k < weights.length; k++) {
            weights[k] = Math.exp(modes.get(k).logWeight() - modes.get(0).logWeight());
            sum += weights[k];
        }
        for (int k = 0; k < weights.length; k++) {
            weights[k] /= sum;
        }
        return weights;
    }
}
