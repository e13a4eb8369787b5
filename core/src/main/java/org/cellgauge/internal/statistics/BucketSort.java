package org.cellgauge.internal.statistics;

/**
 * Sorts numbers and says where each of them stood, by as many buckets of equal width as there are numbers (Knuth, "The
 * Art of Computer Programming", volume 3, section 5.2.5, exercise 38): of draws that are spread like most, few share
 * one. Where a few far ones leave the others crowded, {@link RadixSort} does it.
 */
public final class BucketSort {
    /** Mean over the numbers of how many are in the bucket of each, above which buckets are crowded. */
    private static final int CROWDED = 16;

    private BucketSort() {
    }

    /**
     * Sorts finite numbers, -0.0 before 0.0; equal ones keep their order.
     *
     * @param values what to sort; not changed
     * @param sorted filled with the values in ascending order, as long as they
     * @param work whose {@link DrawsWork#order} may be what is returned
     * @return the index in {@code values} of each sorted value
     */
    public static int[] sort(double[] values, double[] sorted, DrawsWork work) {
        int n = values.length;
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (double v : values) {
            least = Math.min(least, v);
            most = Math.max(most, v);
        }
        double perWidth = (n - 1) / (most - least);
        if (!(perWidth > 0 && perWidth < Double.POSITIVE_INFINITY)) {
            return RadixSort.sort(values, sorted);
        }
        int[] next = work.buckets(n);
        for (double v : values) {
            next[(int) ((v - least) * perWidth)]++;
        }
        int sum = 0;
        double pairs = 0;
        for (int b = 0; b < n; b++) {
            int count = next[b];
            next[b] = sum;
            sum += count;
            pairs += (double) count * count;
        }
        if (pairs > (double) CROWDED * n) {
            return RadixSort.sort(values, sorted);
        }
        int[] order = work.order(n);
        for (int i = 0; i < n; i++) {
            double v = values[i];
            int to = next[(int) ((v - least) * perWidth)]++;
            sorted[to] = v;
            order[to] = i;
        }
        // buckets are in order: nothing is moved out of its own
        for (int i = 1; i < n; i++) {
            double v = sorted[i];
            int from = order[i];
            int to = i;
            while (to > 0 && isAfter(sorted[to - 1], v)) {
                sorted[to] = sorted[to - 1];
                order[to] = order[to - 1];
                to--;
            }
            sorted[to] = v;
            order[to] = from;
        }
        return order;
    }

    private static boolean isAfter(double a, double b) {
        return a > b || a == b && a == 0 && Double.compare(a, b) > 0;
    }
}
