package org.cellgauge.geometry;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.factory.distort.LensDistortionFactory;
import boofcv.struct.calib.CameraPinholeBrown;
import boofcv.struct.distort.Point2Transform2_F64;
import georegression.struct.point.Point2D_F64;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BrownLensTest {
    /** fx, fy, cx, cy, skew, k1, k2, k3, p1, p2: a lens stronger in every term than those in use. */
    private static final double[] STRONG = {581, 590, 640.5, 359.5, 3, -0.3, 0.12, -0.02, 0.01, -0.02};

    private static double[] random(RandomGenerator random) {
        double z = 500 + 1000 * random.nextDouble();
        return new double[] {z * (1.6 * random.nextDouble() - 0.8), z * (1.2 * random.nextDouble() - 0.6), z};
    }

    /** The lens model as its source writes it down, nothing factored out. */
    private static double[] formula(double[] i, double[] p) {
        double x = p[0] / p[2];
        double y = p[1] / p[2];
        double r = Math.hypot(x, y);
        double scale = 1 + i[5] * Math.pow(r, 2) + i[6] * Math.pow(r, 4) + i[7] * Math.pow(r, 6);
        double xd = x * scale + 2 * i[8] * x * y + i[9] * (Math.pow(r, 2) + 2 * Math.pow(x, 2));
        double yd = y * scale + i[8] * (Math.pow(r, 2) + 2 * Math.pow(y, 2)) + 2 * i[9] * x * y;
        return new double[] {i[0] * xd + i[4] * yd + i[2], i[1] * yd + i[3]};
    }

    @Test
    void projectionIsTheWrittenFormula() {
        RandomGenerator random = new Well19937c(1);
        PinholeCamera camera = PinholeCamera.of(1280, 720, STRONG);
        for (int k = 0; k < 200; k++) {
            double[] p = random(random);
            assertArrayEquals(formula(STRONG, p), camera.project(p[0], p[1], p[2]), 1e-9);
        }
    }

    @Test
    void projectionIsThatOfTheImageLibrary() {
        RandomGenerator random = new Well19937c(2);
        CameraPinholeBrown theirs = new CameraPinholeBrown(STRONG[0], STRONG[1], STRONG[4], STRONG[2], STRONG[3], 1280,
                720).fsetRadial(STRONG[5], STRONG[6], STRONG[7]).fsetTangential(STRONG[8], STRONG[9]);
        Point2Transform2_F64 toPixel = LensDistortionFactory.narrow(theirs).distort_F64(false, true);
        PinholeCamera camera = PinholeCamera.of(1280, 720, STRONG);
        Point2D_F64 px = new Point2D_F64();
        for (int k = 0; k < 200; k++) {
            double[] p = random(random);
            toPixel.compute(p[0] / p[2], p[1] / p[2], px);
            assertArrayEquals(new double[] {px.x, px.y}, camera.project(p[0], p[1], p[2]), 1e-9);
        }
    }

    /** Radius at which a lens with these radial terms folds back: where the derivative of r (1 + k1 r² + …) is 0. */
    private static double fold(double k1, double k2) {
        double r = 0;
        while (1 + 3 * k1 * r * r + 5 * k2 * r * r * r * r > 0) {
            r += 1e-5;
        }
        return r;
    }

    @ParameterizedTest
    @CsvSource({"-0.3, 0", "-0.5, 0.05", "-0.3, 0.02", "0.3, -0.1", "0.1, -0.2"})
    void everyPixelWithinTheFoldHasItsSourceAndNoneBeyond(double k1, double k2) {
        double[] intrinsics = {500, 500, 0, 0, 0, k1, k2, 0, 0, 0};
        double fold = fold(k1, k2);
        double edge = fold * (1 + k1 * fold * fold + k2 * Math.pow(fold, 4));
        double[] out = new double[3];
        for (int k = 0; k < 400; k++) {
            double angle = 0.7 * k;
            double r = fold * k / 401;
            double pixel = 500 * r * (1 + k1 * r * r + k2 * Math.pow(r, 4));
            assertTrue(BrownLens.MODEL.toRay(intrinsics, pixel * Math.cos(angle), pixel * Math.sin(angle), out),
                    "radius " + r + " of " + fold);
            assertArrayEquals(new double[] {r * Math.cos(angle), r * Math.sin(angle), 1}, out, 1e-9);
            double beyond = 500 * edge * (1.0001 + 0.01 * k);
            assertFalse(BrownLens.MODEL.toRay(intrinsics, beyond * Math.cos(angle), beyond * Math.sin(angle), out),
                    "pixel " + beyond + " beyond " + 500 * edge);
        }
    }

    @Test
    void theFoldOfACubicLensIsWhereItsDerivativeVanishes() {
        // d/dr (r + k1 r^3) = 0 at r = 1 / sqrt(-3 k1)
        double[] barrel = {300, 300, 320, 240, 0, -0.3, 0, 0, 0, 0};
        assertEquals(Math.atan(1 / Math.sqrt(0.9)), BrownLens.MODEL.reachRad(barrel), 0.002);
        double[] pincushion = {300, 300, 320, 240, 0, 0.2, 0, 0, 0, 0};
        assertTrue(BrownLens.MODEL.reachRad(pincushion) > Math.atan(10), "a pincushion never folds");
    }

    @Test
    void intrinsicsThatAreNoCameraAreRefused() {
        double[] zeroFocal = STRONG.clone();
        zeroFocal[PinholeCamera.FY] = 0;
        double[] notFinite = STRONG.clone();
        notFinite[BrownLens.K3] = Double.NaN;
        assertThrows(IllegalArgumentException.class, () -> PinholeCamera.of(1280, 720, zeroFocal));
        assertThrows(IllegalArgumentException.class, () -> PinholeCamera.of(1280, 720, notFinite));
        assertThrows(IllegalArgumentException.class, () -> PinholeCamera.of(1280, 720, new double[9]));
        assertThrows(IllegalArgumentException.class, () -> PinholeCamera.of(0, 720, STRONG));
        assertThrows(IllegalArgumentException.class, () -> PinholeCamera.ideal(1, 1, -1, 1, 0, 0));
    }

    @Test
    void cameraKeepsItsValuesToItself() {
        double[] values = STRONG.clone();
        PinholeCamera camera = PinholeCamera.of(1280, 720, values);
        values[0] = 1;
        camera.intrinsics()[1] = 1;
        assertArrayEquals(STRONG, camera.intrinsics(), 0);
        PinholeCamera other = camera.withFocal(100, 200);
        assertEquals(100, other.get(PinholeCamera.FX), 0);
        assertEquals(200, other.get(PinholeCamera.FY), 0);
        assertEquals(STRONG[BrownLens.P2], other.get(BrownLens.P2), 0);
        assertTrue(camera.isDistorting());
        assertFalse(PinholeCamera.ideal(10, 10, 5, 5, 5, 5).isDistorting());
    }
}
