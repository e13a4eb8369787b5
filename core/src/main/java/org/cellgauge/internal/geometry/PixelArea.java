package org.cellgauge.internal.geometry;

/** A part of an image or sensor in its pixels; pixel (i, j) covers [i, i + 1) x [j, j + 1). Immutable. */
public final class PixelArea {
    private final double leftPx;
    private final double topPx;
    private final double widthPx;
    private final double heightPx;

    /**
     * An area.
     *
     * @param leftPx left edge
     * @param topPx upper edge
     * @param widthPx width, positive
     * @param heightPx height, positive
     * @throws IllegalArgumentException if a value is not finite or a size not positive
     */
    public PixelArea(double leftPx, double topPx, double widthPx, double heightPx) {
        if (!Double.isFinite(leftPx) || !Double.isFinite(topPx) || !(widthPx > 0) || !(heightPx > 0)
                || Double.isInfinite(widthPx) || Double.isInfinite(heightPx)) {
            throw new IllegalArgumentException("not an area: " + widthPx + " x " + heightPx + " at (" + leftPx + ", "
                    + topPx + ")");
        }
        this.leftPx = leftPx;
        this.topPx = topPx;
        this.widthPx = widthPx;
        this.heightPx = heightPx;
    }

    /**
     * The largest part of a shape in the middle of this area.
     *
     * @param width of the shape, in any unit, positive
     * @param height of the shape, in the same unit
     * @return the part with that ratio of width to height
     */
    public PixelArea centreCrop(double width, double height) {
        double scale = Math.min(widthPx / width, heightPx / height);
        double w = scale * width;
        double h = scale * height;
        return new PixelArea(leftPx + (widthPx - w) / 2, topPx + (heightPx - h) / 2, w, h);
    }

    /**
     * Left edge.
     *
     * @return px
     */
    public double leftPx() {
        return leftPx;
    }

    /**
     * Upper edge.
     *
     * @return px
     */
    public double topPx() {
        return topPx;
    }

    /**
     * Width.
     *
     * @return px, positive
     */
    public double widthPx() {
        return widthPx;
    }

    /**
     * Height.
     *
     * @return px, positive
     */
    public double heightPx() {
        return heightPx;
    }

    @Override
    public String toString() {
        return widthPx + " x " + heightPx + " px at (" + leftPx + ", " + topPx + ")";
    }
}
