package org.cellgauge.geometry;

import static org.cellgauge.geometry.PinholeCamera.CX;
import static org.cellgauge.geometry.PinholeCamera.CY;
import static org.cellgauge.geometry.PinholeCamera.FX;
import static org.cellgauge.geometry.PinholeCamera.FY;
import static org.cellgauge.geometry.PinholeCamera.INTRINSICS;
import static org.cellgauge.geometry.PinholeCamera.K1;
import static org.cellgauge.geometry.PinholeCamera.K2;
import static org.cellgauge.geometry.PinholeCamera.K3;
import static org.cellgauge.geometry.PinholeCamera.P1;
import static org.cellgauge.geometry.PinholeCamera.P2;
import static org.cellgauge.geometry.PinholeCamera.SKEW;

/**
 * The projection of {@link PinholeCamera} over plain arrays, with its derivatives. Nothing here allocates: the inner
 * loops of the posterior stand on it.
 */
public final class Projection {
    private static final int NEWTON_STEPS = 30;
    private static final double NEWTON_TOLERANCE = 1e-12;
    private static final double SHORTEST_NEWTON_STEP = 1e-3;
    /** Points of the ray at which a lens of strong distortion is looked at for a fold. */
    private static final int FOLD_CHECKS = 64;

    private Projection() {
    }

    /**
     * Projects a point of the camera frame.
     *
     * @param intrinsics {@value PinholeCamera#INTRINSICS} values in the order of {@link PinholeCamera}
     * @param x x in the camera frame, mm
     * @param y y in the camera frame, mm
     * @param z z in the camera frame, mm
     * @param uv receives u and v, px, from {@code offset} on
     * @param offset index of u in {@code uv}
     * @return false, with {@code uv} untouched, if the point is not in front of the camera (z not positive or NaN)
     */
    public static boolean project(double[] intrinsics, double x, double y, double z, double[] uv, int offset) {
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

    /**
     * Projects a point of the camera frame and gives the derivatives of its image.
     *
     * @param intrinsics {@value PinholeCamera#INTRINSICS} values
     * @param x x in the camera frame, mm
     * @param y y in the camera frame, mm
     * @param z z in the camera frame, mm
     * @param uv receives u and v, px
     * @param byPoint receives the 2x3 derivative by (x, y, z) row by row, px/mm
     * @param byIntrinsics receives the 2x{@value PinholeCamera#INTRINSICS} derivative by the intrinsics row by row, or
     *     null where it is not wanted
     * @return false, with all outputs untouched, if the point is not in front of the camera
     */
    public static boolean projectWithDerivatives(double[] intrinsics, double x, double y, double z, double[] uv,
            double[] byPoint, double[] byIntrinsics) {
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

        if (byIntrinsics != null) {
            int v = INTRINSICS;
            byIntrinsics[FX] = xd;
            byIntrinsics[FY] = 0;
            byIntrinsics[CX] = 1;
            byIntrinsics[CY] = 0;
            byIntrinsics[SKEW] = yd;
            byIntrinsics[v + FX] = 0;
            byIntrinsics[v + FY] = yd;
            byIntrinsics[v + CX] = 0;
            byIntrinsics[v + CY] = 1;
            byIntrinsics[v + SKEW] = 0;
            setDistortion(byIntrinsics, K1, xn * r2, yn * r2, fx, fy, skew);
            setDistortion(byIntrinsics, K2, xn * r2 * r2, yn * r2 * r2, fx, fy, skew);
            setDistortion(byIntrinsics, K3, xn * r2 * r2 * r2, yn * r2 * r2 * r2, fx, fy, skew);
            setDistortion(byIntrinsics, P1, xy2, r2 + 2 * yn * yn, fx, fy, skew);
            setDistortion(byIntrinsics, P2, r2 + 2 * xn * xn, xy2, fx, fy, skew);
        }
        return true;
    }

    private static void setDistortion(double[] byIntrinsics, int index, double xd, double yd, double fx, double fy,
            double skew) {
        byIntrinsics[index] = fx * xd + skew * yd;
        byIntrinsics[INTRINSICS + index] = fy * yd;
    }

    /**
     * Inverse of the lens model; see {@link PinholeCamera#toNormalised}.
     *
     * @param intrinsics {@value PinholeCamera#INTRINSICS} values
     * @param u pixel x
     * @param v pixel y
     * @param out x/z and y/z, 2 values
     * @return whether it converged
     */
    public static boolean toNormalised(double[] intrinsics, double u, double v, double[] out) {
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
                out[0] = x;
                out[1] = y;
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
