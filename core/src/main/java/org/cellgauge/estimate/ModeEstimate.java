package org.cellgauge.estimate;

import java.util.List;

/**
 * One of several poses that explain the photo, with the share of the posterior it holds.
 *
 * @param weight share of the posterior, 0 to 1
 * @param pose the pose within this mode: mean and covariance of its draws
 */
public record ModeEstimate(double weight, PoseEstimate pose) {
    /** Share of the posterior above which poses other than the first make a pose ambiguous. */
    public static final double AMBIGUOUS_SHARE = 0.01;

    /**
     * Whether other poses than the first hold too much of the posterior to be left aside.
     *
     * @param modes the modes of one pose, heaviest first
     * @return true where they hold more than {@link #AMBIGUOUS_SHARE}
     */
    public static boolean areAmbiguous(List<ModeEstimate> modes) {
        return modes.size() > 1 && 1 - modes.get(0).weight() > AMBIGUOUS_SHARE;
    }
}
