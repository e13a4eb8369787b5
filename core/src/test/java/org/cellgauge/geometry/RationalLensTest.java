package org.cellgauge.geometry;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** What is special about a quotient of polynomials. */
class RationalLensTest {
    private static final RationalLens LENS = RationalLens.MODEL;

    private static double[] values(double... radial) {
        double[] values = new double[RationalLens.PARAMETERS];
        System.arraycopy(new double[] {581, 590, 640.5, 359.5, 3}, 0, values, 0, 5);
        System.arraycopy(radial, 0, values, 5, radial.length);
        return values;
    }

    @Test
    void withoutDenominatorAndPrismItIsBrowns() {
        double[] brown = {581, 590, 640.5, 359.5, 3, -0.3, 0.12, -0.02, 0.01, -0.02};
        double[] rational = values(-0.3, 0.12, -0.02, 0, 0, 0, 0.01, -0.02);
        double[] a = new double[2];
        double[] b = new double[2];
        double[] rayA = new double[3];
        double[] rayB = new double[3];
        for (int i = 0; i < 50; i++) {
            double x = 700 * Math.cos(i);
            double y = 500 * Math.sin(1.3 * i);
            assertTrue(BrownLens.MODEL.project(brown, x, y, 1000, a, 0));
            assertTrue(LENS.project(rational, x, y, 1000, b, 0));
            assertArrayEquals(a, b, 1e-12 * 1280);
            assertEquals(BrownLens.MODEL.toRay(brown, a[0], a[1], rayA), LENS.toRay(rational, a[0], a[1], rayB));
            assertArrayEquals(rayA, rayB, 1e-11);
        }
        assertEquals(BrownLens.MODEL.reachRad(brown), LENS.reachRad(rational), 1e-9);
    }

    /** 1 / (1 - r²) goes to infinity at a radius of 1: every pixel shows something nearer, and nothing beyond. */
    @Test
    void nothingIsSeenBeyondAPole() {
        double[] pole = values(0, 0, 0, -1);
        double[] uv = {7, 8};
        assertEquals(Math.PI / 4, LENS.reachRad(pole), 2e-3);
        assertTrue(LENS.project(pole, 990, 0, 1000, uv, 0));
        assertTrue(uv[0] > 640 + 20 * 581);
        for (double x : new double[] {1000, 1010, 5000}) {
            uv[0] = 7;
            assertFalse(LENS.project(pole, x, 0, 1000, uv, 0));
            assertFalse(LENS.projectWithDerivatives(pole, x, 0, 1000, uv, new double[6], null));
            assertEquals(7, uv[0]);
        }
        double[] ray = new double[3];
        assertTrue(LENS.toRay(pole, 640.5 + 5 * 581, 359.5, ray));
        // x / (1 - x²) = 5
        assertEquals((Math.sqrt(101) - 1) / 10, ray[0], 1e-9);
    }

    /** r / (1 + r²) has its top at 1 with 1/2: what lies beyond comes back, and pixels farther out show nothing. */
    @Test
    void lensThatTurnsBackEndsThere() {
        double[] top = values(0, 0, 0, 1);
        assertEquals(Math.PI / 4, LENS.reachRad(top), 2e-3);
        double[] ray = new double[3];
        assertTrue(LENS.toRay(top, 640.5 + 581 * 0.499, 359.5, ray));
        // x / (1 + x²) = 0.499, the nearer of two
        assertEquals((1 - Math.sqrt(1 - 4 * 0.499 * 0.499)) / (2 * 0.499), ray[0], 1e-9);
        assertFalse(LENS.toRay(top, 640.5 + 581 * 0.501, 359.5, ray));
    }
}
