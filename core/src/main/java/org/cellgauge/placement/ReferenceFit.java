package org.cellgauge.placement;

import java.util.Arrays;
import java.util.List;
import org.cellgauge.cell.Reference;
import org.cellgauge.internal.statistics.ChiSquare;

/**
 * How one reference fits the others under the model, and how far off it would be noticed; immutable.
 *
 * <p>Arrays by coordinate of its placement: shift along world x, y, z in mm, then turn about world x, y, z in rad. What
 * has no test (the pose absorbs it, or the model knows no rigid placement) is NaN.
 */
public final class ReferenceFit {
    private final Reference reference;
    private final double chiSquare;
    private final int degreesOfFreedom;
    private final boolean misplaced;
    private final double distanceMm;
    private final double[] statistic = undefined();
    private final double[] limit = undefined();
    private final double[] offset = undefined();
    private final double[] offsetStd = undefined();
    private final double[] apartStd = undefined();
    private final double[] detectable = undefined();

    ReferenceFit(Reference reference, double distanceMm, double[] chiSquare, boolean misplaced,
            List<DirectionScore> tests, LargestCorrelation among) {
        this.reference = reference;
        this.distanceMm = distanceMm;
        this.chiSquare = chiSquare[0];
        this.degreesOfFreedom = (int) chiSquare[1];
        this.misplaced = misplaced;
        for (DirectionScore test : tests) {
            int c = test.coordinate();
            if (c >= 0) {
                statistic[c] = test.statistic();
                limit[c] = test.limit();
                offset[c] = test.offset()[c];
                offsetStd[c] = test.offsetStd()[c];
                apartStd[c] = offsetStd[c] * test.timesApart(among);
                detectable[c] = test.detectable()[c];
            }
        }
    }

    private static double[] undefined() {
        double[] out = new double[PlacementScores.COORDINATES];
        Arrays.fill(out, Double.NaN);
        return out;
    }

    /**
     * The reference.
     *
     * @return marker id
     */
    public int id() {
        return reference.id();
    }

    /** Its precision along a world axis as stated, mm. */
    double statedStdMm(int axis) {
        return reference.placement().stdMm(axis);
    }

    /** How far it stands from the camera, mm. */
    double distanceMm() {
        return distanceMm;
    }

    /**
     * Its corners' residuals at the mode, normalised by the covariance that the model gives them after the fit.
     *
     * @return chi-square distributed with {@link #degreesOfFreedom()} if the cell is as stated
     */
    public double chiSquare() {
        return chiSquare;
    }

    /**
     * Number of residuals that the fit has left.
     *
     * @return 8, less what the pose absorbs entirely
     */
    public int degreesOfFreedom() {
        return degreesOfFreedom;
    }

    /**
     * Chance of a chi-square as large as this.
     *
     * @return uniform in (0, 1) if the cell is as stated; NaN where no residual is left
     */
    public double pValue() {
        return ChiSquare.pValue(chiSquare, degreesOfFreedom);
    }

    /**
     * Root mean square of its normalised residuals.
     *
     * @return about 1 if the cell is as stated
     */
    public double normalisedResidual() {
        return Math.sqrt(chiSquare / degreesOfFreedom);
    }

    /**
     * Whether it was found to be off by more than its stated precision allows.
     *
     * @return true if a {@link MisplacedReference} names it
     */
    public boolean misplaced() {
        return misplaced;
    }

    /**
     * Whether its placement was tested at all.
     *
     * @return false where the likelihood knows no rigid placements
     */
    public boolean tested() {
        for (double value : statistic) {
            if (!Double.isNaN(value)) {
                return true;
            }
        }
        return false;
    }

    /**
     * For each coordinate the statistic of its test alone.
     *
     * @return a copy; standard normal if the cell is as stated
     */
    public double[] statistic() {
        return statistic.clone();
    }

    /**
     * For each coordinate the size of the statistic that raises an alarm.
     *
     * @return a copy
     */
    public double[] limit() {
        return limit.clone();
    }

    /**
     * For each coordinate where the photo puts the reference relative to the cell file, if that coordinate alone is
     * off.
     *
     * @return a copy; mm, then rad
     */
    public double[] offset() {
        return offset.clone();
    }

    /**
     * Standard deviation of these offsets in cells as stated: the reference's own precision and what photo and other
     * references leave open.
     *
     * @return a copy; mm, then rad
     */
    public double[] offsetStd() {
        return offsetStd.clone();
    }

    /**
     * The same if any one other reference may be off, or one other cause be at work besides: of an offset of several of
     * these the photo tells whose it is.
     *
     * @return a copy; mm, then rad; infinite where something else looks just like it
     */
    public double[] apartStd() {
        return apartStd.clone();
    }

    /**
     * For each coordinate how far the reference has to be off for its test to notice it in 19 of 20 photos.
     *
     * @return a copy; mm, then rad
     */
    public double[] detectable() {
        return detectable.clone();
    }
}
