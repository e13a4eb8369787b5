package org.cellgauge.vision;

/**
 * What an unsharp mask does to the grey values across a straight edge, and how what is left after it was undone changes
 * with its amount and radius, as tables over the distance from the edge.
 *
 * <p>With m the grey of the edge, G a Gaussian of radius r and {@code K = 1 / (1 + a (1 - G))} what undoes the mask of
 * amount a, the value after undoing is {@code K s}; the residual {@code m - K s} changes with a by {@code (1 - G) K m}
 * and with log r by {@code -a r² (G K m)''} (a Gaussian obeys the heat equation). The tables take m from the fitted
 * edge and not from the pixels, so that they share no noise with the residuals: an estimate by them is unbiased however
 * much noise there is. Not thread-safe; arrays are kept.
 */
final class SharpenedStep {
    private static final double STEP_PX = 0.25;
    private static final int ROUNDS = 16;

    private double fromPx;
    private int nodes;
    private double[] grey = new double[0];
    private double[] undone = new double[0];
    private double[] blurred = new double[0];
    private double[] ofAmount = new double[0];
    private double[] ofRadius = new double[0];

    /** How far grey rises above white after the mask, as a share of the difference of white and black. */
    double overshoot;

    /** Makes the tables for lengths up to so many px from the edge; {@link #put} then takes the grey values. */
    int prepare(double lengthPx) {
        nodes = 2 * (int) Math.ceil(lengthPx / STEP_PX) + 1;
        fromPx = -(nodes / 2) * STEP_PX;
        if (grey.length < nodes) {
            grey = new double[nodes];
            undone = new double[nodes];
            blurred = new double[nodes];
            ofAmount = new double[nodes];
            ofRadius = new double[nodes];
        }
        return nodes;
    }

    /** Distance of a node from the edge, px, positive on the bright side. */
    double distance(int node) {
        return fromPx + STEP_PX * node;
    }

    /** Takes the grey value of the edge at a node. */
    void put(int node, double level) {
        grey[node] = level;
    }

    /**
     * Fills the tables.
     *
     * @param amount of the mask, at least 0
     * @param radiusPx deviation of its Gaussian, positive, px
     */
    void solve(double amount, double radiusPx) {
        double[] weights = Unsharpened.weights(radiusPx / STEP_PX);
        blur(grey, weights);
        overshoot = 0;
        double contrast = grey[nodes - 1] - grey[0];
        for (int i = 0; i < nodes; i++) {
            double sharpened = grey[i] + amount * (grey[i] - blurred[i]);
            overshoot = Math.max(overshoot, (sharpened - grey[nodes - 1]) / contrast);
        }
        System.arraycopy(grey, 0, undone, 0, nodes);
        for (int round = 0; amount > 0 && round < ROUNDS; round++) {
            blur(undone, weights);
            for (int i = 0; i < nodes; i++) {
                undone[i] = (grey[i] + amount * blurred[i]) / (1 + amount);
            }
        }
        blur(undone, weights);
        double perStep = amount * radiusPx * radiusPx / (STEP_PX * STEP_PX);
        for (int i = 0; i < nodes; i++) {
            ofAmount[i] = undone[i] - blurred[i];
            double before = blurred[Math.max(0, i - 1)];
            double after = blurred[Math.min(nodes - 1, i + 1)];
            ofRadius[i] = -perStep * (before - 2 * blurred[i] + after);
        }
    }

    private void blur(double[] of, double[] weights) {
        for (int i = 0; i < nodes; i++) {
            double sum = weights[0] * of[i];
            for (int k = 1; k < weights.length; k++) {
                sum += weights[k] * (of[Math.max(0, i - k)] + of[Math.min(nodes - 1, i + k)]);
            }
            blurred[i] = sum;
        }
    }

    /** Derivative of the residual by the amount at a distance from the edge, grey levels. */
    double byAmount(double distancePx) {
        return at(ofAmount, distancePx);
    }

    /** Derivative of the residual by the logarithm of the radius at a distance from the edge, grey levels. */
    double byLogRadius(double distancePx) {
        return at(ofRadius, distancePx);
    }

    private double at(double[] table, double distancePx) {
        double at = (distancePx - fromPx) / STEP_PX;
        int i = (int) at;
        return !(at >= 0) || i >= nodes - 1 ? 0 : table[i] + (at - i) * (table[i + 1] - table[i]);
    }
}
