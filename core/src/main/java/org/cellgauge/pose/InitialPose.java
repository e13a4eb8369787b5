package org.cellgauge.pose;

import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;

/** A first estimate of the camera pose, from which fits and chains start. */
public interface InitialPose {
    /** Mean of the camera poses that each reference gives alone (thesis, section 5.4). */
    InitialPose AVERAGE = new AverageInitialPose();
    /** Random sample consensus over all corners (thesis, Table 9.7). */
    InitialPose RANSAC = new RansacInitialPose();
    /** Perspective-n-point over all references at once, refined by least squares. */
    InitialPose PNP = new PnpInitialPose();

    /**
     * Its name in settings and files.
     *
     * @return {@code average}, {@code ransac} or {@code pnp}
     */
    String optionName();

    /**
     * Estimates the camera pose.
     *
     * @param view references seen
     * @param camera intrinsics
     * @return worldFromCamera, or null where the estimator finds none
     */
    RigidTransform estimate(ReferenceView view, PinholeCamera camera);
}
