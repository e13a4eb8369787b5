package org.cellgauge.internal.validation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.statistics.RunningMoments;
import org.cellgauge.vision.Detections;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TruthPriorTest {
    private static final ThesisScene SCENE = ThesisScene.inPlane(4);
    private static final PinholeCamera LENS = SCENE.cell().camera();
    private static final double[] CENTROID = {246, 190, 0};

    private static CellTruth nominal() {
        return new CellTruth(SCENE.worldFromCamera(), SCENE.objects());
    }

    private static TruthPrior prior(double mm, double rad) {
        return new TruthPrior(SCENE.cell(), nominal(), mm, rad);
    }

    /** 4000 draws: deviations good to 1.1 %, bounds four times that. */
    @Test
    void posesSpreadAsStated() {
        TruthPrior prior = prior(20, 0.05);
        RunningMoments camera = new RunningMoments(6);
        RunningMoments object = new RunningMoments(6);
        RigidTransform nominalCamera = SCENE.worldFromCamera().inverse();
        RigidTransform nominalObject = nominalCamera.compose(SCENE.objects().get(5));
        for (int i = 0; i < 4000; i++) {
            CellTruth truth = prior.draw(RandomStreams.of(3, i));
            RigidTransform drawn = truth.worldFromCamera().inverse();
            camera.add(difference(drawn.apply(CENTROID), nominalCamera.apply(CENTROID), drawn, nominalCamera));
            RigidTransform seen = drawn.compose(truth.worldFromObjects().get(5));
            object.add(difference(seen.translationMm(), nominalObject.translationMm(), seen, nominalObject));
        }
        for (int i = 0; i < 6; i++) {
            double std = i < 3 ? 20 : 0.05;
            assertEquals(1, camera.std(i) / std, 0.045, "camera " + i);
            assertEquals(1, object.std(i) / std, 0.045, "object " + i);
            assertEquals(0, camera.mean(i) / std, 4 / Math.sqrt(4000), "camera " + i);
        }
    }

    private static double[] difference(double[] place, double[] nominalPlace, RigidTransform pose,
            RigidTransform nominal) {
        double[] w = RigidTransform.of(pose.rotation(), new double[3])
                .compose(RigidTransform.of(nominal.rotation(), new double[3]).inverse()).rotationVectorRad();
        return new double[] {place[0] - nominalPlace[0], place[1] - nominalPlace[1], place[2] - nominalPlace[2], w[0],
            w[1], w[2]};
    }

    /** By the invariant measure the density of exp(w) is normal over 2 (1 - cos a) / a^2, a = |w|. */
    @Test
    void densityIsByTheMeasureOfAFlatPrior() {
        TruthPrior prior = prior(30, 0.2);
        RigidTransform nominal = SCENE.worldFromCamera().inverse();
        double angle = 0.3;
        RigidTransform about = RigidTransform.ofRotationVector(new double[] {0, 0, angle}, new double[3]);
        double[] g = nominal.apply(CENTROID);
        RigidTransform turned = about.compose(RigidTransform.of(nominal.rotation(), new double[3]));
        double[] h = turned.apply(CENTROID);
        RigidTransform moved = RigidTransform.of(turned.rotation(),
                new double[] {g[0] + 15 - h[0], g[1] - h[1], g[2] - h[2]});
        double expected = -0.5 * (0.25 + angle * angle / 0.04)
                - Math.log(2 * (1 - Math.cos(angle)) / (angle * angle));
        assertEquals(expected,
                prior.logCamera(LENS, moved.inverse()) - prior.logCamera(LENS, SCENE.worldFromCamera()), 1e-9);
    }

    /** 2000 draws: deviations good to 1.6 %, means to 2.2 % of one; bounds four times that. */
    @Test
    void unknownFocalLengthsAreDrawnFromWhatIsKnownOfThem() {
        double focalStdPx = 30;
        double aspectStd = 0.004;
        TruthPrior prior = new TruthPrior(SCENE.cell(), nominal(), 0, 0,
                IntrinsicsPrior.focalAndAspect(LENS, focalStdPx, aspectStd));
        RunningMoments moments = new RunningMoments(2);
        for (int i = 0; i < 2000; i++) {
            PinholeCamera lens = prior.draw(RandomStreams.of(8, i)).camera(SCENE.cell());
            double fx = lens.get(PinholeCamera.FX);
            // for square pixels fy = fx + fy0 t
            moments.add(new double[] {fx, (lens.get(PinholeCamera.FY) - fx) / LENS.get(PinholeCamera.FY)});
            assertEquals(LENS.get(PinholeCamera.CX), lens.get(PinholeCamera.CX), 0);
        }
        assertEquals(LENS.get(PinholeCamera.FX), moments.mean(0), 0.09 * focalStdPx);
        assertEquals(1, moments.std(0) / focalStdPx, 0.065);
        assertEquals(0, moments.mean(1), 0.09 * aspectStd);
        assertEquals(1, moments.std(1) / aspectStd, 0.065);
        assertEquals(LENS, prior(0, 0).draw(RandomStreams.of(8)).camera(SCENE.cell()));
    }

    @Test
    void noPoseOutOfSightHasDensity() {
        RigidTransform away = RigidTransform.ofEuler(418, 106, 1070, 0, 0, 0);
        assertEquals(Double.NEGATIVE_INFINITY, prior(30, 0.2).logCamera(LENS, away));
    }

    @Test
    void withoutSpreadEveryTruthIsTheNominalOne() {
        CellTruth truth = prior(0, 0).draw(RandomStreams.of(1));
        assertEquals(0, truth.worldFromCamera().angleRadTo(SCENE.worldFromCamera()), 1e-7);
        assertEquals(240, truth.worldFromObjects().get(20).translationMm()[0], 1e-9);
    }

    @Test
    void markerOutOfSightIsRefusedByName() {
        CellTruth behind = new CellTruth(SCENE.worldFromCamera(), CellTruth.objectPoses(SCENE.cell(),
                Map.of(20, RigidTransform.ofEuler(240, 4000, 0, 0, 0, 0))));
        InputRefusedException e = assertThrows(InputRefusedException.class,
                () -> new TruthPrior(SCENE.cell(), behind, 0, 0));
        assertTrue(e.getMessage().startsWith("object 20 "), e.getMessage());
    }

    @ParameterizedTest
    @CsvSource({"-1, 0.1", "5, 0", "0, 0.1", "5, 2", "NaN, 0.1", "Infinity, 0.1", "5, NaN", "5, Infinity", "5, -0.1",
        "1e308, 0.1"})
    void spreadOutOfRangeIsAnError(double mm, double rad) {
        assertThrows(IllegalArgumentException.class, () -> prior(mm, rad));
    }

    /** The camera at (418, 106, 1070) is 1087.0 mm from the centroid. */
    @Test
    void camerasAreNotSpreadFartherThanTheyAreFromTheReferences() {
        assertEquals(1086, prior(1086, 0.1).stdMm());
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class, () -> prior(1088, 0.1));
        assertTrue(e.getMessage().contains("1087 mm here, not 1088.0 mm"), e.getMessage());
    }

    @ParameterizedTest
    @CsvSource({"1", "2", "3", "6"})
    void objectsWithoutAPoseStandBetweenTheReferences(int references) {
        Cell cell = ThesisScene.inPlane(references).cell();
        Map<Integer, RigidTransform> poses = CellTruth.objectPoses(cell, Map.of());
        assertEquals(3, poses.size());
        if (references > 1) {
            for (int axis = 0; axis < 2; axis++) {
                double low = Double.POSITIVE_INFINITY;
                double high = Double.NEGATIVE_INFINITY;
                for (Reference r : cell.references()) {
                    low = Math.min(low, r.worldFromMarker().translationMm()[axis]);
                    high = Math.max(high, r.worldFromMarker().translationMm()[axis]);
                }
                for (RigidTransform pose : poses.values()) {
                    assertTrue(pose.translationMm()[axis] > low && pose.translationMm()[axis] < high, pose.toString());
                }
            }
        }
        double[] first = poses.get(5).translationMm();
        double[] second = poses.get(20).translationMm();
        assertTrue(Math.hypot(first[0] - second[0], first[1] - second[1]) > ThesisScene.SIZE_MM);
    }

    @Test
    void givenPosesAreKeptAndForeignOnesRefused() {
        RigidTransform given = RigidTransform.ofEuler(1, 2, 3, 0, 0, 0);
        assertEquals(given, CellTruth.objectPoses(SCENE.cell(), Map.of(20, given)).get(20));
        assertThrows(IllegalArgumentException.class, () -> CellTruth.objectPoses(SCENE.cell(), Map.of(944, given)));
    }

    /** A marker seen head on moves by f / z px per mm; 3000 draws: deviations good to 1.3 %. */
    @Test
    void referencesAreMisplacedAsStated() {
        ThesisScene scene = ThesisScene.inPlane(1).noObjects().placement(5, 0)
                .cameraAt(RigidTransform.ofEuler(0, 380, 1000, Math.PI, 0, 0));
        CellTruth truth = new CellTruth(scene.worldFromCamera(), Map.of());
        RunningMoments centre = new RunningMoments(2);
        for (int i = 0; i < 3000; i++) {
            Detections detections = SimulatedPhoto.of(scene.cell(), truth, 1e-9, RandomStreams.of(2, 1, i),
                    RandomStreams.of(2, 2, i));
            double[] px = detections.find(1234).cornersPx();
            centre.add(new double[] {(px[0] + px[2] + px[4] + px[6]) / 4, (px[1] + px[3] + px[5] + px[7]) / 4});
        }
        assertEquals(5 * 0.581, centre.std(0), 0.05 * 5 * 0.581);
        assertEquals(5 * 0.581, centre.std(1), 0.05 * 5 * 0.581);
        assertEquals(640, centre.mean(0), 4 * 5 * 0.581 / Math.sqrt(3000));
    }

    @Test
    void cornersAreAsNoisyAsStated() {
        ThesisScene scene = ThesisScene.inPlane(1).noObjects();
        CellTruth truth = new CellTruth(scene.worldFromCamera(), Map.of());
        double[] exact = scene.exactDetections().find(1234).cornersPx();
        RunningMoments noise = new RunningMoments(1);
        for (int i = 0; i < 500; i++) {
            double[] px = SimulatedPhoto.of(scene.cell(), truth, 0.3, null, RandomStreams.of(2, 2, i)).find(1234)
                    .cornersPx();
            for (int k = 0; k < 8; k++) {
                noise.add(new double[] {px[k] - exact[k]});
            }
        }
        // 4000 values: the deviation is good to 1.1 %
        assertEquals(0.3, noise.std(0), 0.045 * 0.3);
    }
}
