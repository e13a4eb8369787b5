package org.cellgauge.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CalibrationTargetReaderTest {
    @TempDir
    private Path folder;

    private CalibrationTarget read(String text) throws IOException {
        return CalibrationTargetReader.read(Files.writeString(folder.resolve("target.yaml"), text));
    }

    @Test
    void readsGrids() throws IOException {
        assertEquals(new CalibrationTarget.Grid(CalibrationTarget.Pattern.CHESSBOARD, 7, 5, 30, 30),
                read("cellgauge_target: 1\nchessboard: {rows: 7, columns: 5, square_mm: 30}\n"));
        assertEquals(new CalibrationTarget.Grid(CalibrationTarget.Pattern.HEXAGONAL_CIRCLE_GRID, 8, 10, 20, 40),
                read("cellgauge_target: 1\nhexagonal_circle_grid: {rows: 8, columns: 10, diameter_mm: 20, "
                        + "spacing_mm: 40}\n"));
        assertEquals(new CalibrationTarget.Grid(CalibrationTarget.Pattern.ECOCHECK, 10, 7, 1, 1),
                read("boofcv.alg.fiducial.calib.ConfigCalibrationTarget:\n  ecocheck:\n    markerShapes:\n"
                        + "    - numRows: 10\n      squareSize: 1.0\n      numCols: 7\n  type: ECOCHECK\n"));
    }

    /** OpenCV's board of 3 rows and 4 columns: id 0 in the second square of the first row, 6 markers in all. */
    @Test
    void charucoMarkersLieInTheWhiteSquares() throws IOException {
        CalibrationTarget.Markers board = (CalibrationTarget.Markers) read("cellgauge_target: 1\ncharuco: {rows: 3, "
                + "columns: 4, square_mm: 20, marker_mm: 15, family: aruco-mip-36h12}\n");
        assertEquals(6, board.markers().size());
        double[] first = board.markers().get(0).worldFromMarker().translationMm();
        assertEquals(-10, first[0], 1e-9);
        assertEquals(20, first[1], 1e-9);
        double[] third = board.markers().get(2).worldFromMarker().translationMm();
        assertEquals(-30, third[0], 1e-9);
        assertEquals(0, third[1], 1e-9);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "cellgauge: 1 | this is a cell file",
        "chessboard: {rows: 7, columns: 5, square_mm: 30} | is missing; add cellgauge_target: 1",
        "cellgauge_target: 1 | states one target",
        "{cellgauge_target: 1, chesboard: {rows: 7}} | did you mean \"chessboard\"",
        "{cellgauge_target: 1, chessboard: {rows: 7, columns: 5}} | chessboard.square_mm: is missing",
        "{cellgauge_target: 1, chessboard: {rows: 2, columns: 5, square_mm: 3}} | must be from 3 to 1000",
        "{cellgauge_target: 1, circle_grid: {rows: 7, columns: 5, diameter_mm: 30, spacing_mm: 20}} | touch",
        "{cellgauge_target: 1, marker_plate: {family: aruco, size_mm: 3, positions_mm: {}}} | no marker family",
        "{cellgauge_target: 1, cell: {file: none.yaml}} | there is no file"})
    void refusesWithTheRemedy(String text, String words) {
        InputRefusedException refused = assertThrows(InputRefusedException.class, () -> read(text));
        assertTrue(refused.getMessage().contains("target.yaml"), refused.getMessage());
        assertTrue(refused.getMessage().contains(words), refused.getMessage());
    }
}
