package org.cellgauge.internal.overlay;

/** Numbers of the series 1, 2, 5, 10, 20, …, upwards and downwards. */
final class RoundNumbers {
    private static final double[] SERIES = {1, 2, 5, 10};
    private static final double ROUNDING = 1e-9;

    private RoundNumbers() {
    }

    /** The smallest number of the series that is not below a positive value. */
    static double atLeast(double value) {
        double decade = decade(value);
        for (double s : SERIES) {
            if (s * decade >= value * (1 - ROUNDING)) {
                return s * decade;
            }
        }
        return 10 * decade;
    }

    /** The largest number of the series that is not above a positive value. */
    static double atMost(double value) {
        double decade = decade(value);
        double found = decade;
        for (double s : SERIES) {
            if (s * decade <= value * (1 + ROUNDING)) {
                found = s * decade;
            }
        }
        return found;
    }

    private static double decade(double value) {
        if (!(value > 0) || Double.isInfinite(value)) {
            throw new IllegalArgumentException("there is no round number near " + value);
        }
        int exponent = (int) Math.floor(Math.log10(value) + ROUNDING);
        // a power below 1 as a quotient: 0.1 and not 0.1 with the rounding of a product
        return exponent >= 0 ? Math.pow(10, exponent) : 1 / Math.pow(10, -exponent);
    }
}
