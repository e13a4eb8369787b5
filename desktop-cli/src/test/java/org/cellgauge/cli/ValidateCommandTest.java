package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.cellgauge.internal.statistics.BinomialBand;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ValidateCommandTest {
    /** Short chains: whether they converge is no matter where only the form of the output is looked at. */
    private static final String[] QUICK = {"--simulations", "4", "--iterations", "700"};

    @TempDir
    private Path folder;
    private Path cell;

    @BeforeEach
    void writeCell() throws IOException {
        cell = SmallCell.write(folder);
    }

    private CommandCall validate(String... args) {
        List<String> all = new ArrayList<>(List.of("validate", "--cell", cell.toString()));
        all.addAll(List.of(args));
        return CommandCall.of(all.toArray(new String[0]));
    }

    private CommandCall quick(String... args) {
        List<String> all = new ArrayList<>(List.of(QUICK));
        all.addAll(List.of(args));
        return validate(all.toArray(new String[0]));
    }

    private static JsonObject json(CommandCall call) {
        return JsonParser.parseString(call.out()).getAsJsonObject();
    }

    // ---- is it right

    /**
     * One call that is long enough to mean something; false alarm of the bands 1 %, of the ranks 1 %, at a fixed seed.
     */
    @Test
    void anHonestLikelihoodCoversAndEndsWithZero() {
        CommandCall call = validate("--simulations", "120", "--json");
        assertEquals(0, call.code(), call.out() + call.err());
        JsonObject result = json(call);
        assertTrue(result.get("covers_95").getAsBoolean());
        assertTrue(result.get("rank_p_value").getAsDouble() > 0.01);
        assertEquals(120, result.getAsJsonObject("settings").get("simulations").getAsInt());
        assertEquals(0.1, result.getAsJsonObject("settings").get("target_mcse_std_rel").getAsDouble());
        int missing = result.get("not_converged").getAsInt() + result.get("refused").getAsInt();
        assertTrue(missing <= 6, missing + " without a figure");
        // one in a hundred is the promise; more than 7 of 120 would come at that rate once in ten thousand
        assertTrue(result.get("false_alarms").getAsInt() <= 7);
        // at 2 and 1 in a thousand, more than 3 and 2 of 120 come once in seven thousand and in three thousand
        assertTrue(result.get("noise_misfits").getAsInt() <= 3);
        assertTrue(result.get("reference_misfits").getAsInt() <= 2);

        Set<String> regions = new HashSet<>();
        for (JsonElement e : result.getAsJsonArray("regions")) {
            JsonObject region = e.getAsJsonObject();
            String name = region.get("name").getAsString();
            regions.add(name);
            assertEquals(name.endsWith("pose") ? 6 : 3, region.get("dimension").getAsInt(), name);
            assertEquals(120 - missing, region.get("trials").getAsInt());
            List<Double> levels = new ArrayList<>();
            int before = -1;
            for (JsonElement l : region.getAsJsonArray("levels")) {
                JsonObject level = l.getAsJsonObject();
                double probability = level.get("probability").getAsDouble();
                levels.add(probability);
                int hits = level.get("hits").getAsInt();
                assertTrue(hits >= before, "a larger region holds what a smaller one does");
                before = hits;
                // six regions share the 1 % of a level
                BinomialBand band = BinomialBand.of(120 - missing, probability, 1 - 0.01 / 6);
                assertEquals(band.lower(), level.get("band_lower").getAsInt());
                assertEquals(band.upper(), level.get("band_upper").getAsInt());
                assertEquals(band.contains(hits), level.get("covers").getAsBoolean());
                assertEquals(band.contains(level.get("gaussian_hits").getAsInt()),
                        level.get("gaussian_covers").getAsBoolean());
            }
            assertEquals(List.of(0.5, 0.8, 0.95), levels);
        }
        assertEquals(Set.of("camera pose", "object 5 position", "object 5 pose", "object 20 position", "object 20 pose",
                "object 20 grip"), regions);

        Map<String, Set<String>> quantities = new HashMap<>();
        for (JsonElement e : result.getAsJsonArray("ranks")) {
            JsonObject quantity = e.getAsJsonObject();
            quantities.computeIfAbsent(quantity.get("part").getAsString(), k -> new HashSet<>())
                    .add(quantity.get("name").getAsString());
            int sum = 0;
            for (JsonElement count : quantity.getAsJsonArray("rank_counts")) {
                sum += count.getAsInt();
            }
            assertEquals(120 - missing, sum);
            double p = quantity.get("p_value").getAsDouble();
            assertTrue(p > 0 && p <= 1);
        }
        assertEquals(Set.of("x_mm", "y_mm", "z_mm", "wx_rad", "wy_rad", "wz_rad", "log_density", "norm"),
                quantities.get("camera"));
        assertEquals(Set.of("x_mm", "y_mm", "z_mm", "wx_rad", "wy_rad", "wz_rad", "distance_mm", "norm"),
                quantities.get("object 5"));
        assertEquals(Set.of("x_mm", "y_mm", "z_mm", "wx_rad", "wy_rad", "wz_rad", "distance_mm", "norm", "grip_x_mm",
                "grip_y_mm", "grip_z_mm", "grip_norm"), quantities.get("object 20"));
    }

    @Test
    void aLikelihoodThatClaimsTooMuchEndsWithFour() {
        CommandCall call = validate("--simulations", "25", "--model", "corner-cube");
        assertEquals(4, call.code(), call.out() + call.err());
        assertTrue(call.out().contains("corner-cube with kappa 0.5"), call.out());
        assertTrue(call.out().contains("TOO RARE"), call.out());
        assertFalse(call.out().contains("misplaced"), "this likelihood knows no placement to test");
        assertTrue(call.out().endsWith("A stated 95 % is not right 95 times in 100 here.\n"), call.out());
    }

    @Test
    void chainsThatDoNotConvergeEndWithFive() {
        CommandCall call = validate("--simulations", "3", "--iterations", "20", "--warmup", "10");
        assertEquals(5, call.code(), call.out() + call.err());
        assertTrue(call.out().contains("3 not converged"), call.out());
        assertTrue(call.out().contains("No check stated a figure: there is nothing to count."), call.out());
        JsonObject result = json(validate("--simulations", "3", "--iterations", "20", "--warmup", "10", "--json"));
        assertEquals(3, result.get("not_converged").getAsInt());
        assertFalse(result.get("covers_95").getAsBoolean());
        assertTrue(result.get("rank_p_value").isJsonNull());
    }

    // ---- the tables

    @Test
    void tablesHoldRegionsErrorsAndRanksOfEveryPart() {
        CommandCall call = quick();
        String out = call.out();
        assertTrue(out.startsWith("4 simulated cells, rigid-marker, seed 1; true poses spread by 50 mm and 10 "
                + "degrees."), out);
        assertTrue(out.replaceAll("\\s+", " ").matches(".* \\d ambiguous; in \\d a reference was called misplaced "
                + "although none was, in \\d corners do not fit the stated noise, in \\d the references together do "
                + "not fit\\. .*"), out);
        for (String region : List.of("camera pose", "object 5 position", "object 5 pose", "object 20 position",
                "object 20 pose", "object 20 grip")) {
            assertTrue(out.lines().anyMatch(l -> l.matches("  " + region + " +[36] .* - .*")), region + "\n" + out);
        }
        assertTrue(out.contains("Errors in stated standard deviations"), out);
        assertTrue(out.contains("Ranks of the truth among 99 draws"), out);
        assertTrue(out.lines().anyMatch(l -> l.matches("  camera( +\\d\\.\\d{3}){8} *")), out);
        assertTrue(out.lines().anyMatch(l -> l.matches("  object 5( +\\d\\.\\d{3}){8} *")), out);
        assertTrue(out.lines().anyMatch(l -> l.matches("  object 20( +\\d\\.\\d{3}){12} *")), out);
        assertTrue(out.replaceAll("\\s+", " ").contains("All together: p ="), out);
        // a count of 4 proves nothing, and says so: all four regions may hold the truth, or three or two
        assertTrue(out.endsWith("A stated 95 % is right 95 times in 100 here, within chance. So few simulated cells "
                + "would not tell it\nfrom 50 times in 100: give more --simulations.\n"), out);
    }

    @Test
    void unknownFocalLengthsAreJudgedToo() {
        CommandCall call = quick("--estimate", "focal", "--focal-prior-std", "20");
        assertTrue(call.out().contains("true focal\nlengths by what is known of them"), call.out());
        assertTrue(call.out().lines().anyMatch(l -> l.matches("  camera focal lengths +2 .* - .*")), call.out());
        assertTrue(call.out().lines().anyMatch(l -> l.matches("  focal lengths: fx_px \\S+, mean \\S+; fy_px \\S+, "
                + "mean \\S+")), call.out());
        JsonObject settings = json(quick("--json", "--estimate", "focal", "--focal-prior-std", "20",
                "--aspect-prior-std", "independent")).getAsJsonObject("settings");
        assertEquals("focal", settings.get("estimate").getAsString());
        assertEquals(20, settings.get("focal_prior_std_px").getAsDouble(), 0);
        assertTrue(settings.get("aspect_prior_std").isJsonNull());
    }

    @Test
    void textAndJsonTellTheSameCounts() {
        String text = quick().out();
        JsonObject camera = json(quick("--json")).getAsJsonArray("regions").get(0).getAsJsonObject();
        StringBuilder row = new StringBuilder("  camera pose +6");
        for (JsonElement level : camera.getAsJsonArray("levels")) {
            row.append(" +").append(String.format(Locale.ROOT, "%.1f",
                    100.0 * level.getAsJsonObject().get("hits").getAsInt() / camera.get("trials").getAsInt()));
        }
        assertTrue(text.lines().anyMatch(l -> l.matches(row + " .*")), row + "\n" + text);
    }

    @Test
    void outputIsPlainTextThatFitsATerminal() {
        CommandCall call = quick();
        for (String text : List.of(call.out(), call.err())) {
            // no colour, no cursor moves, no carriage return
            assertTrue(text.chars().allMatch(c -> c == '\n' || c >= ' ' && c < 0x7F), text);
        }
        call.out().lines().forEach(l -> assertTrue(l.length() <= 120, l.length() + ": " + l));
    }

    @Test
    void progressGoesToStandardErrorALineAtATime() {
        CommandCall call = validate("--simulations", "25", "--iterations", "60", "--warmup", "10", "--json");
        List<String> lines = call.err().lines().toList();
        assertEquals("[25/25] cells simulated and checked", lines.get(lines.size() - 1));
        assertTrue(lines.size() >= 10 && lines.size() <= 13, lines.toString());
        assertTrue(call.out().startsWith("{") && call.out().endsWith("}\n"), call.out());
        assertEquals(1, json(call).get("schema").getAsInt());
    }

    @Test
    void nothingIsWritten() throws IOException {
        Set<Path> before;
        try (Stream<Path> files = Files.list(folder)) {
            before = new HashSet<>(files.toList());
        }
        quick();
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(before, new HashSet<>(files.toList()));
        }
    }

    @Test
    void helpShowsExamplesAndExitCodes() {
        // what the library that formats it complains about goes to the process' own standard error
        PrintStream standard = System.err;
        ByteArrayOutputStream complaints = new ByteArrayOutputStream();
        System.setErr(new PrintStream(complaints, true));
        CommandCall call;
        try {
            call = CommandCall.of("validate", "--help");
        } finally {
            System.setErr(standard);
        }
        assertEquals("", complaints.toString());
        assertEquals(0, call.code());
        assertFalse(call.out().contains("%%"), call.out());
        assertTrue(call.out().contains("cellgauge validate --cell cell.yaml"), call.out());
        assertTrue(call.out().contains("Exit codes: 0 all 95 % regions hold the truth as often as they claim"),
                call.out());
        assertTrue(CommandCall.of("--help").out().contains("validate"));
    }

    // ---- reproducibility

    @Test
    void theSameSeedGivesTheSameFiguresForAnyNumberOfThreads() {
        CommandCall one = quick("--threads", "1", "--seed", "3", "--json");
        CommandCall three = quick("--threads", "3", "--seed", "3", "--json");
        assertEquals(one.out(), three.out());
        assertEquals(one.code(), three.code());
        assertNotEquals(one.out(), quick("--threads", "3", "--seed", "4", "--json").out());
    }

    // ---- what is simulated

    @Test
    void posesAndNoiseAreThoseAskedFor() {
        JsonObject settings = json(quick("--json", "--camera-pose", SmallCell.CAMERA_POSE, "--object",
                "5=290,150,0,22.9,0,17.2", "--spread", "5,1", "--pixel-std", "0.1")).getAsJsonObject("settings");
        assertEquals(0.1, settings.get("simulated_pixel_std_px").getAsDouble());
        assertEquals(5, settings.get("spread_mm").getAsDouble());
        assertEquals(Math.toRadians(1), settings.get("spread_rad").getAsDouble(), 1e-15);
        double[] camera = {200, 150, 900, 3.1, 0.05, 0.02};
        double[] object = {290, 150, 0, Math.toRadians(22.9), 0, Math.toRadians(17.2)};
        for (int i = 0; i < 6; i++) {
            assertEquals(camera[i], settings.getAsJsonArray("camera_pose").get(i).getAsDouble(), 1e-9);
            assertEquals(object[i], settings.getAsJsonObject("object_poses").getAsJsonArray("5").get(i).getAsDouble(),
                    1e-9);
        }
        assertTrue(settings.getAsJsonObject("object_poses").has("20"));
    }

    /** A value that begins with a minus is no option. */
    @ParameterizedTest
    @ValueSource(strings = {"--camera-pose -3,150,950,3.14rad,0,0", "--camera-pose=-3,150,950,3.14rad,0,0"})
    void aCameraMayStandLeftOfTheOrigin(String args) throws IOException {
        Files.writeString(cell, SmallCell.YAML.replace("[400, ", "[300, "));
        List<String> all = new ArrayList<>(List.of("--json", "--spread", "0,0"));
        all.addAll(List.of(args.split(" ")));
        CommandCall call = quick(all.toArray(new String[0]));
        assertEquals("", call.err().replaceAll("\\[.*\\n", ""));
        assertEquals(-3, json(call).getAsJsonObject("settings").getAsJsonArray("camera_pose").get(0).getAsDouble(),
                1e-9);
    }

    @Test
    void withoutSpreadTheTruthIsTheSameInAll() {
        CommandCall call = quick("--spread", "0,0");
        assertTrue(call.out().startsWith("4 simulated cells, rigid-marker, seed 1; the same true poses in all."),
                call.out());
        assertTrue(call.out().contains("At fixed true poses uniform ranks are an approximation"), call.out());
    }

    /** A spread far narrower than the posterior leaves hardly any draw with weight: no p-value comes of that. */
    @Test
    void ranksOfAHandfulOfDrawsAreNoEvidence() {
        String narrow = quick("--spread", "1e-6,1e-6").out().replaceAll("\\s+", " ");
        assertTrue(narrow.matches(".* at least 0\\.\\d % of the draws stayed effective\\. .*"), narrow);
        assertTrue(narrow.contains("; so few draws stayed effective somewhere that this says little either way."),
                narrow);
        assertFalse(narrow.contains("not uniform"), narrow);
        assertFalse(quick().out().replaceAll("\\s+", " ").contains("this says little either way"));
    }

    @Test
    void noiseThatIsEstimatedHasToBeGivenForTheSimulation() throws IOException {
        Files.writeString(cell, SmallCell.YAML.replace("pixel_std_px: 0.05", "pixel_std_px: auto"));
        CommandCall call = quick();
        assertEquals(3, call.code());
        assertTrue(call.err().contains("--pixel-std"), call.err());
        assertNotEquals(3, quick("--pixel-std", "0.05").code());
    }

    // ---- faults

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--simulations 0 | --simulations: must be between 1 and",
        "--simulations many | --simulations",
        "--spread 50 | --spread: '50' is not MM,DEG, as in 50,10",
        "--spread 50,ten | --spread: '50,ten' is not MM,DEG",
        "--spread 50,0 | --spread: the spread takes two positive values",
        "--spread -1,1 | --spread: must be two numbers of at least 0, not -1,1",
        "--spread 50,-1 | --spread: must be two numbers of at least 0, not 50,-1",
        "--spread 50,181 | --spread: the spread takes two positive values (rotations below 57 degrees)",
        "--spread NaN,10 | --spread: 'NaN,10' is not MM,DEG",
        "--spread Infinity,10 | --spread: 'Infinity,10' is not MM,DEG",
        "--spread 50,NaN | --spread: '50,NaN' is not MM,DEG",
        "--spread 5000,10 | --spread: the spread takes at most the distance from camera to references, ",
        "--spread 1e308,10 | --spread: the spread takes at most the distance from camera to references, ",
        "--pixel-std 0 | --pixel-std: must be a positive number of px, not 0",
        "--object 7=0,0,0 | has no object 7; its objects are [5, 20]",
        "--object 5 | --object",
        "--camera-pose 1,2 | --camera-pose",
        "--estimate focal --aspect-prior-std 0 | --aspect-prior-std: must be a share above 0, such as 0.005",
        "--model cube | --model: 'cube' is not known; write rigid-marker or corner-cube",
        "--simulation 5 | Possible solutions: --simulations"})
    void faultyOptionsAreUsageErrors(String args, String message) {
        CommandCall call = validate(args.split(" "));
        assertEquals(2, call.code(), call.err());
        assertTrue(call.err().contains(message), call.err());
        assertTrue(call.err().contains("Try 'cellgauge validate --help'."), call.err());
        assertEquals("", call.out());
        assertFalse(call.err().contains("Exception"), call.err());
    }

    @Test
    void aMissingCellIsRefused() {
        CommandCall call = CommandCall.of("validate", "--cell", folder.resolve("nowhere.yaml").toString());
        assertEquals(3, call.code());
        assertTrue(call.err().contains("nowhere.yaml"), call.err());
        assertEquals(2, CommandCall.of("validate").code());
    }

    @Test
    void aCameraThatDoesNotSeeTheMarkersIsRefusedByName() {
        CommandCall call = quick("--camera-pose", "2000,150,900,3.1rad,0.05rad,0.02rad");
        assertEquals(3, call.code());
        assertTrue(call.err().matches("(?s)reference \\d+ is not seen from the camera pose.*--camera-pose.*"),
                call.err());
    }
}
