package org.cellgauge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.cellgauge.cli.Main;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What docs/markers.md shows of other detectors finds the corners of a photo as the check takes them. */
class DetectorSnippetsTest {
    private static final Path ROOT = Path.of(System.getProperty("cellgauge.root", "."));
    private static final Path SCENE = ROOT.resolve("fixtures/apriltag-4");
    /** Of 3 coordinates with the covariance stated, beyond this once in 10 000. */
    private static final double FARTHEST = 21.1;
    @TempDir
    private Path folder;

    /** A quarter turn would put objects off by their distance from the references' middle, half a pixel by 1 mm. */
    @ParameterizedTest
    @CsvSource({"0, DICT_APRILTAG_36h11", "1, tag36h11"})
    void cornersOfAnotherDetectorGiveTheTruePoses(int snippet, String family) throws IOException,
            InterruptedException {
        Path detections = folder.resolve("photo.json");
        Python.Ran ran = Python.run(Python.snippets(ROOT.resolve("docs/markers.md")).get(snippet), folder,
                SCENE.resolve("photo.png").toString(), family, detections.toString());
        assertEquals(0, ran.code(), ran.printed());
        StringWriter err = new StringWriter();
        int code = Main.commandLine().setOut(new PrintWriter(new StringWriter())).setErr(new PrintWriter(err))
                .execute("check", "--cell", SCENE.resolve("cell.yaml").toString(), "--detections",
                        detections.toString(), "--out", folder.toString());
        assertTrue(code == 0 || code == 4, code + ": " + err);
        JsonObject truth = read(SCENE.resolve("photo.truth.json")).getAsJsonObject("objects");
        JsonObject found = read(folder.resolve("photo.result.json")).getAsJsonObject("objects");
        assertEquals(truth.keySet(), found.keySet());
        for (String id : truth.keySet()) {
            JsonArray at = truth.getAsJsonObject(id).getAsJsonObject("pose").getAsJsonArray("position_mm");
            JsonObject pose = found.getAsJsonObject(id).getAsJsonObject("pose");
            for (int axis = 0; axis < 3; axis++) {
                double error = pose.getAsJsonArray("mean").get(axis).getAsDouble() - at.get(axis).getAsDouble();
                double std = pose.getAsJsonArray("std").get(axis).getAsDouble();
                assertTrue(error * error < FARTHEST * std * std && std < 5, "object " + id + ", axis " + axis
                        + ": off by " + error + " mm at a stated " + std);
            }
        }
    }

    private static JsonObject read(Path file) throws IOException {
        return JsonParser.parseString(Files.readString(file)).getAsJsonObject();
    }
}
