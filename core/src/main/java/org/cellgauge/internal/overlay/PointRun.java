package org.cellgauge.internal.overlay;

import java.util.Arrays;
import java.util.List;

/** Points that a line is made of, one after the other, in an array that is used again for the next line. */
final class PointRun {
    private double[] values;
    private int size;

    /** A run with room for so many points at first. */
    PointRun(int points) {
        values = new double[2 * points];
    }

    void add(double u, double v) {
        if (size + 2 > values.length) {
            values = Arrays.copyOf(values, 2 * values.length + 2);
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

    /**
     * Leaves out points in between that are no farther than a tolerance from the line through those that stay (Douglas
     * and Peucker, "Algorithms for the reduction of the number of points required to represent a digitized line or its
     * caricature", 1973).
     *
     * @param tolerance px
     */
    void straighten(double tolerance) {
        if (size > 4) {
            size = kept(0, size - 2, 2, tolerance * tolerance);
        }
    }

    /** Keeps what is needed after one point up to another, from a place on; where the next goes. */
    private int kept(int from, int to, int place, double squaredTolerance) {
        double u = values[from];
        double v = values[from + 1];
        double du = values[to] - u;
        double dv = values[to + 1] - v;
        double squaredLength = du * du + dv * dv;
        double most = squaredTolerance;
        int farthest = -1;
        for (int i = from + 2; i < to; i += 2) {
            double pu = values[i] - u;
            double pv = values[i + 1] - v;
            double across = pu * dv - pv * du;
            double squared = squaredLength > 0 ? across * across / squaredLength : pu * pu + pv * pv;
            if (squared > most) {
                most = squared;
                farthest = i;
            }
        }
        if (farthest >= 0) {
            // places come no later than points, so that nothing is written over that is yet to be read
            return kept(farthest, to, kept(from, farthest, place, squaredTolerance), squaredTolerance);
        }
        values[place] = values[to];
        values[place + 1] = values[to + 1];
        return place + 2;
    }

    /** Ends the line: hands it on where it has two points or more, and begins another. */
    void flush(List<double[]> lines) {
        if (size >= 4) {
            lines.add(Arrays.copyOf(values, size));
        }
        size = 0;
    }
}
