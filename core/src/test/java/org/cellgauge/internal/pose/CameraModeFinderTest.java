package org.cellgauge.internal.pose;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.fitting.leastsquares.LeastSquaresBuilder;
import org.apache.commons.math3.fitting.leastsquares.LevenbergMarquardtOptimizer;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.util.Pair;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.sampling.RandomStreams;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

class CameraModeFinderTest {
    private static PoseMode only(List<PoseMode> modes) {
        assertEquals(1, modes.size());
        return modes.get(0);
    }

    @ParameterizedTest
    @MethodSource("org.cellgauge.internal.pose.InitialPoseTest#setUps")
    void exactCornersHaveTheirModeAtTheTruePose(int references, boolean raised, PinholeCamera camera) {
        ThesisScene scene = InitialPoseTest.scene(references, raised, camera);
        ReferenceView view = InitialPoseTest.view(scene, scene.exactDetections());
        CameraState truth = CameraState.of(view.cameraFromSet(scene.worldFromCamera()), camera);
        RigidTransform start = RigidTransform.ofEuler(40, -30, 60, 0.02, -0.05, 0.1).compose(scene.worldFromCamera());
        for (ReferenceNoise noise : new ReferenceNoise[] {new RigidMarkerNoise(view, 0.3),
            new CornerCubeNoise(view, 1)}) {
            PoseMode mode = new CameraModeFinder(view, camera, noise, IntrinsicsPrior.KNOWN, null).modes(start).get(0);
            double[] step = mode.state().stepFrom(truth);
            for (int i = 0; i < 6; i++) {
                assertEquals(0, step[i], 1e-5 * Math.sqrt(mode.covariance()[7 * i]));
            }
            assertEquals(0, mode.halfChiSquare(), 1e-8);
            assertEquals(references, mode.markers());
        }
    }

    /**
     * Residuals over their deviations of corners, by a world pose in Euler angles and a placement error of every
     * reference, and of these errors.
     */
    private static double[] residuals(ReferenceView view, PinholeCamera camera, double[] x) {
        RigidTransform pose = RigidTransform.ofEuler(x[0], x[1], x[2], x[3], x[4], x[5]);
        int n = view.size();
        double[] all = new double[14 * n];
        for (int m = 0; m < n; m++) {
            Reference reference = view.references().get(m);
            double[] t = reference.worldFromMarker().translationMm();
            double[] w = new double[3];
            for (int i = 0; i < 3; i++) {
                t[i] += x[6 + 6 * m + i];
                w[i] = x[9 + 6 * m + i];
                all[8 * n + 6 * m + i] = x[6 + 6 * m + i] / reference.placement().stdMm(i);
                all[8 * n + 6 * m + 3 + i] = w[i] / reference.placement().stdRad();
            }
            RigidTransform placed = RigidTransform.ofRotationVector(w, t)
                    .compose(RigidTransform.of(reference.worldFromMarker().rotation(), new double[3]));
            double[] px = ReferenceNoiseTest.project(pose, placed, reference.sizeMm(), camera);
            for (int i = 0; i < 8; i++) {
                all[8 * m + i] = (px[i] - view.observed()[8 * m + i]) / 0.3;
            }
        }
        return all;
    }

    @ParameterizedTest
    @CsvSource({"2, false, 1, 0.01", "3, false, 5, 0.01", "4, true, 5, 0.05",
        "3, true, 20, 0.01", "6, false, 20, 0.05"})
    void modeIsTheOptimumThatAnotherOptimiserFinds(int references, boolean raised, double stdMm, double stdRad) {
        PinholeCamera camera = InitialPoseTest.STRONG;
        ThesisScene scene = InitialPoseTest.scene(references, raised, camera).placement(stdMm, stdRad);
        ReferenceView view = InitialPoseTest.view(scene,
                scene.detections(0.3, RandomStreams.of(11, references), stdMm, stdRad));
        PoseMode mode = new CameraModeFinder(view, camera, new RigidMarkerNoise(view, 0.3), IntrinsicsPrior.KNOWN, null)
                .modes(scene.worldFromCamera()).get(0);

        // pose and placement errors all as unknowns
        double[] t = scene.worldFromCamera().translationMm();
        double[] e = scene.worldFromCamera().eulerRad();
        double[] start = Arrays.copyOf(new double[] {t[0], t[1], t[2], e[0], e[1], e[2]}, 6 + 6 * references);
        var problem = new LeastSquaresBuilder().start(start).target(new double[14 * view.size()]).maxEvaluations(2000)
                .maxIterations(2000).model(point -> {
                    double[] x = point.toArray();
                    double[][] j = new double[14 * view.size()][x.length];
                    for (int c = 0; c < x.length; c++) {
                        double h = c % 6 < 3 ? 0.01 : 1e-5;
                        double[] plus = x.clone();
                        double[] minus = x.clone();
                        plus[c] += h;
                        minus[c] -= h;
                        double[] up = residuals(view, camera, plus);
                        double[] down = residuals(view, camera, minus);
                        for (int r = 0; r < up.length; r++) {
                            j[r][c] = (up[r] - down[r]) / (2 * h);
                        }
                    }
                    return new Pair<>(new ArrayRealVector(residuals(view, camera, x), false),
                            new Array2DRowRealMatrix(j, false));
                }).build();
        var optimum = new LevenbergMarquardtOptimizer().withCostRelativeTolerance(1e-14)
                .withParameterRelativeTolerance(1e-14).optimize(problem);
        double[] x = optimum.getPoint().toArray();
        CameraState theirs = CameraState.of(view.cameraFromSet(RigidTransform.ofEuler(x[0], x[1], x[2], x[3], x[4],
                x[5])),
                camera);
        double[] step = mode.state().stepFrom(theirs);
        for (int i = 0; i < 6; i++) {
            assertEquals(0, step[i], 1e-4 * Math.sqrt(mode.covariance()[7 * i]));
        }
        for (int i = 0; i < 6 * references; i++) {
            assertEquals(x[6 + i], mode.placed().errors()[i], 1e-4 * (i % 6 < 3 ? stdMm : stdRad));
        }
        assertEquals(Math.pow(optimum.getCost(), 2) / 2, mode.halfChiSquare(), 1e-5 * mode.halfChiSquare());
        double sum = 0;
        for (int m = 0; m < view.size(); m++) {
            sum += mode.chiSquareOf(m);
        }
        assertEquals(2 * mode.halfChiSquare(), sum, 1e-9 * sum);

        // covariance of the world pose, by the optimiser's own information
        SimpleMatrix information = new SimpleMatrix(optimum.getJacobian().transpose()
                .multiply(optimum.getJacobian()).getData());
        SimpleMatrix theirCovariance = information.invert().extractMatrix(0, 6, 0, 6);
        SimpleMatrix byChart = new SimpleMatrix(6, 6);
        for (int c = 0; c < 6; c++) {
            double h = c < 3 ? 0.01 : 1e-5;
            double[][] ends = new double[2][6];
            for (int s = 0; s < 2; s++) {
                double[] d = new double[6];
                d[c] = s == 0 ? h : -h;
                CameraState moved = new CameraState();
                moved.setMoved(mode.state(), d, 0);
                RigidTransform world = view.worldFromCamera(moved.cameraFromSet());
                System.arraycopy(world.translationMm(), 0, ends[s], 0, 3);
                System.arraycopy(world.eulerRad(), 0, ends[s], 3, 3);
            }
            for (int r = 0; r < 6; r++) {
                double difference = ends[0][r] - ends[1][r];
                byChart.set(r, c, (r < 3 ? difference : Math.IEEEremainder(difference, 2 * Math.PI)) / (2 * h));
            }
        }
        SimpleMatrix ours = byChart.mult(new SimpleMatrix(6, 6, true, mode.covariance())).mult(byChart.transpose());
        for (int i = 0; i < 6; i++) {
            for (int j = 0; j < 6; j++) {
                assertEquals(theirCovariance.get(i, j), ours.get(i, j),
                        1e-4 * Math.sqrt(theirCovariance.get(i, i) * theirCovariance.get(j, j)));
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"false, 5", "true, 5", "false, 20", "true, 20"})
    void covariancesFrozenAtTheModeAreThoseOfTheMode(boolean cube, double stdMm) {
        ThesisScene scene = ThesisScene.inPlane(4).placement(stdMm, 0.01);
        ReferenceView view = InitialPoseTest.view(scene, scene.detections(0.3, RandomStreams.of(12), stdMm, 0.01));
        ReferenceNoise noise = cube ? new CornerCubeNoise(view, 0.5) : new RigidMarkerNoise(view, 0.3);
        PoseMode mode = only(new CameraModeFinder(view, ThesisScene.CAMERA, noise, IntrinsicsPrior.KNOWN, null)
                .modes(scene.worldFromCamera()));
        double[] whitening = new double[64 * 4];
        ReferenceNoise atMode = noise.about(mode.placed());
        assertTrue(ReprojectionFit.whitening(atMode, mode.state(), mode.blocks(), whitening));
        double largest = 0;
        for (double w : whitening) {
            largest = Math.max(largest, Math.abs(w));
        }
        assertArrayEquals(whitening, mode.whitening(), 1e-6 * largest);

        // stationary: a central difference of the frozen log posterior, in standard deviations
        ReprojectionFit fit = new ReprojectionFit(mode.pointsMm(), mode.comparedPx(), IntrinsicsPrior.KNOWN, null);
        assertTrue(fit.freeze(atMode, mode.state()));
        for (int c = 0; c < 6; c++) {
            double std = Math.sqrt(mode.covariance()[7 * c]);
            double[] d = new double[6];
            CameraState moved = new CameraState();
            d[c] = 1e-3 * std;
            moved.setMoved(mode.state(), d, 0);
            double up = fit.evaluate(moved, false);
            d[c] = -1e-3 * std;
            moved.setMoved(mode.state(), d, 0);
            assertEquals(0, (up - fit.evaluate(moved, false)) / 2e-3, 2e-5);
        }
    }

    @Test
    void startsFarApartLeadToTheSameMode() {
        ThesisScene scene = ThesisScene.oneRaised(4);
        ReferenceView view = InitialPoseTest.view(scene, scene.detections(0.3, RandomStreams.of(13), 5, 0.01));
        CameraModeFinder finder = new CameraModeFinder(view, ThesisScene.CAMERA, new RigidMarkerNoise(view, 0.3),
                IntrinsicsPrior.focal(ThesisScene.CAMERA, 200), null);
        PoseMode a = finder.modes(scene.worldFromCamera()).get(0);
        PoseMode b = finder.modes(RigidTransform.ofEuler(100, -50, 150, 0.1, 0.1, -0.3)
                .compose(scene.worldFromCamera()))
                .get(0);
        assertEquals(8, a.dimension());
        double[] step = a.state().stepFrom(b.state());
        for (int i = 0; i < 6; i++) {
            assertEquals(0, step[i], 1e-4 * Math.sqrt(a.covariance()[9 * i]));
        }
        assertEquals(a.state().intrinsics[0], b.state().intrinsics[0], 1e-4 * Math.sqrt(a.covariance()[54]));
    }

    @Test
    void oneSmallReferenceSeenNearlyFrontallyHasBothItsModes() {
        ThesisScene scene = ThesisScene.inPlane(1).placement(1, 0.001)
                .cameraAt(RigidTransform.ofEuler(300, 500, 1000, 3.0, 0.15, 0.02));
        ReferenceView view = InitialPoseTest.view(scene, scene.exactDetections());
        RigidMarkerNoise noise = new RigidMarkerNoise(view, 0.3);
        CameraModeFinder finder = new CameraModeFinder(view, ThesisScene.CAMERA, noise, IntrinsicsPrior.KNOWN, null);
        List<PoseMode> modes = finder.modes(scene.worldFromCamera());
        assertEquals(2, modes.size());
        assertTrue(modes.get(0).logWeight() >= modes.get(1).logWeight());
        double nearest = Double.POSITIVE_INFINITY;
        for (PoseMode mode : modes) {
            nearest = Math.min(nearest, mode.state().cameraFromSet()
                    .angleRadTo(view.cameraFromSet(scene.worldFromCamera())));
            ReprojectionFit fit = new ReprojectionFit(mode.pointsMm(), mode.comparedPx(), IntrinsicsPrior.KNOWN, null);
            assertTrue(fit.freeze(noise.about(mode.placed()), mode.state()));
            double at = fit.evaluate(mode.state(), false);
            var random = RandomStreams.of(14);
            for (int i = 0; i < 200; i++) {
                double[] d = new double[6];
                for (int k = 0; k < 6; k++) {
                    d[k] = 0.05 * Math.sqrt(mode.covariance()[7 * k]) * random.nextGaussian();
                }
                CameraState moved = new CameraState();
                moved.setMoved(mode.state(), d, 0);
                assertTrue(fit.evaluate(moved, false) >= at - 1e-9);
            }
        }
        assertEquals(0, nearest, 1e-6);
        // Laplace's mass: height of the normal density of the residuals times the volume of the mode
        double[] mass = new double[2];
        for (int i = 0; i < 2; i++) {
            double[] placement = new double[64];
            double[] pixel = new double[64];
            noise.about(modes.get(i).placed()).covariance(modes.get(i).state(), 0, placement, pixel);
            SimpleMatrix residuals = new SimpleMatrix(8, 8, true, placement).plus(new SimpleMatrix(8, 8, true, pixel));
            SimpleMatrix volume = new SimpleMatrix(6, 6, true, modes.get(i).covariance());
            mass[i] = 0.5 * Math.log(volume.determinant()) - 0.5 * Math.log(residuals.determinant())
                    - modes.get(i).halfChiSquare();
        }
        assertEquals(mass[0] - mass[1], modes.get(0).logWeight() - modes.get(1).logWeight(), 1e-4);
        // from either mode the same two are found
        List<PoseMode> again = finder.modes(view.worldFromCamera(modes.get(1).state().cameraFromSet()));
        assertEquals(2, again.size());
        assertEquals(modes.get(0).logWeight(), again.get(0).logWeight(), 1e-4);
    }

    @Test
    void referencesInSpaceAreNeverSeenMirrored() {
        ThesisScene scene = ThesisScene.oneRaised(4);
        ReferenceView view = InitialPoseTest.view(scene, scene.detections(0.3, RandomStreams.of(15), 5, 0.01));
        only(new CameraModeFinder(view, ThesisScene.CAMERA, new RigidMarkerNoise(view, 0.3), IntrinsicsPrior.KNOWN,
                null)
                .modes(scene.worldFromCamera()));
    }
}
