package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.desktop.render.CellSimulation;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine.Help.Ansi;

/** What somebody meets who has just got the program. */
class FirstHourTest {
    @TempDir
    private Path folder;

    @Test
    void withoutACommandThereIsHelp() {
        CommandCall bare = CommandCall.of();
        assertEquals(2, bare.code());
        CommandCall help = CommandCall.of("help");
        assertEquals(0, help.code());
        for (String text : List.of(bare.err(), help.out())) {
            for (String command : List.of("check", "simulate", "validate", "reproduce", "families")) {
                assertTrue(text.lines().anyMatch(line -> line.matches(" +" + command + " .*")), text);
            }
        }
        assertEquals(CommandCall.of("check", "--help").out(), CommandCall.of("help", "check").out());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "chek            | Did you mean: cellgauge check",
        "simulat         | Did you mean: cellgauge simulate",
        "check --cel x   | Possible solutions: --cell",
        "simulate --sed 1 | Possible solutions: --seed"})
    void mistypedWordsGetTheNearestOne(String args, String suggestion) {
        CommandCall call = CommandCall.of(args.trim().split(" +"));
        assertEquals(2, call.code());
        assertTrue(call.err().contains(suggestion), call.err());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "check", "simulate", "validate", "reproduce", "families"})
    void helpFitsAndHasExamplesFirst(String command) {
        for (int width : new int[] {60, 80}) {
            assertEquals(width, Main.helpWidth(String.valueOf(width)));
            picocli.CommandLine line = Main.commandLine();
            line = command.isEmpty() ? line : line.getSubcommands().get(command);
            line.setUsageHelpWidth(width);
            String help = line.getUsageMessage(Ansi.OFF);
            help.lines().forEach(l -> assertTrue(l.length() <= width, l.length() + " of " + width + ": " + l));
            // a line that ends in the middle of an example's word cannot be copied
            help.lines().filter(l -> l.startsWith("  cellgauge ")).forEach(l -> assertTrue(
                    l.endsWith("\\") || l.length() < width - 1, l));
            int example = help.indexOf("\n  cellgauge ");
            assertTrue(example > 0, help);
            assertTrue(command.isEmpty() || example < help.indexOf("Usage:"), help);
            assertFalse(help.contains("%%"), help);
        }
        assertEquals(60, Main.helpWidth("20"));
        assertEquals(80, Main.helpWidth("200"));
        assertEquals(80, Main.helpWidth(null));
    }

    @Test
    void helpOffersOnlyWhatWorks() {
        String help = CommandCall.of("check", "--help").out();
        assertTrue(help.contains("--estimate=none|focal|intrinsics"), help);
    }

    @Test
    void noColourForADumbTerminalAndWhereNoneIsWanted() {
        assertEquals(Ansi.OFF, Main.ansi(Map.of("TERM", "dumb")));
        assertEquals(Ansi.OFF, Main.ansi(Map.of("TERM", "xterm", "NO_COLOR", "")));
        assertEquals(Ansi.AUTO, Main.ansi(Map.of("TERM", "xterm-256color")));
    }

    @Test
    void familiesAreThoseThatACellMayName() {
        CommandCall call = CommandCall.of("families");
        assertEquals(0, call.code());
        List<String> lines = call.out().lines().toList();
        for (MarkerFamily family : MarkerFamily.all()) {
            assertTrue(lines.stream().anyMatch(l -> l.startsWith(family + " ")), family + "\n" + call.out());
        }
        // BoofCV's table of AprilTag 36h11 has 587 markers
        assertTrue(lines.stream().anyMatch(l -> l.matches("apriltag-36h11 +0 to 586 *")), call.out());
    }

    private static CommandCall with(byte[] standardInput, String... args) {
        InputStream usual = System.in;
        System.setIn(new ByteArrayInputStream(standardInput));
        try {
            return CommandCall.of(args);
        } finally {
            System.setIn(usual);
        }
    }

    /** A cell, corners or a photo from standard input give what the file gives. */
    @Test
    void aHyphenIsStandardInput() throws IOException {
        String cell = SmallCell.write(folder).toString();
        Path corners = SmallCell.writeDetections(folder.resolve("corners.json"), 3);
        JsonObject file = result(CommandCall.of("check", "--cell", cell, "--iterations", "60", "--json",
                "--detections", corners.toString()));
        JsonObject piped = result(with(Files.readAllBytes(corners), "check", "--cell", cell, "--iterations", "60",
                "--json", "--detections", "-"));
        assertEquals(file.get("camera"), piped.get("camera"));
        assertEquals("cellgauge check --cell " + cell + " --iterations 60 --detections -",
                piped.get("command").getAsString());
        String inline = SmallCell.YAML.replace("camera: camera.yaml", "camera: {model: pinhole, "
                + SmallCell.CAMERA_YAML.lines().skip(1).findFirst().orElseThrow() + "}");
        JsonObject cellPiped = result(with(inline.getBytes(StandardCharsets.UTF_8), "check", "--cell", "-",
                "--iterations", "60", "--json", "--detections", corners.toString()));
        assertEquals(file.get("camera"), cellPiped.get("camera"));
        CommandCall twice = with(new byte[0], "check", "--cell", "-", "-");
        assertEquals(2, twice.code());
        assertTrue(twice.err().contains("standard input, which can be read once only"), twice.err());
        // no image, but read: the reason is that of a file
        CommandCall noPhoto = with(new byte[] {1, 2, 3}, "check", "--cell", cell, "--json", "-");
        assertEquals(3, noPhoto.code(), noPhoto.err());
    }

    private static JsonObject result(CommandCall call) {
        assertTrue(List.of(0, 4, 5).contains(call.code()), call.err());
        return JsonParser.parseString(call.out()).getAsJsonObject();
    }

    /** The point is in the middle of the image, what lies above it above, and the camera where it was asked to be. */
    @ParameterizedTest
    @CsvSource({"250,190,0, 250,-400,900", "250,190,0, 900,700,300", "0,0,0, 0,0,900", "10,20,30, 10.5,20,800"})
    void theCameraLooksAtThePoint(double x, double y, double z, double fromX, double fromY, double fromZ) {
        double[] target = {x, y, z};
        RigidTransform camera = CellSimulation.lookingAt(new double[] {fromX, fromY, fromZ}, target);
        double[] seen = pixel(camera, x, y, z);
        assertEquals(320, seen[0], 1e-9);
        assertEquals(240, seen[1], 1e-9);
        boolean straight = Math.hypot(fromX - x, fromY - y) < 1;
        double[] above = straight ? pixel(camera, x, y + 10, z) : pixel(camera, x, y, z + 10);
        assertTrue(above[1] < 239, above[1] + "");
        assertEquals(320, above[0], straight ? 0.1 : 1e-6);
        assertEquals(fromZ, camera.translationMm()[2]);
        if (x == fromX && y == fromY) {
            // as the camera stands that looks at the whole cell
            assertEquals(0, camera.angleRadTo(RigidTransform.ofEuler(fromX, fromY, fromZ, Math.PI, 0, 0)), 1e-12);
        }
    }

    private static double[] pixel(RigidTransform worldFromCamera, double x, double y, double z) {
        RigidTransform point = worldFromCamera.inverse()
                .compose(RigidTransform.ofEuler(x, y, z, 0, 0, 0));
        double[] p = point.translationMm();
        return PinholeCamera.ideal(640, 480, 600, 600, 320, 240).project(p[0], p[1], p[2]);
    }

    @Test
    void simulateLooksAtAPointAndTellsHowFarItIs() throws IOException {
        Path cell = SmallCell.write(folder);
        CommandCall call = CommandCall.of("simulate", "--cell", cell.toString(), "--out", folder.toString(), "--count",
                "2", "--look-at", "200,150,0", "--distance", "900");
        assertEquals(0, call.code(), call.err());
        assertTrue(call.err().contains("[1/2] photo-1.png") && call.err().contains("[2/2] photo-2.png"), call.err());
        JsonObject truth = JsonParser.parseString(Files.readString(folder.resolve("photo-1.truth.json")))
                .getAsJsonObject();
        assertTrue(truth.get("command").toString().contains("\"--look-at\",\"200,150,0\""), truth.toString());
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--look-at 0,0,0                             | say from where, with either --camera-position X,Y,Z or",
        "--look-at 0,0,0 --distance -5               | --distance: must be positive, not -5",
        "--look-at 0,0 --distance 900                | --look-at: '0,0' is not X,Y,Z in mm",
        "--distance 900                              | --distance needs the point to look at",
        "--look-at 0,0,0 --camera-position 0,0,0     | --look-at: the camera stands in the point itself",
        "--look-at 0,0,0 --distance 9 --camera-pose 0,0,900,180,0,0 | leave out one of them"})
    void viewpointsThatMakeNoSenseAreUsageErrors(String args, String message) throws IOException {
        String[] words = ("simulate --cell " + SmallCell.write(folder) + " --out " + folder + " " + args.trim())
                .split(" +");
        CommandCall call = CommandCall.of(words);
        assertEquals(2, call.code(), call.err());
        assertTrue(call.err().contains(message), call.err());
    }

    /** Folders like C:/Program Files (x86) and {@code R&D}: what is put in for a path stands between quotes. */
    @Test
    void windowsPathsStandBetweenQuotes() throws IOException {
        Pattern path = Pattern.compile("%(~dp0|lib|java|JAVA_HOME)\\b");
        int found = 0;
        for (String line : Files.readAllLines(Path.of(System.getProperty("cellgauge.root", "."),
                "desktop-cli/src/dist/bin/cellgauge.bat"))) {
            // a replacement within a variable has a quote of its own
            String whole = line.replace(":\"=%", "%");
            Matcher matcher = path.matcher(whole);
            while (!line.startsWith("rem") && matcher.find()) {
                found++;
                assertEquals(1, whole.substring(0, matcher.start()).chars().filter(c -> c == '"').count() % 2, line);
            }
        }
        assertEquals(9, found);
    }

    /** cmd.exe takes a script with bare line feeds apart in the wrong places. */
    @Test
    void windowsHasAStartScriptOfItsOwn() throws IOException {
        String script = Files.readString(Path.of(System.getProperty("cellgauge.root", "."),
                "desktop-cli/src/dist/bin/cellgauge.bat"));
        assertTrue(script.contains("org.cellgauge.cli.Main %*"), script);
        assertEquals(script.lines().count(), script.split("\r\n", -1).length - 1L);
    }
}
