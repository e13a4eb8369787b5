package org.cellgauge.check;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.cellgauge.estimate.VarianceSource;
import org.jspecify.annotations.Nullable;

/** What a target is held against at the position of an object or at its gripping point; immutable. */
public final class JudgedPoint {
    private final double[] stdMm;
    private final double[] sampledStdMm;
    private final double[] mcseStdMm;
    private final double @Nullable [] errorMm;
    private final List<Map<VarianceSource, Double>> shares;
    private final List<Conformity> conformities;

    /**
     * A point. Every array is along world x, y, z.
     *
     * @param stdMm standard deviations as the result states them, mm
     * @param sampledStdMm the same as the diagnostics of the chains have them, mm; NaN where nothing was sampled
     * @param mcseStdMm their Monte Carlo errors, mm; NaN where nothing was sampled
     * @param errorMm root mean square errors if the references that seem misplaced are, mm; null where none does, or
     *     without them there is no camera pose
     * @param shares by axis, each source's share of the variance
     * @param conformities how probable it is that tolerances are kept; empty where there are none
     */
    public JudgedPoint(double[] stdMm, double[] sampledStdMm, double[] mcseStdMm, double @Nullable [] errorMm,
            List<Map<VarianceSource, Double>> shares, List<Conformity> conformities) {
        this.stdMm = stdMm.clone();
        this.sampledStdMm = sampledStdMm.clone();
        this.mcseStdMm = mcseStdMm.clone();
        this.errorMm = errorMm == null ? null : errorMm.clone();
        this.shares = Collections.unmodifiableList(new ArrayList<>(shares));
        this.conformities = Collections.unmodifiableList(new ArrayList<>(conformities));
    }

    /**
     * How probable it is that tolerances are kept.
     *
     * @return unmodifiable, one for each tolerance; of a position the turn of its object is among them
     */
    public List<Conformity> conformities() {
        return conformities;
    }

    /** Standard deviation along an axis as stated, mm. */
    double stdMm(int axis) {
        return stdMm[axis];
    }

    /** The same of the draws, mm. */
    double sampledStdMm(int axis) {
        return sampledStdMm[axis];
    }

    /** Monte Carlo error of that, mm. */
    double mcseStdMm(int axis) {
        return mcseStdMm[axis];
    }

    /** Shares of the variance along an axis, by source. */
    Map<VarianceSource, Double> shares(int axis) {
        return shares.get(axis);
    }

    /** The largest deviation, mm. */
    double largestStdMm() {
        return largest(stdMm);
    }

    /** The error along an axis if references are misplaced, mm; infinite where nothing says what it is. */
    double errorMm(int axis) {
        return errorMm == null ? Double.POSITIVE_INFINITY : errorMm[axis];
    }

    /** The largest of these. */
    double largestErrorMm() {
        return errorMm == null ? Double.POSITIVE_INFINITY : largest(errorMm);
    }

    private static double largest(double[] values) {
        return Arrays.stream(values).max().getAsDouble();
    }
}
