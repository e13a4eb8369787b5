package org.cellgauge.internal.pose;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MarkerPoseFinderTest {
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(1280, 720, 581, 581, 640, 360);
    private static final double SIZE = 47;

    static double[] corners(RigidTransform cameraFromMarker, PinholeCamera camera) {
        double[] c = MarkerGeometry.cornersMm(cameraFromMarker, SIZE);
        double[] px = new double[8];
        for (int k = 0; k < 4; k++) {
            System.arraycopy(camera.project(c[3 * k], c[3 * k + 1], c[3 * k + 2]), 0, px, 2 * k, 2);
        }
        return px;
    }

    /** Half the sum of squared residuals, written independently of the fit. */
    static double cost(RigidTransform pose, double[] observed, double std, PinholeCamera camera) {
        double[] px = corners(pose, camera);
        double sum = 0;
        for (int i = 0; i < 8; i++) {
            sum += (px[i] - observed[i]) * (px[i] - observed[i]) / (2 * std * std);
        }
        return sum;
    }

    private static void assertLocalMinimum(RigidTransform pose, double[] observed, double std) {
        double at = cost(pose, observed, std, CAMERA);
        RandomGenerator random = new Well19937c(1);
        for (int i = 0; i < 300; i++) {
            double[] w = new double[3];
            double[] t = pose.translationMm();
            for (int k = 0; k < 3; k++) {
                w[k] = 1e-3 * random.nextGaussian();
                t[k] += 0.02 * random.nextGaussian();
            }
            RigidTransform turned = RigidTransform.ofRotationVector(w, new double[3])
                    .compose(RigidTransform.of(pose.rotation(), new double[3]));
            assertTrue(cost(RigidTransform.of(turned.rotation(), t), observed, std, CAMERA) > at - 1e-9);
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void exactCornersGiveTheExactPoseEvenWhereASecondModeIsNear(long seed) {
        RandomGenerator random = new Well19937c(seed);
        for (int i = 0; i < 25; i++) {
            double tilt = 0.05 + 0.9 * random.nextDouble();
            double around = 2 * Math.PI * random.nextDouble();
            RigidTransform truth = RigidTransform.ofRotationVector(
                    new double[] {tilt * Math.cos(around), tilt * Math.sin(around), 0},
                    new double[] {300 * random.nextGaussian(), 150 * random.nextGaussian(),
                        700 + 600 * random.nextDouble()})
                    .compose(RigidTransform.ofEuler(0, 0, 0, Math.PI, 0, 3 * random.nextDouble()));
            for (PinholeCamera camera : new PinholeCamera[] {CAMERA, InitialPoseTest.STRONG}) {
                RigidTransform best = new MarkerPoseFinder().best(corners(truth, camera), SIZE, camera);
                assertTrue(truth.angleRadTo(best) < 1e-5, "off by " + truth.angleRadTo(best) + " at " + truth);
            }
        }
    }

    @Test
    void smallNearlyFrontalMarkerHasTwoModesMirroredAboutTheLineOfSight() {
        RigidTransform truth = RigidTransform.ofRotationVector(new double[] {0.2, 0.1, 0}, new double[] {30, -40, 1070})
                .compose(RigidTransform.ofEuler(0, 0, 0, Math.PI, 0, 0.4));
        double[] observed = corners(truth, CAMERA);
        List<PoseMode> modes = new MarkerPoseFinder().modes(observed, SIZE, CAMERA, 0.3);
        assertEquals(2, modes.size());
        RigidTransform a = modes.get(0).state().cameraFromSet();
        RigidTransform b = modes.get(1).state().cameraFromSet();
        assertLocalMinimum(a, observed, 0.3);
        assertLocalMinimum(b, observed, 0.3);
        assertTrue(Math.min(truth.angleRadTo(a), truth.angleRadTo(b)) < 1e-6);
        // the two normals and the line of sight: same angle to it, on opposite sides, up to perspective's small share
        double[] t = truth.translationMm();
        double range = Math.sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
        double[] sum = new double[3];
        for (int i = 0; i < 3; i++) {
            sum[i] = a.rotation()[3 * i + 2] + b.rotation()[3 * i + 2];
        }
        double along = (sum[0] * t[0] + sum[1] * t[1] + sum[2] * t[2]) / range;
        double length = Math.sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
        assertEquals(-1, along / length, 0.02);
    }

    @Test
    void weightsOfTheModesAreLaplacesMasses() {
        RigidTransform truth = RigidTransform.ofRotationVector(new double[] {0.25, 0, 0}, new double[] {0, 0, 600})
                .compose(RigidTransform.ofEuler(0, 0, 0, Math.PI, 0, 0));
        double[] observed = corners(truth, CAMERA);
        List<PoseMode> modes = new MarkerPoseFinder().modes(observed, SIZE, CAMERA, 0.3);
        assertEquals(2, modes.size());
        double expected = 0;
        for (int m = 0; m < 2; m++) {
            RigidTransform pose = modes.get(m).state().cameraFromSet();
            double determinant = new org.ejml.simple.SimpleMatrix(6, 6, true, modes.get(m).covariance()).determinant();
            expected += (m == 0 ? 1 : -1) * (0.5 * Math.log(determinant) - cost(pose, observed, 0.3, CAMERA));
        }
        assertEquals(expected, modes.get(0).logWeight() - modes.get(1).logWeight(), 1e-6);
        assertTrue(expected >= 0);
    }

    @Test
    void largeTiltedMarkerHasOneModeOfAnyWeight() {
        RigidTransform truth = RigidTransform.ofRotationVector(new double[] {0.7, 0, 0}, new double[] {0, 0, 120})
                .compose(RigidTransform.ofEuler(0, 0, 0, Math.PI, 0, 0));
        List<PoseMode> modes = new MarkerPoseFinder().modes(corners(truth, CAMERA), SIZE, CAMERA, 0.3);
        assertTrue(truth.angleRadTo(modes.get(0).state().cameraFromSet()) < 1e-6);
        assertTrue(modes.size() == 1 || modes.get(0).logWeight() - modes.get(1).logWeight() > 100);
    }

    /** Work space is used again: nothing of one marker may be left in the figures of the next. */
    @Test
    void aPoseDoesNotDependOnThoseFoundBefore() {
        RandomGenerator random = new Well19937c(5);
        MarkerPoseFinder used = new MarkerPoseFinder();
        double[] whitening = new double[64];
        for (int i = 0; i < 8; i++) {
            whitening[9 * i] = 1 + random.nextDouble();
            whitening[8 * i] += i == 0 ? 0 : 0.2;
        }
        PinholeCamera[] cameras = {CAMERA, InitialPoseTest.STRONG};
        for (int i = 0; i < 30; i++) {
            RigidTransform truth = RigidTransform.ofRotationVector(
                    new double[] {0.6 * random.nextDouble(), 0.6 * random.nextDouble(), 0},
                    new double[] {100 * random.nextGaussian(), 100 * random.nextGaussian(),
                        700 + 600 * random.nextDouble()})
                    .compose(RigidTransform.ofEuler(0, 0, 0, Math.PI, 0, 3 * random.nextDouble()));
            PinholeCamera camera = cameras[i % 2];
            double size = i % 3 == 0 ? SIZE : 2 * SIZE;
            double[] observed = MarkerGeometry.cornersPx(camera, truth, size);
            // corners of nothing in between: a search that fails must leave nothing behind either
            used.modes(new double[8], size, camera, 1);
            assertSame(new MarkerPoseFinder().modes(observed, size, camera, 0.3),
                    used.modes(observed, size, camera, 0.3));
            assertSame(new MarkerPoseFinder().modes(observed, size, camera, whitening),
                    used.modes(observed, size, camera, whitening));
        }
    }

    private static void assertSame(List<PoseMode> expected, List<PoseMode> actual) {
        assertEquals(expected.size(), actual.size());
        for (int m = 0; m < expected.size(); m++) {
            PoseMode a = expected.get(m);
            PoseMode b = actual.get(m);
            assertArrayEquals(a.state().rotation, b.state().rotation);
            assertArrayEquals(a.state().offset, b.state().offset);
            assertArrayEquals(a.covariance(), b.covariance());
            assertArrayEquals(a.whitening(), b.whitening());
            assertArrayEquals(a.placementPx2(), b.placementPx2());
            assertArrayEquals(a.comparedPx(), b.comparedPx());
            assertArrayEquals(a.pointsMm(), b.pointsMm());
            assertArrayEquals(a.jacobian(0), b.jacobian(0));
            assertArrayEquals(a.whitenedResiduals(0), b.whitenedResiduals(0));
            assertEquals(a.logWeight(), b.logWeight());
        }
    }
}
