package org.cellgauge.vision;

import org.cellgauge.light.ToneCurve;

/** What a detector found out about the light of one photo; immutable. */
public final class PhotoLight {
    /**
     * How far the outlines of all markers lie, alike, from where their inner edges say, in rendered photos: px, and a
     * share of the blur, with which it grows, as what is left of a tone curve moves edges by a share of their blur.
     */
    private static final double LEAST_OUTLINE_STD_PX = 0.002;
    private static final double OUTLINE_STD_BY_BLUR = 0.0055;
    /**
     * From this blur on, px, fully at the second, nothing tells an unsharp mask any more, nor one kind of tone curve
     * from another: rendered photos that hide a mask lie 0.003 px in the dark for each px of blur, those of sRGB taken
     * for a power 0.0015 px, and more where white is dark, since the curve bends most near black: 0.0045 px at a white
     * of 80 of 255.
     */
    private static final double TOLD_BLUR_PX = 0.7;
    private static final double HIDDEN_BLUR_PX = 1;
    private static final double HIDDEN_STD_BY_BLUR = 0.0085;
    /** A mask reaches from cell to cell: those of 3 px lie 0.008 px in the dark at a blur of 1.2 px, px³. */
    private static final double HIDDEN_STD_BY_CELL = 0.1;
    private static final double USUAL_WHITE_GREY = 230;
    private static final double DARKEST_WHITE_GREY = 20;

    private final ToneCurve toneCurve;
    private final boolean toneCurveEstimated;
    private final double blurPx;
    private final double noiseGrey;
    private final double noiseDegreesOfFreedom;
    private final double edgeShiftStdPx;
    private final boolean toneCurveOpen;
    private final double outlineStdPx;

    /**
     * Light of a photo.
     *
     * @param toneCurve the curve that grey values were read with
     * @param toneCurveEstimated whether it was estimated from the photo's edges and not stated
     * @param blurPx optical blur of the edges, standard deviation, median over the markers, px; NaN: not known
     * @param noiseGrey noise of a grey value half-way between black and white, standard deviation, grey levels of 255;
     *     NaN: not known
     * @param noiseDegreesOfFreedom what that rests on; NaN: not known
     * @param edgeShiftStdPx how far edges may lie from where this light puts them, all alike, before inner edges are
     *     looked at: standard deviation along the normal, px, not negative
     */
    public PhotoLight(ToneCurve toneCurve, boolean toneCurveEstimated, double blurPx, double noiseGrey,
            double noiseDegreesOfFreedom, double edgeShiftStdPx) {
        this(toneCurve, toneCurveEstimated, blurPx, noiseGrey, noiseDegreesOfFreedom, edgeShiftStdPx, false,
                usualOutlineStdPx(blurPx));
    }

    private PhotoLight(ToneCurve toneCurve, boolean toneCurveEstimated, double blurPx, double noiseGrey,
            double noiseDegreesOfFreedom, double edgeShiftStdPx, boolean toneCurveOpen, double outlineStdPx) {
        this.toneCurve = toneCurve;
        this.toneCurveEstimated = toneCurveEstimated;
        this.blurPx = blurPx;
        this.noiseGrey = noiseGrey;
        this.noiseDegreesOfFreedom = noiseDegreesOfFreedom;
        this.edgeShiftStdPx = edgeShiftStdPx;
        this.toneCurveOpen = toneCurveOpen;
        this.outlineStdPx = outlineStdPx;
    }

    /**
     * The same light of a photo whose whites are clipped and of whose curve nothing is known beforehand.
     *
     * @return light with an open tone curve
     */
    public PhotoLight withOpenToneCurve() {
        return new PhotoLight(toneCurve, toneCurveEstimated, blurPx, noiseGrey, noiseDegreesOfFreedom, edgeShiftStdPx,
                true, outlineStdPx);
    }

    /**
     * The same light of a photo in which outlines and inner edges of markers are less alike than usual.
     *
     * @param stdPx how far the outlines of all markers may lie, alike, from where their inner edges say: standard
     *     deviation along the normal, px, not negative
     * @return light with that deviation
     */
    public PhotoLight withOutlineStdPx(double stdPx) {
        return new PhotoLight(toneCurve, toneCurveEstimated, blurPx, noiseGrey, noiseDegreesOfFreedom, edgeShiftStdPx,
                toneCurveOpen, stdPx);
    }

    /**
     * How far outlines usually lie from where inner edges say, all alike.
     *
     * @param blurPx blur of the edges, standard deviation, px; NaN: not known
     * @return standard deviation along the normal, px
     */
    public static double usualOutlineStdPx(double blurPx) {
        return usualOutlineStdPx(blurPx, USUAL_WHITE_GREY, Double.POSITIVE_INFINITY);
    }

    /**
     * The same of a photo whose white and markers are known.
     *
     * @param blurPx blur of the edges, standard deviation, px; NaN: not known
     * @param whiteGrey the markers' white, grey levels of 255
     * @param cellPx width of the markers' cells, px
     * @return standard deviation along the normal, px
     */
    public static double usualOutlineStdPx(double blurPx, double whiteGrey, double cellPx) {
        if (Double.isNaN(blurPx)) {
            return LEAST_OUTLINE_STD_PX;
        }
        double hidden = Math.max(0, Math.min(1, (blurPx - TOLD_BLUR_PX) / (HIDDEN_BLUR_PX - TOLD_BLUR_PX)));
        double ofHidden = hidden / Math.sqrt(Math.max(DARKEST_WHITE_GREY, whiteGrey) / 255)
                * Math.hypot(HIDDEN_STD_BY_BLUR * blurPx, HIDDEN_STD_BY_CELL / (cellPx * cellPx));
        return Math.hypot(Math.hypot(LEAST_OUTLINE_STD_PX, OUTLINE_STD_BY_BLUR * blurPx), ofHidden);
    }

    /**
     * Whether nothing tells the tone curve: whites are clipped, and what the image says of its curve is not borne out.
     * Edges then lie wherever a curve puts them, and corners are good for showing markers, not for measuring.
     *
     * @return true if corners are not to be measured with
     */
    public boolean toneCurveOpen() {
        return toneCurveOpen;
    }

    /**
     * The tone curve.
     *
     * @return the curve that grey values were read with
     */
    public ToneCurve toneCurve() {
        return toneCurve;
    }

    /**
     * Where it comes from.
     *
     * @return true if the photo's edges told it, false if it was stated
     */
    public boolean toneCurveEstimated() {
        return toneCurveEstimated;
    }

    /**
     * Optical blur of the edges.
     *
     * @return standard deviation, median over the markers, px; NaN where it is not known
     */
    public double blurPx() {
        return blurPx;
    }

    /**
     * Noise of a grey value half-way between black and white.
     *
     * @return standard deviation, grey levels of 255; NaN where it is not known
     */
    public double noiseGrey() {
        return noiseGrey;
    }

    /**
     * What the noise rests on.
     *
     * @return degrees of freedom; NaN where they are not known
     */
    public double noiseDegreesOfFreedom() {
        return noiseDegreesOfFreedom;
    }

    /**
     * How far edges may lie from where this light puts them, all alike, before inner edges are looked at.
     *
     * @return standard deviation along the normal, px, not negative
     */
    public double edgeShiftStdPx() {
        return edgeShiftStdPx;
    }

    /**
     * How far the outlines of all markers may lie, alike, from where their inner edges say.
     *
     * @return standard deviation along the normal, px, not negative
     */
    public double outlineStdPx() {
        return outlineStdPx;
    }
}
