package org.cellgauge.check;

import java.util.List;
import java.util.function.Function;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.pose.CameraModeFinder;
import org.cellgauge.pose.CameraState;
import org.cellgauge.pose.CornerErrors;
import org.cellgauge.pose.IntrinsicsPrior;
import org.cellgauge.pose.NoiseBelief;
import org.cellgauge.pose.PoseMode;
import org.cellgauge.pose.PosePrior;
import org.cellgauge.pose.ReferenceView;
import org.cellgauge.posterior.CameraChart;
import org.cellgauge.posterior.CameraLikelihood;
import org.cellgauge.posterior.CameraPosterior;
import org.cellgauge.posterior.CentredChart;
import org.cellgauge.posterior.EulerChart;
import org.cellgauge.posterior.SharedPrior;
import org.cellgauge.sampling.StudentTMixture;
import org.cellgauge.settings.CheckSettings;

/** The camera posterior of one photo, as the samplers need it; immutable. */
final class CameraTarget {
    final ReferenceView view;
    final CheckSettings settings;
    final IntrinsicsPrior intrinsicsPrior;
    final PosePrior posePrior;
    final List<PoseMode> modes;
    final RigidTransform initialWorldFromCamera;
    final CornerErrors errors;
    final NoiseBelief belief;
    private final double[] logNoise;
    private final Function<ReferenceView, CameraModeFinder> finders;

    CameraTarget(ReferenceView view, CheckSettings settings, IntrinsicsPrior intrinsicsPrior, PosePrior posePrior,
            List<PoseMode> modes, RigidTransform initialWorldFromCamera,
            Function<ReferenceView, CameraModeFinder> finders) {
        this(view, settings, intrinsicsPrior, posePrior, modes, initialWorldFromCamera, finders, null, null, null);
    }

    /**
     * A target of a photo whose markers share unknowns.
     *
     * @param errors errors of the corners; null where their noise is stated and nothing else is unknown
     * @param belief what is known of the added noise; null where it is stated
     * @param logNoise the same without what the references say, by node
     */
    CameraTarget(ReferenceView view, CheckSettings settings, IntrinsicsPrior intrinsicsPrior, PosePrior posePrior,
            List<PoseMode> modes, RigidTransform initialWorldFromCamera,
            Function<ReferenceView, CameraModeFinder> finders, CornerErrors errors, NoiseBelief belief,
            double[] logNoise) {
        this.errors = errors;
        this.belief = belief;
        this.logNoise = logNoise;
        this.view = view;
        this.settings = settings;
        this.intrinsicsPrior = intrinsicsPrior;
        this.posePrior = posePrior;
        this.modes = modes;
        this.initialWorldFromCamera = initialWorldFromCamera;
        this.finders = finders;
    }

    /** The same camera from other references, at the modes found for them. */
    CameraTarget with(ReferenceView other, List<PoseMode> otherModes) {
        return new CameraTarget(other, settings, intrinsicsPrior, posePrior, otherModes,
                initialWorldFromCamera, finders, errors, belief, logNoise);
    }

    /** Finds the modes as they were found for this target, from other references. */
    CameraModeFinder finder(ReferenceView other) {
        return finders.apply(other);
    }

    /** The posterior in the centred chart about the heaviest mode, a new instance for one thread. */
    CameraPosterior centred() {
        return posterior(new CentredChart(modes.get(0).state(), intrinsicsPrior, belief != null));
    }

    /** The posterior in the thesis' coordinates, a new instance for one thread. */
    CameraPosterior euler() {
        return posterior(new EulerChart(view.centroidMm(), modes.get(0).state(), intrinsicsPrior,
                belief != null));
    }

    /** Laplace's approximation at each mode, with what is known of the noise, in the centred chart. */
    StudentTMixture mixture() {
        return TunedMixture.ofModes(modes, belief);
    }

    private CameraPosterior posterior(CameraChart chart) {
        CornerErrors sampled = belief == null ? null : errors;
        Likelihoods likelihoods = Likelihoods.of(settings.model().likelihood());
        CameraLikelihood likelihood = intrinsicsPrior.count() == 0
                ? likelihoods.likelihood(view, modes, sampled, settings.model().kappa())
                : likelihoods.farReaching(view, modes, finder(view).noise(), sampled, settings.model().kappa());
        boolean shared = view.unknowns() > 0 || belief != null;
        return new CameraPosterior(chart, likelihood, settings.model().rotationPrior(), intrinsicsPrior, posePrior,
                shared ? new SharedPrior(logNoise) : null);
    }

    /** The initial estimate as a state; its intrinsics are the prior means. */
    CameraState initialState() {
        CameraState state = modes.get(0).state();
        RigidTransform cameraFromSet = view.cameraFromSet(initialWorldFromCamera);
        System.arraycopy(cameraFromSet.rotation(), 0, state.rotation, 0, 9);
        System.arraycopy(cameraFromSet.translationMm(), 0, state.offset, 0, 3);
        for (int i = 0; i < intrinsicsPrior.count(); i++) {
            state.intrinsics[intrinsicsPrior.index(i)] = intrinsicsPrior.mean(i);
        }
        return state;
    }
}
