package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two surveys of rendered photos: from photos to what has moved. */
class SurveyAgainstTest {
    @TempDir
    Path folder;

    @BeforeEach
    void files() throws IOException {
        Path fixture = Path.of(System.getProperty("cellgauge.root", "."), "fixtures", "raised-4");
        for (String name : List.of("cell.yaml", "camera.yaml")) {
            Files.copy(fixture.resolve(name), folder.resolve(name));
        }
    }

    private CommandCall run(String... arguments) {
        return CommandCall.of(arguments);
    }

    private String photos(String name, String object, int seed) {
        String to = folder.resolve(name).toString();
        CommandCall made = run("simulate", "--cell", folder.resolve("cell.yaml").toString(), "--out", to, "--count",
                "2", "--camera-jitter", "30,3", "--seed", String.valueOf(seed), "--object", "5=" + object, "--object",
                "20=120,300,0");
        assertEquals(0, made.code(), made.err());
        return to;
    }

    private CommandCall survey(String... more) {
        List<String> all = new ArrayList<>(List.of("survey", "--cell", folder.resolve("cell.yaml").toString()));
        all.addAll(List.of(more));
        return run(all.toArray(new String[0]));
    }

    @Test
    void whatHasMovedIsNamedAndShown() throws IOException {
        Path out = folder.resolve("before.yaml");
        Path kept = folder.resolve("before.survey.json");
        CommandCall before = survey(photos("before", "300,150,0", 1), "--out", out.toString());
        assertTrue(Files.exists(kept), before.err());
        CommandCall after = survey(photos("after", "301.5,150,0", 2), "--against", kept.toString(), "--out",
                folder.resolve("after.yaml").toString());
        assertEquals(ExitCodes.TARGET_MISSED, after.code(), after.err());
        assertTrue(after.out().startsWith("MOVED"), after.out());
        assertTrue(after.out().contains("object 5 !") && !after.out().contains("object 20 !"), after.out());
        assertTrue(after.err().contains("object 5 has moved since the earlier survey by 1.5"), after.err());
        String page = Files.readString(folder.resolve("after.html"));
        assertTrue(page.contains("Control charts") && page.contains("aria-label=\"object 20 by photo\""), "charts");
        JsonObject json = JsonParser.parseString(Files.readString(folder.resolve("after.survey.json")))
                .getAsJsonObject();
        assertTrue(json.getAsJsonObject("drift").get("moved").getAsBoolean());
        assertEquals(2, json.getAsJsonObject("drift").getAsJsonArray("photos").size());
    }

    @Test
    void filesThatHoldNoSurveyAreRefused() throws IOException {
        Path other = folder.resolve("other.json");
        for (String text : List.of("no json", "{}", "{\"epoch\": 3}",
                "{\"epoch\": {\"bodies\": [], \"covariance\": 1}}",
                "{\"epoch\": {\"bodies\": [{\"kind\": \"reference\", \"id\": 1, \"rotation\": [1], "
                        + "\"position_mm\": [0]}], \"covariance\": [[1]]}}")) {
            Files.writeString(other, text);
            CommandCall run = survey("photo.png", "--against", other.toString());
            assertEquals(ExitCodes.INPUT_REFUSED, run.code(), text + ": " + run.err());
            assertTrue(run.err().contains("other.json") && run.err().contains("NAME.survey.json"), run.err());
        }
        CommandCall missing = survey("photo.png", "--against", folder.resolve("none.json").toString());
        assertEquals(ExitCodes.INPUT_REFUSED, missing.code());
        CommandCall alone = survey("photo.png", "--camera-stands");
        assertEquals(ExitCodes.USAGE, alone.code());
    }
}
