package org.cellgauge.vision;

import java.util.Arrays;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.DampedGaussNewton;
import org.cellgauge.light.ToneCurve;
import org.jspecify.annotations.Nullable;

/**
 * One side of a marker fitted to the grey values of the pixels about it: position and slope of its line, width of the
 * blur, grey level of black and white.
 *
 * <p>What a pixel sees is modelled as light: a straight blurred step, made smaller by the ends of the side, with the
 * light that blur brings from the pattern inside and from beyond the paper's edge on top; the tone curve then makes
 * grey of it. Least squares by damped Gauss-Newton in grey levels, where a camera's noise is nearly the same
 * everywhere: the maximum-likelihood estimate under white noise, and its information matrix is the covariance of the
 * line. Not thread-safe; arrays are kept between fits.
 */
final class SideFit {
    static final int UNKNOWNS = 5;
    static final int OFFSET = 0;
    static final int SLOPE = 1;
    static final int BLUR = 2;
    static final int DARK = 3;
    static final int BRIGHT = 4;
    /** Power of the curve, amount and logarithm of the radius of an unsharp mask. */
    static final int SHAPES = 3;
    /** How far from the edge a mask's effect is tabulated, deviations of blur and mask. */
    private static final double STEP_REACH = 5;
    private static final int MAX_STEPS = 20;
    /** A step that moves the line by less is the last one, px; of the first fit; and on the way to a tone curve. */
    static final double SETTLED_PX = 1e-3;
    static final double FIRST_SETTLED_PX = 0.01;
    static final double NEARLY_SETTLED_PX = 0.02;
    static final double SMALLEST_BLUR_PX = 0.1;
    /**
     * So many times that of an edge without blur: what a pixel sees of it changes all at once where the edge leaves the
     * pixel, so that steps go to and fro, each by two thirds of the last.
     */
    private static final double KINKED = 5;
    static final double LARGEST_BLUR_PX = 4;
    /** A bright side that is clipped may be as bright as this, in grey levels of the tone curve's continuation. */
    private static final double LARGEST_LEVEL = 400;
    /**
     * Power is judged by pixels with less light than this from elsewhere, as a share of white: what is taken as given
     * of that light hangs on power itself.
     */
    private static final double CLEAN_SHARE = 0.003;
    /** Where an overshoot is looked for, and beyond what it is measured from: deviations of the blur. */
    private static final double NEAR = 1.3;
    private static final double FAR = 2.6;
    /** And at least so far from the edge, px: a pixel that the edge itself crosses says nothing of an overshoot. */
    private static final double NEAR_PX = 0.8;
    private static final double FAR_PX = 1.6;
    /** Grey level from which on a value is taken for clipped. */
    private static final double CLIPPED = 254.5;

    // geometry in undistorted pixels: middle of the side, unit tangent and unit normal, outwards
    double middleX;
    double middleY;
    double tangentX;
    double tangentY;
    double normalX;
    double normalY;
    double lengthPx;
    double halfLengthPx;

    /**
     * Change of the lamp's light along and across the side as a share of that in its middle, 1/px; given, not fitted.
     */
    double lampAlong;
    double lampAcross;

    // pixels: place along and across the side, grey, and what of white's light is there whatever the step
    private double[] along = new double[256];
    private double[] across = new double[256];
    private double[] grey = new double[256];
    private double[] floor = new double[256];
    private double[] cap = new double[256];
    private double[] window = new double[256];
    private double[] base = new double[256];
    private double[] baseByBlur = new double[256];
    private double baseBlur;
    private int samples;
    /** How many of them, the first ones, tell of power; see {@link #CLEAN_SHARE}. */
    private int clean;

    // of each pixel, at the unknowns last evaluated
    private double[] residuals = new double[0];
    private double[] shares = new double[0];
    private double[] insides = new double[0];
    private double[] byLights = new double[0];
    private double[] byOffset = new double[0];
    private double[] bySlope = new double[0];
    private double[] byBlur = new double[0];
    private double[] byDark = new double[0];
    private double[] byBright = new double[0];
    private double[] distances = new double[0];
    private double[] lights = new double[0];
    private final Work work;

    // where they were last evaluated: mostly what is asked of a fit next is asked there
    private boolean evaluated;
    private final double[] evaluatedAt = new double[UNKNOWNS];
    private @Nullable ToneCurve evaluatedCurve;
    private double evaluatedNoise;
    private boolean evaluatedInside;

    final double[] unknowns = new double[UNKNOWNS];
    private final DampedGaussNewton solver =
            new DampedGaussNewton(UNKNOWNS, DampedGaussNewton.Damping.TENFOLD, MAX_STEPS);
    private final double[] normal = new double[UNKNOWNS * UNKNOWNS];
    private final double[] gradient = new double[UNKNOWNS];
    private final double[] gathered = new double[UNKNOWNS * UNKNOWNS];
    private final double[] factor = new double[UNKNOWNS * UNKNOWNS];
    private final double[] factorInverse = new double[UNKNOWNS * UNKNOWNS];
    private final double[] inverted = new double[UNKNOWNS * UNKNOWNS];
    /** For the scale and the profile of the fit before, which are mostly those of the next; null before the first. */
    private @Nullable Line line;
    private final double[] covariance = new double[UNKNOWNS * UNKNOWNS];
    private final double[] powerRow = new double[UNKNOWNS];
    private final double[][] shapeRow = new double[SHAPES][];
    private final double[][] shapeRows = new double[SHAPES][UNKNOWNS];
    private boolean started;

    /** Position-weighted sum of squared residuals of the pixels and what it would be for noise of 1 grey level. */
    double squares;
    double expectedSquares;
    double degreesOfFreedom;
    /** Score and information of power from this side, for noise of 1 grey level, its own unknowns projected out. */
    double powerScore;
    double powerInformation;
    /** The same of power, amount and logarithm of the radius of an unsharp mask; and the offset's change by them. */
    final double[] shapeScore = new double[SHAPES];
    final double[] shapeInformation = new double[SHAPES * SHAPES];
    final double[] offsetByShape = new double[SHAPES];
    /** How far the mask lifts grey above white, as a share of the difference of white and black. */
    double maskOvershoot;
    /** Change of the line by {@link #lampAlong}: of its offset, px², and of its slope, px. */
    double offsetByLamp;
    double slopeByLamp;
    /** Change of the offset by power, px. */
    double offsetByPower;
    /** Share of the pixels of the bright side that are clipped at white, and of the dark side at black. */
    double clippedShare;
    double crushedShare;
    /** How far grey rises above white and falls below black beside the edge, as a share of their difference. */
    double overshoot;
    /** What is known of the blur beforehand, px, and how well: grey levels squared over px squared, 0 for nothing. */
    private double expectedBlur;
    private double settledPx = SETTLED_PX;
    private double blurWeight;

    /** A value of each pixel that is summed up next: for the sides of a marker, one after another. */
    static final class Work {
        private double[] summed = new double[0];
        private double[] byPower = new double[0];
        private double[] byAmount = new double[0];
        private double[] byLogRadius = new double[0];

        private void reserve(int count) {
            if (summed.length < count) {
                int length = count + count / 4 + 64;
                summed = new double[length];
                byPower = new double[length];
                byAmount = new double[length];
                byLogRadius = new double[length];
            }
        }
    }

    /**
     * A side without pixels.
     *
     * @param work for this and other sides, of which one is fitted at a time
     */
    SideFit(Work work) {
        this.work = work;
    }

    /**
     * Drops the pixels; the line is where the side's new coordinates have it.
     *
     * @param blurPx at which light from elsewhere will be given
     */
    void clear(double blurPx) {
        samples = 0;
        clean = 0;
        evaluated = false;
        baseBlur = blurPx;
        unknowns[OFFSET] = 0;
        unknowns[SLOPE] = 0;
    }

    /**
     * Takes the blur as known beforehand: along a row of pixels a sharp edge tells place or blur, not both.
     *
     * @param blurPx blur of other sides, px
     * @param stdPx how well it is known of this one, px, positive
     * @param noiseGrey noise of a pixel, grey levels
     */
    void expectBlur(double blurPx, double stdPx, double noiseGrey) {
        expectedBlur = blurPx;
        blurWeight = noiseGrey * noiseGrey / (stdPx * stdPx);
        unknowns[BLUR] = blurPx;
    }

    /**
     * How well the last fit tells where the side lies, its blur unknown.
     *
     * @param noiseGrey noise of a pixel, grey levels
     * @return standard deviation across in its middle, px
     */
    double offsetStdPx(double noiseGrey) {
        return noiseGrey * Math.sqrt(covariance(OFFSET, OFFSET));
    }

    /**
     * Forgets the last fit: the next one starts from the grey values alone.
     *
     * @param blurPx where the blur starts, px
     */
    void restart(double blurPx) {
        started = false;
        blurWeight = 0;
        unknowns[BLUR] = blurPx;
    }

    /** Whether there was a fit before. */
    boolean started() {
        return started;
    }

    /**
     * Adds a pixel.
     *
     * @param t place along the side from its middle, px
     * @param d place across, outwards, px
     * @param level its grey level
     * @param least where its scale ends below, grey level
     * @param most where its scale ends above, grey level
     * @param inside share of the step's dark side that lies within the ends of the side
     * @param more light from elsewhere as a share of the difference of white and black
     * @param moreByBlur its derivative by the blur, 1/px
     */
    void add(double t, double d, double level, double least, double most, double inside, double more,
            double moreByBlur) {
        if (samples == along.length) {
            along = Arrays.copyOf(along, 2 * samples);
            across = Arrays.copyOf(across, 2 * samples);
            grey = Arrays.copyOf(grey, 2 * samples);
            floor = Arrays.copyOf(floor, 2 * samples);
            cap = Arrays.copyOf(cap, 2 * samples);
            window = Arrays.copyOf(window, 2 * samples);
            base = Arrays.copyOf(base, 2 * samples);
            baseByBlur = Arrays.copyOf(baseByBlur, 2 * samples);
        }
        double elsewhere = 1 - inside + more;
        int at = samples++;
        if (Math.abs(elsewhere) < CLEAN_SHARE) {
            // to the others of its kind, so that loops over them need not ask
            move(clean, at);
            at = clean++;
        }
        along[at] = t;
        across[at] = d;
        grey[at] = level;
        floor[at] = least;
        cap[at] = most;
        window[at] = inside;
        base[at] = elsewhere;
        baseByBlur[at] = moreByBlur;
        evaluated = false;
    }

    private void move(int from, int to) {
        along[to] = along[from];
        across[to] = across[from];
        grey[to] = grey[from];
        floor[to] = floor[from];
        cap[to] = cap[from];
        window[to] = window[from];
        base[to] = base[from];
        baseByBlur[to] = baseByBlur[from];
    }

    /**
     * Fits.
     *
     * @param scale tone curve and noise
     * @param profile turned to the side's normal
     * @param settled a step that moves the line by less is the last one, px
     * @return whether a dark and a bright side were found
     */
    boolean fit(GreyScale scale, EdgeProfile profile, double settled) {
        settledPx = settled;
        if (samples < 4 * UNKNOWNS) {
            return false;
        }
        if (!started) {
            unknowns[OFFSET] = 0;
            unknowns[SLOPE] = 0;
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            int clipped = 0;
            for (int i = 0; i < samples; i++) {
                low = Math.min(low, grey[i]);
                high = Math.max(high, grey[i]);
                clipped += grey[i] > CLIPPED ? 1 : 0;
            }
            unknowns[DARK] = low;
            unknowns[BRIGHT] = 10 * clipped > samples ? 1.1 * high : high;
            started = true;
        }
        // clipped noise makes the darkest pixel 0, and another curve may have left less
        unknowns[DARK] = Math.max(scale.leastLevel(), unknowns[DARK]);
        Line problem = line;
        if (problem == null || problem.scale != scale || problem.profile != profile) {
            problem = new Line(scale, profile);
            line = problem;
        }
        problem.evaluated = false;
        solver.minimise(problem);
        return !solver.isSingular() && unknowns[BRIGHT] > unknowns[DARK] + 1;
    }

    /** The side as the solver sees it: a step is within what blur and grey levels can be. */
    private final class Line implements DampedGaussNewton.Problem {
        private final GreyScale scale;
        private final EdgeProfile profile;
        /** Whether sum and derivative at the unknowns are known, from when they were tried. */
        private boolean evaluated;
        private double sum;
        private final double[] trial = new double[UNKNOWNS];

        Line(GreyScale scale, EdgeProfile profile) {
            this.scale = scale;
            this.profile = profile;
        }

        @Override
        public double linearise(double[] information, double[] toGradient) {
            if (!evaluated) {
                sum = SideFit.this.linearise(scale, profile, unknowns, normal, gradient);
                holdBlurAtBounds(unknowns[BLUR]);
                evaluated = true;
            }
            System.arraycopy(normal, 0, information, 0, normal.length);
            System.arraycopy(gradient, 0, toGradient, 0, UNKNOWNS);
            return sum;
        }

        @Override
        public double at(double[] step) {
            for (int k = 0; k < UNKNOWNS; k++) {
                trial[k] = unknowns[k] + step[k];
            }
            trial[BLUR] = Math.min(LARGEST_BLUR_PX, Math.max(SMALLEST_BLUR_PX, trial[BLUR]));
            trial[DARK] = Math.max(scale.leastLevel(), trial[DARK]);
            trial[BRIGHT] = Math.min(LARGEST_LEVEL, trial[BRIGHT]);
            // the last step need not be tried: so near to the end of its way a fit does not go astray
            if (!isSettled()) {
                // with its derivative at once: nearly every step is taken
                sum = SideFit.this.linearise(scale, profile, trial, normal, gradient);
                holdBlurAtBounds(trial[BLUR]);
            }
            return sum;
        }

        /**
         * Leaves the blur out of the next step where it is at the end of its range and would go beyond: cut off there,
         * the rest of the step would be that of a blur which is not reached (Bertsekas, "Projected Newton methods for
         * optimization problems with simple constraints", SIAM J. Control Optim. 20, 1982).
         */
        private void holdBlurAtBounds(double blur) {
            if (blur <= SMALLEST_BLUR_PX && gradient[BLUR] > 0 || blur >= LARGEST_BLUR_PX && gradient[BLUR] < 0) {
                for (int k = 0; k < UNKNOWNS; k++) {
                    normal[BLUR * UNKNOWNS + k] = 0;
                    normal[k * UNKNOWNS + BLUR] = 0;
                }
                normal[BLUR * (UNKNOWNS + 1)] = 1;
                gradient[BLUR] = 0;
            }
        }

        @Override
        public void accept() {
            System.arraycopy(trial, 0, unknowns, 0, UNKNOWNS);
        }

        @Override
        public boolean isEnough(double squaredStds, double before, double after, boolean accepted) {
            return accepted && isSettled();
        }

        private boolean isSettled() {
            double settled = trial[BLUR] <= SMALLEST_BLUR_PX ? KINKED * settledPx : settledPx;
            return Math.abs(trial[OFFSET] - unknowns[OFFSET])
                    + Math.abs(trial[SLOPE] - unknowns[SLOPE]) * halfLengthPx < settled;
        }
    }

    private double linearise(GreyScale scale, EdgeProfile profile, double[] p, double[] n, double[] g) {
        evaluate(scale, profile, p);
        information(0, samples, n);
        byUnknowns(residuals, samples, g);
        double beside = p[BLUR] - expectedBlur;
        g[BLUR] += blurWeight * beside;
        n[BLUR * (UNKNOWNS + 1)] += blurWeight;
        return dot(residuals, residuals, samples) + blurWeight * beside * beside;
    }

    /** Residuals of all pixels, and their derivatives by the unknowns, unless known from the last time. */
    private void evaluate(GreyScale scale, EdgeProfile profile, double[] p) {
        if (isEvaluated(scale, p)) {
            return;
        }
        if (residuals.length < samples) {
            int length = along.length;
            residuals = new double[length];
            shares = new double[length];
            insides = new double[length];
            byLights = new double[length];
            byOffset = new double[length];
            bySlope = new double[length];
            byBlur = new double[length];
            byDark = new double[length];
            byBright = new double[length];
            distances = new double[length];
            lights = new double[length];
        }
        double lightDark = scale.light(p[DARK]);
        double lightBright = scale.light(p[BRIGHT]);
        double contrast = lightBright - lightDark;
        double darkSlope = scale.lightByGrey(p[DARK], lightDark);
        double brightSlope = scale.lightByGrey(p[BRIGHT], lightBright);
        setDistances(p[OFFSET], p[SLOPE]);
        profile.at(distances, samples, p[BLUR], shares, byOffset, byBlur);
        setShares(p[BLUR] - baseBlur);
        setLights(lightDark, contrast);
        evaluatedInside = scale.at(lights, floor, cap, samples, residuals, byLights, insides);
        differentiate(contrast, darkSlope, brightSlope);
        System.arraycopy(p, 0, evaluatedAt, 0, UNKNOWNS);
        evaluatedCurve = scale.curve();
        evaluatedNoise = scale.noise();
        evaluated = true;
    }

    /** Whether all pixels were last evaluated there; less noise matters to none that was not at an end of its scale. */
    private boolean isEvaluated(GreyScale scale, double[] p) {
        return evaluated && evaluatedCurve == scale.curve() && Arrays.equals(evaluatedAt, p)
                && (evaluatedNoise == scale.noise() || evaluatedInside && scale.noise() < evaluatedNoise);
    }

    // each of these loops does one thing to all pixels, which the compiler can do to several at a time

    private void setDistances(double offset, double slope) {
        double[] out = distances;
        double[] d = across;
        double[] t = along;
        for (int i = 0; i < samples; i++) {
            out[i] = d[i] - offset - slope * t[i];
        }
    }

    private void setShares(double blurred) {
        double[] out = shares;
        double[] elsewhere = base;
        double[] byElsewhere = baseByBlur;
        double[] within = window;
        for (int i = 0; i < samples; i++) {
            out[i] = elsewhere[i] + byElsewhere[i] * blurred + within[i] * out[i];
        }
    }

    private void setLights(double lightDark, double contrast) {
        double[] out = lights;
        double[] share = shares;
        double[] d = across;
        double[] t = along;
        double byAlong = lampAlong;
        double byAcross = lampAcross;
        for (int i = 0; i < samples; i++) {
            out[i] = (1 + byAlong * t[i] + byAcross * d[i]) * (lightDark + contrast * share[i]);
        }
    }

    /** Residuals in place of grey levels, and derivatives of grey levels in place of those of a share of the light. */
    private void differentiate(double contrast, double darkSlope, double brightSlope) {
        double[] byOwnLight = lights;
        scaleByLamp(byOwnLight);
        double[] residual = residuals;
        double[] level = grey;
        for (int i = 0; i < samples; i++) {
            residual[i] -= level[i];
        }
        double[] within = window;
        double[] r0 = byOffset;
        for (int i = 0; i < samples; i++) {
            r0[i] = -(byOwnLight[i] * contrast) * within[i] * r0[i];
        }
        double[] r1 = bySlope;
        double[] t = along;
        for (int i = 0; i < samples; i++) {
            r1[i] = r0[i] * t[i];
        }
        double[] r2 = byBlur;
        double[] byElsewhere = baseByBlur;
        for (int i = 0; i < samples; i++) {
            r2[i] = byOwnLight[i] * contrast * (within[i] * r2[i] + byElsewhere[i]);
        }
        double[] share = shares;
        double[] r3 = byDark;
        for (int i = 0; i < samples; i++) {
            r3[i] = byOwnLight[i] * darkSlope * (1 - share[i]);
        }
        double[] r4 = byBright;
        for (int i = 0; i < samples; i++) {
            r4[i] = byOwnLight[i] * brightSlope * share[i];
        }
    }

    /** Derivatives of grey levels by the light without the lamp's change. */
    private void scaleByLamp(double[] out) {
        double[] byLight = byLights;
        double[] d = across;
        double[] t = along;
        double byAlong = lampAlong;
        double byAcross = lampAcross;
        for (int i = 0; i < samples; i++) {
            out[i] = byLight[i] * (1 + byAlong * t[i] + byAcross * d[i]);
        }
    }

    /** Sums of products of the derivatives of some pixels, in two loops, each of which has registers enough. */
    private void information(int from, int to, double[] n) {
        double n00 = 0;
        double n10 = 0;
        double n11 = 0;
        double n20 = 0;
        double n21 = 0;
        double n22 = 0;
        for (int i = from; i < to; i++) {
            double r0 = byOffset[i];
            double r1 = bySlope[i];
            double r2 = byBlur[i];
            n00 += r0 * r0;
            n10 += r1 * r0;
            n11 += r1 * r1;
            n20 += r2 * r0;
            n21 += r2 * r1;
            n22 += r2 * r2;
        }
        double n30 = 0;
        double n31 = 0;
        double n32 = 0;
        double n33 = 0;
        double n40 = 0;
        double n41 = 0;
        double n42 = 0;
        double n43 = 0;
        double n44 = 0;
        for (int i = from; i < to; i++) {
            double r0 = byOffset[i];
            double r1 = bySlope[i];
            double r2 = byBlur[i];
            double r3 = byDark[i];
            double r4 = byBright[i];
            n30 += r3 * r0;
            n31 += r3 * r1;
            n32 += r3 * r2;
            n33 += r3 * r3;
            n40 += r4 * r0;
            n41 += r4 * r1;
            n42 += r4 * r2;
            n43 += r4 * r3;
            n44 += r4 * r4;
        }
        n[0] = n00;
        n[5] = n10;
        n[6] = n11;
        n[10] = n20;
        n[11] = n21;
        n[12] = n22;
        n[15] = n30;
        n[16] = n31;
        n[17] = n32;
        n[18] = n33;
        n[20] = n40;
        n[21] = n41;
        n[22] = n42;
        n[23] = n43;
        n[24] = n44;
        for (int a = 0; a < UNKNOWNS; a++) {
            for (int b = 0; b < a; b++) {
                n[b * UNKNOWNS + a] = n[a * UNKNOWNS + b];
            }
        }
    }

    /**
     * Evaluates, at the solution, what the fit says of itself: the covariance of the line for noise of 1 grey level,
     * residuals, and what it says of power.
     *
     * @param scale tone curve and noise
     * @param profile turned to the side's normal
     * @param withPower whether the curve is a power whose power is asked for
     * @return false where the information is singular
     */
    boolean conclude(GreyScale scale, EdgeProfile profile, boolean withPower) {
        evaluate(scale, profile, unknowns);
        information(0, clean, gathered);
        information(clean, samples, normal);
        for (int k = 0; k < normal.length; k++) {
            normal[k] += gathered[k];
        }
        double weights = normal[0];
        concludeEnds();
        concludeOvershoot();
        normal[BLUR * (UNKNOWNS + 1)] += blurWeight;
        double[] inverse = inverseOfDamped(normal);
        if (inverse == null || !(weights > 0)) {
            return false;
        }
        System.arraycopy(inverse, 0, covariance, 0, inverse.length);
        concludeLamp(scale);
        concludeNoise(weights);
        if (withPower) {
            powerOfClean(scale);
        }
        return true;
    }

    /** How much of what is bright and of what is dark is at the end of the scale. */
    private void concludeEnds() {
        int bright = 0;
        int dark = 0;
        int clipped = 0;
        int crushed = 0;
        for (int i = 0; i < samples; i++) {
            if (shares[i] > 0.9) {
                bright++;
                clipped += grey[i] > CLIPPED ? 1 : 0;
            } else if (shares[i] < 0.1) {
                dark++;
                crushed += grey[i] < 0.5 ? 1 : 0;
            }
        }
        clippedShare = bright == 0 ? 0 : (double) clipped / bright;
        crushedShare = dark == 0 ? 0 : (double) crushed / dark;
    }

    /** Sharpening lifts the bright side beside an edge and lowers the dark one. */
    private void concludeOvershoot() {
        double std = Math.sqrt(unknowns[BLUR] * unknowns[BLUR] + 1.0 / 12);
        double nearPx = Math.max(NEAR * std, NEAR_PX);
        double farPx = Math.max(FAR * std, FAR_PX);
        double near = 0;
        double far = 0;
        int nearCount = 0;
        int farCount = 0;
        for (int i = 0; i < samples; i++) {
            double distance = distances[i];
            if (Math.abs(distance) > nearPx && Math.abs(base[i]) < 0.02) {
                double beyond = distance > 0 ? -residuals[i] : residuals[i];
                if (Math.abs(distance) < farPx) {
                    near += beyond;
                    nearCount++;
                } else {
                    far += beyond;
                    farCount++;
                }
            }
        }
        overshoot = nearCount == 0 || farCount == 0 ? 0
                : 2 * (near / nearCount - far / farCount) / (unknowns[BRIGHT] - unknowns[DARK]);
    }

    private void concludeLamp(GreyScale scale) {
        double lightDark = scale.light(unknowns[DARK]);
        double contrast = scale.light(unknowns[BRIGHT]) - lightDark;
        work.reserve(samples);
        double[] byLamp = work.summed;
        double[] byLight = byLights;
        double[] share = shares;
        double[] t = along;
        for (int i = 0; i < samples; i++) {
            byLamp[i] = byLight[i] * (lightDark + contrast * share[i]) * t[i];
        }
        byUnknowns(byLamp, samples, powerRow);
        offsetByLamp = -ofRow(covariance, OFFSET, powerRow);
        slopeByLamp = -ofRow(covariance, SLOPE, powerRow);
    }

    private static double ofRow(double[] m, int row, double[] v) {
        double sum = 0;
        for (int k = 0; k < UNKNOWNS; k++) {
            sum += m[row * UNKNOWNS + k] * v[k];
        }
        return sum;
    }

    /**
     * Squared residuals of the pixels, weighed by how they tell the place, and what the fit takes of the noise of each:
     * the pixels' leverages (Hoaglin and Welsch, "The hat matrix in regression and ANOVA", The American Statistician
     * 32, 1978).
     */
    private void concludeNoise(double weights) {
        work.reserve(samples);
        double[] leverages = work.summed;
        setLeverages(leverages);
        double weighted = 0;
        double taken = 0;
        for (int i = 0; i < samples; i++) {
            double w = byOffset[i] * byOffset[i];
            weighted += w * residuals[i] * residuals[i];
            taken += w * leverages[i];
        }
        squares = weighted / weights;
        expectedSquares = Math.max(0.1, 1 - taken / weights);
        degreesOfFreedom = samples - UNKNOWNS;
    }

    private void setLeverages(double[] out) {
        double[] c = covariance;
        double c00 = c[0];
        double c11 = c[6];
        double c22 = c[12];
        double c33 = c[18];
        double c44 = c[24];
        // both triangles at once
        double c10 = 2 * c[5];
        double c20 = 2 * c[10];
        double c21 = 2 * c[11];
        double c30 = 2 * c[15];
        double c31 = 2 * c[16];
        double c32 = 2 * c[17];
        double c40 = 2 * c[20];
        double c41 = 2 * c[21];
        double c42 = 2 * c[22];
        double c43 = 2 * c[23];
        double[] r0 = byOffset;
        double[] r1 = bySlope;
        double[] r2 = byBlur;
        double[] r3 = byDark;
        double[] r4 = byBright;
        for (int i = 0; i < samples; i++) {
            out[i] = r0[i] * (c00 * r0[i] + c10 * r1[i] + c20 * r2[i] + c30 * r3[i] + c40 * r4[i])
                    + r1[i] * (c11 * r1[i] + c21 * r2[i] + c31 * r3[i] + c41 * r4[i])
                    + r2[i] * (c22 * r2[i] + c32 * r3[i] + c42 * r4[i])
                    + r3[i] * (c33 * r3[i] + c43 * r4[i]) + r4[i] * c44 * r4[i];
        }
    }

    /** Projects the side's own unknowns out of the score and the information of power. */
    private void powerOfClean(GreyScale scale) {
        scale.setEnds(unknowns[DARK], unknowns[BRIGHT]);
        work.reserve(samples);
        double[] byPower = work.byPower;
        scale.byPower(shares, clean, byPower);
        byUnknowns(byPower, clean, powerRow);
        byUnknowns(residuals, clean, gradient);
        powerScore = 0;
        powerInformation = 0;
        offsetByPower = 0;
        double[] inverse = inverseOfDamped(gathered);
        if (inverse == null) {
            return;
        }
        double taken = 0;
        double ofOthers = 0;
        for (int a = 0; a < UNKNOWNS; a++) {
            double moved = ofRow(inverse, a, powerRow);
            if (a == OFFSET) {
                offsetByPower = -moved;
            }
            taken += moved * powerRow[a];
            ofOthers += moved * gradient[a];
        }
        powerInformation = Math.max(0, dot(byPower, byPower, clean) - taken);
        powerScore = ofOthers - dot(byPower, residuals, clean);
    }

    /**
     * Evaluates, at the solution, score and information of the curve's power, of the amount of an unsharp mask that was
     * undone and of the logarithm of its radius ({@link #shapeScore}, {@link #shapeInformation}, {@link
     * #offsetByShape}).
     *
     * @param scale tone curve and noise
     * @param profile turned to the side's normal
     * @param table work space
     * @param amount of the mask, at least 0
     * @param radiusPx deviation of its Gaussian, px
     */
    void sharpness(GreyScale scale, EdgeProfile profile, SharpenedStep table, double amount, double radiusPx) {
        double[] p = unknowns;
        table.setEdge(scale, profile, p[BLUR], scale.light(p[DARK]), scale.light(p[BRIGHT]),
                STEP_REACH * (Math.sqrt(p[BLUR] * p[BLUR] + 1.0 / 12) + radiusPx));
        table.solve(amount, radiusPx);
        maskOvershoot = table.overshoot;
        evaluate(scale, profile, p);
        scale.setEnds(p[DARK], p[BRIGHT]);
        work.reserve(samples);
        scale.byPower(shares, clean, work.byPower);
        table.at(distances, clean, work.byAmount, work.byLogRadius);
        shapeRow[0] = work.byPower;
        shapeRow[1] = work.byAmount;
        shapeRow[2] = work.byLogRadius;
        double[] within = insides;
        for (int a = 0; a < SHAPES; a++) {
            double[] by = shapeRow[a];
            for (int i = 0; i < clean; i++) {
                by[i] *= within[i];
            }
            byUnknowns(by, clean, shapeRows[a]);
            shapeScore[a] = -dot(by, residuals, clean);
            for (int b = 0; b <= a; b++) {
                shapeInformation[a * SHAPES + b] = dot(by, shapeRow[b], clean);
                shapeInformation[b * SHAPES + a] = shapeInformation[a * SHAPES + b];
            }
        }
        byUnknowns(residuals, clean, gradient);
        information(0, clean, gathered);
        double[] inverse = inverseOfDamped(gathered);
        if (inverse == null) {
            Arrays.fill(shapeInformation, 0);
            Arrays.fill(shapeScore, 0);
            Arrays.fill(offsetByShape, 0);
            return;
        }
        projectShape(inverse);
    }

    /** Sums of the derivatives by each unknown, times something else of every pixel. */
    private void byUnknowns(double[] of, int count, double[] out) {
        double s0 = 0;
        double s1 = 0;
        double s2 = 0;
        double s3 = 0;
        double s4 = 0;
        for (int i = 0; i < count; i++) {
            double v = of[i];
            s0 += byOffset[i] * v;
            s1 += bySlope[i] * v;
            s2 += byBlur[i] * v;
            s3 += byDark[i] * v;
            s4 += byBright[i] * v;
        }
        out[OFFSET] = s0;
        out[SLOPE] = s1;
        out[BLUR] = s2;
        out[DARK] = s3;
        out[BRIGHT] = s4;
    }

    /** Sum of products; four at a time, as no one of them has to wait for the one before. */
    private static double dot(double[] a, double[] b, int count) {
        double s0 = 0;
        double s1 = 0;
        double s2 = 0;
        double s3 = 0;
        int i = 0;
        for (; i < count - 3; i += 4) {
            s0 += a[i] * b[i];
            s1 += a[i + 1] * b[i + 1];
            s2 += a[i + 2] * b[i + 2];
            s3 += a[i + 3] * b[i + 3];
        }
        for (; i < count; i++) {
            s0 += a[i] * b[i];
        }
        return s0 + s1 + (s2 + s3);
    }

    /** Inverse of a matrix of the unknowns, hardly damped, in an array that the next call writes over; null: none. */
    private double @Nullable [] inverseOfDamped(double[] matrix) {
        System.arraycopy(matrix, 0, factor, 0, factor.length);
        for (int a = 0; a < UNKNOWNS; a++) {
            factor[a * (UNKNOWNS + 1)] += 1e-9;
        }
        return Cholesky.inverse(factor, UNKNOWNS, factorInverse, inverted) ? inverted : null;
    }

    /** Projects the side's own unknowns out of score and information of the shape. */
    private void projectShape(double[] inverse) {
        for (int s = 0; s < SHAPES; s++) {
            for (int a = 0; a < UNKNOWNS; a++) {
                double moved = ofRow(inverse, a, shapeRows[s]);
                if (a == OFFSET) {
                    offsetByShape[s] = -moved;
                }
                shapeScore[s] += moved * gradient[a];
                for (int other = 0; other < SHAPES; other++) {
                    shapeInformation[other * SHAPES + s] -= shapeRows[other][a] * moved;
                }
            }
        }
    }

    /** Covariance of two unknowns for noise of 1 grey level. */
    double covariance(int a, int b) {
        return covariance[a * UNKNOWNS + b];
    }
}
