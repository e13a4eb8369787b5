package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.Random;
import java.util.stream.Stream;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.light.ToneCurve;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Detections files say what they say, come back as written, and are refused where no marker can look so. */
class DetectionsFileTest {
    private static final String FILE = "{\"image\": {\"width\": 1280, \"height\": 720, \"name\": \"a.png\"},\n"
            + " \"markers\": [\n"
            + "  {\"id\": 944, \"corners_px\": [[710.5, 110], [760, 111], [761, 160], [709, 161]]},\n"
            + "  {\"id\": 5, \"corners_px\": [[20, 60], [20, 20], [60, 20], [60, 60]]}]}\n";

    @TempDir
    Path folder;

    private static Detections read(String text) {
        return DetectionsFile.read(new StringReader(text), "a.json");
    }

    @Test
    void everyValueIsReadAsWritten() {
        Detections detections = read(FILE);
        assertEquals("a.png", detections.imageName());
        assertEquals(1280, detections.widthPx());
        assertEquals(720, detections.heightPx());
        assertEquals(2, detections.markers().size());
        assertArrayEquals(new double[] {710.5, 110, 760, 111, 761, 160, 709, 161}, detections.find(944).cornersPx());
        assertArrayEquals(new double[] {20, 60, 20, 20, 60, 20, 60, 60}, detections.find(5).cornersPx());
    }

    @Test
    void orderOfTheKeysDoesNotMatter() {
        Detections detections = read("{\"markers\": [{\"corners_px\": [[1, 1], [9, 1], [9, 9], [1, 9]], \"id\": 0}], "
                + "\"image\": {\"name\": \"b\", \"height\": 10, \"width\": 12}}");
        assertEquals(12, detections.widthPx());
        assertEquals(0, detections.markers().get(0).id());
    }

    @Test
    void imageWithoutMarkersAndNameIsRead() {
        Detections detections = read("{\"image\": {\"width\": 640, \"height\": 480}, \"markers\": []}");
        assertEquals("a.json", detections.imageName());
        assertTrue(detections.markers().isEmpty());
    }

    @Test
    void writtenFileComesBackToTheLastDigit() throws IOException {
        Detections written = new Detections("a \"quoted\"\n\u00e4.png", 1920, 1080, Arrays.asList(
                new MarkerObservation(7, new double[] {1.0 / 3, 0.1, 1e2 / 3, 0.2, 100.0 / 3, 1e2 / 7, 1e-7, 14.3}),
                new MarkerObservation(4095, new double[] {900, 900, 950.25, 900, 950, 950, 900, 950})));
        StringBuilder text = new StringBuilder();
        DetectionsFile.write(written, text);
        Path file = folder.resolve("b.json");
        Files.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
        Detections read = DetectionsFile.read(file);
        assertEquals(written.imageName(), read.imageName());
        assertEquals(1920, read.widthPx());
        assertEquals(1080, read.heightPx());
        for (int i = 0; i < 2; i++) {
            assertEquals(written.markers().get(i).id(), read.markers().get(i).id());
            assertArrayEquals(written.markers().get(i).cornersPx(), read.markers().get(i).cornersPx());
        }
    }

    @Test
    void writtenFileWithoutMarkersComesBack() throws IOException {
        StringBuilder text = new StringBuilder();
        DetectionsFile.write(new Detections("a", 4, 3, Collections.emptyList()), text);
        assertTrue(read(text.toString()).markers().isEmpty());
    }

    static Stream<Arguments> faults() {
        String corners = "[[20, 60], [20, 20], [60, 20], [60, 60]]";
        return Stream.of(
            fault("cut off", FILE.substring(FILE.indexOf("709")), "", "a.json, line 3", "markers[0].corners_px", "ends",
                    "write it again"),
            fault("missing comma", "\"id\": 5,", "\"id\": 5", "a.json, line 4, column ", "markers[1].id",
                    "not valid JSON", "commas"),
            fault("single quotes", "\"id\": 5", "'id': 5", "a.json, line 4", "not valid JSON", "quotes"),
            fault("text after the end", "]]}]}", "]]}]} x", "line 4", "not valid JSON"),
            fault("unknown key", "\"id\": 5", "\"ident\": 5", "line 4",
                    "markers[1].ident: unknown key", "id, corners_px"),
            fault("unknown key of the image", "\"width\"", "\"breadth\"", "line 1",
                    "image.breadth: unknown key", "width"),
            fault("unknown key at the top", "\"image\"", "\"picture\"", "picture: unknown key",
                    "image, light, markers"),
            fault("key twice", "\"width\": 1280", "\"width\": 1280, \"width\": 1280", "image.width: stands twice",
                    "keep"),
            fault("missing image", "\"image\": {\"width\": 1280, \"height\": 720, \"name\": \"a.png\"},", "",
                    "image: is missing", "\"width\": 1280"),
            fault("missing height", "\"height\": 720, ", "", "image.height: is missing", "add"),
            fault("missing id", "\"id\": 5, ", "", "line 4", "markers[1].id: is missing"),
            fault("missing corners", ", \"corners_px\": " + corners, "", "markers[1].corners_px: is missing",
                    "[x, y]"),
            fault("width of 0", "1280", "0", "line 1", "image.width: ", "from 1 to 30000", "got 0"),
            fault("width in quotes", "1280", "\"1280\"", "image.width: ", "whole number", "text in quotes"),
            fault("negative id", "\"id\": 5", "\"id\": -5", "markers[1].id: ", "got -5"),
            fault("fraction as id", "\"id\": 5", "\"id\": 5.5", "markers[1].id: ", "whole number", "got 5.5"),
            fault("marker twice", "\"id\": 5", "\"id\": 944", "line 4", "markers[1].id: ", "944", "markers[0].id",
                    "keep the true one"),
            fault("three corners", ", [60, 60]]", "]", "line 4", "markers[1].corners_px: ", "expected 4 corners, got 3",
                    "top-left"),
            fault("three values of a corner", "[60, 60]]", "[60, 60, 1]]", "markers[1].corners_px[3]: ",
                    "expected 2 numbers, got 3", "[x, y]"),
            fault("corner not a number", "[60, 60]]", "[NaN, 60]]", "markers[1].corners_px[3][0]: ", "finite"),
            fault("infinite corner", "[60, 60]]", "[60, 1e999]]", "markers[1].corners_px[3][1]: ", "finite", "1e999"),
            fault("corner in quotes", "[60, 60]]", "[\"60\", 60]]", "markers[1].corners_px[3][0]: ", "without quotes"),
            fault("null corner", "[60, 60]]", "[null, 60]]", "markers[1].corners_px[3][0]: ", "null"),
            fault("corners as four objects", corners, "{\"x\": 1}", "markers[1].corners_px: ", "an object", "[[x, y]"),
            fault("mirrored order", corners, "[[20, 20], [20, 60], [60, 60], [60, 20]]", "line 4",
                    "markers[1].corners_px: ", "marker 5", "counter-clockwise", "top-left, top-right"),
            fault("crossed order", corners, "[[20, 20], [60, 60], [60, 20], [20, 60]]", "markers[1].corners_px: ",
                    "crosses itself", "top-left, top-right"),
            fault("dented outline", corners, "[[20, 20], [60, 20], [30, 30], [20, 60]]", "markers[1].corners_px: ",
                    "no picture of a square"),
            fault("corners in one point", corners, "[[20, 20], [20, 20], [20, 20], [20, 20]]",
                    "markers[1].corners_px: ", "no area"),
            fault("corners on one line", corners, "[[20, 20], [30, 20], [40, 20], [50, 20]]", "no area"),
            fault("corners as shares of the image", corners, "[[0.2, 0.2], [0.3, 0.2], [0.3, 0.3], [0.2, 0.3]]",
                    "no area", "in px"),
            fault("corner far outside", "[60, 60]]", "[60, 6000]]", "markers[1].corners_px: ", "6000", "far outside",
                    "1280 x 720"));
    }

    private static Arguments fault(String name, String from, String to, String... parts) {
        return arguments(name, from, to, parts);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("faults")
    void faultIsRefusedWithItsPlaceAndRemedy(String name, String from, String to, String[] parts) {
        assertTrue(FILE.contains(from), "the faultless file holds what is replaced");
        String message = assertThrows(InputRefusedException.class, () -> read(FILE.replace(from, to))).getMessage();
        assertTrue(message.startsWith("a.json, line "), message);
        for (String part : parts) {
            assertTrue(message.contains(part), () -> "\"" + part + "\" is not in: " + message);
        }
    }

    @Test
    void emptyMissingAndForeignFilesAreRefused() throws IOException {
        Path file = folder.resolve("c.json");
        assertTrue(refusal(file).contains("c.json: there is no such file"));
        Files.write(file, " \n".getBytes(StandardCharsets.UTF_8));
        assertTrue(refusal(file).contains("empty"));
        Files.write(file, "cellgauge: 1\n".getBytes(StandardCharsets.UTF_8));
        assertTrue(refusal(file).contains("not valid JSON"));
        Files.write(file, "[]".getBytes(StandardCharsets.UTF_8));
        assertTrue(refusal(file).contains("expected an object, got a list"));
        assertTrue(refusal(folder).contains("folder"));
    }

    private static String refusal(Path file) {
        return assertThrows(InputRefusedException.class, () -> DetectionsFile.read(file)).getMessage();
    }

    // ---- precision and light

    private static final String DIAGONAL = rows(0.01, 0, 0);
    private static final String PRECISE = FILE.replace("[60, 60]]}", "[60, 60]],\n   \"covariance_px2\": " + DIAGONAL
            + ",\n   \"edge_shift\": {\"px\": 0.25, \"variance_px2\": 0.04,\n    "
            + "\"covariance_with_corners_px2\": [0.001, 0, 0, 0, 0, 0, 0, -0.002]}}")
            .replace("\"a.png\"},", "\"a.png\"},\n \"light\": {\"tone_curve\": \"gamma 1.8\", "
            + "\"edge_shift_std_px\": 0.125, \"blur_px\": 0.75, \"noise_grey\": 2.5},");

    /** A covariance: its diagonal, and one pair of mirrored values. */
    private static String rows(double diagonal, double above, double below) {
        StringBuilder out = new StringBuilder("[");
        for (int i = 0; i < 8; i++) {
            out.append(i == 0 ? "[" : ",\n [");
            for (int j = 0; j < 8; j++) {
                double value = i == j ? diagonal : i == 0 && j == 1 ? above : i == 1 && j == 0 ? below : 0;
                out.append(j == 0 ? "" : ", ").append(value);
            }
            out.append(']');
        }
        return out.append(']').toString();
    }

    @Test
    void precisionAndLightAreReadAsWritten() {
        Detections read = read(PRECISE);
        assertNull(read.find(944).covariancePx2());
        assertNull(read.find(944).edgeShift());
        double[] covariance = read.find(5).covariancePx2();
        for (int i = 0; i < 64; i++) {
            assertEquals(i % 9 == 0 ? 0.01 : 0, covariance[i]);
        }
        assertEquals(0.25, read.find(5).edgeShift().shiftPx());
        assertEquals(0.04, read.find(5).edgeShift().variancePx2());
        assertArrayEquals(new double[] {0.001, 0, 0, 0, 0, 0, 0, -0.002},
                read.find(5).edgeShift().covarianceWithCornersPx2());
        assertEquals("gamma 1.8", read.light().toneCurve().words());
        assertFalse(read.light().toneCurveEstimated());
        assertEquals(0.125, read.light().edgeShiftStdPx());
        assertEquals(0.75, read.light().blurPx());
        assertEquals(2.5, read.light().noiseGrey());
        assertTrue(Double.isNaN(read.light().noiseDegreesOfFreedom()));
        assertNull(read(FILE).light());
        assertTrue(Double.isNaN(read(PRECISE.replace(", \"blur_px\": 0.75", "")).light().blurPx()));
    }

    @Test
    void precisionAndLightComeBackToTheLastDigit() throws IOException {
        Random random = new Random(4);
        double[] factor = random.doubles(64, -0.1, 0.1).toArray();
        double[] covariance = new double[64];
        for (int i = 0; i < 8; i++) {
            for (int j = 0; j < 8; j++) {
                for (int k = 0; k < 8; k++) {
                    covariance[8 * i + j] += factor[8 * i + k] * factor[8 * j + k];
                }
                covariance[8 * i + j] += i == j ? 0.001 : 0;
            }
        }
        double[] withCorners = random.doubles(8, -1e-4, 1e-4).toArray();
        double[] corners = {20, 60, 20, 20, 60, 20, 60, 60};
        PhotoLight light = new PhotoLight(ToneCurve.gamma(2.0 + 1.0 / 3), true, 1.0 / 7, 1.0 / 9, 123.5, 1.0 / 11);
        Detections written = new Detections("a.png", 1280, 720, Arrays.asList(
                new MarkerObservation(5, corners, covariance, new EdgeShift(-1.0 / 3, 2.0 / 3, withCorners)),
                new MarkerObservation(6, corners, covariance, null), new MarkerObservation(7, corners)),
                Collections.emptyList(), light);
        StringBuilder text = new StringBuilder();
        DetectionsFile.write(written, text);
        Detections read = read(text.toString());
        assertArrayEquals(covariance, read.find(5).covariancePx2());
        assertArrayEquals(covariance, read.find(6).covariancePx2());
        assertEquals(-1.0 / 3, read.find(5).edgeShift().shiftPx());
        assertEquals(2.0 / 3, read.find(5).edgeShift().variancePx2());
        assertArrayEquals(withCorners, read.find(5).edgeShift().covarianceWithCornersPx2());
        assertNull(read.find(6).edgeShift());
        assertNull(read.find(7).covariancePx2());
        assertEquals(light.toneCurve().words(), read.light().toneCurve().words());
        assertTrue(read.light().toneCurveEstimated());
        assertEquals(light.blurPx(), read.light().blurPx());
        assertEquals(light.noiseGrey(), read.light().noiseGrey());
        assertEquals(light.noiseDegreesOfFreedom(), read.light().noiseDegreesOfFreedom());
        assertEquals(light.edgeShiftStdPx(), read.light().edgeShiftStdPx());
        StringBuilder again = new StringBuilder();
        DetectionsFile.write(read, again);
        assertEquals(text.toString(), again.toString());
    }

    static Stream<Arguments> precisionFaults() {
        String lastRow = "0.0, 0.01]]";
        String withCorners = "[0.001, 0, 0, 0, 0, 0, 0, -0.002]";
        return Stream.of(
            fault("seven rows", ",\n [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.01]]", "]",
                    "markers[1].covariance_px2: expected 8 rows, got 7", "8 rows of 8 numbers"),
            fault("a row of nine", lastRow, "0.0, 0.01, 0]]",
                    "markers[1].covariance_px2[7]: expected 8 numbers, got 9"),
            fault("a flat list", DIAGONAL, "[0.01, 0, 0, 0, 0, 0, 0, 0]", "markers[1].covariance_px2[0]: ",
                    "got a number"),
            fault("a deviation", DIAGONAL, "0.1", "markers[1].covariance_px2: ", "got a number",
                    "or leave the key out"),
            fault("not symmetric", DIAGONAL, rows(0.01, 0.001, 0.0010001), "markers[1].covariance_px2: ", "marker 5",
                    "0.001 in row 1, column 2", "0.0010001 in row 2, column 1"),
            fault("not definite", DIAGONAL, rows(0.01, 0.01, 0.01), "markers[1].covariance_px2: ", "marker 5",
                    "not positive definite"),
            fault("negative", DIAGONAL, rows(-0.01, 0, 0), "markers[1].covariance_px2: ", "not positive definite"),
            fault("no number", lastRow, "0.0, 1e999]]", "markers[1].covariance_px2[7][7]: ", "finite"),
            fault("covariance twice", "\"edge_shift\": {", "\"covariance_px2\": [], \"edge_shift\": {",
                    "markers[1].covariance_px2: stands twice"),
            fault("shift without covariance", "\"covariance_px2\": " + DIAGONAL + ",", "",
                    "markers[1].edge_shift: marker 5", "add covariance_px2"),
            fault("shift as a number", "{\"px\": 0.25, \"variance_px2\": 0.04,\n    \"covariance_with_corners_px2\": "
                    + withCorners + "}", "0.25", "markers[1].edge_shift: expected an object"),
            fault("shift without its variance", "\"variance_px2\": 0.04,", "",
                    "markers[1].edge_shift.variance_px2: is missing"),
            fault("shift without its covariance", ",\n    \"covariance_with_corners_px2\": " + withCorners, "",
                    "markers[1].edge_shift.covariance_with_corners_px2: is missing"),
            fault("shift that is exact", "\"variance_px2\": 0.04", "\"variance_px2\": 0", "variance_px2: ", "above 0"),
            fault("seven covariances", withCorners, "[0, 0, 0, 0, 0, 0, 0]", "expected 8 numbers, got 7"),
            fault("covariances that are too large", withCorners, "[0.03, 0, 0, 0, 0, 0, 0, 0]",
                    "markers[1].edge_shift: ", "contradict each other", "marker 5"),
            fault("unknown key of the shift", "\"px\": 0.25", "\"shift\": 0.25",
                    "markers[1].edge_shift.shift: unknown"),
            fault("unknown tone curve", "gamma 1.8", "gama 1.8", "light.tone_curve: ", "gama 1.8", "gamma G"),
            fault("gamma that no camera has", "gamma 1.8", "gamma 18", "light.tone_curve: ", "between"),
            fault("light without its curve", "\"tone_curve\": \"gamma 1.8\", ", "", "light.tone_curve: is missing"),
            fault("light without its deviation", "\"edge_shift_std_px\": 0.125, ", "",
                    "light.edge_shift_std_px: is missing"),
            fault("negative blur", "\"blur_px\": 0.75", "\"blur_px\": -0.75", "light.blur_px: ", "from 0 on", "-0.75"),
            fault("unknown key of light", "\"blur_px\"", "\"blur\"", "light.blur: unknown key", "blur_px"),
            fault("light as a text", "{\"tone_curve\": \"gamma 1.8\", \"edge_shift_std_px\": 0.125, \"blur_px\": 0.75, "
                    + "\"noise_grey\": 2.5}", "\"srgb\"", "light: expected an object"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("precisionFaults")
    void faultyPrecisionIsRefusedWithItsPlaceAndRemedy(String name, String from, String to, String[] parts) {
        assertTrue(PRECISE.contains(from), "the faultless file holds what is replaced");
        String message = assertThrows(InputRefusedException.class, () -> read(PRECISE.replace(from, to))).getMessage();
        assertTrue(message.startsWith("a.json, line "), message);
        for (String part : parts) {
            assertTrue(message.contains(part), () -> "\"" + part + "\" is not in: " + message);
        }
    }

    /** Written by hand or in another program, mirrored values differ in their last digits. */
    @Test
    void roundedCovariancesAreTakenAsTheyAre() {
        double[] covariance = read(PRECISE.replace(DIAGONAL, rows(0.01, 0.001, 0.0010000001))).find(5).covariancePx2();
        assertEquals(0.001, covariance[1]);
        assertEquals(0.0010000001, covariance[8]);
    }
}
