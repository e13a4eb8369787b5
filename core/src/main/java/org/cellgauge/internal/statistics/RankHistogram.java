package org.cellgauge.internal.statistics;

import java.util.Arrays;
import org.apache.commons.math3.special.Gamma;

/**
 * Ranks of true values among posterior draws, in bins, and whether they are uniform as a right posterior makes them.
 *
 * <p>Simulation-based calibration (Talts, Betancourt, Simpson, Vehtari &amp; Gelman 2018, "Validating Bayesian
 * inference algorithms with simulation-based calibration", arXiv:1804.06788): draw a truth from the prior, data from
 * the truth, L draws from the posterior; the rank of the truth among them is uniform on 0..L (theorem 1), provided that
 * the draws are independent, so chains must be thinned first. Claimed deviations that are too small pile up ranks at
 * both ends, too large ones in the middle, a bias tilts the histogram.
 *
 * <p>Not safe for use by several threads at once.
 */
public final class RankHistogram {
    private final int draws;
    private final int[] counts;
    private int total;

    /**
     * An empty histogram.
     *
     * @param draws number L of posterior draws per truth, at least 1; ranks run from 0 to L
     * @param bins number of bins, at least 2; must divide L + 1, so that all bins hold as many ranks
     * @throws IllegalArgumentException if the numbers do not fit
     */
    public RankHistogram(int draws, int bins) {
        if (draws < 1 || bins < 2 || (draws + 1L) % bins != 0) {
            throw new IllegalArgumentException("the " + (draws + 1L) + " ranks of " + draws
                    + " draws cannot be shared evenly by " + bins + " bins");
        }
        this.draws = draws;
        this.counts = new int[bins];
    }

    /**
     * The rank of a truth among posterior draws.
     *
     * @param truth the true value
     * @param posteriorDraws the draws, in any order
     * @return number of draws below the truth, in [0, L]
     * @throws IllegalArgumentException if a number is NaN
     */
    public static int rankOf(double truth, double[] posteriorDraws) {
        int rank = 0;
        for (double x : posteriorDraws) {
            if (Double.isNaN(x) || Double.isNaN(truth)) {
                throw new IllegalArgumentException("NaN has no rank");
            }
            if (x < truth) {
                rank++;
            }
        }
        return rank;
    }

    /**
     * Counts one rank.
     *
     * @param rank in [0, L]
     * @throws IllegalArgumentException if it is outside
     */
    public void add(int rank) {
        if (rank < 0 || rank > draws) {
            throw new IllegalArgumentException("a rank among " + draws + " draws lies in [0, " + draws + "], was "
                    + rank);
        }
        counts[(int) ((long) rank * counts.length / (draws + 1L))]++;
        total++;
    }

    /**
     * Counts the ranks of another histogram too.
     *
     * @param other histogram of as many draws and bins, left as it is
     * @throws IllegalArgumentException if draws or bins differ
     */
    public void merge(RankHistogram other) {
        if (other.draws != draws || other.counts.length != counts.length) {
            throw new IllegalArgumentException("histograms differ: " + draws + " draws in " + counts.length
                    + " bins, " + other.draws + " draws in " + other.counts.length + " bins");
        }
        for (int i = 0; i < counts.length; i++) {
            counts[i] += other.counts[i];
        }
        total += other.total;
    }

    /**
     * Ranks per bin.
     *
     * @return a new array of counts, lowest ranks first
     */
    public int[] counts() {
        return Arrays.copyOf(counts, counts.length);
    }

    /**
     * Number of ranks so far.
     *
     * @return the count
     */
    public int total() {
        return total;
    }

    /**
     * Ranks that each bin would hold on average if they were uniform.
     *
     * @return total over number of bins
     */
    public double expectedPerBin() {
        return (double) total / counts.length;
    }

    /**
     * Pearson's statistic against uniform ranks: the sum of (count - expected)^2 / expected.
     *
     * @return the statistic, not negative; NaN for an empty histogram
     */
    public double chiSquare() {
        if (total == 0) {
            return Double.NaN;
        }
        double expected = expectedPerBin();
        double sum = 0;
        for (int count : counts) {
            double d = count - expected;
            sum += d * d / expected;
        }
        return sum;
    }

    /**
     * Probability that uniform ranks give a statistic at least as large. Uses the chi-square distribution of one degree
     * of freedom less than bins, an approximation that is good from about five expected ranks per bin.
     *
     * @return the p-value, in [0, 1]; NaN for an empty histogram
     */
    public double pValue() {
        double statistic = chiSquare();
        return Double.isNaN(statistic)
                ? Double.NaN
                : Gamma.regularizedGammaQ((counts.length - 1) / 2.0, statistic / 2);
    }

    /**
     * The band in which the count of each single bin lies with a stated confidence if ranks are uniform.
     *
     * @param confidence in (0, 1)
     * @return the band
     * @throws IllegalArgumentException if the histogram is empty or the confidence out of range
     */
    public BinomialBand band(double confidence) {
        return BinomialBand.of(total, 1.0 / counts.length, confidence);
    }
}
