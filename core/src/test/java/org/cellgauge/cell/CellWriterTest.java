package org.cellgauge.cell;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Random;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.cell.CameraWriter;
import org.cellgauge.internal.cell.CellWriter;
import org.cellgauge.light.ToneCurve;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What is written is read back as the same cell, from one file. */
@Isolated("changes the default locale")
class CellWriterTest {
    private static final CameraSource NO_OTHER_FILE = name -> {
        throw new IOException("a written cell names no other file, but this one names " + name);
    };

    private static Cell again(Cell cell) {
        return CellReader.read(CellWriter.text(cell, Collections.emptyList()), "written", NO_OTHER_FILE);
    }

    private static void assertSame(Cell expected, Cell actual) {
        assertEquals(expected.camera().toString(), actual.camera().toString());
        assertArrayEquals(expected.camera().intrinsics(), actual.camera().intrinsics());
        assertEquals(expected.family(), actual.family());
        assertEquals(expected.pixelStdPx(), actual.pixelStdPx());
        assertEquals(expected.prints().sizeStdMm(), actual.prints().sizeStdMm());
        assertEquals(expected.prints().flatnessMm(), actual.prints().flatnessMm());
        assertEquals(expected.prints().printGainStdMm(), actual.prints().printGainStdMm());
        assertEquals(expected.target(), actual.target());
        assertEquals(expected.references().size(), actual.references().size());
        for (int i = 0; i < expected.references().size(); i++) {
            Reference e = expected.references().get(i);
            Reference a = actual.references().get(i);
            assertEquals(e.id(), a.id());
            assertEquals(e.sizeMm(), a.sizeMm());
            assertArrayEquals(e.worldFromMarker().translationMm(), a.worldFromMarker().translationMm());
            for (int k = 0; k < 9; k++) {
                assertTrue(e.worldFromMarker().rotation()[k] == a.worldFromMarker().rotation()[k],
                        "rotation of reference " + e.id());
            }
            for (int axis = 0; axis < 3; axis++) {
                assertEquals(e.placement().stdMm(axis), a.placement().stdMm(axis));
            }
            assertEquals(e.placement().stdRad(), a.placement().stdRad());
        }
        assertEquals(expected.objects().size(), actual.objects().size());
        for (int i = 0; i < expected.objects().size(); i++) {
            assertEquals(expected.objects().get(i).id(), actual.objects().get(i).id());
            assertEquals(expected.objects().get(i).sizeMm(), actual.objects().get(i).sizeMm());
            assertArrayEquals(expected.objects().get(i).gripMm(), actual.objects().get(i).gripMm());
        }
    }

    @Test
    void everyKeyComesBack() {
        Cell cell = CellReaderTest.read(CellReaderTest.CELL);
        assertSame(cell, again(cell));
    }

    @Test
    void targetsOfAllAndOfSingleObjectsComeBack() {
        Cell cell = CellReaderTest.read(CellReaderTest.CELL.replace("{std_mm: 1.0}", "{std_mm: [1, 1, 2.5], "
                + "tolerance_mm: 3, tolerance_deg: 0.5, probability: 0.99}").replace("grip_mm: [0, 0, 100]",
                "grip_mm: [0, 0, 100], target: {tolerance_mm: [1, 2, 3], distance_mm: 4.25}"));
        assertSame(cell, again(cell));
        Requirement own = cell.target().of(20);
        assertEquals(new Requirement(new Requirement.Axes(1, 1, 2.5), new Requirement.Axes(1, 2, 3), 4.25, 0.5, 0.99),
                own, "what is left out is that of all");
        assertEquals(3, cell.target().of(5).toleranceMm().z());
        assertEquals(OptionalDouble.empty(), cell.targetStdMm());
    }

    @Test
    void whatIsSaidForPlanningComesBack() {
        Cell cell = CellReaderTest.read(CellReaderTest.CELL + "plan:\n"
                + "  camera_pose: [418, 106, 1070, 176.5, 5.5, 1]\n"
                + "  camera_range: {position_mm: [50, 40, 0], turn_deg: 5}\n"
                + "  regions_mm: {5: [500, 400, 0, 0]}\n"
                + "  free_mm: [[0, 0, 500, 400], [600, 0, 700, 50.5]]\n"
                + "  walls_mm: [[0, 450, 500, 450, 300]]\n"
                + "  max_height_mm: 0\n"
                + "  costs: {raise-reference: 40, more-pixels: 0}\n");
        assertEquals(new Area(0, 0, 500, 400), cell.planning().regions().get(5));
        assertEquals(40, cell.planning().costs().get(ChangeKind.RAISE_REFERENCE));
        Cell again = again(cell);
        assertArrayEquals(cell.planning().worldFromCamera().rotation(), again.planning().worldFromCamera().rotation(),
                1e-15);
        assertArrayEquals(new double[] {418, 106, 1070}, again.planning().worldFromCamera().translationMm());
        Planning read = cell.planning();
        assertEquals(new Planning(again.planning().worldFromCamera(), read.cameraRange(), read.regions(), read.free(),
                read.walls(), read.maxHeightMm(), read.costs()), again.planning());
    }

    @Test
    void markersAreTheSameWayUpAgain() {
        String text = CellReaderTest.CELL.replace("{family: square-binary,", "{family: tag36h11, orientation: opencv,")
                .replace("944", "94").replace("1234", "123").replace("911", "91");
        Cell cell = CellReaderTest.read(text);
        assertTrue(cell.family().isHalfTurned());
        assertSame(cell, again(cell));
        assertFalse(CellReaderTest.read(text.replace(" orientation: opencv,", "")).family().isHalfTurned());
        assertThrows(InputRefusedException.class, () -> CellReaderTest.read(text.replace(": opencv", ": upright")));
    }

    @Test
    void whatIsLeftOutStaysOut() {
        Cell cell = CellReaderTest.read("cellgauge: 1\ncamera: c\nmarkers: {family: apriltag-36h11, size_mm: 40.5}\n"
                + "placement: {std_mm: [5, 5, 5], std_deg: 0.5}\nreferences: {0: {position_mm: [0, 0, 0]}}\n");
        Cell again = again(cell);
        assertSame(cell, again);
        assertEquals(OptionalDouble.empty(), again.pixelStdPx());
        assertEquals(OptionalDouble.empty(), again.targetStdMm());
        assertTrue(again.objects().isEmpty());
    }

    @ParameterizedTest
    @ValueSource(strings = {"[0, 0, 0]", "[30, -45, 60]", "[180, 0, 0]", "[0, 0, -179.5]", "[12.34, 56.78, -90.12]",
        "[0.1, 0.2, 0.3]", "[123.456789, -1e-3, 90]", "[-90, 0, 0]"})
    void anglesComeBackAsPeopleWroteThem(String rotation) {
        Cell cell = CellReaderTest.read(CellReaderTest.CELL.replace("rotation_deg: [0, 0, 0]}",
                "rotation_deg: " + rotation + "}"));
        assertSame(cell, again(cell));
        assertTrue(CellWriter.text(cell, Collections.emptyList())
                .contains("rotation_deg: " + rotation.replace("1e-3", "0.001") + "\n"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"[0, 90, 0]", "[10, -90, 20]", "[10, 100, 20]", "[270, 0, 359]"})
    void anglesOutsideTheirRangeGiveTheSameRotation(String rotation) {
        Cell cell = CellReaderTest.read(CellReaderTest.CELL.replace("rotation_deg: [0, 0, 0]}",
                "rotation_deg: " + rotation + "}"));
        RigidTransform expected = cell.references().get(0).worldFromMarker();
        RigidTransform actual = again(cell).references().get(0).worldFromMarker();
        // near theta = 90 degrees an angle is known to the root of the rounding
        double tolerance = rotation.contains("90,") ? 1e-7 : 1e-14;
        assertTrue(expected.angleRadTo(actual) < tolerance, expected + " became " + actual);
    }

    @Test
    void anyNumberComesBackWithAllItsDigits() {
        Random random = new Random(11);
        for (int n = 0; n < 200; n++) {
            double[] k = new double[BrownLens.PARAMETERS];
            k[PinholeCamera.FX] = 900 + 200 * random.nextDouble();
            k[PinholeCamera.FY] = 900 + 200 * random.nextDouble();
            k[PinholeCamera.CX] = 600 + random.nextDouble();
            k[PinholeCamera.CY] = 300 + random.nextDouble();
            k[PinholeCamera.SKEW] = 1e-9 * random.nextGaussian();
            k[BrownLens.K1] = 1e-2 * random.nextGaussian();
            k[BrownLens.P2] = 1e-4 * random.nextGaussian();
            double[] grip = {1e-7 * random.nextGaussian(), 123456.789 * random.nextDouble(), -random.nextDouble()};
            Cell cell = new Cell(PinholeCamera.of(1281, 719, k), MarkerFamily.SQUARE_BINARY,
                    Collections.singletonList(new Reference(7, 20 + random.nextDouble(),
                            RigidTransform.ofEuler(random.nextGaussian(), 1e5 * random.nextDouble(), -1e-4, 0, 0, 0),
                            new Placement(1e-5 * random.nextDouble(), random.nextDouble(), 1, random.nextDouble()))),
                    Collections.singletonList(new ObjectMarker(8, 3 + random.nextDouble(), grip)),
                    OptionalDouble.of(random.nextDouble()), OptionalDouble.of(1e-6 * random.nextDouble()));
            Cell again = again(cell);
            // the deviation of the rotation is in degrees there, so its last digit may move
            assertEquals(cell.references().get(0).placement().stdRad(),
                    again.references().get(0).placement().stdRad(), 4e-16);
            assertArrayEquals(cell.camera().intrinsics(), again.camera().intrinsics());
            assertArrayEquals(cell.references().get(0).worldFromMarker().translationMm(),
                    again.references().get(0).worldFromMarker().translationMm());
            for (int axis = 0; axis < 3; axis++) {
                assertEquals(cell.references().get(0).placement().stdMm(axis),
                        again.references().get(0).placement().stdMm(axis));
            }
            assertEquals(cell.references().get(0).sizeMm(), again.references().get(0).sizeMm());
            assertArrayEquals(grip, again.objects().get(0).gripMm());
            assertEquals(cell.pixelStdPx(), again.pixelStdPx());
            assertEquals(cell.targetStdMm(), again.targetStdMm());
        }
    }

    @Test
    void theLanguageOfTheMachineDoesNotMatter() {
        Cell cell = CellReaderTest.read(CellReaderTest.CELL);
        String expected = CellWriter.text(cell, Collections.emptyList());
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(new Locale("ar", "EG"));
            assertEquals(expected, CellWriter.text(cell, Collections.emptyList()));
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void remarksCannotBecomeKeys() {
        Cell cell = CellReaderTest.read(CellReaderTest.CELL);
        List<String> remarks = Arrays.asList("by cellgauge", "two\nlines: 1\r\u2028three: 2", "");
        String text = CellWriter.text(cell, remarks);
        assertTrue(text.startsWith("# by cellgauge\n# two lines: 1  three: 2\n# \ncellgauge: 1\n"), text);
        assertSame(cell, CellReader.read(text, "written", NO_OTHER_FILE));
    }

    @Test
    void camerasComeBackFromTheirOwnFile() {
        PinholeCamera plain = PinholeCamera.ideal(640, 480, 500.125, 501, 319.5, 240);
        assertEquals(plain.toString(), CameraReader.read(CameraWriter.text(plain), "written").toString());
        assertTrue(CameraWriter.text(plain).startsWith("model: pinhole\n"));
        PinholeCamera distorted = CameraReader.read(CellReaderTest.CAMERA, "original");
        assertEquals(distorted.toString(), CameraReader.read(CameraWriter.text(distorted), "written").toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"srgb", "linear", "gamma 2.2", "gamma 1.8765432109876543"})
    void toneCurvesComeBack(String words) {
        ToneCurve curve = ToneCurve.of(words);
        Cell cell = CellReaderTest.read(CellReaderTest.CELL);
        assertNull(again(cell).toneCurve());
        Cell again = again(cell.withToneCurve(curve));
        assertSame(cell, again);
        assertEquals(words, again.toneCurve().words());
        for (double light : new double[] {0.001, 0.2, 0.7}) {
            assertEquals(curve.grey(light), again.toneCurve().grey(light));
        }
        String camera = CameraWriter.text(cell.camera(), curve);
        assertEquals(words, CameraReader.file(camera, "camera.yaml", null).toneCurve().words());
        assertArrayEquals(cell.camera().intrinsics(), CameraReader.read(camera, "camera.yaml").intrinsics());
        assertNull(CameraReader.file(CameraWriter.text(cell.camera(), (ToneCurve) null), "camera.yaml", null)
                .toneCurve());
    }
}
