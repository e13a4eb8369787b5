package org.cellgauge.internal.posterior;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.PosePrior;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.pose.ReprojectionFit;
import org.cellgauge.internal.pose.RigidMarkerNoise;
import org.cellgauge.internal.sampling.LogDensity;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.settings.RotationPrior;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;

class ChartTest {
    private static final ThesisScene SCENE = ThesisScene.inPlane(3);
    private static final ReferenceView VIEW = ReferenceView.of(SCENE.cell().references(),
            SCENE.detections(0.3, RandomStreams.of(1), 5, 0.01));
    private static final CameraState BASE = CameraState.of(VIEW.cameraFromSet(SCENE.worldFromCamera()),
            ThesisScene.CAMERA);
    private static final IntrinsicsPrior FOCAL = IntrinsicsPrior.focal(ThesisScene.CAMERA, 200);

    private static double[] random(RandomGenerator random, double scale) {
        double[] x = new double[8];
        for (int i = 0; i < 8; i++) {
            x[i] = scale * (i < 3 ? 50 : i < 6 ? 0.5 : 40) * random.nextGaussian();
        }
        return x;
    }

    @Test
    void chartsDecodeWhatTheyEncode() {
        RandomGenerator random = RandomStreams.of(2);
        CameraChart centred = new CentredChart(BASE, FOCAL);
        CameraChart euler = new EulerChart(VIEW.centroidMm(), BASE, FOCAL);
        assertEquals(8, centred.dimension());
        assertEquals(8, euler.dimension());
        assertArrayEquals(new double[8], centred.encode(BASE), 1e-13);
        assertArrayEquals(new double[] {418, 106, 1070, 3.08, 0.10, 0.02, 581, 581}, euler.encode(BASE), 1e-9);
        for (int i = 0; i < 100; i++) {
            double[] x = random(random, 1);
            CameraState state = new CameraState();
            centred.decode(x, state);
            assertArrayEquals(x, centred.encode(state), 1e-11);
            CameraState back = new CameraState();
            euler.decode(euler.encode(state), back);
            assertArrayEquals(state.rotation, back.rotation, 1e-13);
            assertArrayEquals(state.offset, back.offset, 1e-9);
            assertArrayEquals(state.intrinsics, back.intrinsics, 1e-11);
        }
    }

    @Test
    void eulerChartIsTheCameraInTheWorld() {
        CameraState state = new CameraState();
        new EulerChart(VIEW.centroidMm(), BASE, FOCAL).decode(new double[] {400, 90, 1000, 3, 0.2, -0.1, 570, 590},
                state);
        RigidTransform expected = VIEW.cameraFromSet(RigidTransform.ofEuler(400, 90, 1000, 3, 0.2, -0.1));
        assertArrayEquals(expected.rotation(), state.rotation, 1e-14);
        assertArrayEquals(expected.translationMm(), state.offset, 1e-10);
        assertEquals(570, state.intrinsics[PinholeCamera.FX], 0);
        assertEquals(590, state.intrinsics[PinholeCamera.FY], 0);
        assertEquals(640, state.intrinsics[PinholeCamera.CX], 0);
    }

    /** Log of |det| of the change of coordinates from the Euler to the centred chart, by central differences. */
    private static double logDeterminant(CameraChart from, CameraChart to, double[] x) {
        int n = x.length;
        SimpleMatrix j = new SimpleMatrix(n, n);
        CameraState state = new CameraState();
        for (int c = 0; c < n; c++) {
            double h = c < 3 ? 0.05 : c < 6 ? 1e-5 : 0.05;
            double[] plus = x.clone();
            double[] minus = x.clone();
            plus[c] += h;
            minus[c] -= h;
            from.decode(plus, state);
            double[] up = to.encode(state);
            from.decode(minus, state);
            double[] down = to.encode(state);
            for (int r = 0; r < n; r++) {
                j.set(r, c, (up[r] - down[r]) / (2 * h));
            }
        }
        return Math.log(Math.abs(j.determinant()));
    }

    /**
     * One posterior in two charts: densities differ by the volume that the change of coordinates takes, and
     * nothing else.
     */
    @Test
    void densitiesOfOnePosteriorInTwoChartsDifferByTheChangeOfVolume() {
        CameraChart centred = new CentredChart(BASE, FOCAL);
        CameraChart euler = new EulerChart(VIEW.centroidMm(), BASE, FOCAL);
        double[] whitening = new double[192];
        ReprojectionFit.whitening(new RigidMarkerNoise(VIEW, 0.3), BASE, VIEW.blocks(), whitening);
        PosePrior weak = new PosePrior(BASE, 1000, 0.7);
        for (RotationPrior prior : RotationPrior.values()) {
            LogDensity inCentred = new CameraPosterior(centred, new RigidMarkerLikelihood(VIEW, whitening), prior,
                    FOCAL, weak);
            LogDensity inEuler = new CameraPosterior(euler, new RigidMarkerLikelihood(VIEW, whitening), prior, FOCAL,
                    weak);
            RandomGenerator random = RandomStreams.of(3);
            for (int i = 0; i < 30; i++) {
                double[] x = random(random, 1);
                CameraState state = new CameraState();
                centred.decode(x, state);
                double[] e = euler.encode(state);
                double expected = logDeterminant(euler, centred, e);
                double a = inEuler.at(e);
                double b = inCentred.at(x);
                assertEquals(expected, a - b, 1e-6 + 1e-10 * Math.abs(b), prior.toString());
            }
        }
    }

    @Test
    void priorFlatInTheThesisAnglesIsFlatInItsCoordinates() {
        CameraChart euler = new EulerChart(VIEW.centroidMm(), BASE, IntrinsicsPrior.KNOWN);
        LogDensity density = new CameraPosterior(euler, state -> 0, RotationPrior.FLAT_IN_EULER_ANGLES,
                IntrinsicsPrior.KNOWN, null);
        LogDensity uniform = new CameraPosterior(euler, state -> 0, RotationPrior.UNIFORM, IntrinsicsPrior.KNOWN, null);
        double at = density.at(new double[6]);
        for (double theta : new double[] {-1.5, -0.3, 0.1, 1, 1.57, 2, 4}) {
            assertEquals(at, density.at(new double[] {1, 2, 3, 0.4, theta, 5}), 1e-9);
            assertEquals(Math.log(Math.abs(Math.cos(theta))), uniform.at(new double[] {1, 2, 3, 0.4, theta, 5}), 1e-9);
        }
    }

    /** Flat in camera position is flat in the offset: at a fixed rotation the one is an isometry of the other. */
    @Test
    void equalStepsOfTheCentredOffsetAreEqualStepsOfTheCamera() {
        CameraChart centred = new CentredChart(BASE, FOCAL);
        RandomGenerator random = RandomStreams.of(4);
        for (int i = 0; i < 10; i++) {
            double[] x = random(random, 1);
            SimpleMatrix j = new SimpleMatrix(3, 3);
            for (int c = 0; c < 3; c++) {
                double[] moved = x.clone();
                moved[c] += 1;
                double[] a = centre(centred, moved);
                double[] b = centre(centred, x);
                for (int r = 0; r < 3; r++) {
                    j.set(r, c, a[r] - b[r]);
                }
            }
            assertArrayEquals(SimpleMatrix.identity(3).getDDRM().data, j.transpose().mult(j).getDDRM().data, 1e-9);
        }
    }

    private static double[] centre(CameraChart chart, double[] x) {
        CameraState state = new CameraState();
        chart.decode(x, state);
        return VIEW.worldFromCamera(state.cameraFromSet()).translationMm();
    }

    @Test
    void rotationsBeyondAHalfTurnAreNotCountedTwice() {
        CameraChart centred = new CentredChart(BASE, IntrinsicsPrior.KNOWN);
        assertEquals(Double.NEGATIVE_INFINITY, centred.logMeasure(new double[] {0, 0, 0, 0, 3.2, 0}), 0);
        assertEquals(Rotations.logHaarDensity(0, 3.1, 0), centred.logMeasure(new double[] {0, 0, 0, 0, 3.1, 0}), 0);
        LogDensity density = new CameraPosterior(centred, state -> 0, RotationPrior.UNIFORM, IntrinsicsPrior.KNOWN,
                null);
        assertEquals(Double.NEGATIVE_INFINITY, density.at(new double[] {0, 0, 0, Double.NaN, 0, 0}), 0);
        LogDensity broken = new CameraPosterior(centred, state -> Double.NaN, RotationPrior.UNIFORM,
                IntrinsicsPrior.KNOWN, null);
        assertEquals(Double.NEGATIVE_INFINITY, broken.at(new double[6]), 0);
    }

    @Test
    void posteriorIsTheSumOfItsParts() {
        CameraChart centred = new CentredChart(BASE, FOCAL);
        PosePrior pose = new PosePrior(BASE, 100, 0.5);
        LogDensity density = new CameraPosterior(centred, state -> 1000 + state.offset[0], RotationPrior.UNIFORM, FOCAL,
                pose);
        double[] x = {30, -200, 0, 0.6, 0, 0.8, 100, 0};
        // Gaussians of 0.3, -2 and 0 deviations in position, of 2 in rotation and of 0.5 in the focal length
        double priors = -0.5 * (0.09 + 4 + 4 + 0.25) + 2 * Math.log(Math.sin(0.5) / 0.5);
        assertEquals(1000 + BASE.offset[0] + 30 + priors, density.at(x), 1e-9);
    }

    @Test
    void negativeFocalLengthIsImpossible() {
        CameraChart centred = new CentredChart(BASE, FOCAL);
        LogDensity density = new CameraPosterior(centred, state -> 0, RotationPrior.UNIFORM, FOCAL, null);
        assertEquals(Double.NEGATIVE_INFINITY, density.at(new double[] {0, 0, 0, 0, 0, 0, -600, 0}), 0);
        assertEquals(-0.5 * 0.25, density.at(new double[] {0, 0, 0, 0, 0, 0, 0, 100}), 1e-12);
    }

    @Test
    void objectPosteriorIsCornerNoiseAndTheUniformMeasure() {
        RigidTransform pose = RigidTransform.ofEuler(30, -40, 900, 3, 0.2, 0.5);
        CameraState base = CameraState.of(pose, ThesisScene.CAMERA);
        double[] corners = new double[8];
        double[] local = org.cellgauge.internal.geometry.MarkerGeometry.cornersMm(47);
        for (int k = 0; k < 4; k++) {
            double[] c = pose.apply(local[3 * k], local[3 * k + 1], 0);
            double[] uv = ThesisScene.CAMERA.project(c[0], c[1], c[2]);
            corners[2 * k] = uv[0] + 0.1 * k;
            corners[2 * k + 1] = uv[1] - 0.2;
        }
        ObjectPosterior density = new ObjectPosterior(corners, 47, 0.25, base);
        double[] x = {1, -2, 30, 0.1, -0.2, 0.3};
        RigidTransform moved = RigidTransform.ofRotationVector(new double[] {0.1, -0.2, 0.3}, new double[3])
                .compose(RigidTransform.of(pose.rotation(), new double[3]));
        double expected = Rotations.logHaarDensity(0.1, -0.2, 0.3);
        for (int k = 0; k < 4; k++) {
            double[] c = moved.apply(local[3 * k], local[3 * k + 1], 0);
            double[] uv = ThesisScene.CAMERA.project(c[0] + 31, c[1] - 42, c[2] + 930);
            expected -= (Math.pow(uv[0] - corners[2 * k], 2) + Math.pow(uv[1] - corners[2 * k + 1], 2)) / (2 * 0.0625);
        }
        assertEquals(expected, density.at(x), 1e-9 * Math.abs(expected));
        CameraState state = new CameraState();
        density.decode(x, state);
        assertArrayEquals(moved.rotation(), state.rotation, 1e-14);
        density.setBase(state);
        assertEquals(expected - Rotations.logHaarDensity(0.1, -0.2, 0.3), density.at(new double[6]), 1e-8);
        for (double[] bad : new double[][] {{0, 0, -2000, 0, 0, 0}, {0, 0, 0, 3, 3, 0}, {Double.NaN, 0, 0, 0, 0, 0},
            {0, 0, 0, Double.NaN, 0, 0}}) {
            assertEquals(Double.NEGATIVE_INFINITY, density.at(bad), 0);
        }
    }
}
