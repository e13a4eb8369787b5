package org.cellgauge.output;

import org.jspecify.annotations.Nullable;

/** What becomes of a gripping point without the references that seem misplaced; immutable. */
public final class MovedGrip extends Value {
    private final double[] meanMm;
    private final double[][] covarianceMm2;
    private final double[] moveMm;
    private final double[] errorMm;

    MovedGrip(double[] meanMm, double[][] covarianceMm2, double[] moveMm, double[] errorMm) {
        this.meanMm = Figures.finite(meanMm);
        this.covarianceMm2 = Figures.finite(covarianceMm2);
        this.moveMm = Figures.finite(moveMm);
        this.errorMm = Figures.finite(errorMm);
    }

    /**
     * Where it is by Laplace's approximation.
     *
     * @return x, y, z in the world, mm; a new array
     */
    public double[] meanMm() {
        return meanMm.clone();
    }

    /**
     * Its covariance.
     *
     * @return 3x3, mm²; a copy
     */
    public double[][] covarianceMm2() {
        return Figures.finite(covarianceMm2);
    }

    /**
     * How far it moves when the references are left out.
     *
     * @return along world x, y, z, mm; a new array
     */
    public double[] moveMm() {
        return moveMm.clone();
    }

    /**
     * Root mean square error of what the result states, if the references are misplaced.
     *
     * @return along world x, y, z, mm; a new array
     */
    public double[] errorMm() {
        return errorMm.clone();
    }

    /**
     * Standard deviations of the mean.
     *
     * @return along world x, y, z, mm; a new array
     */
    public double[] stdMm() {
        return Figures.std(covarianceMm2);
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {meanMm, covarianceMm2, moveMm, errorMm};
    }
}
