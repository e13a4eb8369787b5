package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

class SimulateCommandTest {
    private static final String CELL = "cellgauge: 1\n"
            + "camera: {model: pinhole, pinhole: {fx: 300, fy: 300, cx: 160, cy: 120, width: 320, height: 240}}\n"
            + "markers: {family: square-binary, size_mm: 47}\n"
            + "placement: {std_mm: [5, 5, 5], std_deg: 0.5}\n"
            + "pixel_std_px: 0.3\n"
            + "references:\n"
            + "  944: {position_mm: [200, 0, 0], rotation_deg: [0, 0, 0]}\n"
            + "  22:  {position_mm: [0, 0, 0], rotation_deg: [0, 0, 0]}\n"
            + "objects:\n"
            + "  5: {grip_mm: [10, 20, 100]}\n"
            + "  20: {}\n";

    @TempDir
    private Path folder;
    private Path cell;
    private String out;
    private String err;

    @BeforeEach
    void writeCell() throws IOException {
        cell = Files.writeString(folder.resolve("cell.yaml"), CELL);
    }

    private int run(String... args) {
        StringWriter outText = new StringWriter();
        StringWriter errText = new StringWriter();
        int code = new CommandLine(new SimulateCommand()).setOut(new PrintWriter(outText))
                .setErr(new PrintWriter(errText)).execute(args);
        out = outText.toString();
        err = errText.toString();
        return code;
    }

    private int simulate(Path target, String... more) {
        List<String> args = new ArrayList<>(List.of("--cell", cell.toString(), "--out", target.toString()));
        args.addAll(List.of(more));
        return run(args.toArray(new String[0]));
    }

    private static List<String> names(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(f -> f.getFileName().toString()).sorted().toList();
        }
    }

    private static double[] numbers(JsonArray array) {
        double[] values = new double[array.size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = array.get(i).getAsDouble();
        }
        return values;
    }

    @Test
    void truthTellsPosesGripAndCorners() throws IOException {
        Path target = folder.resolve("photos");
        assertEquals(0, simulate(target, "--name", "a", "--object", "5=100,50,30,0,0,90", "--camera-pose",
                "100,20,600,180,0,0"), err);
        assertEquals(List.of("a.png", "a.truth.json"), names(target));
        assertEquals(List.of(target.resolve("a.truth.json").toString(), target.resolve("a.png").toString()),
                out.lines().toList());
        assertTrue(err.contains("Object 20"), err);

        BufferedImage picture = ImageIO.read(target.resolve("a.png").toFile());
        assertEquals(320, picture.getWidth());
        assertEquals(240, picture.getHeight());
        assertEquals(BufferedImage.TYPE_BYTE_GRAY, picture.getType());

        JsonObject truth = JsonParser.parseString(Files.readString(target.resolve("a.truth.json"))).getAsJsonObject();
        assertEquals(1, truth.get("schema").getAsInt());
        assertEquals("a.png", truth.getAsJsonObject("image").get("name").getAsString());
        JsonObject cameraPose = truth.getAsJsonObject("camera").getAsJsonObject("pose");
        assertArrayEquals(new double[] {100, 20, 600}, numbers(cameraPose.getAsJsonArray("position_mm")), 1e-9);
        assertEquals(Math.PI, cameraPose.getAsJsonArray("euler_rad").get(0).getAsDouble(), 1e-12);
        JsonObject object = truth.getAsJsonObject("objects").getAsJsonObject("5");
        // turned by 90 degrees about z: x goes to y and y to -x
        assertArrayEquals(new double[] {80, 60, 130}, numbers(object.getAsJsonArray("grip_in_world_mm")), 1e-9);
        // camera from above: u = cx + f (x - 100) / depth, v = cy - f (y - 20) / depth; the top-left corner of the
        // object, turned, stands at (100 - 23.5, 50 - 23.5, 30)
        double depth = 570;
        assertArrayEquals(new double[] {160 - 300 * 23.5 / depth, 120 - 300 * 6.5 / depth},
                numbers(object.getAsJsonArray("corners_px").get(0).getAsJsonArray()), 1e-9);
        assertEquals(3, truth.getAsJsonArray("markers").size());
    }

    @Test
    void drawnPlacementsStandInTheTruthAndInTheCorners() throws IOException {
        Path target = folder.resolve("photos");
        assertEquals(0, simulate(target, "--placement-errors", "draw", "--count", "2", "--camera-pose",
                "100,20,600,180,0,0"), err);
        assertEquals(List.of("photo-1.png", "photo-1.truth.json", "photo-2.png", "photo-2.truth.json"), names(target));
        PinholeCamera camera = PinholeCamera.ideal(320, 240, 300, 300, 160, 120);
        RigidTransform cameraFromWorld = RigidTransform.ofEuler(100, 20, 600, Math.PI, 0, 0).inverse();
        double[] before = null;
        for (String name : List.of("photo-1.truth.json", "photo-2.truth.json")) {
            JsonObject reference = JsonParser.parseString(Files.readString(target.resolve(name))).getAsJsonObject()
                    .getAsJsonObject("references").getAsJsonObject("944");
            double[] nominal = numbers(reference.getAsJsonObject("nominal").getAsJsonArray("position_mm"));
            double[] actual = numbers(reference.getAsJsonObject("actual").getAsJsonArray("position_mm"));
            double[] euler = numbers(reference.getAsJsonObject("actual").getAsJsonArray("euler_rad"));
            assertArrayEquals(new double[] {200, 0, 0}, nominal);
            assertFalse(Arrays.equals(nominal, actual));
            assertFalse(Arrays.equals(before, actual));
            before = actual;
            double[] corners = MarkerGeometry.cornersMm(cameraFromWorld.compose(RigidTransform.ofEuler(actual[0],
                    actual[1], actual[2], euler[0], euler[1], euler[2])), 47);
            assertArrayEquals(camera.project(corners[6], corners[7], corners[8]),
                    numbers(reference.getAsJsonArray("corners_px").get(2).getAsJsonArray()), 1e-6);
        }
    }

    @Test
    void sameSeedGivesTheSameBytes() throws IOException {
        Path one = folder.resolve("one");
        Path two = folder.resolve("two");
        Path three = folder.resolve("three");
        simulate(one, "--seed", "7", "--camera-jitter", "3,0.5");
        simulate(two, "--seed", "7", "--camera-jitter", "3,0.5");
        simulate(three, "--seed", "8", "--camera-jitter", "3,0.5");
        byte[] first = Files.readAllBytes(one.resolve("photo.png"));
        assertArrayEquals(first, Files.readAllBytes(two.resolve("photo.png")));
        assertFalse(Arrays.equals(first, Files.readAllBytes(three.resolve("photo.png"))));
    }

    @ParameterizedTest
    @ValueSource(strings = {"--noise=-1", "--noise=x", "--blur-px=-0.1", "--gamma=0", "--count=0", "--texture=0.9",
        "--placement-errors=some", "--object=77=1,2,3", "--object=5=1,2", "--object=x=1,2,3", "--object=5",
        "--camera-pose=1,2", "--camera-jitter=1", "--camera-jitter=-1,0", "--name=../a", "--name=", "--unknown",
        "--vignetting=2", "--gradient=2", "--quiet-zone=-1", "--shot-noise=-1", "--seed=1.5", "--tone-curve=bright",
        "--tone-curve=gamma 9", "--exposure=0", "--unsharp=1", "--unsharp=-1,1", "--unsharp=1,0", "--jpeg=0",
        "--jpeg=101", "--print-gain=3", "--print-gain=NaN", "--black-level=200", "--clip=300", "--ink=2",
        "--mirrored=7", "--inverted=some", "--turned=22", "--turned=22=x", "--exchanged=22", "--exchanged=all"})
    void badOptionIsAUsageErrorAndWritesNothing(String option) {
        Path target = folder.resolve("photos");
        assertEquals(2, simulate(target, option));
        assertFalse(err.isBlank());
        assertFalse(Files.exists(target));
    }

    /**
     * Grey values of the first photo, which has no noise and no blur, tell the print: marker 22 has its only black
     * corner of the code at the lower left, a cell and a half from the middle both ways, and paper all around.
     */
    @Test
    void printsAreWrongAsAskedFor() throws IOException {
        String[] plain = {"--noise=0", "--blur-px=0", "--vignetting=0", "--gradient=0",
            "--camera-pose=0,0,200,180,0,0"};
        // of light 0.05 and 0.85; image x is along world x, image y against world y
        int black = 13;
        int white = 217;
        assertArrayEquals(new int[] {white, black, white, white}, codeCornersOfMarker22(plain));
        assertArrayEquals(new int[] {white, white, black, white}, codeCornersOfMarker22(plain, "--mirrored=all"));
        assertArrayEquals(new int[] {black, white, black, black}, codeCornersOfMarker22(plain, "--inverted=22,944"));
        assertArrayEquals(new int[] {black, white, white, white}, codeCornersOfMarker22(plain, "--turned=22=1"));
        assertArrayEquals(new int[] {white, white, white, black}, codeCornersOfMarker22(plain, "--turned=all=2"));
        assertArrayEquals(new int[] {white, 102, white, white}, codeCornersOfMarker22(plain, "--ink=0.4"));
        assertArrayEquals(new int[] {200, 33, 200, 200}, codeCornersOfMarker22(plain, "--black-level=20",
                "--clip=200"));
    }

    /** Top left, bottom left, bottom right, top right. */
    private int[] codeCornersOfMarker22(String[] plain, String... more) throws IOException {
        Path target = Files.createTempDirectory(folder, "prints");
        List<String> options = new ArrayList<>(List.of(plain));
        options.addAll(List.of(more));
        assertEquals(0, simulate(target, options.toArray(new String[0])), err);
        BufferedImage image = ImageIO.read(target.resolve("photo.png").toFile());
        // 47 mm at 200 mm and 300 px are 70.5 px, a cell 8.8 px
        int off = (int) Math.round(1.5 * 47 / 8 * 300 / 200);
        int[] greys = new int[4];
        for (int i = 0; i < 4; i++) {
            int column = 160 + (i < 2 ? -off : off);
            int row = 120 + (i == 0 || i == 3 ? -off : off);
            greys[i] = image.getRaster().getSample(column, row, 0);
        }
        return greys;
    }

    @Test
    void exchangedMarkersStandInEachOthersPlaces() throws IOException {
        Path target = folder.resolve("photos");
        assertEquals(0, simulate(target, "--exchanged", "22,944"));
        JsonObject references = JsonParser.parseString(Files.readString(target.resolve("photo.truth.json")))
                .getAsJsonObject().getAsJsonObject("references");
        assertEquals("[200.0,0.0,0.0]", references.getAsJsonObject("22").getAsJsonObject("actual").get("position_mm")
                .toString());
        assertEquals("[0.0,0.0,0.0]", references.getAsJsonObject("22").getAsJsonObject("nominal").get("position_mm")
                .toString());
    }

    @Test
    void objectGivenTwiceIsAUsageError() {
        assertEquals(2, simulate(folder.resolve("photos"), "--object", "5=1,2,3", "--object", "5=1,2,3"));
        assertTrue(err.contains("twice"), err);
    }

    @Test
    void missingCellFileIsRefused() {
        Path target = folder.resolve("photos");
        assertEquals(3, run("--cell", folder.resolve("none.yaml").toString(), "--out", target.toString()));
        assertTrue(err.contains("none.yaml"), err);
        assertFalse(Files.exists(target));
    }

    @Test
    void folderThatCannotBeMadeIsRefusedBeforeAnythingIsRendered() throws IOException {
        Path file = Files.createFile(folder.resolve("file"));
        assertEquals(3, simulate(file.resolve("photos"), "--count", "100000"));
        assertEquals(file + ": this is a file, not a folder; name a folder with --out", err.trim());
    }

    @Test
    void markerOutsideTheImageIsSaid() {
        assertEquals(0, simulate(folder.resolve("photos"), "--camera-pose", "0,0,600,180,0,0", "--object",
                "5=1000,0,0"));
        assertTrue(err.contains("marker 5 is not wholly inside"), err);
    }

    @Test
    void gammaIsShortForToneCurve() throws IOException {
        assertEquals(2, simulate(folder.resolve("both"), "--gamma", "2.2", "--tone-curve", "srgb"));
        assertTrue(err.contains("--gamma is short for --tone-curve"), err);
        assertEquals(0, simulate(folder.resolve("one"), "--gamma", "2.2"), err);
        assertEquals(0, simulate(folder.resolve("two"), "--tone-curve", "gamma 2.2"), err);
        assertArrayEquals(Files.readAllBytes(folder.resolve("one/photo.png")),
                Files.readAllBytes(folder.resolve("two/photo.png")));
    }

    private String png(String name, String... more) throws IOException {
        assertEquals(0, simulate(folder.resolve(name), more), err);
        return Files.readString(folder.resolve(name).resolve("photo.png"), StandardCharsets.ISO_8859_1);
    }

    /** Chunks of ISO/IEC 15948: sRGB with an intent, gAMA with 100000 / gamma as four bytes. */
    @Test
    void pngSaysWhichToneCurveItHas() throws IOException {
        String linear = png("linear");
        assertFalse(linear.contains("sRGB") || linear.contains("gAMA"));
        assertTrue(png("srgb", "--tone-curve", "srgb").contains("sRGB"));
        String gamma = png("gamma", "--gamma", "2.2");
        int at = gamma.indexOf("gAMA") + 4;
        assertTrue(at > 4);
        assertEquals(Math.round(1e5 / 2.2), (gamma.charAt(at) << 24) + (gamma.charAt(at + 1) << 16)
                + (gamma.charAt(at + 2) << 8) + gamma.charAt(at + 3));
        String bare = png("bare", "--tone-curve", "srgb", "--no-profile");
        assertFalse(bare.contains("sRGB") || bare.contains("gAMA"));
    }

    @Test
    void jpegIsGreyAndStandsInTheTruth() throws IOException {
        Path target = folder.resolve("photos");
        assertEquals(0, simulate(target, "--jpeg", "85", "--tone-curve", "srgb", "--exposure", "1.95", "--unsharp",
                "0.6,1.2", "--print-gain", "0.2"), err);
        assertEquals(List.of("photo.jpg", "photo.truth.json"), names(target));
        BufferedImage picture = ImageIO.read(target.resolve("photo.jpg").toFile());
        assertEquals(1, picture.getRaster().getNumBands());
        JsonObject truth = JsonParser.parseString(Files.readString(target.resolve("photo.truth.json")))
                .getAsJsonObject();
        assertEquals("photo.jpg", truth.getAsJsonObject("image").get("name").getAsString());
        JsonObject settings = truth.getAsJsonObject("settings");
        assertEquals("srgb", settings.get("tone_curve").getAsString());
        assertEquals(1.95, settings.get("exposure").getAsDouble());
        assertEquals(0.6, settings.get("unsharp_amount").getAsDouble());
        assertEquals(1.2, settings.get("unsharp_radius_px").getAsDouble());
        assertEquals(85, settings.get("jpeg_quality").getAsInt());
        assertEquals(0.2, settings.get("print_gain_mm").getAsDouble());
    }

    /** What was not asked for does not stand in the truth, as before it could be asked for. */
    @Test
    void truthOfAnOldCallIsWhatItWas() throws IOException {
        Path target = folder.resolve("photos");
        assertEquals(0, simulate(target), err);
        JsonObject settings = JsonParser.parseString(Files.readString(target.resolve("photo.truth.json")))
                .getAsJsonObject().getAsJsonObject("settings");
        assertEquals(Set.of("placement_errors", "camera_jitter_mm_deg", "blur_px", "noise_grey",
                "full_well_electrons", "gamma", "vignetting", "gradient", "texture_contrast", "quiet_zone"),
                settings.keySet());
        assertEquals(1, settings.get("gamma").getAsDouble());
    }
}
