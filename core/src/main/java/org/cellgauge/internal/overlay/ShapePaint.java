package org.cellgauge.internal.overlay;

/**
 * Colours and widths that a shape is painted with, whatever paints it; immutable. A shape is filled first, then its
 * dark rim is drawn, then its line, each where there is one.
 *
 * <p>Colours are those of Okabe and Ito ("Color Universal Design", 2008), which people with any of the common colour
 * vision deficiencies tell apart, the green and the blue a little lighter for dark photos. Every line lies on a dark
 * rim, so that it shows on bright and on dark photos. They are given as 0xAARRGGBB, not premultiplied.
 */
public final class ShapePaint {
    private static final int ORANGE = 0xFFE69F00;
    private static final int SKY_BLUE = 0xFF56B4E9;
    private static final int GREEN = 0xFF14B98A;
    private static final int YELLOW = 0xFFF0E442;
    private static final int VERMILLION = 0xFFD55E00;
    private static final int PURPLE = 0xFFCC79A7;
    private static final int BLUE = 0xFF2E93D8;
    private static final int WHITE = 0xFFFFFFFF;
    private static final int GRID = 0x6EFFFFFF;
    private static final int GRID_RIM = 0x23000000;
    private static final int RIM = 0xBE000000;
    private static final int PANEL = 0xCD101216;
    private static final int RGB = 0x00FFFFFF;
    private static final int FILL_ALPHA = 60;
    private static final int DASHED_FILL_ALPHA = 25;
    /** By how much a rim is wider than its line, in units. */
    private static final double RIM_U = 2;
    private static final double TEXT_RIM_U = 2.6;
    /** Narrow, so as not to hide the detected outline that the expected one is to be compared with. */
    private static final double EXPECTED_RIM_U = 0.6;

    private final int fillArgb;
    private final int rimArgb;
    private final double rimPx;
    private final int lineArgb;
    private final double linePx;

    private ShapePaint(int fillArgb, int rimArgb, double rimPx, int lineArgb, double linePx) {
        this.fillArgb = fillArgb;
        this.rimArgb = rimArgb;
        this.rimPx = rimPx;
        this.lineArgb = lineArgb;
        this.linePx = linePx;
    }

    /**
     * The paint of a shape.
     *
     * @param shape the shape
     * @param unitPx {@link Overlay#unitPx()} of its overlay
     * @return its colours and widths
     */
    public static ShapePaint of(Shape shape, double unitPx) {
        int line = argb(shape);
        if (shape instanceof PanelShape) {
            return new ShapePaint(PANEL, 0, 0, line, shape.strokePx());
        }
        int alpha = shape.dashed() ? DASHED_FILL_ALPHA : FILL_ALPHA;
        int fill = shape instanceof EllipseShape ? alpha << 24 | line & RGB : 0;
        double rimU = shape.role() == Role.REFERENCE_EXPECTED ? EXPECTED_RIM_U
                : shape instanceof TextShape ? TEXT_RIM_U : RIM_U;
        return new ShapePaint(fill, shape.role() == Role.WORLD_GRID ? GRID_RIM : RIM,
                shape.strokePx() + rimU * unitPx, line, shape.strokePx());
    }

    /**
     * How far corners of panels are rounded.
     *
     * @param unitPx unit of the overlay
     * @return radius, px
     */
    public static double panelRadiusPx(double unitPx) {
        return 3 * unitPx;
    }

    /**
     * Dashes of dashed shapes; their lines have flat ends, others round ones.
     *
     * @param unitPx unit of the overlay
     * @return length of a dash and of the gap behind it, px; a new array
     */
    public static float[] dashesPx(double unitPx) {
        return new float[] {(float) (4 * unitPx), (float) (3 * unitPx)};
    }

    /**
     * What the shape is filled with.
     *
     * @return 0xAARRGGBB, 0 for nothing
     */
    public int fillArgb() {
        return fillArgb;
    }

    /**
     * Colour of the rim.
     *
     * @return 0xAARRGGBB, 0 for none
     */
    public int rimArgb() {
        return rimArgb;
    }

    /**
     * Width of the rim, the line's included.
     *
     * @return px, 0 where there is none
     */
    public double rimPx() {
        return rimPx;
    }

    /**
     * Colour of the line.
     *
     * @return 0xAARRGGBB
     */
    public int lineArgb() {
        return lineArgb;
    }

    /**
     * Width of the line.
     *
     * @return px
     */
    public double linePx() {
        return linePx;
    }

    private static int argb(Shape shape) {
        switch (shape.role()) {
            case WORLD_GRID:
                return GRID;
            case WORLD_AXIS_X:
            case OBJECT_AXIS_X:
                return VERMILLION;
            case WORLD_AXIS_Y:
            case OBJECT_AXIS_Y:
                return GREEN;
            case WORLD_AXIS_Z:
            case OBJECT_AXIS_Z:
                return BLUE;
            case REFERENCE_OUTLINE:
                return shape.status() == Status.FAIL ? VERMILLION : WHITE;
            case REFERENCE_EXPECTED:
                return YELLOW;
            default:
                break;
        }
        boolean plainText = shape instanceof TextShape && shape.status() == Status.NEUTRAL;
        return plainText ? WHITE : argb(shape.status());
    }

    private static int argb(Status status) {
        switch (status) {
            case PASS:
                return GREEN;
            case FAIL:
                return VERMILLION;
            case NOT_CONVERGED:
                return PURPLE;
            case AMBIGUOUS:
                return ORANGE;
            default:
                return SKY_BLUE;
        }
    }
}
