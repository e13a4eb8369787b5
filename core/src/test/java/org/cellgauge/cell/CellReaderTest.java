package org.cellgauge.cell;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.OptionalDouble;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.cell.CellWriter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What a faultless cell file says is what the cell holds. */
class CellReaderTest {
    static final String CAMERA = "model: pinhole_radial_tangential\n"
            + "pinhole: {fx: 581.0, fy: 582.0, cx: 640.5, cy: 360.5, width: 1280, height: 720, skew: 0.0}\n"
            + "radial_tangential: {radial: [-0.05, 0.01], t1: 0.001, t2: -0.002}\n";
    static final String CELL = "cellgauge: 1\n"
            + "camera: camera.yaml            # BoofCV calibration file, path relative to this file\n"
            + "markers: {family: square-binary, size_mm: 47}\n"
            + "placement: {std_mm: [5, 6, 7], std_deg: 0.5}\n"
            + "pixel_std_px: 0.3                                  # or: auto\n"
            + "references:\n"
            + "  944:  {position_mm: [492, 380, 0], rotation_deg: [0, 0, 0]}\n"
            + "  22:   {position_mm: [0, -36, 165], rotation_deg: [0, 0, 0], "
            + "placement: {std_mm: [1, 1, 1], std_deg: 0.2}, size_mm: 100}\n"
            + "objects:\n"
            + "  5:  {}\n"
            + "  20: {grip_mm: [0, 0, 100]}                       # point in the object marker's frame\n"
            + "target: {std_mm: 1.0}\n";

    @TempDir
    Path folder;

    static Cell read(String text) {
        return CellReader.read(text, "cell.yaml", name -> CAMERA);
    }

    /** Precision of prints: exact, flat and usual ink where nothing is said; 0 may be said; nothing is negative. */
    @Test
    void precisionOfPrintsIsReadAndComesBack() {
        PrintPrecision usual = read(CELL).prints();
        assertEquals(0, usual.sizeStdMm());
        assertEquals(0, usual.flatnessMm());
        assertEquals(0.05, usual.printGainStdMm());
        String stated = CELL.replace("size_mm: 47}", "size_mm: 47, size_std_mm: 0.1, flatness_mm: 0.2, "
                + "print_gain_std_mm: 0}");
        Cell cell = read(stated);
        for (Cell same : new Cell[] {cell, cell.withTarget(OptionalDouble.empty()),
            read(CellWriter.text(cell, Collections.emptyList()))}) {
            assertEquals(0.1, same.prints().sizeStdMm());
            assertEquals(0.2, same.prints().flatnessMm());
            assertEquals(0, same.prints().printGainStdMm());
        }
        InputRefusedException refused = assertThrows(InputRefusedException.class,
                () -> read(stated.replace("size_std_mm: 0.1", "size_std_mm: -0.1")));
        assertTrue(refused.getMessage().contains("size_std_mm"), refused.getMessage());
    }

    @Test
    void wholeFileIsReadAsWritten() {
        Cell cell = read(CELL);
        assertEquals(1280, cell.camera().widthPx());
        assertEquals(MarkerFamily.SQUARE_BINARY, cell.family());
        assertEquals(0.3, cell.pixelStdPx().getAsDouble());
        assertEquals(1.0, cell.targetStdMm().getAsDouble());
        assertEquals(2, cell.references().size());
        Reference first = cell.references().get(0);
        assertEquals(944, first.id());
        assertEquals(47, first.sizeMm());
        assertArrayEquals(new double[] {492, 380, 0}, first.worldFromMarker().translationMm());
        assertArrayEquals(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1}, first.worldFromMarker().rotation(), 1e-15);
        assertPlacement(first, 5, 6, 7, 0.5);
        Reference second = cell.references().get(1);
        assertEquals(22, second.id());
        assertEquals(100, second.sizeMm());
        assertArrayEquals(new double[] {0, -36, 165}, second.worldFromMarker().translationMm());
        assertPlacement(second, 1, 1, 1, 0.2);
        assertEquals(2, cell.objects().size());
        assertEquals(5, cell.objects().get(0).id());
        assertEquals(47, cell.objects().get(0).sizeMm());
        assertNull(cell.objects().get(0).gripMm());
        assertEquals(20, cell.objects().get(1).id());
        assertArrayEquals(new double[] {0, 0, 100}, cell.objects().get(1).gripMm());
    }

    @Test
    void documentedExampleIsRead() {
        Cell cell = read("cellgauge: 1\n"
                + "camera: camera.yaml            # BoofCV calibration file, path relative to this file; or inline\n"
                + "markers: {family: square-binary, size_mm: 47}      # also aruco-\u2026 / apriltag-\u2026\n"
                + "placement: {std_mm: [5, 5, 5], std_deg: 0.5}       # any reference may override\n"
                + "pixel_std_px: 0.3                                  # or: auto\n"
                + "references:\n"
                + "  944:  {position_mm: [492, 380, 0], rotation_deg: [0, 0, 0]}\n"
                + "  22:   {position_mm: [0, -36, 165], rotation_deg: [0, 0, 0], "
                + "placement: {std_mm: [1, 1, 1], std_deg: 0.2}, size_mm: 100}\n"
                + "objects:\n"
                + "  5:  {}\n"
                + "  20: {grip_mm: [0, 0, 100]}                       # point in the object marker's frame\n"
                + "target: {std_mm: 1.0}                              # every axis of every object\n");
        assertPlacement(cell.references().get(0), 5, 5, 5, 0.5);
        assertPlacement(cell.references().get(1), 1, 1, 1, 0.2);
        assertEquals(0.3, cell.pixelStdPx().getAsDouble());
        assertEquals(1.0, cell.targetStdMm().getAsDouble());
    }

    @Test
    void rotationTurnsAboutXThenYThenZInDegrees() {
        // Rz(90) Ry(0) Rx(90): x -> y, y -> z, z -> x
        Cell cell = read(CELL.replace("rotation_deg: [0, 0, 0]}", "rotation_deg: [90, 0, 90]}"));
        assertArrayEquals(new double[] {0, 0, 1, 1, 0, 0, 0, 1, 0},
                cell.references().get(0).worldFromMarker().rotation(), 1e-15);
    }

    @Test
    void rotationIsNoneWhereLeftOut() {
        Cell cell = read(CELL.replace(", rotation_deg: [0, 0, 0]}", "}"));
        assertArrayEquals(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1},
                cell.references().get(0).worldFromMarker().rotation(), 1e-15);
    }

    @Test
    void placementOverrideInheritsTheRotationItLeavesOut() {
        Cell cell = read(CELL.replace("placement: {std_mm: [1, 1, 1], std_deg: 0.2}",
                "placement: {std_mm: [1, 2, 3]}"));
        assertPlacement(cell.references().get(1), 1, 2, 3, 0.5);
    }

    @Test
    void placementOverrideInheritsTheLengthsItLeavesOut() {
        Cell cell = read(CELL.replace("placement: {std_mm: [1, 1, 1], std_deg: 0.2}", "placement: {std_deg: 0.2}"));
        assertPlacement(cell.references().get(1), 5, 6, 7, 0.2);
    }

    @Test
    void generalPlacementMayBeLeftOutWhereEveryReferenceStatesItsOwn() {
        Cell cell = read(CELL.replace("placement: {std_mm: [5, 6, 7], std_deg: 0.5}\n", "").replace(
                "[492, 380, 0],", "[492, 380, 0], placement: {std_mm: [2, 2, 2], std_deg: 0.1},"));
        assertPlacement(cell.references().get(0), 2, 2, 2, 0.1);
    }

    @Test
    void generalSizeMayBeLeftOutWhereEveryMarkerStatesItsOwn() {
        Cell cell = read("cellgauge: 1\ncamera: c\nmarkers: {family: apriltag-36h11}\n"
                + "placement: {std_mm: [5, 5, 5], std_deg: 0.5}\n"
                + "references: {0: {position_mm: [0, 0, 0], size_mm: 40}}\nobjects: {586: {size_mm: 30.5}}\n");
        assertEquals(40, cell.references().get(0).sizeMm());
        assertEquals(30.5, cell.objects().get(0).sizeMm());
        assertEquals("apriltag-36h11", cell.family().familyName());
    }

    @Test
    void pixelDeviationIsAutoWhereSaidOrLeftOut() {
        assertFalse(read(CELL.replace("pixel_std_px: 0.3", "pixel_std_px: auto")).pixelStdPx().isPresent());
        assertFalse(read(CELL.replace("pixel_std_px: 0.3", "")).pixelStdPx().isPresent());
    }

    @Test
    void objectsAndTargetMayBeLeftOut() {
        Cell cell = read(CELL.substring(0, CELL.indexOf("objects:")));
        assertTrue(cell.objects().isEmpty());
        assertFalse(cell.targetStdMm().isPresent());
    }

    @Test
    void objectWithNothingAfterItsColonIsAnObject() {
        assertEquals(5, read(CELL.replace("5:  {}", "5:")).objects().get(0).id());
    }

    @Test
    void exponentsAnchorsAndByteOrderMarkAreUnderstood() throws IOException {
        Files.write(folder.resolve("camera.yaml"), CAMERA.getBytes(StandardCharsets.UTF_8));
        Path file = folder.resolve("cell.yaml");
        Files.write(file, ("\uFEFF" + CELL.replace("pixel_std_px: 0.3", "pixel_std_px: 3e-1")
                .replace("placement: {std_mm: [1", "placement: &fine {std_mm: [1")
                .replace("[492, 380, 0],", "[492, 380, 0], size_mm: 47.,")
                .replace("\n", "\r\n")).getBytes(StandardCharsets.UTF_8));
        Cell cell = CellReader.read(file);
        assertEquals(0.3, cell.pixelStdPx().getAsDouble());
        assertPlacement(cell.references().get(1), 1, 1, 1, 0.2);
    }

    @Test
    void cameraFileIsFoundBesideTheCellFile() throws IOException {
        Files.createDirectories(folder.resolve("cameras"));
        Files.write(folder.resolve("cameras/left.yaml"), CAMERA.getBytes(StandardCharsets.UTF_8));
        Path file = folder.resolve("cell.yaml");
        Files.write(file, CELL.replace("camera.yaml ", "cameras/left.yaml ").getBytes(StandardCharsets.UTF_8));
        assertArrayEquals(CameraReader.read(CAMERA, "c").intrinsics(), CellReader.read(file).camera().intrinsics());
    }

    @Test
    void cameraMayStandInTheCellFile() {
        String inline = "camera:\n  " + CAMERA.trim().replace("\n", "\n  ") + "\n";
        Cell cell = CellReader.read(CELL.replaceFirst("camera: .*\n", inline), "cell.yaml", name -> {
            throw new IOException("no file is to be read");
        });
        assertEquals(-0.002, cell.camera().get(BrownLens.P2));
    }

    @Test
    void aCallerMayKnowTheCamera() {
        PinholeCamera own = PinholeCamera.ideal(640, 480, 500, 500, 320, 240);
        String without = CELL.replaceFirst("camera: .*\n", "");
        String inline = CELL.replaceFirst("camera: .*\n", "camera: {model: of another kind}\n");
        for (String text : new String[] {CELL, without, inline}) {
            Cell cell = CellReader.read(text, "cell.yaml", own);
            assertSame(own, cell.camera());
            assertEquals(2, cell.references().size());
            assertEquals(2, cell.objects().size());
        }
        // nobody else may leave it out
        InputRefusedException refused = assertThrows(InputRefusedException.class, () -> read(without));
        assertTrue(refused.getMessage().contains("camera: is missing"), refused.getMessage());
        // and what else is wrong is still wrong
        assertThrows(InputRefusedException.class, () -> CellReader.read(without + "colour: red\n", "cell.yaml", own));
    }

    @Test
    void howTheCameraIsStatedCanBeAsked() {
        StatedCamera named = CellReader.statedCamera(CELL, "cell.yaml");
        assertEquals(StatedCamera.Kind.FILE, named.kind());
        assertEquals("camera.yaml", named.fileName());
        StatedCamera none = CellReader.statedCamera(CELL.replaceFirst("camera: .*\n", ""), "cell.yaml");
        assertEquals(StatedCamera.Kind.NONE, none.kind());
        assertNull(none.fileName());
        String inline = "camera:\n  " + CAMERA.trim().replace("\n", "\n  ") + "\n";
        assertEquals(StatedCamera.Kind.INLINE,
                CellReader.statedCamera(CELL.replaceFirst("camera: .*\n", inline), "cell.yaml").kind());
        assertThrows(InputRefusedException.class, () -> CellReader.statedCamera(CAMERA, "cell.yaml"));
        assertThrows(InputRefusedException.class,
                () -> CellReader.statedCamera(CELL.replaceFirst("camera: .*\n", "camera: [1]\n"), "cell.yaml"));
    }

    @Test
    void anotherCameraLeavesTheRestOfTheCellAsItIs() {
        Cell cell = read(CELL);
        PinholeCamera other = cell.camera().resized(640, 360);
        Cell resized = cell.withCamera(other);
        assertSame(other, resized.camera());
        assertEquals(cell.references(), resized.references());
        assertEquals(cell.objects(), resized.objects());
        assertEquals(cell.targetStdMm(), resized.targetStdMm());
        assertEquals(cell.pixelStdPx(), resized.pixelStdPx());
        assertEquals(cell.family(), resized.family());
    }

    @Test
    void twoFacesOfOnePlateMayLieAtOnePlace() {
        Cell cell = read(CELL.replace("[0, -36, 165], rotation_deg: [0, 0, 0]",
                "[492, 380, -3], rotation_deg: [180, 0, 0]"));
        assertEquals(2, cell.references().size());
    }

    private static void assertPlacement(Reference r, double xMm, double yMm, double zMm, double deg) {
        assertArrayEquals(new double[] {xMm, yMm, zMm},
                new double[] {r.placement().stdMm(0), r.placement().stdMm(1), r.placement().stdMm(2)});
        assertEquals(deg * Math.PI / 180, r.placement().stdRad(), 1e-16);
    }

    private static String words(Cell cell) {
        return cell.toneCurve() == null ? "auto" : cell.toneCurve().words();
    }

    /** What the cell file says, what the camera file says, and which of them holds. */
    @ParameterizedTest
    @CsvSource({", , auto", "auto, , auto", "srgb, , srgb", "linear, , linear", "gamma 2.2, , gamma 2.2",
        "gamma 1, , linear", "'\"gamma 1.8\"', , gamma 1.8", ", srgb, srgb", ", auto, auto", ", gamma 1.8, gamma 1.8",
        "auto, gamma 1.8, auto", "linear, srgb, linear"})
    void toneCurveOfTheCellFileWinsOverTheCameraFiles(String inCell, String inCamera, String expected) {
        String camera = CAMERA + (inCamera == null ? "" : "tone_curve: " + inCamera + "\n");
        String ofCell = CELL + (inCell == null ? "" : "tone_curve: " + inCell + "\n");
        assertEquals(expected, words(CellReader.read(ofCell, "cell.yaml", name -> camera)));
        String inline = ofCell.replaceFirst("camera: .*\n", "camera:\n  " + camera.trim().replace("\n", "\n  ") + "\n");
        Cell cell = CellReader.read(inline, "cell.yaml", name -> {
            throw new IOException("the camera stands in the cell file");
        });
        assertEquals(expected, words(cell));
        assertEquals(expected, words(cell.withCamera(cell.camera()).withTarget(java.util.OptionalDouble.of(2))));
        // a camera known otherwise: nothing is read of the file's
        assertEquals(inCell == null ? "auto" : expected, words(CellReader.read(ofCell, "cell.yaml", cell.camera())));
        assertEquals(expected, words(CellReader.read(ofCell, "cell.yaml",
                CameraReader.file(camera, "camera.yaml", null))));
    }

    @Test
    void faultyToneCurveOfACameraFileIsRefusedThere() {
        InputRefusedException e = assertThrows(InputRefusedException.class,
                () -> CellReader.read(CELL, "cell.yaml", name -> CAMERA + "tone_curve: gama 2.2\n"));
        assertTrue(e.getMessage().startsWith("camera.yaml, line 4, tone_curve: "), e.getMessage());
    }
}
