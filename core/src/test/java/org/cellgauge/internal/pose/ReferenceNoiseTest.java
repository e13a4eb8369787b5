package org.cellgauge.internal.pose;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ReferenceNoiseTest {
    private static final PinholeCamera STRONG = InitialPoseTest.STRONG;

    /** Four references, one raised, each turned and each placed with its own precision. */
    static List<Reference> references() {
        List<Reference> list = new ArrayList<>();
        list.add(new Reference(944, 47, RigidTransform.ofEuler(492, 380, 0, 0.1, -0.2, 1),
                new Placement(5, 2, 8, 0.01)));
        list.add(new Reference(1234, 60, RigidTransform.ofEuler(0, 380, 0, 0, 0.3, -2), new Placement(1, 1, 1, 0.05)));
        list.add(new Reference(911, 47, RigidTransform.ofEuler(492, 0, 0, 0, 0, 0), new Placement(0, 0, 20, 0)));
        list.add(new Reference(22, 100, RigidTransform.ofEuler(0, -36, 165, 0.4, 0.1, 0.2),
                new Placement(3, 4, 5, 0.02)));
        return list;
    }

    static ReferenceView view() {
        ThesisScene scene = ThesisScene.oneRaised(4);
        return ReferenceView.of(references(), scene.exactDetections());
    }

    static double[] project(RigidTransform worldFromCamera, RigidTransform worldFromMarker, double size,
            PinholeCamera camera) {
        double[] c = MarkerGeometry.cornersMm(worldFromCamera.inverse().compose(worldFromMarker), size);
        double[] px = new double[8];
        for (int k = 0; k < 4; k++) {
            System.arraycopy(camera.project(c[3 * k], c[3 * k + 1], c[3 * k + 2]), 0, px, 2 * k, 2);
        }
        return px;
    }

    /** Derivative of the corners by the placement error, by central differences over the reference's own pose. */
    static SimpleMatrix numericJacobian(Reference reference, RigidTransform worldFromCamera, PinholeCamera camera) {
        SimpleMatrix j = new SimpleMatrix(8, 6);
        for (int c = 0; c < 6; c++) {
            double h = c < 3 ? 0.1 : 1e-3;
            double[][] px = new double[2][];
            for (int s = 0; s < 2; s++) {
                double[] t = reference.worldFromMarker().translationMm();
                double[] w = new double[3];
                if (c < 3) {
                    t[c] += s == 0 ? h : -h;
                } else {
                    w[c - 3] = s == 0 ? h : -h;
                }
                RigidTransform turned = RigidTransform.ofRotationVector(w, new double[3])
                        .compose(RigidTransform.of(reference.worldFromMarker().rotation(), new double[3]));
                px[s] = project(worldFromCamera, RigidTransform.of(turned.rotation(), t), reference.sizeMm(), camera);
            }
            for (int r = 0; r < 8; r++) {
                j.set(r, c, (px[0][r] - px[1][r]) / (2 * h));
            }
        }
        return j;
    }

    @Test
    void derivativeByPlacementIsThatOfMovedReferences() {
        ReferenceView view = view();
        CameraState state = CameraState.of(view.cameraFromSet(ThesisScene.WORLD_FROM_CAMERA), STRONG);
        double[] out = new double[48];
        for (int m = 0; m < view.size(); m++) {
            SimpleMatrix numeric = numericJacobian(view.references().get(m), ThesisScene.WORLD_FROM_CAMERA, STRONG);
            assertTrue(new RigidMarkerNoise(view, 0.3).jacobian(state, m, out));
            for (int c = 0; c < 6; c++) {
                double largest = numeric.extractVector(false, c).elementMaxAbs();
                for (int r = 0; r < 8; r++) {
                    assertEquals(numeric.get(r, c), out[6 * r + c], 1e-6 * largest, "marker " + m + " column " + c);
                }
            }
        }
    }

    @Test
    void rigidCovarianceIsThePlacementCarriedIntoTheImage() {
        ReferenceView view = view();
        CameraState state = CameraState.of(view.cameraFromSet(ThesisScene.WORLD_FROM_CAMERA), STRONG);
        double[] placement = new double[64];
        double[] pixel = new double[64];
        for (int m = 0; m < view.size(); m++) {
            Placement p = view.references().get(m).placement();
            double[] squares = new double[6];
            for (int i = 0; i < 6; i++) {
                squares[i] = i < 3 ? p.stdMm(i) * p.stdMm(i) : p.stdRad() * p.stdRad();
            }
            SimpleMatrix j = numericJacobian(view.references().get(m), ThesisScene.WORLD_FROM_CAMERA, STRONG);
            SimpleMatrix expected = j.mult(SimpleMatrix.diag(squares)).mult(j.transpose());
            assertTrue(new RigidMarkerNoise(view, 0.3).covariance(state, m, placement, pixel));
            assertArrayEquals(expected.getDDRM().data, placement, 1e-5 * expected.elementMaxAbs());
            assertArrayEquals(SimpleMatrix.identity(8).scale(0.09).getDDRM().data, pixel, 1e-15);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 1})
    void cornerCubeTakesTheFarthestVertexOfTheBoxInEachDirection(double kappa) {
        ReferenceView view = view();
        CameraState state = CameraState.of(view.cameraFromSet(ThesisScene.WORLD_FROM_CAMERA), STRONG);
        RigidTransform cameraFromWorld = ThesisScene.WORLD_FROM_CAMERA.inverse();
        double[] placement = new double[64];
        double[] pixel = new double[64];
        for (int m = 0; m < view.size(); m++) {
            Reference reference = view.references().get(m);
            double[] corners = MarkerGeometry.cornersMm(reference.worldFromMarker(), reference.sizeMm());
            SimpleMatrix expected = new SimpleMatrix(8, 8);
            for (int k = 0; k < 4; k++) {
                double[] c = cameraFromWorld.apply(corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]);
                double[] centre = STRONG.project(c[0], c[1], c[2]);
                double[] largest = new double[2];
                for (int bits = 0; bits < 8; bits++) {
                    double[] v = new double[3];
                    for (int i = 0; i < 3; i++) {
                        v[i] = corners[3 * k + i]
                                + ((bits >> i & 1) == 0 ? -kappa : kappa) * reference.placement().stdMm(i);
                    }
                    double[] x = cameraFromWorld.apply(v);
                    double[] uv = STRONG.project(x[0], x[1], x[2]);
                    largest[0] = Math.max(largest[0], Math.abs(uv[0] - centre[0]));
                    largest[1] = Math.max(largest[1], Math.abs(uv[1] - centre[1]));
                }
                expected.set(2 * k, 2 * k, largest[0] * largest[0]);
                expected.set(2 * k + 1, 2 * k + 1, largest[1] * largest[1]);
            }
            assertTrue(new CornerCubeNoise(view, kappa).covariance(state, m, placement, pixel));
            assertArrayEquals(expected.getDDRM().data, placement, 1e-9);
            assertArrayEquals(new double[64], pixel, 0);
        }
    }

    @Test
    void posesWithACornerBehindTheCameraHaveNoCovariance() {
        ReferenceView view = view();
        // camera in the plane of the references, looking along it: some are behind
        CameraState state = CameraState.of(view.cameraFromSet(RigidTransform.ofEuler(246, 190, 0, Math.PI / 2, 0, 0)),
                STRONG);
        boolean rigid = true;
        boolean cube = true;
        for (int m = 0; m < view.size(); m++) {
            rigid &= new RigidMarkerNoise(view, 0.3).covariance(state, m, new double[64], new double[64]);
            cube &= new CornerCubeNoise(view, 1).covariance(state, m, new double[64], new double[64]);
        }
        assertFalse(rigid);
        assertFalse(cube);
        assertFalse(ReprojectionFit.whitening(new RigidMarkerNoise(view, 0.3), state, view.blocks(), new double[256]));
    }

    @Test
    void deviationsThatAreNoDeviationsAreRefused() {
        for (double bad : new double[] {0, -1, Double.NaN}) {
            assertThrows(IllegalArgumentException.class, () -> new RigidMarkerNoise(view(), bad));
            assertThrows(IllegalArgumentException.class, () -> new CornerCubeNoise(view(), bad));
            assertThrows(IllegalArgumentException.class, () -> IntrinsicsPrior.focal(STRONG, bad));
            assertThrows(IllegalArgumentException.class, () -> new PosePrior(new CameraState(), bad, 1));
            assertThrows(IllegalArgumentException.class, () -> new PosePrior(new CameraState(), 1, bad));
        }
    }

    @Test
    void viewHoldsWhatWasSeenAboutTheCentroidOfThat() {
        List<Reference> references = references();
        references.add(new Reference(5000, 47, RigidTransform.IDENTITY, new Placement(1, 1, 1, 1)));
        ReferenceView view = ReferenceView.of(references, ThesisScene.oneRaised(4).exactDetections());
        assertEquals(4, view.size());
        assertArrayEquals(new double[] {246, 181, 41.25}, view.centroidMm(), 1e-12);
        RigidTransform set = view.cameraFromSet(ThesisScene.WORLD_FROM_CAMERA);
        assertArrayEquals(ThesisScene.WORLD_FROM_CAMERA.inverse().apply(246, 181, 41.25), set.translationMm(), 1e-10);
        assertArrayEquals(ThesisScene.WORLD_FROM_CAMERA.translationMm(), view.worldFromCamera(set).translationMm(),
                1e-9);
        double[] corners = MarkerGeometry.cornersMm(references.get(1).worldFromMarker(), 60);
        assertEquals(corners[4] - 181, view.pointsMm()[16], 1e-12);

        ReferenceView two = view.only(List.of(1, 3));
        assertArrayEquals(new double[] {0, 172, 82.5}, two.centroidMm(), 1e-12);
        assertEquals(view.observedPx()[24], two.observedPx()[8], 0);
        double[] other = new double[32];
        assertArrayEquals(other, view.withObservations(other).observedPx(), 0);
        assertThrows(IllegalArgumentException.class, () -> view.withObservations(new double[31]));
        assertThrows(IllegalArgumentException.class,
                () -> ReferenceView.of(references.subList(4, 5), ThesisScene.oneRaised(4).exactDetections()));
    }
}
