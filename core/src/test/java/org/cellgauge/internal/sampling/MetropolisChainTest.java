package org.cellgauge.internal.sampling;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.StateLayout;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.statistics.ChainDiagnostics;
import org.junit.jupiter.api.Test;

class MetropolisChainTest {
    private static final IntrinsicsPrior FOCAL_PRIOR =
            IntrinsicsPrior.focal(PinholeCamera.ideal(640, 480, 500, 500, 320, 240), 50);
    private static final StateLayout FOCAL = StateLayout.of(1, FOCAL_PRIOR, 0);
    private static LogDensity density(int dimension, ToDoubleFunction<double[]> log) {
        return new LogDensity() {
            @Override
            public int dimension() {
                return dimension;
            }

            @Override
            public double at(double[] x) {
                return log.applyAsDouble(x);
            }
        };
    }

    private static LogDensity normal(int n) {
        return density(n, x -> {
            double s = 0;
            for (double v : x) {
                s += v * v;
            }
            return -0.5 * s;
        });
    }

    private static double[] identity(int n) {
        double[] c = new double[n * n];
        for (int i = 0; i < n; i++) {
            c[i * (n + 1)] = 1;
        }
        return c;
    }

    /** Four chains of a quantity of the state; the proposals are made anew for each. */
    private static double[][] run(LogDensity density, Function<Integer, List<? extends Proposal>> proposals,
            double[] start, int warmup, int draws, long seed, ToDoubleFunction<double[]> quantity) {
        double[][] out = new double[4][draws];
        for (int c = 0; c < 4; c++) {
            List<? extends Proposal> own = proposals.apply(c);
            MetropolisChain chain = new MetropolisChain(density, own, start, RandomStreams.of(seed, c));
            for (int i = 0; i < warmup; i++) {
                chain.step();
            }
            for (Proposal p : own) {
                if (p instanceof AdaptiveStep) {
                    ((AdaptiveStep) p).freeze();
                }
            }
            for (int i = 0; i < draws; i++) {
                chain.step();
                out[c][i] = quantity.applyAsDouble(chain.current());
            }
        }
        return out;
    }

    /** Mean and deviation within five Monte Carlo standard errors of the truth, which are themselves small. */
    private static void assertMoments(double mean, double std, double[][] chains, double largestError) {
        ChainDiagnostics d = ChainDiagnostics.of(chains);
        assertTrue(d.rHat() < 1.02, "R-hat " + d.rHat());
        assertTrue(d.mcseMean() < largestError && d.mcseSd() < largestError, d.mcseMean() + ", " + d.mcseSd());
        assertEquals(mean, d.mean(), 5 * d.mcseMean());
        assertEquals(std, d.std(), 5 * d.mcseSd());
    }

    @Test
    void everyProposalLeavesTheStandardNormalAsItIs() {
        double[] far = {3, -3, 3};
        List<Function<Integer, List<? extends Proposal>>> all = List.of(
                c -> List.of(new GaussianStep("all", 0, 3, 1.4, 0)),
                c -> List.of(new GaussianStep("first", 0, 1, 2, 0), new GaussianStep("others", 1, 2, 1.5, 0)),
                c -> List.of(new StudentTMixture(new double[][] {{0.5, -0.5, 0}}, new double[][] {identity(3)},
                        new double[] {1})),
                c -> List.of(new StudentTMixture(new double[][] {{1, 0, 0}, {-1, 1, 0}},
                        new double[][] {identity(3), {2, 0.5, 0, 0.5, 1, 0, 0, 0, 3}}, new double[] {2, 1}),
                        new GaussianStep("all", 0, 3, 1.4, 0)),
                c -> List.of(new AdaptiveStep(new double[] {1e-4, 0, 0, 0, 25, 0, 0, 0, 1}, 3)));
        for (int p = 0; p < all.size(); p++) {
            for (int i = 0; i < 3; i++) {
                int coordinate = i;
                assertMoments(0, 1, run(normal(3), all.get(p), far, 4000, 10_000, 20 + p, x -> x[coordinate]), 0.06);
            }
            // a product tells correlation: mean 0, deviation 1
            assertMoments(0, 1, run(normal(3), all.get(p), far, 4000, 10_000, 30 + p, x -> x[0] * x[1]), 0.08);
        }
    }

    @Test
    void bothModesOfABimodalTargetGetTheirShare() {
        LogDensity bimodal = density(2, x -> {
            double a = Math.log(0.3) - 0.5 * (x[0] + 3) * (x[0] + 3);
            double b = Math.log(0.7) - 0.5 * (x[0] - 3) * (x[0] - 3);
            double m = Math.max(a, b);
            return m + Math.log(Math.exp(a - m) + Math.exp(b - m)) - 0.5 * x[1] * x[1];
        });
        Function<Integer, List<? extends Proposal>> walk = c -> List.of(new GaussianStep("walk", 0, 2, 4, 0));
        Function<Integer, List<? extends Proposal>> independence = c -> List.of(new StudentTMixture(
                new double[][] {{-3, 0}, {3, 0}}, new double[][] {identity(2), identity(2)}, new double[] {1, 1}));
        for (Function<Integer, List<? extends Proposal>> proposals : List.of(walk, independence)) {
            // 0.7 · 3 - 0.3 · 3; 1 + 9 - 1.2²
            assertMoments(1.2, Math.sqrt(10 - 1.44), run(bimodal, proposals, new double[2], 500, 20_000, 41, x -> x[0]),
                    0.1);
            double tail = new org.apache.commons.math3.distribution.NormalDistribution().cumulativeProbability(-3);
            double left = 0.3 * (1 - tail) + 0.7 * tail;
            assertMoments(left, Math.sqrt(left * (1 - left)),
                    run(bimodal, proposals, new double[2], 500, 20_000, 42, x -> x[0] < 0 ? 1 : 0), 0.02);
        }
    }

    @Test
    void impossiblePointsAreNeverTaken() {
        LogDensity exponential = density(1, x -> x[0] < 0 ? Double.NEGATIVE_INFINITY : -x[0]);
        double[][] draws = run(exponential, c -> List.of(new GaussianStep("walk", 0, 1, 2, 0)), new double[] {1}, 200,
                20_000, 43, x -> x[0]);
        assertMoments(1, 1, draws, 0.05);
        for (double[] chain : draws) {
            for (double x : chain) {
                assertTrue(x >= 0);
            }
        }
        LogDensity withNan = density(1, x -> x[0] < 0 ? Double.NaN : -x[0]);
        assertMoments(1, 1, run(withNan, c -> List.of(new GaussianStep("walk", 0, 1, 2, 0)), new double[] {1}, 200,
                20_000, 44, x -> x[0]), 0.05);
    }

    @Test
    void stepsTowardsFourStatesVisitEachByItsProbability() {
        double[] probability = {0.1, 0.2, 0.3, 0.4};
        LogDensity discrete = density(1, x -> x[0] < 0 || x[0] >= 4 ? Double.NEGATIVE_INFINITY
                : Math.log(probability[(int) x[0]]));
        for (int k = 0; k < 4; k++) {
            int state = k;
            double p = probability[k];
            assertMoments(p, Math.sqrt(p * (1 - p)), run(discrete, c -> List.of(new GaussianStep("walk", 0, 1, 1.5, 0)),
                    new double[] {0.5}, 100, 20_000, 45, x -> (int) x[0] == state ? 1 : 0), 0.02);
        }
    }

    /**
     * Steps that multiply by a log-normal factor reach each point with a density that falls with its distance
     * from 0.
     */
    @Test
    void correctionOfAnAsymmetricProposalIsApplied() {
        Proposal factor = new Proposal() {
            @Override
            public String name() {
                return "factor";
            }

            @Override
            public double propose(double[] from, double[] to, RandomGenerator random) {
                to[0] = from[0] * Math.exp(1.5 * random.nextGaussian());
                return Math.log(to[0]) - Math.log(from[0]);
            }
        };
        LogDensity exponential = density(1, x -> -x[0]);
        assertMoments(1, 1, run(exponential, c -> List.of(factor), new double[] {1}, 200, 20_000, 46, x -> x[0]), 0.05);
    }

    @Test
    void everySuggestionIsCountedOnceAndTheCurrentPointNeverEvaluatedAgain() {
        int[] evaluations = new int[1];
        LogDensity counting = density(8, x -> {
            evaluations[0]++;
            return normal(8).at(x);
        });
        MetropolisChain chain = new MetropolisChain(counting, ThesisMixture.proposals(FOCAL, FOCAL_PRIOR),
                new double[8],
                RandomStreams.of(47));
        int steps = 5000;
        int accepted = 0;
        for (int i = 0; i < steps; i++) {
            double[] before = chain.current().clone();
            if (chain.step()) {
                accepted++;
            } else {
                assertArrayEquals(before, chain.current(), 0);
            }
            assertEquals(normal(8).at(chain.current()), chain.logDensity(), 0);
        }
        assertEquals(steps + 1, evaluations[0]);
        long total = 0;
        long acceptedTotal = 0;
        for (AcceptanceCount count : chain.acceptance()) {
            total += count.accepted() + count.rejected();
            acceptedTotal += count.accepted();
            // each of five proposals is as likely as the others: five standard errors of a binomial share
            assertEquals(0.2, (count.accepted() + count.rejected()) / (double) steps, 5 * Math.sqrt(0.16 / steps));
        }
        assertEquals(steps, total);
        assertEquals(accepted, acceptedTotal);
        assertEquals(5, chain.acceptance().size());
        assertEquals("rotation 0.1 rad", chain.acceptance().get(0).proposal());
    }

    @Test
    void countsAddAndGiveTheirShare() {
        AcceptanceCount sum = new AcceptanceCount("a", 3, 5).plus(new AcceptanceCount("a", 1, 7));
        assertEquals(4, sum.accepted());
        assertEquals(12, sum.rejected());
        assertEquals(0.25, sum.rate(), 0);
        assertTrue(Double.isNaN(new AcceptanceCount("a", 0, 0).rate()));
    }

    @Test
    void chainThatCouldNeverMoveIsRefused() {
        List<Proposal> walk = List.of(new GaussianStep("walk", 0, 1, 1, 0));
        for (double bad : new double[] {Double.NaN, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY}) {
            assertThrows(IllegalStateException.class,
                    () -> new MetropolisChain(density(1, x -> bad), walk, new double[1], RandomStreams.of(1)));
        }
        double[] level = {0};
        MetropolisChain chain = new MetropolisChain(density(1, x -> level[0]), walk, new double[1],
                RandomStreams.of(1));
        level[0] = -5;
        assertTrue(chain.densityChanged(new double[] {3}));
        assertEquals(-5, chain.logDensity(), 0);
        assertEquals(0, chain.current()[0], 0);
        level[0] = Double.NaN;
        assertFalse(chain.densityChanged(new double[] {3}));
    }

    @Test
    void chainThatLosesItsDensityGoesOnFromAnotherPoint() {
        double[] from = {0};
        MetropolisChain chain = new MetropolisChain(density(1, x -> x[0] < from[0] ? Double.NEGATIVE_INFINITY : -x[0]),
                List.of(new GaussianStep("walk", 0, 1, 1, 0)), new double[1], RandomStreams.of(1));
        from[0] = 2;
        double[] start = {3};
        assertTrue(chain.densityChanged(start));
        start[0] = 99;
        assertEquals(3, chain.current()[0], 0);
        assertEquals(-3, chain.logDensity(), 0);
        for (int i = 0; i < 50; i++) {
            chain.step();
            assertTrue(chain.current()[0] >= 2);
        }
    }

    @Test
    void startIsCopiedAndSeedsRepeat() {
        double[] start = {0.5, 0.5};
        List<Proposal> walk = List.of(new GaussianStep("walk", 0, 2, 1, 0));
        MetropolisChain a = new MetropolisChain(normal(2), walk, start, RandomStreams.of(9, 1));
        MetropolisChain b = new MetropolisChain(normal(2), walk, start, RandomStreams.of(9, 1));
        start[0] = 99;
        for (int i = 0; i < 200; i++) {
            assertEquals(a.step(), b.step());
        }
        assertArrayEquals(a.current(), b.current(), 0);
        assertTrue(Math.abs(a.current()[0]) < 10);
    }

    @Test
    void tuningApproachesAShiftedAndScaledTarget() {
        LogDensity target = density(3, x -> -0.5 * (Math.pow((x[0] - 4) / 0.3, 2) + Math.pow((x[1] + 3) / 2, 2)
                + Math.pow((x[2] - x[1]) / 0.5, 2)));
        StudentTMixture start = new StudentTMixture(new double[][] {new double[3]}, new double[][] {identity(3)},
                new double[] {1});
        double before = efficiency(target, start);
        ImportanceTuning tuning = ImportanceTuning.tune(target, start, 3000, RandomStreams.of(50));
        double after = efficiency(target, tuning.proposal());
        assertTrue(before < 0.02, "before " + before);
        // a t of 5 degrees of freedom with the target's own covariance as its scale has 0.65 in three dimensions
        assertTrue(after > 0.5, "after " + after);
        assertEquals(after, tuning.efficiency(), 0.1);
    }

    @Test
    void tuningOfAMixtureKeepsBothModes() {
        LogDensity target = density(1, x -> Math.log(Math.exp(-0.5 * Math.pow((x[0] + 20) / 0.5, 2)) / 0.5
                + 3 * Math.exp(-0.5 * Math.pow((x[0] - 20) / 2, 2)) / 2));
        StudentTMixture start = new StudentTMixture(new double[][] {{-21}, {22}}, new double[][] {{1}, {1}},
                new double[] {1, 1});
        ImportanceTuning tuning = ImportanceTuning.tune(target, start, 2000, RandomStreams.of(51));
        StudentTMixture tuned = tuning.proposal();
        double left = 0;
        for (int k = 0; k < tuned.components(); k++) {
            left += tuned.mean(k)[0] < 0 ? tuned.weight(k) : 0;
        }
        // shares 1/4 and 3/4, from 2000 weighted draws
        assertEquals(0.25, left, 0.08);
        assertTrue(efficiency(target, tuned) > 0.6);
    }

    @Test
    void targetThatNoDrawMeetsHasNoEfficiency() {
        StudentTMixture start = new StudentTMixture(new double[][] {{0}}, new double[][] {{1}}, new double[] {1});
        ImportanceTuning tuning = ImportanceTuning.tune(density(1, x -> Double.NEGATIVE_INFINITY), start, 100,
                RandomStreams.of(52));
        assertEquals(0, tuning.efficiency(), 0);
    }

    /** 1 / (N sum w²) of 20 000 fresh importance draws. */
    private static double efficiency(LogDensity target, StudentTMixture mixture) {
        int n = 20_000;
        RandomGenerator random = RandomStreams.of(53);
        double[] x = new double[target.dimension()];
        double[] log = new double[n];
        double largest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < n; i++) {
            mixture.draw(x, random);
            log[i] = target.at(x) - mixture.logDensity(x);
            largest = Math.max(largest, log[i]);
        }
        double sum = 0;
        double squares = 0;
        for (double l : log) {
            double w = Math.exp(l - largest);
            sum += w;
            squares += w * w;
        }
        return sum * sum / squares / n;
    }
}
