package org.cellgauge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import dev.harrel.jsonschema.Validator;
import dev.harrel.jsonschema.ValidatorFactory;
import dev.harrel.jsonschema.providers.GsonNode;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.cellgauge.cli.Main;
import org.cellgauge.output.ResultJson;
import org.cellgauge.output.ResultReader;
import org.cellgauge.settings.LikelihoodModel;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Default settings converge on every stored photo with every likelihood; those of the thesis on none, and say so. */
class FixturesConvergeTest {
    private static final Path ROOT = Path.of(System.getProperty("cellgauge.root", "."));

    @TempDir
    private Path folder;

    static List<Path> scenes() throws IOException {
        try (Stream<Path> folders = Files.list(ROOT.resolve("fixtures"))) {
            List<Path> scenes = folders.filter(f -> Files.exists(f.resolve("photo.png"))).sorted().toList();
            assertTrue(scenes.size() >= 7, "fixtures are missing: " + scenes);
            return scenes;
        }
    }

    static List<Arguments> scenesAndLikelihoods() throws IOException {
        List<Arguments> all = new ArrayList<>();
        for (Path scene : scenes()) {
            for (LikelihoodModel model : LikelihoodModel.values()) {
                all.add(Arguments.of(scene, model.word()));
            }
        }
        return all;
    }

    private record Call(int code, String printed) {
    }

    private static Call check(Path scene, String... options) {
        List<String> words = new ArrayList<>(List.of("check", "--cell", scene.resolve("cell.yaml").toString(),
                scene.resolve("photo.png").toString()));
        words.addAll(Arrays.asList(options));
        StringWriter out = new StringWriter();
        int code = Main.commandLine().setOut(new PrintWriter(out)).setErr(new PrintWriter(new StringWriter()))
                .execute(words.toArray(new String[0]));
        return new Call(code, out.toString());
    }

    private static JsonObject json(String text) {
        return JsonParser.parseString(text).getAsJsonObject();
    }

    /** Positions of objects and camera are where the truth has them: of 84 figures none is four deviations off. */
    @ParameterizedTest
    @MethodSource("scenes")
    void figuresCoverTheTruth(Path scene) throws IOException {
        String printed = check(scene, "--json").printed();
        Validator.Result valid = new ValidatorFactory().withJsonNodeFactory(new GsonNode.Factory())
                .validate(Files.readString(ROOT.resolve("docs/result.schema.json")), printed);
        assertTrue(valid.isValid(), () -> valid.getErrors().stream()
                .map(e -> e.getInstanceLocation() + ": " + e.getError()).toList().toString());
        // all that it says is in the view
        assertEquals(printed, ResultJson.line(ResultReader.stored(printed, "printed")));
        JsonObject result = json(printed);
        JsonObject truth = json(Files.readString(scene.resolve("photo.truth.json")));
        JsonObject objects = truth.getAsJsonObject("objects");
        double worst = off(result.getAsJsonObject("camera"), truth.getAsJsonObject("camera").getAsJsonObject("pose"));
        for (String id : objects.keySet()) {
            worst = Math.max(worst, off(result.getAsJsonObject("objects").getAsJsonObject(id).getAsJsonObject("pose"),
                    objects.getAsJsonObject(id).getAsJsonObject("pose")));
        }
        assertTrue(worst < 4, worst + " deviations");
        assertEquals(0, result.getAsJsonArray("misplaced_references").size(), "all stand as the cell file says");
    }

    /** The largest difference of a coordinate, in stated deviations. */
    private static double off(JsonObject stated, JsonObject truth) {
        double worst = 0;
        for (int i = 0; i < 3; i++) {
            double difference = stated.getAsJsonArray("mean").get(i).getAsDouble()
                    - truth.getAsJsonArray("position_mm").get(i).getAsDouble();
            worst = Math.max(worst, Math.abs(difference) / stated.getAsJsonArray("std").get(i).getAsDouble());
        }
        return worst;
    }

    /** Two seeds, so that no lucky one passes; target met or missed, but a figure. */
    @ParameterizedTest
    @MethodSource("scenesAndLikelihoods")
    void defaultSettingsConverge(Path scene, String model) {
        for (String seed : List.of("1", "2")) {
            Call call = check(scene, "--model", model, "--seed", seed, "--json");
            JsonObject result = json(call.printed());
            String what = "seed " + seed + ": " + result.get("reason").getAsString();
            JsonObject diagnostics = result.getAsJsonObject("diagnostics");
            assertTrue(diagnostics.get("converged").getAsBoolean(), what);
            assertTrue(diagnostics.get("precision_reached").getAsBoolean(), what);
            assertEquals(result.get("verdict").getAsString().equals("pass") ? 0 : 4, call.code(), what);
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void thesisPresetIsToldThatItDidNotConvergeAndStatesNoAccuracy(Path scene) throws IOException {
        Call call = check(scene, "--preset", "thesis", "--out", folder.toString());
        assertEquals(5, call.code());
        assertTrue(call.printed().startsWith("NOT CONVERGED"), call.printed());
        JsonObject result = json(Files.readString(folder.resolve("photo.result.json")));
        assertEquals("not-converged", result.get("verdict").getAsString());
        assertFalse(result.getAsJsonObject("diagnostics").get("converged").getAsBoolean());
        JsonObject objects = result.getAsJsonObject("objects");
        assertEquals(3, objects.size());
        for (String id : objects.keySet()) {
            assertTrue(objects.getAsJsonObject(id).get("within_target").isJsonNull(), id);
        }
    }
}
