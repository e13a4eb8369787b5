package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.junit.jupiter.api.Test;

class SquareResidualTest {
    private static PinholeCamera distorted() {
        double[] values = PinholeCamera.ideal(1280, 720, 581, 590, 650, 350).intrinsics();
        values[BrownLens.K1] = -0.3;
        values[BrownLens.K2] = 0.09;
        values[BrownLens.P1] = 0.002;
        values[BrownLens.P2] = -0.001;
        return PinholeCamera.of(1280, 720, values);
    }

    private static double[] corners(PinholeCamera camera, RandomGenerator random) {
        double tiltX = Math.PI + (random.nextDouble() - 0.5) * 1.6;
        double tiltY = (random.nextDouble() - 0.5) * 1.6;
        return DrawnMarkers.corners(camera, RigidTransform.ofEuler(300 * (random.nextDouble() - 0.5),
                200 * (random.nextDouble() - 0.5), 500 + 400 * random.nextDouble(), tiltX, tiltY,
                6.28 * random.nextDouble()), 100);
    }

    @Test
    void trueSquaresLeaveNothing() {
        PinholeCamera camera = distorted();
        SquareResidual residual = new SquareResidual(camera);
        RandomGenerator random = new Well19937c(1);
        for (int i = 0; i < 200; i++) {
            assertEquals(0, residual.impliedStdPx(corners(camera, random)), 1e-3);
        }
    }

    /** With 2 degrees of freedom each, the mean of 1000 squared residuals has a relative deviation of 3.2 %. */
    @Test
    void noisySquaresImplyTheirNoise() {
        PinholeCamera camera = distorted();
        SquareResidual residual = new SquareResidual(camera);
        RandomGenerator random = new Well19937c(2);
        double sum = 0;
        int n = 1000;
        for (int i = 0; i < n; i++) {
            double[] corners = corners(camera, random);
            for (int k = 0; k < 8; k++) {
                corners[k] += 0.2 * random.nextGaussian();
            }
            double s = residual.impliedStdPx(corners);
            sum += s * s;
        }
        assertEquals(0.04, sum / n, 4 * 0.032 * 0.04);
    }

    /**
     * Small squares far off have two poses that look nearly alike, and noise leads one of the two starts astray every
     * twentieth time. The square root of half a chi-square of 2 exceeds 4 once in ten million times.
     */
    @Test
    void noSmallSquareImpliesFarMoreThanItsNoise() {
        PinholeCamera camera = distorted();
        SquareResidual residual = new SquareResidual(camera);
        RandomGenerator random = new Well19937c(3);
        for (int i = 0; i < 5000; i++) {
            double[] corners = DrawnMarkers.corners(camera, RigidTransform.ofEuler(200 * (random.nextDouble() - 0.5),
                    150 * (random.nextDouble() - 0.5), 500 + 400 * random.nextDouble(),
                    Math.PI + (random.nextDouble() - 0.5) * 2.2, (random.nextDouble() - 0.5) * 2.2,
                    6.28 * random.nextDouble()), 30);
            for (int k = 0; k < 8; k++) {
                corners[k] += random.nextGaussian();
            }
            assertTrue(residual.impliedStdPx(corners) < 4, "square " + i);
        }
    }

    @Test
    void wedgeAndCornersInWrongOrderAreFarFromAnySquare() {
        SquareResidual residual = new SquareResidual(distorted());
        assertTrue(residual.impliedStdPx(new double[] {250, 180, 350, 180, 330, 260, 270, 260}) > 4);
        assertTrue(residual.impliedStdPx(new double[] {250, 180, 350, 260, 350, 180, 250, 260}) > 4);
    }
}
