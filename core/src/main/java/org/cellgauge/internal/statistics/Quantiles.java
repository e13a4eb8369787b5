package org.cellgauge.internal.statistics;

/** Quantiles of stored draws. */
public final class Quantiles {
    /** Rounding of probability times count that still means a whole index. */
    private static final double FUZZ = 1e-12;

    private Quantiles() {}

    /**
     * The sample quantile of type 7 (Hyndman &amp; Fan 1996, "Sample quantiles in statistical packages", The American
     * Statistician 50(4)): linear between the order statistics around index (n - 1) p, counted from 0. Default of R and
     * NumPy.
     *
     * @param sorted at least one value, ascending, finite
     * @param probability in [0, 1]
     * @return the quantile
     */
    public static double ofSorted(double[] sorted, double probability) {
        double index = (sorted.length - 1) * probability;
        // Rounding must not put the quantile a hair below an order statistic: "draw <= quantile" would miss that draw
        double nearest = Math.rint(index);
        if (Math.abs(index - nearest) <= FUZZ * Math.max(1, nearest)) {
            return sorted[(int) nearest];
        }
        int below = (int) index;
        double low = sorted[below];
        return low + (index - below) * (sorted[below + 1] - low);
    }

    /**
     * The median: the middle value, or the mean of the two middle values.
     *
     * <p>Apart from {@link #ofSorted} because folding needs both middle values at the same distance, to the last bit:
     * they must tie in rank.
     *
     * @param sorted at least one value, ascending, finite
     * @return the median
     */
    public static double medianOfSorted(double[] sorted) {
        int n = sorted.length;
        return n % 2 == 1 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2;
    }
}
