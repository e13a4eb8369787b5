package org.cellgauge.geometry;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.alg.distort.kanbra.KannalaBrandtStoP_F64;
import boofcv.struct.calib.CameraKannalaBrandt;
import georegression.struct.point.Point2D_F64;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;

class KannalaBrandtLensTest {
    private static final double[] VALUES = {286, 287, 424, 400, 0.5, -0.008, 0.043, -0.0399, 0.0069};

    private static double[] point(RandomGenerator random) {
        return new double[] {1000 * random.nextGaussian(), 1000 * random.nextGaussian(), 300 * random.nextDouble()};
    }

    @Test
    void projectionIsTheWrittenFormula() {
        RandomGenerator random = new Well19937c(1);
        PinholeCamera camera = PinholeCamera.of(KannalaBrandtLens.MODEL, 848, 800, VALUES);
        for (int k = 0; k < 200; k++) {
            double[] p = point(random);
            double t = Math.acos(p[2] / Math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
            double phi = Math.atan2(p[1], p[0]);
            double r = t + VALUES[5] * Math.pow(t, 3) + VALUES[6] * Math.pow(t, 5) + VALUES[7] * Math.pow(t, 7)
                    + VALUES[8] * Math.pow(t, 9);
            double[] expected = {286 * r * Math.cos(phi) + 0.5 * r * Math.sin(phi) + 424,
                287 * r * Math.sin(phi) + 400};
            assertArrayEquals(expected, camera.project(p[0], p[1], p[2]), 1e-9);
        }
    }

    @Test
    void projectionIsThatOfTheImageLibrary() {
        RandomGenerator random = new Well19937c(2);
        CameraKannalaBrandt theirs = new CameraKannalaBrandt(5, 0).fsetK(286, 287, 0.5, 424, 400)
                .fsetSymmetric(1, VALUES[5], VALUES[6], VALUES[7], VALUES[8]);
        KannalaBrandtStoP_F64 toPixel = new KannalaBrandtStoP_F64(theirs);
        PinholeCamera camera = PinholeCamera.of(KannalaBrandtLens.MODEL, 848, 800, VALUES);
        Point2D_F64 px = new Point2D_F64();
        for (int k = 0; k < 200; k++) {
            double[] p = point(random);
            double d = Math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
            toPixel.compute(p[0] / d, p[1] / d, p[2] / d, px);
            assertArrayEquals(new double[] {px.x, px.y}, camera.project(p[0], p[1], p[2]), 1e-9);
        }
    }

    @Test
    void reachOfACubicPolynomialIsWhereItsDerivativeVanishes() {
        // d/dt (t + k1 t^3) = 0 at t = 1 / sqrt(-3 k1)
        double[] values = {300, 300, 320, 240, 0, -0.3, 0, 0, 0};
        double fold = 1 / Math.sqrt(0.9);
        assertEquals(fold, KannalaBrandtLens.MODEL.reachRad(values), 1e-3);
        double edge = 300 * (fold - 0.3 * Math.pow(fold, 3));
        double[] ray = new double[3];
        assertTrue(KannalaBrandtLens.MODEL.toRay(values, 320 + 0.999999 * edge, 240, ray));
        assertEquals(fold, Math.acos(ray[2]), 0.003);
        assertFalse(KannalaBrandtLens.MODEL.toRay(values, 320 + 1.000001 * edge, 240, ray));
        assertFalse(KannalaBrandtLens.MODEL.project(values, Math.sin(1.2), 0, Math.cos(1.2), new double[2], 0));
    }

    @Test
    void aPolynomialThatRisesAgainIsFollowedToItsFirstTopAlone() {
        // 1 - 0.9 t² + 0.15 t⁴ falls between 1.20 and 2.15 rad: r reaches 0.758 at 1.20 and, again, at some 2.7
        double[] values = {1, 1, 0, 0, 0, -0.3, 0.03, 0, 0};
        double reach = KannalaBrandtLens.MODEL.reachRad(values);
        assertEquals(Math.sqrt((0.9 - Math.sqrt(0.81 - 0.6)) / 0.3), reach, 1e-3);
        double[] ray = new double[3];
        double top = reach - 0.3 * Math.pow(reach, 3) + 0.03 * Math.pow(reach, 5);
        assertTrue(KannalaBrandtLens.MODEL.toRay(values, 0.99 * top, 0, ray));
        assertTrue(Math.acos(ray[2]) < reach);
        assertFalse(KannalaBrandtLens.MODEL.toRay(values, 1.01 * top, 0, ray));
    }
}
