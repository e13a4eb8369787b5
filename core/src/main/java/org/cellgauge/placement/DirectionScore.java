package org.cellgauge.placement;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.statistics.SharedLevel;
import org.jspecify.annotations.Nullable;

/**
 * The test of one direction of one reference's placement: is the reference off along it by more than its stated
 * precision allows? Or of one cause that moves the corners of all references. Immutable.
 *
 * <p>Tried of a reference are shifts along each world axis, shifts half-way between two axes, and turns about each
 * axis. The limits are such that a cell as stated raises any alarm with the chance {@link #LEVEL}. The level is shared
 * by the chance that each test would find what it looks for, five stated deviations along its direction (weights fixed
 * by the layout alone keep the level: Genovese, Roeder and Wasserman, "False discovery control with p-value
 * weighting", Biometrika 2006): a test of what the pose absorbs anyway must not cost the others their sharpness.
 * Causes share it by the chance of finding the size that their {@link CausePattern} calls typical.
 */
final class DirectionScore {
    /** Chance of a false alarm per cell by the linear model; with those of noise and of all together below 1 in 100. */
    static final double LEVEL = 0.0065;
    /** Chance of being found that {@link #detectable()} is about. */
    static final double POWER = 0.95;
    /** How far off a reference is, in stated deviations, that the tests are made to find. */
    static final double LOOKED_FOR = 5;
    /** What share of the level a direction gets: places are stated, and measured, along axes. */
    private static final double[] WEIGHTS = {1, 0.2, 0.05};
    /** About where the limits will be: it sets the weights, not the level. */
    private static final double TYPICAL_LIMIT = 3.3;
    /**
     * Deviations that a cause of its typical size comes to, below which it is not asked about: only ten times that size
     * and more would show, which no cell has, and what rounding leaves of a fit would pass for it.
     */
    private static final double LEAST_SENSITIVITY = 0.1;
    private static final NormalDistribution NORMAL = new NormalDistribution(null, 0, 1);
    private static final double HALF = Math.sqrt(0.5);
    /** Shifts along an axis, shifts between two, turns; by coordinate of the placement in stated deviations. */
    private static final double[][][] DIRECTIONS = {
        {{1, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0}},
        {{HALF, HALF, 0, 0, 0, 0}, {HALF, -HALF, 0, 0, 0, 0}, {HALF, 0, HALF, 0, 0, 0}, {HALF, 0, -HALF, 0, 0, 0},
            {0, HALF, HALF, 0, 0, 0}, {0, HALF, -HALF, 0, 0, 0}},
        {{0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 1}}};
    /** Directions of a principal point. */
    private static final double[][] ACROSS = {{1, 0}, {0, 1}, {HALF, HALF}, {HALF, -HALF}};
    private static final double[][] ALONE = {{1}};
    /** Limits depend on layout and pose alone, not on the seed of a run. */
    private static final long SEED = 20_250_117;

    /** Index of the reference; -1 of a cause. */
    final int index;
    /** Null of a cause. */
    final @Nullable Reference reference;
    /** Null of a reference. */
    final @Nullable CausePattern cause;
    /** The score that its direction begins with. */
    final int first;
    private final double[] direction;
    /** Where the direction begins and ends to be anything but zero. */
    private final int from;
    private final int to;
    private final double score;
    private final double sensitivity;
    private final double weight;
    private final double limit;

    private DirectionScore(int index, @Nullable Reference reference, @Nullable CausePattern cause, int first,
            double[] direction, double score, double sensitivity, double weight, double limit) {
        this.index = index;
        this.reference = reference;
        this.cause = cause;
        this.first = first;
        this.direction = direction;
        int begins = 0;
        while (begins < direction.length - 1 && direction[begins] == 0) {
            begins++;
        }
        int ends = direction.length;
        while (ends > begins + 1 && direction[ends - 1] == 0) {
            ends--;
        }
        from = begins;
        to = ends;
        this.score = score;
        this.sensitivity = sensitivity;
        this.weight = weight;
        this.limit = limit;
    }

    /** The reference that it is about; only where it is about one. */
    Reference reference() {
        return Objects.requireNonNull(reference, "a cause is no reference");
    }

    private CausePattern cause() {
        return Objects.requireNonNull(cause, "a reference is no cause");
    }

    private DirectionScore withLimit(double found) {
        return new DirectionScore(index, reference, cause, first, direction, score, sensitivity, weight, found);
    }

    /** All tests of a fit; none of a direction that the pose absorbs entirely. */
    static List<DirectionScore> of(ReferenceView view, List<CausePattern> causes, PlacementScores scores) {
        List<DirectionScore> tests = withoutLimits(view, causes, scores);
        return tests.isEmpty() ? tests : withLimits(tests, scores);
    }

    /** The most of chi-square that any direction of a reference or of a cause takes. */
    static double mostExplained(ReferenceView view, List<CausePattern> causes, PlacementScores scores) {
        double most = 0;
        for (DirectionScore test : withoutLimits(view, causes, scores)) {
            most = Math.max(most, test.statistic() * test.statistic());
        }
        return most;
    }

    private static List<DirectionScore> withoutLimits(ReferenceView view, List<CausePattern> causes,
            PlacementScores scores) {
        List<DirectionScore> tests = new ArrayList<>();
        for (int m = 0; m < view.size(); m++) {
            int first = PlacementScores.COORDINATES * m;
            for (int kind = 0; kind < DIRECTIONS.length; kind++) {
                for (double[] direction : DIRECTIONS[kind]) {
                    double sensitivity = Math.sqrt(scores.variance(first, direction));
                    if (sensitivity > 0) {
                        tests.add(new DirectionScore(m, view.references().get(m), null, first, direction,
                                scores.score(first, direction), sensitivity,
                                WEIGHTS[kind] * chance(LOOKED_FOR, sensitivity, TYPICAL_LIMIT), Double.NaN));
                    }
                }
            }
        }
        int first = scores.firstOfCauses();
        for (CausePattern cause : causes) {
            for (double[] direction : cause.columnsPx.length == 1 ? ALONE : ACROSS) {
                double sensitivity = Math.sqrt(scores.variance(first, direction));
                if (sensitivity > LEAST_SENSITIVITY) {
                    tests.add(new DirectionScore(-1, null, cause, first, direction, scores.score(first, direction),
                            sensitivity, cause.weight
                            * NORMAL.cumulativeProbability(sensitivity - TYPICAL_LIMIT), Double.NaN));
                }
            }
            first += cause.columnsPx.length;
        }
        return tests;
    }

    private static List<DirectionScore> withLimits(List<DirectionScore> tests, PlacementScores scores) {
        double[] weights = new double[tests.size()];
        for (int t = 0; t < weights.length; t++) {
            weights[t] = tests.get(t).weight;
        }
        double[] limits = SharedLevel.limits(new Joint(tests, scores), weights, LEVEL, RandomStreams.of(SEED));
        List<DirectionScore> out = new ArrayList<>();
        for (int t = 0; t < weights.length; t++) {
            out.add(tests.get(t).withLimit(limits[t]));
        }
        return out;
    }

    /** All tests of a photo where nothing is to be found. */
    private static final class Joint implements SharedLevel.Statistics {
        private final List<DirectionScore> tests;
        private final PlacementScores scores;
        private final double[] values;
        private final double[] room;

        Joint(List<DirectionScore> tests, PlacementScores scores) {
            this.tests = tests;
            this.scores = scores;
            values = new double[scores.size()];
            room = new double[scores.size()];
        }

        @Override
        public int count() {
            return tests.size();
        }

        @Override
        public void draw(RandomGenerator random, double[] out) {
            scores.draw(random, values);
            for (int t = 0; t < out.length; t++) {
                out[t] = tests.get(t).along(values) / tests.get(t).sensitivity;
            }
        }

        @Override
        public void correlations(int test, double[] out) {
            DirectionScore own = tests.get(test);
            scores.covariances(own.first, own.direction, room, values);
            for (int t = 0; t < out.length; t++) {
                out[t] = tests.get(t).along(values) / (own.sensitivity * tests.get(t).sensitivity);
            }
        }
    }

    /** Sum along the direction of one value per score. */
    private double along(double[] values) {
        double sum = 0;
        for (int c = from; c < to; c++) {
            sum += direction[c] * values[first + c];
        }
        return sum;
    }

    /**
     * Chance that a reference off by so many stated deviations is beyond the limit: the offset stands in the place of
     * the random error that is part of the statistic's variance.
     */
    private static double chance(double deviations, double sensitivity, double limit) {
        double left = Math.sqrt(Math.max(1e-12, 1 - sensitivity * sensitivity));
        return NORMAL.cumulativeProbability((deviations * sensitivity - limit) / left);
    }

    /** Standard normal if the reference stands as stated; the sign is that of the shift or turn. */
    double statistic() {
        return score / sensitivity;
    }

    /** Size of the statistic beyond which the reference is off. */
    double limit() {
        return limit;
    }

    boolean raisesAlarm() {
        return Math.abs(statistic()) > limit;
    }

    /**
     * How much speaks for this test's shift rather than another's: twice the logarithm of the likelihood ratio at the
     * best size of the shift, and of the weight.
     */
    double evidence() {
        return statistic() * statistic() + 2 * Math.log(weight);
    }

    /** What it comes to that the cause is of the size that fits best. */
    Explanation explanation() {
        return reference == null
                ? cause().explanation(direction, score / (sensitivity * sensitivity), 1 / sensitivity, evidence())
                : Explanation.outright(Cause.REFERENCE_OFF, Collections.singletonList(reference().id()), -1, 0,
                        evidence());
    }

    /** The cause as it fits, given how nearly it is like every other test of the photo. */
    CauseFit fit(LargestCorrelation among) {
        return new CauseFit(explanation(), statistic(), limit(), explanation().std() * timesApart(among));
    }

    /** How many times less well its size is told if any one other cause, or other reference, may be the reason. */
    double timesApart(LargestCorrelation among) {
        double nearest = among.of(this);
        return 1 / Math.sqrt(Math.max(0, 1 - nearest * nearest));
    }

    /** Size of the correlation with another test. */
    double correlation(DirectionScore other, PlacementScores scores) {
        double shared = scores.covariance(first, direction, other.first, other.direction);
        return Math.abs(shared) / (sensitivity * other.sensitivity);
    }

    /**
     * Its normalised score as a vector: where two tests are of different references, their correlation is minus the
     * product of theirs.
     */
    double[] taken(PlacementScores scores) {
        double[] taken = scores.taken(first, direction);
        for (int k = 0; k < taken.length; k++) {
            taken[k] /= sensitivity;
        }
        return taken;
    }

    /** Whether another test is about the same reference or the same cause. */
    boolean isOfTheSame(DirectionScore other) {
        return reference == null ? other.cause != null && cause().isLike(other.cause)
                : other.reference != null && reference.id() == other.reference.id();
    }

    /** The size of shift or turn that fits best if only this one is off, by coordinate: mm, then rad. */
    double[] offset() {
        return scaled(score / (sensitivity * sensitivity));
    }

    /** Standard deviation of that size, by coordinate: mm, then rad. */
    double[] offsetStd() {
        return scaled(1 / sensitivity);
    }

    /**
     * The smallest shift or turn along this direction that is beyond the limit with the chance {@link #POWER}: Baarda's
     * minimal detectable bias ("A testing procedure for use in geodetic networks", 1968), by coordinate: mm, then rad.
     */
    double[] detectable() {
        double quantile = NORMAL.inverseCumulativeProbability(POWER);
        return scaled((limit + quantile * Math.sqrt(Math.max(0, 1 - sensitivity * sensitivity))) / sensitivity);
    }

    private double[] scaled(double deviations) {
        Placement placement = reference().placement();
        double[] out = new double[PlacementScores.COORDINATES];
        for (int c = 0; c < out.length; c++) {
            if (direction[c] != 0) {
                out[c] = deviations * direction[c] * (c < 3 ? placement.stdMm(c) : placement.stdRad());
            }
        }
        return out;
    }

    /** The coordinate of the placement tested where it is a single one; -1 for another direction. */
    int coordinate() {
        for (int c = 0; c < direction.length && reference != null; c++) {
            if (direction[c] == 1) {
                return c;
            }
        }
        return -1;
    }
}
