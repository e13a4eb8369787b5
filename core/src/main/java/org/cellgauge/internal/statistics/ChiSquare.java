package org.cellgauge.internal.statistics;

import org.apache.commons.math3.distribution.ChiSquaredDistribution;

/** Sums of squares of independent standard normal variables, held against their distribution. */
public final class ChiSquare {

    private ChiSquare() {
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
                : 1 - new ChiSquaredDistribution(null, degreesOfFreedom).cumulativeProbability(chiSquare);
    }
}
