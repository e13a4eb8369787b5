package org.cellgauge.estimate;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.cellgauge.internal.estimate.Matrices;

/** Unknown intrinsics with their uncertainty; immutable. */
public final class IntrinsicsEstimate {
    /** Share of the deviation known beforehand, from which on a photo has told next to nothing. */
    private static final double NOT_LEARNED = 0.9;

    private final List<String> names;
    private final double[] mean;
    private final double[][] covariance;
    private final double[] priorMean;
    private final double[] priorStd;
    private final int estimated;

    /**
     * An estimate.
     *
     * @param names names with units, for instance {@code fx_px}
     * @param mean values in that order; copied
     * @param covariance in that order; copied
     * @param priorMean values that were known beforehand, in that order; copied
     * @param priorStd how well they were known, in that order; +infinity where a prior is flat; copied
     * @param estimated how many are estimated, beginning with the first; the others are as a calibration leaves them
     */
    public IntrinsicsEstimate(List<String> names, double[] mean, double[][] covariance, double[] priorMean,
            double[] priorStd, int estimated) {
        this.names = Collections.unmodifiableList(names);
        this.mean = mean.clone();
        this.covariance = Matrices.copy(covariance);
        this.priorMean = priorMean.clone();
        this.priorStd = priorStd.clone();
        this.estimated = estimated;
    }

    /**
     * The same unknowns with other means and covariances.
     *
     * @param otherMean values in the order of the names; copied
     * @param otherCovariance in that order; copied
     * @return a new estimate
     */
    public IntrinsicsEstimate with(double[] otherMean, double[][] otherCovariance) {
        return new IntrinsicsEstimate(names, otherMean, otherCovariance, priorMean, priorStd, estimated);
    }

    /**
     * Names with units.
     *
     * @return unmodifiable
     */
    public List<String> names() {
        return names;
    }

    /**
     * Means.
     *
     * @return a copy, in the order of the names
     */
    public double[] mean() {
        return mean.clone();
    }

    /**
     * Covariance.
     *
     * @return a copy, in the order of the names
     */
    public double[][] covariance() {
        return Matrices.copy(covariance);
    }

    /**
     * Values that were known before the photo was seen.
     *
     * @return a copy, in the order of the names
     */
    public double[] priorMean() {
        return priorMean.clone();
    }

    /**
     * How well they were known.
     *
     * @return standard deviations, a copy, in the order of the names; +infinity where a prior is flat
     */
    public double[] priorStd() {
        return priorStd.clone();
    }

    /**
     * Whether a photo tells anything of an unknown.
     *
     * @param std its standard deviation
     * @param priorStd the one known beforehand; +infinity or NaN where that is none
     * @return false where the first is nine tenths of the second or more: its figures are what was known beforehand
     */
    public static boolean isLearned(double std, double priorStd) {
        return !(std >= NOT_LEARNED * priorStd);
    }

    /**
     * Which of those that are estimated the photo tells next to nothing of.
     *
     * @return names
     */
    public List<String> notLearned() {
        List<String> open = new ArrayList<>();
        for (int i = 0; i < estimated; i++) {
            if (!isLearned(Math.sqrt(covariance[i][i]), priorStd[i])) {
                open.add(names.get(i));
            }
        }
        return open;
    }

    /**
     * How many are estimated, beginning with the first.
     *
     * @return 0 to all; the others are as a calibration leaves them
     */
    public int estimated() {
        return estimated;
    }
}
