package org.cellgauge.internal.overlay;

import java.util.Arrays;
import java.util.List;

/** Points that a line is made of, one after the other, in an array that is used again for the next line. */
final class PointRun {
    private double[] values = new double[16];
    private int size;

    void add(double u, double v) {
        if (size + 2 > values.length) {
            values = Arrays.copyOf(values, 2 * values.length);
        }
        values[size] = u;
        values[size + 1] = v;
        size += 2;
    }

    boolean isEmpty() {
        return size == 0;
    }

    /** Number of values, two a point. */
    int size() {
        return size;
    }

    double get(int i) {
        return values[i];
    }

    void clear() {
        size = 0;
    }

    /** Ends the line: hands it on where it has two points or more, and begins another. */
    void flush(List<double[]> lines) {
        if (size >= 4) {
            lines.add(Arrays.copyOf(values, size));
        }
        size = 0;
    }
}
