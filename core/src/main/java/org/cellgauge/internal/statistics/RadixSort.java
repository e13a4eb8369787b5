package org.cellgauge.internal.statistics;

/**
 * Sorts numbers and says where each of them stood: least significant digit first (Knuth, "The Art of Computer
 * Programming", volume 3, section 5.2.5), which takes time in proportion to their number.
 */
public final class RadixSort {
    private static final int BITS = 11;
    private static final int BUCKETS = 1 << BITS;
    private static final int PASSES = 6;

    private RadixSort() {
    }

    /**
     * Sorts finite numbers, -0.0 before 0.0; equal ones keep their order.
     *
     * @param values what to sort; not changed
     * @param sorted filled with the values in ascending order, as long as they
     * @return the index in {@code values} of each sorted value
     */
    public static int[] sort(double[] values, double[] sorted) {
        int n = values.length;
        long[] keys = new long[n];
        long[] otherKeys = new long[n];
        int[] order = new int[n];
        int[] otherOrder = new int[n];
        int[][] counts = new int[PASSES][BUCKETS];
        for (int i = 0; i < n; i++) {
            long bits = Double.doubleToRawLongBits(values[i]);
            // so that unsigned keys are in the order of the numbers: all bits of negative ones turned over, of others
            // the sign alone
            long key = bits ^ (bits >> 63 | Long.MIN_VALUE);
            keys[i] = key;
            order[i] = i;
            for (int p = 0; p < PASSES; p++) {
                counts[p][(int) (key >>> BITS * p) & BUCKETS - 1]++;
            }
        }
        for (int p = 0; p < PASSES; p++) {
            int[] next = counts[p];
            int shift = BITS * p;
            if (n == 0 || next[(int) (keys[0] >>> shift) & BUCKETS - 1] == n) {
                continue;
            }
            int sum = 0;
            for (int b = 0; b < BUCKETS; b++) {
                int count = next[b];
                next[b] = sum;
                sum += count;
            }
            for (int i = 0; i < n; i++) {
                long key = keys[i];
                int to = next[(int) (key >>> shift) & BUCKETS - 1]++;
                otherKeys[to] = key;
                otherOrder[to] = order[i];
            }
            long[] k = keys;
            keys = otherKeys;
            otherKeys = k;
            int[] o = order;
            order = otherOrder;
            otherOrder = o;
        }
        for (int i = 0; i < n; i++) {
            sorted[i] = values[order[i]];
        }
        return order;
    }
}
