package org.cellgauge.vision;

/**
 * What a pixel sees of a straight edge: the share of its light that comes from the bright side, when optics blur the
 * edge by a Gaussian and the pixel averages over its own square.
 *
 * <p>Along the edge's normal (nx, ny) a unit square weighs like two boxes of widths |nx| and |ny| convolved. With
 * {@code G(x) = ((x² + s²) Φ(x/s) + x s φ(x/s)) / 2}, the second integral of the blurred step, the share at
 * distance d is {@code (G(d+p) - G(d+m) - G(d-m) + G(d-p)) / (|nx| |ny|)}, p and m being half the sum and half the
 * difference of the widths. A Gaussian alone would not do: the edge of a sharp image would then seem to move with its
 * place within a pixel by some hundredths. From a blur of {@value #SMOOTH} px on the box is smooth enough for an
 * Edgeworth series up to the sixth cumulant (Kendall and Stuart, "The Advanced Theory of Statistics" I, 1977, 6.18: the
 * cumulants of a box of width a are a²/12, -a⁴/120, a⁶/252), which is ten times quicker and as good: the error is below
 * 1e-4. Not thread-safe; results are fields so that nothing is allocated per pixel.
 */
final class EdgeProfile {
    private static final double ROOT_TWO_PI = Math.sqrt(2 * Math.PI);
    /** Below this width a box is as good as none, and the formula would divide by its width. */
    private static final double NARROWEST = 0.05;
    /** Beyond this many deviations of the blur only one side is seen: the rest is a ten-thousandth of a grey level. */
    private static final double REACH = 5;
    /** Blur from which on the series is used, px. */
    static final double SMOOTH = 0.5;
    /** Steps per unit of the tables of the normal distribution: linear between them, to 1e-6. */
    private static final int STEPS = 256;
    private static final int LARGEST = 8;
    private static final int NODES = 2 * LARGEST * STEPS + 2;
    /** Distribution and density by turns: what is asked for at once lies side by side. */
    private static final double[] NORMAL = new double[2 * NODES];

    static {
        for (int i = 0; i < NODES; i++) {
            double z = (double) i / STEPS - LARGEST;
            NORMAL[2 * i] = cumulative(z);
            NORMAL[2 * i + 1] = Math.exp(-0.5 * z * z) / ROOT_TWO_PI;
        }
    }

    /** Share of light from the bright side, 0 to 1. */
    double share;
    /** Derivative of the share by the distance, 1/px. */
    double byDistance;
    /** Derivative of the share by the blur, 1/px. */
    double byBlur;

    private double fourthCumulant;
    private double sixthCumulant;
    private double widthsVariance;
    private double seriesBlur;
    private double inverseStd;
    private double c4;
    private double c6;
    private double c44;
    private double sumHalf;
    private double differenceHalf;
    private double inverseArea;
    private double first;
    private double second;
    private double cumulative;
    /** Work space: distances in deviations, and the normal density there. */
    private double[] deviations = new double[0];
    private double[] densities = new double[0];

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
        double a2 = a * a;
        double b2 = b * b;
        widthsVariance = (a2 + b2) / 12;
        fourthCumulant = -(a2 * a2 + b2 * b2) / 120;
        sixthCumulant = (a2 * a2 * a2 + b2 * b2 * b2) / 252;
        seriesBlur = Double.NaN;
    }

    /**
     * Evaluates share and derivatives.
     *
     * @param distance of the pixel's centre from the edge, positive on the bright side, px
     * @param blur standard deviation of the optical blur, positive, px
     */
    void at(double distance, double blur) {
        if (blur >= SMOOTH) {
            series(distance, blur);
            return;
        }
        double reach = sumHalf + REACH * blur;
        if (distance >= reach || distance <= -reach) {
            share = distance > 0 ? 1 : 0;
            byDistance = 0;
            byBlur = 0;
            return;
        }
        double inverseBlur = 1 / blur;
        integrals(distance + sumHalf, inverseBlur, blur);
        double g2 = second;
        double g1 = first;
        double g0 = cumulative;
        integrals(distance + differenceHalf, inverseBlur, blur);
        g2 -= second;
        g1 -= first;
        g0 -= cumulative;
        integrals(distance - differenceHalf, inverseBlur, blur);
        g2 -= second;
        g1 -= first;
        g0 -= cumulative;
        integrals(distance - sumHalf, inverseBlur, blur);
        share = (g2 + second) * inverseArea;
        byDistance = (g1 + first) * inverseArea;
        // the blurred step obeys the heat equation: its derivative by the blur is blur times that by distance twice
        byBlur = blur * (g0 + cumulative) * inverseArea;
    }

    /**
     * Evaluates share and derivatives at many distances, each as {@link #at} does to the last bit: every loop does one
     * thing, so that the compiler can take several distances at a time.
     *
     * @param distances of pixels' centres from the edge, positive on the bright side, px
     * @param count how many of them
     * @param blur standard deviation of the optical blur, positive, px
     * @param shares receives shares of light from the bright side, 0 to 1
     * @param byDistances receives their derivatives by the distance, 1/px
     * @param byBlurs receives their derivatives by the blur, 1/px
     */
    void at(double[] distances, int count, double blur, double[] shares, double[] byDistances, double[] byBlurs) {
        if (blur < SMOOTH) {
            for (int i = 0; i < count; i++) {
                at(distances[i], blur);
                shares[i] = share;
                byDistances[i] = byDistance;
                byBlurs[i] = byBlur;
            }
            return;
        }
        shares(distances, count, blur, shares);
        expandByDistance(count, byDistances);
        expandByBlur(count, blur, byBlurs);
    }

    /**
     * Evaluates shares alone.
     *
     * @param distances of pixels' centres from the edge, positive on the bright side, px
     * @param count how many of them
     * @param blur standard deviation of the optical blur, positive, px
     * @param shares receives shares of light from the bright side, 0 to 1
     */
    void shares(double[] distances, int count, double blur, double[] shares) {
        if (blur < SMOOTH) {
            for (int i = 0; i < count; i++) {
                at(distances[i], blur);
                shares[i] = share;
            }
            return;
        }
        if (blur != seriesBlur) {
            prepareSeries(blur);
        }
        if (deviations.length < count) {
            deviations = new double[distances.length];
            densities = new double[distances.length];
        }
        lookUp(distances, count, shares);
        expandShares(count, shares);
    }

    /** Distances in deviations, and the normal distribution and its density there. */
    private void lookUp(double[] distances, int count, double[] distribution) {
        double[] normal = NORMAL;
        double[] density = densities;
        double[] zs = deviations;
        double perPx = inverseStd;
        for (int i = 0; i < count; i++) {
            double z = distances[i] * perPx;
            zs[i] = z;
            if (z >= REACH || z <= -REACH) {
                distribution[i] = z > 0 ? 1 : 0;
                density[i] = 0;
            } else {
                double at = (z + LARGEST) * STEPS;
                int k = (int) at;
                double f = at - k;
                double before = normal[2 * k];
                double densityBefore = normal[2 * k + 1];
                distribution[i] = before + f * (normal[2 * k + 2] - before);
                density[i] = densityBefore + f * (normal[2 * k + 3] - densityBefore);
            }
        }
    }

    // one result a loop: of three at once the compiler makes one pixel at a time

    private void expandShares(int count, double[] shares) {
        double[] zs = deviations;
        double[] density = densities;
        double ofFourth = c4;
        double ofSixth = c6;
        double ofFourthTwice = c44;
        for (int i = 0; i < count; i++) {
            double z = zs[i];
            double z2 = z * z;
            double h5 = z * (z2 * (z2 - 10) + 15);
            double h6 = z2 * (z2 * (z2 - 15) + 45) - 15;
            double h7 = z * h6 - 6 * h5;
            shares[i] -= density[i] * (ofFourth * (z * (z2 - 3)) + ofSixth * h5 + ofFourthTwice * h7);
        }
    }

    private void expandByDistance(int count, double[] out) {
        double[] zs = deviations;
        double[] density = densities;
        double ofFourth = c4;
        double ofSixth = c6;
        double ofFourthTwice = c44;
        double perPx = inverseStd;
        for (int i = 0; i < count; i++) {
            double z = zs[i];
            double z2 = z * z;
            double h5 = z * (z2 * (z2 - 10) + 15);
            double h6 = z2 * (z2 * (z2 - 15) + 45) - 15;
            double h8 = z * (z * h6 - 6 * h5) - 7 * h6;
            out[i] = density[i] * perPx
                    * (1 + ofFourth * (z2 * (z2 - 6) + 3) + ofSixth * h6 + ofFourthTwice * h8);
        }
    }

    private void expandByBlur(int count, double blur, double[] out) {
        double[] zs = deviations;
        double[] density = densities;
        double ofFourth = c4;
        double ofSixth = c6;
        double ofFourthTwice = c44;
        double perPx = inverseStd;
        for (int i = 0; i < count; i++) {
            double z = zs[i];
            double z2 = z * z;
            double h5 = z * (z2 * (z2 - 10) + 15);
            double h6 = z2 * (z2 * (z2 - 15) + 45) - 15;
            double h7 = z * h6 - 6 * h5;
            double h9 = z * (z * h7 - 7 * h6) - 8 * h7;
            out[i] = -blur * density[i] * perPx * perPx
                    * (z + ofFourth * h5 + ofSixth * h7 + ofFourthTwice * h9);
        }
    }

    /** In parts small enough for the compiler to put them into the loops that call them. */
    private void series(double distance, double blur) {
        if (blur != seriesBlur) {
            prepareSeries(blur);
        }
        double z = distance * inverseStd;
        if (z >= REACH || z <= -REACH) {
            share = z > 0 ? 1 : 0;
            byDistance = 0;
            byBlur = 0;
            return;
        }
        double at = (z + LARGEST) * STEPS;
        int i = (int) at;
        double f = at - i;
        double[] normal = NORMAL;
        double before = normal[2 * i];
        double densityBefore = normal[2 * i + 1];
        expand(z, before + f * (normal[2 * i + 2] - before),
                densityBefore + f * (normal[2 * i + 3] - densityBefore), blur);
    }

    private void prepareSeries(double blur) {
        double variance = widthsVariance + blur * blur;
        inverseStd = 1 / Math.sqrt(variance);
        double k4 = fourthCumulant / (variance * variance);
        c4 = k4 / 24;
        c6 = sixthCumulant / (variance * variance * variance) / 720;
        c44 = k4 * k4 / 1152;
        seriesBlur = blur;
    }

    private void expand(double z, double distribution, double density, double blur) {
        double z2 = z * z;
        // Hermite polynomials 3 to 9
        double h3 = z * (z2 - 3);
        double h4 = z2 * (z2 - 6) + 3;
        double h5 = z * (z2 * (z2 - 10) + 15);
        double h6 = z2 * (z2 * (z2 - 15) + 45) - 15;
        double h7 = z * h6 - 6 * h5;
        double h8 = z * h7 - 7 * h6;
        double h9 = z * h8 - 8 * h7;
        share = distribution - density * (c4 * h3 + c6 * h5 + c44 * h7);
        byDistance = density * inverseStd * (1 + c4 * h4 + c6 * h6 + c44 * h8);
        byBlur = -blur * density * inverseStd * inverseStd * (z + c4 * h5 + c6 * h7 + c44 * h9);
    }

    /**
     * The normal distribution function from a table.
     *
     * @param z any value
     * @return its value, with an error below 1e-6
     */
    static double tabulated(double z) {
        double at = (z + LARGEST) * STEPS;
        if (!(at > 0)) {
            return 0;
        }
        int i = (int) at;
        return i >= NODES - 1 ? 1 : NORMAL[2 * i] + (at - i) * (NORMAL[2 * i + 2] - NORMAL[2 * i]);
    }

    /**
     * The normal density from a table.
     *
     * @param z any value
     * @return its value, with an error below 1e-6
     */
    static double density(double z) {
        double at = (z + LARGEST) * STEPS;
        int i = (int) at;
        return at > 0 && i < NODES - 1 ? NORMAL[2 * i + 1] + (at - i) * (NORMAL[2 * i + 3] - NORMAL[2 * i + 1]) : 0;
    }

    /**
     * The blurred step and its first and second integral: the normal distribution about the next node of the table by
     * three terms of its series, whose error is below that of the nodes.
     */
    private void integrals(double x, double inverseBlur, double blur) {
        double z = x * inverseBlur;
        if (z <= -LARGEST || z >= LARGEST) {
            cumulative = z > 0 ? 1 : 0;
            first = z > 0 ? x : 0;
            second = z > 0 ? 0.5 * (x * x + blur * blur) : 0;
            return;
        }
        int node = (int) ((z + LARGEST) * STEPS + 0.5);
        double at = (double) node / STEPS - LARGEST;
        double step = z - at;
        double curved = (at * at - 1) * step * step;
        double atNode = NORMAL[2 * node + 1];
        double density = atNode * (1 - at * step + curved / 2);
        cumulative = NORMAL[2 * node] + atNode * step * (1 - at * step / 2 + curved / 6);
        first = x * cumulative + blur * density;
        second = 0.5 * ((x * x + blur * blur) * cumulative + x * blur * density);
    }

    /**
     * The normal distribution function, by Abramowitz and Stegun, 26.2.17.
     *
     * @param z any value
     * @return its value, with an error below 7.5e-8
     */
    static double cumulative(double z) {
        double density = Math.exp(-0.5 * z * z) / ROOT_TWO_PI;
        double t = 1 / (1 + 0.2316419 * Math.abs(z));
        double tail = density * t * (0.319381530 + t * (-0.356563782 + t * (1.781477937
                + t * (-1.821255978 + t * 1.330274429))));
        return z < 0 ? tail : 1 - tail;
    }
}
