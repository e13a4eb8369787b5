package org.cellgauge.internal.validation;

import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.cellgauge.internal.statistics.BinomialBand;

/**
 * How often stated regions of one kind held the truth; immutable.
 *
 * <p>A region of probability p is the ellipsoid about the mean, shaped by the covariance of the draws, that holds the
 * share p of the draws (JCGM 102:2011, section 7.7). The Gaussian region beside it has the same centre and shape, and
 * is sized by the chi-square quantile instead: what a reader makes of a mean and a covariance, and what the ellipses in
 * the image are.
 */
public final class RegionCoverage {
    private final String name;
    private final int dimension;
    private final double[] drawShares;
    private final double[] gaussianShares;
    private final double confidence;

    RegionCoverage(String name, int dimension, double[] drawShares, double[] squaredDistances, double confidence) {
        this.name = name;
        this.dimension = dimension;
        this.drawShares = drawShares;
        this.confidence = confidence;
        ChiSquaredDistribution chiSquare = new ChiSquaredDistribution(null, dimension);
        gaussianShares = new double[squaredDistances.length];
        for (int i = 0; i < gaussianShares.length; i++) {
            gaussianShares[i] = chiSquare.cumulativeProbability(squaredDistances[i]);
        }
    }

    /**
     * What the regions are of.
     *
     * @return for instance {@code object 5 position}
     */
    public String name() {
        return name;
    }

    /**
     * Number of coordinates.
     *
     * @return 3 (position in mm) or 6 (position in mm, rotation vector in rad, both in world axes)
     */
    public int dimension() {
        return dimension;
    }

    /**
     * Number of checks that stated a region.
     *
     * @return not negative
     */
    public int trials() {
        return drawShares.length;
    }

    /**
     * How many regions held the truth.
     *
     * @param probability that the regions claim, in (0, 1)
     * @return the count
     */
    public int hits(double probability) {
        return hits(drawShares, probability);
    }

    /**
     * How many Gaussian regions held the truth.
     *
     * @param probability that the regions claim, in (0, 1)
     * @return the count
     */
    public int gaussianHits(double probability) {
        return hits(gaussianShares, probability);
    }

    private static int hits(double[] shares, double probability) {
        int hits = 0;
        for (double share : shares) {
            hits += share <= probability ? 1 : 0;
        }
        return hits;
    }

    /**
     * Counts that an honest claim gives. All regions of a validation lie in their bands together with the validation's
     * confidence (Bonferroni).
     *
     * @param probability that the regions claim, in (0, 1)
     * @return the band
     * @throws IllegalArgumentException if there were no trials
     */
    public BinomialBand band(double probability) {
        return BinomialBand.of(trials(), probability, confidence);
    }

    /**
     * Whether the count of the regions is one that an honest claim gives.
     *
     * @param probability that the regions claim, in (0, 1)
     * @return false without trials
     */
    public boolean covers(double probability) {
        return trials() > 0 && band(probability).contains(hits(probability));
    }

    /**
     * The same of the Gaussian regions.
     *
     * @param probability that the regions claim, in (0, 1)
     * @return false without trials
     */
    public boolean gaussianCovers(double probability) {
        return trials() > 0 && band(probability).contains(gaussianHits(probability));
    }
}
