package org.cellgauge.internal.statistics;

import org.apache.commons.math3.distribution.GammaDistribution;

/** Sums of squares of independent standard normal variables, held against their distribution. */
public final class ChiSquare {
    private static final double DEFAULT_ACCURACY = GammaDistribution.DEFAULT_INVERSE_ABSOLUTE_ACCURACY;

    private ChiSquare() {
    }

    /**
     * The distribution, as the gamma distribution that it is: the library's own class for it makes a random generator
     * of 2.5 kB beside that.
     *
     * @param degreesOfFreedom at least 1
     * @param accuracy absolute, of its quantiles
     */
    static GammaDistribution distribution(int degreesOfFreedom, double accuracy) {
        return new GammaDistribution(null, degreesOfFreedom / 2.0, 2, accuracy);
    }

    /**
     * The chance of a sum at least as large if there is nothing to find.
     *
     * @param chiSquare the sum, not negative
     * @param degreesOfFreedom how many squares are independent, at least 0
     * @return in [0, 1]; NaN where nothing is tested, which is where no square or no finite sum is left
     */
    public static double pValue(double chiSquare, int degreesOfFreedom) {
        return degreesOfFreedom == 0 || !Double.isFinite(chiSquare) ? Double.NaN
                : 1 - distribution(degreesOfFreedom, DEFAULT_ACCURACY).cumulativeProbability(chiSquare);
    }
}
