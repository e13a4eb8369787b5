package org.cellgauge.internal.statistics;

/** Means and variances of stored numbers in two passes, four sums at a time so that no addition waits for another. */
public final class Sums {
    private Sums() {
    }

    /**
     * Mean of part of an array.
     *
     * @param x numbers
     * @param from index of the first
     * @param to index after the last, beyond {@code from}
     * @return their mean; finite where they are
     */
    public static double mean(double[] x, int from, int to) {
        double mean = sum(x, from, to) / (to - from);
        if (Double.isFinite(mean)) {
            return mean;
        }
        // The sum of very large numbers overflows, their mean does not
        mean = 0;
        for (int i = from; i < to; i++) {
            mean += x[i] / (to - from);
        }
        return mean;
    }

    private static double sum(double[] x, int from, int to) {
        double s0 = 0;
        double s1 = 0;
        double s2 = 0;
        double s3 = 0;
        int i = from;
        for (; i < to - 3; i += 4) {
            s0 += x[i];
            s1 += x[i + 1];
            s2 += x[i + 2];
            s3 += x[i + 3];
        }
        for (; i < to; i++) {
            s0 += x[i];
        }
        return s0 + s1 + (s2 + s3);
    }

    /**
     * Takes its mean from part of an array.
     *
     * @param x numbers; changed
     * @param from index of the first
     * @param to index after the last, beyond {@code from}
     * @return the mean that they had
     */
    public static double centre(double[] x, int from, int to) {
        double mean = mean(x, from, to);
        for (int i = from; i < to; i++) {
            x[i] -= mean;
        }
        return mean;
    }

    /**
     * Variance of part of an array.
     *
     * @param x numbers
     * @param from index of the first
     * @param to index after the last, beyond {@code from}
     * @return their variance, divisor one less than their number; NaN of a single one
     */
    public static double variance(double[] x, int from, int to) {
        double mean = mean(x, from, to);
        double s0 = 0;
        double s1 = 0;
        int i = from;
        for (; i < to - 1; i += 2) {
            double a = x[i] - mean;
            double b = x[i + 1] - mean;
            s0 += a * a;
            s1 += b * b;
        }
        if (i < to) {
            s0 += (x[i] - mean) * (x[i] - mean);
        }
        return to - from < 2 ? Double.NaN : (s0 + s1) / (to - from - 1);
    }
}
