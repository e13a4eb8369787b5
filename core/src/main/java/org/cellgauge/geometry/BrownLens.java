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
 * Radial and tangential (Brown-Conrady) distortion of a pinhole camera, for fields of view up to some 120 degrees.
 *
 * <p>The model is BoofCV's {@code pinhole_radial_tangential}: with the undistorted normalised point
 * {@code (x, y) = (X/Z, Y/Z)} and {@code r² = x² + y²}
 * <pre>
 * xd = x (1 + k1 r² + k2 r⁴ + k3 r⁶) + 2 p1 x y + p2 (r² + 2 x²)
 * yd = y (1 + k1 r² + k2 r⁴ + k3 r⁶) + p1 (r² + 2 y²) + 2 p2 x y
 * </pre>
 * (D. C. Brown, "Decentering distortion of lenses", 1966; BoofCV calls p1, p2 t1, t2).
 */
public final class BrownLens implements Lens {
    /** The model. */
    public static final BrownLens MODEL = new BrownLens();

    /** Index of the first radial coefficient. */
    public static final int K1 = 5;
    /** Index of the second radial coefficient. */
    public static final int K2 = 6;
    /** Index of the third radial coefficient. */
    public static final int K3 = 7;
    /** Index of the first tangential coefficient. */
    public static final int P1 = 8;
    /** Index of the second tangential coefficient. */
    public static final int P2 = 9;
    /** Number of parameters. */
    public static final int PARAMETERS = 10;

    private static final List<String> NAMES = Collections.unmodifiableList(Arrays.asList("fx_px", "fy_px", "cx_px",
            "cy_px", "skew_px", "k1", "k2", "k3", "p1", "p2"));
    private static final int NEWTON_STEPS = 30;
    private static final double NEWTON_TOLERANCE = 1e-12;
    private static final double SHORTEST_NEWTON_STEP = 1e-3;
    /** Points of the ray at which a lens of strong distortion is looked at for a fold. */
    private static final int FOLD_CHECKS = 64;
    private static final double FOLD_SCAN_STEP = 1e-3;
    /** 87 degrees off the axis; nothing such a camera sees lies beyond. */
    private static final double LARGEST_RADIUS = 20;

    private BrownLens() {
    }

    @Override
    public String modelName() {
        return "pinhole_radial_tangential";
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
    public boolean isDistorting(double[] intrinsics) {
        return intrinsics[K1] != 0 || intrinsics[K2] != 0 || intrinsics[K3] != 0 || intrinsics[P1] != 0
                || intrinsics[P2] != 0;
    }

    @Override
    public boolean isWide() {
        return false;
    }

    /** Where the radial polynomial r (1 + k1 r² + k2 r⁴ + k3 r⁶) stops growing, at most 87 degrees. */
    @Override
    public double reachRad(double[] intrinsics) {
        double k1 = intrinsics[K1];
        double k2 = intrinsics[K2];
        double k3 = intrinsics[K3];
        if (k1 == 0 && k2 == 0 && k3 == 0) {
            return Math.atan(LARGEST_RADIUS);
        }
        for (double r = FOLD_SCAN_STEP; r < LARGEST_RADIUS; r += FOLD_SCAN_STEP) {
            double s = r * r;
            if (1 + s * (3 * k1 + s * (5 * k2 + s * 7 * k3)) <= 0) {
                return Math.atan(Math.max(r - FOLD_SCAN_STEP, FOLD_SCAN_STEP / 2));
            }
        }
        return Math.atan(LARGEST_RADIUS);
    }

    @Override
    public boolean project(double[] intrinsics, double x, double y, double z, double[] uv, int offset) {
        if (!(z > 0)) {
            return false;
        }
        double xn = x / z;
        double yn = y / z;
        double r2 = xn * xn + yn * yn;
        double radial = 1 + r2 * (intrinsics[K1] + r2 * (intrinsics[K2] + r2 * intrinsics[K3]));
        double p1 = intrinsics[P1];
        double p2 = intrinsics[P2];
        double xy2 = 2 * xn * yn;
        double xd = xn * radial + p1 * xy2 + p2 * (r2 + 2 * xn * xn);
        double yd = yn * radial + p1 * (r2 + 2 * yn * yn) + p2 * xy2;
        uv[offset] = intrinsics[FX] * xd + intrinsics[SKEW] * yd + intrinsics[CX];
        uv[offset + 1] = intrinsics[FY] * yd + intrinsics[CY];
        return true;
    }

    @Override
    public boolean projectWithDerivatives(double[] intrinsics, double x, double y, double z, double[] uv,
            double[] byPoint, double @Nullable [] byParameters) {
        if (!(z > 0)) {
            return false;
        }
        double inverseZ = 1 / z;
        double xn = x * inverseZ;
        double yn = y * inverseZ;
        double r2 = xn * xn + yn * yn;
        double k1 = intrinsics[K1];
        double k2 = intrinsics[K2];
        double k3 = intrinsics[K3];
        double p1 = intrinsics[P1];
        double p2 = intrinsics[P2];
        double fx = intrinsics[FX];
        double fy = intrinsics[FY];
        double skew = intrinsics[SKEW];
        double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
        double radialByR2 = k1 + r2 * (2 * k2 + r2 * 3 * k3);
        double xy2 = 2 * xn * yn;
        double xd = xn * radial + p1 * xy2 + p2 * (r2 + 2 * xn * xn);
        double yd = yn * radial + p1 * (r2 + 2 * yn * yn) + p2 * xy2;
        uv[0] = fx * xd + skew * yd + intrinsics[CX];
        uv[1] = fy * yd + intrinsics[CY];

        double xdByX = radial + 2 * xn * xn * radialByR2 + 2 * p1 * yn + 6 * p2 * xn;
        double xdByY = xy2 * radialByR2 + 2 * p1 * xn + 2 * p2 * yn;
        double ydByX = xdByY;
        double ydByY = radial + 2 * yn * yn * radialByR2 + 6 * p1 * yn + 2 * p2 * xn;
        double uByX = fx * xdByX + skew * ydByX;
        double uByY = fx * xdByY + skew * ydByY;
        double vByX = fy * ydByX;
        double vByY = fy * ydByY;
        byPoint[0] = uByX * inverseZ;
        byPoint[1] = uByY * inverseZ;
        byPoint[2] = -(uByX * xn + uByY * yn) * inverseZ;
        byPoint[3] = vByX * inverseZ;
        byPoint[4] = vByY * inverseZ;
        byPoint[5] = -(vByX * xn + vByY * yn) * inverseZ;

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
            setDistortion(byParameters, K1, xn * r2, yn * r2, fx, fy, skew);
            setDistortion(byParameters, K2, xn * r2 * r2, yn * r2 * r2, fx, fy, skew);
            setDistortion(byParameters, K3, xn * r2 * r2 * r2, yn * r2 * r2 * r2, fx, fy, skew);
            setDistortion(byParameters, P1, xy2, r2 + 2 * yn * yn, fx, fy, skew);
            setDistortion(byParameters, P2, r2 + 2 * xn * xn, xy2, fx, fy, skew);
        }
        return true;
    }

    private static void setDistortion(double[] byParameters, int index, double xd, double yd, double fx, double fy,
            double skew) {
        byParameters[index] = fx * xd + skew * yd;
        byParameters[PARAMETERS + index] = fy * yd;
    }

    @Override
    public boolean toRay(double[] intrinsics, double u, double v, double[] ray) {
        double yd = (v - intrinsics[CY]) / intrinsics[FY];
        double xd = (u - intrinsics[CX] - intrinsics[SKEW] * yd) / intrinsics[FX];
        double k1 = intrinsics[K1];
        double k2 = intrinsics[K2];
        double k3 = intrinsics[K3];
        double p1 = intrinsics[P1];
        double p2 = intrinsics[P2];
        double x = 0;
        double y = 0;
        double stepX = xd;
        double stepY = yd;
        // from the image of the optical axis outwards: a start at the distorted point may itself lie beyond the fold
        for (int step = 0; step < NEWTON_STEPS; step++) {
            double length = 1;
            while (!upright(intrinsics, x + length * stepX, y + length * stepY)) {
                length /= 2;
                if (length < SHORTEST_NEWTON_STEP) {
                    return false;
                }
            }
            x += length * stepX;
            y += length * stepY;
            if (length == 1 && Math.abs(stepX) + Math.abs(stepY) < NEWTON_TOLERANCE) {
                if (!uprightUpTo(intrinsics, x, y)) {
                    return false;
                }
                ray[0] = x;
                ray[1] = y;
                ray[2] = 1;
                return true;
            }
            double r2 = x * x + y * y;
            double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
            double radialByR2 = k1 + r2 * (2 * k2 + r2 * 3 * k3);
            double errorX = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x) - xd;
            double errorY = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y - yd;
            double a = radial + 2 * x * x * radialByR2 + 2 * p1 * y + 6 * p2 * x;
            double b = 2 * x * y * radialByR2 + 2 * p1 * x + 2 * p2 * y;
            double d = radial + 2 * y * y * radialByR2 + 6 * p1 * y + 2 * p2 * x;
            double determinant = a * d - b * b;
            stepX = (b * errorY - d * errorX) / determinant;
            stepY = (b * errorX - a * errorY) / determinant;
        }
        return false;
    }

    /**
     * Whether the lens map neither folds nor turns over at a normalised point: its derivative, which is symmetric, is
     * positive definite. False for NaN.
     */
    private static boolean upright(double[] intrinsics, double x, double y) {
        double k1 = intrinsics[K1];
        double k2 = intrinsics[K2];
        double k3 = intrinsics[K3];
        double p1 = intrinsics[P1];
        double p2 = intrinsics[P2];
        double r2 = x * x + y * y;
        double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
        double radialByR2 = k1 + r2 * (2 * k2 + r2 * 3 * k3);
        double a = radial + 2 * x * x * radialByR2 + 2 * p1 * y + 6 * p2 * x;
        double b = 2 * x * y * radialByR2 + 2 * p1 * x + 2 * p2 * y;
        double d = radial + 2 * y * y * radialByR2 + 6 * p1 * y + 2 * p2 * x;
        return a > 0 && a * d - b * b > 0;
    }

    /** Whether no fold lies between the optical axis and a point: beyond one, a pixel has another, nearer source. */
    private static boolean uprightUpTo(double[] intrinsics, double x, double y) {
        double r2 = x * x + y * y;
        double bound = r2 * (3 * Math.abs(intrinsics[K1]) + r2 * (5 * Math.abs(intrinsics[K2])
                + r2 * 7 * Math.abs(intrinsics[K3])))
                + 8 * Math.sqrt(r2) * (Math.abs(intrinsics[P1]) + Math.abs(intrinsics[P2]));
        if (bound < 1) {
            return true;
        }
        for (int i = 1; i < FOLD_CHECKS; i++) {
            if (!upright(intrinsics, x * i / FOLD_CHECKS, y * i / FOLD_CHECKS)) {
                return false;
            }
        }
        return true;
    }
}
