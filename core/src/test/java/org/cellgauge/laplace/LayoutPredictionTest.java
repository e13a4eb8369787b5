package org.cellgauge.laplace;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.settings.ObjectNoise;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A prediction from poses alone is what a check finds on the exact corners of that layout, by search. */
class LayoutPredictionTest {
    private static final PinholeCamera DISTORTED = PinholeCamera.of(1280, 720,
            new double[] {581, 590, 640, 360, 0, -0.2, 0.05, 0, 0.001, -0.001});

    private static final PinholeCamera FISHEYE = PinholeCamera.of(KannalaBrandtLens.MODEL, 1280, 720,
            new double[] {560, 565, 640, 360, 0, 0.02, -0.01, 0.003, -0.001});

    private enum Layout {
        FOUR, FOUR_BY_FISHEYE, RAISED_FOCAL, TWO_ON_A_WEAK_PRIOR, BENT_PRINTS_OF_UNSURE_SIZE,
        CORNER_CUBE_WITHOUT_OBJECT_NOISE;

        ThesisScene scene() {
            ThesisScene scene = this == TWO_ON_A_WEAK_PRIOR ? ThesisScene.inPlane(2)
                    : this == RAISED_FOCAL ? ThesisScene.oneRaised(4) : ThesisScene.inPlane(4);
            return scene.camera(this == FOUR_BY_FISHEYE ? FISHEYE : DISTORTED).placement(5, 0.01).pixelStd(0.3)
                    .planeObjects().grip(20, 10, -20, 100);
        }

        Cell cell() {
            Cell cell = scene().cell();
            return this != BENT_PRINTS_OF_UNSURE_SIZE ? cell : new Cell(cell.camera(), cell.family(),
                    cell.references(), cell.objects(), cell.pixelStdPx(), cell.targetStdMm(),
                    new PrintPrecision(0.1, 0.2, 0));
        }

        /** A check knows what bent paper does to corners by the heavier of both poses of each marker alone. */
        double tolerance() {
            return this == BENT_PRINTS_OF_UNSURE_SIZE ? 1e-3 : 1e-5;
        }

        CheckSettings settings() {
            CheckSettings.Builder settings = CheckSettings.builder();
            if (this == RAISED_FOCAL) {
                settings.estimate(Estimate.FOCAL).focalPriorStdPx(50);
            }
            if (this == CORNER_CUBE_WITHOUT_OBJECT_NOISE) {
                settings.likelihood(LikelihoodModel.CORNER_CUBE).objectNoise(ObjectNoise.NONE);
            }
            return settings.build();
        }
    }

    private static void assertSame(double[][] expected, double[][] actual, double tolerance) {
        assertEquals(expected.length, actual.length);
        for (int i = 0; i < expected.length; i++) {
            for (int j = 0; j < expected.length; j++) {
                assertEquals(expected[i][j], actual[i][j], tolerance * Math.sqrt(expected[i][i] * expected[j][j]));
            }
        }
    }

    private static void assertSame(PoseEstimate expected, PoseEstimate actual, double tolerance) {
        for (int i = 0; i < 6; i++) {
            assertEquals(expected.mean()[i], actual.mean()[i], 1e-5 * expected.std()[i]);
        }
        assertSame(expected.covariance(), actual.covariance(), tolerance);
        assertSame(expected.tangentCovariance(), actual.tangentCovariance(), tolerance);
    }

    @ParameterizedTest
    @EnumSource
    void predictionIsWhatACheckOfExactCornersFinds(Layout layout) {
        ThesisScene scene = layout.scene();
        Cell cell = layout.cell();
        LayoutPrediction prediction = LayoutPrediction.of(cell, scene.worldFromCamera(), scene.objects(),
                layout.settings());
        CellEstimate check = CellCheck.quickLook(cell, scene.exactDetections(), layout.settings(), null).update()
                .estimate();
        assertSame(check.camera(), prediction.camera(), layout.tolerance());
        if (check.intrinsics() == null) {
            assertEquals(0, prediction.intrinsicsCovariance().length);
        } else {
            assertSame(check.intrinsics().covariance(), prediction.intrinsicsCovariance(),
                    layout.tolerance());
        }
        assertEquals(Set.of(5, 20, 30), prediction.objects());
        for (ObjectEstimate object : check.objects()) {
            int id = object.marker().id();
            assertSame(object.pose(), prediction.object(id), layout.tolerance());
            object.budget().shares().forEach((source, share) ->
                    assertEquals(share, prediction.budget(id).shares().get(source), layout.tolerance(),
                            source.toString()));
            if (object.grip() == null) {
                assertNull(prediction.grip(id));
                assertNull(prediction.gripBudget(id));
            } else {
                assertSame(object.grip().covarianceMm2(), prediction.grip(id).covarianceMm2(),
                        layout.tolerance());
                assertEquals(object.gripBudget().shares().size(), prediction.gripBudget(id).shares().size());
            }
        }
    }

    @Test
    void markersOutOfSightAreLeftOut() {
        ThesisScene scene = Layout.FOUR.scene();
        Map<Integer, RigidTransform> objects = scene.objects();
        RigidTransform away = RigidTransform.ofEuler(3000, 0, 0, 0, 0, 0);
        RigidTransform turnedOver = objects.get(20).compose(RigidTransform.ofEuler(0, 0, 0, Math.PI, 0, 0));
        LayoutPrediction prediction = LayoutPrediction.of(scene.cell(), scene.worldFromCamera(),
                Map.of(5, away, 20, turnedOver, 30, objects.get(30)), CheckSettings.builder().build());
        assertEquals(Set.of(30), prediction.objects());
        assertNull(prediction.object(5));
        assertThrows(IllegalArgumentException.class, () -> prediction.budget(20));
        // nothing of the cell is seen from beneath it
        assertNull(LayoutPrediction.of(scene.cell(), RigidTransform.ofEuler(418, 106, -1070, 0, 0, 0), objects,
                CheckSettings.builder().build()));
        // a camera further to the side sees fewer references
        List<Integer> ids = new ArrayList<>();
        LayoutPrediction aside = LayoutPrediction.of(scene.cell(),
                RigidTransform.ofEuler(0, -480, 0, 0, 0, 0).compose(scene.worldFromCamera()), objects,
                CheckSettings.builder().build());
        assertNotNull(aside);
        aside.references().forEach(r -> ids.add(r.id()));
        assertArrayEquals(new Object[] {911, 22}, ids.toArray());
    }

    @Test
    void anUnknownCornerNoiseIsRefused() {
        ThesisScene scene = Layout.FOUR.scene();
        Cell cell = scene.cell();
        Cell unstated = new Cell(cell.camera(), cell.family(), cell.references(), cell.objects(),
                OptionalDouble.empty(), OptionalDouble.empty());
        assertThrows(IllegalArgumentException.class, () -> LayoutPrediction.of(unstated, scene.worldFromCamera(),
                scene.objects(), CheckSettings.builder().build()));
    }
}
