package org.cellgauge.internal.statistics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Limits of tests that share a level, against cases that are known without simulation. */
class SharedLevelTest {
    private static final NormalDistribution NORMAL = new NormalDistribution(null, 0, 1);

    /** Statistics as products of rows of length 1 with independent standard normal numbers. */
    private static double[] limits(double[][] rows, double[] weights, double level, RandomGenerator random) {
        return SharedLevel.limits(new SharedLevel.Statistics() {
            @Override
            public int count() {
                return rows.length;
            }

            @Override
            public void draw(RandomGenerator source, double[] out) {
                double[] z = new double[rows[0].length];
                for (int k = 0; k < z.length; k++) {
                    z[k] = source.nextGaussian();
                }
                for (int i = 0; i < rows.length; i++) {
                    out[i] = product(rows[i], z);
                }
            }

            @Override
            public void correlations(int test, double[] out) {
                for (int i = 0; i < rows.length; i++) {
                    out[i] = product(rows[i], rows[test]);
                }
            }
        }, weights, level, random);
    }

    private static double product(double[] a, double[] b) {
        double sum = 0;
        for (int k = 0; k < a.length; k++) {
            sum += a[k] * b[k];
        }
        return sum;
    }

    private static double[] equal(int n) {
        double[] weights = new double[n];
        Arrays.fill(weights, 1);
        return weights;
    }

    private static double[][] unit(int n) {
        double[][] rows = new double[n][n];
        for (int i = 0; i < n; i++) {
            rows[i][i] = 1;
        }
        return rows;
    }

    /** Independent tests: each at 1 - (1 - level)^(1/n) (Sidak). 1.5 % of the level is 0.005 of the limit. */
    @ParameterizedTest
    @CsvSource({"1, 0.01", "3, 0.01", "12, 0.009", "40, 0.01", "5, 0.3"})
    void limitsOfIndependentTestsAreSidaks(int n, double level) {
        double[] limits = limits(unit(n), equal(n), level, new Well19937c(1));
        double each = 1 - Math.pow(1 - level, 1.0 / n);
        for (double limit : limits) {
            assertEquals(NORMAL.inverseCumulativeProbability(1 - each / 2), limit, 0.01);
        }
    }

    @Test
    void aTestThatStandsTwiceCountsOnce() {
        double[][] rows = {{1, 0}, {1, 0}, {-1, 0}, {0, 1}};
        double[] limits = limits(rows, equal(4), 0.01, new Well19937c(2));
        double each = 1 - Math.sqrt(1 - 0.01);
        assertEquals(NORMAL.inverseCumulativeProbability(1 - each / 2), limits[0], 0.01);
        assertEquals(limits[0], limits[2], 1e-12);
    }

    /**
     * Comparisons of k treatments with one control, all correlated by 0.5: two-sided 5 % points for infinite degrees of
     * freedom from Dunnett, "New tables for multiple comparisons with a control", Biometrics 1964, table II.
     */
    @ParameterizedTest
    @CsvSource({"2, 2.21", "3, 2.35", "5, 2.51", "9, 2.69"})
    void limitsOfCorrelatedTestsAreDunnetts(int k, double tabulated) {
        double[][] rows = new double[k][k + 1];
        for (int i = 0; i < k; i++) {
            rows[i][i] = Math.sqrt(0.5);
            rows[i][k] = Math.sqrt(0.5);
        }
        double[] limits = limits(rows, equal(k), 0.05, new Well19937c(3));
        // half a digit of the table, and what simulation leaves: 1.5 % of 0.05 is 0.007 of the limit
        assertEquals(tabulated, limits[0], 0.005 + 0.01);
    }

    /** All directions of a plane at once: the largest is the length of two normal numbers, sqrt(-2 ln level). */
    @Test
    void directionsOfAPlaneTogetherHaveTheLimitOfItsChiSquare() {
        double[][] rows = new double[180][];
        for (int i = 0; i < rows.length; i++) {
            rows[i] = new double[] {Math.cos(Math.PI * i / rows.length), Math.sin(Math.PI * i / rows.length)};
        }
        double[] limits = limits(rows, equal(rows.length), 0.01, new Well19937c(4));
        assertEquals(Math.sqrt(-2 * Math.log(0.01)), limits[7], 0.015);
    }

    @Test
    void weightsShareTheLevelInTheirProportion() {
        double[] weights = {1, 0.2, 0.01};
        double[] limits = limits(unit(3), weights, 0.01, new Well19937c(5));
        double first = 2 * NORMAL.cumulativeProbability(-limits[0]);
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            double own = 2 * NORMAL.cumulativeProbability(-limits[i]);
            assertEquals(weights[i], own / first, 1e-6 * weights[i]);
            sum += own;
        }
        // alarms of independent rare tests hardly coincide
        assertEquals(0.01, sum, 0.0002);
    }

    /** Against counting, on correlations without any pattern. */
    @Test
    void alarmsAreAsRareAsTheLevelSays() {
        RandomGenerator random = new Well19937c(6);
        double[][] rows = new double[20][5];
        double[] weights = new double[20];
        for (int i = 0; i < rows.length; i++) {
            double length = 0;
            for (int k = 0; k < 5; k++) {
                rows[i][k] = random.nextGaussian();
                length += rows[i][k] * rows[i][k];
            }
            for (int k = 0; k < 5; k++) {
                rows[i][k] /= Math.sqrt(length);
            }
            weights[i] = 0.05 + random.nextDouble();
        }
        double[] limits = limits(rows, weights, 0.01, new Well19937c(7));
        int alarms = 0;
        int draws = 400_000;
        double[] z = new double[5];
        for (int d = 0; d < draws; d++) {
            for (int k = 0; k < 5; k++) {
                z[k] = random.nextGaussian();
            }
            for (int i = 0; i < rows.length; i++) {
                double t = 0;
                for (int k = 0; k < 5; k++) {
                    t += rows[i][k] * z[k];
                }
                if (Math.abs(t) > limits[i]) {
                    alarms++;
                    break;
                }
            }
        }
        // three deviations of the count (1.6 % of it each), and two of the limits (1.5 %)
        assertEquals(1, alarms / (0.01 * draws), 3 * 0.016 + 2 * 0.015);
    }

    @Test
    void theSameNumbersGiveTheSameLimits() {
        double[][] rows = {{1, 0}, {0.6, 0.8}};
        assertArrayEquals(limits(rows, equal(2), 0.01, new Well19937c(8)),
                limits(rows, equal(2), 0.01, new Well19937c(8)));
    }

    @Test
    void badArgumentsAreRefused() {
        RandomGenerator random = new Well19937c(9);
        assertThrows(IllegalArgumentException.class, () -> limits(new double[0][], equal(0), 0.1, random));
        assertThrows(IllegalArgumentException.class,
                () -> limits(unit(2), new double[] {1, 0}, 0.1, random));
        assertThrows(IllegalArgumentException.class, () -> limits(unit(2), equal(2), 1, random));
    }
}
