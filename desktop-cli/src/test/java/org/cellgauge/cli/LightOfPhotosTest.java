package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Rendered photos through the whole check, where nobody states a noise: tone curves, clipped whites, thin margins. */
class LightOfPhotosTest {
    private static final String YAML = SmallCell.YAML.replace("pixel_std_px: 0.05\n", "")
            .replace("size_mm: 100", "size_mm: 47");

    /** Quantiles of chi-square with 3 degrees of freedom, of any table. */
    private static final double LIMIT_95 = 7.815;
    private static final double LIMIT_9999 = 21.108;

    @TempDir
    private Path folder;

    private Path cell(String more) throws IOException {
        assertFalse(YAML.contains("pixel_std_px"));
        SmallCell.write(folder);
        return Files.writeString(folder.resolve("cell.yaml"), YAML + more);
    }

    /** Markers of 31 px; the references stand off as far as the cell file says. */
    private void render(Path cell, String... more) {
        List<String> all = new ArrayList<>(List.of("simulate", "--cell", cell.toString(), "--out", folder.toString(),
                "--object", "5=290,150,0,22.9,0,17.2", "--object", "20=110,150,0,0,22.9,-11.5", "--camera-pose",
                SmallCell.CAMERA_POSE, "--placement-errors", "draw"));
        all.addAll(List.of(more));
        CommandCall call = CommandCall.of(all.toArray(new String[0]));
        assertEquals(0, call.code(), call.err());
    }

    private CommandCall check(Path cell, String photo) {
        return CommandCall.of("check", "--cell", cell.toString(), folder.resolve(photo).toString(), "--json");
    }

    private JsonObject truth(String photo) throws IOException {
        return JsonParser.parseString(Files.readString(folder.resolve(photo + ".truth.json"))).getAsJsonObject();
    }

    private static JsonObject result(CommandCall call) {
        return JsonParser.parseString(call.out()).getAsJsonObject();
    }

    /** Squared distance of position and truth in deviations, 3 degrees of freedom. */
    private static double squares(JsonObject stated, JsonObject truth) {
        double[][] a = new double[3][4];
        JsonArray covariance = stated.getAsJsonArray("covariance");
        double[] off = new double[3];
        for (int i = 0; i < 3; i++) {
            off[i] = stated.getAsJsonArray("mean").get(i).getAsDouble()
                    - truth.getAsJsonArray("position_mm").get(i).getAsDouble();
            for (int j = 0; j < 3; j++) {
                a[i][j] = covariance.get(i).getAsJsonArray().get(j).getAsDouble();
            }
            a[i][3] = off[i];
        }
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                double factor = k == i ? 0 : a[k][i] / a[i][i];
                for (int j = i; j < 4; j++) {
                    a[k][j] -= factor * a[i][j];
                }
            }
        }
        return off[0] * a[0][3] / a[0][0] + off[1] * a[1][3] / a[1][1] + off[2] * a[2][3] / a[2][2];
    }

    /** The squared distances of camera and objects, as above. */
    private static List<Double> squares(CommandCall call, JsonObject truth) {
        JsonObject result = result(call);
        List<Double> all = new ArrayList<>();
        all.add(squares(result.getAsJsonObject("camera"), truth.getAsJsonObject("camera").getAsJsonObject("pose")));
        JsonObject objects = result.getAsJsonObject("objects");
        for (String id : objects.keySet()) {
            all.add(squares(objects.getAsJsonObject(id).getAsJsonObject("pose"),
                    truth.getAsJsonObject("objects").getAsJsonObject(id).getAsJsonObject("pose")));
        }
        assertEquals(3, all.size(), call.out());
        return all;
    }

    /** Of 9 positions at most two are outside a 95 % region (more: once in 120), none outside one of 99.99 %. */
    @Test
    void jpegsOfAnotherCurveThanTheySayCoverTheTruthAndAccuseNobody() throws IOException {
        Path cell = cell("");
        render(cell, "--tone-curve", "gamma 2.2", "--jpeg", "92", "--count", "3", "--seed", "11");
        int outside = 0;
        for (int i = 1; i <= 3; i++) {
            CommandCall call = check(cell, "photo-" + i + ".jpg");
            JsonObject result = result(call);
            assertEquals(0, result.getAsJsonArray("misplaced_references").size(), call.out());
            for (double d : squares(call, truth("photo-" + i))) {
                outside += d > LIMIT_95 ? 1 : 0;
                assertTrue(d < LIMIT_9999, call.out());
            }
            String curve = result.getAsJsonObject("light").get("tone_curve").getAsString();
            assertFalse(curve.equals("linear"), curve);
        }
        assertTrue(outside <= 2, outside + " of 9 positions are outside");
    }

    /** White paper three times as bright as the brightest value: nothing tells the curve, and the words say so. */
    @Test
    void clippedPhotosOfAnUnknownCurveAreRefusedInWords() throws IOException {
        Path cell = cell("");
        render(cell, "--tone-curve", "linear", "--exposure", "3", "--no-profile");
        CommandCall call = check(cell, "photo.png");
        assertEquals(3, call.code(), call.out() + call.err());
        assertTrue(call.err().contains("whites are clipped"), call.err());
        assertTrue(call.err().contains("tone_curve"), call.err());
    }

    @Test
    void clippedPhotosOfAStatedCurveCoverTheTruth() throws IOException {
        Path cell = cell("tone_curve: linear\n");
        render(cell, "--tone-curve", "linear", "--exposure", "1.95", "--blur-px", "1");
        CommandCall call = check(cell, "photo.png");
        JsonObject result = result(call);
        assertTrue(result.getAsJsonArray("warnings").toString().contains("whites are clipped"), call.out());
        assertTrue(Collections.max(squares(call, truth("photo"))) < LIMIT_9999, call.out());
    }

    /** White paper of a tenth of the marker's size, 3 px here, with a grey wall behind. */
    @ParameterizedTest
    @ValueSource(strings = {"linear", "srgb"})
    void thinMarginsMoveNothing(String curve) throws IOException {
        Path cell = cell("");
        render(cell, "--tone-curve", curve, "--quiet-zone", "0.1", "--seed", "3");
        CommandCall call = check(cell, "photo.png");
        JsonObject result = result(call);
        assertEquals(0, result.getAsJsonArray("misplaced_references").size(), call.out());
        assertTrue(Collections.max(squares(call, truth("photo"))) < LIMIT_9999, call.out());
    }
}
