package org.cellgauge.geometry;

import static org.cellgauge.geometry.PinholeCamera.CX;
import static org.cellgauge.geometry.PinholeCamera.CY;
import static org.cellgauge.geometry.PinholeCamera.FX;
import static org.cellgauge.geometry.PinholeCamera.FY;
import static org.cellgauge.geometry.PinholeCamera.SKEW;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A fisheye: the distance from the image's middle is a polynomial of the angle off the axis, so that the lens may see
 * half of all directions and more.
 *
 * <p>With the angle {@code t = atan2(sqrt(X² + Y²), Z)} and the direction {@code (c, s) = (X, Y) / sqrt(X² + Y²)}
 * <pre>
 * r = t + k1 t³ + k2 t⁵ + k3 t⁷ + k4 t⁹,   xd = r c,   yd = r s
 * </pre>
 * (J. Kannala and S. S. Brandt, "A generic camera model and calibration method for conventional, wide-angle, and
 * fish-eye lenses", PAMI 2006, equation 6, the radially symmetric part; the same as OpenCV's fisheye and as BoofCV's
 * {@code kannala_brandt} once the polynomial's first coefficient is taken into the focal lengths). The model ends where
 * r stops growing with t, and at the latest at t = pi.
 */
public final class KannalaBrandtLens implements Lens {
    /** The model. */
    public static final KannalaBrandtLens MODEL = new KannalaBrandtLens();

    /** Index of the coefficient of t³; those of t⁵, t⁷ and t⁹ follow. */
    public static final int K1 = 5;
    /** Index of the coefficient of t⁵. */
    public static final int K2 = 6;
    /** Index of the coefficient of t⁷. */
    public static final int K3 = 7;
    /** Index of the coefficient of t⁹. */
    public static final int K4 = 8;
    /** Number of parameters. */
    public static final int PARAMETERS = 9;

    private static final List<String> NAMES = Collections.unmodifiableList(Arrays.asList("fx_px", "fy_px", "cx_px",
            "cy_px", "skew_px", "k1", "k2", "k3", "k4"));
    private static final int NEWTON_STEPS = 60;
    private static final double NEWTON_TOLERANCE_RAD = 1e-12;
    private static final double SCAN_STEP_RAD = 0.01;
    private static final double BOUND_FACTOR = 0.8;
    private static final int HALVINGS = 40;

    private KannalaBrandtLens() {
    }

    @Override
    public String modelName() {
        return "kannala_brandt";
    }

    @Override
    public List<String> parameterNames() {
        return NAMES;
    }

    @Override
    public int parameterCount() {
        return PARAMETERS;
    }

    @Override
    public boolean isDistorting(double[] parameters) {
        // no choice of coefficients makes a polynomial of the angle its tangent
        return true;
    }

    @Override
    public boolean isWide() {
        return true;
    }

    @Override
    public double reachRad(double[] parameters) {
        return risenUntil(parameters, Double.POSITIVE_INFINITY);
    }

    /** The distance r of an angle. */
    private static double radius(double[] k, double t) {
        double t2 = t * t;
        return t * (1 + t2 * (k[K1] + t2 * (k[K2] + t2 * (k[K3] + t2 * k[K4]))));
    }

    /** Its derivative by the angle. */
    private static double slope(double[] k, double t) {
        double t2 = t * t;
        return 1 + t2 * (3 * k[K1] + t2 * (5 * k[K2] + t2 * (7 * k[K3] + t2 * 9 * k[K4])));
    }

    /** Whether r grows from the axis up to an angle, as far as a bound tells: what is below 0 alone takes it down. */
    private static boolean risesUpTo(double[] k, double t) {
        double t2 = t * t;
        return 1 + t2 * (3 * Math.min(0, k[K1]) + t2 * (5 * Math.min(0, k[K2])
                + t2 * (7 * Math.min(0, k[K3]) + t2 * 9 * Math.min(0, k[K4])))) > 0;
    }

    /** An angle up to which r grows and reaches a distance; if it never does, where it stops growing, or pi. */
    private static double risenUntil(double[] k, double r) {
        double sure = Math.PI;
        while (sure > SCAN_STEP_RAD && !risesUpTo(k, sure)) {
            sure *= BOUND_FACTOR;
        }
        double t = sure;
        while (t < Math.PI && radius(k, t) < r) {
            double next = Math.min(t + SCAN_STEP_RAD, Math.PI);
            if (!(slope(k, next) > 0)) {
                return lastRising(k, t, next);
            }
            t = next;
        }
        return t;
    }

    /** Where r stops growing, between an angle at which it grows and one at which it does not. */
    private static double lastRising(double[] k, double rising, double falling) {
        double low = rising;
        double high = falling;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = (low + high) / 2;
            if (slope(k, middle) > 0) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    @Override
    public boolean project(double[] parameters, double x, double y, double z, double[] uv, int offset) {
        double across = Math.sqrt(x * x + y * y);
        double t = Math.atan2(across, z);
        if (!(slope(parameters, t) > 0)) {
            return false;
        }
        double scale;
        if (across > 0) {
            scale = radius(parameters, t) / across;
        } else if (z > 0) {
            scale = 1 / z;
        } else {
            return false;
        }
        double xd = x * scale;
        double yd = y * scale;
        uv[offset] = parameters[FX] * xd + parameters[SKEW] * yd + parameters[CX];
        uv[offset + 1] = parameters[FY] * yd + parameters[CY];
        return true;
    }

    @Override
    public boolean projectWithDerivatives(double[] parameters, double x, double y, double z, double[] uv,
            double[] byPoint, double @Nullable [] byParameters) {
        double across = Math.sqrt(x * x + y * y);
        double t = Math.atan2(across, z);
        double slope = slope(parameters, t);
        if (!(slope > 0) || !(across > 0 || z > 0)) {
            return false;
        }
        double squared = across * across + z * z;
        // on the axis any direction across serves: what follows does not depend on it there
        double c = across > 0 ? x / across : 1;
        double s = across > 0 ? y / across : 0;
        double r = radius(parameters, t);
        double around = across > 0 ? r / across : 1 / z;
        double outwards = slope * z / squared;
        double along = -slope * across / squared;
        double xd = across > 0 ? r * c : 0;
        double yd = across > 0 ? r * s : 0;
        double fx = parameters[FX];
        double fy = parameters[FY];
        double skew = parameters[SKEW];
        uv[0] = fx * xd + skew * yd + parameters[CX];
        uv[1] = fy * yd + parameters[CY];

        // a step outwards changes r, a step around turns (c, s)
        double xdByX = outwards * c * c + around * s * s;
        double xdByY = (outwards - around) * c * s;
        double ydByY = outwards * s * s + around * c * c;
        byPoint[0] = fx * xdByX + skew * xdByY;
        byPoint[1] = fx * xdByY + skew * ydByY;
        byPoint[2] = (fx * c + skew * s) * along;
        byPoint[3] = fy * xdByY;
        byPoint[4] = fy * ydByY;
        byPoint[5] = fy * s * along;

        if (byParameters != null) {
            int v = PARAMETERS;
            byParameters[FX] = xd;
            byParameters[FY] = 0;
            byParameters[CX] = 1;
            byParameters[CY] = 0;
            byParameters[SKEW] = yd;
            byParameters[v + FX] = 0;
            byParameters[v + FY] = yd;
            byParameters[v + CX] = 0;
            byParameters[v + CY] = 1;
            byParameters[v + SKEW] = 0;
            double power = across > 0 ? t : 0;
            for (int i = K1; i <= K4; i++) {
                power *= t * t;
                byParameters[i] = (fx * c + skew * s) * power;
                byParameters[v + i] = fy * s * power;
            }
        }
        return true;
    }

    @Override
    public boolean toRay(double[] parameters, double u, double v, double[] ray) {
        double yd = (v - parameters[CY]) / parameters[FY];
        double xd = (u - parameters[CX] - parameters[SKEW] * yd) / parameters[FX];
        double r = Math.sqrt(xd * xd + yd * yd);
        double t = angle(parameters, r);
        if (!(t >= 0)) {
            return false;
        }
        double sine = r > 0 ? Math.sin(t) / r : 1;
        ray[0] = xd * sine;
        ray[1] = yd * sine;
        ray[2] = Math.cos(t);
        return true;
    }

    /** The smallest angle of a distance, by Newton's method within bounds that close in; NaN where there is none. */
    private static double angle(double[] k, double r) {
        double low = 0;
        double high = risenUntil(k, r);
        if (!(radius(k, high) >= r)) {
            return Double.NaN;
        }
        double t = Math.min(Math.max(low, r), high);
        for (int step = 0; step < NEWTON_STEPS; step++) {
            double error = radius(k, t) - r;
            if (error > 0) {
                high = t;
            } else {
                low = t;
            }
            double next = t - error / slope(k, t);
            if (!(next >= low && next <= high)) {
                next = (low + high) / 2;
            }
            double change = Math.abs(next - t);
            t = next;
            if (change < NEWTON_TOLERANCE_RAD) {
                return t;
            }
        }
        return Double.NaN;
    }
}
