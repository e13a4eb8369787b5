package org.cellgauge.geometry;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
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
import org.junit.jupiter.params.provider.ValueSource;

class ProjectionTest {
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

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void derivativesAreThoseOfTheProjection(boolean distorted) {
        RandomGenerator random = new Well19937c(3);
        double[] intrinsics = STRONG.clone();
        if (!distorted) {
            java.util.Arrays.fill(intrinsics, PinholeCamera.SKEW, PinholeCamera.INTRINSICS, 0);
        }
        double[] uv = new double[2];
        double[] byPoint = new double[6];
        double[] byIntrinsics = new double[2 * PinholeCamera.INTRINSICS];
        for (int k = 0; k < 100; k++) {
            double[] p = random(random);
            assertTrue(Projection.projectWithDerivatives(intrinsics, p[0], p[1], p[2], uv, byPoint, byIntrinsics));
            assertArrayEquals(formula(intrinsics, p), uv, 1e-9);
            for (int c = 0; c < 3; c++) {
                // third-order error of a central difference at this step is 1e-8 relative, rounding 1e-9
                double h = 1e-4 * p[2];
                double[] plus = p.clone();
                double[] minus = p.clone();
                plus[c] += h;
                minus[c] -= h;
                double[] up = formula(intrinsics, plus);
                double[] down = formula(intrinsics, minus);
                for (int r = 0; r < 2; r++) {
                    assertEquals((up[r] - down[r]) / (2 * h) * p[2], byPoint[3 * r + c] * p[2], 1e-6 * 600);
                }
            }
            for (int c = 0; c < PinholeCamera.INTRINSICS; c++) {
                // the image is linear in each intrinsic value alone: no error but rounding
                double h = c < PinholeCamera.K1 ? 1 : 0.01;
                double[] plus = intrinsics.clone();
                double[] minus = intrinsics.clone();
                plus[c] += h;
                minus[c] -= h;
                double[] up = formula(plus, p);
                double[] down = formula(minus, p);
                for (int r = 0; r < 2; r++) {
                    assertEquals((up[r] - down[r]) / (2 * h), byIntrinsics[PinholeCamera.INTRINSICS * r + c], 1e-9);
                }
            }
        }
    }

    @Test
    void derivativesByPointAloneAreTheSame() {
        double[] with = new double[6];
        double[] without = new double[6];
        double[] uv = new double[2];
        Projection.projectWithDerivatives(STRONG, 300, -200, 900, uv, with, new double[20]);
        Projection.projectWithDerivatives(STRONG, 300, -200, 900, uv, without, null);
        assertArrayEquals(with, without, 0);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.0, -1, Double.NaN, Double.NEGATIVE_INFINITY})
    void pointsNotInFrontOfTheCameraHaveNoImage(double z) {
        double[] uv = {7, 8};
        assertFalse(Projection.project(STRONG, 1, 2, z, uv, 0));
        assertFalse(Projection.projectWithDerivatives(STRONG, 1, 2, z, uv, new double[6], null));
        assertArrayEquals(new double[] {7, 8}, uv, 0);
        assertNull(PinholeCamera.of(1280, 720, STRONG).project(1, 2, z));
    }

    @Test
    void normalisedPointComesBackFromItsPixel() {
        RandomGenerator random = new Well19937c(4);
        PinholeCamera camera = PinholeCamera.of(1280, 720, STRONG);
        double[] out = new double[2];
        for (int k = 0; k < 500; k++) {
            double[] p = random(random);
            double[] uv = camera.project(p[0], p[1], p[2]);
            assertTrue(camera.toNormalised(uv[0], uv[1], out));
            assertArrayEquals(new double[] {p[0] / p[2], p[1] / p[2]}, out, 1e-11);
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
        double[] out = new double[2];
        for (int k = 0; k < 400; k++) {
            double angle = 0.7 * k;
            double r = fold * k / 401;
            double pixel = 500 * r * (1 + k1 * r * r + k2 * Math.pow(r, 4));
            assertTrue(Projection.toNormalised(intrinsics, pixel * Math.cos(angle), pixel * Math.sin(angle), out),
                    "radius " + r + " of " + fold);
            assertArrayEquals(new double[] {r * Math.cos(angle), r * Math.sin(angle)}, out, 1e-9);
            double beyond = 500 * edge * (1.0001 + 0.01 * k);
            assertFalse(Projection.toNormalised(intrinsics, beyond * Math.cos(angle), beyond * Math.sin(angle), out),
                    "pixel " + beyond + " beyond " + 500 * edge);
        }
    }

    @Test
    void pixelThatIsNoNumberHasNoSource() {
        double[] out = new double[2];
        assertFalse(Projection.toNormalised(STRONG, Double.NaN, 3, out));
        assertFalse(Projection.toNormalised(STRONG, 3, Double.POSITIVE_INFINITY, out));
    }

    @Test
    void intrinsicsThatAreNoCameraAreRefused() {
        double[] zeroFocal = STRONG.clone();
        zeroFocal[PinholeCamera.FY] = 0;
        double[] notFinite = STRONG.clone();
        notFinite[PinholeCamera.K3] = Double.NaN;
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
        assertEquals(STRONG[PinholeCamera.P2], other.get(PinholeCamera.P2), 0);
        assertTrue(camera.hasDistortion());
        assertFalse(PinholeCamera.ideal(10, 10, 5, 5, 5, 5).hasDistortion());
    }
}
