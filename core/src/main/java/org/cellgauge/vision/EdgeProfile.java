package org.cellgauge.vision;

/**
 * What a pixel sees of a straight edge: the share of its light that comes from the bright side, when optics blur the
 * edge by a Gaussian and the pixel averages over its own square.
 *
 * <p>Along the edge's normal (nx, ny) a unit square weighs like two boxes of widths |nx| and |ny| convolved. With
 * {@code G(x) = ((x² + s²) Φ(x/s) + x s φ(x/s)) / 2}, the second integral of the blurred step, the share at
 * distance d is {@code (G(d+p) - G(d+m) - G(d-m) + G(d-p)) / (|nx| |ny|)}, p and m being half the sum and half the
 * difference of the widths. A Gaussian alone would not do: the edge of a sharp image would then seem to move with its
 * place within a pixel by some hundredths. Not thread-safe; results are fields so that nothing is allocated per pixel.
 */
final class EdgeProfile {
    private static final double ROOT_TWO_PI = Math.sqrt(2 * Math.PI);
    /** Below this width a box is as good as none, and the formula would divide by its width. */
    private static final double NARROWEST = 0.05;
    /** Beyond this many deviations of the blur only one side is seen: the rest is a ten-thousandth of a grey level. */
    private static final double REACH = 5;

    /** Share of light from the bright side, 0 to 1. */
    double share;
    /** Derivative of the share by the distance, 1/px. */
    double byDistance;
    /** Derivative of the share by the blur, 1/px. */
    double byBlur;

    private double sumHalf;
    private double differenceHalf;
    private double inverseArea;
    private double first;
    private double second;
    private double cumulative;

    /**
     * Sets the direction of the edge.
     *
     * @param nx x of its unit normal
     * @param ny y of its unit normal
     */
    void turn(double nx, double ny) {
        double a = Math.max(NARROWEST, Math.abs(nx));
        double b = Math.max(NARROWEST, Math.abs(ny));
        sumHalf = (a + b) / 2;
        differenceHalf = (a - b) / 2;
        inverseArea = 1 / (a * b);
    }

    /**
     * Evaluates share and derivatives.
     *
     * @param distance of the pixel's centre from the edge, positive on the bright side, px
     * @param blur standard deviation of the optical blur, positive, px
     */
    void at(double distance, double blur) {
        double reach = sumHalf + REACH * blur;
        if (distance >= reach || distance <= -reach) {
            share = distance > 0 ? 1 : 0;
            byDistance = 0;
            byBlur = 0;
            return;
        }
        integrals(distance + sumHalf, blur);
        double g2 = second;
        double g1 = first;
        double g0 = cumulative;
        integrals(distance + differenceHalf, blur);
        g2 -= second;
        g1 -= first;
        g0 -= cumulative;
        integrals(distance - differenceHalf, blur);
        g2 -= second;
        g1 -= first;
        g0 -= cumulative;
        integrals(distance - sumHalf, blur);
        share = (g2 + second) * inverseArea;
        byDistance = (g1 + first) * inverseArea;
        // the blurred step obeys the heat equation: its derivative by the blur is blur times that by distance twice
        byBlur = blur * (g0 + cumulative) * inverseArea;
    }

    /** The blurred step and its first and second integral. */
    private void integrals(double x, double blur) {
        double z = x / blur;
        double density = Math.exp(-0.5 * z * z) / ROOT_TWO_PI;
        cumulative = cumulative(z, density);
        first = x * cumulative + blur * density;
        second = 0.5 * ((x * x + blur * blur) * cumulative + x * blur * density);
    }

    /**
     * The normal distribution function.
     *
     * @param z any value
     * @return its value, with an error below 7.5e-8
     */
    static double cumulative(double z) {
        return cumulative(z, Math.exp(-0.5 * z * z) / ROOT_TWO_PI);
    }

    /** Normal distribution function by Abramowitz and Stegun, 26.2.17: the error is below 7.5e-8. */
    private static double cumulative(double z, double density) {
        double t = 1 / (1 + 0.2316419 * Math.abs(z));
        double tail = density * t * (0.319381530 + t * (-0.356563782 + t * (1.781477937
                + t * (-1.821255978 + t * 1.330274429))));
        return z < 0 ? tail : 1 - tail;
    }
}
