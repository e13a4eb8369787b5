package org.cellgauge.pose;

/**
 * How far the eight image coordinates of a reference's corners may be from where the pose puts them: the covariance of
 * their residuals, split by what causes it.
 */
public interface ReferenceNoise {
    /**
     * Covariance of the residuals of one reference at a pose.
     *
     * @param state pose and intrinsics
     * @param marker index of the reference in its {@link ReferenceView}
     * @param placementPx2 receives the 8x8 part that comes from the placement of the reference, row by row, px²
     * @param pixelPx2 receives the 8x8 part that comes from corner noise, row by row, px²
     * @return false, with the outputs undefined, if a corner is not in front of the camera
     */
    boolean covariance(CameraState state, int marker, double[] placementPx2, double[] pixelPx2);

    /**
     * The added noise that it is evaluated at.
     *
     * @return the u of {@link AddedNoise}; 0 where the noise is stated
     */
    default double noise() {
        return 0;
    }
}
