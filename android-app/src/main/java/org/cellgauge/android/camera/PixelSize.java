package org.cellgauge.android.camera;

/** Size of an image in pixels; immutable. */
final class PixelSize {
    private final int widthPx;
    private final int heightPx;

    /**
     * A size.
     *
     * @param widthPx at least 1
     * @param heightPx at least 1
     */
    PixelSize(int widthPx, int heightPx) {
        if (widthPx < 1 || heightPx < 1) {
            throw new IllegalArgumentException("image size must be positive: " + widthPx + " x " + heightPx);
        }
        this.widthPx = widthPx;
        this.heightPx = heightPx;
    }

    int widthPx() {
        return widthPx;
    }

    int heightPx() {
        return heightPx;
    }

    /** Number of pixels. */
    long area() {
        return (long) widthPx * heightPx;
    }

    /**
     * Whether this is the other size scaled: the same ratio of width to height but for the rounding of a height and a
     * width to whole pixels, as between 1366 x 768 and 1280 x 720.
     */
    boolean sameShapeAs(PixelSize other) {
        long difference = Math.abs((long) widthPx * other.heightPx - (long) heightPx * other.widthPx);
        return difference <= Math.max(Math.max(widthPx, other.widthPx), Math.max(heightPx, other.heightPx)) / 2;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof PixelSize && ((PixelSize) other).widthPx == widthPx
                && ((PixelSize) other).heightPx == heightPx;
    }

    @Override
    public int hashCode() {
        return 31 * widthPx + heightPx;
    }

    @Override
    public String toString() {
        return widthPx + " x " + heightPx;
    }
}
