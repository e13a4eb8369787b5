package org.cellgauge.internal.posterior;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.Allocated;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CameraLikelihoodTest {
    private static final PinholeCamera STRONG = PinholeCamera.of(1280, 720,
            new double[] {581, 590, 640.5, 359.5, 0.5, -0.25, 0.1, -0.02, 0.004, -0.006});
    private static final double SIGMA_PX = 0.3;

    private static List<Reference> references() {
        List<Reference> list = new ArrayList<>();
        list.add(new Reference(944, 47, RigidTransform.ofEuler(492, 380, 0, 0.1, -0.2, 1),
                new Placement(5, 2, 8, 0.01)));
        list.add(new Reference(911, 60, RigidTransform.ofEuler(492, 0, 0, 0, 0, 0), new Placement(1, 4, 20, 0)));
        list.add(new Reference(22, 47, RigidTransform.ofEuler(0, -36, 165, 0, 0, 0), new Placement(3, 4, 5, 0.02)));
        return list;
    }

    private static ReferenceView view(PinholeCamera camera) {
        ThesisScene scene = ThesisScene.oneRaised(4).camera(camera);
        return ReferenceView.of(references(), scene.detections(0.3, RandomStreams.of(1), 5, 0.01));
    }

    private static CameraState state(ReferenceView view, PinholeCamera camera) {
        return CameraState.of(view.cameraFromSet(ThesisScene.WORLD_FROM_CAMERA), camera);
    }

    private static double[] project(RigidTransform worldFromCamera, double[] worldPoint, PinholeCamera camera) {
        double[] c = worldFromCamera.inverse().apply(worldPoint);
        return camera.project(c[0], c[1], c[2]);
    }

    private static double[] corner(RigidTransform worldFromMarker, double size, int k) {
        double[] local = MarkerGeometry.cornersMm(size);
        return worldFromMarker.apply(local[3 * k], local[3 * k + 1], local[3 * k + 2]);
    }

    /**
     * Log density of N(0, J S J^T + sigma² I) of all residuals, covariances taken at one pose, residuals at
     * another.
     */
    private static double normal(ReferenceView view, RigidTransform frozen, RigidTransform at, PinholeCamera camera) {
        double sum = 0;
        for (int m = 0; m < view.size(); m++) {
            Reference reference = view.references().get(m);
            SimpleMatrix j = new SimpleMatrix(8, 6);
            double[] variances = new double[6];
            SimpleMatrix residual = new SimpleMatrix(8, 1);
            for (int k = 0; k < 4; k++) {
                double[] uv = project(at, corner(reference.worldFromMarker(), reference.sizeMm(), k), camera);
                residual.set(2 * k, uv[0] - view.observedPx()[8 * m + 2 * k]);
                residual.set(2 * k + 1, uv[1] - view.observedPx()[8 * m + 2 * k + 1]);
                for (int c = 0; c < 6; c++) {
                    double h = c < 3 ? 0.1 : 1e-3;
                    variances[c] = Math.pow(c < 3 ? reference.placement().stdMm(c) : reference.placement().stdRad(), 2);
                    double[][] ends = new double[2][];
                    for (int s = 0; s < 2; s++) {
                        double d = s == 0 ? h : -h;
                        double[] t = reference.worldFromMarker().translationMm();
                        double[] w = new double[3];
                        if (c < 3) {
                            t[c] += d;
                        } else {
                            w[c - 3] = d;
                        }
                        RigidTransform turned = RigidTransform.ofRotationVector(w, t)
                                .compose(RigidTransform.of(reference.worldFromMarker().rotation(), new double[3]));
                        ends[s] = project(frozen, corner(turned, reference.sizeMm(), k), camera);
                    }
                    j.set(2 * k, c, (ends[0][0] - ends[1][0]) / (2 * h));
                    j.set(2 * k + 1, c, (ends[0][1] - ends[1][1]) / (2 * h));
                }
            }
            SimpleMatrix covariance = j.mult(SimpleMatrix.diag(variances)).mult(j.transpose())
                    .plus(SimpleMatrix.identity(8).scale(SIGMA_PX * SIGMA_PX));
            sum -= 0.5 * residual.transpose().mult(covariance.invert()).mult(residual).get(0);
            sum -= 0.5 * Math.log(covariance.determinant());
        }
        return sum;
    }

    private static PinholeCamera camera(String lens) {
        switch (lens) {
            case "pinhole":
                return ThesisScene.CAMERA;
            case "skewed":
                return PinholeCamera.of(1280, 720, new double[] {581, 590, 640.5, 359.5, 9, 0, 0, 0, 0, 0});
            case "distorted":
                return STRONG;
            default:
                return PinholeCamera.of(KannalaBrandtLens.MODEL, 1280, 720,
                        new double[] {581, 590, 640.5, 359.5, 0.5, 0.03, -0.01, 0.002, 0});
        }
    }

    private static RigidMarkerLikelihood rigid(ReferenceView view, CameraState frozen) {
        double[] whitening = new double[64 * view.size()];
        assertTrue(ReprojectionFit.whitening(new RigidMarkerNoise(view, SIGMA_PX), frozen, view.blocks(), whitening));
        return new RigidMarkerLikelihood(view, whitening);
    }

    @ParameterizedTest
    @ValueSource(strings = {"pinhole", "skewed", "distorted", "fisheye"})
    void rigidMarkerIsTheNormalDensityOfTheResiduals(String lens) {
        PinholeCamera camera = camera(lens);
        ReferenceView view = view(camera);
        CameraState frozen = state(view, camera);
        RigidMarkerLikelihood likelihood = rigid(view, frozen);
        RandomGenerator random = RandomStreams.of(2);
        for (int i = 0; i < 20; i++) {
            double[] step = new double[6];
            for (int k = 0; k < 6; k++) {
                step[k] = (k < 3 ? 10 : 0.01) * random.nextGaussian();
            }
            CameraState state = new CameraState();
            state.setMoved(frozen, step, 0);
            double expected = normal(view, ThesisScene.WORLD_FROM_CAMERA, view.worldFromCamera(state.cameraFromSet()),
                    camera);
            assertEquals(expected, likelihood.at(state), 1e-5 * Math.abs(expected));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 1})
    void cornerCubeIsTheFormulaOfTheNotes(double kappa) {
        for (PinholeCamera camera : new PinholeCamera[] {ThesisScene.CAMERA, STRONG}) {
            ReferenceView view = view(camera);
            RandomGenerator random = RandomStreams.of(3);
            for (int i = 0; i < 10; i++) {
                double[] step = new double[6];
                for (int k = 0; k < 6; k++) {
                    step[k] = (k < 3 ? 10 : 0.01) * random.nextGaussian();
                }
                CameraState state = new CameraState();
                state.setMoved(state(view, camera), step, 0);
                RigidTransform pose = view.worldFromCamera(state.cameraFromSet());
                // log L = - sum [ du² / (2 su²) + log su + the same in v ], su the farthest of eight box vertices
                double expected = 0;
                for (int m = 0; m < view.size(); m++) {
                    Reference r = view.references().get(m);
                    for (int k = 0; k < 4; k++) {
                        double[] x = corner(r.worldFromMarker(), r.sizeMm(), k);
                        double[] uv = project(pose, x, camera);
                        double[] sigma = new double[2];
                        for (double sx : new double[] {-kappa, kappa}) {
                            for (double sy : new double[] {-kappa, kappa}) {
                                for (double sz : new double[] {-kappa, kappa}) {
                                    double[] vertex = project(pose, new double[] {x[0] + sx * r.placement().stdMm(0),
                                        x[1] + sy * r.placement().stdMm(1), x[2] + sz * r.placement().stdMm(2)},
                                        camera);
                                    sigma[0] = Math.max(sigma[0], Math.abs(vertex[0] - uv[0]));
                                    sigma[1] = Math.max(sigma[1], Math.abs(vertex[1] - uv[1]));
                                }
                            }
                        }
                        for (int c = 0; c < 2; c++) {
                            double d = view.observedPx()[8 * m + 2 * k + c] - uv[c];
                            expected -= d * d / (2 * sigma[c] * sigma[c]) + Math.log(sigma[c]);
                        }
                    }
                }
                assertEquals(expected, new CornerCubeLikelihood(view, kappa).at(state), 1e-9 * Math.abs(expected));
            }
        }
    }

    @Test
    void posesThatShowNoImageAreImpossible() {
        for (PinholeCamera camera : new PinholeCamera[] {ThesisScene.CAMERA, STRONG}) {
            ReferenceView view = view(camera);
            for (CameraLikelihood likelihood : List.of(rigid(view, state(view, camera)),
                    new CornerCubeLikelihood(view, 1))) {
                CameraState behind = state(view, camera);
                behind.offset[2] = -500;
                assertEquals(Double.NEGATIVE_INFINITY, likelihood.at(behind), 0);
                CameraState half = state(view, camera);
                half.offset[2] = 50;
                assertEquals(Double.NEGATIVE_INFINITY, likelihood.at(half), 0);
                for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
                    for (int i = 0; i < 3; i++) {
                        CameraState state = state(view, camera);
                        state.offset[i] = bad;
                        if (bad != bad || i < 2) {
                            assertEquals(Double.NEGATIVE_INFINITY, likelihood.at(state), 0);
                        }
                    }
                    CameraState state = state(view, camera);
                    state.intrinsics[PinholeCamera.FX] = bad;
                    assertEquals(Double.NEGATIVE_INFINITY, likelihood.at(state), 0);
                }
                assertTrue(Double.isFinite(likelihood.at(state(view, camera))));
            }
        }
    }

    @Test
    void placementStatedAsExactLeavesCornerCubeWithoutADeviation() {
        List<Reference> exact = List.of(new Reference(944, 47, RigidTransform.IDENTITY, new Placement(0, 0, 0, 0.1)));
        ReferenceView view = ReferenceView.of(exact, ThesisScene.oneRaised(4).exactDetections());
        assertThrows(IllegalArgumentException.class, () -> new CornerCubeLikelihood(view, 1));
        assertThrows(IllegalArgumentException.class, () -> new CornerCubeLikelihood(view(STRONG), 0));
        assertThrows(IllegalArgumentException.class, () -> new RigidMarkerLikelihood(view(STRONG), new double[64]));
    }

    @Test
    void evaluatingADensityAllocatesNothing() {
        ReferenceView view = view(STRONG);
        CameraState base = state(view, STRONG);
        IntrinsicsPrior prior = IntrinsicsPrior.focal(STRONG, 200);
        CameraChart centred = new CentredChart(base, prior);
        CameraChart euler = new EulerChart(view.centroidMm(), base, prior);
        PosePrior pose = new PosePrior(base, 1000, 0.7);
        List<Supplier<LogDensity>> densities = List.of(
                () -> new CameraPosterior(centred, rigid(view, base), RotationPrior.UNIFORM, prior, pose),
                () -> new CameraPosterior(euler, new CornerCubeLikelihood(view, 1), RotationPrior.FLAT_IN_EULER_ANGLES,
                        prior, null),
                () -> new ObjectPosterior(new double[] {600, 300, 630, 300, 630, 330, 600, 330}, 47, 0.3,
                        CameraState.of(RigidTransform.ofEuler(0, 0, 1000, Math.PI, 0, 0), STRONG)));
        for (Supplier<LogDensity> supplier : densities) {
            LogDensity density = supplier.get();
            double[] x = density.dimension() == 6 ? new double[6]
                    : density.at(centred.encode(base)) > -1e4 ? centred.encode(base) : euler.encode(base);
            double[] sum = new double[1];
            for (int i = 0; i < 2000; i++) {
                sum[0] += density.at(x);
            }
            long bytes = Allocated.bytes(() -> {
                for (int i = 0; i < 100_000; i++) {
                    x[0] += 1e-9;
                    sum[0] += density.at(x);
                }
            });
            assertTrue(Double.isFinite(sum[0]));
            // one object of a single field a call would be 16 bytes
            assertTrue(bytes < 100_000, bytes + " bytes in 100 000 calls");
        }
    }
}
