package org.cellgauge.internal.geometry;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RotationsTest {
    /** The definition, as three matrices multiplied by EJML. */
    private static SimpleMatrix product(double psi, double theta, double phi) {
        SimpleMatrix x = new SimpleMatrix(new double[][] {{1, 0, 0}, {0, Math.cos(psi), -Math.sin(psi)},
            {0, Math.sin(psi), Math.cos(psi)}});
        SimpleMatrix y = new SimpleMatrix(new double[][] {{Math.cos(theta), 0, Math.sin(theta)}, {0, 1, 0},
            {-Math.sin(theta), 0, Math.cos(theta)}});
        SimpleMatrix z = new SimpleMatrix(new double[][] {{Math.cos(phi), -Math.sin(phi), 0},
            {Math.sin(phi), Math.cos(phi), 0}, {0, 0, 1}});
        return z.mult(y).mult(x);
    }

    /** Power series of the matrix exponential of [w], after halving the angle until the series converges at once. */
    private static SimpleMatrix series(double wx, double wy, double wz) {
        int halvings = 0;
        double length = Math.sqrt(wx * wx + wy * wy + wz * wz);
        while (length > 0.5) {
            length /= 2;
            halvings++;
        }
        SimpleMatrix generator = new SimpleMatrix(new double[][] {{0, -wz, wy}, {wz, 0, -wx}, {-wy, wx, 0}})
                .scale(Math.scalb(1.0, -halvings));
        SimpleMatrix sum = SimpleMatrix.identity(3);
        SimpleMatrix term = SimpleMatrix.identity(3);
        for (int k = 1; k < 25; k++) {
            term = term.mult(generator).scale(1.0 / k);
            sum = sum.plus(term);
        }
        for (int k = 0; k < halvings; k++) {
            sum = sum.mult(sum);
        }
        return sum;
    }

    private static double[] array(SimpleMatrix m) {
        return m.getDDRM().data.clone();
    }

    private static double[] exp(double[] w) {
        double[] r = new double[9];
        Rotations.exp(w[0], w[1], w[2], r);
        return r;
    }

    private static double[] log(double[] r) {
        double[] w = new double[3];
        Rotations.log(r, w, 0);
        return w;
    }

    private static double[] times(double[] a, double[] b) {
        double[] out = new double[9];
        Rotations.multiply(a, b, out);
        return out;
    }

    private static double[] randomVector(RandomGenerator random, double length) {
        double[] w = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
        double scale = length / Math.sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
        return new double[] {w[0] * scale, w[1] * scale, w[2] * scale};
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 0", "3.08, 0.10, 0.02", "-2, 1.2, 0.7", "0.3, -1.5707963267948966, -2",
        "1, 1.5707963267948966, 0.5",
        "0.1, 2.5, -3"})
    void matrixOfAnglesIsTheProductOfTheThreeTurns(double psi, double theta, double phi) {
        double[] r = new double[9];
        Rotations.fromEuler(psi, theta, phi, r);
        assertArrayEquals(array(product(psi, theta, phi)), r, 1e-15);
    }

    @Test
    void anglesInRangeComeBack() {
        RandomGenerator random = new Well19937c(1);
        double[] e = new double[5];
        for (int i = 0; i < 500; i++) {
            double psi = Math.PI * (2 * random.nextDouble() - 1);
            double theta = 0.99 * Math.PI / 2 * (2 * random.nextDouble() - 1);
            double phi = Math.PI * (2 * random.nextDouble() - 1);
            Rotations.toEuler(array(product(psi, theta, phi)), e, 1);
            assertArrayEquals(new double[] {0, psi, theta, phi, 0}, e, 1e-13);
        }
    }

    /** How far theta is from +-pi/2: whatever the angles, they must stand for the same matrix. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-16, 1e-14, 1e-13, 3e-12, 1e-11, 1e-9, 1e-7, 1e-4, 0.01})
    void anglesNearGimbalLockStandForTheSameMatrix(double distance) {
        RandomGenerator random = new Well19937c(2);
        double[] e = new double[3];
        for (int i = 0; i < 100; i++) {
            double psi = Math.PI * (2 * random.nextDouble() - 1);
            double phi = Math.PI * (2 * random.nextDouble() - 1);
            double theta = (i % 2 == 0 ? 1 : -1) * (Math.PI / 2 - distance);
            // turned there and back, so that its elements carry the rounding of any composed rotation
            double[] there = exp(randomVector(random, 1));
            double[] r = new double[9];
            Rotations.multiplyTransposed(array(product(psi, theta, phi)), there, r);
            r = times(r, there);
            Rotations.toEuler(r, e, 0);
            assertArrayEquals(r, array(product(e[0], e[1], e[2])), 4e-12);
        }
    }

    @ParameterizedTest
    @CsvSource({"0.4, 0.3, 1", "-2, 1, 1", "0.4, 0.3, -1", "3, -3, -1"})
    void gimbalLockLeavesTheWholeTurnToPsi(double psi, double phi, int sign) {
        double[] e = new double[3];
        Rotations.toEuler(array(product(psi, sign * Math.PI / 2, phi)), e, 0);
        assertEquals(sign * Math.PI / 2, e[1], 1e-15);
        assertEquals(0, e[2], 0);
        // at theta = pi/2 only psi - phi shows, at -pi/2 only psi + phi
        assertEquals(0, Math.IEEEremainder(e[0] - (psi - sign * phi), 2 * Math.PI), 1e-14);
    }

    @Test
    void halfTurnHasTheAnglePiAndNotItsNegative() {
        double[] e = new double[3];
        for (double zero : new double[] {0.0, -0.0, -1e-17}) {
            Rotations.toEuler(new double[] {1, 0, 0, 0, -1, -zero, 0, zero, -1}, e, 0);
            assertEquals(Math.PI, e[0], 0);
            Rotations.toEuler(new double[] {-1, -zero, 0, zero, -1, 0, 0, 0, 1}, e, 0);
            assertEquals(Math.PI, e[2], 0);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-300, 1e-12, 1e-7, 9.9e-5, 1.01e-4, 0.01, 1, 2, 3, 3.1415, 3.14159265358, 4, 6.2})
    void exponentialIsThePowerSeries(double angle) {
        RandomGenerator random = new Well19937c(3);
        for (int i = 0; i < 20; i++) {
            double[] w = randomVector(random, angle);
            assertArrayEquals(array(series(w[0], w[1], w[2])), exp(w), 1e-14);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-160, 1e-12, 1e-7, 9.9e-5, 1.01e-4, 0.01, 1, 2, 2.0943951, 3, 3.1415, 3.1415926535})
    void logarithmUndoesTheExponential(double angle) {
        RandomGenerator random = new Well19937c(4);
        for (int i = 0; i < 50; i++) {
            double[] w = randomVector(random, angle);
            assertArrayEquals(w, log(exp(w)), 1e-15 + 2e-15 * angle);
        }
    }

    @Test
    void logarithmOfHalfTurnsIsTheAxisTimesPiUpToSign() {
        RandomGenerator random = new Well19937c(5);
        for (int i = 0; i < 50; i++) {
            double[] n = i < 3 ? new double[] {i == 0 ? 1 : 0, i == 1 ? 1 : 0, i == 2 ? 1 : 0}
                    : randomVector(random, 1);
            double[] r = new double[9];
            for (int k = 0; k < 9; k++) {
                r[k] = 2 * n[k / 3] * n[k % 3] - (k % 4 == 0 ? 1 : 0);
            }
            double[] w = log(r);
            double along = w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
            assertEquals(Math.PI, Math.abs(along), 1e-14);
            assertEquals(Math.PI, Math.sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]), 1e-14);
        }
    }

    /** Columns of the left Jacobian: how exp(w + h e) exp(-w) turns. */
    private static SimpleMatrix leftJacobian(double[] w) {
        double h = 1e-5;
        SimpleMatrix j = new SimpleMatrix(3, 3);
        double[] turned = new double[9];
        for (int c = 0; c < 3; c++) {
            double[] plus = w.clone();
            double[] minus = w.clone();
            plus[c] += h;
            minus[c] -= h;
            Rotations.multiplyTransposed(exp(plus), exp(minus), turned);
            double[] difference = log(turned);
            for (int r = 0; r < 3; r++) {
                j.set(r, c, difference[r] / (2 * h));
            }
        }
        return j;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-5, 0.3, 1, 2, 3, 3.14, 4.5, 6})
    void haarDensityIsTheDeterminantOfTheChart(double angle) {
        RandomGenerator random = new Well19937c(6);
        for (int i = 0; i < 10; i++) {
            double[] w = randomVector(random, angle);
            double determinant = leftJacobian(w).determinant();
            assertEquals(determinant, Math.exp(Rotations.logHaarDensity(w[0], w[1], w[2])), 1e-8);
        }
    }

    @Test
    void haarDensityOfSmallAnglesKeepsItsDigits() {
        // 2 log(sin(h)/h) = -w²/12 - w⁴/1440 - …, either side of where the formula changes
        for (double angle : new double[] {1e-6, 0.99e-4, 1.01e-4, 1e-3}) {
            double expected = -angle * angle / 12 - Math.pow(angle, 4) / 1440;
            assertEquals(expected, Rotations.logHaarDensity(0, angle, 0), 4e-16 + 1e-9 * Math.abs(expected));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-5, 0.9e-4, 1.1e-4, 0.3, 1, 2, 3})
    void inverseLeftJacobianIsTheDerivativeOfTheLogarithm(double angle) {
        RandomGenerator random = new Well19937c(7);
        double h = 1e-5;
        double[] j = new double[9];
        for (int i = 0; i < 10; i++) {
            double[] w = randomVector(random, angle);
            Rotations.inverseLeftJacobian(w[0], w[1], w[2], j);
            for (int c = 0; c < 3; c++) {
                double[] d = new double[3];
                d[c] = h;
                double[] plus = log(times(exp(d), exp(w)));
                d[c] = -h;
                double[] minus = log(times(exp(d), exp(w)));
                for (int r = 0; r < 3; r++) {
                    assertEquals((plus[r] - minus[r]) / (2 * h), j[3 * r + c], 2e-8);
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 0.99e-4, 1.01e-4, 1e-3})
    void inverseLeftJacobianOfSmallAnglesKeepsItsDigits(double angle) {
        double[] j = new double[9];
        Rotations.inverseLeftJacobian(angle, 0, 0, j);
        // I - [w]/2 + (1/12 + |w|²/720 + …) [w]²
        double square = -angle * angle * (1.0 / 12 + angle * angle / 720);
        assertArrayEquals(new double[] {1, 0, 0, 0, 1 + square, angle / 2, 0, -angle / 2, 1 + square}, j, 3e-16);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 2, 3.14, 5})
    void inverseLeftJacobianInvertsTheLeftJacobian(double angle) {
        double[] w = randomVector(new Well19937c(8), angle);
        double[] j = new double[9];
        Rotations.inverseLeftJacobian(w[0], w[1], w[2], j);
        SimpleMatrix unit = new SimpleMatrix(3, 3, true, j).mult(leftJacobian(w));
        assertTrue(unit.isIdentical(SimpleMatrix.identity(3), 1e-7), unit::toString);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-6, 1e-4, 0.01, 0.5, 2, 3})
    void leftJacobianIsTheOneOfTheSeries(double angle) {
        double[] w = {0.48 * angle, -0.6 * angle, 0.64 * angle};
        double[] j = new double[9];
        Rotations.leftJacobian(w[0], w[1], w[2], j);
        double[] inverse = new double[9];
        Rotations.inverseLeftJacobian(w[0], w[1], w[2], inverse);
        assertTrue(new SimpleMatrix(3, 3, true, j).isIdentical(leftJacobian(w), 1e-7));
        SimpleMatrix unit = new SimpleMatrix(3, 3, true, j).mult(new SimpleMatrix(3, 3, true, inverse));
        assertTrue(unit.isIdentical(SimpleMatrix.identity(3), 1e-12), unit::toString);
    }

    @Test
    void productsAgreeWithEjml() {
        RandomGenerator random = new Well19937c(9);
        double[] a = new double[9];
        double[] b = new double[9];
        for (int i = 0; i < 9; i++) {
            a[i] = random.nextGaussian();
            b[i] = random.nextGaussian();
        }
        double[] out = new double[9];
        SimpleMatrix ma = new SimpleMatrix(3, 3, true, a);
        SimpleMatrix mb = new SimpleMatrix(3, 3, true, b);
        Rotations.multiply(a, b, out);
        assertArrayEquals(array(ma.mult(mb)), out, 1e-15);
        Rotations.multiplyTransposed(a, b, out);
        assertArrayEquals(array(ma.mult(mb.transpose())), out, 1e-15);
        Rotations.transpose(a, out);
        assertArrayEquals(array(ma.transpose()), out, 0);
    }
}
