package org.cellgauge.internal.statistics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.statistics.Ellipse;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class CoverageRegionTest {
    /** Values of scipy.stats.chi2.ppf, SciPy 1.17.1. */
    @ParameterizedTest
    @CsvSource({"0.95, 1, 3.841458820694124", "0.95, 2, 5.991464547107979", "0.95, 3, 7.814727903251179",
        "0.5, 3, 2.3659738843753377", "0.99, 6, 16.811893829770927", "0.6827, 1, 1.000043427117466",
        "0.999, 8, 26.12448155837614"})
    void chiSquareQuantilesAreThoseOfSciPy(double probability, int dof, double expected) {
        assertEquals(expected, CoverageRegion.chiSquareQuantile(probability, dof), 1e-9 * expected);
    }

    @Test
    void distanceOfIndependentComponentsIsTheSumOfSquares() {
        CoverageRegion r = CoverageRegion.of(new double[] {1, 2, 3}, diagonal(4, 9, 16), 0.95);
        assertEquals(1 + 4 + 9, r.mahalanobisSquared(new double[] {3, 8, -9}), 1e-12);
        assertEquals(0, r.mahalanobisSquared(r.mean()), 0);
        double k = Math.sqrt(7.814727903251179);
        assertEquals(k, r.factor(), 1e-9);
        assertEquals(0.95, r.probability(), 0);
        assertArrayEquals(new double[] {4 * k, 3 * k, 2 * k}, r.semiAxes(), 1e-9);
        assertArrayEquals(new double[] {0, 0, 1}, absolute(r.axisDirections()[0]), 1e-12);
        assertArrayEquals(new double[] {1, 0, 0}, absolute(r.axisDirections()[2]), 1e-12);
        assertEquals(3 * k, r.halfWidth(1), 1e-9);
        assertTrue(r.contains(new double[] {1, 2, 3 + 0.999999 * 4 * k}));
        assertFalse(r.contains(new double[] {1, 2, 3 + 1.000001 * 4 * k}));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void distanceIsThatOfTheWhitenedVector(long seed) {
        // x = mean + L z has the distance |z|^2, whatever L is
        RandomGenerator random = new Well19937c(seed);
        int d = 2 + (int) seed;
        double[][] l = new double[d][d];
        for (int i = 0; i < d; i++) {
            for (int j = 0; j < i; j++) {
                l[i][j] = random.nextGaussian();
            }
            l[i][i] = 0.5 + random.nextDouble();
        }
        // mm beside rad: units must not decide what counts as zero
        double[] unit = new double[d];
        for (int i = 0; i < d; i++) {
            unit[i] = i % 2 == 0 ? 1e3 : 1e-6;
        }
        double[][] covariance = new double[d][d];
        double[] mean = new double[d];
        double[] x = new double[d];
        double[] z = new double[d];
        double norm = 0;
        for (int i = 0; i < d; i++) {
            z[i] = random.nextGaussian();
            norm += z[i] * z[i];
            mean[i] = random.nextGaussian() * unit[i];
        }
        for (int i = 0; i < d; i++) {
            x[i] = mean[i];
            for (int j = 0; j < d; j++) {
                x[i] += unit[i] * l[i][j] * z[j];
                for (int k = 0; k < d; k++) {
                    covariance[i][j] += unit[i] * unit[j] * l[i][k] * l[j][k];
                }
            }
        }
        CoverageRegion r = CoverageRegion.of(mean, covariance, 0.9);
        assertEquals(norm, r.mahalanobisSquared(x), 1e-8 * norm);
    }

    @Test
    void planarRegionAgreesWithTheEllipse() {
        double[][] covariance = {{3, -1.2}, {-1.2, 2}};
        CoverageRegion r = CoverageRegion.of(new double[] {1, 2}, covariance, 0.95);
        Ellipse e = Ellipse.ofNormal(new double[] {1, 2}, covariance, 0.95);
        assertEquals(e.semiMajor(), r.semiAxes()[0], 1e-12);
        assertEquals(e.semiMinor(), r.semiAxes()[1], 1e-12);
        double[] axis = r.axisDirections()[0];
        assertEquals(0, Math.sin(Math.atan2(axis[1], axis[0]) - e.angleRad()), 1e-12);
    }

    @Test
    void regionHoldsItsShareOfNormalDraws() {
        CoverageRegion r = CoverageRegion.of(new double[3], diagonal(1, 4, 0.25), 0.8);
        RandomGenerator random = new Well19937c(23);
        int n = 20000;
        int hits = 0;
        double[] x = new double[3];
        for (int i = 0; i < n; i++) {
            x[0] = random.nextGaussian();
            x[1] = 2 * random.nextGaussian();
            x[2] = 0.5 * random.nextGaussian();
            if (r.contains(x)) {
                hits++;
            }
        }
        // A right region misses this band once in 10 000 seeds
        assertTrue(BinomialBand.of(n, 0.8, 0.9999).contains(hits), hits + " of " + n);
    }

    @Test
    void flatRegionsExcludeWhatLiesOffThem() {
        CoverageRegion plane = CoverageRegion.of(new double[] {0, 0, 5}, diagonal(1, 1, 0), 0.95);
        assertEquals(2, plane.mahalanobisSquared(new double[] {1, 1, 5}), 1e-12);
        assertEquals(Double.POSITIVE_INFINITY, plane.mahalanobisSquared(new double[] {0, 0, 5.001}), 0);
        assertEquals(0, plane.semiAxes()[2], 0);
        CoverageRegion line = CoverageRegion.of(new double[] {1e3, 0}, new double[][] {{1, 3}, {3, 9}}, 0.95);
        assertEquals(4, line.mahalanobisSquared(new double[] {1e3 + 2, 6}), 1e-9);
        assertFalse(line.contains(new double[] {1e3 + 2, 6.01}));
        CoverageRegion point = CoverageRegion.of(new double[] {7}, new double[1][1], 0.95);
        assertTrue(point.contains(new double[] {7}));
        assertFalse(point.contains(new double[] {7.0001}));
        assertArrayEquals(new double[] {0}, point.semiAxes(), 0);
    }

    @Test
    void impossibleInputIsRefused() {
        // Every pair of correlations is possible, the three together are not
        requireRefused(new double[][] {{1, 0.9, -0.9}, {0.9, 1, 0.9}, {-0.9, 0.9, 1}});
        requireRefused(new double[][] {{1, 0, 0}, {0, -1e-30, 0}, {0, 0, 1}});
        requireRefused(new double[][] {{1, 0.1, 0}, {0.2, 1, 0}, {0, 0, 1}});
        requireRefused(new double[][] {{1, 0, 0}, {0, 1}, {0, 0, 1}});
        requireRefused(diagonal(1, Double.POSITIVE_INFINITY, 1));
        requireRefused(diagonal(1, 1));
        CoverageRegion r = CoverageRegion.of(new double[2], diagonal(1, 1), 0.9);
        assertThrows(IllegalArgumentException.class, () -> r.contains(new double[3]));
        assertThrows(IllegalArgumentException.class, () -> r.contains(new double[] {0, Double.NaN}));
        assertThrows(IllegalArgumentException.class, () -> r.halfWidth(2));
        assertThrows(IllegalArgumentException.class, () -> CoverageRegion.chiSquareQuantile(0.5, 0));
        assertThrows(IllegalArgumentException.class, () -> CoverageRegion.chiSquareQuantile(1, 2));
        assertThrows(IllegalArgumentException.class,
                () -> CoverageRegion.of(new double[0], new double[0][0], 0.5));
    }

    private static void requireRefused(double[][] covariance) {
        assertThrows(IllegalArgumentException.class, () -> CoverageRegion.of(new double[3], covariance, 0.95));
    }

    private static double[][] diagonal(double... variances) {
        double[][] out = new double[variances.length][variances.length];
        for (int i = 0; i < variances.length; i++) {
            out[i][i] = variances[i];
        }
        return out;
    }

    private static double[] absolute(double[] v) {
        return Arrays.stream(v).map(Math::abs).toArray();
    }
}
