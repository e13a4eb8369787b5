package org.cellgauge.vision;

import org.cellgauge.light.ToneCurve;
import org.jspecify.annotations.Nullable;

/**
 * A grey image as the detector reads it: one byte of luminance per pixel in an array that may be somebody else's.
 *
 * <p>The array is wrapped, never copied, and rows may be further apart than they are wide, so that the luminance plane
 * of a camera frame goes in as it is. The image is a view: whoever owns the array must leave it alone while the image
 * is in use. Values are unsigned, 0 black to 255 white; pixel (x, y) covers [x, x+1) by [y, y+1), y downwards.
 */
public final class GreyImage {
    private final byte[] luminance;
    private final int offset;
    private final int rowStride;
    private final int widthPx;
    private final int heightPx;
    private final @Nullable ToneCurve toneCurve;

    private GreyImage(byte[] luminance, int offset, int rowStride, int widthPx, int heightPx,
            @Nullable ToneCurve toneCurve) {
        this.luminance = luminance;
        this.offset = offset;
        this.rowStride = rowStride;
        this.widthPx = widthPx;
        this.heightPx = heightPx;
        this.toneCurve = toneCurve;
    }

    /**
     * An image over part of an array, without copying.
     *
     * @param luminance unsigned bytes; kept, not copied
     * @param offset index of pixel (0, 0), at least 0
     * @param rowStride indices from one row to the next, at least the width
     * @param widthPx image width, at least 1
     * @param heightPx image height, at least 1
     * @return the view
     * @throws IllegalArgumentException if a size is not positive, the stride is below the width or the array too short
     */
    public static GreyImage wrap(byte[] luminance, int offset, int rowStride, int widthPx, int heightPx) {
        if (widthPx < 1 || heightPx < 1) {
            throw new IllegalArgumentException("image size must be positive: " + widthPx + " x " + heightPx);
        }
        if (offset < 0 || rowStride < widthPx) {
            throw new IllegalArgumentException("offset " + offset + " or row stride " + rowStride
                    + " does not fit a width of " + widthPx);
        }
        // the last row ends where its pixels end: planes of cameras often stop short of a full stride there
        long end = offset + (long) rowStride * (heightPx - 1) + widthPx;
        if (end > luminance.length) {
            throw new IllegalArgumentException(widthPx + " x " + heightPx + " px with row stride " + rowStride
                    + " take " + end + " bytes, the array has " + luminance.length);
        }
        return new GreyImage(luminance, offset, rowStride, widthPx, heightPx, null);
    }

    /**
     * An image over an array that holds its rows one after the other, without copying.
     *
     * @param luminance unsigned bytes, at least width times height; kept, not copied
     * @param widthPx image width, at least 1
     * @param heightPx image height, at least 1
     * @return the view
     * @throws IllegalArgumentException as {@link #wrap}
     */
    public static GreyImage packed(byte[] luminance, int widthPx, int heightPx) {
        return wrap(luminance, 0, widthPx, widthPx, heightPx);
    }

    /**
     * The same image with what its file or its camera says of its tone curve.
     *
     * @param stated how grey values were made of light; null: nothing is said
     * @return a view of the same array
     */
    public GreyImage withToneCurve(@Nullable ToneCurve stated) {
        return new GreyImage(luminance, offset, rowStride, widthPx, heightPx, stated);
    }

    /**
     * What the image's file or its camera says of its tone curve: where an estimate starts, not more, since files often
     * say sRGB of whatever curve the camera has.
     *
     * @return how grey values were made of light; null where nothing is said
     */
    public @Nullable ToneCurve toneCurve() {
        return toneCurve;
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
     * The array behind the image.
     *
     * @return the array itself, not a copy
     */
    public byte[] luminance() {
        return luminance;
    }

    /**
     * Index of pixel (0, 0).
     *
     * @return index into {@link #luminance()}
     */
    public int offset() {
        return offset;
    }

    /**
     * Indices from one row to the next.
     *
     * @return at least the width
     */
    public int rowStride() {
        return rowStride;
    }

    /**
     * One pixel.
     *
     * @param x column, 0 to width - 1; not checked
     * @param y row, 0 to height - 1; not checked
     * @return 0 to 255
     */
    public int get(int x, int y) {
        return luminance[offset + y * rowStride + x] & 0xFF;
    }

    /**
     * Grey value between pixel centres, bilinear; beyond the outermost centres the image goes on as at its edge.
     *
     * @param u pixel x, centres at +0.5
     * @param v pixel y, centres at +0.5
     * @return 0 to 255
     */
    public double interpolate(double u, double v) {
        double x = Math.min(Math.max(u - 0.5, 0), widthPx - 1.0);
        double y = Math.min(Math.max(v - 0.5, 0), heightPx - 1.0);
        int x0 = (int) x;
        int y0 = (int) y;
        int x1 = Math.min(x0 + 1, widthPx - 1);
        int y1 = Math.min(y0 + 1, heightPx - 1);
        double top = get(x0, y0) + (x - x0) * (get(x1, y0) - get(x0, y0));
        double bottom = get(x0, y1) + (x - x0) * (get(x1, y1) - get(x0, y1));
        return top + (y - y0) * (bottom - top);
    }

    /** Whether a place has pixel centres on all sides. */
    boolean hasNeighbours(double u, double v) {
        return u >= 0.5 && v >= 0.5 && u < widthPx - 0.5 && v < heightPx - 0.5;
    }

    /** As {@link #interpolate} where {@link #hasNeighbours} holds, without asking where the image ends. */
    double interpolateInside(double u, double v) {
        double x = u - 0.5;
        double y = v - 0.5;
        int x0 = (int) x;
        int y0 = (int) y;
        int at = offset + y0 * rowStride + x0;
        int first = luminance[at] & 0xFF;
        int third = luminance[at + rowStride] & 0xFF;
        double top = first + (x - x0) * ((luminance[at + 1] & 0xFF) - first);
        double bottom = third + (x - x0) * ((luminance[at + rowStride + 1] & 0xFF) - third);
        return top + (y - y0) * (bottom - top);
    }
}
