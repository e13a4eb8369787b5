package org.cellgauge.geometry;

import static org.cellgauge.geometry.PinholeCamera.CX;
import static org.cellgauge.geometry.PinholeCamera.CY;
import static org.cellgauge.geometry.PinholeCamera.FX;
import static org.cellgauge.geometry.PinholeCamera.FY;
import static org.cellgauge.geometry.PinholeCamera.SKEW;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Rational radial, tangential and thin prism distortion of a pinhole camera, for fields of view up to some 140 degrees.
 *
 * <p>The model is OpenCV's of 8 and 12 coefficients (documentation of its module calib3d, "Detailed description"): with
 * the undistorted normalised point {@code (x, y) = (X/Z, Y/Z)} and {@code r² = x² + y²}
 * <pre>
 * q  = (1 + k1 r² + k2 r⁴ + k3 r⁶) / (1 + k4 r² + k5 r⁴ + k6 r⁶)
 * xd = x q + 2 p1 x y + p2 (r² + 2 x²) + s1 r² + s2 r⁴
 * yd = y q + p1 (r² + 2 y²) + 2 p2 x y + s3 r² + s4 r⁴
 * </pre>
 * The quotient is of D. Claus and A. W. Fitzgibbon, "A rational function lens distortion model for general cameras",
 * CVPR 2005, in OpenCV's form; the thin prism of J. Weng, P. Cohen and M. Herniou, "Camera calibration with distortion
 * models and accuracy evaluation", PAMI 14(10), 1992, eq. 14, with a second order. With k4 to k6 and the prism at 0 it
 * is a {@link BrownLens}, which is the faster of the two.
 */
public final class RationalLens implements Lens {
    /** The model. */
    public static final RationalLens MODEL = new RationalLens();

    /** Index of the first radial coefficient; the others of the numerator follow, then those of the denominator. */
    public static final int K1 = 5;
    /** Index of the first radial coefficient of the denominator. */
    public static final int K4 = 8;
    /** Index of the first tangential coefficient; the second follows. */
    public static final int P1 = 11;
    /** Index of the first coefficient of the thin prism; three more follow. */
    public static final int S1 = 13;
    /** Number of parameters. */
    public static final int PARAMETERS = 17;

    private static final List<String> NAMES = List.of("fx_px", "fy_px", "cx_px", "cy_px", "skew_px", "k1", "k2", "k3",
            "k4", "k5", "k6", "p1", "p2", "s1", "s2", "s3", "s4");
    private static final int K2 = 6;
    private static final int K3 = 7;
    private static final int K5 = 9;
    private static final int K6 = 10;
    private static final int P2 = 12;
    private static final int S2 = 14;
    private static final int S3 = 15;
    private static final int S4 = 16;
    private static final int NEWTON_STEPS = 40;
    private static final double NEWTON_TOLERANCE = 1e-12;
    private static final double SHORTEST_NEWTON_STEP = 1e-3;
    /** Points of the ray at which a lens of strong distortion is looked at for a fold. */
    private static final int FOLD_CHECKS = 64;
    private static final double FOLD_SCAN_STEP = 1e-3;
    /** 87 degrees off the axis; nothing such a camera sees lies beyond. */
    private static final double LARGEST_RADIUS = 20;

    private RationalLens() {
    }

    @Override
    public String modelName() {
        return "pinhole_rational";
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
    public boolean isDistorting(double[] p) {
        for (int i = K1; i < PARAMETERS; i++) {
            if (p[i] != 0) {
                return true;
            }
        }
        return false;
    }

    @Override
    public boolean isWide() {
        return false;
    }

    /** Where r q stops growing or the denominator comes to 0, at most 87 degrees. */
    @Override
    public double reachRad(double[] p) {
        if (p[K1] == 0 && p[K2] == 0 && p[K3] == 0 && p[K4] == 0 && p[K5] == 0 && p[K6] == 0) {
            return Math.atan(LARGEST_RADIUS);
        }
        for (double r = FOLD_SCAN_STEP; r < LARGEST_RADIUS; r += FOLD_SCAN_STEP) {
            double r2 = r * r;
            if (!(denominator(p, r2) > 0) || !(quotient(p, r2) + 2 * r2 * quotientByR2(p, r2) > 0)) {
                return Math.atan(Math.max(r - FOLD_SCAN_STEP, FOLD_SCAN_STEP / 2));
            }
        }
        return Math.atan(LARGEST_RADIUS);
    }

    private static double denominator(double[] p, double r2) {
        return 1 + r2 * (p[K4] + r2 * (p[K5] + r2 * p[K6]));
    }

    private static double quotient(double[] p, double r2) {
        return (1 + r2 * (p[K1] + r2 * (p[K2] + r2 * p[K3]))) / denominator(p, r2);
    }

    private static double quotientByR2(double[] p, double r2) {
        double numeratorByR2 = p[K1] + r2 * (2 * p[K2] + r2 * 3 * p[K3]);
        double denominatorByR2 = p[K4] + r2 * (2 * p[K5] + r2 * 3 * p[K6]);
        return (numeratorByR2 - quotient(p, r2) * denominatorByR2) / denominator(p, r2);
    }

    private static double distortedX(double[] p, double x, double y, double r2, double q) {
        return x * q + 2 * p[P1] * x * y + p[P2] * (r2 + 2 * x * x) + r2 * (p[S1] + r2 * p[S2]);
    }

    private static double distortedY(double[] p, double x, double y, double r2, double q) {
        return y * q + p[P1] * (r2 + 2 * y * y) + 2 * p[P2] * x * y + r2 * (p[S3] + r2 * p[S4]);
    }

    /** Derivative of xd by x, of which the tangential part is {@code 2 p1 y + 6 p2 x}. */
    private static double xByX(double[] p, double x, double y, double r2, double q, double byR2) {
        return q + 2 * x * x * byR2 + 2 * p[P1] * y + 6 * p[P2] * x + 2 * x * (p[S1] + 2 * r2 * p[S2]);
    }

    private static double xByY(double[] p, double x, double y, double r2, double byR2) {
        return 2 * x * y * byR2 + 2 * p[P1] * x + 2 * p[P2] * y + 2 * y * (p[S1] + 2 * r2 * p[S2]);
    }

    private static double yByX(double[] p, double x, double y, double r2, double byR2) {
        return 2 * x * y * byR2 + 2 * p[P1] * x + 2 * p[P2] * y + 2 * x * (p[S3] + 2 * r2 * p[S4]);
    }

    private static double yByY(double[] p, double x, double y, double r2, double q, double byR2) {
        return q + 2 * y * y * byR2 + 6 * p[P1] * y + 2 * p[P2] * x + 2 * y * (p[S3] + 2 * r2 * p[S4]);
    }

    @Override
    public boolean project(double[] p, double x, double y, double z, double[] uv, int offset) {
        if (!(z > 0)) {
            return false;
        }
        double xn = x / z;
        double yn = y / z;
        double r2 = xn * xn + yn * yn;
        double q = quotient(p, r2);
        double xd = distortedX(p, xn, yn, r2, q);
        double yd = distortedY(p, xn, yn, r2, q);
        if (denominator(p, r2) <= 0) {
            return false;
        }
        uv[offset] = p[FX] * xd + p[SKEW] * yd + p[CX];
        uv[offset + 1] = p[FY] * yd + p[CY];
        return true;
    }

    @Override
    public boolean projectWithDerivatives(double[] p, double x, double y, double z, double[] uv, double[] byPoint,
            double @Nullable [] byParameters) {
        if (!(z > 0)) {
            return false;
        }
        double inverseZ = 1 / z;
        double xn = x * inverseZ;
        double yn = y * inverseZ;
        double r2 = xn * xn + yn * yn;
        double denominator = denominator(p, r2);
        if (denominator <= 0) {
            return false;
        }
        double q = quotient(p, r2);
        double byR2 = quotientByR2(p, r2);
        double xd = distortedX(p, xn, yn, r2, q);
        double yd = distortedY(p, xn, yn, r2, q);
        double fx = p[FX];
        double fy = p[FY];
        double skew = p[SKEW];
        uv[0] = fx * xd + skew * yd + p[CX];
        uv[1] = fy * yd + p[CY];

        double ydByX = yByX(p, xn, yn, r2, byR2);
        double ydByY = yByY(p, xn, yn, r2, q, byR2);
        double uByX = fx * xByX(p, xn, yn, r2, q, byR2) + skew * ydByX;
        double uByY = fx * xByY(p, xn, yn, r2, byR2) + skew * ydByY;
        byPoint[0] = uByX * inverseZ;
        byPoint[1] = uByY * inverseZ;
        byPoint[2] = -(uByX * xn + uByY * yn) * inverseZ;
        byPoint[3] = fy * ydByX * inverseZ;
        byPoint[4] = fy * ydByY * inverseZ;
        byPoint[5] = -fy * (ydByX * xn + ydByY * yn) * inverseZ;

        if (byParameters != null) {
            set(byParameters, FX, xd, 0);
            set(byParameters, FY, 0, yd);
            set(byParameters, CX, 1, 0);
            set(byParameters, CY, 0, 1);
            set(byParameters, SKEW, yd, 0);
            double power = r2 / denominator;
            for (int i = 0; i < 3; i++) {
                setDistortion(p, byParameters, K1 + i, xn * power, yn * power);
                setDistortion(p, byParameters, K4 + i, -q * xn * power, -q * yn * power);
                power *= r2;
            }
            setDistortion(p, byParameters, P1, 2 * xn * yn, r2 + 2 * yn * yn);
            setDistortion(p, byParameters, P2, r2 + 2 * xn * xn, 2 * xn * yn);
            setDistortion(p, byParameters, S1, r2, 0);
            setDistortion(p, byParameters, S2, r2 * r2, 0);
            setDistortion(p, byParameters, S3, 0, r2);
            setDistortion(p, byParameters, S4, 0, r2 * r2);
        }
        return true;
    }

    private static void set(double[] byParameters, int index, double u, double v) {
        byParameters[index] = u;
        byParameters[PARAMETERS + index] = v;
    }

    private static void setDistortion(double[] p, double[] byParameters, int index, double xd, double yd) {
        set(byParameters, index, p[FX] * xd + p[SKEW] * yd, p[FY] * yd);
    }

    @Override
    public boolean toRay(double[] p, double u, double v, double[] ray) {
        double yd = (v - p[CY]) / p[FY];
        double xd = (u - p[CX] - p[SKEW] * yd) / p[FX];
        double x = 0;
        double y = 0;
        double stepX = xd;
        double stepY = yd;
        // from the image of the optical axis outwards, as in BrownLens
        for (int step = 0; step < NEWTON_STEPS; step++) {
            double length = 1;
            while (!upright(p, x + length * stepX, y + length * stepY)) {
                length /= 2;
                if (length < SHORTEST_NEWTON_STEP) {
                    return false;
                }
            }
            x += length * stepX;
            y += length * stepY;
            if (length == 1 && Math.abs(stepX) + Math.abs(stepY) < NEWTON_TOLERANCE * (1 + Math.abs(x) + Math.abs(y))) {
                if (!uprightUpTo(p, x, y)) {
                    return false;
                }
                ray[0] = x;
                ray[1] = y;
                ray[2] = 1;
                return true;
            }
            double r2 = x * x + y * y;
            double q = quotient(p, r2);
            double byR2 = quotientByR2(p, r2);
            double errorX = distortedX(p, x, y, r2, q) - xd;
            double errorY = distortedY(p, x, y, r2, q) - yd;
            double a = xByX(p, x, y, r2, q, byR2);
            double b = xByY(p, x, y, r2, byR2);
            double c = yByX(p, x, y, r2, byR2);
            double d = yByY(p, x, y, r2, q, byR2);
            double determinant = a * d - b * c;
            stepX = (b * errorY - d * errorX) / determinant;
            stepY = (c * errorX - a * errorY) / determinant;
        }
        return false;
    }

    /**
     * Whether the lens map neither folds nor turns over at a normalised point, and the point is before any pole of the
     * quotient. False for NaN.
     */
    private static boolean upright(double[] p, double x, double y) {
        double r2 = x * x + y * y;
        double q = quotient(p, r2);
        double byR2 = quotientByR2(p, r2);
        double a = xByX(p, x, y, r2, q, byR2);
        return denominator(p, r2) > 0 && a > 0
                && a * yByY(p, x, y, r2, q, byR2) - xByY(p, x, y, r2, byR2) * yByX(p, x, y, r2, byR2) > 0;
    }

    /** Whether no fold lies between the optical axis and a point: beyond one, a pixel has another, nearer source. */
    private static boolean uprightUpTo(double[] p, double x, double y) {
        double r2 = x * x + y * y;
        double numerator = r2 * (Math.abs(p[K1]) + r2 * (Math.abs(p[K2]) + r2 * Math.abs(p[K3])));
        double denominator = r2 * (Math.abs(p[K4]) + r2 * (Math.abs(p[K5]) + r2 * Math.abs(p[K6])));
        // a bound of how far the derivative is from the identity; it grows with the radius, and so holds all the way
        double quotient = (numerator + denominator) / (1 - denominator);
        double byR2 = (3 * numerator + 3 * denominator * (1 + quotient)) / (1 - denominator);
        double rest = 8 * Math.sqrt(r2) * (Math.abs(p[P1]) + Math.abs(p[P2]))
                + 2 * Math.sqrt(r2) * (Math.abs(p[S1]) + Math.abs(p[S3])
                        + 2 * r2 * (Math.abs(p[S2]) + Math.abs(p[S4])));
        if (denominator < 1 && quotient + 2 * byR2 + rest < 1) {
            return true;
        }
        for (int i = 1; i < FOLD_CHECKS; i++) {
            if (!upright(p, x * i / FOLD_CHECKS, y * i / FOLD_CHECKS)) {
                return false;
            }
        }
        return true;
    }
}
