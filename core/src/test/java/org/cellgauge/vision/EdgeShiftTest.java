package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.junit.jupiter.api.Test;

class EdgeShiftTest {
    @Test
    void cornersOfASquareMoveAlongItsDiagonals() {
        assertArrayEquals(new double[] {1, 1, -1, 1, -1, -1, 1, -1},
                EdgeShift.ofCorners(new double[] {0, 0, 9, 0, 9, 9, 0, 9}), 1e-12);
        // the other sense of turning
        assertArrayEquals(new double[] {1, 1, 1, -1, -1, -1, -1, 1},
                EdgeShift.ofCorners(new double[] {0, 0, 0, 9, 9, 9, 9, 0}), 1e-12);
    }

    /** Each side of any quadrilateral, moved, is 1 px from where it was, on the inner side. */
    @Test
    void sidesMoveByOnePixel() {
        double[] c = {3, 1, 30, 5, 27, 36, -2, 29};
        double[] d = EdgeShift.ofCorners(c);
        for (int i = 0; i < 4; i++) {
            int j = (i + 1) % 4;
            int k = (i + 2) % 4;
            double dx = c[2 * j] - c[2 * i];
            double dy = c[2 * j + 1] - c[2 * i + 1];
            double length = Math.hypot(dx, dy);
            double inside = Math.signum(dx * (c[2 * k + 1] - c[2 * i + 1]) - dy * (c[2 * k] - c[2 * i]));
            assertEquals(1, inside * (dx * d[2 * i + 1] - dy * d[2 * i]) / length, 1e-12);
            assertEquals(1, inside * (dx * d[2 * j + 1] - dy * d[2 * j]) / length, 1e-12);
        }
    }

    /** The image of a square on paper that is seen aslant, against that of a larger square. */
    @Test
    void inkMovesSidesByTheSameOnThePaper() {
        PinholeCamera camera = PinholeCamera.ideal(1280, 720, 900, 900, 640, 360);
        RigidTransform pose = RigidTransform.ofEuler(60, -40, 700, 3.0, 0.6, 0.4);
        double sizeMm = 50;
        double[] byInk = EdgeShift.byInk(corners(camera, pose, sizeMm), sizeMm);
        double h = 0.01;
        double[] larger = corners(camera, pose, sizeMm + 2 * h);
        double[] smaller = corners(camera, pose, sizeMm - 2 * h);
        for (int i = 0; i < 8; i++) {
            assertEquals((larger[i] - smaller[i]) / (2 * h), byInk[i], 1e-5);
        }
    }

    private static double[] corners(PinholeCamera camera, RigidTransform pose, double sizeMm) {
        double[] points = MarkerGeometry.cornersMm(pose, sizeMm);
        double[] px = new double[8];
        for (int k = 0; k < 4; k++) {
            System.arraycopy(camera.project(points[3 * k], points[3 * k + 1], points[3 * k + 2]), 0, px, 2 * k, 2);
        }
        return px;
    }
}
