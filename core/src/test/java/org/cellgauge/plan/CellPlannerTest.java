package org.cellgauge.plan;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.cell.CameraCalibration;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ChangeKind;
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
}
