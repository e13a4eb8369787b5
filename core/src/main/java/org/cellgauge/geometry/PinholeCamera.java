package org.cellgauge.geometry;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Intrinsics of a pinhole camera with radial and tangential (Brown-Conrady) distortion and its image size; immutable.
 *
 * <p>The model is BoofCV's {@code pinhole_radial_tangential}: with the undistorted normalised point
 * {@code (x, y) = (X/Z, Y/Z)} and {@code r² = x² + y²}
 * <pre>
 * xd = x (1 + k1 r² + k2 r⁴ + k3 r⁶) + 2 p1 x y + p2 (r² + 2 x²)
 * yd = y (1 + k1 r² + k2 r⁴ + k3 r⁶) + p1 (r² + 2 y²) + 2 p2 x y
 * u  = fx xd + skew yd + cx,   v = fy yd + cy
 * </pre>
 * (D. C. Brown, "Decentering distortion of lenses", 1966; BoofCV calls p1, p2 t1, t2). Pixel centres are at +0.5.
 */
public final class PinholeCamera {
    /** Index of fx (px) in an intrinsics array; also the order of derivatives by intrinsics. */
    public static final int FX = 0;
    /** Index of fy (px). */
    public static final int FY = 1;
    /** Index of cx (px). */
    public static final int CX = 2;
    /** Index of cy (px). */
    public static final int CY = 3;
    /** Index of the skew (px). */
    public static final int SKEW = 4;
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
    /** Length of an intrinsics array. */
    public static final int INTRINSICS = 10;

    private final int widthPx;
    private final int heightPx;
    private final double[] intrinsics;

    private PinholeCamera(int widthPx, int heightPx, double[] intrinsics) {
        this.widthPx = widthPx;
        this.heightPx = heightPx;
        this.intrinsics = intrinsics;
    }

    /**
     * A camera of an intrinsics array.
     *
     * @param widthPx image width, at least 1
     * @param heightPx image height, at least 1
     * @param intrinsics {@value #INTRINSICS} values in the order of the index constants; copied
     * @return the camera
     * @throws IllegalArgumentException if a value is not finite, a focal length not positive or the size not positive
     */
    public static PinholeCamera of(int widthPx, int heightPx, double[] intrinsics) {
        if (intrinsics.length != INTRINSICS) {
            throw new IllegalArgumentException("intrinsics take " + INTRINSICS + " values, not " + intrinsics.length);
        }
        for (double v : intrinsics) {
            if (!Double.isFinite(v)) {
                throw new IllegalArgumentException("intrinsics are not finite: " + Arrays.toString(intrinsics));
            }
        }
        if (intrinsics[FX] <= 0 || intrinsics[FY] <= 0) {
            throw new IllegalArgumentException("focal lengths must be positive: " + Arrays.toString(intrinsics));
        }
        if (widthPx < 1 || heightPx < 1) {
            throw new IllegalArgumentException("image size must be positive: " + widthPx + " x " + heightPx);
        }
        return new PinholeCamera(widthPx, heightPx, intrinsics.clone());
    }

    /**
     * A camera without distortion and skew.
     *
     * @param widthPx image width
     * @param heightPx image height
     * @param fxPx focal length in x
     * @param fyPx focal length in y
     * @param cxPx principal point x
     * @param cyPx principal point y
     * @return the camera
     * @throws IllegalArgumentException as {@link #of(int, int, double[])}
     */
    public static PinholeCamera ideal(int widthPx, int heightPx, double fxPx, double fyPx, double cxPx, double cyPx) {
        double[] values = new double[INTRINSICS];
        values[FX] = fxPx;
        values[FY] = fyPx;
        values[CX] = cxPx;
        values[CY] = cyPx;
        return of(widthPx, heightPx, values);
    }

    /**
     * The same camera with another focal length.
     *
     * @param fxPx focal length in x, positive
     * @param fyPx focal length in y, positive
     * @return a new camera
     */
    public PinholeCamera withFocal(double fxPx, double fyPx) {
        double[] values = intrinsics.clone();
        values[FX] = fxPx;
        values[FY] = fyPx;
        return of(widthPx, heightPx, values);
    }

    /**
     * A camera of which only the field of view is known: square pixels, principal point in the middle of the image, no
     * distortion.
     *
     * @param widthPx image width
     * @param heightPx image height
     * @param horizontalFieldOfViewRad angle between the left and the right edge of the image, between 0 and pi
     * @return the camera
     * @throws IllegalArgumentException if the angle is out of range, or as {@link #of(int, int, double[])}
     */
    public static PinholeCamera fromFieldOfView(int widthPx, int heightPx, double horizontalFieldOfViewRad) {
        double f = focalPx(widthPx, horizontalFieldOfViewRad);
        return ideal(widthPx, heightPx, f, f, widthPx / 2.0, heightPx / 2.0);
    }

    private static double focalPx(int widthPx, double horizontalFieldOfViewRad) {
        if (!(horizontalFieldOfViewRad > 0 && horizontalFieldOfViewRad < Math.PI)) {
            throw new IllegalArgumentException("a field of view lies between 0 and pi, not at "
                    + horizontalFieldOfViewRad);
        }
        return widthPx / 2.0 / Math.tan(horizontalFieldOfViewRad / 2);
    }

    /**
     * The same camera when its image is delivered in another size: the same area of the sensor, scaled. Since pixel
     * centres are at +0.5, positions scale by the ratio of the sizes and nothing is added; distortion stays, because it
     * is one of directions and not of pixels.
     *
     * @param newWidthPx width of the scaled image
     * @param newHeightPx height of the scaled image
     * @return a new camera
     * @throws IllegalArgumentException if a size is not positive
     */
    public PinholeCamera resized(int newWidthPx, int newHeightPx) {
        double x = (double) newWidthPx / widthPx;
        double y = (double) newHeightPx / heightPx;
        double[] values = intrinsics.clone();
        values[FX] *= x;
        values[CX] *= x;
        values[SKEW] *= x;
        values[FY] *= y;
        values[CY] *= y;
        return of(newWidthPx, newHeightPx, values);
    }

    /**
     * The same camera when only a part of its image is delivered.
     *
     * @param leftPx left edge of the part in this camera's image; it may lie outside
     * @param topPx upper edge of the part
     * @param newWidthPx width of the part
     * @param newHeightPx height of the part
     * @return a new camera whose image is that part
     * @throws IllegalArgumentException if a size is not positive
     */
    public PinholeCamera cropped(int leftPx, int topPx, int newWidthPx, int newHeightPx) {
        double[] values = intrinsics.clone();
        values[CX] -= leftPx;
        values[CY] -= topPx;
        return of(newWidthPx, newHeightPx, values);
    }

    /**
     * Angle between the left and the right edge of an image of this width and focal length with the principal point in
     * the middle, distortion aside.
     *
     * @return rad
     */
    public double horizontalFieldOfViewRad() {
        return 2 * Math.atan(widthPx / 2.0 / intrinsics[FX]);
    }

    /**
     * How uncertain the focal length is where the field of view is: half the difference between the focal lengths at
     * one deviation more and one less. A data sheet's angle, perhaps of another image format, is good to some 10
     * degrees.
     *
     * @param fieldOfViewStdRad standard deviation of {@link #horizontalFieldOfViewRad()}, rad, positive and small
     *     enough that the angle stays between 0 and pi
     * @return standard deviation of fx, px
     * @throws IllegalArgumentException if the deviation is out of range
     */
    public double focalStdPx(double fieldOfViewStdRad) {
        if (!(fieldOfViewStdRad > 0)) {
            throw new IllegalArgumentException("a deviation must be positive, not " + fieldOfViewStdRad);
        }
        double angle = horizontalFieldOfViewRad();
        return (focalPx(widthPx, angle - fieldOfViewStdRad) - focalPx(widthPx, angle + fieldOfViewStdRad)) / 2;
    }

    /**
     * Image width.
     *
     * @return px
     */
    public int widthPx() {
        return widthPx;
    }

    /**
     * Image height.
     *
     * @return px
     */
    public int heightPx() {
        return heightPx;
    }

    /**
     * One intrinsic value.
     *
     * @param index one of the index constants
     * @return the value (px for fx, fy, cx, cy, skew; no unit for the distortion coefficients)
     */
    public double get(int index) {
        return intrinsics[index];
    }

    /**
     * All intrinsics.
     *
     * @return a copy, {@value #INTRINSICS} values
     */
    public double[] intrinsics() {
        return intrinsics.clone();
    }

    /**
     * Whether the lens distorts at all.
     *
     * @return true if a distortion coefficient differs from 0
     */
    public boolean hasDistortion() {
        return intrinsics[K1] != 0 || intrinsics[K2] != 0 || intrinsics[K3] != 0 || intrinsics[P1] != 0
                || intrinsics[P2] != 0;
    }

    /**
     * Projects a point of the camera frame.
     *
     * @param x x in the camera frame, mm
     * @param y y in the camera frame, mm
     * @param z z in the camera frame, mm
     * @return u, v in px, or null if the point is not in front of the camera (z not positive)
     */
    public double @Nullable [] project(double x, double y, double z) {
        double[] uv = new double[2];
        return Projection.project(intrinsics, x, y, z, uv, 0) ? uv : null;
    }

    /**
     * Inverse of the lens model: the undistorted normalised point of a pixel position, by Newton's method on the
     * distortion from the optical axis outwards.
     *
     * @param u pixel x
     * @param v pixel y
     * @param out x/z and y/z, 2 values
     * @return whether it converged (to 1e-12); beyond the radius where the polynomial turns back it has no inverse
     */
    public boolean toNormalised(double u, double v, double[] out) {
        return Projection.toNormalised(intrinsics, u, v, out);
    }

    @Override
    public String toString() {
        return widthPx + " x " + heightPx + " px, " + Arrays.toString(intrinsics);
    }
}
