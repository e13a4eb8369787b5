package org.cellgauge.internal.statistics;

/**
 * Quantiles of the standard normal distribution, to about 1e-16: Wichura, "Algorithm AS 241: The percentage points of
 * the normal distribution", Applied Statistics 37(3), 1988, routine PPND16.
 */
final class NormalQuantile {
    private static final double CENTRAL = 0.425;
    /** Root of the negative logarithm of the tail's probability from which on another function is the better one. */
    private static final double FAR = 5;

    private NormalQuantile() {
    }

    /**
     * The quantile.
     *
     * @param probability in (0, 1)
     * @return what a standard normal value is below with this probability
     */
    static double of(double probability) {
        double q = probability - 0.5;
        if (Math.abs(q) <= CENTRAL) {
            double r = CENTRAL * CENTRAL - q * q;
            return q * (((((((2509.0809287301227 * r + 33430.57558358813) * r + 67265.7709270087) * r
                    + 45921.95393154987) * r + 13731.69376550946) * r + 1971.5909503065513) * r
                    + 133.14166789178438) * r + 3.3871328727963665)
                    / (((((((5226.495278852854 * r + 28729.085735721943) * r + 39307.89580009271) * r
                    + 21213.794301586597) * r + 5394.196021424751) * r + 687.1870074920579) * r
                    + 42.31333070160091) * r + 1);
        }
        double r = Math.sqrt(-Math.log(Math.min(probability, 1 - probability)));
        double size = r > FAR ? far(r - FAR) : near(r - 1.6);
        return q < 0 ? -size : size;
    }

    private static double near(double r) {
        return (((((((0.0007745450142783414 * r + 0.022723844989269184) * r + 0.2417807251774506) * r
                + 1.2704582524523684) * r + 3.6478483247632045) * r + 5.769497221460691) * r
                + 4.630337846156546) * r + 1.4234371107496835)
                / (((((((1.0507500716444169e-09 * r + 0.0005475938084995345) * r + 0.015198666563616457) * r
                + 0.14810397642748008) * r + 0.6897673349851) * r + 1.6763848301838038) * r
                + 2.053191626637759) * r + 1);
    }

    private static double far(double r) {
        return (((((((2.0103343992922881e-07 * r + 2.7115555687434876e-05) * r + 0.0012426609473880784) * r
                + 0.026532189526576124) * r + 0.29656057182850487) * r + 1.7848265399172913) * r
                + 5.463784911164114) * r + 6.657904643501103)
                / (((((((2.0442631033899397e-15 * r + 1.421511758316446e-07) * r + 1.8463183175100548e-05) * r
                + 0.0007868691311456133) * r + 0.014875361290850615) * r + 0.1369298809227358) * r
                + 0.599832206555888) * r + 1);
    }
}
