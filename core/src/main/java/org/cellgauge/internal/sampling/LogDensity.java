package org.cellgauge.internal.sampling;

/**
 * An unnormalised log density over an array of coordinates. Implementations hold scratch arrays: one instance per
 * thread.
 */
public interface LogDensity {
    /**
     * Number of coordinates.
     *
     * @return at least 1
     */
    int dimension();

    /**
     * The log density at a point, up to a constant.
     *
     * @param x coordinates; not changed, not kept
     * @return finite, or -infinity where the density is zero; NaN never
     */
    double at(double[] x);
}
