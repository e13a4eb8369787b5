package org.cellgauge.sampling;

import java.util.Arrays;

/** The kept draws of one chain, quantity by quantity. Not thread-safe. */
public final class Draws {
    private final QuantityLayout layout;
    private final double[][] values;
    private int count;

    /**
     * No draws yet.
     *
     * @param layout quantities of a draw
     */
    public Draws(QuantityLayout layout) {
        this.layout = layout;
        values = new double[layout.size()][256];
    }

    /**
     * Adds a draw.
     *
     * @param quantities one value per quantity
     */
    public void add(double[] quantities) {
        if (count == values[0].length) {
            for (int q = 0; q < values.length; q++) {
                values[q] = Arrays.copyOf(values[q], 2 * count);
            }
        }
        for (int q = 0; q < values.length; q++) {
            values[q][count] = quantities[q];
        }
        count++;
    }

    /**
     * Number of draws.
     *
     * @return not negative
     */
    public int count() {
        return count;
    }

    /**
     * One value as drawn.
     *
     * @param quantity position in the layout
     * @param draw 0 to count - 1
     * @return the value; angles in (-pi, pi]
     */
    public double get(int quantity, int draw) {
        return values[quantity][draw];
    }

    /**
     * The series of one quantity, angles unrolled about their reference direction so that the series has no jump.
     *
     * @param quantity position in the layout
     * @return a new array
     */
    public double[] series(int quantity) {
        double[] series = new double[count];
        series(quantity, series, 0);
        return series;
    }

    /**
     * The same into a larger array.
     *
     * @param quantity position in the layout
     * @param out filled with the series
     * @param from where it begins there
     */
    public void series(int quantity, double[] out, int from) {
        System.arraycopy(values[quantity], 0, out, from, count);
        if (layout.isAngle(quantity)) {
            double reference = layout.referenceRad(quantity);
            for (int i = from; i < from + count; i++) {
                out[i] = reference + org.cellgauge.internal.statistics.Angles.difference(out[i], reference);
            }
        }
    }
}
