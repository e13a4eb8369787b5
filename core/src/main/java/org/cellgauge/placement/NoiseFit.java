package org.cellgauge.placement;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.distribution.FDistribution;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.MarkerPoseFinder;
import org.cellgauge.internal.statistics.ChiSquare;
import org.cellgauge.internal.statistics.CoverageRegion;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/**
 * Whether corners are as precise as the cell file states, by how square markers are; immutable.
 *
 * <p>Eight coordinates of a marker less the six of its pose leave two that neither pose, placement nor size explains:
 * over all markers of the cell that the photo shows their squares are chi-square distributed if the noise is as stated
 * (global test of a network by its variance factor, here by its part that no placement error reaches: Baarda, "A
 * testing procedure for use in geodetic networks", 1968). Each marker is held against it alone as well: among
 * many, one that is far off would hide in the sum. A noise that nobody states is learned from the same squares; each
 * marker is held against what those of the others say of it.
 */
public final class NoiseFit {
    /** Chance that a photo as stated fails the test of all markers together. */
    static final double LEVEL_TOGETHER = 0.0018;
    /** Chance that any marker of a photo as stated fails the test of it alone. */
    static final double LEVEL_ALONE = 0.0002;
    /** Chance that a photo as stated fails; with that of {@link DirectionScore#LEVEL} below 1 in 100. */
    public static final double LEVEL = LEVEL_TOGETHER + LEVEL_ALONE;
    /** Share of photos in which corners are less noisy than what references are then tested with. */
    private static final double CONFIDENCE = 0.95;
    /** Chance of calling one of several equally noisy markers the only bad one. */
    private static final double OUTLIER_LEVEL = 0.01;
    /** Markers but for bad ones that fit as stated no worse than this let these count as the only bad ones. */
    private static final double USUAL = 0.05;
    /** How far about their prior means unknown focal lengths are searched, and in which steps. */
    private static final double SEARCHED_STDS = 3;
    private static final double FIRST_STEP_STDS = 0.25;
    private static final double LAST_STEP_STDS = 0.001;
    /** Least inflation of the variance of a marker with a corner that is far off. */
    private static final double LEAST_INFLATION = 9;

    private final double statedStdPx;
    private final Map<Integer, Double> markers;
    private final double chiSquare;
    private final List<Integer> outliers;
    private final Map<Integer, Double> noSquares;

    private NoiseFit(double statedStdPx, Map<Integer, Double> markers, Map<Integer, Double> noSquares) {
        this.statedStdPx = statedStdPx;
        this.markers = Collections.unmodifiableMap(markers);
        this.noSquares = Collections.unmodifiableMap(noSquares);
        double sum = 0;
        for (double squares : markers.values()) {
            sum += squares;
        }
        chiSquare = sum;
        outliers = Collections.unmodifiableList(tested() ? badOnes() : new ArrayList<>(noSquares.keySet()));
    }

    /**
     * Holds the corners of a photo against their stated noise.
     *
     * @param cell the cell
     * @param errors errors of the corners
     * @param lens intrinsics, as estimated where they are unknown
     * @param finder of the caller's thread
     * @return the test
     */
    public static NoiseFit of(Cell cell, CornerErrors errors, PinholeCamera lens, MarkerPoseFinder finder) {
        if (errors.added() != null) {
            return new NoiseFit(Double.NaN, Collections.emptyMap(), errors.noSquares(LEVEL));
        }
        Map<Integer, Double> markers = new LinkedHashMap<>();
        if (!Double.isNaN(errors.statedStdPx())) {
            for (Reference reference : cell.references()) {
                add(reference.id(), reference.sizeMm(), errors, lens, finder, markers);
            }
            for (ObjectMarker object : cell.objects()) {
                add(object.id(), object.sizeMm(), errors, lens, finder, markers);
            }
        }
        return new NoiseFit(errors.statedStdPx(), markers, Collections.emptyMap());
    }

    /**
     * The same with unknown intrinsics: those within three deviations of what is known of them that make markers the
     * most square. Corners that some focal length explains are no sign of noise; that one is fitted makes the test a
     * little too lenient.
     *
     * @param cell the cell
     * @param errors errors of the corners
     * @param prior of the unknown intrinsics
     * @param finder of the caller's thread
     * @return the test
     */
    public static NoiseFit ofUnknownIntrinsics(Cell cell, CornerErrors errors, IntrinsicsPrior prior,
            MarkerPoseFinder finder) {
        if (errors.added() != null) {
            return of(cell, errors, cell.camera(), finder);
        }
        double[] at = new double[prior.count()];
        NoiseFit best = null;
        for (double k = -SEARCHED_STDS; k <= SEARCHED_STDS; k += FIRST_STEP_STDS) {
            double[] there = at.clone();
            there[0] = k;
            NoiseFit fit = at(cell, errors, prior, there, finder);
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
                    NoiseFit fit = Math.abs(there[i]) > SEARCHED_STDS ? null
                            : at(cell, errors, prior, there, finder);
                    if (fit != null && fit.isSquarerThan(best)) {
                        best = fit;
                        at = there;
                    }
                }
            }
        }
        return best == null ? untested() : best;
    }

    private static @Nullable NoiseFit at(Cell cell, CornerErrors errors, IntrinsicsPrior prior, double[] rows,
            MarkerPoseFinder finder) {
        double[] intrinsics = cell.camera().intrinsics();
        prior.setWhitened(rows, intrinsics);
        return intrinsics[PinholeCamera.FX] > 0 && intrinsics[PinholeCamera.FY] > 0 ? of(cell, errors,
                cell.camera().withIntrinsics(intrinsics), finder) : null;
    }

    private boolean isSquarerThan(@Nullable NoiseFit other) {
        return other == null || markers.size() > other.markers.size()
                || (markers.size() == other.markers.size() && chiSquare < other.chiSquare);
    }

    /**
     * The same with a marker of which the other references say that a corner is off.
     *
     * @param wrong the corner
     * @return a test that holds no more
     */
    public NoiseFit with(WrongCorner wrong) {
        Map<Integer, Double> worse = new LinkedHashMap<>(tested() ? markers : noSquares);
        worse.put(wrong.id(), tested() ? wrong.chiSquare() : Math.sqrt(wrong.chiSquare() / 2));
        return tested() ? new NoiseFit(statedStdPx, worse, noSquares) : new NoiseFit(statedStdPx, markers, worse);
    }

    /**
     * The test on squares that are known already.
     *
     * @param statedStdPx the stated noise, px
     * @param markers chi-square of each marker, by id
     * @return the test
     */
    public static NoiseFit of(double statedStdPx, Map<Integer, Double> markers) {
        return new NoiseFit(statedStdPx, new LinkedHashMap<>(markers), Collections.emptyMap());
    }

    /**
     * A test that nothing is held against.
     *
     * @return one that holds
     */
    public static NoiseFit untested() {
        return new NoiseFit(Double.NaN, Collections.emptyMap(), Collections.emptyMap());
    }

    private static void add(int id, double sizeMm, CornerErrors errors, PinholeCamera lens, MarkerPoseFinder finder,
            Map<Integer, Double> to) {
        double squares = errors.has(id) ? errors.squareChiSquare(id, sizeMm, lens, finder) : Double.NaN;
        if (!Double.isNaN(squares)) {
            to.put(id, squares);
        }
    }

    /**
     * The fewest markers, the worst ones and half of all at most, without which the others fit as stated; none if they
     * are not out of line with these (F test), so that it is the noise of all.
     */
    private List<Integer> badOnes() {
        if (holds()) {
            return new ArrayList<>();
        }
        List<Integer> worstFirst = new ArrayList<>(markers.keySet());
        worstFirst.sort((a, b) -> Double.compare(squares(b), squares(a)));
        double ofRest = chiSquare;
        for (int k = 1; 2 * k <= worstFirst.size(); k++) {
            ofRest -= squares(worstFirst.get(k - 1));
            int rest = 2 * (worstFirst.size() - k);
            boolean othersFit = ChiSquare.pValue(ofRest, rest) > USUAL;
            for (int other : worstFirst.subList(k, worstFirst.size())) {
                othersFit &= holdsAlone(squares(other));
            }
            if (othersFit) {
                double limit = new FDistribution(null, 2, rest)
                        .inverseCumulativeProbability(1 - OUTLIER_LEVEL / worstFirst.size());
                return (chiSquare - ofRest) / (2 * k) > limit * ofRest / rest
                        ? new ArrayList<>(worstFirst.subList(0, k)) : new ArrayList<>();
            }
        }
        return new ArrayList<>();
    }

    /** The test of one marker; chi-square of 2 degrees of freedom is beyond x with the chance exp(-x / 2). */
    private boolean holdsAlone(double squares) {
        return Math.exp(-squares / 2) >= LEVEL_ALONE / markers.size();
    }

    private double squares(int id) {
        return markers.getOrDefault(id, Double.NaN);
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
        return ChiSquare.pValue(chiSquare, degreesOfFreedom());
    }

    /**
     * Whether the corners of every marker may be of a square, as precise as stated; where nothing is stated, as
     * precise as those of the others.
     *
     * @return true as well where there is nothing to test
     */
    public boolean holds() {
        return tested() ? pValue() >= LEVEL_TOGETHER
                && markers.values().stream().allMatch(this::holdsAlone) : noSquares.isEmpty();
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
     * The markers because of which the test fails, where the others fit as stated.
     *
     * @return their ids, the worst first, unmodifiable; mostly none
     */
    public List<Integer> outliers() {
        return outliers;
    }

    /**
     * How many times noisier than stated the corners of a marker are by themselves.
     *
     * @param id marker id
     * @return NaN where it is not in the photo, or not tested
     */
    public double times(int id) {
        return Math.sqrt(squares(id) / 2);
    }

    /**
     * Factors on the variances of the corners of {@link #outliers()} and of all that fail alone with which regions hold
     * all the same: half of chi-square is the factor that would make them usual, 2 degrees of freedom tell it so poorly
     * that regions need twice that.
     *
     * @return by marker id; empty where the noise is not stated
     */
    public Map<Integer, Double> inflationOfOutliers() {
        Map<Integer, Double> factors = new LinkedHashMap<>();
        markers.forEach((id, squares) -> {
            if (outliers.contains(id) || !holdsAlone(squares)) {
                factors.put(id, Math.max(LEAST_INFLATION, squares));
            }
        });
        return factors;
    }

    /**
     * The same of a marker of which a corner is off.
     *
     * @param wrong the corner
     * @return factor on the variances of the marker's corners
     */
    public static double inflation(WrongCorner wrong) {
        return Math.max(LEAST_INFLATION, wrong.chiSquare());
    }

    /**
     * Factors on the variances of corners with which references can be tested although no single marker is why the
     * noise is not as stated: the upper limit of 95 % of what the squares of all show.
     *
     * @return by marker id; empty where the noise holds but for outliers
     */
    public Map<Integer, Double> inflation() {
        Map<Integer, Double> factors = new LinkedHashMap<>();
        if (tested() && outliers.isEmpty() && !holds()) {
            double factor = chiSquare / CoverageRegion.chiSquareQuantile(1 - CONFIDENCE, degreesOfFreedom());
            markers.keySet().forEach(id -> factors.put(id, factor));
        }
        return factors;
    }

    /** What to tell the user. */
    List<Warning> warnings() {
        List<Warning> warnings = new ArrayList<>();
        for (int id : outliers) {
            warnings.add(tested() ? Warning.of(CheckWarning.MARKER_NOISIER_THAN_STATED, id,
                    Decimal.of(times(id), 1), Decimal.of(statedStdPx, 3))
                    : Warning.of(CheckWarning.MARKER_NO_SQUARE, id,
                            Decimal.of(noSquares.getOrDefault(id, Double.NaN), 1)));
        }
        if (outliers.isEmpty() && !holds()) {
            warnings.add(Warning.of(CheckWarning.NOISIER_THAN_STATED, Decimal.of(times(), 1),
                    Decimal.of(statedStdPx, 3), Decimal.of(shownStdPx(), 3)));
        }
        return warnings;
    }

    /** What it adds to a reason; null where the noise holds. */
    @Nullable Misfit misfit() {
        if (holds()) {
            return null;
        }
        if (outliers.isEmpty()) {
            return Misfit.ofNoise(times(), statedStdPx, shownStdPx());
        }
        int worst = outliers.get(0);
        return tested() ? Misfit.ofMarker(worst, times(worst), statedStdPx)
                : Misfit.ofNoSquare(worst, noSquares.getOrDefault(worst, Double.NaN));
    }
}
