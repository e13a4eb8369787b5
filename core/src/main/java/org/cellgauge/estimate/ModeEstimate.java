package org.cellgauge.estimate;

import java.util.List;

/** One of several poses that explain the photo, with the share of the posterior it holds; immutable. */
public final class ModeEstimate {
    /** Share of the posterior above which poses other than the first make a pose ambiguous. */
    public static final double AMBIGUOUS_SHARE = 0.01;

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
     * Whether other poses than the first hold too much of the posterior to be left aside.
     *
     * @param modes the modes of one pose, heaviest first
     * @return true where they hold more than {@link #AMBIGUOUS_SHARE}
     */
    public static boolean areAmbiguous(List<ModeEstimate> modes) {
        return modes.size() > 1 && 1 - modes.get(0).weight() > AMBIGUOUS_SHARE;
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
