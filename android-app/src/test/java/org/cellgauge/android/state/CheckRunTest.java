package org.cellgauge.android.state;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;

import java.util.Arrays;
import org.cellgauge.android.files.CellDocument;
import org.cellgauge.cell.CameraCalibration;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.geometry.PinholeCamera;
import org.junit.Test;

/** What a check takes of a calibration. */
public class CheckRunTest {
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(1280, 720, 900, 901, 640, 360);

    private static Cell checked(PinholeCamera camera, boolean calibrated) {
        Cell cell = CellReader.read("cellgauge: 1\nmarkers: {family: square-binary, size_mm: 47}\n"
                + "placement: {std_mm: [5, 5, 5], std_deg: 0.5}\nreferences: {944: {position_mm: [0, 0, 0]}}\n",
                "cell.yaml", CAMERA).withCalibration(new CameraCalibration(Arrays.asList("fx", "k1"),
                        new double[] {4, 1e-3, 1e-3, 1e-6}, 20));
        CellDocument document = new CellDocument("cell.yaml", null, cell, calibrated ? CAMERA : null);
        return new CheckRun(1, document, camera, false, null, new OneDetector(Detectors.OF_LIBRARY)).cell();
    }

    @Test
    public void covarianceOfTheCalibrationGoesAlong() {
        Cell cell = checked(CAMERA, true);
        assertEquals(2, cell.calibration().std(0), 0);
        // frames of half the size: the focal length is half as many pixels, and so is its deviation
        Cell half = checked(CAMERA.resized(640, 360), true);
        assertEquals(450, half.camera().get(PinholeCamera.FX), 0);
        assertEquals(1, half.calibration().std(0), 1e-15);
        assertEquals(5e-4, half.calibration().covariance()[1], 1e-18);
        assertEquals(1e-3, half.calibration().std(1), 1e-15);
    }

    @Test
    public void anotherCameraIsNotAsWellKnown() {
        assertNull(checked(CAMERA.withFocal(880, 880), true).calibration());
        assertNull(checked(CAMERA, false).calibration());
    }
}
