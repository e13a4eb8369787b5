package org.cellgauge.internal.pose;

import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.settings.InitialEstimate;

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
     * Estimates the camera pose.
     *
     * @param view references seen
     * @param camera intrinsics
     * @return worldFromCamera, or null where the estimator finds none
     */
    RigidTransform estimate(ReferenceView view, PinholeCamera camera);
}
