package org.cellgauge.geometry;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * A camera: a lens with the values of its parameters, and the size of its image; immutable.
 *
 * <p>The lens is a {@link BrownLens}, a pinhole with radial and tangential distortion or none, unless another is named.
 * Whatever the lens, the first five values are fx, fy, cx, cy and skew. Pixel centres are at +0.5.
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
    /** Two vectors along one direction differ by less, in units of their length. */
    private static final double SAME_RAY = 2e-6;

    private final Lens lens;
    private final int widthPx;
    private final int heightPx;
    private final double[] intrinsics;

    private PinholeCamera(Lens lens, int widthPx, int heightPx, double[] intrinsics) {
        this.lens = lens;
        this.widthPx = widthPx;
        this.heightPx = heightPx;
        this.intrinsics = intrinsics;
    }

    /**
     * A camera with a {@link BrownLens}.
     *
     * @param widthPx image width, at least 1
     * @param heightPx image height, at least 1
     * @param intrinsics {@value BrownLens#PARAMETERS} values in the order of the index constants; copied
     * @return the camera
     * @throws IllegalArgumentException if a value is not finite, a focal length not positive or the size not positive
     */
    public static PinholeCamera of(int widthPx, int heightPx, double[] intrinsics) {
        return of(BrownLens.MODEL, widthPx, heightPx, intrinsics);
    }

    /**
     * A camera with any lens.
     *
     * @param lens its model
     * @param widthPx image width, at least 1
     * @param heightPx image height, at least 1
     * @param intrinsics values of the lens's parameters; copied
     * @return the camera
     * @throws IllegalArgumentException if there are more or fewer values than parameters, one is not finite, a focal
     *     length not positive or the size not positive
     */
    public static PinholeCamera of(Lens lens, int widthPx, int heightPx, double[] intrinsics) {
        if (intrinsics.length != lens.parameterCount()) {
            throw new IllegalArgumentException("intrinsics take " + lens.parameterCount() + " values, not "
                    + intrinsics.length);
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
        return new PinholeCamera(lens, widthPx, heightPx, intrinsics.clone());
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
        double[] values = new double[BrownLens.PARAMETERS];
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
        return withIntrinsics(values);
    }

    /**
     * The same camera with other values of its lens's parameters.
     *
     * @param values as in {@link #intrinsics()}; copied
     * @return a new camera
     * @throws IllegalArgumentException as {@link #of(Lens, int, int, double[])}
     */
    public PinholeCamera withIntrinsics(double[] values) {
        return of(lens, widthPx, heightPx, values);
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
        return of(lens, newWidthPx, newHeightPx, values);
    }

    /**
     * Whether images of a size can be all of this camera's image, binned or scaled.
     *
     * @param otherWidthPx their width
     * @param otherHeightPx their height
     * @return true if width and height have exactly the same ratio
     */
    public boolean hasShape(int otherWidthPx, int otherHeightPx) {
        return (long) otherWidthPx * heightPx == (long) otherHeightPx * widthPx;
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
        return of(lens, newWidthPx, newHeightPx, values);
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
     * The model of the lens.
     *
     * @return the lens
     */
    public Lens lens() {
        return lens;
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
     * @param index one of the index constants, of this class or of the lens
     * @return the value (px for fx, fy, cx, cy, skew; no unit for the coefficients of the lens)
     */
    public double get(int index) {
        return intrinsics[index];
    }

    /**
     * All intrinsics.
     *
     * @return a copy, in the order of {@link Lens#parameterNames()}
     */
    public double[] intrinsics() {
        return intrinsics.clone();
    }

    /**
     * Whether the lens bends straight lines, {@link Lens#isDistorting}.
     *
     * @return false for an ideal pinhole
     */
    public boolean isDistorting() {
        return lens.isDistorting(intrinsics);
    }

    /**
     * Projects a point of the camera frame.
     *
     * @param x x in the camera frame, mm
     * @param y y in the camera frame, mm
     * @param z z in the camera frame, mm
     * @return u, v in px, or null if the lens cannot see the point, {@link Lens#project}
     */
    public double @Nullable [] project(double x, double y, double z) {
        double[] uv = new double[2];
        return lens.project(intrinsics, x, y, z, uv, 0) ? uv : null;
    }

    /**
     * Projects a point of the camera frame, and makes sure that it is the one seen there: beyond the radius where a
     * lens model folds over, a point has an image where the light of another one falls.
     *
     * @param x x in the camera frame, mm
     * @param y y in the camera frame, mm
     * @param z z in the camera frame, mm
     * @return u, v in px, or null if the camera cannot see the point
     */
    public double @Nullable [] image(double x, double y, double z) {
        double[] uv = new double[2];
        if (!lens.project(intrinsics, x, y, z, uv, 0)) {
            return null;
        }
        if (!lens.isDistorting(intrinsics)) {
            // what does not bend does not fold over
            return uv;
        }
        double[] ray = new double[3];
        if (!lens.toRay(intrinsics, uv[0], uv[1], ray)) {
            return null;
        }
        double scale = Math.sqrt((ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]) / (x * x + y * y + z * z));
        return Math.abs(ray[0] - scale * x) + Math.abs(ray[1] - scale * y) + Math.abs(ray[2] - scale * z) < SAME_RAY
                ? uv : null;
    }

    /**
     * The direction that a pixel position shows, {@link Lens#toRay}.
     *
     * @param u pixel x
     * @param v pixel y
     * @param ray a vector along the direction in the camera frame, 3 values
     * @return whether there is one
     */
    public boolean toRay(double u, double v, double[] ray) {
        return lens.toRay(intrinsics, u, v, ray);
    }

    /**
     * The undistorted normalised point of a pixel position: where the direction that it shows meets the plane z = 1.
     *
     * @param u pixel x
     * @param v pixel y
     * @param out x/z and y/z, 2 values
     * @return whether there is one; not beyond the radius where the lens's polynomial turns back, and not at a right
     *     angle to the axis or further off
     */
    public boolean toNormalised(double u, double v, double[] out) {
        double[] ray = new double[3];
        if (!lens.toRay(intrinsics, u, v, ray) || !(ray[2] > 0)) {
            return false;
        }
        out[0] = ray[0] / ray[2];
        out[1] = ray[1] / ray[2];
        return true;
    }

    @Override
    public String toString() {
        return widthPx + " x " + heightPx + " px, " + lens.modelName() + " " + Arrays.toString(intrinsics);
    }
}
