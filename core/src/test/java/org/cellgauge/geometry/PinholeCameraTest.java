package org.cellgauge.geometry;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;

/** Cameras derived from others see every point where the scaled or cut image shows it. */
class PinholeCameraTest {
    private static final PinholeCamera CAMERA = PinholeCamera.of(1280, 720,
            new double[] {800, 810, 650, 350, 3, -0.25, 0.1, -0.02, 0.001, -0.002});

    private interface Check {
        void at(double[] point, double[] uv);
    }

    private static void forPoints(Check check) {
        RandomGenerator random = new Well19937c(2);
        for (int i = 0; i < 200; i++) {
            double[] p = {800 * random.nextGaussian() / 3, 500 * random.nextGaussian() / 3, 1000};
            check.at(p, CAMERA.project(p[0], p[1], p[2]));
        }
    }

    @Test
    void aScaledImageShowsEveryPointAtItsScaledPlace() {
        PinholeCamera half = CAMERA.resized(640, 360);
        PinholeCamera squeezed = CAMERA.resized(1920, 360);
        assertEquals(640, half.widthPx());
        assertEquals(360, half.heightPx());
        forPoints((p, uv) -> {
            assertArrayEquals(new double[] {uv[0] / 2, uv[1] / 2}, half.project(p[0], p[1], p[2]), 1e-9);
            assertArrayEquals(new double[] {1.5 * uv[0], uv[1] / 2}, squeezed.project(p[0], p[1], p[2]), 1e-9);
        });
    }

    @Test
    void aCutImageShowsEveryPointAtItsShiftedPlace() {
        PinholeCamera part = CAMERA.cropped(160, -20, 960, 700);
        assertEquals(960, part.widthPx());
        assertEquals(700, part.heightPx());
        forPoints((p, uv) ->
                assertArrayEquals(new double[] {uv[0] - 160, uv[1] + 20}, part.project(p[0], p[1], p[2]), 1e-9));
    }

    @Test
    void aFieldOfViewReachesFromEdgeToEdge() {
        double angle = Math.toRadians(66);
        PinholeCamera camera = PinholeCamera.fromFieldOfView(1280, 720, angle);
        double edge = Math.tan(angle / 2);
        assertArrayEquals(new double[] {1280, 360}, camera.project(edge, 0, 1), 1e-9);
        assertArrayEquals(new double[] {0, 360}, camera.project(-edge, 0, 1), 1e-9);
        // pixels are square
        assertArrayEquals(new double[] {640, 360 + 640}, camera.project(0, edge, 1), 1e-9);
        assertEquals(angle, camera.horizontalFieldOfViewRad(), 1e-12);
        assertThrows(IllegalArgumentException.class, () -> PinholeCamera.fromFieldOfView(1280, 720, Math.PI));
        assertThrows(IllegalArgumentException.class, () -> PinholeCamera.fromFieldOfView(1280, 720, 0));
    }

    @Test
    void tenDegreesOfFieldOfViewAreTheFocalLengthsTenDegreesOffOnEitherSide() {
        PinholeCamera camera = PinholeCamera.fromFieldOfView(1280, 720, Math.toRadians(65));
        // 640 / tan(27.5 deg) = 1229.429 and 640 / tan(37.5 deg) = 834.064
        assertEquals((1229.4285612615463 - 834.0642386183716) / 2, camera.focalStdPx(Math.toRadians(10)), 1e-9);
        // df/dh = -(w / 4) / sin(h / 2)^2 for a small deviation
        assertEquals(320 / Math.pow(Math.sin(Math.toRadians(32.5)), 2), camera.focalStdPx(1e-5) / 1e-5, 1e-3);
        assertThrows(IllegalArgumentException.class, () -> camera.focalStdPx(0));
        assertThrows(IllegalArgumentException.class, () -> camera.focalStdPx(Math.toRadians(65)));
    }
}
