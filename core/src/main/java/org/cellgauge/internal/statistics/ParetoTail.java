package org.cellgauge.internal.statistics;

/**
 * How heavy the tails of draws are: the shape k of a generalised Pareto distribution fitted to the largest and to the
 * smallest of them. Moments of an order below 1/k exist, of t-distributed draws those below their degrees of freedom.
 *
 * <p>A mean is known as well as its Monte Carlo error says where a variance exists, k below 1/2. <b>A standard
 * deviation is a mean of squares</b>, which have twice the k: its error needs a fourth moment, k below
 * {@value #LARGEST_FOR_STD}. Where k is larger, too large squares are too rare for any number of draws to show their
 * share, and the error that is computed from those seen is too small.
 *
 * <p>Sources: Vehtari, Simpson, Gelman, Yao and Gabry, "Pareto smoothed importance sampling", JMLR 25(72), 2024 (length
 * of the tails, shrinkage of k, thresholds); Zhang and Stephens, "A new and efficient estimation method for the
 * generalized Pareto distribution", Technometrics 51(3), 2009 (the fit). Choices are those of version 1.6 of the R
 * package {@code posterior}.
 */
public final class ParetoTail {
    /** Largest k with which the Monte Carlo error of a standard deviation is what it is stated as. */
    public static final double LARGEST_FOR_STD = 0.25;

    private static final int FEWEST_IN_TAIL = 5;
    private static final int LEAST_GRID = 30;
    /** Weakly informative prior: as if so many exceedances had spoken for k = 1/2. */
    private static final double PRIOR_DRAWS = 10;
    private static final double PRIOR_K = 0.5;
    /** Factors of one product before its logarithm is taken: none is larger than 1e30, so that it cannot overflow. */
    private static final int FACTORS = 8;

    private ParetoTail() {
    }

    /**
     * The heavier tail of draws.
     *
     * @param sorted draws, ascending, finite
     * @param effectiveShare effective number of draws in the tails over their number, positive
     * @return the larger k of both tails; NaN where there are too few draws, or all of a tail are equal
     */
    public static double k(double[] sorted, double effectiveShare) {
        int n = sorted.length;
        double length = n > 225 ? 3 * Math.sqrt(n / effectiveShare) : n / 5.0;
        int tail = (int) Math.min(Math.ceil(length), Math.floor(n / 2.0));
        if (!(tail >= FEWEST_IN_TAIL)) {
            return Double.NaN;
        }
        double[] above = new double[tail];
        double[] below = new double[tail];
        for (int i = 0; i < tail; i++) {
            above[i] = sorted[n - tail + i] - sorted[n - tail - 1];
            below[i] = sorted[tail] - sorted[tail - 1 - i];
        }
        return Math.max(shrunk(above), shrunk(below));
    }

    /** Shape of exceedances, drawn towards 1/2 as much as they are few. */
    private static double shrunk(double[] exceedances) {
        double n = exceedances.length;
        return (n * shape(exceedances) + PRIOR_DRAWS * PRIOR_K) / (n + PRIOR_DRAWS);
    }

    /**
     * Shape of a generalised Pareto distribution, by Zhang and Stephens.
     *
     * @param exceedances over a threshold, ascending, not negative
     * @return k, positive for heavy tails; NaN where all are equal
     */
    static double shape(double[] exceedances) {
        int n = exceedances.length;
        double largest = exceedances[n - 1];
        double quartile = exceedances[(int) Math.floor(n / 4.0 + 0.5) - 1];
        if (!(largest > 0 && quartile > 0) || largest == exceedances[0]) {
            return Double.NaN;
        }
        int grid = LEAST_GRID + (int) Math.sqrt(n);
        double[] theta = new double[grid];
        double[] logLikelihood = new double[grid];
        double most = Double.NEGATIVE_INFINITY;
        for (int j = 0; j < grid; j++) {
            theta[j] = 1 / largest + (1 - Math.sqrt(grid / (j + 0.5))) / (3 * quartile);
            double k = meanLog(exceedances, theta[j]);
            logLikelihood[j] = n * (Math.log(-theta[j] / k) - k - 1);
            most = Math.max(most, logLikelihood[j]);
        }
        double sum = 0;
        double mean = 0;
        for (int j = 0; j < grid; j++) {
            double weight = Math.exp(logLikelihood[j] - most);
            sum += weight;
            mean += weight * theta[j];
        }
        return meanLog(exceedances, mean / sum);
    }

    /** Mean of log(1 - theta x), by products of several factors each. */
    private static double meanLog(double[] x, double theta) {
        double sum = 0;
        double product = 1;
        for (int i = 0; i < x.length; i++) {
            product *= 1 - theta * x[i];
            if ((i + 1) % FACTORS == 0) {
                sum += Math.log(product);
                product = 1;
            }
        }
        return (sum + Math.log(product)) / x.length;
    }
}
