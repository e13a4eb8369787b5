package org.cellgauge.internal.statistics;

import org.apache.commons.math3.special.Erf;

/**
 * Quantiles of the standard normal distribution, to about 1e-16: Wichura, "Algorithm AS 241: The percentage points of
 * the normal distribution", Applied Statistics 37(3), 1988, routine PPND16.
 */
final class NormalQuantile {
    private static final double CENTRAL = 0.425;
    /** Beyond about 1e-11 the paper has a third approximation, which nothing here reaches. */
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
            return q * (((((((2509.0809287301226727 * r + 33430.575583588128105) * r + 67265.770927008700853) * r
                    + 45921.953931549871457) * r + 13731.693765509461125) * r + 1971.5909503065514427) * r
                    + 133.14166789178437745) * r + 3.387132872796366608)
                    / (((((((5226.495278852854561 * r + 28729.085735721942674) * r + 39307.89580009271061) * r
                    + 21213.794301586595867) * r + 5394.1960214247511077) * r + 687.1870074920579083) * r
                    + 42.313330701600911252) * r + 1);
        }
        double r = Math.sqrt(-Math.log(Math.min(probability, 1 - probability)));
        if (r > FAR) {
            return -Math.sqrt(2) * Erf.erfcInv(2 * probability);
        }
        r -= 1.6;
        double size = (((((((7.7454501427834140764e-4 * r + 0.0227238449892691845833) * r + 0.24178072517745061177) * r
                + 1.27045825245236838258) * r + 3.64784832476320460504) * r + 5.7694972214606914055) * r
                + 4.6303378461565452959) * r + 1.42343711074968357734)
                / (((((((1.05075007164441684324e-9 * r + 5.475938084995344946e-4) * r + 0.0151986665636164571966) * r
                + 0.14810397642748007459) * r + 0.68976733498510000455) * r + 1.6763848301838038494) * r
                + 2.05319162663775882187) * r + 1);
        return q < 0 ? -size : size;
    }
}
