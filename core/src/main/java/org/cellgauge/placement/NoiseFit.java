package org.cellgauge.placement;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.distribution.FDistribution;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.statistics.CoverageRegion;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Warning;

/**
 * Whether corners are as precise as the cell file states, by how square markers are; immutable.
 *
 * <p>Eight coordinates of a marker less the six of its pose leave two that neither pose, placement nor size explains:
 * over all markers of the cell that the photo shows their squares are chi-square distributed if the noise is as stated
 * (global test of a network by its variance factor, here by its part that no placement error reaches: Baarda, "A
 * testing procedure for use in geodetic networks", 1968). A noise that nobody states is learned from the same squares
 * and has nothing to be held against.
 */
public final class NoiseFit {
    /** Chance that a photo as stated fails the test; with that of {@link DirectionScore#LEVEL} below 1 in 100. */
    public static final double LEVEL = 0.002;
    /** Share of photos in which corners are less noisy than what references are then tested with. */
    private static final double CONFIDENCE = 0.95;
    /** Chance of calling one of several equally noisy markers the only bad one. */
    private static final double OUTLIER_LEVEL = 0.01;
    /** Markers but for one that fit as stated no worse than this let it count as the only bad one. */
    private static final double USUAL = 0.05;
    /** Fewer markers than this cannot say which of them is out of line. */
    private static final int LEAST_MARKERS = 3;
    /** How far about their prior means unknown focal lengths are searched, and in which steps. */
    private static final double SEARCHED_STDS = 3;
    private static final double FIRST_STEP_STDS = 0.25;
    private static final double LAST_STEP_STDS = 0.001;
    /** Least inflation of the variance of a marker with a corner that is far off. */
    private static final double LEAST_INFLATION = 9;

    private final double statedStdPx;
    private final Map<Integer, Double> markers;
    private final double chiSquare;
    private final OptionalInt outlier;

    private NoiseFit(double statedStdPx, Map<Integer, Double> markers) {
        this.statedStdPx = statedStdPx;
        this.markers = Collections.unmodifiableMap(markers);
        double sum = 0;
        for (double squares : markers.values()) {
            sum += squares;
        }
        chiSquare = sum;
        outlier = holds() ? OptionalInt.empty() : onlyBadOne();
    }

    /**
     * Holds the corners of a photo against their stated noise.
     *
     * @param cell the cell
     * @param errors errors of the corners
     * @param lens intrinsics, as estimated where they are unknown
     */
    public static NoiseFit of(Cell cell, CornerErrors errors, PinholeCamera lens) {
        Map<Integer, Double> markers = new LinkedHashMap<>();
        if (!Double.isNaN(errors.statedStdPx())) {
            for (Reference reference : cell.references()) {
                add(reference.id(), reference.sizeMm(), errors, lens, markers);
            }
            for (ObjectMarker object : cell.objects()) {
                add(object.id(), object.sizeMm(), errors, lens, markers);
            }
        }
        return new NoiseFit(errors.statedStdPx(), markers);
    }

    /**
     * The same with unknown focal lengths: those within three deviations of what is known of them that make markers the
     * most square. Corners that some focal length explains are no sign of noise; that one is fitted makes the test a
     * little too lenient.
     *
     * @param cell the cell
     * @param errors errors of the corners
     * @param prior of the unknown intrinsics
     */
    public static NoiseFit ofUnknownFocal(Cell cell, CornerErrors errors, IntrinsicsPrior prior) {
        double[] at = new double[prior.count()];
        NoiseFit best = null;
        for (double k = -SEARCHED_STDS; k <= SEARCHED_STDS; k += FIRST_STEP_STDS) {
            double[] there = at.clone();
            there[0] = k;
            NoiseFit fit = at(cell, errors, prior, there);
            if (fit != null && fit.isSquarerThan(best)) {
                best = fit;
                at = there;
            }
        }
        // from there along every unknown in turn, in steps that shrink to a thousandth of a deviation
        for (double step = FIRST_STEP_STDS; step > LAST_STEP_STDS && best != null; step /= 2) {
            for (int i = 0; i < at.length; i++) {
                for (int side = -1; side <= 1; side += 2) {
                    double[] there = at.clone();
                    there[i] += side * step;
                    NoiseFit fit = Math.abs(there[i]) > SEARCHED_STDS ? null : at(cell, errors, prior, there);
                    if (fit != null && fit.isSquarerThan(best)) {
                        best = fit;
                        at = there;
                    }
                }
            }
        }
        return best == null ? untested() : best;
    }

    private static NoiseFit at(Cell cell, CornerErrors errors, IntrinsicsPrior prior, double[] rows) {
        double[] intrinsics = cell.camera().intrinsics();
        prior.setWhitened(rows, intrinsics);
        return intrinsics[PinholeCamera.FX] > 0 && intrinsics[PinholeCamera.FY] > 0 ? of(cell, errors,
                cell.camera().withIntrinsics(intrinsics)) : null;
    }

    private boolean isSquarerThan(NoiseFit other) {
        return other == null || markers.size() > other.markers.size()
                || (markers.size() == other.markers.size() && chiSquare < other.chiSquare);
    }

    /**
     * The test on squares that are known already.
     *
     * @param statedStdPx the stated noise, px
     * @param markers chi-square of each marker, by id
     */
    public static NoiseFit of(double statedStdPx, Map<Integer, Double> markers) {
        return new NoiseFit(statedStdPx, new LinkedHashMap<>(markers));
    }

    /** A test that nothing is held against. */
    public static NoiseFit untested() {
        return new NoiseFit(Double.NaN, Collections.emptyMap());
    }

    private static void add(int id, double sizeMm, CornerErrors errors, PinholeCamera lens, Map<Integer, Double> to) {
        double squares = errors.has(id) ? errors.squareChiSquare(id, sizeMm, lens) : Double.NaN;
        if (!Double.isNaN(squares)) {
            to.put(id, squares);
        }
    }

    /** The marker that is out of line with the others (F test), where these fit as stated. */
    private OptionalInt onlyBadOne() {
        int count = markers.size();
        if (count < LEAST_MARKERS) {
            return OptionalInt.empty();
        }
        int worst = worst();
        int rest = 2 * (count - 1);
        double ofRest = chiSquare - markers.get(worst);
        double limit = new FDistribution(null, 2, rest).inverseCumulativeProbability(1 - OUTLIER_LEVEL / count);
        return markers.get(worst) / 2 > limit * ofRest / rest && p(ofRest, rest) > USUAL
                ? OptionalInt.of(worst) : OptionalInt.empty();
    }

    private int worst() {
        int worst = -1;
        for (Map.Entry<Integer, Double> marker : markers.entrySet()) {
            worst = worst < 0 || marker.getValue() > markers.get(worst) ? marker.getKey() : worst;
        }
        return worst;
    }

    private static double p(double chiSquare, int degreesOfFreedom) {
        return 1 - new ChiSquaredDistribution(null, degreesOfFreedom).cumulativeProbability(chiSquare);
    }

    /**
     * Whether there is a stated noise to hold corners against.
     *
     * @return false where the noise is learned from the photo
     */
    public boolean tested() {
        return !markers.isEmpty();
    }

    /**
     * Sum of squares of what no pose explains, in stated deviations.
     *
     * @return chi-square distributed with {@link #degreesOfFreedom()} if the noise is as stated; NaN if not tested
     */
    public double chiSquare() {
        return tested() ? chiSquare : Double.NaN;
    }

    /**
     * Two per marker.
     *
     * @return 0 if not tested
     */
    public int degreesOfFreedom() {
        return 2 * markers.size();
    }

    /**
     * Chance of a chi-square as large as this if the noise is as stated.
     *
     * @return between 0 and 1; NaN if not tested
     */
    public double pValue() {
        return tested() ? p(chiSquare, degreesOfFreedom()) : Double.NaN;
    }

    /**
     * Whether the corners may be as precise as stated.
     *
     * @return true as well if not tested
     */
    public boolean holds() {
        return !tested() || pValue() >= LEVEL;
    }

    /**
     * How many times noisier the corners are than stated, as their squares show.
     *
     * @return about 1 if the noise is as stated; NaN if not tested
     */
    public double times() {
        return Math.sqrt(chiSquare() / degreesOfFreedom());
    }

    /**
     * The noise that the squares show.
     *
     * @return standard deviation of a coordinate, px; NaN if not tested
     */
    public double shownStdPx() {
        return statedStdPx * times();
    }

    /**
     * The one marker because of which the test fails, where the others fit as stated.
     *
     * @return its id, mostly empty
     */
    public OptionalInt outlier() {
        return outlier;
    }

    /**
     * How many times noisier than stated the corners of a marker are by themselves.
     *
     * @param id marker id
     * @return NaN where it is not in the photo, or not tested
     */
    public double times(int id) {
        return Math.sqrt(markers.getOrDefault(id, Double.NaN) / 2);
    }

    /**
     * Factors on the variances of corners with which references can be tested although the noise is not as stated: of
     * the only bad marker alone, otherwise the upper limit of 95 % of what the squares of all markers show.
     *
     * @return by marker id; empty where the noise holds
     */
    public Map<Integer, Double> inflation() {
        Map<Integer, Double> factors = new LinkedHashMap<>();
        if (outlier.isPresent()) {
            int id = outlier.getAsInt();
            factors.put(id, Math.max(LEAST_INFLATION, markers.get(id)));
        } else if (!holds()) {
            double factor = chiSquare / CoverageRegion.chiSquareQuantile(1 - CONFIDENCE, degreesOfFreedom());
            markers.keySet().forEach(id -> factors.put(id, factor));
        }
        return factors;
    }

    /** What to tell the user. */
    List<Warning> warnings() {
        List<Warning> warnings = new ArrayList<>();
        if (outlier.isPresent()) {
            warnings.add(Warning.of(CheckWarning.MARKER_NOISIER_THAN_STATED, outlier.getAsInt(),
                    Decimal.of(times(outlier.getAsInt()), 1), Decimal.of(statedStdPx, 3)));
        } else if (!holds()) {
            warnings.add(Warning.of(CheckWarning.NOISIER_THAN_STATED, Decimal.of(times(), 1),
                    Decimal.of(statedStdPx, 3), Decimal.of(shownStdPx(), 3)));
        }
        return warnings;
    }

    /** What it adds to a reason; null where the noise holds. */
    Misfit misfit() {
        return holds() ? null : outlier.isPresent()
                ? Misfit.ofMarker(outlier.getAsInt(), times(outlier.getAsInt()), statedStdPx)
                : Misfit.ofNoise(times(), statedStdPx, shownStdPx());
    }
}
