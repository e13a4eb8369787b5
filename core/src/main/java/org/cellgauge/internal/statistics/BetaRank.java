package org.cellgauge.internal.statistics;

import org.apache.commons.math3.distribution.BetaDistribution;

/**
 * Ranks among sorted draws that belong to points of a Beta distribution. A rank is a whole number: its neighbours tell
 * with two values of the distribution function what a solver finds after a dozen.
 */
public final class BetaRank {
    private final BetaDistribution beta;
    private final int total;

    /**
     * Ranks among some draws.
     *
     * @param alpha first shape parameter, positive
     * @param beta second shape parameter, positive
     * @param total number of draws, at least 1
     */
    public BetaRank(double alpha, double beta, int total) {
        // no numbers are drawn, so there is no generator
        this.beta = new BetaDistribution(null, alpha, beta);
        this.total = total;
    }

    /**
     * The last rank whose share of the draws does not exceed a point.
     *
     * @param probability of the point, in (0, 1)
     * @param deviations about where it is, in standard deviations from the mean
     * @return from 0 to the number of draws
     */
    public int floor(double probability, double deviations) {
        double mean = beta.getNumericalMean();
        double guess = mean + deviations * Math.sqrt(beta.getNumericalVariance());
        int from = (int) Math.min(Math.max(Math.floor(guess * total), 0), total);
        int step = 1;
        // the rank is at least low and less than high
        int low;
        int high;
        if (isBelow(from, probability)) {
            low = from;
            while (low + step <= total && isBelow(low + step, probability)) {
                low += step;
                step *= 2;
            }
            high = Math.min(low + step, total + 1);
        } else {
            high = from;
            while (high - step > 0 && !isBelow(high - step, probability)) {
                high -= step;
                step *= 2;
            }
            low = Math.max(high - step, 0);
        }
        while (high - low > 1) {
            int middle = (low + high) / 2;
            if (isBelow(middle, probability)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    private boolean isBelow(int rank, double probability) {
        return rank == 0 || rank <= total && beta.cumulativeProbability((double) rank / total) <= probability;
    }
}
