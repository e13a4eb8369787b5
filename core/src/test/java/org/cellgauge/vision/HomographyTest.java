package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.junit.jupiter.api.Test;

class HomographyTest {
    private static double[] map(double[] h, double x, double y) {
        double w = h[6] * x + h[7] * y + 1;
        return new double[] {(h[0] * x + h[1] * y + h[2]) / w, (h[3] * x + h[4] * y + h[5]) / w};
    }

    /** And the middle of the square to where the diagonals meet, which a perspective image keeps. */
    @Test
    void cornersMapToCornersAndTheMiddleToTheMeetingOfTheDiagonals() {
        PinholeCamera camera = PinholeCamera.ideal(640, 480, 581, 575, 322, 238);
        RigidTransform pose = RigidTransform.ofEuler(30, -20, 400, Math.PI + 0.5, -0.4, 0.8);
        double[] corners = DrawnMarkers.corners(camera, pose, 60);
        double[] h = new double[8];
        assertTrue(Homography.ofUnitSquare(corners, h));
        double[][] unit = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        for (int i = 0; i < 4; i++) {
            double[] p = map(h, unit[i][0], unit[i][1]);
            assertEquals(corners[2 * i], p[0], 1e-9);
            assertEquals(corners[2 * i + 1], p[1], 1e-9);
        }
        double[] t = pose.translationMm();
        double[] centre = camera.project(t[0], t[1], t[2]);
        assertEquals(centre[0], map(h, 0.5, 0.5)[0], 1e-9);
        assertEquals(centre[1], map(h, 0.5, 0.5)[1], 1e-9);
    }

    @Test
    void cornersOnALineHaveNone() {
        assertFalse(Homography.ofUnitSquare(new double[] {0, 0, 1, 1, 2, 2, 3, 3}, new double[8]));
    }
}
