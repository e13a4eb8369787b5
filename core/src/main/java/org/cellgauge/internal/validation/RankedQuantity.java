package org.cellgauge.internal.validation;

import org.cellgauge.internal.statistics.RankHistogram;

/** Ranks of the true values of one quantity among posterior draws, and its errors in stated deviations. */
public final class RankedQuantity {
    private final String part;
    private final String name;
    private final RankHistogram ranks;
    private final double meanError;
    private final double rmsError;

    RankedQuantity(String part, String name, RankHistogram ranks, double meanError, double rmsError) {
        this.part = part;
        this.name = name;
        this.ranks = ranks;
        this.meanError = meanError;
        this.rmsError = rmsError;
    }

    /**
     * The part of the cell.
     *
     * @return {@code camera} or for instance {@code object 5}
     */
    public String part() {
        return part;
    }

    /**
     * The quantity: a coordinate of the pose or grip in world axes, or {@code log_density} (of the camera's posterior),
     * {@code distance_mm} (camera to object), {@code norm} and {@code grip_norm} (Mahalanobis distance from the mean).
     *
     * @return its name, unit included
     */
    public String name() {
        return name;
    }

    /**
     * The ranks.
     *
     * @return a copy
     */
    public RankHistogram ranks() {
        RankHistogram copy = new RankHistogram(Validation.RANKED_DRAWS, ranks.counts().length);
        copy.merge(ranks);
        return copy;
    }

    /**
     * Mean of (truth - mean) / stated standard deviation over the simulations.
     *
     * @return 0 if the estimate has no bias; NaN for what is no coordinate
     */
    public double meanError() {
        return meanError;
    }

    /**
     * Root mean square of (truth - mean) / stated standard deviation over the simulations.
     *
     * @return 1 if the deviations are right, more if they are too small; NaN for what is no coordinate
     */
    public double rmsError() {
        return rmsError;
    }
}
