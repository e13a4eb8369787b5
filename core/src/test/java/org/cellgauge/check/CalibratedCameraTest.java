package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalDouble;
import org.cellgauge.cell.CameraCalibration;
import org.cellgauge.cell.Cell;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.settings.CalibrationUse;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.vision.Detections;
import org.junit.jupiter.api.Test;

/** What a calibration leaves open reaches the objects. */
class CalibratedCameraTest {
    /** Objects' own corners are that precise that the camera matters. */
    private static final double PIXEL_STD_PX = 0.02;
    private static final ThesisScene SCENE = ThesisScene.oneRaised(4).placement(0.3, 0.002);
    private static final Detections PHOTO = SCENE.detections(PIXEL_STD_PX, RandomStreams.of(3), 0.3, 0.002);
    /** fx, fy, cx, cy, k1; the focal lengths go together, as those of every calibration. */
    private static final CameraCalibration WIDE = new CameraCalibration(List.of("fx", "fy", "cx", "cy", "k1"),
            new double[] {
                9, 8.8, 0, 0, 0.01,
                8.8, 9, 0, 0, 0.01,
                0, 0, 4, 0, 0,
                0, 0, 0, 4, 0,
                0.01, 0.01, 0, 0, 1e-4}, 20);

    private static Cell cell(CameraCalibration calibration) {
        return SCENE.cell().withPixelStdPx(OptionalDouble.of(PIXEL_STD_PX)).withCalibration(calibration);
    }

    private static CheckSettings.Builder settings() {
        return CheckSettings.builder().seed(5).iterations(3000).warmup(200);
    }

    @Test
    void itIsAPartOfTheVarianceAndOfTheBudget() {
        CellEstimate exact = quick(cell(null), settings());
        CellEstimate taken = quick(cell(WIDE), settings().set(SettingTable.CALIBRATION, CalibrationUse.EXACT));
        CheckResult known = CellCheck.run(cell(WIDE), PHOTO, settings().build());
        assertNull(exact.intrinsics());
        assertNotNull(known.estimate().intrinsics());
        assertEquals(List.of("fx_px", "fy_px", "cx_px", "cy_px", "k1"), known.estimate().intrinsics().names());
        ObjectEstimate object = known.estimate().object(20);
        for (int axis = 0; axis < 3; axis++) {
            double std = object.pose().std()[axis];
            assertTrue(std > 1.05 * exact.object(20).pose().std()[axis], "axis " + axis);
            // the approximation is the marginal of what is sampled in full
            assertEquals(std, known.quickLook().object(20).pose().std()[axis], 0.02 * std, "axis " + axis);
            assertEquals(exact.object(20).pose().std()[axis], taken.object(20).pose().std()[axis], 0,
                    "taken as exact, axis " + axis);
        }
        double share = object.budget().shares().get(VarianceSource.CALIBRATION);
        assertTrue(share > 0.04 && share < 0.99, "share " + share);
        assertNull(object.budget().shares().get(VarianceSource.INTRINSICS));
        assertNull(exact.object(20).budget().shares().get(VarianceSource.CALIBRATION));
    }

    private static CellEstimate quick(Cell cell, CheckSettings.Builder settings) {
        return CellCheck.quickLook(cell, PHOTO, settings.build(), null).estimate();
    }

    @Test
    void aNextToPerfectCalibrationIsAnExactCamera() {
        double[] next = WIDE.covariance();
        for (int i = 0; i < next.length; i++) {
            next[i] *= 1e-8;
        }
        double[] exact = quick(cell(null), settings()).object(20).pose().std();
        double[] known = quick(cell(new CameraCalibration(WIDE.parameters(), next, 20)), settings())
                .object(20).pose().std();
        for (int i = 0; i < 6; i++) {
            assertEquals(exact[i], known[i], 1e-5 * exact[i]);
        }
    }

    @Test
    void whatIsEstimatedIsNotWhatTheCalibrationSays() {
        CheckResult focal = CellCheck.run(cell(WIDE), PHOTO, settings().iterations(400).estimate(Estimate.FOCAL)
                .build());
        assertEquals(List.of("fx_px", "fy_px", "cx_px", "cy_px", "k1"), focal.estimate().intrinsics().names());
        assertTrue(focal.estimate().object(20).budget().shares().containsKey(VarianceSource.INTRINSICS));
        assertTrue(focal.estimate().object(20).budget().shares().containsKey(VarianceSource.CALIBRATION));
        CheckResult all = CellCheck.run(cell(null), PHOTO, settings().iterations(400).estimate(Estimate.INTRINSICS)
                .build());
        assertEquals(List.of("fx_px", "fy_px", "cx_px", "cy_px", "k1", "k2"), all.estimate().intrinsics().names());
    }
}
