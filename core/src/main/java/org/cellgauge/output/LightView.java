package org.cellgauge.output;

import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.PhotoLight;
import org.jspecify.annotations.Nullable;

/** What was found out about a photo's light; immutable. */
public final class LightView extends Value {
    private final ToneCurve toneCurve;
    private final boolean toneCurveEstimated;
    private final double blurPx;
    private final double noiseGrey;
    private final double noiseDegreesOfFreedom;
    private final double edgeShiftStdPx;

    LightView(ToneCurve toneCurve, boolean toneCurveEstimated, double blurPx, double noiseGrey, double
            noiseDegreesOfFreedom, double edgeShiftStdPx) {
        this.toneCurve = toneCurve;
        this.toneCurveEstimated = toneCurveEstimated;
        this.blurPx = Figures.finite(blurPx);
        this.noiseGrey = Figures.finite(noiseGrey);
        this.noiseDegreesOfFreedom = Figures.finite(noiseDegreesOfFreedom);
        this.edgeShiftStdPx = Figures.finite(edgeShiftStdPx);
    }

    static LightView of(PhotoLight light) {
        return new LightView(light.toneCurve(), light.toneCurveEstimated(), light.blurPx(), light.noiseGrey(),
                light.noiseDegreesOfFreedom(), light.edgeShiftStdPx());
    }

    /**
     * The tone curve that corners were found with.
     *
     * @return never null
     */
    public ToneCurve toneCurve() {
        return toneCurve;
    }

    /**
     * Whether it was estimated from the photo.
     *
     * @return false where it was stated
     */
    public boolean toneCurveEstimated() {
        return toneCurveEstimated;
    }

    /**
     * How blurred edges are.
     *
     * @return standard deviation, px; NaN where that is not known
     */
    public double blurPx() {
        return blurPx;
    }

    /**
     * How noisy pixels are.
     *
     * @return standard deviation, of 255 grey levels; NaN where that is not known
     */
    public double noiseGrey() {
        return noiseGrey;
    }

    /**
     * What that rests on.
     *
     * @return degrees of freedom
     */
    public double noiseDegreesOfFreedom() {
        return noiseDegreesOfFreedom;
    }

    /**
     * How far edges may be shifted by what is not known of the tone curve.
     *
     * @return standard deviation, px
     */
    public double edgeShiftStdPx() {
        return edgeShiftStdPx;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {toneCurve.words(), toneCurveEstimated, blurPx, noiseGrey, noiseDegreesOfFreedom,
            edgeShiftStdPx};
    }
}
