package org.cellgauge.internal.vision;

/** Which pixels about a side of a marker its fit looks at, which a forecast of the fit has to know as well. */
public final class SideBand {
    /** Variance of a pixel's own extent, px². */
    public static final double PIXEL_VARIANCE = 1.0 / 12;
    /** Least distance from a side that is looked at, px. */
    public static final double HALF_WIDTH_PX = 3;
    private static final double HALF_WIDTH_BLURS = 2.6;
    private static final double CORNER_MARGIN_PX = 1.5;
    private static final double CORNER_MARGIN_BLURS = 3.2;
    private static final double CORNER_MARGIN_SHARE = 0.28;

    private SideBand() {
    }

    /**
     * How far from the side.
     *
     * @param blurPx standard deviation of the blur, without the pixel's own extent
     * @return px, either way
     */
    public static double halfWidthPx(double blurPx) {
        return Math.max(HALF_WIDTH_PX, HALF_WIDTH_BLURS * Math.sqrt(blurPx * blurPx + PIXEL_VARIANCE));
    }

    /**
     * Blur of edges as a sharpened photo shows them: that of an edge which is as steep in the middle.
     *
     * @param blurPx standard deviation of the blur before the mask, px
     * @param amount of an unsharp mask, at least 0
     * @param radiusPx standard deviation of its Gaussian, px
     * @return standard deviation without the pixel's own extent, px, at least 0
     */
    public static double sharpenedBlurPx(double blurPx, double amount, double radiusPx) {
        double std = Math.sqrt(blurPx * blurPx + PIXEL_VARIANCE);
        double steepness = (1 + amount) / std - amount / Math.hypot(std, radiusPx);
        return Math.sqrt(Math.max(0, 1 / (steepness * steepness) - PIXEL_VARIANCE));
    }

    /**
     * What is left out at each end of a side: there the next side's light must be known before it is measured, and
     * under a wrong tone curve that would pull at the curve.
     *
     * @param lengthPx of the side
     * @param blurPx standard deviation of the blur, without the pixel's own extent
     * @return px: deviations of the blur, at most a share of the length
     */
    public static double cornerMarginPx(double lengthPx, double blurPx) {
        return Math.min(CORNER_MARGIN_SHARE * lengthPx,
                Math.max(CORNER_MARGIN_PX, CORNER_MARGIN_BLURS * Math.sqrt(blurPx * blurPx + PIXEL_VARIANCE)));
    }
}
