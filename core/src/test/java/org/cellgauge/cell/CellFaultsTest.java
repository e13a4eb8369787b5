package org.cellgauge.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.ByteArrayInputStream;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.cell.InputChecks;
import org.cellgauge.internal.cell.InputFiles;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Each fault of a cell file is refused with its file, line, key and remedy. */
class CellFaultsTest {
    @TempDir
    Path folder;

    /** Name; what to replace in the faultless file; by what; parts that the message must hold. */
    static Stream<Arguments> faults() {
        return Stream.of(
            fault("two of three numbers", "[492, 380, 0]", "[492, 380]",
                    "cell.yaml, line 7, references.944.position_mm: ", "expected 3 numbers, got 2", "[x, y, z] in mm"),
            fault("decimal comma in a list", "[492, 380, 0]", "[492,5, 380,0, 0,0]", "line 7", "got 6", "a point"),
            fault("decimal comma in a mapping", "size_mm: 47}", "size_mm: 47,5}", "line 3, markers.5: ", "a point"),
            fault("decimal comma in a block", "pixel_std_px: 0.3", "pixel_std_px: 0,3",
                    "line 5, pixel_std_px: ", "0.3"),
            fault("mistyped key", "size_mm: 47}", "sizemm: 47}", "cell.yaml, line 3, markers.sizemm: ",
                    "unknown key", "did you mean \"size_mm\"?"),
            fault("mistyped key at the top", "placement:", "placment:", "line 4, placment: ", "\"placement\""),
            fault("key like no other", "target:", "colour:", "line 12, colour: unknown key", "known here: ", "target"),
            fault("mistyped key of a reference", "rotation_deg: [0, 0, 0]}", "rotation: [0, 0, 0]}",
                    "line 7, references.944.rotation: ", "did you mean \"rotation_deg\"?"),
            fault("mistyped key of an object", "grip_mm", "grip", "line 11, objects.20.grip: ", "\"grip_mm\""),
            fault("key twice", "pixel_std_px: 0.3", "markers: {}", "line 5, markers: ", "twice", "line 3", "keep one"),
            fault("reference twice", "  22:", "  944:", "line 8, references.944: ", "twice", "line 7", "keep one"),
            fault("reference twice, once quoted", "  22:", "  '944':", "line 8, references.944: ", "line 7"),
            fault("reference and object", "  5:", "  22:", "line 10, objects.22: ", "line 8", "references.22",
                    "delete one"),
            fault("id beyond the family", "  944:", "  4096:", "line 7, references.4096: ",
                    "square-binary has no marker 4096", "0 to 4095"),
            fault("object's id beyond the family", "  5:", "  5000:", "line 10, objects.5000: ", "0 to 4095"),
            fault("negative id", "  944:", "  -1:", "line 7, references.-1: ", "no marker id", "0 to 4095"),
            fault("id with leading zero", "  5:", "  05:", "line 10, objects.05: ", "leading zeros"),
            fault("name in place of an id", "  5:", "  box:", "line 10, objects.box: ", "no marker id"),
            fault("unknown family", "square-binary", "square_binry", "line 3, markers.family: ",
                    "did you mean \"square-binary\"?"),
            fault("way up that is none", "size_mm: 47}", "size_mm: 47, orientation: upright}",
                    "line 3, markers.orientation: ", "no orientation", "write opencv"),
            fault("marker that looks the same when turned", AS_FAR_AS_FIRST_ID,
                    AS_FAR_AS_FIRST_ID.replace("square-binary", "aruco-original").replace("944", "1023"),
                    "line 7, references.1023: ", "looks like another", "another id"),
            fault("size of 0", "size_mm: 47}", "size_mm: 0}", "line 3, markers.size_mm: ", "greater than 0", "mm"),
            fault("negative size", "size_mm: 100}", "size_mm: -100}", "line 8, references.22.size_mm: ",
                    "greater than 0", "got -100"),
            fault("size in metres", "size_mm: 47}", "size_mm: 0.047}", "line 3, markers.size_mm: ", "not in m"),
            fault("deviation of 0", "[5, 6, 7]", "[5, 0, 7]", "line 4, placement.std_mm[1]: ", "greater than 0",
                    "0.01"),
            fault("negative deviation of an override", "[1, 1, 1]", "[1, 1, -1]",
                    "line 8, references.22.placement.std_mm[2]: ", "greater than 0"),
            fault("rotation deviation of 0", "std_deg: 0.5", "std_deg: 0", "line 4, placement.std_deg: ",
                    "greater than 0"),
            fault("one number for three deviations", "[5, 6, 7]", "5", "line 4, placement.std_mm: ",
                    "expected 3 numbers, got \"5\"", "[5, 5, 5]"),
            fault("corner deviation of 0", "pixel_std_px: 0.3", "pixel_std_px: 0.0", "line 5, pixel_std_px: ",
                    "greater than 0", "auto"),
            fault("corner deviation in words", "pixel_std_px: 0.3", "pixel_std_px: automatic",
                    "line 5, pixel_std_px: ", "\"automatic\"", "or auto"),
            fault("tone curve without its word", "pixel_std_px: 0.3", "tone_curve: 2.2", "line 5, tone_curve: ",
                    "\"2.2\" is no tone curve", "gamma 2.2"),
            fault("unknown tone curve", "pixel_std_px: 0.3", "tone_curve: rec709", "line 5, tone_curve: ",
                    "\"rec709\"", "auto, srgb, linear or gamma G"),
            fault("gamma that no camera has", "pixel_std_px: 0.3", "tone_curve: gamma 22", "line 5, tone_curve: ",
                    "\"gamma 22\"", "from 0.2 to 5"),
            fault("tone curve as a mapping", "pixel_std_px: 0.3", "tone_curve: {gamma: 2.2}", "line 5, tone_curve: ",
                    "a mapping", "gamma G"),
            fault("tone curve without a value", "pixel_std_px: 0.3", "tone_curve:", "line 5, tone_curve: ", "nothing"),
            fault("negative target", "std_mm: 1.0", "std_mm: -1.0", "line 12, target.std_mm: ", "greater than 0"),
            fault("target without its number", "{std_mm: 1.0}", "{}", "line 12, target.std_mm: ", "missing",
                    "std_mm: 1.0"),
            fault("target as a bare number", "{std_mm: 1.0}", "1.0", "line 12, target: ", "mapping",
                    "{std_mm: 1.0}"),
            fault("probability of all", "{std_mm: 1.0}", "{tolerance_mm: 1, probability: 1}",
                    "line 12, target.probability: ", "less than 1", "0.95"),
            fault("probability of nothing", "{std_mm: 1.0}", "{std_mm: 1, probability: 0.9}",
                    "line 12, target.tolerance_mm: ", "missing", "tolerance_mm: 1.0"),
            fault("tolerance of two axes", "{std_mm: 1.0}", "{tolerance_mm: [1, 2]}",
                    "line 12, target.tolerance_mm: ", "3 numbers", "[x, y, z]"),
            fault("tolerance along no axis", "{std_mm: 1.0}", "{tolerance_mm: [1, 0, 2]}",
                    "line 12, target.tolerance_mm[1]: ", "greater than 0"),
            fault("wall without height", "target:", "plan: {walls_mm: [[0, 0, 1, 0, 0]]}\ntarget:",
                    "line 12, plan.walls_mm[0]: ", "no length or no height"),
            fault("region of no object", "target:", "plan: {regions_mm: {6: [0, 0, 1, 1]}}\ntarget:",
                    "line 12, plan.regions_mm.6: ", "6 is no object"),
            fault("cost below nothing", "target:", "plan: {costs: {add-reference: -1}}\ntarget:",
                    "line 12, plan.costs.add-reference: ", "not be negative"),
            fault("cost of no change", "target:", "plan: {costs: {add: 1}}\ntarget:",
                    "line 12, plan.costs.add: ", "unknown key"),
            fault("not a number", "[492, 380, 0]", "[492, .nan, 0]", "line 7, references.944.position_mm[1]: ",
                    "finite", ".nan"),
            fault("infinite", "std_deg: 0.2", "std_deg: .inf", "line 8, references.22.placement.std_deg: ", "finite"),
            fault("overflow", "std_deg: 0.2", "std_deg: 1e999", "line 8, references.22.placement.std_deg: ", "finite"),
            fault("number in quotes", "size_mm: 47}", "size_mm: \"47\"}", "line 3, markers.size_mm: ",
                    "text \"47\"", "without quotes"),
            fault("number with its unit", "size_mm: 47}", "size_mm: 47 mm}", "line 3, markers.size_mm: ",
                    "\"47 mm\"", "without its unit"),
            fault("clock time, 90 in YAML 1.1", "size_mm: 47}", "size_mm: 1:30}", "markers.size_mm: ", "\"1:30\""),
            fault("list in place of a number", "size_mm: 47}", "size_mm: [47]}", "markers.size_mm: ", "a list"),
            fault("truth in place of a number", "size_mm: 47}", "size_mm: yes}", "markers.size_mm: ", "\"yes\""),
            fault("list in place of references' mapping", "{position_mm: [492, 380, 0], rotation_deg: [0, 0, 0]}",
                    "[492, 380, 0]", "line 7, references.944: ", "mapping", "a list", "position_mm"),
            fault("more than a full turn", "rotation_deg: [0, 0, 0]}", "rotation_deg: [0, 450, 0]}",
                    "line 7, references.944.rotation_deg: ", "full turn", "-360 to 360"),
            fault("missing version", "cellgauge: 1\n", "\n", "cellgauge: is missing", "cellgauge: 1"),
            fault("other version", "cellgauge: 1", "cellgauge: 2", "line 1, cellgauge: ", "cellgauge: 1"),
            fault("missing markers", "markers: {family: square-binary, size_mm: 47}", "", "line 1, markers: is missing",
                    "family: square-binary"),
            fault("missing family", "family: square-binary, ", "", "line 3, markers.family: is missing",
                    "square-binary"),
            fault("missing size", ", size_mm: 47}", "}", "line 3, markers.size_mm: is missing", "references.944"),
            fault("missing position", "position_mm: [492, 380, 0], ", "",
                    "line 7, references.944.position_mm: is missing", "[x, y, z]"),
            fault("missing placement", "placement: {std_mm: [5, 6, 7], std_deg: 0.5}", "",
                    "placement: is missing", "references.944", "line 7", "std_deg: 0.5"),
            fault("half a placement", ", std_deg: 0.5", "", "line 4, placement.std_deg: is missing", "std_deg: 0.5"),
            fault("missing camera", "camera: camera.yaml ", "", "line 1, camera: is missing", "camera.yaml"),
            fault("camera left empty", "camera: camera.yaml ", "camera: ", "line 2, camera: ", "nothing"),
            fault("missing camera file", "camera: camera.yaml", "camera: nowhere.yaml", "line 2, camera: ",
                    "no file \"nowhere.yaml\"", "relative to this file"),
            fault("references left empty", CellReaderTest.CELL.substring(CellReaderTest.CELL.indexOf("  944:"),
                    CellReaderTest.CELL.indexOf("objects:")), "", "line 6, references: ", "no reference", "944"),
            fault("references as an empty list", CellReaderTest.CELL.substring(
                    CellReaderTest.CELL.indexOf("references:"), CellReaderTest.CELL.indexOf("objects:")),
                    "references: []\n", "line 6, references: ",
                    "no reference", "944"),
            fault("references at one place", "[0, -36, 165], rotation_deg: [0, 0, 0]",
                    "[490, 380, 10], rotation_deg: [5, 0, 90]", "line 8, references.22.position_mm: ", "944 (line 7)",
                    "10.2 mm apart", "correct one"),
            fault("tab", "  5:", "\t5:", "cell.yaml, line 10, column 1: ", "tab", "spaces"),
            fault("open bracket", "[492, 380, 0]", "[492, 380, 0", "cell.yaml, line 7, column ", "not valid YAML",
                    "brackets"),
            fault("open quote", "square-binary", "\"square-binary", "cell.yaml, line ", "not valid YAML", "quotes"),
            fault("second document", "objects:", "---\nobjects:", "cell.yaml, line 9, column 1: ", "second document"),
            fault("merge key", "  5:  {}", "  5:  {<<: *b}", "line 10"),
            fault("merge key of an anchor", "5:  {}\n  20: {", "5: &a {}\n  20: {<<: *a, ",
                    "line 11, objects.20.<<: ", "merge", "write the keys out"),
            fault("tag of a program's own", "size_mm: 47}", "size_mm: !java.lang.Double 47}",
                    "line 3, markers.size_mm: ", "tag", "delete"));
    }

    private static final String AS_FAR_AS_FIRST_ID = CellReaderTest.CELL.substring(
            CellReaderTest.CELL.indexOf("square-binary"), CellReaderTest.CELL.indexOf("944") + 3);

    private static Arguments fault(String name, String from, String to, String... parts) {
        return arguments(name, from, to, parts);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("faults")
    void faultIsRefusedWithItsPlaceAndRemedy(String name, String from, String to, String[] parts) {
        assertTrue(CellReaderTest.CELL.contains(from), "the faultless file holds what is replaced");
        String text = CellReaderTest.CELL.replace(from, to);
        String message = assertThrows(InputRefusedException.class, () -> CellReader.read(text, "cell.yaml", file -> {
            if (!file.equals("camera.yaml")) {
                throw new FileNotFoundException(file);
            }
            return CellReaderTest.CAMERA;
        })).getMessage();
        assertHolds(message, "cell.yaml");
        assertHolds(message, parts);
    }

    @Test
    void missingFileIsRefused() {
        assertHolds(refusal(folder.resolve("cell.yaml")), "cell.yaml: ", "no such file", "check the name");
    }

    @Test
    void folderIsRefused() {
        assertHolds(refusal(folder), folder.toString(), "folder", "cell file");
    }

    @Test
    void emptyFileIsRefused() throws IOException {
        assertHolds(refusal(written("cell.yaml", "# nothing but a comment\n")), "cell.yaml: ", "empty");
    }

    @Test
    void binaryFileIsRefused() throws IOException {
        Path file = folder.resolve("a.png");
        Files.write(file, new byte[] {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13});
        assertHolds(refusal(file), "a.png: ", "UTF-8", "cell file");
        Files.write(file, new byte[] {'a', 0, 0, 'b'});
        assertHolds(refusal(file), "a.png: ", "binary", "cell file");
    }

    @Test
    void otherTextEncodingIsRefused() throws IOException {
        Path file = folder.resolve("cell.yaml");
        Files.write(file, ("\uFEFF" + CellReaderTest.CELL).getBytes(StandardCharsets.UTF_16LE));
        assertHolds(refusal(file), "cell.yaml: ", "UTF-16", "save");
    }

    @Test
    void hugeFileIsRefused() throws IOException {
        Path file = folder.resolve("cell.yaml");
        Files.write(file, new byte[CellReader.MAX_BYTES + 1]);
        assertHolds(refusal(file), "cell.yaml: ", "larger than 1024 KiB");
    }

    @Test
    void streamIsReadAndJudgedAsAFileIs() {
        byte[] text = "\uFEFFcellgauge: 1\n".getBytes(StandardCharsets.UTF_8);
        assertEquals("cellgauge: 1\n",
                InputFiles.text(new ByteArrayInputStream(text), "cell.yaml", CellPhrase.CELL_FILE, text.length));
        assertHolds(assertThrows(InputRefusedException.class, () -> InputFiles.text(new ByteArrayInputStream(text),
                "cell.yaml", CellPhrase.CELL_FILE, text.length - 1)).getMessage(), "cell.yaml: ", "larger than");
    }

    @Test
    void controlCharactersOfAFileDoNotReachTheMessage() {
        String message = assertThrows(InputRefusedException.class, () -> CellReaderTest.read(
                CellReaderTest.CELL.replace("target:", "\"\\e[31mtar\\nget\":"))).getMessage();
        assertHolds(message, "line 12", "unknown key");
        assertEquals(-1, message.indexOf('\u001b'));
    }

    @Test
    void manyAliasesAreRefusedBeforeTheyGrow() {
        StringBuilder text = new StringBuilder("a0: &a0 [x]\n");
        for (int i = 1; i < 40; i++) {
            text.append("a").append(i).append(": &a").append(i).append(" [*a").append(i - 1).append(", *a")
                    .append(i - 1).append("]\n");
        }
        assertHolds(assertThrows(InputRefusedException.class,
                () -> CellReader.read(text.toString(), "cell.yaml", n -> "")).getMessage(), "cell.yaml");
    }

    @Test
    void unreadableFileIsRefused() throws IOException {
        Path file = written("cell.yaml", CellReaderTest.CELL);
        Assumptions.assumeTrue(file.toFile().setReadable(false) && !Files.isReadable(file),
                "a user who may read everything");
        assertHolds(refusal(file), "cell.yaml: ", "permission");
    }

    @Test
    void missingCameraFileIsNamedWithItsWholePath() throws IOException {
        String message = refusal(written("cell.yaml", CellReaderTest.CELL));
        assertHolds(message, "cell.yaml, line 2, camera: ", "no file", folder.resolve("camera.yaml").toString());
    }

    @Test
    void folderInPlaceOfTheCameraFileIsRefused() throws IOException {
        Files.createDirectories(folder.resolve("camera.yaml"));
        assertHolds(refusal(written("cell.yaml", CellReaderTest.CELL)), "cell.yaml, line 2, camera: ", "folder");
    }

    @Test
    void faultOfTheCameraFileNamesTheCameraFile() throws IOException {
        written("camera.yaml", CellReaderTest.CAMERA.replace("fx: 581.0", "fx: -581.0"));
        String message = refusal(written("cell.yaml", CellReaderTest.CELL));
        assertHolds(message, "camera.yaml, line 2, pinhole.fx: ", "greater than 0");
        assertFalse(message.contains("cell.yaml"), message);
    }

    @Test
    void faultOfAnInlineCameraNamesTheCellFilesLine() {
        String inline = "camera:\n  model: pinhole\n  pinhole: {fx: 581, fy: 581, cx: 640, width: 1280, height: 720}\n";
        String message = assertThrows(InputRefusedException.class, () -> CellReader.read(
                CellReaderTest.CELL.replaceFirst("camera: .*\n", inline), "cell.yaml", n -> "")).getMessage();
        assertHolds(message, "cell.yaml, line 4, camera.pinhole.cy: is missing");
    }

    @Test
    void cameraFileInPlaceOfACellFileIsRecognised() throws IOException {
        assertHolds(refusal(written("camera.yaml", CellReaderTest.CAMERA)), "camera.yaml, line 1", "camera file",
                "name a cell file");
    }

    @Test
    void detectionsFileInPlaceOfACellFileIsRecognised() throws IOException {
        assertHolds(refusal(written("a.json", "{\"image\": {\"width\": 1280}, \"markers\": []}")), "a.json, line 1",
                "detections file", "name a cell file");
    }

    @Test
    void wordsInPlaceOfACellFileAreRefused() throws IOException {
        assertHolds(refusal(written("notes.txt", "bring the marker\n")), "notes.txt, line 1", "cellgauge: 1");
    }

    @Test
    void imageOfAnotherSizeIsRefused() {
        Cell cell = CellReaderTest.read(CellReaderTest.CELL);
        InputChecks.imageSize(cell, 1280, 720, "a.png");
        assertHolds(sizeRefusal(cell, 640, 480), "a.png: ", "640 x 480", "1280 x 720", "calibrate");
        assertHolds(sizeRefusal(cell, 640, 360), "scaled");
        assertHolds(sizeRefusal(cell, 720, 1280), "turned");
    }

    private static String sizeRefusal(Cell cell, int width, int height) {
        return assertThrows(InputRefusedException.class, () -> InputChecks.imageSize(cell, width, height, "a.png"))
                .getMessage();
    }

    private static String refusal(Path file) {
        return assertThrows(InputRefusedException.class, () -> CellReader.read(file)).getMessage();
    }

    private Path written(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.write(file, text.getBytes(StandardCharsets.UTF_8));
        return file;
    }

    static void assertHolds(String message, String... parts) {
        for (String part : parts) {
            assertTrue(message.contains(part), () -> "\"" + part + "\" is not in: " + message);
        }
        assertFalse(message.contains("\n"), () -> "one line: " + message);
    }
}
