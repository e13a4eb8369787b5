package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.DetectionsFile;
import org.cellgauge.vision.PhotoLight;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CheckCommandTest {
    @TempDir
    private Path folder;
    private Path cell;
    private Path corners;
    private Path out;

    @BeforeEach
    void writeInputs() throws IOException {
        cell = SmallCell.write(folder);
        corners = SmallCell.writeDetections(folder.resolve("corners.json"), 1);
        out = folder.resolve("out");
    }

    private CommandCall check(Object... args) {
        List<String> all = new ArrayList<>(List.of("check", "--cell", cell.toString()));
        for (Object arg : args) {
            all.add(arg.toString());
        }
        return CommandCall.of(all.toArray(new String[0]));
    }

    private static Set<String> names(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return new TreeSet<>(files.map(f -> f.getFileName().toString()).toList());
        }
    }

    private static Map<String, String> contents(Path folder) throws IOException {
        Map<String, String> contents = new TreeMap<>();
        for (String name : names(folder)) {
            contents.put(name, new String(Files.readAllBytes(folder.resolve(name)), StandardCharsets.ISO_8859_1));
        }
        return contents;
    }

    private static JsonObject json(Path file) throws IOException {
        return JsonParser.parseString(Files.readString(file)).getAsJsonObject();
    }

    private static double[] numbers(JsonElement array) {
        double[] values = new double[array.getAsJsonArray().size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = array.getAsJsonArray().get(i).getAsDouble();
        }
        return values;
    }

    private static double[][] matrix(JsonElement rows) {
        return rows.getAsJsonArray().asList().stream().map(CheckCommandTest::numbers).toArray(double[][]::new);
    }

    // ---- exit codes

    @Test
    void exitCodesTellTheVerdict() {
        CommandCall pass = check("--detections", corners, "--target", 5, "--out", out);
        assertEquals(0, pass.code(), pass.err());
        assertTrue(pass.out().startsWith("pass  "), pass.out());
        CommandCall fail = check("--detections", corners, "--target", 0.1, "--out", out);
        assertEquals(4, fail.code(), fail.err());
        assertTrue(fail.out().startsWith("FAIL  "), fail.out());
        // 40 kept draws of 4 chains cannot have 400 effective ones
        CommandCall short40 = check("--detections", corners, "--iterations", 20, "--warmup", 10, "--out", out);
        assertEquals(5, short40.code(), short40.err());
    }

    @Test
    void withoutATargetThereIsNoneToMiss() throws IOException {
        Files.writeString(cell, SmallCell.YAML.replace("target: {std_mm: 2.0}\n", ""));
        assertEquals(0, check("--detections", corners, "--out", out).code());
        JsonObject result = json(out.resolve("corners.result.json"));
        assertEquals("no-target", result.get("verdict").getAsString());
        assertTrue(result.getAsJsonObject("objects").getAsJsonObject("5").get("within_target").isJsonNull());
    }

    @Test
    void figuresThatHaveNotConvergedStandBesideThatWord() throws IOException {
        CommandCall call = check("--detections", corners, "--iterations", 20, "--warmup", 10, "--out", out);
        call.out().lines().filter(line -> line.matches(" *(object \\d+|its gripping point) +-?\\d.*"))
                .forEach(line -> assertTrue(line.endsWith("not converged"), line));
        call.out().lines().filter(line -> line.contains(" in world"))
                .forEach(line -> assertTrue(line.endsWith("NOT CONVERGED"), line));
        JsonObject result = json(out.resolve("corners.result.json"));
        assertEquals("not-converged", result.get("verdict").getAsString());
        assertFalse(result.getAsJsonObject("diagnostics").get("converged").getAsBoolean());
        assertTrue(result.getAsJsonObject("objects").getAsJsonObject("5").get("within_target").isJsonNull());
        String report = Files.readString(out.resolve("report.html"));
        assertTrue(report.contains("not converged"));
    }

    @Test
    void theMostSeriousCodeOfABatchWins() {
        assertEquals(3, ExitCodes.moreSerious(3, 5));
        assertEquals(1, ExitCodes.moreSerious(3, 1));
        assertEquals(5, ExitCodes.moreSerious(4, 5));
        assertEquals(4, ExitCodes.moreSerious(4, 0));
    }

    /** By seed and content: no photo shares its random numbers with another, and none depends on its neighbours. */
    @Test
    void aPhotoHasTheSameFiguresAloneAndInABatchAndOtherPhotosOtherRandomNumbers() throws Exception {
        Path folder = Files.createDirectories(out.resolveSibling("batch-" + out.getFileName()));
        Path first = SmallCell.writeDetections(folder.resolve("first.json"), 3);
        Path second = SmallCell.writeDetections(folder.resolve("second.json"), 4);
        // the corners of the first but for a digit that no figure shows
        Path other = Files.writeString(folder.resolve("other.json"),
                Files.readString(first).replaceFirst("(\\d\\.\\d{6})\\d", "$10"));
        Path alone = folder.resolve("alone");
        Path batch = folder.resolve("in-batch");
        assertEquals(0, check("--detections", first, "--target", 5, "--seed", 7, "--out", alone).code());
        assertEquals(0, check("--detections", second, "--detections", first, "--detections", other, "--target", 5,
                "--seed", 7, "--out", batch).code());
        JsonObject one = json(alone.resolve("first.result.json")).getAsJsonObject("camera");
        assertEquals(one, json(batch.resolve("first.result.json")).getAsJsonObject("camera"));
        JsonObject another = json(batch.resolve("other.result.json")).getAsJsonObject("camera");
        double difference = one.getAsJsonArray("mean").get(0).getAsDouble()
                - another.getAsJsonArray("mean").get(0).getAsDouble();
        // the mode moves by a millionth of a pixel, the mean of other draws by its Monte Carlo error
        double std = one.getAsJsonArray("std").get(0).getAsDouble();
        assertTrue(Math.abs(difference) > 1e-4 * std, "same random numbers: " + difference);
    }

    // ---- the result file

    /** What a detector found out about the light is passed on, and what is stated of the tone curve is a setting. */
    @Test
    void lightOfThePhotoIsInEveryOutput() throws IOException {
        CommandCall without = check("--detections", corners, "--target", 5, "--out", out);
        assertFalse(without.out().contains("Light:"), without.out());
        JsonObject result = json(out.resolve("corners.result.json"));
        assertFalse(result.has("light"));
        assertEquals("auto", result.getAsJsonObject("settings").get("tone_curve").getAsString());

        Detections plain = DetectionsFile.read(corners);
        StringBuilder lit = new StringBuilder();
        DetectionsFile.write(new Detections("none.png", plain.widthPx(), plain.heightPx(), plain.markers(), List.of(),
                new PhotoLight(ToneCurve.gamma(2.15625), true, 0.71, 1.96, 400, 0.035)), lit);
        Path file = Files.writeString(folder.resolve("lit.json"), lit);
        Files.writeString(cell, SmallCell.YAML + "tone_curve: srgb\n");
        CommandCall call = check("--detections", file, "--target", 5, "--out", out);
        assertTrue(call.out().replaceAll("\\s+", " ").contains("Light: tone curve gamma 2.16 (estimated), blur 0.71 "
                + "px, noise 2.0 of 255 grey levels, edges may be shifted by 0.035 px (std)"), call.out());
        result = json(out.resolve("lit.result.json"));
        JsonObject light = result.getAsJsonObject("light");
        assertEquals("gamma 2.15625", light.get("tone_curve").getAsString());
        assertTrue(light.get("tone_curve_estimated").getAsBoolean());
        assertEquals(0.71, light.get("blur_px").getAsDouble());
        assertEquals(1.96, light.get("noise_grey").getAsDouble());
        assertEquals(400, light.get("noise_degrees_of_freedom").getAsDouble());
        assertEquals(0.035, light.get("edge_shift_std_px").getAsDouble());
        assertEquals("srgb", result.getAsJsonObject("settings").get("tone_curve").getAsString());
        String report = Files.readString(out.resolve("report.html"));
        assertTrue(report.contains("<td>light of the photo</td>") && report.contains("gamma 2.16 (estimated)"), report);
        assertTrue(report.contains("<tr><td>tone curve</td><td class=\"text\">srgb</td></tr>"));

        // a detector that knows nothing of blur and noise
        Files.writeString(file, lit.toString().replaceAll(", \"(blur|noise)[^,}]*", ""));
        call = check("--detections", file, "--target", 5, "--out", out);
        assertTrue(call.out().replaceAll("\\s+", " ").contains("gamma 2.16 (estimated), edges may be"), call.out());
        assertTrue(json(out.resolve("lit.result.json")).getAsJsonObject("light").get("blur_px").isJsonNull());
    }

    @Test
    void theResultFileHoldsWhatItsReadersCountOn() throws Exception {
        assertEquals(0, check("--detections", corners, "--target", 5, "--seed", 7, "--out", out).code());
        JsonObject result = json(out.resolve("corners.result.json"));
        assertEquals(1, result.get("schema").getAsInt());
        assertEquals("pass", result.get("verdict").getAsString());
        assertEquals(Set.of("name", "sha256"), result.getAsJsonObject("input").keySet());
        assertEquals("corners.json", result.getAsJsonObject("input").get("name").getAsString());
        byte[] digest = MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(corners));
        assertEquals(HexFormat.of().formatHex(digest), result.getAsJsonObject("input").get("sha256").getAsString());
        for (String key : List.of("decided", "reason", "settings", "camera", "objects", "diagnostics", "acceptance",
                "warnings", "version")) {
            assertTrue(result.has(key), key);
        }
        assertFalse(result.has("intrinsics"));
        JsonObject settings = result.getAsJsonObject("settings");
        assertEquals(7, settings.get("seed").getAsLong());
        assertEquals("rigid-marker", settings.get("model").getAsString());
        assertTrue(settings.get("iterations").isJsonNull());
        assertFalse(settings.has("threads"));
        JsonObject camera = result.getAsJsonObject("camera");
        assertEquals("camera in world", camera.get("frame").getAsString());
        assertEquals("[\"x_mm\",\"y_mm\",\"z_mm\",\"psi_rad\",\"theta_rad\",\"phi_rad\"]",
                camera.get("order").toString());
        assertPose(camera);
        JsonObject object = result.getAsJsonObject("objects").getAsJsonObject("20");
        assertEquals("object in world", object.getAsJsonObject("pose").get("frame").getAsString());
        assertPose(object.getAsJsonObject("pose"));
        double sum = 0;
        for (JsonElement share : object.getAsJsonObject("budget").asMap().values()) {
            sum += share.getAsDouble();
        }
        assertEquals(1, sum, 1e-12);
        JsonObject grip = object.getAsJsonObject("grip");
        double[][] covariance = matrix(grip.get("covariance"));
        assertEquals(3, numbers(grip.get("mean")).length);
        for (int i = 0; i < 3; i++) {
            assertEquals(Math.sqrt(covariance[i][i]), numbers(grip.get("std"))[i], 1e-12);
        }
        JsonObject ellipse = object.getAsJsonObject("ellipse95_px");
        assertEquals(2, numbers(ellipse.get("centre")).length);
        double[] axes = numbers(ellipse.get("semi_axes"));
        assertTrue(axes[0] >= axes[1] && axes[1] > 0);
        assertFalse(result.getAsJsonObject("objects").getAsJsonObject("5").has("grip"));
        JsonObject diagnostics = result.getAsJsonObject("diagnostics");
        assertTrue(diagnostics.get("converged").getAsBoolean());
        assertTrue(diagnostics.get("r_hat_max").getAsDouble() < 1.01);
        assertTrue(diagnostics.get("ess_bulk_min").getAsDouble() >= 400);
        assertTrue(diagnostics.get("ess_tail_min").getAsDouble() >= 400);
        assertTrue(diagnostics.get("mcse_std_rel_max").getAsDouble() < 0.02);
        assertTrue(diagnostics.getAsJsonObject("parameters").has("object_20_grip_z_mm"));
        JsonObject accepted = result.getAsJsonObject("acceptance").getAsJsonObject("independence");
        assertTrue(accepted.get("accepted").getAsLong() > accepted.get("rejected").getAsLong());
    }

    private static void assertPose(JsonObject pose) {
        double[] mean = numbers(pose.get("mean"));
        double[] std = numbers(pose.get("std"));
        double[][] covariance = matrix(pose.get("covariance"));
        double[][] tangent = matrix(pose.get("tangent_covariance"));
        for (int i = 0; i < 6; i++) {
            assertEquals(Math.sqrt(covariance[i][i]), std[i], 1e-12);
            for (int j = 0; j < 6; j++) {
                assertEquals(covariance[i][j], covariance[j][i], 0);
                if (i < 3 && j < 3) {
                    assertEquals(covariance[i][j], tangent[i][j], 1e-9 * std[i] * std[j]);
                }
            }
            assertTrue(i < 3 || (mean[i] > -Math.PI && mean[i] <= Math.PI));
        }
    }

    @Test
    void posesLieWithinTheirUncertaintyOfTheTruth() throws IOException {
        assertEquals(0, check("--detections", corners, "--target", 5, "--out", out).code());
        JsonObject result = json(out.resolve("corners.result.json"));
        // References stand exactly where the cell file says: errors are those of corners alone, far below the stated
        // std. A mixed-up frame or angle order would be off by many of them
        double[] truth = {200, 150, 900, 3.1, 0.05, 0.02};
        JsonObject camera = result.getAsJsonObject("camera");
        for (int i = 0; i < 6; i++) {
            assertEquals(truth[i], numbers(camera.get("mean"))[i], 3 * numbers(camera.get("std"))[i]);
        }
        JsonObject grip = result.getAsJsonObject("objects").getAsJsonObject("20").getAsJsonObject("grip");
        double[] gripTruth = RigidTransform.ofEuler(110, 150, 0, 0, 0.4, -0.2).apply(0, 0, 100);
        for (int i = 0; i < 3; i++) {
            assertEquals(gripTruth[i], numbers(grip.get("mean"))[i], 3 * numbers(grip.get("std"))[i]);
        }
    }

    @Test
    void standardOutputOfJsonIsTheResultFile() throws IOException {
        CommandCall call = check("--detections", corners, "--json", "--out", out, "--target", 5);
        assertEquals(json(out.resolve("corners.result.json")), JsonParser.parseString(call.out()));
        assertEquals(1, call.out().lines().count());
    }

    @Test
    void namesInAnyScriptSurviveWhateverTheTerminalSpeaks() throws IOException {
        Path file = Files.copy(corners, folder.resolve("Pr\u00fcfung \u96f6\u4ef6.json"));
        CommandCall call = check("--detections", file, "--json", "--iterations", 100);
        assertTrue(call.out().chars().allMatch(c -> c < 0x7F), call.out());
        assertEquals("Pr\u00fcfung \u96f6\u4ef6.json", JsonParser.parseString(call.out()).getAsJsonObject()
                .getAsJsonObject("input").get("name").getAsString());
    }

    @Test
    void jsonAloneWritesNoFiles() throws IOException {
        Set<String> before = names(folder);
        CommandCall call = check("--detections", corners, "--json", "--target", 5);
        assertEquals(0, call.code(), call.err());
        assertEquals(1, JsonParser.parseString(call.out()).getAsJsonObject().get("schema").getAsInt());
        assertEquals(before, names(folder));
        assertFalse(Files.exists(Path.of("cellgauge-out")));
    }

    /** One line for each input, whatever became of it and however it was named; the first one refused, too. */
    @Test
    void jsonHasALineOfOneShapeForEveryInput() throws IOException {
        Path photos = Files.createDirectories(folder.resolve("photos"));
        Files.write(photos.resolve("cut.png"), new byte[] {(byte) 0x89, 'P', 'N', 'G'});
        Path faulty = Files.writeString(folder.resolve("faulty.json"), "{");
        CommandCall call = check(photos, "--detections", faulty, corners, "--json", "--target", 5);
        assertEquals(3, call.code());
        List<JsonObject> lines = call.out().lines().map(l -> JsonParser.parseString(l).getAsJsonObject()).toList();
        assertEquals(List.of("cut.png", "faulty.json", "corners.json"), lines.stream()
                .map(l -> l.getAsJsonObject("input").get("name").getAsString()).toList());
        assertEquals(List.of("refused", "refused", "pass"), lines.stream().map(l -> l.get("verdict").getAsString())
                .toList());
        JsonObject refusal = lines.get(1).getAsJsonObject("refusal");
        assertEquals("detections-cut-short", refusal.get("code").getAsString());
        assertEquals(faulty.toString(), refusal.get("file").getAsString());
        assertEquals(1, refusal.get("line").getAsInt());
        assertTrue(call.err().contains(lines.get(1).get("reason").getAsString()), call.err());
        CommandCall alone = check("--detections", corners, "--json", "--target", 5);
        assertEquals(lines.get(2), JsonParser.parseString(alone.out()));
        CommandCall refused = check("--detections", faulty, "--json");
        assertEquals(3, refused.code());
        assertEquals(lines.get(1), JsonParser.parseString(refused.out()));
    }

    /** What a stored result says under another target is what a check with that target says. */
    @Test
    void aChangedTargetIsJudgedWithoutSampling() throws IOException {
        check("--detections", corners, "--target", 5, "--out", out);
        Map<String, String> before = contents(out);
        Path fresh = folder.resolve("fresh");
        check("--detections", corners, "--target", 0.3, "--out", fresh);
        Files.writeString(cell, Files.readString(cell).replace("target: {std_mm: 2.0}", "target: {std_mm: 0.3}"));
        CommandCall call = check("--detections", corners, "--rejudge", "--out", out);
        assertEquals(4, call.code(), call.err());
        JsonObject judged = json(out.resolve("corners.result.json"));
        JsonObject expected = json(fresh.resolve("corners.result.json"));
        assertEquals(expected.get("date"), judged.remove("judged_on"));
        assertNotEquals(expected.remove("cell"), judged.remove("cell"));
        for (JsonObject result : List.of(judged, expected)) {
            // the target stands in the cell file in place of an option
            assertTrue(result.remove("command").getAsString().startsWith("cellgauge check --cell "));
            result.getAsJsonObject("settings").remove("target_std_mm");
        }
        assertEquals(expected, judged);
        Map<String, String> after = contents(out);
        assertEquals(contents(fresh).get("corners.overlay.png"), after.get("corners.overlay.png"));
        assertEquals(before.get("corners.chain-1.csv"), after.get("corners.chain-1.csv"));
        assertTrue(after.get("summary.csv").contains(",fail,"), after.get("summary.csv"));
        assertTrue(after.get("report.html").contains("TARGET MISSED") || after.get("report.html").contains("FAIL"));

        // what is of something else is refused, and stays
        assertRefused("other settings", check("--detections", corners, "--rejudge", "--seed", 2, "--out", out));
        assertRefused("no result of this input is in " + fresh + "/none", check("--detections", corners, "--rejudge",
                "--out", fresh.resolve("none")));
        Files.writeString(cell, Files.readString(cell).replace("[1, 1, 1], std_deg", "[2, 1, 1], std_deg"));
        assertRefused("of another cell", check("--detections", corners, "--rejudge", "--out", out));
        SmallCell.writeDetections(corners, 2);
        assertRefused("of another file of this name", check("--detections", corners, "--rejudge", "--out", out));
        assertEquals(after.get("corners.result.json"), contents(out).get("corners.result.json"));
    }

    private static void assertRefused(String why, CommandCall call) {
        assertEquals(3, call.code(), call.err());
        assertTrue(call.err().contains(why), call.err());
    }

    @Test
    void unknownIntrinsicsHaveTheirOwnKey() throws IOException {
        check("--detections", corners, "--estimate", "focal", "--iterations", 400, "--out", out);
        JsonObject intrinsics = json(out.resolve("corners.result.json")).getAsJsonObject("intrinsics");
        assertEquals("[\"fx_px\",\"fy_px\"]", intrinsics.get("names").toString());
        double[][] covariance = matrix(intrinsics.get("covariance"));
        assertEquals(Math.sqrt(covariance[1][1]), numbers(intrinsics.get("std"))[1], 1e-12);
        assertEquals(600, numbers(intrinsics.get("mean"))[0], 4 * numbers(intrinsics.get("std"))[0]);
    }

    @Test
    void thesisPresetSetsAllAndOptionsBesideItStillCount() throws IOException {
        check("--detections", corners, "--preset", "thesis", "--chains", 2, "--iterations", 6000, "--out", out);
        JsonObject settings = json(out.resolve("corners.result.json")).getAsJsonObject("settings");
        assertEquals("corner-cube", settings.get("model").getAsString());
        assertEquals("thesis-mixture", settings.get("sampler").getAsString());
        assertEquals("average", settings.get("initial").getAsString());
        assertEquals("none", settings.get("object_noise").getAsString());
        assertEquals(0.5, settings.get("kappa").getAsDouble());
        assertEquals(2, settings.get("chains").getAsInt());
        assertEquals(6000, settings.get("iterations").getAsInt());
        assertEquals(5000, settings.get("warmup").getAsInt());
        assertTrue(names(out).contains("corners.chain-2.csv"));
    }

    @Test
    void whatDoesNotExistIsNull() throws IOException {
        // 10 kept draws are too few for effective sample sizes
        check("--detections", corners, "--iterations", 20, "--warmup", 10, "--out", out);
        String text = Files.readString(out.resolve("corners.result.json"));
        assertFalse(text.contains("NaN") || text.contains("Infinity"), text);
        assertTrue(json(out.resolve("corners.result.json")).getAsJsonObject("diagnostics").get("ess_bulk_min")
                .isJsonNull());
    }

    // ---- the chains beside Laplace's approximation

    @Test
    void theReportSaysByHowMuchTheChainsCorrectLaplacesApproximation() throws IOException {
        CommandCall call = check("--detections", corners, "--target", 5, "--out", out);
        JsonObject result = json(out.resolve("corners.result.json"));
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        double farthest = 0;
        for (String id : List.of("5", "20")) {
            JsonObject laplace = result.getAsJsonObject("laplace").getAsJsonObject("objects").getAsJsonObject(id);
            JsonObject object = result.getAsJsonObject("objects").getAsJsonObject(id);
            for (String prefix : id.equals("20") ? List.of("", "grip_") : List.of("")) {
                JsonObject sampled = object.getAsJsonObject(prefix.isEmpty() ? "pose" : "grip");
                for (int i = 0; i < 3; i++) {
                    double std = numbers(laplace.get(prefix + "std"))[i];
                    double ratio = numbers(sampled.get("std"))[i] / std;
                    double shift = (numbers(sampled.get("mean"))[i] - numbers(laplace.get(prefix + "mean"))[i]) / std;
                    assertEquals(ratio, numbers(laplace.get(prefix + "sampled_by_laplace"))[i], 1e-12);
                    assertEquals(shift, numbers(laplace.get(prefix + "mean_shift_by_std"))[i], 1e-9);
                    least = Math.min(least, ratio);
                    most = Math.max(most, ratio);
                    farthest = Math.max(farthest, Math.abs(shift));
                }
            }
        }
        // a nearly Gaussian posterior: what is left is Monte Carlo error, 2 % of each deviation
        assertTrue(least > 0.9 && most < 1.1 && farthest < 0.2, least + ", " + most + ", " + farthest);
        String line = call.out().replaceAll("\\s+", " ");
        assertTrue(line.contains(String.format(Locale.ROOT, "Chains against Laplace's approximation: std %.2f (",
                least)), line);
        assertTrue(line.contains(String.format(Locale.ROOT, ") to %.2f (", most)), line);
        assertTrue(line.contains(String.format(Locale.ROOT, ") times as large, means up to %.2f std apart (",
                farthest)), line);
        assertTrue(Files.readString(out.resolve("report.html")).contains("Chains against Laplace&#39;s approximation"));
    }

    // ---- references against each other

    /** The cell file has reference 911 by 12 mm beside where the photo shows it, with a stated precision of 1 mm. */
    private void misplace911() throws IOException {
        Files.writeString(cell, SmallCell.YAML.replace("911: {position_mm: [400, 0, 0]",
                "911: {position_mm: [400, 12, 0]"));
    }

    @Test
    void everyReferenceHasItsFigures() throws IOException {
        assertEquals(0, check("--detections", corners, "--target", 5, "--out", out).code());
        JsonObject result = json(out.resolve("corners.result.json"));
        JsonObject references = result.getAsJsonObject("references");
        assertEquals(Set.of("944", "22", "911", "1234"), references.keySet());
        assertEquals(0, result.getAsJsonArray("misplaced_references").size());
        assertFalse(result.has("without_misplaced"));
        JsonObject fit = result.getAsJsonObject("noise").getAsJsonObject("fit");
        assertTrue(fit.get("holds").getAsBoolean());
        JsonObject together = fit.getAsJsonObject("references");
        assertTrue(together.get("holds").getAsBoolean());
        assertEquals(18, together.get("degrees_of_freedom").getAsInt());
        assertTrue(together.get("chi_square").getAsDouble() > 0 && together.get("p").getAsDouble() > 0.001);
        for (JsonElement e : references.asMap().values()) {
            JsonObject reference = e.getAsJsonObject();
            assertTrue(reference.get("used").getAsBoolean());
            assertFalse(reference.get("misplaced").getAsBoolean());
            int degrees = reference.get("degrees_of_freedom").getAsInt();
            assertEquals(8, degrees);
            double chiSquare = reference.get("chi_square").getAsDouble();
            assertEquals(Math.sqrt(chiSquare / degrees), reference.get("normalised_residual").getAsDouble(), 1e-12);
            assertTrue(reference.get("p_value").getAsDouble() > 1e-4);
            assertEquals("[\"x_mm\",\"y_mm\",\"z_mm\",\"wx_rad\",\"wy_rad\",\"wz_rad\"]",
                    reference.get("order").toString());
            double[] statistic = numbers(reference.get("statistic"));
            double[] offset = numbers(reference.get("offset"));
            double[] std = numbers(reference.get("offset_std"));
            double[] limit = numbers(reference.get("limit"));
            double[] detectable = numbers(reference.get("detectable"));
            for (int i = 0; i < 6; i++) {
                assertEquals(statistic[i], offset[i] / std[i], 1e-9);
                assertTrue(Math.abs(statistic[i]) < limit[i]);
                assertTrue(detectable[i] > limit[i] * std[i], "to be beyond the limit it must be farther off");
            }
            // stated to 1 mm and 0.2 degrees: what is seen of it is never more precise
            assertTrue(std[0] > 1 && std[5] > Math.toRadians(0.2));
        }
    }

    @Test
    void aMisplacedReferenceIsNamedWithTheObjectsThatDependOnIt() throws IOException {
        misplace911();
        CommandCall call = check("--detections", corners, "--target", 3, "--out", out);
        assertEquals(4, call.code(), call.out());
        JsonObject result = json(out.resolve("corners.result.json"));
        assertTrue(result.getAsJsonObject("references").getAsJsonObject("911").get("misplaced").getAsBoolean());
        JsonObject found = result.getAsJsonArray("misplaced_references").get(0).getAsJsonObject();
        assertEquals(911, found.get("id").getAsInt());
        assertTrue(found.get("statistic").getAsDouble() < -found.get("limit").getAsDouble());
        // it stands at 0 where the file has 12
        assertEquals(-12, numbers(found.get("offset"))[1], 3);
        JsonObject without = result.getAsJsonObject("without_misplaced");
        assertEquals("[911]", without.get("left_out").toString());
        assertPose(without.getAsJsonObject("camera"));
        JsonObject objects = without.getAsJsonObject("objects");
        assertEquals(Set.of("5", "20"), objects.keySet());
        JsonObject grip = objects.getAsJsonObject("20").getAsJsonObject("grip");
        double[] truth = RigidTransform.ofEuler(110, 150, 0, 0, 0.4, -0.2).apply(0, 0, 100);
        for (int i = 0; i < 3; i++) {
            double std = numbers(grip.get("std"))[i];
            assertEquals(truth[i], numbers(grip.get("mean"))[i], 3 * std);
            assertEquals(Math.hypot(std, numbers(grip.get("move_mm"))[i]), numbers(grip.get("error_mm"))[i], 1e-12);
        }
        String reason = result.get("reason").getAsString();
        assertTrue(reason.contains("But reference 911 seems misplaced: if so, the largest error is"), reason);
        boolean missed = false;
        for (JsonElement object : result.getAsJsonObject("objects").asMap().values()) {
            missed |= !object.getAsJsonObject().get("within_target").getAsBoolean();
            assertTrue(object.getAsJsonObject().get("worst_std_mm").getAsDouble() < 3);
        }
        assertTrue(missed, "an object must say that the target is missed");

        String text = call.out();
        assertTrue(text.lines().anyMatch(l -> l.matches("  reference 911 .*SEEMS OFF")), text);
        assertTrue(text.lines().noneMatch(l -> l.matches("  reference 944 .*SEEMS OFF")), text);
        assertTrue(text.contains("Without reference 911, by Laplace's approximation, mm"), text);
        assertTrue(text.replaceAll("\\s+", " ").contains("- reference 911 seems off by about -1"), text);
        assertTrue(text.lines().anyMatch(l -> l.matches("  (object 5|object 20|  its gripping point) .*FAIL")), text);
        String report = Files.readString(out.resolve("report.html"));
        assertTrue(report.contains("Without reference 911, by Laplace&#39;s approximation, mm"), "table of the report");
        assertTrue(report.contains("seems off</span>"), "mark of the report");
        List<String> lines = Files.readAllLines(out.resolve("summary.csv"));
        int within = Arrays.asList(lines.get(0).split(",")).indexOf("within_target");
        assertTrue(lines.stream().skip(1).anyMatch(l -> l.split(",")[within].equals("false")), lines.toString());
    }

    // ---- corners against their stated noise

    /** The cell file states a tenth of the noise that the corners have: nothing meets a target on that. */
    @Test
    void aNoiseThatCornersContradictMeetsNoTarget() throws IOException {
        Files.writeString(cell, SmallCell.YAML.replace("pixel_std_px: 0.05", "pixel_std_px: 0.005"));
        CommandCall call = check("--detections", corners, "--target", 5, "--out", out);
        assertEquals(4, call.code(), call.out());
        JsonObject result = json(out.resolve("corners.result.json"));
        assertEquals("fail", result.get("verdict").getAsString());
        assertTrue(result.get("decided").getAsBoolean());
        assertTrue(result.get("reason").getAsString().contains(" times noisier than the stated 0.005 px: "));
        assertFalse(result.getAsJsonObject("objects").getAsJsonObject("5").get("within_target").getAsBoolean());
        assertEquals(0, result.getAsJsonArray("misplaced_references").size());
        JsonObject fit = result.getAsJsonObject("noise").getAsJsonObject("fit");
        assertFalse(fit.get("holds").getAsBoolean());
        // two for each of six markers
        assertEquals(12, fit.get("degrees_of_freedom").getAsInt());
        assertEquals(0.005 * Math.sqrt(fit.get("chi_square").getAsDouble() / 12), fit.get("shown_std_px").getAsDouble(),
                1e-12);
        // made with 0.05 px; chi-square of 12 tells that to a factor of two
        assertEquals(0.05, fit.get("shown_std_px").getAsDouble(), 0.025);
        assertTrue(fit.get("p").getAsDouble() < 1e-6);
        String text = call.out();
        assertTrue(text.replaceAll("\\s+", " ").matches(".* px as stated; markers are square to 0\\.[0-9]{3} px "
                + "\\(chi-square [0-9.]+ of 12, p below 0\\.001\\): NOT AS STATED References together: .*"), text);
        assertTrue(text.lines().noneMatch(l -> l.matches("  (object 5|object 20|  its gripping point) .*pass")), text);
        String report = Files.readString(out.resolve("report.html"));
        assertTrue(report.contains(": NOT AS STATED"), "noise of the report");
        List<String> lines = Files.readAllLines(out.resolve("summary.csv"));
        int within = Arrays.asList(lines.get(0).split(",")).indexOf("within_target");
        assertTrue(lines.stream().skip(1).allMatch(l -> l.split(",")[within].equals("false")), lines.toString());
    }

    @Test
    void aReferenceThatWasNotSeenHasNoFigures() throws IOException {
        Files.writeString(corners, Files.readString(corners).replace("\"id\": 22,", "\"id\": 23,"));
        check("--detections", corners, "--out", out);
        JsonObject references = json(out.resolve("corners.result.json")).getAsJsonObject("references");
        assertEquals("{\"used\":false}", references.getAsJsonObject("22").toString());
        assertTrue(references.getAsJsonObject("944").get("used").getAsBoolean());
    }

    // ---- reproducibility

    @Test
    void theSameSeedGivesTheSameFilesForAnyNumberOfThreads() throws IOException {
        check("--detections", corners, "--seed", 3, "--threads", 1, "--out", out);
        Path second = folder.resolve("second");
        check("--detections", corners, "--seed", 3, "--threads", 2, "--out", second);
        assertEquals(contents(out), contents(second));
        check("--detections", corners, "--seed", 4, "--threads", 2, "--out", second);
        assertNotEquals(contents(out).get("corners.chain-1.csv"), contents(second).get("corners.chain-1.csv"));
    }

    // ---- files

    @Test
    void aPhotoIsCheckedFromItsPixelsOn() throws IOException {
        SmallCell.writePhotos(cell, folder, "photo", 1);
        CommandCall call = check(folder.resolve("photo.png"), "--target", 5, "--out", out);
        assertEquals(0, call.code(), call.err());
        assertEquals(Set.of("photo.result.json", "photo.overlay.png", "photo.chain-1.csv", "photo.chain-2.csv",
                "photo.chain-3.csv", "photo.chain-4.csv", "report.html", "summary.csv"), names(out));
        BufferedImage overlay = ImageIO.read(out.resolve("photo.overlay.png").toFile());
        assertEquals(SmallCell.WIDTH, overlay.getWidth());
        assertEquals(SmallCell.HEIGHT, overlay.getHeight());
    }

    @Test
    void chainsAreStanCsvOfTheDrawsThatWereKept() throws IOException {
        check("--detections", corners, "--iterations", 300, "--warmup", 100, "--chains", 2, "--out", out);
        JsonObject result = json(out.resolve("corners.result.json"));
        List<String> expected = new ArrayList<>(result.getAsJsonObject("diagnostics").getAsJsonObject("parameters")
                .keySet());
        double sum = 0;
        for (int chain = 1; chain <= 2; chain++) {
            List<String> lines = Files.readAllLines(out.resolve("corners.chain-" + chain + ".csv"));
            List<String> comments = lines.stream().filter(l -> l.startsWith("#")).toList();
            assertTrue(comments.stream().anyMatch(l -> l.matches("# *num_samples = 200")));
            assertTrue(comments.contains("# id = " + chain));
            // CmdStanPy takes a file without them for a torn one
            assertEquals(List.of("# ", "#  Elapsed Time: 0 seconds (Warm-up)", "#                0 seconds (Sampling)",
                    "#                0 seconds (Total)", "# "), lines.subList(lines.size() - 5, lines.size()));
            List<String> data = lines.stream().filter(l -> !l.startsWith("#")).toList();
            assertEquals(expected, Arrays.asList(data.get(0).split(",")));
            assertEquals("lp__", data.get(0).split(",")[0]);
            assertEquals(1 + 200, data.size());
            int x = expected.indexOf("camera_x_mm");
            int psi = expected.indexOf("camera_psi_rad");
            for (String line : data.subList(1, data.size())) {
                String[] values = line.split(",");
                assertEquals(expected.size(), values.length);
                sum += Double.parseDouble(values[x]);
                double angle = Double.parseDouble(values[psi]);
                assertTrue(angle > -Math.PI && angle <= Math.PI);
            }
        }
        // the same draws as the result's: to the rounding of a sum of 400 numbers
        assertEquals(numbers(result.getAsJsonObject("camera").get("mean"))[0], sum / 400, 1e-9);
        assertFalse(names(out).contains("corners.chain-3.csv"));
    }

    @Test
    void aRunWithFewerChainsLeavesNoneOfAnEarlierOne() throws IOException {
        check("--detections", corners, "--iterations", 100, "--chains", 3, "--out", out);
        check("--detections", corners, "--iterations", 100, "--chains", 1, "--out", out);
        assertTrue(names(out).contains("corners.chain-1.csv"));
        assertFalse(names(out).contains("corners.chain-2.csv"));
        check("--detections", corners, "--iterations", 100, "--chains", 1, "--no-draws", "--out", out);
        assertFalse(names(out).contains("corners.chain-1.csv"));
        assertTrue(names(out).contains("corners.result.json"));
        assertFalse(names(out).contains("corners.chain-3.csv"));
    }

    @Test
    void summaryHasARowForEveryPhotoAndObject() throws IOException {
        Path other = SmallCell.writeDetections(folder.resolve("other.json"), 2);
        Path faulty = Files.writeString(folder.resolve("faulty, \"quoted\".json"), "{");
        check("--detections", corners, faulty, other, "--target", 5, "--out", out);
        List<String> lines = Files.readAllLines(out.resolve("summary.csv"));
        assertEquals(1 + 2 + 1 + 2, lines.size());
        List<String> header = Arrays.asList(lines.get(0).split(","));
        String[] row = lines.get(2).split(",");
        assertEquals("corners", row[header.indexOf("name")]);
        assertEquals("20", row[header.indexOf("object")]);
        assertEquals("true", row[header.indexOf("within_target")]);
        double[] mean = numbers(json(out.resolve("corners.result.json")).getAsJsonObject("objects")
                .getAsJsonObject("20").getAsJsonObject("pose").get("mean"));
        assertEquals(mean[2], Double.parseDouble(row[header.indexOf("z_mm")]), 0);
        assertTrue(lines.get(3).contains("\"faulty, \"\"quoted\"\"\",refused,"), lines.get(3));
    }

    @Test
    void theReportHoldsAllItShows() throws Exception {
        SmallCell.writePhotos(cell, folder, "a<b", 1);
        check(folder.resolve("a<b.png"), "--detections", corners, "--target", 5, "--out", out);
        String report = Files.readString(out.resolve("report.html"));
        assertTrue(report.contains("data:image/jpeg;base64,/9j/"), "no picture in it");
        assertTrue(report.contains("a&lt;b") && !report.contains("a<b"), "names must be escaped");
        assertTrue(report.contains("<pre>cellgauge check --cell " + cell + " --target 5 &#39;" + folder
                + "/a&lt;b.png&#39;</pre>"), "command that repeats it");
        for (Setting<?> setting : SettingTable.all()) {
            assertEquals(setting.determinesFigures(), report.contains("<tr><td>" + setting.name().replace('-', ' ')
                    + "</td><td class=\"text\">"), setting.name());
        }
        assertTrue(report.contains("<tr><td>target</td><td class=\"text\">5 mm</td></tr>"), "its settings");
        // nothing that has to be opened before it is printed but the diagnostics of every quantity
        assertEquals(2, report.split("<details>", -1).length - 1);
        JsonObject result = json(out.resolve("corners.result.json"));
        for (String key : List.of("input", "cell", "camera_file")) {
            String sha256 = result.getAsJsonObject(key).get("sha256").getAsString();
            assertTrue(report.contains(sha256), key);
        }
        assertEquals(HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(cell))),
                result.getAsJsonObject("cell").get("sha256").getAsString());
        assertTrue(report.contains("<td>date</td><td class=\"text\">" + result.get("date").getAsString() + "</td>"));
        double[] std = numbers(result.getAsJsonObject("objects").getAsJsonObject("5").getAsJsonObject("pose")
                .get("std"));
        assertTrue(report.contains("<td data-of=\"std psi\">" + String.format(Locale.ROOT, "%.4f",
                Math.toDegrees(std[3])) + "</td>"), "orientation with its deviation");
        assertTrue(report.contains("Over the photos"), "trend of two inputs");
        for (String outside : List.of("http:", "https:", "src=\"/", "<script", "<link", "@import", "url(")) {
            assertFalse(report.contains(outside), outside);
        }
    }

    @Test
    void aPhotoBesideItsDetectionsIsTheGroundOfTheOverlay() throws IOException {
        SmallCell.writePhotos(cell, folder, "none", 1);      // the name that the detections file states
        check("--detections", corners, "--iterations", 100, "--out", out);
        BufferedImage with = ImageIO.read(out.resolve("corners.overlay.png").toFile());
        Files.delete(folder.resolve("none.png"));
        check("--detections", corners, "--iterations", 100, "--again", "--out", out);
        BufferedImage without = ImageIO.read(out.resolve("corners.overlay.png").toFile());
        int differing = 0;
        for (int y = 0; y < with.getHeight(); y++) {
            for (int x = 0; x < with.getWidth(); x++) {
                differing += with.getRGB(x, y) != without.getRGB(x, y) ? 1 : 0;
            }
        }
        assertTrue(differing > with.getWidth() * with.getHeight() / 2, differing + " pixels differ");
    }

    // ---- batches

    /** Two markers carry each other's ids: no figure, and every overview says what to do. */
    @Test
    void aBatchOfExchangedReferencesPassesNothingAndSaysWhatToDo() throws IOException {
        Path other = SmallCell.writeDetections(folder.resolve("other.json"), 2);
        for (Path file : List.of(corners, other)) {
            Files.writeString(file, Files.readString(file).replace("\"id\": 944,", "\"id\": -1,")
                    .replace("\"id\": 911,", "\"id\": 944,").replace("\"id\": -1,", "\"id\": 911,"));
        }
        CommandCall call = check("--detections", corners, other, "--target", 50, "--out", out);
        assertEquals(5, call.code(), call.out());
        String text = call.out().replaceAll("\\s+", " ");
        assertTrue(text.contains("2 photos: 2 CONTRADICTED"), text);
        assertTrue(text.matches(".* corners and other: references (911 and 944|944 and 911) seem exchanged.*"), text);
        List<String> lines = Files.readAllLines(out.resolve("summary.csv"));
        List<String> header = Arrays.asList(lines.get(0).split(","));
        for (String line : lines.subList(1, lines.size())) {
            assertTrue(line.contains(",contradicted,") && line.endsWith(" exchange their ids or their markers"), line);
            assertEquals("", line.split(",")[header.indexOf("std_x_mm")], "no figure");
        }
        assertTrue(Files.readString(out.resolve("report.html")).contains("seem exchanged"), "report");
        JsonObject result = json(out.resolve("corners.result.json"));
        assertEquals("exchanged", result.getAsJsonArray("causes").get(0).getAsJsonObject().get("cause").getAsString());
        assertTrue(result.get("action").getAsString().contains("seem exchanged"), "action");
    }

    @Test
    void oneBadPhotoCostsTheOthersNothing() throws IOException {
        Path photos = folder.resolve("photos");
        SmallCell.writePhotos(cell, photos, "photo", 2);
        byte[] first = Files.readAllBytes(photos.resolve("photo-1.png"));
        Files.write(photos.resolve("photo-0.png"), Arrays.copyOf(first, first.length / 2));
        CommandCall call = check(photos, "--target", 5, "--out", out);
        assertEquals(3, call.code(), call.err());
        assertTrue(names(out).containsAll(Set.of("photo-1.result.json", "photo-2.result.json", "report.html",
                "summary.csv")));
        assertFalse(names(out).contains("photo-0.result.json"));
        assertTrue(call.err().contains("photo-0.png: it is cut short"), call.err());
        assertTrue(call.err().contains("[3/3] photo-2: pass"), call.err());
        assertTrue(call.out().contains("3 photos: 1 refused, 2 pass"), call.out());
    }

    @Test
    void inputsOfOneNameAreToldApart() throws IOException {
        Path other = SmallCell.writeDetections(Files.createDirectories(folder.resolve("b")).resolve("corners.json"), 2);
        Path taken = SmallCell.writeDetections(folder.resolve("corners-2.json"), 3);
        CommandCall call = check("--detections", corners, other, taken, "--iterations", 100, "--out", out);
        assertTrue(names(out).containsAll(Set.of("corners.result.json", "corners-2.result.json",
                "corners-3.result.json")), names(out).toString());
        assertTrue(call.err().contains(other + " are called corners-3"), call.err());
        assertNotEquals(json(out.resolve("corners.result.json")).get("input"),
                json(out.resolve("corners-3.result.json")).get("input"));
    }

    @Test
    void photosOfAFolderComeInTheOrderOfTheirNumbers() throws IOException {
        for (String name : List.of("p10.png", "p9.png", "p1.png")) {
            Files.write(folder.resolve(name), new byte[0]);
        }
        CommandCall call = check(folder, "--out", out);
        assertEquals(List.of("p1", "p9", "p10"), call.out().lines().map(l -> l.split(" ")[0])
                .filter(word -> word.matches("p\\d+")).toList());
    }

    @Test
    void aFileNamedTwiceIsCheckedOnce() throws IOException {
        CommandCall call = check("--detections", corners, corners, "--iterations", 100, "--out", out);
        assertTrue(call.err().contains("named twice"), call.err());
        assertFalse(names(out).contains("corners-2.result.json"));
    }

    @Test
    void overlaysOfAnEarlierRunAreNoPhotos() throws IOException {
        Path photos = folder.resolve("photos");
        SmallCell.writePhotos(cell, photos, "photo", 1);
        check(photos, "--iterations", 100, "--out", photos);
        CommandCall again = check(photos, "--iterations", 100, "--out", photos);
        assertTrue(again.out().contains("1 photo: "), again.out());
    }

    // ---- what people read

    @Test
    void theTableNamesWhatWasNotSeen() throws IOException {
        String text = Files.readString(corners);
        Files.writeString(corners, text.replace("\"id\": 20,", "\"id\": 21,"));
        CommandCall call = check("--detections", corners, "--target", 5, "--out", out);
        assertEquals(4, call.code(), call.err());
        assertTrue(call.out().lines().anyMatch(l -> l.matches(" *object 20 .*not seen")), call.out());
        assertTrue(call.out().contains("not in the cell file: 21"), call.out());
    }

    @Test
    void theTableFitsATerminalOf100ColumnsAndIsPlainText() throws IOException {
        CommandCall call = check("--detections", corners, "--out", out);
        call.out().lines().filter(l -> !l.contains(corners.toString()))
                .forEach(l -> assertTrue(l.length() <= 100, l.length() + ": " + l));
        assertTrue(call.out().chars().allMatch(c -> c == '\n' || c >= ' ' && c < 0x7F), call.out());
    }

    @Test
    void helpShowsExamplesAndExitCodes() {
        CommandCall call = CommandCall.of("check", "--help");
        assertEquals(0, call.code());
        assertTrue(call.out().contains("cellgauge check --cell cell.yaml photo.png"), call.out());
        assertTrue(call.out().contains("Exit codes"), call.out());
        assertTrue(CommandCall.of("--help").out().contains("check"));
    }

    @Test
    void debugTellsHowLongTheStagesTake() {
        CommandCall call = check("--detections", corners, "--iterations", 100, "--json", "--debug");
        assertTrue(call.err().lines().anyMatch(l -> l.matches("Time: .*detections file \\d+ ms.*check \\d+ ms.*")),
                call.err());
        assertArrayEquals(new String[0], check("--detections", corners, "--iterations", 100, "--json").err().lines()
                .toArray());
    }
}
