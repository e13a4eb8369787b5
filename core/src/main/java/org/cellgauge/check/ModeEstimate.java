package org.cellgauge.check;

/** One of several poses that explain the photo, with the share of the posterior it holds; immutable. */
public final class ModeEstimate {
    private final double weight;
    private final PoseEstimate pose;

    /**
     * A mode.
     *
     * @param weight share of the draws, 0 to 1
     * @param pose mean and covariance of the draws of this mode
     */
    public ModeEstimate(double weight, PoseEstimate pose) {
        this.weight = weight;
        this.pose = pose;
    }

    /**
     * Share of the posterior.
     *
     * @return 0 to 1
     */
    public double weight() {
        return weight;
    }

    /**
     * The pose within this mode.
     *
     * @return mean and covariance
     */
    public PoseEstimate pose() {
        return pose;
    }
}
