package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.cellgauge.geometry.RigidTransform;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A rendered photo of a small marker seen nearly from the front, whose corners do not tell which way it is tilted. */
class AmbiguousPhotoTest {
    /** The marker of object 5, 40 mm wide, tilted by 13 degrees about x, with its gripping point 50 mm before it. */
    private static final RigidTransform TRUTH = RigidTransform.ofEuler(200, 150, 0, Math.toRadians(13), 0, 0.2);

    @TempDir
    private Path folder;

    private JsonObject check(double pixelStdPx, String name) throws IOException {
        Path cell = SmallCell.write(folder);
        Files.writeString(cell, SmallCell.YAML.replace("pixel_std_px: 0.05", "pixel_std_px: " + pixelStdPx)
                .replace("  5: {}", "  5: {size_mm: 40, grip_mm: [0, 0, 50]}")
                .replace("  20: {grip_mm: [0, 0, 100]}\n", "")
                .replace("target: {std_mm: 2.0}", "target: {std_mm: 50}"));
        CommandCall photo = CommandCall.of("simulate", "--cell", cell.toString(), "--out", folder.toString(),
                "--object", "5=200,150,0,13,0,0.2rad", "--camera-pose", "200,150,900,180,0,0", "--name", name);
        assertEquals(0, photo.code(), photo.err());
        CommandCall call = CommandCall.of("check", "--cell", cell.toString(), folder.resolve(name + ".png").toString(),
                "--out", folder.resolve("out").toString());
        JsonObject result = JsonParser.parseString(Files.readString(folder.resolve("out")
                .resolve(name + ".result.json"))).getAsJsonObject();
        assertEquals(result.get("verdict").getAsString().equals("ambiguous") ? 5 : 0, call.code(), call.out());
        assertEquals(result.get("verdict").getAsString().equals("ambiguous"), call.out().startsWith("AMBIGUOUS"));
        return result;
    }

    private static double tiltFromTruth(JsonObject mode) {
        JsonArray mean = mode.getAsJsonArray("mean");
        return RigidTransform.ofEuler(0, 0, 0, mean.get(3).getAsDouble(), mean.get(4).getAsDouble(),
                mean.get(5).getAsDouble()).angleRadTo(TRUTH);
    }

    /** Corners as noisy as those of real photos: both poses, either of which may be the right one. */
    @Test
    void bothPosesAreToldWithTheirWeights() throws IOException {
        JsonObject result = check(0.4, "noisy");
        assertEquals("ambiguous", result.get("verdict").getAsString());
        assertTrue(result.get("reason").getAsString().startsWith("Two poses explain the corners of object 5"));
        JsonObject object = result.getAsJsonObject("objects").getAsJsonObject("5");
        assertTrue(object.get("within_target").isJsonNull());
        JsonArray modes = object.getAsJsonArray("modes");
        assertEquals(2, modes.size());
        JsonObject heavy = modes.get(0).getAsJsonObject();
        JsonObject light = modes.get(1).getAsJsonObject();
        assertEquals(1, heavy.get("weight").getAsDouble() + light.get("weight").getAsDouble(), 1e-9);
        assertTrue(light.get("weight").getAsDouble() > 0.01);
        // the truth is one of the two, the other is tilted to the opposite side
        double nearer = Math.min(tiltFromTruth(heavy), tiltFromTruth(light));
        double farther = Math.max(tiltFromTruth(heavy), tiltFromTruth(light));
        assertTrue(nearer < 0.15 && farther > 0.25, nearer + ", " + farther);
        BufferedImage overlay = ImageIO.read(folder.resolve("out/noisy.overlay.png").toFile());
        assertEquals(SmallCell.WIDTH, overlay.getWidth());
        assertTrue(orange(overlay) > 300, "the caution of an ambiguous object is painted");
    }

    /** The same photo, its corners trusted as far as a renderer deserves: perspective tells the poses apart. */
    @Test
    void preciseCornersLeaveOnePose() throws IOException {
        JsonObject result = check(0.03, "precise");
        assertEquals("pass", result.get("verdict").getAsString());
        JsonObject object = result.getAsJsonObject("objects").getAsJsonObject("5");
        assertTrue(!object.has("modes"));
        JsonObject pose = object.getAsJsonObject("pose");
        assertTrue(tiltFromTruth(pose) < 0.05, "off by " + tiltFromTruth(pose));
    }

    private static int orange(BufferedImage image) {
        int count = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                int rgb = image.getRGB(x, y);
                count += (rgb >> 16 & 255) > 200 && (rgb >> 8 & 255) > 120 && (rgb & 255) < 60 ? 1 : 0;
            }
        }
        return count;
    }
}
