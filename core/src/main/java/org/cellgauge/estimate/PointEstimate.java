package org.cellgauge.estimate;

import org.cellgauge.internal.estimate.Matrices;

/** A point in the world with its uncertainty; immutable. */
public final class PointEstimate {
    private final double[] meanMm;
    private final double[][] covarianceMm2;

    /**
     * An estimate.
     *
     * @param meanMm x, y, z in the world, mm; copied
     * @param covarianceMm2 3x3, world axes, mm²; copied
     */
    public PointEstimate(double[] meanMm, double[][] covarianceMm2) {
        this.meanMm = meanMm.clone();
        this.covarianceMm2 = Matrices.copy(covarianceMm2);
    }

    /**
     * Mean position.
     *
     * @return a copy, world, mm
     */
    public double[] meanMm() {
        return meanMm.clone();
    }

    /**
     * Covariance.
     *
     * @return a copy, 3x3, world axes, mm²
     */
    public double[][] covarianceMm2() {
        return Matrices.copy(covarianceMm2);
    }

    /**
     * Standard deviations.
     *
     * @return a new array of 3 values, mm
     */
    public double[] stdMm() {
        return new double[] {Math.sqrt(covarianceMm2[0][0]), Math.sqrt(covarianceMm2[1][1]),
            Math.sqrt(covarianceMm2[2][2])};
    }
}
