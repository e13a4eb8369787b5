package org.cellgauge.vision;

import java.util.Arrays;

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
    private double[] distances = new double[0];
    private double[] lights = new double[0];
    private double[] byLights = new double[0];
    private double[] grey = new double[0];
    private double[] undone = new double[0];
    /** What is blurred next, its ends continued as far as the Gaussian reaches. */
    private double[] padded = new double[0];
    private double weightsRadius = Double.NaN;
    private double[] weights = new double[0];
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
            distances = new double[nodes];
            lights = new double[nodes];
            byLights = new double[nodes];
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
     * Makes the tables and takes the grey values of a fitted edge, as if nothing else were there.
     *
     * @param scale makes grey of light
     * @param profile turned to the edge's normal
     * @param blurPx optical blur, px
     * @param lightDark light of its dark side
     * @param lightBright light of its bright side
     * @param lengthPx how far from the edge tables go, px
     */
    void setEdge(GreyScale scale, EdgeProfile profile, double blurPx, double lightDark, double lightBright,
            double lengthPx) {
        prepare(lengthPx);
        double[] light = lights;
        for (int i = 0; i < nodes; i++) {
            distances[i] = distance(i);
        }
        profile.shares(distances, nodes, blurPx, light);
        double contrast = lightBright - lightDark;
        for (int i = 0; i < nodes; i++) {
            light[i] = lightDark + contrast * light[i];
        }
        scale.endless(light, nodes, grey, byLights);
    }

    /**
     * Fills the tables.
     *
     * @param amount of the mask, at least 0
     * @param radiusPx deviation of its Gaussian, positive, px
     */
    void solve(double amount, double radiusPx) {
        if (radiusPx != weightsRadius) {
            weights = Unsharpened.weights(radiusPx / STEP_PX);
            weightsRadius = radiusPx;
        }
        if (padded.length < nodes + 2 * weights.length) {
            padded = new double[nodes + 2 * weights.length];
        }
        blur(grey);
        overshoot = 0;
        double contrast = grey[nodes - 1] - grey[0];
        for (int i = 0; i < nodes; i++) {
            double sharpened = grey[i] + amount * (grey[i] - blurred[i]);
            overshoot = Math.max(overshoot, (sharpened - grey[nodes - 1]) / contrast);
        }
        System.arraycopy(grey, 0, undone, 0, nodes);
        for (int round = 0; amount > 0 && round < ROUNDS; round++) {
            for (int i = 0; i < nodes; i++) {
                undone[i] = (grey[i] + amount * blurred[i]) / (1 + amount);
            }
            blur(undone);
        }
        double perStep = amount * radiusPx * radiusPx / (STEP_PX * STEP_PX);
        for (int i = 0; i < nodes; i++) {
            ofAmount[i] = undone[i] - blurred[i];
            double before = blurred[Math.max(0, i - 1)];
            double after = blurred[Math.min(nodes - 1, i + 1)];
            ofRadius[i] = -perStep * (before - 2 * blurred[i] + after);
        }
    }

    /** Blurs: weight by weight, so that the compiler can take several nodes at a time. */
    private void blur(double[] of) {
        double[] from = padded;
        double[] to = blurred;
        int reach = weights.length - 1;
        Arrays.fill(from, 0, reach, of[0]);
        System.arraycopy(of, 0, from, reach, nodes);
        Arrays.fill(from, reach + nodes, 2 * reach + nodes, of[nodes - 1]);
        double own = weights[0];
        for (int i = 0; i < nodes; i++) {
            to[i] = own * of[i];
        }
        for (int k = 1; k <= reach; k++) {
            add(weights[k], from, reach - k, reach + k, to);
        }
    }

    private void add(double weight, double[] from, int before, int after, double[] to) {
        for (int i = 0; i < nodes; i++) {
            to[i] += weight * (from[before + i] + from[after + i]);
        }
    }

    /**
     * Looks up how the residual changes.
     *
     * @param distancesPx from the edge, px
     * @param count how many
     * @param byAmount receives derivatives by the amount, grey levels
     * @param byLogRadius receives those by the logarithm of the radius, grey levels
     */
    void at(double[] distancesPx, int count, double[] byAmount, double[] byLogRadius) {
        double[] a = ofAmount;
        double[] r = ofRadius;
        for (int n = 0; n < count; n++) {
            double at = (distancesPx[n] - fromPx) / STEP_PX;
            int i = (int) at;
            if (!(at >= 0) || i >= nodes - 1) {
                byAmount[n] = 0;
                byLogRadius[n] = 0;
            } else {
                double f = at - i;
                byAmount[n] = a[i] + f * (a[i + 1] - a[i]);
                byLogRadius[n] = r[i] + f * (r[i + 1] - r[i]);
            }
        }
    }
}
