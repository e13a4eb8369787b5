package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

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
}
