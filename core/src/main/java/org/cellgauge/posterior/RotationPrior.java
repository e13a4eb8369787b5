package org.cellgauge.posterior;

import org.cellgauge.pose.CameraState;

/** What is taken of the camera's rotation beforehand. */
public enum RotationPrior {
    /** Every rotation alike (Haar measure): no direction of the world is special. */
    UNIFORM,
    /** Flat in the Euler angles, as the thesis has it without saying so; it favours theta near +-90 degrees. */
    FLAT_IN_EULER_ANGLES;

    /**
     * Log density by the uniform measure over rotations.
     *
     * @param state pose of the references in the camera frame
     * @return up to a constant
     */
    public double logDensity(CameraState state) {
        if (this == UNIFORM) {
            return 0;
        }
        // sin(theta) is minus the element (3, 1) of worldFromCamera, which is (1, 3) of its transpose
        double sine = state.rotation[2];
        return -0.5 * Math.log(Math.max(1 - sine * sine, Double.MIN_NORMAL));
    }
}
