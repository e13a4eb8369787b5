package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.cellgauge.desktop.CheckInput;
import org.cellgauge.internal.settings.SettingsJson;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingTable;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** The written command is run, and what it finds compared: nothing that determines figures may be missing in it. */
class RepeatingCommandTest {
    private static final CheckSettings USUAL = CheckSettings.builder().build();
    /** Chains of so few iterations say nothing, but they say the same again. */
    private static final String FEW = " --iterations 60";

    @TempDir
    static Path folder;
    private static Path cell;
    private static Path corners;

    @BeforeAll
    static void writeCell() throws IOException {
        cell = SmallCell.write(folder);
        corners = SmallCell.writeDetections(folder.resolve("corners.json"), 3);
    }

    static List<Setting<?>> settings() {
        return SettingTable.all().stream().filter(Setting::determinesFigures).collect(Collectors.toList());
    }

    private static String other(Setting<?> setting) {
        String usual = setting.text(USUAL);
        for (String word : setting.form().placeholder().split("\\|")) {
            if (word.equals(word.toLowerCase()) && !word.equals(usual)) {
                return word;
            }
        }
        if (setting == SettingTable.INITIAL_FOCAL_PX) {
            return "600";
        }
        if (Set.of(SettingTable.FOCAL_PRIOR_SHARE, SettingTable.HIGHER_RADIAL_PRIOR_STD,
                SettingTable.TANGENTIAL_PRIOR_STD).contains(setting)) {
            return "0.01";
        }
        return usual.isEmpty() ? "40" : new BigDecimal(usual).multiply(BigDecimal.valueOf(2)).toPlainString();
    }

    private static String check(String options) {
        List<String> words = new ArrayList<>(List.of("check", "--cell", cell.toString()));
        words.addAll(List.of(options.trim().split(" +")));
        words.addAll(List.of("--json", "--detections", corners.toString()));
        return run(words);
    }

    private static String run(List<String> words) {
        CommandCall call = CommandCall.of(words.toArray(new String[0]));
        assertTrue(Set.of(ExitCodes.OK, ExitCodes.TARGET_MISSED, ExitCodes.NO_FIGURE).contains(call.code()),
                words + ": " + call.err());
        return call.out();
    }

    /** What the command of a result finds. */
    private static String again(JsonObject result) {
        List<String> words = new ArrayList<>(Arrays.asList(result.get("command").getAsString().split(" ")));
        assertEquals("cellgauge", words.remove(0));
        words.add(1, "--json");
        return run(words);
    }

    private static JsonObject json(String text) {
        return JsonParser.parseString(text).getAsJsonObject();
    }

    @ParameterizedTest
    @MethodSource("settings")
    void theCommandFindsTheSameAgain(Setting<?> setting) {
        boolean ofLength = Set.of(SettingTable.ITERATIONS, SettingTable.PRECISION, SettingTable.MAX_ITERATIONS)
                .contains(setting);
        CheckSettings before = setting.appliesTo(USUAL) ? USUAL
                : USUAL.toBuilder().estimate(Estimate.INTRINSICS).build();
        // neither waits for the usual precision
        String few = setting == SettingTable.PRECISION ? " --max-iterations 300"
                : setting == SettingTable.MAX_ITERATIONS ? " --precision 0.9" : ofLength ? "" : FEW;
        String options = few + (before == USUAL ? "" : " --estimate intrinsics") + " "
                + SettingOptions.name(setting) + " " + other(setting);
        String found = check(options);
        JsonElement value = json(found).getAsJsonObject("settings").get(setting.key());
        assertNotEquals(String.valueOf(setting.plain(before)), value.isJsonNull() ? "null" : value.getAsString(),
                "the option counts");
        assertEquals(found, again(json(found)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"--preset thesis --iterations 60 --warmup 20",
        "--preset thesis --estimate focal --seed -5 --precision 0.9 --max-iterations 90 --warmup 30 --threads 2"})
    void thePresetsCommandFindsTheSameAgain(String options) {
        String found = check(options);
        assertEquals(found, again(json(found)));
    }

    /** What stands in a result makes the settings again, the warm-up that it took among them. */
    @Test
    void settingsAreReadBackFromAResult() {
        CheckSettings read = SettingsJson.read(json(check("--preset thesis --iterations 60 --warmup 20 --target 3"))
                .getAsJsonObject("settings"));
        CheckSettings.Builder asked = CheckSettings.thesis().iterations(60).warmup(20).targetStdMm(3)
                .aspectPriorStd(USUAL.model().aspectPriorStd());
        assertEquals(asked.build(), read);
        assertEquals(USUAL.toBuilder().iterations(60).warmup(30).build(),
                SettingsJson.read(json(check(FEW)).getAsJsonObject("settings")));
    }

    @Test
    void validateTellsAllSettingsAndItsCommandFindsTheSameAgain() {
        String found = run(List.of("validate", "--cell", cell.toString(), "--simulations", "2", "--iterations", "300",
                "--camera-pose", SmallCell.CAMERA_POSE, "--object", "20=110,150,0", "--object", "5=290,150,0",
                "--spread", "20,5", "--pixel-std", "0.1", "--kappa", "0.75", "--json", "--threads", "1"));
        JsonObject written = json(found).getAsJsonObject("settings");
        assertEquals(0.75, written.get("kappa").getAsDouble());
        assertEquals(20, written.get("spread_mm").getAsDouble());
        for (Setting<?> row : StudyTable.all()) {
            assertTrue(written.has(row.key()), row.key());
        }
        for (String key : SettingsJson.plain(USUAL).keySet()) {
            assertTrue(written.has(key), key);
        }
        assertEquals(USUAL.toBuilder().iterations(300).kappa(0.75).build(), SettingsJson.read(written));
        assertEquals(found, again(json(found)));
    }

    /**
     * Every setting of a study stands in the JSON and, where it is not the default, in the command, whose words make
     * the same settings again. Nothing is rendered for this: the words are read alone.
     */
    @Test
    void theCommandOfAStudyTellsEverySetting() {
        Map<Setting<?>, String> others = new LinkedHashMap<>();
        others.put(StudyTable.SIMULATIONS, "7");
        others.put(StudyTable.PHOTOS, "true");
        others.put(StudyTable.CORNERS_ONLY, "true");
        others.put(StudyTable.EXACT_OUTLINES, "true");
        others.put(StudyTable.SPREAD, "20,5.5");
        others.put(StudyTable.TONE_CURVE, "gamma 1.8");
        others.put(StudyTable.BLUR_PX, "1.25");
        others.put(StudyTable.MARKER_PX, "32");
        others.put(StudyTable.EXPOSURE, "clipped");
        others.put(StudyTable.JPEG_QUALITY, "85");
        others.put(StudyTable.UNSHARP, "0.6,1.2");
        others.put(StudyTable.PRINT_GAIN_MM, "-0.1");
        others.put(StudyTable.GRADIENT, "-0.4");
        others.put(StudyTable.NOISE_GREY, "3");
        others.put(StudyTable.FULL_WELL_ELECTRONS, "10000");
        others.put(StudyTable.STATED_PIXEL_STD_PX, "auto");
        Set<Setting<?>> alone = Set.of(StudyTable.GRID, StudyTable.RANDOM_LAYOUTS, StudyTable.PIXEL_STD_PX,
                StudyTable.OUTLIERS, StudyTable.CALIBRATION_PHOTOS);
        Set<Setting<?>> tried = new HashSet<>(others.keySet());
        tried.addAll(alone);
        assertEquals(new HashSet<>(StudyTable.all()), tried, "a new setting is tried here, too");
        toldAndReadBack(others);
        toldAndReadBack(Map.of(StudyTable.PHOTOS, "true", StudyTable.GRID, "true"));
        toldAndReadBack(Map.of(StudyTable.RANDOM_LAYOUTS, "true", StudyTable.PIXEL_STD_PX, "0.2"));
        toldAndReadBack(Map.of(StudyTable.OUTLIERS, "0.05,20"));
        toldAndReadBack(Map.of(StudyTable.CALIBRATION_PHOTOS, "20"));
    }

    private static void toldAndReadBack(Map<Setting<?>, String> texts) {
        Map<Setting<?>, Object> values = new HashMap<>();
        texts.forEach((row, text) -> values.put(row, row.read(text)));
        StudySettings study = new StudySettings(values);
        CheckSettings thesis = CheckSettings.thesis().seed(-5).build();
        CommandLine none = parsed(List.of("validate"));
        String command = RepeatingCommand.validate(cell, study, thesis, none.getParseResult(), Set.of());
        List<String> words = new ArrayList<>();
        Matcher quotedOrPlain = Pattern.compile("'([^']*)'|(\\S+)").matcher(command);
        while (quotedOrPlain.find()) {
            words.add(quotedOrPlain.group(1) != null ? quotedOrPlain.group(1) : quotedOrPlain.group(2));
        }
        CommandLine again = parsed(words.subList(1, words.size()));
        StudySettings read = new StudyOptions().settings(again);
        assertEquals(study.plain(), read.plain(), command);
        texts.forEach((row, text) -> assertTrue(command.contains(row.form().isFlag() ? SettingOptions.name(row)
                : SettingOptions.name(row) + " " + RepeatingCommand.quoted(text)), row + ": " + command));
        assertEquals(SettingsJson.plain(thesis),
                SettingsJson.plain(CheckOptions.settings(again, CheckOptions.OfValidate.USUAL)));
    }

    private static CommandLine parsed(List<String> words) {
        CommandLine root = Main.commandLine();
        root.parseArgs(words.toArray(new String[0]));
        return root.getSubcommands().get(words.get(0));
    }

    /** Words as a real shell reads them. */
    @ParameterizedTest
    @ValueSource(strings = {"plain-1.png", "two words.png", "it's.png", "$HOME", "a\"b", "", "*", "~", "-x", "ä.png",
        "back\\slash", "new\nline", "a;b", "#x", "!x", "{a,b}"})
    void aShellReadsQuotedWordsUnchanged(String word) throws IOException, InterruptedException {
        Process shell = new ProcessBuilder("sh", "-c", "printf '%s|' " + RepeatingCommand.quoted(word)).start();
        String read = new String(shell.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, shell.waitFor());
        assertEquals(word + "|", read);
    }

    @Test
    void awkwardNamesOfFilesAreWrittenSoThatTheyAreFound() {
        assertEquals("cellgauge check --cell 'my cell.yaml' ./-photo.png", RepeatingCommand.check(
                Path.of("my cell.yaml"), new CheckInput(Path.of("-photo.png"), false, "-photo", null), USUAL,
                false));
    }
}
