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
    /** Deviations that a coordinate is off by at most: corners of others are biased by up to 0.2 px. */
    private static final double FARTHEST = 4;
    @TempDir
    private Path folder;

    /** A quarter turn would put objects off by their distance from the references' middle, half a pixel by 1 mm. */
    @ParameterizedTest
    @CsvSource({"0, DICT_APRILTAG_36h11", "1, tag36h11"})
    void cornersOfAnotherDetectorGiveTheTruePoses(int snippet, String family) throws IOException,
            InterruptedException {
        String program = Python.snippets(ROOT.resolve("docs/markers.md")).get(snippet);
        Python.assumeModulesOf(program, folder);
        String cell = ROOT.resolve("fixtures/apriltag-4/cell.yaml").toString();
        Path detections = folder.resolve("photo.json");
        // from where all markers fit they are 41 px wide and more; the fixture's own 25 px are too small for OpenCV
        assertEquals(0, call("simulate", "--cell", cell, "--object", "5=259,276,155,25,0,10", "--object",
                "20=261,202,147,0,0,15", "--object", "30=239,-27,0,15,0,-30", "--out", folder.toString()));
        Python.Ran ran = Python.run(program, folder,
                folder.resolve("photo.png").toString(), family, detections.toString());
        assertEquals(0, ran.code(), ran.printed());
        assertEquals(0, call("check", "--cell", cell, "--detections", detections.toString(), "--out",
                folder.toString()));
        JsonObject truth = read(folder.resolve("photo.truth.json")).getAsJsonObject("objects");
        JsonObject found = read(folder.resolve("photo.result.json")).getAsJsonObject("objects");
        assertEquals(truth.keySet(), found.keySet());
        for (String id : truth.keySet()) {
            JsonArray at = truth.getAsJsonObject(id).getAsJsonObject("pose").getAsJsonArray("position_mm");
            JsonObject pose = found.getAsJsonObject(id).getAsJsonObject("pose");
            for (int axis = 0; axis < 3; axis++) {
                double error = pose.getAsJsonArray("mean").get(axis).getAsDouble() - at.get(axis).getAsDouble();
                double std = pose.getAsJsonArray("std").get(axis).getAsDouble();
                assertTrue(Math.abs(error) < FARTHEST * std && std < 5, "object " + id + ", axis " + axis
                        + ": off by " + error + " mm at a stated " + std);
            }
        }
    }

    private static int call(String... arguments) {
        return Main.commandLine().setOut(new PrintWriter(new StringWriter()))
                .setErr(new PrintWriter(new StringWriter())).execute(arguments);
    }

    private static JsonObject read(Path file) throws IOException {
        return JsonParser.parseString(Files.readString(file)).getAsJsonObject();
    }
}
