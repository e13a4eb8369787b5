package org.cellgauge.internal.statistics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.apache.commons.math3.stat.correlation.Covariance;
import org.apache.commons.math3.stat.descriptive.moment.Mean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RunningMomentsTest {
    @Test
    void momentsOfThreePointsAreThoseByHand() {
        RunningMoments m = new RunningMoments(2);
        m.add(new double[] {1, 10});
        m.add(new double[] {2, 14});
        m.add(new double[] {6, 12});
        assertEquals(3, m.count());
        assertArrayEquals(new double[] {3, 12}, m.mean(), 1e-15);
        // deviations (-2,-2), (-1,2), (3,0): variances 14/2 and 8/2, covariance (4-2+0)/2
        assertEquals(7, m.covariance(0, 0), 1e-14);
        assertEquals(4, m.covariance(1, 1), 1e-14);
        assertEquals(1, m.covariance(0, 1), 1e-14);
        assertEquals(1, m.covariance(1, 0), 1e-14);
        assertEquals(2, m.std(1), 1e-14);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 6, 9})
    void streamAgreesWithTwoPassCovarianceOfCommonsMath(int d) {
        double[][] draws = correlated(500, d, 11 + d);
        RunningMoments m = new RunningMoments(d);
        for (double[] x : draws) {
            m.add(x);
        }
        for (int i = 0; i < d; i++) {
            double[] column = column(draws, i);
            assertEquals(new Mean().evaluate(column), m.mean(i), 1e-9);
            for (int j = 0; j < d; j++) {
                double expected = new Covariance().covariance(column, column(draws, j), true);
                assertEquals(expected, m.covariance()[i][j], 1e-10 * (1 + Math.abs(expected)));
                assertEquals(m.covariance()[i][j], m.covariance(i, j), 0);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 137, 499, 500})
    void mergedPartsEqualTheWhole(int cut) {
        double[][] draws = correlated(500, 4, 3);
        RunningMoments all = new RunningMoments(4);
        RunningMoments first = new RunningMoments(4);
        RunningMoments second = new RunningMoments(4);
        for (int n = 0; n < draws.length; n++) {
            all.add(draws[n]);
            (n < cut ? first : second).add(draws[n]);
        }
        double[] secondMean = second.mean();
        first.merge(second);
        assertEquals(500, first.count());
        assertArrayEquals(all.mean(), first.mean(), 1e-9);
        for (int i = 0; i < 4; i++) {
            assertArrayEquals(all.covariance()[i], first.covariance()[i], 1e-9);
        }
        assertArrayEquals(secondMean, second.mean(), 0, "the merged stream is left as it was");
    }

    @Test
    void mergingAStreamWithItselfCountsEveryDrawTwice() {
        RunningMoments m = new RunningMoments(1);
        m.add(new double[] {1});
        m.add(new double[] {3});
        m.merge(m);
        assertEquals(4, m.count());
        assertEquals(2, m.mean(0), 0);
        // deviations -1, 1, -1, 1
        assertEquals(4.0 / 3, m.covariance(0, 0), 1e-15);
    }

    @Test
    void largeOffsetDoesNotCancelTheVariance() {
        // 1e9 + {4, 7, 13, 16}: variance 30, lost completely by sums of squares in double precision
        RunningMoments m = new RunningMoments(1);
        for (double x : new double[] {4, 7, 13, 16}) {
            m.add(new double[] {1e9 + x});
        }
        assertEquals(30, m.covariance(0, 0), 1e-6);
    }

    @Test
    void stdOfConstantSeriesIsZero() {
        RunningMoments m = new RunningMoments(2);
        for (int i = 0; i < 10; i++) {
            m.add(new double[] {0.1, -1e7 / 3});
        }
        assertEquals(0, m.std(0), 0);
        assertEquals(0, m.std(1), 0);
    }

    @Test
    void offsetSelectsTheDrawWithinALongerArray() {
        RunningMoments m = new RunningMoments(2);
        m.add(new double[] {99, 1, 2, 99}, 1);
        assertArrayEquals(new double[] {1, 2}, m.mean(), 0);
        assertThrows(IllegalArgumentException.class, () -> m.add(new double[] {1, 2, 3}, 2));
        assertThrows(IllegalArgumentException.class, () -> m.add(new double[] {1, 2, 3}, -1));
        assertThrows(IllegalArgumentException.class, () -> m.add(new double[] {1, 2, 3}));
        assertEquals(1, m.count(), "a refused draw is not counted");
    }

    @Test
    void momentsThatDoNotExistAreNaN() {
        RunningMoments m = new RunningMoments(1);
        assertTrue(Double.isNaN(m.mean(0)));
        assertTrue(Double.isNaN(m.mean()[0]));
        m.add(new double[] {5});
        assertEquals(5, m.mean(0), 0);
        assertTrue(Double.isNaN(m.std(0)));
        assertTrue(Double.isNaN(m.covariance()[0][0]));
    }

    @Test
    void nonFiniteDrawSpoilsItsOwnComponentOnly() {
        RunningMoments m = new RunningMoments(2);
        m.add(new double[] {1, 1});
        m.add(new double[] {Double.NaN, 2});
        m.add(new double[] {1, 3});
        assertTrue(Double.isNaN(m.mean(0)));
        assertTrue(Double.isNaN(m.covariance(0, 1)));
        assertEquals(1, m.std(1), 1e-15);
    }

    @Test
    void copyIsIndependentAndClearForgets() {
        RunningMoments m = new RunningMoments(1);
        m.add(new double[] {1});
        m.add(new double[] {3});
        RunningMoments copy = m.copy();
        m.add(new double[] {100});
        assertEquals(2, copy.count());
        assertEquals(2, copy.mean(0), 0);
        assertEquals(Math.sqrt(2), copy.std(0), 1e-15);
        copy.clear();
        copy.add(new double[] {7});
        copy.add(new double[] {7});
        assertEquals(7, copy.mean(0), 0);
        assertEquals(0, copy.std(0), 0);
        assertEquals(3, m.count());
    }

    @Test
    void wrongShapesAreRefused() {
        RunningMoments m = new RunningMoments(2);
        assertThrows(IllegalArgumentException.class, () -> new RunningMoments(0));
        assertThrows(IllegalArgumentException.class, () -> m.merge(new RunningMoments(3)));
        assertThrows(IllegalArgumentException.class, () -> m.mean(new double[3]));
        assertThrows(IllegalArgumentException.class, () -> m.covariance(new double[2][3]));
        assertThrows(IllegalArgumentException.class, () -> m.covariance(new double[3][2]));
        assertThrows(IllegalArgumentException.class, () -> m.std(2));
        assertThrows(IllegalArgumentException.class, () -> m.mean(-1));
    }

    /** Correlated draws: a random mixing matrix applied to independent normal ones, shifted away from zero. */
    private static double[][] correlated(int n, int d, int seed) {
        RandomGenerator random = new Well19937c(seed);
        double[][] mix = new double[d][d];
        for (double[] row : mix) {
            for (int j = 0; j < d; j++) {
                row[j] = random.nextGaussian();
            }
        }
        double[][] draws = new double[n][d];
        double[] z = new double[d];
        for (double[] x : draws) {
            for (int j = 0; j < d; j++) {
                z[j] = random.nextGaussian();
            }
            for (int i = 0; i < d; i++) {
                x[i] = 100 * i;
                for (int j = 0; j < d; j++) {
                    x[i] += mix[i][j] * z[j];
                }
            }
        }
        return draws;
    }

    private static double[] column(double[][] draws, int i) {
        double[] out = new double[draws.length];
        for (int n = 0; n < out.length; n++) {
            out[n] = draws[n][i];
        }
        return out;
    }
}
