package org.cellgauge.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Target files that mutation found: each ended in an internal error. */
class TargetFileRangesTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "charuco: {rows: 8, columns: 11, square_mm: 1e308, marker_mm: 18, family: aruco-mip-36h12}"
                + " | charuco.square_mm: 1.0E308 mm is more than a kilometre",
        "marker_plate: {family: apriltag-36h11, size_mm: 40, positions_mm: {0: [0, 0], 1: [60, -1e307]}}"
                + " | marker_plate.positions_mm.1: -1.0E307 mm is more than a kilometre",
        "cell: {file: \"a\\0b\"} | cell.file: there is no file"})
    void isRefused(String kind, String message) throws IOException {
        refuses("cellgauge_target: 1\n" + kind + "\n", message);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = "{type: ECOCHECK, ecocheck: {markerShapes: []}} | markerShapes: is missing")
    void ofBoofCvIsRefused(String value, String message) throws IOException {
        refuses("boofcv.alg.fiducial.calib.ConfigCalibrationTarget: " + value + "\n", message);
    }

    private void refuses(String text, String message) throws IOException {
        Path file = Files.writeString(folder.resolve("target.yaml"), text);
        InputRefusedException refused = assertThrows(InputRefusedException.class,
                () -> CalibrationTargetReader.read(file));
        assertTrue(refused.getMessage().contains(message), refused.getMessage());
        assertEquals(file.toString(), refused.refusal().place().file());
    }
}
