package org.cellgauge.internal.sampling;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.random.AbstractRandomGenerator;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.StateLayout;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;

class ProposalTest {
    private static final IntrinsicsPrior FOCAL_PRIOR =
            IntrinsicsPrior.focal(PinholeCamera.ideal(640, 480, 500, 500, 320, 240), 50);
    private static final StateLayout FOCAL = StateLayout.of(1, FOCAL_PRIOR, 0);
    private static final double[] SCALE_A = {4, 1, 0.5, 1, 2, -0.3, 0.5, -0.3, 0.25};
    private static final double[] SCALE_B = {0.5, 0, 0.1, 0, 1, 0, 0.1, 0, 3};
    private static final double[] MEAN_A = {1, -2, 30};
    private static final double[] MEAN_B = {-6, 4, 20};

    private static StudentTMixture two() {
        return new StudentTMixture(new double[][] {MEAN_A, MEAN_B}, new double[][] {SCALE_A, SCALE_B},
                new double[] {3, 1});
    }

    /** Density of a multivariate t with 5 degrees of freedom, without the constant of its dimension. */
    private static double t5(double[] x, double[] mean, double[] scale) {
        SimpleMatrix s = new SimpleMatrix(3, 3, true, scale);
        SimpleMatrix d = new SimpleMatrix(3, 1, true, x).minus(new SimpleMatrix(3, 1, true, mean));
        double squared = d.transpose().mult(s.invert()).mult(d).get(0);
        return Math.pow(1 + squared / 5, -(5 + 3) / 2.0) / Math.sqrt(s.determinant());
    }

    @Test
    void densityOfAMixtureIsTheWeightedSumOfItsComponents() {
        StudentTMixture mixture = two();
        RandomGenerator random = RandomStreams.of(1);
        for (int i = 0; i < 100; i++) {
            double[] x = {5 * random.nextGaussian(), 5 * random.nextGaussian(), 25 + 8 * random.nextGaussian()};
            double expected = Math.log(0.75 * t5(x, MEAN_A, SCALE_A) + 0.25 * t5(x, MEAN_B, SCALE_B));
            assertEquals(expected, mixture.logDensity(x), 1e-11);
            double[] shares = new double[2];
            mixture.responsibilities(shares);
            assertEquals(0.75 * t5(x, MEAN_A, SCALE_A) / Math.exp(expected), shares[0], 1e-11);
            assertEquals(1, shares[0] + shares[1], 1e-12);
        }
        // so far off that no density is a number: falls with the power of the distance, 5 degrees of freedom + 3
        double far = mixture.logDensity(new double[] {1e70, 0, 0});
        assertEquals(-8 * Math.log(10), mixture.logDensity(new double[] {1e71, 0, 0}) - far, 1e-9);
        assertEquals(0.75, mixture.weight(0), 1e-15);
        assertEquals(0.25, mixture.weight(1), 1e-15);
        assertArrayEquals(SCALE_A, mixture.scale(0), 1e-14);
        assertArrayEquals(MEAN_B, mixture.mean(1), 0);
        assertThrows(IllegalArgumentException.class, () -> new StudentTMixture(new double[][] {{0, 0}},
                new double[][] {{1, 2, 2, 1}}, new double[] {1}));
    }

    @Test
    void suggestionIsIndependentAndCorrectedByBothDensities() {
        StudentTMixture mixture = two();
        double[] to = new double[3];
        double[] from = {0, 1, 28};
        RandomGenerator random = RandomStreams.of(2);
        for (int i = 0; i < 50; i++) {
            double correction = mixture.propose(from, to, random);
            double expected = Math.log(0.75 * t5(from, MEAN_A, SCALE_A) + 0.25 * t5(from, MEAN_B, SCALE_B))
                    - Math.log(0.75 * t5(to, MEAN_A, SCALE_A) + 0.25 * t5(to, MEAN_B, SCALE_B));
            assertEquals(expected, correction, 1e-10);
        }
        assertArrayEquals(new double[] {0, 1, 28}, from, 0);
        // where the chain went on, stayed, or was put somewhere else
        for (int i = 0; i < 60; i++) {
            double[] at = i % 3 == 0 ? to.clone() : i % 3 == 1 ? from : new double[] {1, i, 20};
            System.arraycopy(at, 0, from, 0, 3);
            double correction = mixture.propose(from, to, random);
            assertEquals(two().logDensity(from) - two().logDensity(to), correction, 1e-12, "step " + i);
        }
        double[] other = new double[3];
        mixture.copy().propose(new double[3], other, RandomStreams.of(3));
        mixture.propose(from, to, RandomStreams.of(3));
        assertArrayEquals(to, other, 0);
    }

    @Test
    void drawsHaveTheMomentsOfTheDistribution() {
        StudentTMixture one = new StudentTMixture(new double[][] {MEAN_A}, new double[][] {SCALE_A}, new double[] {7});
        int n = 200_000;
        RandomGenerator random = RandomStreams.of(4);
        double[] x = new double[3];
        double[] sum = new double[3];
        double[] products = new double[9];
        for (int i = 0; i < n; i++) {
            one.draw(x, random);
            for (int a = 0; a < 3; a++) {
                sum[a] += x[a] - MEAN_A[a];
                for (int b = 0; b < 3; b++) {
                    products[3 * a + b] += (x[a] - MEAN_A[a]) * (x[b] - MEAN_A[b]);
                }
            }
        }
        for (int a = 0; a < 3; a++) {
            // variance 5/3 of the scale; five standard errors of a mean
            assertEquals(0, sum[a] / n, 5 * Math.sqrt(5.0 / 3 * SCALE_A[4 * a] / n));
            for (int b = 0; b < 3; b++) {
                double size = 5.0 / 3 * Math.sqrt(SCALE_A[4 * a] * SCALE_A[4 * b]);
                // the kurtosis of t5 is 9, so a variance has the relative error sqrt(8/n): 5 of them
                assertEquals(5.0 / 3 * SCALE_A[3 * a + b] / size, products[3 * a + b] / n / size,
                        5 * Math.sqrt(8.0 / n));
            }
        }
    }

    @Test
    void componentsAreDrawnByTheirWeights() {
        StudentTMixture mixture = new StudentTMixture(new double[][] {{-100}, {0}, {100}},
                new double[][] {{1}, {1}, {1}}, new double[] {1, 2, 5});
        int n = 40_000;
        int[] count = new int[3];
        RandomGenerator random = RandomStreams.of(5);
        double[] x = new double[1];
        for (int i = 0; i < n; i++) {
            mixture.draw(x, random);
            count[x[0] < -50 ? 0 : x[0] < 50 ? 1 : 2]++;
        }
        double[] share = {1 / 8.0, 2 / 8.0, 5 / 8.0};
        for (int k = 0; k < 3; k++) {
            assertEquals(share[k], count[k] / (double) n, 5 * Math.sqrt(share[k] * (1 - share[k]) / n));
        }
    }

    @Test
    void gaussianStepMovesItsCoordinatesAloneAndWrapsThem() {
        GaussianStep step = new GaussianStep("turn", 1, 2, 0.5, 2 * Math.PI);
        RandomGenerator random = RandomStreams.of(6);
        double[] from = {-50, 0.1, 6.2, 70};
        double[] to = new double[4];
        double square = 0;
        int below = 0;
        for (int i = 0; i < 20_000; i++) {
            assertEquals(0, step.propose(from, to, random), 0);
            assertEquals(-50, to[0], 0);
            assertEquals(70, to[3], 0);
            for (int k = 1; k < 3; k++) {
                assertTrue(to[k] >= 0 && to[k] < 2 * Math.PI);
                double moved = Math.IEEEremainder(to[k] - from[k], 2 * Math.PI);
                square += moved * moved;
            }
            below += to[1] > 3 ? 1 : 0;
        }
        // 40 000 squares of N(0, 0.5²): relative error sqrt(2/40 000)
        assertEquals(0.25, square / 40_000, 0.25 * 5 * Math.sqrt(2.0 / 40_000));
        assertTrue(below > 0);
        assertEquals("turn", step.name());
    }

    @Test
    void anAngleJustBelowZeroIsNotWrappedToTheWholeTurn() {
        GaussianStep step = new GaussianStep("tiny", 0, 1, 1, 2 * Math.PI);
        double[] to = new double[1];
        step.propose(new double[1], to, new Scripted(-1e-17));
        assertEquals(0, to[0], 0);
    }

    @Test
    void thesisMixtureHasItsFiveNamedSteps() {
        assertEquals(4, ThesisMixture.proposals(StateLayout.of(1, IntrinsicsPrior.KNOWN, 0),
                IntrinsicsPrior.KNOWN).size());
        List<String> names = new ArrayList<>();
        double[] from = {418, 106, 1070, 3, 3, 3, 581, 581};
        double[][] stds = {{0, 0, 0, 0.1, 0.1, 0.1, 0, 0}, {10, 10, 10, 0, 0, 0, 0, 0}, {1, 1, 1, 0, 0, 0, 0, 0},
            {0, 0, 0, 0.01, 0.01, 0.01, 0, 0}, {0, 0, 0, 0, 0, 0, 15, 15}};
        RandomGenerator random = RandomStreams.of(7);
        int n = 5000;
        int which = 0;
        for (Proposal proposal : ThesisMixture.proposals(FOCAL, FOCAL_PRIOR)) {
            names.add(proposal.name());
            double[] squares = new double[8];
            double[] to = new double[8];
            for (int i = 0; i < n; i++) {
                assertEquals(0, proposal.propose(from, to, random), 0);
                for (int k = 0; k < 8; k++) {
                    squares[k] += (to[k] - from[k]) * (to[k] - from[k]) / n;
                }
            }
            for (int k = 0; k < 8; k++) {
                assertEquals(stds[which][k], Math.sqrt(squares[k]), stds[which][k] * 5 / Math.sqrt(2.0 * n));
            }
            which++;
        }
        assertEquals(List.of("rotation 0.1 rad", "translation 10 mm", "translation 1 mm", "rotation 0.01 rad",
                "focal length 15 px"), names);
    }

    /** Columns of the factor that a step uses, read off by feeding unit vectors instead of Gaussians. */
    private static double[] covarianceInUse(AdaptiveStep step, int n) {
        double[] covariance = new double[n * n];
        for (int k = 0; k < n; k++) {
            double[] unit = new double[n];
            unit[k] = Math.sqrt(n) / 2.38;
            double[] to = new double[n];
            assertEquals(0, step.propose(new double[n], to, new Scripted(unit)), 0);
            for (int a = 0; a < n; a++) {
                for (int b = 0; b < n; b++) {
                    covariance[n * a + b] += to[a] * to[b];
                }
            }
        }
        return covariance;
    }

    @Test
    void adaptiveStepStartsAtItsGuessAndLearnsTheCovarianceOfTheDraws() {
        AdaptiveStep step = new AdaptiveStep(new double[] {1e-6, 0, 0, 0, 1e-6, 0, 0, 0, 1e-6}, 3);
        assertEquals(1e-6, covarianceInUse(step, 3)[0], 1e-18);
        step = new AdaptiveStep(new double[] {1e-6, 0, 0, 0, 1e-6, 0, 0, 0, 1e-6}, 3);
        RandomGenerator random = RandomStreams.of(8);
        double[] l = SCALE_A.clone();
        Cholesky.factor(l, 3);
        double[] to = new double[3];
        // far away at first, as a chain before it has found the bulk; then independent draws
        for (int i = 0; i < 32_300; i++) {
            double[] z = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
            double away = i < 500 ? 1000 : 0;
            double[] x = {l[0] * z[0] + away, l[3] * z[0] + l[4] * z[1], l[6] * z[0] + l[7] * z[1] + l[8] * z[2]};
            step.propose(x, to, random);
        }
        step.freeze();
        assertFalse(step.learning());
        double[] learnt = covarianceInUse(step, 3);
        for (int a = 0; a < 3; a++) {
            for (int b = 0; b < 3; b++) {
                double size = Math.sqrt(SCALE_A[4 * a] * SCALE_A[4 * b]);
                // the draws from 16 000 to 32 000 stand behind it: four errors sqrt(2/16 000) of a variance
                assertEquals(SCALE_A[3 * a + b] / size, learnt[3 * a + b] / size, 4 * Math.sqrt(2.0 / 16_000));
            }
        }
        for (int i = 0; i < 5000; i++) {
            step.propose(new double[] {1e6 * random.nextGaussian(), 0, 0}, to, random);
        }
        assertArrayEquals(learnt, covarianceInUse(step, 3), 0);
    }

    @Test
    void oneAdaptiveStepInTwentyIsShort() {
        AdaptiveStep step = new AdaptiveStep(new double[] {1}, 1);
        step.freeze();
        RandomGenerator random = RandomStreams.of(9);
        double[] to = new double[1];
        double square = 0;
        int n = 100_000;
        for (int i = 0; i < n; i++) {
            step.propose(new double[1], to, random);
            square += to[0] * to[0] / n;
        }
        double expected = 2.38 * 2.38 * (0.95 + 0.05 * 0.01);
        // kurtosis of the mixture is 3 / 0.95: relative error sqrt(2.2/n)
        assertEquals(expected, square, expected * 5 * Math.sqrt(2.2 / n));
    }

    /** Gives the numbers it was made with as Gaussians, and one half as uniforms. */
    private static final class Scripted extends AbstractRandomGenerator {
        private final double[] gaussians;
        private int next;

        Scripted(double... gaussians) {
            this.gaussians = gaussians;
        }

        @Override
        public void setSeed(long seed) {
            throw new UnsupportedOperationException();
        }

        @Override
        public double nextDouble() {
            return 0.5;
        }

        @Override
        public double nextGaussian() {
            return gaussians[next++];
        }
    }
}
