package org.cellgauge.vision;

import java.util.Arrays;
import org.cellgauge.light.ToneCurve;

/**
 * Grey levels of 8 bits and the light that makes them under one tone curve, for inner loops: a table instead of powers,
 * results in fields, and the expectation of a grey value that noise and the ends of the scale change: values beyond
 * black and white are censored, not measured (Tobin, "Estimation of relationships for limited dependent variables",
 * Econometrica 1958). Not thread-safe: each thread evaluates at an own one of {@link #another}.
 */
final class GreyScale {
    private static final double WHITE = 255;
    private static final int NODES = 512;
    /** Light up to which the table goes: what is beyond white is seen by its edges alone. */
    private static final double MOST_LIGHT = 3;
    private static final double PER_ROOT = NODES / Math.sqrt(MOST_LIGHT);
    private static final double LEAST_LIGHT = 1e-7;
    private static final double LEAST_ROOT = Math.sqrt(LEAST_LIGHT);
    /** Node of the table from which on four neighbours tell a logarithm to a millionth. */
    private static final int FIRST_CUBIC = 20;
    /** Logarithms of the light at the nodes of the table. */
    private static final double[] LOGARITHM = new double[NODES + 1];
    /** Level below which powers are cut off: there light would no longer change with the level. */
    private static final double CUT_LEVEL = 0.25;
    private static final double LEAST_LEVEL = 0.3;
    private static final double LEAST_LEVEL_LINEAR = -20;
    /** Noise reaches the ends of the scale within so many deviations. */
    private static final double REACH = 3;

    static {
        for (int i = 1; i <= NODES; i++) {
            LOGARITHM[i] = 2 * Math.log(i / PER_ROOT);
        }
    }

    /** Expected grey level. */
    double grey;
    /** Its derivative by the light. */
    double byLight;
    /** Share of the noise that leaves the grey level within the scale. */
    double inside;

    private final Tables tables;
    private double darkLight;
    private double brightLight;
    private double darkByPower;
    private double brightByPower;
    /** Work space: light, its root, and its logarithm. */
    private double[] lights = new double[0];
    private double[] roots = new double[0];
    private double[] logarithms = new double[0];

    /** What every one of {@link #another} sees: a curve by its tables, and the noise. */
    private static final class Tables {
        private ToneCurve curve = ToneCurve.LINEAR;
        private boolean linear;
        /** Node from which on the table is a power, and even enough for a cubic through four nodes. */
        private int firstCubic;
        private double noise = 1.5;
        /** Grey and its derivative by the light by turns, at equal steps of the light's root. */
        private final double[] grey = new double[2 * NODES + 2];
        private final double[] lightOfByte = new double[257];
    }

    /** The scale of a linear curve. */
    GreyScale() {
        tables = new Tables();
        tabulate();
    }

    private GreyScale(Tables tables) {
        this.tables = tables;
    }

    /**
     * The same scale, whatever curve and noise are set from now on, with results of its own. Nothing may be set while
     * another thread evaluates.
     *
     * @return a scale that shares curve and noise with this one
     */
    GreyScale another() {
        return new GreyScale(tables);
    }

    /**
     * Takes another curve.
     *
     * @param other the curve
     */
    void set(ToneCurve other) {
        if (!other.equals(tables.curve)) {
            tables.curve = other;
            tabulate();
        }
    }

    private void tabulate() {
        ToneCurve curve = tables.curve;
        double[] table = tables.grey;
        boolean linear = curve.isLinear();
        tables.linear = linear;
        for (int i = 0; i <= 256; i++) {
            tables.lightOfByte[i] = light(i);
        }
        for (int i = 0; i <= NODES && !linear; i++) {
            double root = i / PER_ROOT;
            table[2 * i] = WHITE * curve.grey(root * root);
        }
        for (int i = 1; i < NODES && !linear; i++) {
            // by the root from both neighbours, by the light by the chain rule
            table[2 * i + 1] = (table[2 * i + 2] - table[2 * i - 2]) * PER_ROOT / 2 * PER_ROOT / (2 * i);
        }
        tables.firstCubic = FIRST_CUBIC;
        while (tables.firstCubic < NODES && curve.isToe(table[2 * tables.firstCubic - 2] / WHITE)) {
            tables.firstCubic++;
        }
        table[1] = table[3];
        table[2 * NODES + 1] = table[2 * NODES - 1];
    }

    /** Standard deviation of the noise that may push grey values over the ends of the scale, grey levels. */
    void setNoise(double stdGrey) {
        tables.noise = Math.max(0.3, stdGrey);
    }

    /** What {@link #setNoise} has set. */
    double noise() {
        return tables.noise;
    }

    /**
     * The least grey level that black may be fitted with: below it {@link #light} is constant and a fit would stick.
     *
     * @return grey level; negative where grey is light, as a black level that is not quite 0 makes it
     */
    double leastLevel() {
        return tables.linear ? LEAST_LEVEL_LINEAR : LEAST_LEVEL;
    }

    /** The curve in force. */
    ToneCurve curve() {
        return tables.curve;
    }

    /**
     * Light of a grey level.
     *
     * @param level grey level; beyond 255 the curve goes on
     * @return light, 1 at 255
     */
    double light(double level) {
        return tables.linear ? level / WHITE : tables.curve.light(Math.max(level, CUT_LEVEL) / WHITE);
    }

    /**
     * Light of a grey level from a table.
     *
     * @param level grey level, 0 to 255
     * @return light, 1 at 255
     */
    double tabulatedLight(double level) {
        int i = (int) level;
        double[] light = tables.lightOfByte;
        return light[i] + (level - i) * (light[i + 1] - light[i]);
    }

    /**
     * Derivative of {@link #light}.
     *
     * @param level grey level
     * @return light per grey level
     */
    double lightByGrey(double level) {
        return lightByGrey(level, light(level));
    }

    /**
     * The same where the light is known, which saves a power.
     *
     * @param level grey level
     * @param light its light
     * @return light per grey level
     */
    double lightByGrey(double level, double light) {
        if (tables.linear) {
            return 1 / WHITE;
        }
        return level < CUT_LEVEL ? 0 : tables.curve.lightByGrey(level / WHITE, light) / WHITE;
    }

    /**
     * Prepares {@link #byPower} for the two sides of an edge.
     *
     * @param dark grey level of the dark side
     * @param bright grey level of the bright side
     */
    void setEnds(double dark, double bright) {
        double offset = tables.curve.offset();
        double d = (Math.max(dark, CUT_LEVEL) / WHITE + offset) / (1 + offset);
        double b = (Math.max(bright, CUT_LEVEL) / WHITE + offset) / (1 + offset);
        darkLight = Math.pow(d, tables.curve.power());
        brightLight = Math.pow(b, tables.curve.power());
        darkByPower = darkLight * Math.log(d);
        brightByPower = brightLight * Math.log(b);
    }

    /**
     * Derivative of the grey of a share of light by the curve's power, the grey levels of dark and bright held; see
     * {@link ToneCurve#greyByPower}.
     *
     * @param share of the light that comes from the bright side
     * @return grey levels per unit of the power
     */
    double byPower(double share) {
        double power = tables.curve.power();
        double light = Math.max(LEAST_LIGHT, darkLight + (brightLight - darkLight) * share);
        double logarithm = Math.log(light);
        double change = darkByPower * (1 - share) + brightByPower * share;
        return WHITE * (1 + tables.curve.offset()) * Math.exp(logarithm / power) * (change / (power * light)
                - logarithm / (power * power));
    }

    /**
     * The same for many shares, to a millionth: by cubics through the nodes of the table. An exponential and a
     * logarithm of every pixel would take longer than all else of it.
     *
     * @param shares of the light that come from the bright side
     * @param count how many
     * @param out receives grey levels per unit of the power
     */
    void byPower(double[] shares, int count, double[] out) {
        if (tables.linear) {
            for (int i = 0; i < count; i++) {
                out[i] = byPower(shares[i]);
            }
            return;
        }
        if (lights.length < count) {
            lights = new double[shares.length];
            roots = new double[shares.length];
            logarithms = new double[shares.length];
        }
        double[] light = lights;
        double[] root = roots;
        double dark = darkLight;
        double contrast = brightLight - darkLight;
        for (int i = 0; i < count; i++) {
            light[i] = dark + contrast * shares[i];
        }
        for (int i = 0; i < count; i++) {
            root[i] = Math.sqrt(light[i]);
        }
        lookUpPowers(count, out);
        double power = tables.curve.power();
        double perLight = 1 / power;
        double perLogarithm = 1 / (power * power);
        double[] logarithm = logarithms;
        double ofDark = darkByPower;
        double ofContrast = brightByPower - darkByPower;
        for (int i = 0; i < count; i++) {
            out[i] *= (ofDark + ofContrast * shares[i]) * perLight / light[i] - perLogarithm * logarithm[i];
        }
    }

    /** Of roots of light, powers in grey levels and logarithms. */
    private void lookUpPowers(int count, double[] powers) {
        double[] t = tables.grey;
        double[] l = LOGARITHM;
        double[] root = roots;
        double[] logarithm = logarithms;
        double[] light = lights;
        double added = WHITE * tables.curve.offset();
        int first = tables.firstCubic;
        for (int i = 0; i < count; i++) {
            double at = root[i] * PER_ROOT;
            int k = (int) at;
            if (k < first || k > NODES - 2) {
                double inScale = Math.max(LEAST_LIGHT, light[i]);
                light[i] = inScale;
                logarithm[i] = Math.log(inScale);
                powers[i] = (WHITE + added) * Math.exp(logarithm[i] / tables.curve.power());
                continue;
            }
            // Lagrange's polynomial
            double f = at - k;
            double low = f * (f - 1) / 6;
            double high = (f + 1) * (f - 2) / 2;
            double before = low * (2 - f);
            double here = high * (f - 1);
            double next = -high * f;
            double after = low * (f + 1);
            powers[i] = added + before * t[2 * k - 2] + here * t[2 * k] + next * t[2 * k + 2] + after * t[2 * k + 4];
            logarithm[i] = before * l[k - 1] + here * l[k] + next * l[k + 1] + after * l[k + 2];
        }
    }

    /**
     * Evaluates {@link #grey} and {@link #byLight}.
     *
     * @param light light, 1 at white
     */
    void at(double light) {
        at(light, 0, WHITE);
    }

    /**
     * The same for many pixels, each as {@link #at(double, double, double)} has it to the last bit.
     *
     * @param lights light, 1 at white
     * @param floors grey level at which each pixel's scale ends below
     * @param caps grey level at which it ends above
     * @param count how many pixels
     * @param greys receives expected grey levels
     * @param byLights receives their derivatives by the light
     * @param insides receives shares of the noise that leave the grey level within the scale
     * @return whether noise reaches the ends of no pixel's scale
     */
    boolean at(double[] lights, double[] floors, double[] caps, int count, double[] greys, double[] byLights,
            double[] insides) {
        endless(lights, count, greys, byLights);
        Arrays.fill(insides, 0, count, 1);
        double reach = REACH * tables.noise;
        boolean within = true;
        for (int i = 0; i < count; i++) {
            if (greys[i] < floors[i] + reach || greys[i] > caps[i] - reach) {
                grey = greys[i];
                byLight = byLights[i];
                censor(floors[i], caps[i]);
                greys[i] = grey;
                byLights[i] = byLight;
                insides[i] = inside;
                within = false;
            }
        }
        return within;
    }

    /**
     * Grey levels of a scale without ends: the curve itself.
     *
     * @param lights light, 1 at white
     * @param count how many
     * @param greys receives grey levels
     * @param byLights receives their derivatives by the light
     */
    void endless(double[] lights, int count, double[] greys, double[] byLights) {
        if (tables.linear) {
            for (int i = 0; i < count; i++) {
                greys[i] = WHITE * lights[i];
            }
            Arrays.fill(byLights, 0, count, WHITE);
        } else {
            // the root of no light or less is no number, or too small, and is replaced when it is looked up
            for (int i = 0; i < count; i++) {
                greys[i] = Math.sqrt(lights[i]);
            }
            lookUp(lights, count, greys, byLights);
        }
    }

    /** In place of roots of light, grey levels. */
    private void lookUp(double[] lights, int count, double[] greys, double[] byLights) {
        double[] t = tables.grey;
        for (int i = 0; i < count; i++) {
            double at = (lights[i] > LEAST_LIGHT ? greys[i] : LEAST_ROOT) * PER_ROOT;
            int k = Math.min((int) at, NODES - 1);
            double f = at - k;
            double before = t[2 * k];
            double slopeBefore = t[2 * k + 1];
            greys[i] = before + f * (t[2 * k + 2] - before);
            byLights[i] = slopeBefore + f * (t[2 * k + 3] - slopeBefore);
        }
    }

    /**
     * The same for a pixel whose scale ends elsewhere.
     *
     * @param light light, 1 at white
     * @param floor grey level at which it ends below
     * @param cap grey level at which it ends above
     */
    void at(double light, double floor, double cap) {
        if (tables.linear) {
            grey = WHITE * light;
            byLight = WHITE;
        } else {
            double root = Math.sqrt(Math.max(light, LEAST_LIGHT));
            double at = root * PER_ROOT;
            int i = Math.min((int) at, NODES - 1);
            double f = at - i;
            double[] t = tables.grey;
            double before = t[2 * i];
            double slopeBefore = t[2 * i + 1];
            grey = before + f * (t[2 * i + 2] - before);
            byLight = slopeBefore + f * (t[2 * i + 3] - slopeBefore);
        }
        censor(floor, cap);
    }

    /** Expectation of a grey value that noise may push over the ends of its scale. */
    private void censor(double floor, double cap) {
        double noise = tables.noise;
        inside = 1;
        if (grey < floor + REACH * noise) {
            double z = (grey - floor) / noise;
            inside = EdgeProfile.tabulated(z);
            grey = floor + ((grey - floor) * inside + noise * EdgeProfile.density(z));
            byLight *= inside;
        } else if (grey > cap - REACH * noise) {
            double z = (cap - grey) / noise;
            inside = EdgeProfile.tabulated(z);
            grey = cap - ((cap - grey) * inside + noise * EdgeProfile.density(z));
            byLight *= inside;
        }
    }
}
