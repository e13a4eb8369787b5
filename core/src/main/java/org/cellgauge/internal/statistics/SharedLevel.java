package org.cellgauge.internal.statistics;

import java.util.Arrays;
import org.apache.commons.math3.random.RandomGenerator;

/**
 * Limits of many correlated tests that share one level of false alarms.
 *
 * <p>Each statistic is standard normal if there is nothing to find, and raises an alarm when it is beyond its limit to
 * either side. Bonferroni's inequality gives every test its part of the level and takes no notice of how much alarms
 * coincide; here the limits are lowered until the chance of any alarm is the whole level. That chance is estimated by
 * importance sampling from the tests' own tails (Naiman and Priebe, "Computing scan statistic p values using importance
 * sampling, with applications to genetics and medical image analysis", Journal of Computational and Graphical
 * Statistics 2001, section 2): with p_j the chance of test j alone,
 *
 * <pre>P(any) = sum_j p_j E[1 / number of alarms], j drawn with chance p_j / sum p, the draw given an alarm of j,</pre>
 *
 * whose relative error is that of a mean of values between 0 and 1, however rare the alarm. Time is proportional to the
 * tests, and memory too.
 */
public final class SharedLevel {
    /** The relative error of the level reached is then about 1.5 %. */
    private static final int DRAWS = 1000;
    private static final int MOST_ROUNDS = 50;
    private static final double AGREEMENT = 1e-4;

    private SharedLevel() {
    }

    /** Statistics of tests that are jointly normal, each standard normal. */
    public interface Statistics {
        /**
         * Number of tests.
         *
         * @return at least 1
         */
        int count();

        /**
         * Draws all statistics.
         *
         * @param random source of randomness
         * @param out receives one value per test
         */
        void draw(RandomGenerator random, double[] out);

        /**
         * Correlations of one test with all.
         *
         * @param test its index
         * @param out receives one value per test
         */
        void correlations(int test, double[] out);
    }

    /**
     * The limits.
     *
     * @param of the tests' statistics
     * @param weights by which the tests share the level, positive; only their proportions count
     * @param level chance of any alarm, in (0, 1)
     * @param random source of randomness; the same numbers give the same limits
     * @return for each test the size of its statistic beyond which it raises an alarm
     * @throws IllegalArgumentException if there is no test, a weight is not positive or the level is out of range
     */
    public static double[] limits(Statistics of, double[] weights, double level, RandomGenerator random) {
        int tests = of.count();
        double sum = 0;
        double heaviest = 0;
        for (double weight : weights) {
            if (!(weight > 0 && Double.isFinite(weight))) {
                throw new IllegalArgumentException("weights must be positive, not " + weight);
            }
            sum += weight;
            heaviest = Math.max(heaviest, weight);
        }
        if (tests == 0 || weights.length != tests || !(level > 0 && level < 1)) {
            throw new IllegalArgumentException("needs as many weights as tests and a level between 0 and 1");
        }
        // Bonferroni's limits first
        double scale = level / sum;
        // where the heaviest test alone has the whole level
        double widest = level / heaviest;
        Simulation simulation = new Simulation(of, weights, sum, scale, widest, random);
        double[] limits = new double[tests];
        for (int round = 0; round < MOST_ROUNDS; round++) {
            double chance = simulation.chance(scale, limits);
            if (Math.abs(chance / level - 1) < AGREEMENT) {
                break;
            }
            scale = Math.min(widest, scale * (level / chance));
        }
        return limits;
    }

    /**
     * Draws that stay the same while the limits move, so that the chance is a smooth function of them. Of each draw
     * only those tests are kept that raise an alarm at any of the limits between the first and the widest: a few, so
     * that what a draw costs is one look at every test.
     */
    private static final class Simulation {
        private final double[] weights;
        private final int[] chosen = new int[DRAWS];
        private final double[] tail = new double[DRAWS];
        private final double[] own = new double[DRAWS];
        private final Others[] others = new Others[DRAWS];

        Simulation(Statistics of, double[] weights, double sumOfWeights, double scale, double widest,
                RandomGenerator random) {
            this.weights = weights;
            int tests = of.count();
            double[] lowest = new double[tests];
            for (int l = 0; l < tests; l++) {
                lowest[l] = limit(widest * weights[l]);
            }
            double[] t = new double[tests];
            double[] correlation = new double[tests];
            int known = -1;
            int at = 0;
            double upTo = weights[0];
            for (int i = 0; i < DRAWS; i++) {
                // which test is given its alarm: in strata, so that each has its share
                double place = (i + random.nextDouble()) / DRAWS * sumOfWeights;
                while (upTo < place && at < tests - 1) {
                    upTo += weights[++at];
                }
                chosen[i] = at;
                tail[i] = 1 - random.nextDouble();
                of.draw(random, t);
                if (known != at) {
                    of.correlations(at, correlation);
                    known = at;
                }
                own[i] = t[at];
                others[i] = new Others(t, correlation, lowest, at, given(i, scale), given(i, widest));
            }
        }

        /** What the chosen test of a draw is short of its alarm, which by symmetry may be taken to be positive. */
        private double given(int draw, double scale) {
            return limit(Math.min(1, scale * weights[chosen[draw]]) * tail[draw]) - own[draw];
        }

        /**
         * Chance of any alarm where test j alone raises one with the chance scale * weights[j]; fills in the limits.
         */
        double chance(double scale, double[] limits) {
            double all = 0;
            for (int j = 0; j < limits.length; j++) {
                limits[j] = limit(scale * weights[j]);
                all += Math.min(1, scale * weights[j]);
            }
            double mean = 0;
            for (int i = 0; i < DRAWS; i++) {
                mean += 1.0 / (1 + others[i].alarms(given(i, scale), limits)) / DRAWS;
            }
            return all * mean;
        }
    }

    /** The tests of one draw that may raise an alarm beside the chosen one. */
    private static final class Others {
        /** Rounding must not lose an alarm. */
        private static final double SLACK = 1e-9;

        private final int[] tests;
        private final double[] statistics;
        private final double[] correlations;

        /** Statistics move in a straight line from what is given first to what is given last. */
        Others(double[] statistics, double[] correlations, double[] lowest, int chosen, double first, double last) {
            int count = 0;
            for (int l = 0; l < lowest.length; l++) {
                count += isCandidate(statistics[l], correlations[l], lowest[l], first, last) ? 1 : 0;
            }
            int[] found = new int[count];
            int next = 0;
            for (int l = 0; l < lowest.length; l++) {
                if (isCandidate(statistics[l], correlations[l], lowest[l], first, last) && l != chosen) {
                    found[next++] = l;
                }
            }
            tests = Arrays.copyOf(found, next);
            this.statistics = new double[next];
            this.correlations = new double[next];
            for (int k = 0; k < next; k++) {
                this.statistics[k] = statistics[tests[k]];
                this.correlations[k] = correlations[tests[k]];
            }
        }

        private static boolean isCandidate(double statistic, double correlation, double lowest, double first,
                double last) {
            return Math.max(Math.abs(statistic + correlation * first), Math.abs(statistic + correlation * last))
                    > lowest - SLACK;
        }

        int alarms(double given, double[] limits) {
            int alarms = 0;
            for (int k = 0; k < tests.length; k++) {
                alarms += Math.abs(statistics[k] + correlations[k] * given) > limits[tests[k]] ? 1 : 0;
            }
            return alarms;
        }
    }

    /** Size that a standard normal value exceeds, to either side, with the given chance. */
    private static double limit(double chance) {
        return chance >= 1 ? 0 : -NormalQuantile.of(chance / 2);
    }
}
