package org.cellgauge.cell;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalDouble;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.cell.CalibratedCameraText;
import org.cellgauge.internal.cell.CameraExport;
import org.cellgauge.internal.cell.CameraWriter;
import org.cellgauge.internal.cell.CellWriter;
import org.cellgauge.internal.cell.InputChecks;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Camera files that say how well their intrinsics are known. */
class CameraCalibrationTest {
    private static final PinholeCamera CAMERA = PinholeCamera.of(1280, 720, new double[] {581.25, 582.5, 640.1,
        359.7, 0, -0.3, 0.12, 0, 0.001, -0.002});
    private static final List<List<Double>> COVARIANCE = List.of(List.of(0.4, 0.38, 1e-4),
            List.of(0.38, 0.41, 2e-4), List.of(1e-4, 2e-4, 1.7e-6));
    private static final String TEXT = CameraWriter.text(CAMERA)
            + CalibratedCameraText.block(List.of("fx", "fy", "k1"), COVARIANCE, 20, 0.21, 1.3);

    private static InputRefusedException refused(String text) {
        return assertThrows(InputRefusedException.class, () -> CameraReader.file(text, "camera.yaml", null));
    }

    /** It goes along with the camera wherever that goes: into a cell, into other sizes, and into a file again. */
    @Test
    void distanceOfTheFocusGoesWithTheCamera() {
        assertEquals(OptionalDouble.empty(), CameraReader.file(TEXT, "camera.yaml", null).focusDistanceM());
        String text = TEXT + CameraWriter.focusDistance(1 / 1.3);
        CameraFile file = CameraReader.file(text, "camera.yaml", null);
        assertEquals(OptionalDouble.of(1 / 1.3), file.focusDistanceM());
        String noCamera = CellReaderTest.CELL.replaceFirst("camera: .*\n", "");
        Cell cell = CellReader.read(noCamera, "cell.yaml", file);
        assertEquals(file.focusDistanceM(), cell.focusDistanceM());
        assertEquals(file.focusDistanceM(), cell.scaledTo(640, 360).focusDistanceM());
        assertEquals(file.focusDistanceM(), cell.withTarget(Target.NONE).withToneCurve(null).withCalibration(null)
                .withReferences(cell.references()).withObjects(cell.objects()).withPlanning(cell.planning())
                .withPixelStdPx(cell.pixelStdPx()).withJointPlacement(cell.joint()).focusDistanceM());
        assertEquals(OptionalDouble.empty(), cell.withCamera(CAMERA).focusDistanceM());
        assertEquals(file.focusDistanceM(), CellReader.read(CellWriter.text(cell, List.of()), "kept.yaml", name -> {
            throw new AssertionError("the camera is inline");
        }).focusDistanceM());
        for (CameraFormat format : CameraExport.FORMS.values()) {
            assertEquals(OptionalDouble.of(0.9), CameraReader.file(CameraExport.text(CAMERA, format)
                    + "focus_distance_m: 0.9\n", "camera.yaml", null).focusDistanceM());
        }
        assertThrows(IllegalArgumentException.class, () -> cell.withFocusDistanceM(OptionalDouble.of(0)));
    }

    @ParameterizedTest
    @CsvSource({"0, must be from 0.01 to 1000", "-1, must be from 0.01 to 1000", "1200, must be from 0.01 to 1000",
        ".inf, finite", "near, number", "0.9 m, without"})
    void distancesOfNoFocusAreRefusedInWords(String stated, String words) {
        InputRefusedException refused = refused(TEXT + "focus_distance_m: " + stated + "\n");
        assertTrue(refused.getMessage().startsWith("camera.yaml, line 14"), refused.getMessage());
        assertTrue(refused.getMessage().contains("focus_distance_m"), refused.getMessage());
        assertTrue(refused.getMessage().contains(words), refused.getMessage());
        assertTrue(refused.getMessage().contains("that the lens was focused at"), refused.getMessage());
    }

    /**
     * Blocks of 2 x 2 pixels become one. A place u, counted from the middle of the first pixel, becomes
     * (u + 0.5) / 2 - 0.5: the middle of the first block, between pixels 0 and 1, is the middle of the first pixel.
     */
    @Test
    void scaledImageShowsTheSameDirections() {
        Cell cell = CellReader.read(CellReaderTest.CELL.replaceFirst("camera: .*\n", ""), "cell.yaml",
                CameraReader.file(TEXT, "camera.yaml", null));
        Cell half = cell.scaledTo(640, 360);
        for (double x = -0.9; x < 1; x += 0.3) {
            double[] whole = cell.camera().project(1000 * x, 400 * x, 1000);
            double[] binned = half.camera().project(1000 * x, 400 * x, 1000);
            for (int i = 0; i < 2; i++) {
                assertEquals((whole[i] - 0.5 + 0.5) / 2 - 0.5, binned[i] - 0.5, 1e-10);
            }
        }
        CameraCalibration scaled = half.calibration();
        assertEquals(Math.sqrt(0.4) / 2, scaled.std(0), 1e-12);
        assertEquals(Math.sqrt(1.7e-6), scaled.std(2), 1e-12);
        assertArrayEquals(new double[] {0.1, 0.095, 5e-5, 0.095, 0.1025, 1e-4, 5e-5, 1e-4, 1.7e-6},
                scaled.covariance(), 1e-15);
        assertThrows(IllegalArgumentException.class, () -> cell.scaledTo(640, 480));
        assertSame(cell, InputChecks.ofSize(cell, 1280, 720, "a.png", true));
        assertEquals(640, InputChecks.ofSize(cell, 640, 360, "a.png", true).camera().widthPx());
        for (int[] size : new int[][] {{640, 480}, {720, 1280}, {360, 640}, {641, 360}}) {
            String message = assertThrows(InputRefusedException.class, () -> InputChecks.ofSize(cell, size[0], size[1],
                    "a.png", true)).getMessage();
            assertTrue(message.contains(size[0] + " x " + size[1] + " px"), message);
            assertTrue(message.contains("1280 x 720 px"), message);
            assertTrue(message.contains(size[0] == 720 ? "EXIF" : "cut"), message);
        }
        assertThrows(InputRefusedException.class, () -> InputChecks.ofSize(cell, 640, 360, "a.png", false));
    }

    @Test
    void fileComesBackAsItWasWritten() {
        CameraCalibration read = CameraReader.file(TEXT, "camera.yaml", null).calibration();
        assertNotNull(read);
        assertEquals(List.of("fx", "fy", "k1"), read.parameters());
        assertArrayEquals(new double[] {0.4, 0.38, 1e-4, 0.38, 0.41, 2e-4, 1e-4, 2e-4, 1.7e-6}, read.covariance(), 0);
        assertEquals(20, read.photos());
        assertArrayEquals(new int[] {PinholeCamera.FX, PinholeCamera.FY, BrownLens.K1}, read.indices(CAMERA.lens()));
        assertArrayEquals(CAMERA.intrinsics(), CameraReader.read(TEXT, "camera.yaml").intrinsics(), 0);
        assertNull(CameraReader.file(CameraWriter.text(CAMERA), "camera.yaml", null).calibration());
    }

    @Test
    void cellTakesTheCalibrationOfItsCamera() {
        String cell = "cellgauge: 1\ncamera: camera.yaml\nmarkers: {family: square-binary, size_mm: 47}\n"
                + "placement: {std_mm: [1, 1, 1], std_deg: 0.5}\npixel_std_px: 0.3\n"
                + "references:\n  944: {position_mm: [0, 0, 0], rotation_deg: [0, 0, 0]}\n";
        Cell read = CellReader.read(cell, "cell.yaml", name -> TEXT);
        assertEquals(CameraReader.file(TEXT, "camera.yaml", null).calibration(), read.calibration());
        assertEquals(read.calibration(), read.withPixelStdPx(java.util.OptionalDouble.of(1)).calibration());
        assertNull(read.withCamera(CAMERA).calibration(), "another camera's calibration is another one");
    }

    @Test
    void whatIsNoCovarianceIsRefusedWithItsPlace() {
        // a row too few, an entry too few, not symmetric, no variance, correlated by more than 1
        String[] broken = {TEXT.replaceFirst("(?m)^ +- \\[0.4.*\n", ""), TEXT.replace("0.38, 0.41, ", "0.41, "),
            TEXT.replace("[0.4, 0.38", "[0.4, 0.3"), TEXT.replace("[0.4, ", "[0, "), TEXT.replace("0.38", "0.48")};
        for (String text : broken) {
            InputRefusedException e = refused(text);
            assertEquals(CellRefusal.NO_COVARIANCE, e.refusal().kind());
            assertTrue(e.getMessage().contains("cellgauge_calibration.covariance"), e.getMessage());
        }
        InputRefusedException foreign = refused(TEXT.replace("fy, k1]", "fy, k9]"));
        assertEquals(CellRefusal.CALIBRATED_PARAMETER, foreign.refusal().kind());
        assertTrue(foreign.getMessage().contains("fx, fy, cx, cy, skew, k1"), foreign.getMessage());
        assertEquals(CellRefusal.CALIBRATED_PARAMETER, refused(TEXT.replace("fy, k1]", "fy, fy]")).refusal().kind());
        assertEquals(CellRefusal.MISSING, refused(TEXT.replace("covariance:", "covariants:")).refusal().kind());
    }
}
