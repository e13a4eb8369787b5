package org.cellgauge.android.state;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.cellgauge.android.camera.CameraModelSource;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Verdict;
import org.cellgauge.output.ResultView;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.junit.Test;

/**
 * Lenses that bend rays, seen through a model that does not. Truth is simulated: corners are those of the bent lens,
 * and where the objects are is known.
 */
public class LensKnowledgeTest {
    private static final CheckSettings QUICK = CheckSettings.builder().targetMcseStdRel(0.1).threads(1).build();

    /** The largest error of any coordinate of any object, mm, and the same in its deviations. */
    private static double[] worstError(CheckResult result) {
        ResultView view = ResultView.of(result);
        double mm = 0;
        double stds = 0;
        for (int i = 0; i < SimulatedCell.IDS.length; i++) {
            for (int axis = 0; axis < 3; axis++) {
                double error = Math.abs(view.object(SimulatedCell.IDS[i]).mean()[axis]
                        - SimulatedCell.PLACES_MM[i][axis]);
                mm = Math.max(mm, error);
                stds = Math.max(stds, error / view.object(SimulatedCell.IDS[i]).std()[axis]);
            }
        }
        return new double[] {mm, stds};
    }

    private static CheckResult check(double k1, int view, CheckSettings settings) {
        Cell cell = SimulatedCell.cell();
        return CellCheck.run(cell, SimulatedCell.photo(cell, SimulatedCell.bent(k1), view), settings);
    }

    @Test
    public void whatAnUnmeasuredLensDoesIsInTheFigures() {
        CheckSettings unmeasured = LensKnowledge.settings(QUICK, SimulatedCell.STRAIGHT, false);
        for (double k1 : new double[] {0.03, 0.06}) {
            for (int view = 0; view < 3; view += 2) {
                CheckResult result = check(k1, view, unmeasured);
                double[] worst = worstError(result);
                String what = "k1 " + k1 + ", view " + view + ": " + worst[0] + " mm, " + worst[1] + " deviations, "
                        + result.reason();
                // the largest of nine errors in each of four photos, each beyond 4.5 deviations in one of 150 000 cases
                assertTrue(what, worst[1] < 4.5);
                assertTrue(what, result.referenceCheck().misplaced().isEmpty());
                assertTrue(what, result.verdict() != Verdict.PASS || worst[0] < 3 * 3);
            }
        }
    }

    /** Why: at its word the same lens is wrong by more than it says, or accuses references that stand right. */
    @Test
    public void aModelAtItsWordLeavesTheLensOut() {
        CheckSettings trusted = LensKnowledge.settings(QUICK, SimulatedCell.STRAIGHT, true);
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
        CheckSettings settings = LensKnowledge.settings(general, SimulatedCell.STRAIGHT, false);
        assertEquals(Estimate.INTRINSICS, settings.model().estimate());
        assertEquals(7, settings.sampling().seed());
        assertEquals(Estimate.NONE, LensKnowledge.settings(settings, SimulatedCell.STRAIGHT, true).model().estimate());
    }
}
