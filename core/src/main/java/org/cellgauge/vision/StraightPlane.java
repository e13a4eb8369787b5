package org.cellgauge.vision;

import java.util.Arrays;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.TangentPlane;
import org.jspecify.annotations.Nullable;

/**
 * The plane in which the sides of one marker are straight: the undistorted pixels of the image or, under a wide lens,
 * a plane of the marker's own ({@link TangentPlane}). Without distortion it is the image.
 *
 * <p>Not thread-safe: it keeps the places of the pixels about the marker, since bending them back takes as long as all
 * that is then done with them.
 */
final class StraightPlane {
    private static final int CORNERS = 4;
    /** About a marker, what its sides' bands reach; and the most pixels whose places are kept, of 16 bytes each. */
    private static final int CACHE_MARGIN_PX = 8;
    private static final int MOST_CACHED = 1 << 16;

    private final Lens lens;
    private final double[] intrinsics;
    /** Where the marker is looked at under a wide lens; null for others. */
    private final @Nullable TangentPlane tangent;
    private final boolean distorted;
    private final double[] ray = new double[3];
    private final double[] place = new double[2];

    // places of pixels about the marker, NaN where nobody has asked yet
    private int cachedX;
    private int cachedY;
    private int cachedWidth;
    private int cachedHeight;
    private double[] cached = new double[0];

    /**
     * For markers in images of one camera.
     *
     * @param camera the camera
     */
    StraightPlane(PinholeCamera camera) {
        this.lens = camera.lens();
        this.intrinsics = camera.intrinsics();
        this.tangent = lens.isWide() ? new TangentPlane(camera) : null;
        this.distorted = camera.isDistorting();
    }

    /**
     * Turns to another marker.
     *
     * @param cornersPx 8 values, distorted px
     * @return false where the lens does not see it
     */
    boolean aim(double[] cornersPx) {
        if (tangent != null && !tangent.aim(cornersPx)) {
            return false;
        }
        if (distorted) {
            clearCache(cornersPx);
        }
        return true;
    }

    /** Whether the image is another plane than this one. */
    boolean isDistorted() {
        return distorted;
    }

    /**
     * From the image to this plane.
     *
     * @param u distorted px
     * @param v distorted px
     * @param out receives x and y
     * @param at where
     * @return false where the lens sees nothing
     */
    boolean toPlane(double u, double v, double[] out, int at) {
        if (!distorted) {
            out[at] = u;
            out[at + 1] = v;
            return true;
        }
        if (tangent != null) {
            return tangent.toPlane(u, v, out, at);
        }
        if (!lens.toRay(intrinsics, u, v, ray)) {
            return false;
        }
        out[at] = intrinsics[PinholeCamera.FX] * ray[0] + intrinsics[PinholeCamera.SKEW] * ray[1]
                + intrinsics[PinholeCamera.CX];
        out[at + 1] = intrinsics[PinholeCamera.FY] * ray[1] + intrinsics[PinholeCamera.CY];
        return true;
    }

    /**
     * The same for the centre of a pixel.
     *
     * @param x column
     * @param y row
     * @param out receives x and y in its first two places
     * @return false where the lens sees nothing
     */
    boolean ofPixel(int x, int y, double[] out) {
        if (!distorted) {
            out[0] = x + 0.5;
            out[1] = y + 0.5;
            return true;
        }
        int column = x - cachedX;
        int row = y - cachedY;
        if (column < 0 || row < 0 || column >= cachedWidth || row >= cachedHeight) {
            return toPlane(x + 0.5, y + 0.5, out, 0);
        }
        int at = 2 * (row * cachedWidth + column);
        if (Double.isNaN(cached[at])) {
            if (!toPlane(x + 0.5, y + 0.5, place, 0)) {
                return false;
            }
            cached[at] = place[0];
            cached[at + 1] = place[1];
        }
        out[0] = cached[at];
        out[1] = cached[at + 1];
        return true;
    }

    /**
     * From this plane to the image.
     *
     * @param x in this plane
     * @param y in this plane
     * @param out receives distorted px
     * @param at where
     */
    void toImage(double x, double y, double[] out, int at) {
        if (!distorted) {
            out[at] = x;
            out[at + 1] = y;
            return;
        }
        if (tangent != null) {
            tangent.toImage(x, y, out, at);
            return;
        }
        double yn = (y - intrinsics[PinholeCamera.CY]) / intrinsics[PinholeCamera.FY];
        double xn = (x - intrinsics[PinholeCamera.CX] - intrinsics[PinholeCamera.SKEW] * yn)
                / intrinsics[PinholeCamera.FX];
        lens.project(intrinsics, xn, yn, 1, out, at);
    }

    /** Forgets places of pixels; those about the corners will be kept. */
    private void clearCache(double[] cornersPx) {
        double lowU = Double.POSITIVE_INFINITY;
        double highU = Double.NEGATIVE_INFINITY;
        double lowV = Double.POSITIVE_INFINITY;
        double highV = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < CORNERS; i++) {
            lowU = Math.min(lowU, cornersPx[2 * i]);
            highU = Math.max(highU, cornersPx[2 * i]);
            lowV = Math.min(lowV, cornersPx[2 * i + 1]);
            highV = Math.max(highV, cornersPx[2 * i + 1]);
        }
        cachedX = (int) lowU - CACHE_MARGIN_PX;
        cachedY = (int) lowV - CACHE_MARGIN_PX;
        cachedWidth = (int) highU + CACHE_MARGIN_PX - cachedX;
        cachedHeight = (int) highV + CACHE_MARGIN_PX - cachedY;
        if ((long) cachedWidth * cachedHeight > MOST_CACHED) {
            cachedWidth = 0;
            cachedHeight = 0;
        }
        int size = 2 * cachedWidth * cachedHeight;
        if (cached.length < size) {
            cached = new double[size];
        }
        Arrays.fill(cached, 0, size, Double.NaN);
    }
}
