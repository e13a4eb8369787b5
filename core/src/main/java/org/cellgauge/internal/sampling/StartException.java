package org.cellgauge.internal.sampling;

/** A chain cannot start: the density at its first point is not finite, and it could never move. */
public final class StartException extends IllegalStateException {
    private static final long serialVersionUID = 1L;

    private final double logDensity;

    StartException(double logDensity) {
        super("the density is " + logDensity + " at the start of the chain");
        this.logDensity = logDensity;
    }

    /**
     * The log density at the first point.
     *
     * @return infinite or NaN
     */
    public double logDensity() {
        return logDensity;
    }
}
