package org.cellgauge.internal.overlay;

/**
 * Where an upright image lies in a view of another size: {@code x = scale u + dx}, {@code y = scale v + dy}; immutable.
 */
public final class ViewFit {
    private final double scale;
    private final double dx;
    private final double dy;

    private ViewFit(double scale, double imageWidth, double imageHeight, double viewWidth, double viewHeight) {
        this.scale = scale;
        this.dx = (viewWidth - scale * imageWidth) / 2;
        this.dy = (viewHeight - scale * imageHeight) / 2;
    }

    /**
     * The image fills the view and is cut at two opposite sides where the shapes differ.
     *
     * @param imageWidth width of the upright image, px, positive
     * @param imageHeight its height
     * @param viewWidth width of the view, in its own px, positive
     * @param viewHeight its height
     * @return the fit
     * @throws IllegalArgumentException if a size is not positive
     */
    public static ViewFit centreCrop(double imageWidth, double imageHeight, double viewWidth, double viewHeight) {
        require(imageWidth, imageHeight, viewWidth, viewHeight);
        return new ViewFit(Math.max(viewWidth / imageWidth, viewHeight / imageHeight), imageWidth, imageHeight,
                viewWidth, viewHeight);
    }

    /**
     * The whole image lies within the view, with bars at two opposite sides where the shapes differ.
     *
     * @param imageWidth width of the upright image, px, positive
     * @param imageHeight its height
     * @param viewWidth width of the view, in its own px, positive
     * @param viewHeight its height
     * @return the fit
     * @throws IllegalArgumentException if a size is not positive
     */
    public static ViewFit fit(double imageWidth, double imageHeight, double viewWidth, double viewHeight) {
        require(imageWidth, imageHeight, viewWidth, viewHeight);
        return new ViewFit(Math.min(viewWidth / imageWidth, viewHeight / imageHeight), imageWidth, imageHeight,
                viewWidth, viewHeight);
    }

    private static void require(double... sizes) {
        for (double size : sizes) {
            if (!(size > 0) || Double.isInfinite(size)) {
                throw new IllegalArgumentException("a size must be positive, not " + size);
            }
        }
    }

    /**
     * View px per image px.
     *
     * @return positive
     */
    public double scale() {
        return scale;
    }

    /**
     * x of the image's left edge in the view.
     *
     * @return view px; negative where the image is cut there
     */
    public double dx() {
        return dx;
    }

    /**
     * y of the image's upper edge in the view.
     *
     * @return view px; negative where the image is cut there
     */
    public double dy() {
        return dy;
    }

    /**
     * Where a position of the upright image lies in the view.
     *
     * @param u px
     * @param v px
     * @return x, y in view px
     */
    public double[] toView(double u, double v) {
        return new double[] {scale * u + dx, scale * v + dy};
    }

    /**
     * What position of the upright image lies at a place of the view.
     *
     * @param x view px
     * @param y view px
     * @return u, v in px, perhaps outside the image
     */
    public double[] toImage(double x, double y) {
        return new double[] {(x - dx) / scale, (y - dy) / scale};
    }
}
