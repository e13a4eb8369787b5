package org.cellgauge.output;

import org.jspecify.annotations.Nullable;

/**
 * How one reference fits the others; immutable. Arrays by coordinate of its placement: shift along world x, y, z in mm,
 * then turn about world x, y, z in rad; what has no test is NaN.
 */
public final class ReferenceFitView extends Value {
    private final int id;
    private final boolean used;
    private final boolean misplaced;
    private final double chiSquare;
    private final int degreesOfFreedom;
    private final double pValue;
    private final double normalisedResidual;
    private final boolean tested;
    private final double[] statistic;
    private final double[] limit;
    private final double[] offset;
    private final double[] offsetStd;
    private final double[] detectable;

    ReferenceFitView(int id, boolean used, boolean misplaced, double chiSquare, int degreesOfFreedom, double pValue,
            double normalisedResidual, boolean tested, double[] statistic, double[] limit, double[] offset, double[]
            offsetStd, double[] detectable) {
        this.id = id;
        this.used = used;
        this.misplaced = misplaced;
        this.chiSquare = Figures.finite(chiSquare);
        this.degreesOfFreedom = degreesOfFreedom;
        this.pValue = Figures.finite(pValue);
        this.normalisedResidual = Figures.finite(normalisedResidual);
        this.tested = tested;
        this.statistic = Figures.finite(statistic);
        this.limit = Figures.finite(limit);
        this.offset = Figures.finite(offset);
        this.offsetStd = Figures.finite(offsetStd);
        this.detectable = Figures.finite(detectable);
    }

    /**
     * The reference.
     *
     * @return marker id
     */
    public int id() {
        return id;
    }

    /**
     * Whether the camera pose rests on it.
     *
     * @return false for one that was not seen or left out: it has no figures
     */
    public boolean used() {
        return used;
    }

    /**
     * Whether it seems misplaced.
     *
     * @return mostly false
     */
    public boolean misplaced() {
        return misplaced;
    }

    /**
     * Its corners' residuals after the fit.
     *
     * @return chi-square distributed if the cell is as stated
     */
    public double chiSquare() {
        return chiSquare;
    }

    /**
     * Their degrees of freedom.
     *
     * @return 0 where there are none
     */
    public int degreesOfFreedom() {
        return degreesOfFreedom;
    }

    /**
     * Chance of residuals as large as these if the cell is as stated.
     *
     * @return between 0 and 1
     */
    public double pValue() {
        return pValue;
    }

    /**
     * Root of chi-square by its degrees of freedom.
     *
     * @return about 1 if the cell is as stated
     */
    public double normalisedResidual() {
        return normalisedResidual;
    }

    /**
     * Whether its coordinates are tested.
     *
     * @return false where nothing but the residual is known
     */
    public boolean tested() {
        return tested;
    }

    /**
     * The test of each coordinate.
     *
     * @return standard normal if the reference stands as stated; a new array
     */
    public double[] statistic() {
        return statistic.clone();
    }

    /**
     * The size that makes a test raise an alarm.
     *
     * @return a new array
     */
    public double[] limit() {
        return limit.clone();
    }

    /**
     * By how much it seems off, if that coordinate alone is.
     *
     * @return mm, then rad; a new array
     */
    public double[] offset() {
        return offset.clone();
    }

    /**
     * Standard deviation of these offsets in cells as stated.
     *
     * @return mm, then rad; a new array
     */
    public double[] offsetStd() {
        return offsetStd.clone();
    }

    /**
     * How far off it has to be to be noticed in 19 of 20 photos.
     *
     * @return mm, then rad; a new array
     */
    public double[] detectable() {
        return detectable.clone();
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {id, used, misplaced, chiSquare, degreesOfFreedom, pValue, normalisedResidual,
            tested, statistic, limit, offset, offsetStd, detectable};
    }
}
