package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.SamplerKind;
import org.cellgauge.vision.Detections;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A quick look from the mode of an earlier photo is that from the initial estimate. */
class QuickLookTest {
    private static final CheckSettings SETTINGS = CheckSettings.builder().threads(1).build();

    private static QuickLook look(Cell cell, Detections detections, RigidTransform start) {
        return CellCheck.quickLook(cell, detections, SETTINGS, start);
    }

    private static void assertSame(QuickLook expected, QuickLook actual, double stds) {
        CellEstimate a = expected.update().estimate();
        CellEstimate b = actual.update().estimate();
        assertPose(a.camera(), b.camera(), stds);
        assertEquals(a.objects().size(), b.objects().size());
        for (int o = 0; o < a.objects().size(); o++) {
            assertPose(a.objects().get(o).pose(), b.objects().get(o).pose(), stds);
        }
    }

    private static void assertPose(PoseEstimate a, PoseEstimate b, double stds) {
        for (int i = 0; i < 6; i++) {
            assertEquals(0, (a.mean()[i] - b.mean()[i]) / a.std()[i], stds);
            assertEquals(1, b.std()[i] / a.std()[i], stds);
        }
    }

    @Test
    void fromTheModeOfAnEarlierPhotoItIsTheSame() {
        for (int seed = 1; seed <= 40; seed++) {
            ThesisScene scene = seed % 2 == 0 ? ThesisScene.inPlane(3) : ThesisScene.oneRaised(4);
            Cell cell = scene.cell();
            Detections photo = scene.detections(0.3, RandomStreams.of(seed), 5, 0.01);
            var random = RandomStreams.of(seed, 7);
            // the camera was elsewhere: some 50 mm and 3 degrees off
            double[] turn = {0.05 * random.nextGaussian(), 0.05 * random.nextGaussian(), 0.05 * random.nextGaussian()};
            double[] move = {50 * random.nextGaussian(), 50 * random.nextGaussian(), 50 * random.nextGaussian()};
            RigidTransform before = ThesisScene.WORLD_FROM_CAMERA.compose(RigidTransform.ofRotationVector(turn, move));
            assertSame(look(cell, photo, null), look(cell, photo, before), 1e-6);
        }
    }

    @Test
    void aStartThatLeadsNowhereIsNotUsed() {
        ThesisScene scene = ThesisScene.oneRaised(4);
        Cell cell = scene.cell();
        Detections photo = scene.detections(0.3, RandomStreams.of(1), 5, 0.01);
        QuickLook cold = look(cell, photo, null);
        RigidTransform[] wrong = {RigidTransform.ofEuler(0, 0, -1000, 0, 0, 0),
            RigidTransform.ofEuler(418, 106, 1070, 0, 0, 0), RigidTransform.ofEuler(418, 106, 1070, 3.08, 0.10, 3.1),
            RigidTransform.ofEuler(-900, 2000, 300, 2.1, 0.8, -1)};
        for (RigidTransform start : wrong) {
            assertSame(cold, look(cell, photo, start), 1e-6);
        }
    }

    @Test
    void cornersThatNoPoseExplainsWellAreLookedAtFromTheInitialEstimate() {
        // a reference far off its place: chi-square is beyond what noise allows wherever the search starts
        ThesisScene scene = ThesisScene.inPlane(4).placement(1, 0.003).shifted(944, 0, 30);
        Cell cell = scene.cell();
        Detections photo = scene.detections(0.05, RandomStreams.of(1), 1, 0.003);
        QuickLook cold = look(cell, photo, null);
        QuickLook warm = look(cell, photo, RigidTransform.ofEuler(430, 100, 1060, 3.1, 0.1, 0));
        assertArrayEquals(cold.update().estimate().camera().mean(), warm.update().estimate().camera().mean());
    }

    @Test
    void wherePriorIsAboutTheInitialEstimateItStaysThere() {
        for (int references = 1; references <= 2; references++) {
            ThesisScene scene = ThesisScene.inPlane(references);
            Cell cell = scene.cell();
            Detections photo = scene.detections(0.3, RandomStreams.of(4), 5, 0.01);
            CellEstimate cold = look(cell, photo, null).update().estimate();
            RigidTransform near = RigidTransform.ofEuler(450, 90, 1040, 3.1, 0.1, 0);
            CellEstimate warm = look(cell, photo, near).update().estimate();
            assertArrayEquals(cold.camera().mean(), warm.camera().mean());
            assertArrayEquals(cold.camera().std(), warm.camera().std());
        }
    }

    @ParameterizedTest
    @EnumSource(SamplerKind.class)
    void chainsCanBeRunAgainAndAreThoseOfTheWholeCheck(SamplerKind sampler) {
        ThesisScene scene = ThesisScene.inPlane(3);
        Detections photo = scene.detections(0.3, RandomStreams.of(3), 5, 0.01);
        CheckSettings settings = CheckSettings.builder().sampler(sampler).iterations(1200).warmup(300).build();
        CheckResult whole = CellCheck.run(scene.cell(), photo, settings);
        QuickLook look = CellCheck.quickLook(scene.cell(), photo, settings, null);
        for (int i = 0; i < 2; i++) {
            List<CheckUpdate> updates = look.chains(() -> 2).toList().blockingGet();
            CheckResult result = updates.get(updates.size() - 1).result();
            assertArrayEquals(whole.draws().get(1).series(2), result.draws().get(1).series(2));
            assertEquals(whole.reason(), result.reason());
            assertEquals(whole.warnings(), result.warnings());
            assertTrue(updates.stream().noneMatch(u -> u.phase() == CheckUpdate.Phase.QUICK_LOOK));
        }
        assertEquals(whole.pixelStdPx(), look.pixelStdPx());
    }
}
