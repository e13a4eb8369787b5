package org.cellgauge.internal.pose;

import java.util.List;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.settings.InitialEstimate;
import org.jspecify.annotations.Nullable;

/** A first estimate of the camera pose, from which fits and chains start. */
public interface InitialPose {
    /** Mean of the camera poses that each reference gives alone (thesis, section 5.4). */
    InitialPose AVERAGE = new AverageInitialPose();
    /** Random sample consensus over all corners (thesis, Table 9.7). */
    InitialPose RANSAC = new RansacInitialPose();
    /** Perspective-n-point over all references at once, refined by least squares. */
    InitialPose PNP = new PnpInitialPose();

    /**
     * The estimator of a first estimate.
     *
     * @param estimate as the settings have it
     * @return one of the above
     */
    static InitialPose of(InitialEstimate estimate) {
        switch (estimate) {
            case AVERAGE:
                return AVERAGE;
            case RANSAC:
                return RANSAC;
            default:
                return PNP;
        }
    }

    /**
     * A first estimate and how good it is.
     *
     * @param worldFromCamera the camera pose
     * @param costPx2 how far it leaves corners off: sum of squared distances, each at most that of a foreign marker,
     *     px²
     */
    record Estimate(RigidTransform worldFromCamera, double costPx2) {
    }

    /**
     * The best of some candidates, refined by least squares as {@link #PNP} does: for many like views, of which it is
     * known what each reference alone says.
     *
     * @param view references seen
     * @param camera intrinsics
     * @param worldFromCameras candidates
     * @return the estimate, or null where there is no candidate before which any corner lies
     */
    static @Nullable Estimate best(ReferenceView view, PinholeCamera camera, List<RigidTransform> worldFromCameras) {
        return PnpInitialPose.refined(view, camera, worldFromCameras);
    }

    /**
     * Estimates the camera pose.
     *
     * @param view references seen
     * @param camera intrinsics
     * @return worldFromCamera, or null where the estimator finds none
     */
    @Nullable RigidTransform estimate(ReferenceView view, PinholeCamera camera);
}
