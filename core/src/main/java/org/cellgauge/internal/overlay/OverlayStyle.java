package org.cellgauge.internal.overlay;

/** How an overlay is shown: how its image is turned, with what panels, words and size of letters; immutable. */
public final class OverlayStyle {
    /** Over the photo as it is: with banner and legend, in English, letters in proportion to the image. */
    public static final OverlayStyle PHOTO =
            new OverlayStyle(ImageOrientation.IDENTITY, true, LabelWords.ENGLISH, LegendWords.ENGLISH, 1);

    /** Least width of the image in heights of a letter: the figures of an object then fit on one line. */
    private static final double LEAST_WIDTH_IN_CAPS = 24;
    /** Least height of the image in heights of a letter: labels of a few objects leave some of it to be seen. */
    private static final double LEAST_HEIGHT_IN_CAPS = 26;

    private final ImageOrientation orientation;
    private final boolean panels;
    private final LabelWords labels;
    private final LegendWords legend;
    private final double letterScale;

    private OverlayStyle(ImageOrientation orientation, boolean panels, LabelWords labels, LegendWords legend,
            double letterScale) {
        this.orientation = orientation;
        this.panels = panels;
        this.labels = labels;
        this.legend = legend;
        this.letterScale = letterScale;
    }

    /**
     * How the image is turned and mirrored.
     *
     * @return from the image as it comes to the upright image, which the overlay lies over
     */
    public ImageOrientation orientation() {
        return orientation;
    }

    /**
     * Whether there is a banner and a legend.
     *
     * @return false where the program says in its own way what they would say
     */
    public boolean panels() {
        return panels;
    }

    /**
     * What the labels say.
     *
     * @return the words
     */
    public LabelWords labels() {
        return labels;
    }

    /**
     * What the legend says.
     *
     * @return the words
     */
    public LegendWords legend() {
        return legend;
    }

    /**
     * How large letters beside the markers are.
     *
     * @return 1 for the size in proportion to the image, positive
     */
    public double letterScale() {
        return letterScale;
    }

    /**
     * This style for an image that is turned or mirrored.
     *
     * @param turned how
     * @return a style
     */
    public OverlayStyle withOrientation(ImageOrientation turned) {
        return new OverlayStyle(turned, panels, labels, legend, letterScale);
    }

    /**
     * This style without banner and legend.
     *
     * @return a style
     */
    public OverlayStyle withoutPanels() {
        return new OverlayStyle(orientation, false, labels, legend, letterScale);
    }

    /**
     * This style with other labels.
     *
     * @param words what the labels say
     * @return a style
     */
    public OverlayStyle withLabels(LabelWords words) {
        return new OverlayStyle(orientation, panels, words, legend, letterScale);
    }

    /**
     * This style with another legend.
     *
     * @param words what the legend says
     * @return a style
     */
    public OverlayStyle withLegend(LegendWords words) {
        return new OverlayStyle(orientation, panels, labels, words, letterScale);
    }

    /**
     * This style with letters that can be read where the image is shown, however small it is shown there: at least as
     * large as wanted, but so that the figures of an object still fit into the image's width and labels do not fill its
     * height; never smaller than in proportion to the image.
     *
     * @param widthPx width of the upright image
     * @param heightPx its height
     * @param fit where it lies in the view
     * @param capHeight wanted height of a capital letter, view px, at least 0
     * @return a style
     * @throws IllegalArgumentException if the height is negative or not finite
     */
    public OverlayStyle legible(int widthPx, int heightPx, ViewFit fit, double capHeight) {
        if (!(capHeight >= 0) || Double.isInfinite(capHeight)) {
            throw new IllegalArgumentException("letters cannot be " + capHeight + " px high");
        }
        double proportionalPx = CellDrawing.labelCapPx(widthPx, heightPx);
        double largestPx = Math.min(widthPx / LEAST_WIDTH_IN_CAPS, heightPx / LEAST_HEIGHT_IN_CAPS);
        double wantedPx = Math.min(capHeight / fit.scale(), largestPx);
        return new OverlayStyle(orientation, panels, labels, legend,
                Math.max(1, wantedPx / proportionalPx));
    }

    @Override
    public String toString() {
        return orientation + (panels ? ", with panels" : ", without panels") + ", letters x " + letterScale;
    }
}
