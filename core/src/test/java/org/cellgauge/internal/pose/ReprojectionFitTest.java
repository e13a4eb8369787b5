package org.cellgauge.internal.pose;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.sampling.RandomStreams;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;

class ReprojectionFitTest {
    private static final PinholeCamera STRONG = InitialPoseTest.STRONG;
    private static final ReferenceView VIEW = ReferenceNoiseTest.view();
    private static final IntrinsicsPrior ALL = IntrinsicsPrior.of(STRONG, new int[] {0, 1, 2, 3, 4, 5, 6, 7, 8, 9},
            new double[] {200, 150, 20, 30, 1, 0.1, 0.2, 0.3, 0.01, 0.02});

    private static CameraState state() {
        return CameraState.of(VIEW.cameraFromSet(ThesisScene.WORLD_FROM_CAMERA), STRONG);
    }

    private static PosePrior posePrior() {
        CameraState base = new CameraState();
        base.setMoved(state(), new double[] {30, -20, 50, 0.5, -0.9, 0.7}, 0);
        return new PosePrior(base, 1000, 0.7);
    }

    private static CameraState moved(CameraState from, IntrinsicsPrior prior, int column, double by) {
        double[] step = new double[6];
        if (column < 6) {
            step[column] = by;
        }
        CameraState state = new CameraState();
        state.setMoved(from, step, 0);
        if (column >= 6) {
            state.intrinsics[prior.index(column - 6)] += by;
        }
        return state;
    }

    @Test
    void chartDerivativesAreThoseOfTheWhitenedResiduals() {
        ReprojectionFit fit = new ReprojectionFit(VIEW.points(), VIEW.observed(), ALL, posePrior());
        CameraState state = state();
        state.intrinsics[PinholeCamera.FX] += 20;
        assertTrue(fit.freeze(new RigidMarkerNoise(VIEW, 0.3), state));
        assertEquals(16, fit.columns());
        assertEquals(32 + 10 + 6, fit.rows());
        double[] jacobian = fit.jacobianAt(state);
        for (int c = 0; c < fit.columns(); c++) {
            double h = c < 3 ? 0.05 : c < 6 ? 1e-4 : c < 11 ? 0.5 : 1e-3;
            fit.evaluate(moved(state, ALL, c, h), false);
            double[] plus = fit.residuals().clone();
            fit.evaluate(moved(state, ALL, c, -h), false);
            double[] minus = fit.residuals().clone();
            double largest = 0;
            for (int r = 0; r < fit.rows(); r++) {
                largest = Math.max(largest, Math.abs(plus[r] - minus[r]) / (2 * h));
            }
            for (int r = 0; r < fit.rows(); r++) {
                assertEquals((plus[r] - minus[r]) / (2 * h), jacobian[r * fit.columns() + c], 1e-6 * largest,
                        "row " + r + " column " + c);
            }
        }
    }

    @Test
    void costIsMinusTheLogDensityOfPriorsAndCorners() {
        PosePrior posePrior = posePrior();
        CameraState state = moved(moved(state(), ALL, 1, 8), ALL, 8, 0.1);
        state.intrinsics[0] += 33;
        ReprojectionFit fit = new ReprojectionFit(VIEW.points(), VIEW.observed(), ALL, posePrior);
        fit.setIsotropic(0.4);
        double corners = 0;
        double[] points = VIEW.pointsMm();
        RigidTransform pose = state.cameraFromSet();
        PinholeCamera camera = PinholeCamera.of(1280, 720, state.intrinsics);
        for (int k = 0; k < 16; k++) {
            double[] p = pose.apply(points[3 * k], points[3 * k + 1], points[3 * k + 2]);
            double[] uv = camera.project(p[0], p[1], p[2]);
            corners += Math.pow((uv[0] - VIEW.observed()[2 * k]) / 0.4, 2) / 2;
            corners += Math.pow((uv[1] - VIEW.observed()[2 * k + 1]) / 0.4, 2) / 2;
        }
        double expected = corners - ALL.logDensity(state.intrinsics)
                - posePrior.logDensity(state, new double[9], new double[3]);
        assertEquals(expected, fit.evaluate(state, false), 1e-9 * expected);
        assertEquals(expected, fit.evaluate(state, true), 1e-9 * expected);
    }

    @Test
    void priorsAreGaussianInTheirOwnUnits() {
        double[] intrinsics = STRONG.intrinsics();
        double at = ALL.logDensity(intrinsics);
        intrinsics[1] += 150;
        intrinsics[9] -= 0.04;
        assertEquals(-(1 + 4) / 2.0, ALL.logDensity(intrinsics) - at, 1e-12);
        intrinsics[0] = -1;
        assertEquals(Double.NEGATIVE_INFINITY, ALL.logDensity(intrinsics), 0);

        PosePrior prior = new PosePrior(state(), 100, 0.5);
        CameraState state = new CameraState();
        state.setMoved(state(), new double[] {0, -200, 0, 0.6, 0, 0.8}, 0);
        assertEquals(-(4 + 4) / 2.0, prior.logDensity(state, new double[9], new double[3]), 1e-12);
    }

    @Test
    void fitFindsExactPoseAndIntrinsicsFromFarAway() {
        ThesisScene scene = ThesisScene.oneRaised(6).camera(STRONG);
        ReferenceView view = InitialPoseTest.view(scene, scene.exactDetections());
        PinholeCamera wrong = STRONG.withFocal(500, 700);
        // priors wide enough not to be felt: 1e6 px against an information of single px
        IntrinsicsPrior prior = IntrinsicsPrior.focal(wrong, 1e7);
        ReprojectionFit fit = new ReprojectionFit(view.points(), view.observed(), prior, null);
        fit.setIsotropic(1);
        CameraState truth = CameraState.of(view.cameraFromSet(scene.worldFromCamera()), STRONG);
        CameraState state = CameraState.of(truth.cameraFromSet(), wrong);
        state.setMoved(state, new double[] {80, -60, 150, 0.2, -0.25, 0.4}, 0);
        assertTrue(fit.fit(state) < 1e-6);
        double[] step = state.stepFrom(truth);
        assertArrayEquals(new double[6], step, 1e-3);
        assertEquals(581, state.intrinsics[0], 1e-3);
        assertEquals(590, state.intrinsics[1], 1e-3);
    }

    @Test
    void startBehindTheCameraGivesNoFit() {
        ReprojectionFit fit = new ReprojectionFit(VIEW.points(), VIEW.observed(), IntrinsicsPrior.KNOWN, null);
        fit.setIsotropic(1);
        CameraState state = state();
        state.offset[2] = -1000;
        assertTrue(Double.isNaN(fit.fit(state)));
        assertThrows(IllegalStateException.class, () -> fit.jacobianAt(state));
    }

    private static ReprojectionFit weighed(CameraState at) {
        ReprojectionFit fit = new ReprojectionFit(VIEW.points(), VIEW.observed(), IntrinsicsPrior.KNOWN, null);
        assertTrue(fit.freeze(new RigidMarkerNoise(VIEW, 0.3), at));
        return fit;
    }

    @Test
    void fitLeavesWhatIsKnownOfItsResult() {
        for (int column = 0; column < 6; column++) {
            CameraState state = moved(state(), IntrinsicsPrior.KNOWN, column, column < 3 ? 20 : 0.05);
            ReprojectionFit fit = weighed(state);
            fit.fit(state);
            double[] residuals = fit.residuals().clone();
            double[] jacobian = fit.jacobian().clone();
            double[] information = fit.information().clone();
            fit.evaluate(state, true);
            assertArrayEquals(fit.residuals(), residuals, 0);
            assertArrayEquals(fit.jacobian(), jacobian, 0);
            assertArrayEquals(fit.information(), information, 0);
        }
    }

    @Test
    void informationIsTheSquareOfTheDerivative() {
        CameraState state = state();
        ReprojectionFit fit = new ReprojectionFit(VIEW.points(), VIEW.observed(),
                IntrinsicsPrior.of(STRONG, new int[] {0}, new double[] {200}), null);
        fit.setIsotropic(0.3);
        assertEquals(7, fit.columns());
        double[] j = fit.jacobianAt(state);
        for (int a = 0; a < 7; a++) {
            for (int b = 0; b < 7; b++) {
                double sum = 0;
                for (int k = 0; k < fit.rows(); k++) {
                    sum += j[7 * k + a] * j[7 * k + b];
                }
                assertEquals(sum, fit.information()[7 * a + b], 0);
            }
        }
    }

    @Test
    void equalWeightsAreThoseOfADiagonalMatrix() {
        CameraState state = moved(state(), IntrinsicsPrior.KNOWN, 3, 0.05);
        ReprojectionFit equal = new ReprojectionFit(VIEW.points(), VIEW.observed(), IntrinsicsPrior.KNOWN, null);
        ReprojectionFit diagonal = new ReprojectionFit(VIEW.points(), VIEW.observed(), IntrinsicsPrior.KNOWN, null);
        equal.setIsotropic(0.3);
        diagonal.setWhitening(equal.whitening().clone());
        assertEquals(diagonal.evaluate(state, true), equal.evaluate(state, true), 0);
        assertArrayEquals(diagonal.residuals(), equal.residuals(), 0);
        assertArrayEquals(diagonal.jacobian(), equal.jacobian(), 0);
    }

    @Test
    void fitIsGivenUpWhereItSettlesAtAKnownPlace() {
        CameraState state = moved(state(), IntrinsicsPrior.KNOWN, 0, 20);
        ReprojectionFit fit = weighed(state);
        CameraState end = state.copy();
        fit.fit(end);
        int[] asked = {0};
        CameraState givenUp = state.copy();
        fit.fit(givenUp, at -> {
            asked[0]++;
            return true;
        });
        assertEquals(1, asked[0]);
        double[] left = givenUp.stepFrom(end);
        assertTrue(Math.abs(left[0]) < 1 && Math.abs(left[2]) < 1, "given up before it settles");
        CameraState unknown = state.copy();
        fit.fit(unknown, at -> false);
        assertArrayEquals(end.offset, unknown.offset, 0);
    }

    @Test
    void stepBetweenStatesLeadsFromOneToTheOther() {
        CameraState base = state();
        CameraState other = new CameraState();
        double[] step = {1, -2, 3, 0.4, -0.5, 2};
        other.setMoved(base, step, 0);
        assertArrayEquals(step, other.stepFrom(base), 1e-12);
        CameraState same = state();
        same.setMoved(same, new double[] {9, 1, -2, 3, 0.4, -0.5, 2}, 1);
        assertArrayEquals(other.rotation, same.rotation, 0);
        assertArrayEquals(other.offset, same.offset, 0);
    }

    @Test
    void informationIsTheHessianWhereResidualsVanish() {
        ThesisScene scene = ThesisScene.inPlane(3).camera(STRONG);
        ReferenceView view = InitialPoseTest.view(scene, scene.exactDetections());
        IntrinsicsPrior prior = IntrinsicsPrior.focal(STRONG, 200);
        CameraState truth = CameraState.of(view.cameraFromSet(scene.worldFromCamera()), STRONG);
        ReprojectionFit fit = new ReprojectionFit(view.points(), view.observed(), prior, null);
        assertTrue(fit.freeze(new RigidMarkerNoise(view, 0.3), truth));
        assertEquals(0, fit.evaluate(truth, true), 1e-15);
        int n = fit.columns();
        SimpleMatrix information = new SimpleMatrix(n, n, true, fit.information().clone());
        for (int i = 0; i < n; i++) {
            for (int j = 0; j <= i; j++) {
                // steps of a fiftieth of a deviation: the curvature's own change is of second order in them
                double hi = 0.02 / Math.sqrt(information.get(i, i));
                double hj = 0.02 / Math.sqrt(information.get(j, j));
                double mixed = 0;
                for (int s = 0; s < 4; s++) {
                    double si = s % 2 == 0 ? 1 : -1;
                    double sj = s < 2 ? 1 : -1;
                    mixed += si * sj * fit.evaluate(moved(moved(truth, prior, i, si * hi), prior, j, sj * hj), false);
                }
                assertEquals(information.get(i, j), mixed / (4 * hi * hj),
                        1e-3 * Math.sqrt(information.get(i, i) * information.get(j, j)), i + ", " + j);
            }
        }
    }

    @Test
    void gainIsTheChangeOfTheFitByTheCorners() {
        ThesisScene scene = ThesisScene.oneRaised(3);
        ReferenceView view = InitialPoseTest.view(scene, scene.exactDetections());
        RigidMarkerNoise noise = new RigidMarkerNoise(view, 0.3);
        CameraState truth = CameraState.of(view.cameraFromSet(scene.worldFromCamera()), ThesisScene.CAMERA);
        ReprojectionFit fit = new ReprojectionFit(view.points(), view.observed(), IntrinsicsPrior.KNOWN, null);
        fit.freeze(noise, truth);
        double cost = fit.evaluate(truth, true);
        PoseMode mode = PoseMode.of(fit, truth, cost, null);
        var random = RandomStreams.of(5);
        for (int m = 0; m < 3; m++) {
            double[] observed = view.observedPx();
            double[] change = new double[8];
            for (int i = 0; i < 8; i++) {
                change[i] = 1e-3 * random.nextGaussian();
                observed[8 * m + i] += change[i];
            }
            ReprojectionFit other = new ReprojectionFit(view.points(), observed, IntrinsicsPrior.KNOWN, null);
            other.freeze(noise, truth);
            CameraState state = new CameraState().copyFrom(truth);
            other.fit(state);
            double[] step = state.stepFrom(truth);
            double[] gain = mode.gain(m);
            for (int c = 0; c < 6; c++) {
                double expected = 0;
                for (int i = 0; i < 8; i++) {
                    expected += gain[8 * c + i] * change[i];
                }
                assertEquals(expected, step[c], 1e-3 * 1e-3 * Math.sqrt(mode.covariance()[7 * c]));
            }
        }
    }
}
