package org.cellgauge.pose;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;

/**
 * Modes of the camera pose given all references: damped Gauss-Newton with the residual covariances frozen at the mode
 * itself, repeated until mode and covariances agree.
 */
public final class CameraModeFinder {
    private static final int MAX_FREEZES = 100;
    private static final double AGREEMENT = 1e-6;
    /** A mode with less than this share of the heaviest one's mass cannot change any figure shown. */
    private static final double NEGLIGIBLE_LOG_WEIGHT = -20;
    private static final double SAME_MODE_STDS = 1e-2;

    private final ReferenceView view;
    private final PinholeCamera camera;
    private final ReferenceNoise noise;
    private final IntrinsicsPrior intrinsicsPrior;
    private final PosePrior posePrior;

    /**
     * A finder.
     *
     * @param view references seen
     * @param camera intrinsics; unknown ones start at these values
     * @param noise covariance of the residuals
     * @param intrinsicsPrior unknown intrinsics
     * @param posePrior prior of the pose, or null for a flat one
     */
    public CameraModeFinder(ReferenceView view, PinholeCamera camera, ReferenceNoise noise,
            IntrinsicsPrior intrinsicsPrior, PosePrior posePrior) {
        this.view = view;
        this.camera = camera;
        this.noise = noise;
        this.intrinsicsPrior = intrinsicsPrior;
        this.posePrior = posePrior;
    }

    /**
     * Finds the modes.
     *
     * @param worldFromCamera start
     * @return the mode reached from the start and, where the references may be seen mirrored and that mode has any
     *     weight, that one; the heavier first; empty if the start does not lead to a mode
     */
    public List<PoseMode> modes(RigidTransform worldFromCamera) {
        RigidTransform start = view.cameraFromSet(worldFromCamera);
        PoseMode first = fitFrom(start);
        if (first == null) {
            return Collections.emptyList();
        }
        List<PoseMode> modes = new ArrayList<>();
        modes.add(first);
        RigidTransform planeFromSet = planeFromSet();
        if (planeFromSet != null) {
            RigidTransform cameraFromPlane = first.state().cameraFromSet().compose(planeFromSet.inverse());
            RigidTransform mirrored = MarkerPoseFinder.mirrored(cameraFromPlane).compose(planeFromSet);
            PoseMode second = fitFrom(mirrored);
            if (second != null && distinct(first, second)) {
                double difference = second.logWeight() - first.logWeight();
                if (difference > -NEGLIGIBLE_LOG_WEIGHT) {
                    modes.clear();
                }
                if (difference > NEGLIGIBLE_LOG_WEIGHT) {
                    modes.add(difference > 0 ? 0 : modes.size(), second);
                }
            }
        }
        return modes;
    }

    /** Rotation that turns the common plane of all references into z = 0, or null where they have none. */
    private RigidTransform planeFromSet() {
        double[] r = view.references().get(0).worldFromMarker().rotation();
        double[] points = view.points();
        double extent = 0;
        double height = 0;
        double first = r[2] * points[0] + r[5] * points[1] + r[8] * points[2];
        for (int k = 0; k < points.length; k += 3) {
            double h = r[2] * points[k] + r[5] * points[k + 1] + r[8] * points[k + 2];
            height = Math.max(height, Math.abs(h - first));
            extent = Math.max(extent, Math.hypot(Math.hypot(points[k], points[k + 1]), points[k + 2]));
        }
        // references far out of one plane tell a mirrored pose apart at sight
        return height > 0.02 * extent ? null : RigidTransform.of(r, new double[3]).inverse();
    }

    private static boolean distinct(PoseMode a, PoseMode b) {
        double[] step = b.state().stepFrom(a.state());
        double[] covariance = a.covariance();
        double squared = 0;
        for (int i = 0; i < 6; i++) {
            squared += step[i] * step[i] / covariance[i * a.dimension() + i];
        }
        return Math.sqrt(squared) > SAME_MODE_STDS;
    }

    private PoseMode fitFrom(RigidTransform cameraFromSet) {
        CameraState state = CameraState.of(cameraFromSet, camera);
        state.unknowns = new double[view.unknowns()];
        state.noise = noise.noise();
        ReprojectionFit fit = new ReprojectionFit(view.points(), view.observed(), view.columns(), view.unknowns(),
                intrinsicsPrior, posePrior);
        CameraState before = new CameraState();
        double cost = Double.NaN;
        for (int i = 0; i < MAX_FREEZES; i++) {
            before.copyFrom(state);
            if (!fit.freeze(noise, state)) {
                return null;
            }
            cost = fit.fit(state);
            if (Double.isNaN(cost)) {
                return null;
            }
            fit.evaluate(state, true);
            double[] step = state.stepFrom(before);
            double squared = 0;
            for (int k = 0; k < 6; k++) {
                squared += step[k] * step[k] * fit.information()[k * fit.columns() + k];
            }
            for (int k = 0; k < intrinsicsPrior.count(); k++) {
                double d = state.intrinsics[intrinsicsPrior.index(k)] - before.intrinsics[intrinsicsPrior.index(k)];
                squared += d * d * fit.information()[(6 + k) * (fit.columns() + 1)];
            }
            for (int k = 0; k < view.unknowns(); k++) {
                double d = state.unknowns[k] - before.unknowns[k];
                squared += d * d * fit.information()[(6 + intrinsicsPrior.count() + k) * (fit.columns() + 1)];
            }
            if (squared < AGREEMENT * AGREEMENT) {
                break;
            }
        }
        return PoseMode.of(fit, state, cost, view.size());
    }
}
