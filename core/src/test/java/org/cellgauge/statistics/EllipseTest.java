package org.cellgauge.statistics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.internal.statistics.BinomialBand;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class EllipseTest {
    private static final double K95 = Math.sqrt(-2 * Math.log(0.05));

    @ParameterizedTest
    @CsvSource({"3, 1, 0", "3, 1, 0.4", "3, 1, -0.4", "3, 1, 1.5", "3, 1, -1.5", "2, 1.999, 0.7", "1e4, 1e-4, 0.3"})
    void axesAndAngleOfAKnownCovarianceComeBack(double major, double minor, double angle) {
        Ellipse e = Ellipse.ofNormal(new double[] {5, -7}, rotated(major, minor, angle), 0.95);
        assertEquals(5, e.centreX(), 0);
        assertEquals(-7, e.centreY(), 0);
        assertEquals(K95 * major, e.semiMajor(), 1e-12 * major);
        // Squares of the entries hide the minor axis behind rounding of the major one
        assertEquals(K95 * minor, e.semiMinor(), 1e-12 * minor + 1e-15 * major * major / minor * 10);
        assertEquals(angle, e.angleRad(), 1e-10);
    }

    @ParameterizedTest
    @CsvSource({"4, 0, 1, 0", "1, 0, 4, 1.5707963267948966", "1, -0.0, 4, 1.5707963267948966", "2, 0, 2, 0",
        "2, 1, 2, 0.7853981633974483", "2, -1, 2, -0.7853981633974483"})
    void angleLiesInTheHalfOpenInterval(double a, double b, double c, double angle) {
        Ellipse e = Ellipse.ofNormal(new double[2], new double[][] {{a, b}, {b, c}}, 0.5);
        assertEquals(angle, e.angleRad(), 1e-15);
    }

    @Test
    void anyAngleIsBroughtIntoTheInterval() {
        assertEquals(Math.PI / 2, new Ellipse(0, 0, 2, 1, -Math.PI / 2).angleRad(), 0);
        assertEquals(0.2, new Ellipse(0, 0, 2, 1, 0.2 + Math.PI).angleRad(), 1e-15);
        assertEquals(-0.2, new Ellipse(0, 0, 2, 1, -0.2 - 3 * Math.PI).angleRad(), 1e-14);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void boundaryLiesAtTheMahalanobisDistanceOfTheQuantile(long seed) {
        RandomGenerator random = new Well19937c(seed);
        double a = 1 + random.nextDouble();
        double c = 1 + random.nextDouble();
        double b = (2 * random.nextDouble() - 1) * Math.sqrt(a * c);
        double[][] covariance = {{a, b}, {b, c}};
        Ellipse e = Ellipse.ofNormal(new double[] {100, 200}, covariance, 0.9);
        double[][] boundary = e.boundary(37);
        assertEquals(37, boundary.length);
        double det = a * c - b * b;
        for (double[] p : boundary) {
            double x = p[0] - 100;
            double y = p[1] - 200;
            assertEquals(-2 * Math.log(0.1), (c * x * x - 2 * b * x * y + a * y * y) / det, 1e-9);
            assertTrue(e.contains(p[0], p[1]));
            assertFalse(e.contains(100 + 1.0001 * x, 200 + 1.0001 * y));
        }
    }

    @Test
    void boundaryBeginsAtTheLongerAxisAndTurnsFromXToY() {
        double[][] b = new Ellipse(1, 2, 4, 3, Math.PI / 2).boundary(4);
        assertArrayEquals(new double[] {1, 6}, b[0], 1e-14);
        assertArrayEquals(new double[] {-2, 2}, b[1], 1e-14);
        assertArrayEquals(new double[] {1, -2}, b[2], 1e-14);
        assertArrayEquals(new double[] {4, 2}, b[3], 1e-14);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 0.95})
    void ellipseHoldsItsShareOfNormalDraws(double probability) {
        double[][] l = {{2, 0}, {-1.5, 0.4}};
        double[][] covariance = {{4, -3}, {-3, 2.25 + 0.16}};
        Ellipse e = Ellipse.ofNormal(new double[] {3, 4}, covariance, probability);
        RandomGenerator random = new Well19937c(17);
        int n = 20000;
        int hits = 0;
        for (int i = 0; i < n; i++) {
            double u = random.nextGaussian();
            double v = random.nextGaussian();
            if (e.contains(3 + l[0][0] * u, 4 + l[1][0] * u + l[1][1] * v)) {
                hits++;
            }
        }
        // A right ellipse misses this band once in 10 000 seeds
        assertTrue(BinomialBand.of(n, probability, 0.9999).contains(hits), hits + " of " + n);
    }

    @Test
    void flatCovariancesGiveLinesAndPoints() {
        Ellipse line = Ellipse.ofNormal(new double[] {1000, 500}, new double[][] {{1, 2}, {2, 4}}, 0.95);
        assertEquals(K95 * Math.sqrt(5), line.semiMajor(), 1e-12);
        assertEquals(0, line.semiMinor(), 1e-7);
        assertEquals(Math.atan(2), line.angleRad(), 1e-15);
        assertTrue(line.contains(1001, 502));
        assertFalse(line.contains(1001, 501.9));
        Ellipse point = Ellipse.ofNormal(new double[] {1000, 500}, new double[2][2], 0.95);
        assertEquals(0, point.semiMajor(), 0);
        assertEquals(0, point.angleRad(), 0);
        assertTrue(point.contains(1000, 500));
        assertFalse(point.contains(1000, 500.001));
        assertArrayEquals(new double[] {1000, 500}, point.boundary(3)[1], 0);
    }

    @Test
    void tinyAndHugeUnitsMakeNoDifference() {
        for (double unit : new double[] {1e-150, 1e150}) {
            double u2 = unit * unit;
            Ellipse e = Ellipse.ofNormal(new double[2], new double[][] {{4 * u2, 0}, {0, u2}}, 0.95);
            assertEquals(2 * K95, e.semiMajor() / unit, 1e-12);
            assertEquals(K95, e.semiMinor() / unit, 1e-12);
        }
    }

    @Test
    void narrowAxisKeepsItsDigits() {
        double[][] covariance = {{1e-8, 0}, {0, 1e8}};
        Ellipse e = Ellipse.ofNormal(new double[2], covariance, 0.95);
        assertEquals(K95 * 1e-4, e.semiMinor(), 1e-16);
        assertEquals(K95 * 1e4, e.semiMajor(), 1e-9);
    }

    @Test
    void impossibleInputIsRefused() {
        double[] mean = new double[2];
        requireRefused(mean, new double[][] {{1, 2}, {2, 1}});
        requireRefused(mean, new double[][] {{-1, 0}, {0, 1}});
        requireRefused(mean, new double[][] {{0, 0.1}, {0.1, 1}});
        requireRefused(mean, new double[][] {{1, 0.5}, {0.4, 1}});
        requireRefused(mean, new double[][] {{1, Double.NaN}, {Double.NaN, 1}});
        requireRefused(mean, new double[3][3]);
        requireRefused(new double[] {Double.NaN, 0}, new double[][] {{1, 0}, {0, 1}});
        requireRefused(new double[3], new double[][] {{1, 0}, {0, 1}});
        for (double p : new double[] {0, 1, Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> Ellipse.ofNormal(mean, new double[2][2], p));
        }
        assertThrows(IllegalArgumentException.class, () -> new Ellipse(0, 0, 1, 2, 0));
        assertThrows(IllegalArgumentException.class, () -> new Ellipse(0, 0, 1, -1, 0));
        assertThrows(IllegalArgumentException.class, () -> new Ellipse(0, 0, 1, 1, 0).boundary(2));
        assertFalse(new Ellipse(0, 0, 1, 1, 0).contains(Double.NaN, 0));
    }

    private static void requireRefused(double[] mean, double[][] covariance) {
        assertThrows(IllegalArgumentException.class, () -> Ellipse.ofNormal(mean, covariance, 0.95));
    }

    private static double[][] rotated(double major, double minor, double angle) {
        double c = Math.cos(angle);
        double s = Math.sin(angle);
        double p = major * major;
        double q = minor * minor;
        return new double[][] {{c * c * p + s * s * q, c * s * (p - q)}, {c * s * (p - q), s * s * p + c * c * q}};
    }
}
