package org.cellgauge.android.state;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.cellgauge.android.camera.CameraModelSource;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Verdict;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.output.ResultView;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.junit.Test;

/**
 * Lenses that bend rays, seen through a model that does not. Truth is simulated: corners are those of the bent lens,
 * and where the objects are is known.
 */
public class LensKnowledgeTest {
    private static final PinholeCamera STRAIGHT = PinholeCamera.ideal(1280, 720, 950, 950, 640, 360);
    private static final double NOISE_PX = 0.1;
    /** Objects at the border of the view, where a lens bends most. */
    private static final double[][] PLACES_MM = {{-420, -210, 40}, {430, 220, 20}, {0, 240, 60}};
    private static final int[] IDS = {5, 6, 7};
    private static final String CELL = "cellgauge: 1\nmarkers: {family: square-binary, size_mm: 60}\n"
            + "placement: {std_mm: [0.5, 0.5, 0.5], std_deg: 0.1}\npixel_std_px: 0.1\n"
            + "target: {std_mm: 3}\nreferences:\n"
            + "  10: {position_mm: [-150, -120, 0]}\n  20: {position_mm: [150, -120, 0]}\n"
            + "  30: {position_mm: [150, 120, 0]}\n  40: {position_mm: [-150, 120, 100]}\n"
            + "objects: {5: {}, 6: {}, 7: {}}\n";

    private static PinholeCamera bent(double k1) {
        double[] intrinsics = new double[BrownLens.MODEL.parameterCount()];
        System.arraycopy(STRAIGHT.intrinsics(), 0, intrinsics, 0, PinholeCamera.SKEW);
        intrinsics[BrownLens.MODEL.parameterNames().indexOf("k1")] = k1;
        return PinholeCamera.of(BrownLens.MODEL, STRAIGHT.widthPx(), STRAIGHT.heightPx(), intrinsics);
    }

    private static Cell cell() {
        return CellReader.read(CELL, "cell.yaml", STRAIGHT);
    }

    private static Detections photo(Cell cell, PinholeCamera lens, int view) {
        Random noise = new Random(100 + view);
        RigidTransform cameraFromWorld = RigidTransform.ofEuler(20 * view - 20, 30 - 30 * view, 900,
                Math.PI - 0.15 + 0.15 * view, 0.1 * view - 0.1, 0.05).inverse();
        List<MarkerObservation> markers = new ArrayList<>();
        for (Reference reference : cell.references()) {
            markers.add(seen(reference.id(), cameraFromWorld.compose(reference.worldFromMarker()), lens, noise));
        }
        for (int i = 0; i < IDS.length; i++) {
            RigidTransform worldFromObject = RigidTransform.ofEuler(PLACES_MM[i][0], PLACES_MM[i][1], PLACES_MM[i][2],
                    0.2, -0.2, 0.3);
            markers.add(seen(IDS[i], cameraFromWorld.compose(worldFromObject), lens, noise));
        }
        return new Detections("view " + view, STRAIGHT.widthPx(), STRAIGHT.heightPx(), markers);
    }

    private static MarkerObservation seen(int id, RigidTransform cameraFromMarker, PinholeCamera lens, Random noise) {
        double[] px = MarkerGeometry.cornersPx(lens, cameraFromMarker, 60);
        for (int i = 0; i < px.length; i++) {
            px[i] += NOISE_PX * noise.nextGaussian();
        }
        return new MarkerObservation(id, px);
    }

    /** The largest error of any coordinate of any object, mm, and the same in its deviations. */
    private static double[] worstError(CheckResult result) {
        ResultView view = ResultView.of(result);
        double mm = 0;
        double stds = 0;
        for (int i = 0; i < IDS.length; i++) {
            for (int axis = 0; axis < 3; axis++) {
                double error = Math.abs(view.object(IDS[i]).mean()[axis] - PLACES_MM[i][axis]);
                mm = Math.max(mm, error);
                stds = Math.max(stds, error / view.object(IDS[i]).std()[axis]);
            }
        }
        return new double[] {mm, stds};
    }

    private static CheckResult check(double k1, int view, CheckSettings settings) {
        Cell cell = cell();
        return CellCheck.run(cell, photo(cell, bent(k1), view), settings);
    }

    @Test
    public void whatAnUnmeasuredLensDoesIsInTheFigures() {
        CheckSettings unmeasured = LensKnowledge.settings(CheckSettings.builder().threads(1).build(), STRAIGHT, false);
        for (double k1 : new double[] {0.03, 0.06, -0.06}) {
            for (int view = 0; view < 3; view++) {
                CheckResult result = check(k1, view, unmeasured);
                double[] worst = worstError(result);
                String what = "k1 " + k1 + ", view " + view + ": " + worst[0] + " mm, " + worst[1] + " deviations, "
                        + result.reason();
                // the largest of nine errors, each beyond 4.5 deviations in one of 150 000 cases
                assertTrue(what, worst[1] < 4.5);
                assertTrue(what, result.referenceCheck().misplaced().isEmpty());
                assertTrue(what, result.verdict() != Verdict.PASS || worst[0] < 3 * 3);
            }
        }
    }

    /** Why: at its word the same lens is wrong by more than it says, or accuses references that stand right. */
    @Test
    public void aModelAtItsWordLeavesTheLensOut() {
        CheckSettings trusted = LensKnowledge.settings(CheckSettings.builder().threads(1).build(), STRAIGHT, true);
        CheckResult result = check(0.06, 0, trusted);
        assertTrue(result.verdict() == Verdict.CONTRADICTED || worstError(result)[1] > 4.5
                || !result.referenceCheck().misplaced().isEmpty());
    }

    @Test
    public void onlyACalibrationCountsAsOne() {
        CheckSettings general = CheckSettings.builder().seed(7).build();
        assertTrue(LensKnowledge.isMeasured(CameraModelSource.CALIBRATION_FILE));
        assertFalse(LensKnowledge.isMeasured(CameraModelSource.FIELD_OF_VIEW));
        assertFalse(LensKnowledge.isMeasured(CameraModelSource.DEVICE_CALIBRATION));
        CheckSettings settings = LensKnowledge.settings(general, STRAIGHT, false);
        assertEquals(Estimate.INTRINSICS, settings.model().estimate());
        assertEquals(7, settings.sampling().seed());
        assertEquals(Estimate.NONE, LensKnowledge.settings(settings, STRAIGHT, true).model().estimate());
    }
}
