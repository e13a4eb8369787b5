package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonParser;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every fault a user can make ends in one message that names place and remedy, and in the right exit code. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class CheckFaultsTest {
    private static final String PLAIN = "--cell cell.yaml --detections good.json";

    @TempDir
    static Path folder;

    /**
     * A fault.
     *
     * @param args arguments after {@code check}; names of files stand in the folder of the test
     * @param code exit code expected
     * @param words all of them must be in the message
     */
    record Fault(String args, int code, String... words) {
        @Override
        public String toString() {
            return args;
        }
    }

    @BeforeAll
    static void writeFiles() throws IOException {
        SmallCell.write(folder);
        SmallCell.writePhotos(folder.resolve("cell.yaml"), folder, "photo", 1);
        SmallCell.writeDetections(folder.resolve("good.json"), 1);

        // cell files
        cell("no-camera.yaml", "camera: camera.yaml", "camera: nowhere.yaml");
        cell("bad-camera.yaml", "camera: camera.yaml", "camera: cell.yaml");
        cell("typo.yaml", "pixel_std_px", "pixel_std");
        cell("twice.yaml", "  22: {", "  944: {");
        cell("both.yaml", "  5: {}", "  22: {}");
        cell("size.yaml", "size_mm: 100", "size_mm: -100");
        cell("std.yaml", "std_mm: [1, 1, 1]", "std_mm: [1, -1, 1]");
        cell("family.yaml", "square-binary", "square-binry");
        cell("id.yaml", "  5: {}", "  4097: {}");
        cell("version.yaml", "cellgauge: 1", "cellgauge: 2");
        cell("focal.yaml", "camera: camera.yaml", "camera: {model: pinhole, pinhole: {fx: 0, fy: 600, cx: 320, "
                + "cy: 240, width: 640, height: 480}}");
        cell("larger.yaml", "camera: camera.yaml", "camera: {model: pinhole, pinhole: {fx: 1200, fy: 1200, cx: 640, "
                + "cy: 480, width: 1280, height: 960}}");
        cell("others.yaml", "  944: {", "  945: {", "  22: {", "  23: {", "  911: {", "  912: {", "  1234: {",
                "  1235: {");
        Files.writeString(folder.resolve("broken.yaml"), "cellgauge: [1\n");
        Files.write(folder.resolve("empty.yaml"), new byte[0]);
        Files.write(folder.resolve("binary.yaml"), new byte[] {0, 1, 2, (byte) 0xFE, (byte) 0xC0});

        // images
        byte[] png = Files.readAllBytes(folder.resolve("photo.png"));
        Files.write(folder.resolve("cut.png"), Arrays.copyOf(png, png.length / 2));
        ByteArrayOutputStream jpeg = new ByteArrayOutputStream();
        ImageIO.write(ImageIO.read(folder.resolve("photo.png").toFile()), "jpeg", jpeg);
        Files.write(folder.resolve("cut.jpg"), Arrays.copyOf(jpeg.toByteArray(), jpeg.size() / 2));
        Files.write(folder.resolve("empty.png"), new byte[0]);
        Files.writeString(folder.resolve("text.png"), "no picture at all");
        Files.write(folder.resolve("huge.png"), announcing(60_000, 60_000));
        picture("small.png", 320, 240);
        picture("turned.png", 480, 640);
        picture("blank.png", 640, 480);
        Files.createDirectories(folder.resolve("no-photos"));

        // detections files
        String good = Files.readString(folder.resolve("good.json"));
        Files.writeString(folder.resolve("cut.json"), good.substring(0, good.length() / 2));
        Files.writeString(folder.resolve("key.json"), good.replaceFirst("corners_px", "corner_px"));
        Files.writeString(folder.resolve("text.json"), good.replaceFirst("\"width\": 640", "\"width\": \"wide\""));
        Files.writeString(folder.resolve("size.json"), good.replace("640", "800").replace("480", "600"));
        Files.writeString(folder.resolve("nan.json"), good.replaceFirst("\\[\\[[0-9.]+", "[[NaN"));
        Files.writeString(folder.resolve("none.json"),
                "{\"image\": {\"width\": 640, \"height\": 480}, \"markers\": []}");
        Files.writeString(folder.resolve("twice.json"), good.replace("\"id\": 22,", "\"id\": 944,"));
        Files.write(folder.resolve("empty.json"), new byte[0]);

        // folders
        Files.writeString(folder.resolve("file"), "in the way");
    }

    private static void cell(String name, String... replacements) throws IOException {
        String text = SmallCell.YAML;
        for (int i = 0; i < replacements.length; i += 2) {
            assertTrue(text.contains(replacements[i]), replacements[i]);
            text = text.replace(replacements[i], replacements[i + 1]);
        }
        Files.writeString(folder.resolve(name), text);
    }

    private static void picture(String name, int width, int height) throws IOException {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_GRAY);
        Random random = new Random(5);
        for (int i = 0; i < width * height; i++) {
            image.getRaster().setSample(i % width, i / width, 0, 120 + random.nextInt(10));
        }
        ImageIO.write(image, "png", folder.resolve(name).toFile());
    }

    /** A PNG of a few bytes whose header announces a size (PNG specification, section 11.2.2). */
    private static byte[] announcing(int width, int height) throws IOException {
        ByteArrayOutputStream header = new ByteArrayOutputStream();
        DataOutputStream data = new DataOutputStream(header);
        data.writeBytes("IHDR");
        data.writeInt(width);
        data.writeInt(height);
        data.write(new byte[] {8, 2, 0, 0, 0});
        CRC32 crc = new CRC32();
        crc.update(header.toByteArray());
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(png);
        out.write(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'});
        out.writeInt(13);
        out.write(header.toByteArray());
        out.writeInt((int) crc.getValue());
        return png.toByteArray();
    }

    static List<Fault> faults() {
        return List.of(
                // the cell and its camera
                new Fault("--cell missing.yaml good.json", 3, "missing.yaml", "no such file"),
                new Fault("--cell no-photos good.json", 3, "no-photos", "folder"),
                new Fault("--cell empty.yaml good.json", 3, "empty.yaml"),
                new Fault("--cell broken.yaml good.json", 3, "broken.yaml", "line 2", "YAML"),
                new Fault("--cell binary.yaml good.json", 3, "binary.yaml", "UTF-8"),
                new Fault("--cell typo.yaml good.json", 3, "typo.yaml", "did you mean \"pixel_std_px\""),
                new Fault("--cell twice.yaml good.json", 3, "twice.yaml", "944"),
                new Fault("--cell both.yaml good.json", 3, "both.yaml", "22"),
                new Fault("--cell size.yaml good.json", 3, "size.yaml", "size_mm", "-100"),
                new Fault("--cell std.yaml good.json", 3, "std.yaml", "std_mm", "-1"),
                new Fault("--cell family.yaml good.json", 3, "family.yaml", "square-binary"),
                new Fault("--cell id.yaml good.json", 3, "id.yaml", "4097"),
                new Fault("--cell version.yaml good.json", 3, "version.yaml", "cellgauge"),
                new Fault("--cell no-camera.yaml good.json", 3, "no-camera.yaml", "nowhere.yaml", "no file"),
                new Fault("--cell bad-camera.yaml good.json", 3, "cell.yaml", "camera"),
                new Fault("--cell focal.yaml good.json", 3, "focal.yaml", "fx"),
                // images
                new Fault("--cell cell.yaml missing.png", 3, "missing.png", "no such file"),
                new Fault("--cell cell.yaml empty.png", 3, "empty.png", "empty"),
                new Fault("--cell cell.yaml text.png", 3, "text.png", "no image"),
                new Fault("--cell cell.yaml cut.png", 3, "cut.png", "cut short"),
                new Fault("--cell cell.yaml cut.jpg", 3, "cut.jpg", "cut short"),
                new Fault("--cell cell.yaml huge.png", 3, "huge.png", "60000 x 60000"),
                new Fault("--cell cell.yaml no-photos", 3, "no-photos", "no image in this folder"),
                new Fault("--cell cell.yaml small.png", 3, "small.png", "320 x 240", "640 x 480", "scaled"),
                new Fault("--cell cell.yaml turned.png", 3, "turned.png", "480 x 640", "turned"),
                new Fault("--cell larger.yaml photo.png", 3, "photo.png", "1280 x 960"),
                new Fault("--cell cell.yaml blank.png", 3, "blank.png", "none of the references", "944"),
                new Fault("--cell others.yaml photo.png", 3, "photo.png", "none of the references", "945"),
                // detections
                new Fault("--cell cell.yaml --detections missing.json", 3, "missing.json", "no such file"),
                new Fault("--cell cell.yaml --detections empty.json", 3, "empty.json", "empty"),
                new Fault("--cell cell.yaml --detections cut.json", 3, "cut.json", "line"),
                new Fault("--cell cell.yaml --detections key.json", 3, "key.json", "corners_px"),
                new Fault("--cell cell.yaml --detections text.json", 3, "text.json", "width"),
                new Fault("--cell cell.yaml --detections size.json", 3, "size.json", "800 x 600", "640 x 480"),
                new Fault("--cell cell.yaml --detections nan.json", 3, "nan.json", "finite"),
                new Fault("--cell cell.yaml --detections none.json", 3, "none.json", "none of the references"),
                new Fault("--cell cell.yaml --detections twice.json", 3, "twice.json", "944"),
                new Fault("--cell cell.yaml --detections photo.png", 3, "photo.png", "detections file"),
                // options
                new Fault("good.json", 2, "--cell"),
                new Fault("--cell cell.yaml", 2, "nothing to check"),
                new Fault(PLAIN + " --modle rigid-marker", 2, "--modle", "--model"),
                new Fault(PLAIN + " --model rigid", 2, "--model", "'rigid'", "rigid-marker", "corner-cube"),
                new Fault(PLAIN + " --sampler gibbs", 2, "--sampler", "'gibbs'", "independence"),
                new Fault(PLAIN + " --initial mean", 2, "--initial", "average", "ransac", "pnp"),
                new Fault(PLAIN + " --estimate lens", 2, "--estimate", "focal"),
                new Fault(PLAIN + " --preset mine", 2, "--preset", "thesis"),
                new Fault(PLAIN + " --object-noise some", 2, "--object-noise", "detection"),
                new Fault(PLAIN + " --chains 0", 2, "chains", "1"),
                new Fault(PLAIN + " --chains four", 2, "--chains", "'four'"),
                new Fault(PLAIN + " --iterations 100 --warmup 100", 2, "--warmup", "100"),
                new Fault(PLAIN + " --iterations 3", 2, "iterations"),
                new Fault(PLAIN + " --kappa 0", 2, "kappa"),
                new Fault(PLAIN + " --threads 0", 2, "threads"),
                new Fault(PLAIN + " --seed 1.5", 2, "--seed", "1.5"),
                new Fault(PLAIN + " --target -1", 2, "--target", "-1"),
                new Fault(PLAIN + " --target", 2, "--target"),
                // where results go
                new Fault(PLAIN + " --out file", 3, "file", "not a folder", "--out"),
                new Fault(PLAIN + " --out file/below", 3, "file", "not a folder", "--out"));
    }

    @ParameterizedTest
    @MethodSource("faults")
    void everyFaultHasItsMessageAndItsCode(Fault fault) {
        List<String> args = new ArrayList<>(List.of("check"));
        String previous = "";
        for (String word : fault.args().split(" ")) {
            boolean file = previous.equals("--cell") || previous.equals("--out") || word.endsWith(".json")
                    || word.endsWith(".png") || word.endsWith(".jpg") || word.equals("no-photos");
            args.add(file ? folder.resolve(word).toString() : word);
            previous = word;
        }
        if (!fault.args().contains("--out")) {
            args.add("--out");
            args.add(folder.resolve("results").toString());
        }
        CommandCall call = CommandCall.of(args.toArray(new String[0]));
        assertEquals(fault.code(), call.code(), call.err());
        for (String word : fault.words()) {
            assertTrue(call.err().contains(word), "no '" + word + "' in: " + call.err());
        }
        assertFalse(call.err().contains("Exception"), call.err());
        assertFalse(call.err().contains("\tat "), call.err());
        assertTrue(call.err().lines().count() <= 3, "more than a message: " + call.err());
        if (fault.code() == 2) {
            assertTrue(call.err().contains("--help"), call.err());
        }
    }

    @Test
    void aCallWithoutACommandIsAFaultOfUsage() {
        CommandCall call = CommandCall.of();
        assertEquals(2, call.code());
        assertTrue(call.err().contains("check"), call.err());
    }

    @Test
    void aMistypedCommandIsMetWithTheNearestOne() {
        CommandCall call = CommandCall.of("chekc");
        assertEquals(2, call.code());
        assertTrue(call.err().contains("check"), call.err());
    }

    @Test
    void aResultThatCannotBeWrittenIsStillShown() throws IOException {
        // a folder in the place of the result file: no permission is needed to make it fail, so it does for root too
        Path blocked = folder.resolve("blocked");
        Files.createDirectories(blocked.resolve("good.result.json").resolve("in-the-way"));
        CommandCall call = CommandCall.of("check", "--cell", folder.resolve("cell.yaml").toString(), "--detections",
                folder.resolve("good.json").toString(), "--target", "5", "--json", "--out", blocked.toString());
        assertEquals(3, call.code());
        assertTrue(call.err().contains("cannot be written") && call.err().contains("--out"), call.err());
        assertEquals(1, call.err().lines().count(), call.err());
        assertEquals("pass", JsonParser.parseString(call.out()).getAsJsonObject().get("verdict").getAsString());
        try (Stream<Path> files = Files.list(blocked)) {
            assertTrue(files.noneMatch(f -> f.toString().endsWith(".part")), "temporary files are left");
        }
    }

    @Test
    void aRefusedInputLeavesNothingThatLooksLikeAResult() throws IOException {
        Path out = folder.resolve("stale");
        String cell = folder.resolve("cell.yaml").toString();
        Path photo = Files.copy(folder.resolve("photo.png"), folder.resolve("once.png"));
        assertEquals(0, CommandCall.of("check", "--cell", cell, photo.toString(), "--out", out.toString()).code());
        assertTrue(Files.exists(out.resolve("once.result.json")));
        Files.write(photo, new byte[0]);
        assertEquals(3, CommandCall.of("check", "--cell", cell, photo.toString(), "--out", out.toString()).code());
        assertFalse(Files.exists(out.resolve("once.result.json")));
        assertFalse(Files.exists(out.resolve("once.chain-1.csv")));
    }
}
