package org.cellgauge.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.cellgauge.cell.Area;
import org.cellgauge.cell.CameraCalibration;
import org.cellgauge.cell.CameraRange;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ChangeKind;
import org.cellgauge.cell.Reference;
import org.cellgauge.cell.Wall;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.RigidTransform;
import org.junit.jupiter.api.Test;

/** What a plan reckons with. */
class CellPlannerTest {
    /** Where deviations come from the calibration, a camera of more pixels that is known as well is no better. */
    @Test
    void anotherCameraIsNoBetterKnown() {
        ThesisScene scene = ThesisScene.inPlane(4).placement(0.01, 1e-4).pixelStd(0.005).planeObjects();
        Cell exact = scene.cell();
        Cell calibrated = exact.withCalibration(new CameraCalibration(List.of("fx", "fy"),
                new double[] {36, 35.9, 35.9, 36}, 20));
        Map<Integer, List<RigidTransform>> places = new LinkedHashMap<>();
        RigidTransform lift = RigidTransform.ofEuler(0, 0, 150, 0, 0, 0);
        scene.objects().forEach((id, pose) -> places.put(id, List.of(lift.compose(pose))));
        Layout layout = new Layout(calibrated, List.of(scene.worldFromCamera()), places);
        Plan plan = CellPlanner.plan(layout, PlanOptions.USUAL);
        Proposal pixels = plan.single().stream()
                .filter(p -> p.changes().get(0).kind() == ChangeKind.MORE_PIXELS).findFirst().orElseThrow();
        double ifExact = CellPlanner.forecast(layout.with(exact), PlanOptions.USUAL).worstStdMm();
        assertTrue(ifExact < 0.5 * plan.now().worstStdMm(), ifExact + " " + plan.now());
        assertTrue(pixels.forecast().worstStdMm() > 0.8 * plan.now().worstStdMm(), pixels.forecast().toString());
    }

    private static Layout layout(ThesisScene scene, Cell cell) {
        Map<Integer, List<RigidTransform>> places = new LinkedHashMap<>();
        scene.objects().forEach((id, pose) -> places.put(id, List.of(pose)));
        return new Layout(cell, List.of(scene.worldFromCamera()), places);
    }

    /** One more reference where the plan puts it, against 200 drawn where the camera sees them, flat or tilted. */
    @Test
    void noneOfManyRandomReferencesIsBetterThanTheOneProposed() {
        ThesisScene scene = ThesisScene.inPlane(3).placement(1, 0.003).pixelStd(0.1).planeObjects();
        Layout layout = layout(scene, scene.cell());
        Plan plan = CellPlanner.plan(layout, PlanOptions.USUAL);
        Proposal best = plan.single().stream()
                .filter(p -> p.changes().get(0).kind() == ChangeKind.ADD_REFERENCE).findFirst().orElseThrow();
        Reference usual = layout.cell().references().get(0);
        Random random = new Random(3);
        int tried = 0;
        while (tried < 200) {
            RigidTransform pose = RigidTransform.ofEuler(-700 + 2200 * random.nextDouble(),
                    -600 + 1300 * random.nextDouble(), 200 * random.nextDouble(),
                    Math.toRadians(60 * random.nextDouble() - 30), Math.toRadians(60 * random.nextDouble() - 30), 0);
            List<Reference> references = new ArrayList<>(layout.cell().references());
            references.add(new Reference(1, usual.sizeMm(), pose, usual.placement()));
            Forecast with = CellPlanner.forecast(layout.with(layout.cell().withReferences(references)),
                    PlanOptions.USUAL);
            if (with.references().contains(1)) {
                tried++;
                assertTrue(best.forecast().worstStdMm() <= with.worstStdMm() * 1.01,
                        best.sentence() + ": " + best.forecast().worstStdMm() + ", not " + with.worstStdMm());
            }
        }
    }

    /** The worst of many poses is no better than any of them, and near the worst drawn at random within the range. */
    @Test
    void theWorstOfARangeIsForetold() {
        ThesisScene scene = ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.1).planeObjects();
        CameraRange range = new CameraRange(60, 40, 80, 4);
        List<RigidTransform> poses = range.poses(scene.worldFromCamera());
        assertEquals(21, poses.size());
        assertEquals(3, new CameraRange(0, 10, 0, 0).poses(scene.worldFromCamera()).size());
        assertEquals(1, CameraRange.NONE.poses(scene.worldFromCamera()).size());
        Layout layout = layout(scene, scene.cell());
        double worst = CellPlanner.forecast(layout.withCameras(poses), PlanOptions.USUAL).worstStdMm();
        assertTrue(worst > CellPlanner.forecast(layout, PlanOptions.USUAL).worstStdMm());
        Random random = new Random(4);
        for (int i = 0; i < 100; i++) {
            double[] turn = new double[3];
            double[] shift = {60, 40, 80};
            for (int k = 0; k < 3; k++) {
                shift[k] *= 2 * random.nextDouble() - 1;
            }
            turn[i % 3] = Math.toRadians(4 * (2 * random.nextDouble() - 1));
            RigidTransform pose = RigidTransform.ofEuler(shift[0], shift[1], shift[2], 0, 0, 0)
                    .compose(scene.worldFromCamera()).compose(RigidTransform.ofRotationVector(turn, new double[3]));
            assertTrue(CellPlanner.forecast(layout.withCameras(List.of(pose)), PlanOptions.USUAL).worstStdMm()
                    <= 1.03 * worst);
        }
    }

    @Test
    void wallsCarryReferencesAndHideWhatIsBehindThem() {
        Wall wall = new Wall(0, 100, 500, 100, 300);
        double[] above = {250, 0, 900};
        assertTrue(wall.hides(new double[] {250, 110, 0}, above));
        assertTrue(!wall.hides(new double[] {250, 90, 0}, above), "before it");
        assertTrue(!wall.hides(new double[] {250, 500, 0}, above), "seen over it");
        assertTrue(!wall.hides(new double[] {700, 110, 0}, new double[] {700, 0, 900}), "beside it");
        ThesisScene scene = ThesisScene.inPlane(3).placement(1, 0.003).pixelStd(0.1).planeObjects();
        PlanOptions usual = PlanOptions.USUAL;
        // a slanting view of a wall behind the table; the table itself is taken
        Layout layout = layout(scene, scene.cell()).withCameras(List.of(RigidTransform.ofEuler(250, -500, 700,
                Math.toRadians(-135), 0, 0)));
        PlanOptions walled = new PlanOptions(usual.settings(), usual.toneCurve(), usual.blurPx(), usual.noiseGrey(),
                List.of(new Area(-1, -1, 0, 0)), List.of(new Wall(0, 450, 500, 450, 300)), 0, 20, Map.of());
        Plan plan = CellPlanner.plan(layout, walled);
        Proposal added = plan.single().stream()
                .filter(p -> p.changes().get(0).kind() == ChangeKind.ADD_REFERENCE).findFirst().orElseThrow();
        List<Reference> references = added.layout().cell().references();
        RigidTransform pose = references.get(references.size() - 1).worldFromMarker();
        assertEquals(450, pose.translationMm()[1], 1e-9);
        assertEquals(-1, pose.rotation()[5], 1e-9, "it looks at the camera's side");
        assertTrue(pose.translationMm()[2] > 28, "its paper ends above the table");
    }

    /** More references and more precise ones are better, and this cell's own set-up is one of the table. */
    @Test
    void theTableFollowsPrecisionNumberAndArrangement() {
        ThesisScene scene = ThesisScene.inPlane(4).placement(1, 0.01).pixelStd(0.3).planeObjects();
        DecisionTable table = DecisionTable.of(layout(scene, scene.cell()), PlanOptions.USUAL);
        assertEquals(8, table.rows().size());
        double[] before = new double[5];
        for (DecisionTable.Row row : table.rows()) {
            assertEquals(5, row.worstStdMm().size());
            for (int i = 0; i < 5; i++) {
                if (!row.raised()) {
                    assertTrue(i == 0 || row.worstStdMm().get(i) <= row.worstStdMm().get(i - 1), table.toString());
                    assertTrue(row.worstStdMm().get(i) > before[i], "placed worse: " + table);
                    before[i] = row.worstStdMm().get(i);
                }
            }
        }
        Layout four = layout(scene, scene.cell());
        assertEquals(CellPlanner.forecast(four, PlanOptions.USUAL).worstStdMm(),
                table.rows().get(2).worstStdMm().get(2), 1e-9, "this cell is one of the table");
    }
}
