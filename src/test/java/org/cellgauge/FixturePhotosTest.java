package org.cellgauge;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.abst.fiducial.FiducialDetector;
import boofcv.factory.fiducial.ConfigFiducialBinary;
import boofcv.factory.fiducial.ConfigFiducialHammingDetector;
import boofcv.factory.fiducial.ConfigHammingMarker;
import boofcv.factory.fiducial.FactoryFiducial;
import boofcv.factory.fiducial.HammingDictionary;
import boofcv.factory.filter.binary.ConfigThreshold;
import boofcv.factory.filter.binary.ThresholdType;
import boofcv.struct.image.GrayU8;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import georegression.struct.shapes.Polygon2D_F64;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cli.SimulateCommand;
import org.cellgauge.desktop.ImageFiles;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.EdgeShift;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;

/** The stored photos show what their truth says, and their truth says how to make them again. */
class FixturePhotosTest {
    private static final Path ROOT = Path.of(System.getProperty("cellgauge.root", "."));

    @TempDir
    private Path folder;

    static Stream<Path> scenes() throws IOException {
        try (Stream<Path> folders = Files.list(ROOT.resolve("fixtures"))) {
            List<Path> scenes = folders.filter(f -> Files.exists(f.resolve("photo.truth.json"))).sorted().toList();
            assertTrue(scenes.size() >= 7, "fixtures are missing: " + scenes);
            return scenes.stream();
        }
    }

    private static JsonObject truth(Path scene) throws IOException {
        return JsonParser.parseString(Files.readString(scene.resolve("photo.truth.json"))).getAsJsonObject();
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void detectorFindsEveryMarkerWhereTheTruthHasIt(Path scene) throws IOException {
        Cell cell = CellReader.read(scene.resolve("cell.yaml"));
        JsonArray markers = truth(scene).getAsJsonArray("markers");
        assertEquals(cell.references().size() + cell.objects().size(), markers.size());

        BufferedImage picture = ImageIO.read(scene.resolve("photo.png").toFile());
        GrayU8 image = new GrayU8(picture.getWidth(), picture.getHeight());
        image.data = light(((DataBufferByte) picture.getRaster().getDataBuffer()).getData(),
                truth(scene).getAsJsonObject("settings"));
        FiducialDetector<GrayU8> detector = cell.family().isSquareBinary()
                ? FactoryFiducial.squareBinary(new ConfigFiducialBinary(47),
                        ConfigThreshold.local(ThresholdType.LOCAL_MEAN, 21), GrayU8.class)
                : FactoryFiducial.squareHamming(
                        ConfigHammingMarker.loadDictionary(HammingDictionary.APRILTAG_36h11),
                        new ConfigFiducialHammingDetector(), GrayU8.class);
        detector.detect(image);

        double sum = 0;
        for (JsonElement marker : markers) {
            int id = marker.getAsJsonObject().get("id").getAsInt();
            Polygon2D_F64 found = null;
            for (int i = 0; i < detector.totalFound(); i++) {
                found = detector.getId(i) == id ? detector.getBounds(i, null) : found;
            }
            assertNotNull(found, "marker " + id + " was not found");
            for (int i = 0; i < 4; i++) {
                JsonArray corner = marker.getAsJsonObject().getAsJsonArray("corners_px").get(i).getAsJsonArray();
                double du = found.get(i).x - corner.get(0).getAsDouble();
                double dv = found.get(i).y - corner.get(1).getAsDouble();
                sum += du * du + dv * dv;
            }
        }
        double rms = Math.sqrt(sum / (8 * markers.size()));
        // BoofCV without any tuning has 0.08 px rms per coordinate at this blur, noise and size, and 0.35 px where it
        // takes the grey of sRGB for light
        assertTrue(rms < 0.15, "corners are off by " + rms + " px rms");
        assertTrue(rms > 0.001, "corners as exact as this were not measured: " + rms + " px rms");
    }

    /** Light of grey values by the formula of IEC 61966-2-1 where the truth says sRGB, in steps of a 255th. */
    private static byte[] light(byte[] grey, JsonObject settings) {
        boolean linear = !settings.has("tone_curve") || settings.get("tone_curve").getAsString().equals("linear");
        if (linear) {
            return grey;
        }
        assertEquals("srgb", settings.get("tone_curve").getAsString());
        byte[] light = new byte[grey.length];
        for (int i = 0; i < grey.length; i++) {
            double v = (grey[i] & 255) / 255.0;
            light[i] = (byte) Math.round(255 * (v <= 0.04045 ? v / 12.92 : Math.pow((v + 0.055) / 1.055, 2.4)));
        }
        return light;
    }

    /**
     * The program's own detector, which is told of the curve only what the file says. Four sides of 25 px at noise of 2
     * grey levels allow 0.01 px; chi-square of all 8 coordinates of 6 or 7 markers is within three deviations of what
     * it should be, but for the shift that all edges share, which is stated apart.
     */
    @ParameterizedTest
    @MethodSource("scenes")
    void cornersAreAsPreciseAsTheyAreStatedToBe(Path scene) throws IOException {
        Cell cell = CellReader.read(scene.resolve("cell.yaml"));
        List<Integer> ids = new ArrayList<>();
        cell.references().forEach(r -> ids.add(r.id()));
        cell.objects().forEach(o -> ids.add(o.id()));
        Detections found = new BoofMarkerDetector(cell.camera(), cell.family(), ids)
                .detect(ImageFiles.read(scene.resolve("photo.png")), "photo.png");
        JsonArray markers = truth(scene).getAsJsonArray("markers");
        double squares = 0;
        double chiSquare = 0;
        for (JsonElement marker : markers) {
            MarkerObservation seen = found.find(marker.getAsJsonObject().get("id").getAsInt());
            assertNotNull(seen, "marker " + marker.getAsJsonObject().get("id") + " was not found");
            double[] errors = seen.cornersPx();
            for (int i = 0; i < 8; i++) {
                errors[i] -= marker.getAsJsonObject().getAsJsonArray("corners_px").get(i / 2).getAsJsonArray()
                        .get(i % 2).getAsDouble();
                squares += errors[i] * errors[i];
            }
            double[] covariance = seen.covariancePx2();
            double[] byShift = EdgeShift.ofCorners(seen.cornersPx());
            for (int i = 0; i < 64; i++) {
                covariance[i] += byShift[i / 8] * byShift[i % 8] * Math.pow(found.light().edgeShiftStdPx(), 2);
            }
            chiSquare += chiSquare(errors, covariance);
        }
        double rms = Math.sqrt(squares / (8 * markers.size()));
        System.out.printf("%s: corners off by %.4f px rms, chi-square %.1f of %d, tone curve %s%n",
                scene.getFileName(), rms, chiSquare, 8 * markers.size(), found.light().toneCurve().words());
        assertTrue(rms < 0.03, "corners are off by " + rms + " px rms");
        // the stated shift of all edges is generous here: seven of the 8 directions of a marker count at least
        double least = 7 * markers.size() - 3 * Math.sqrt(2 * 7 * markers.size());
        double most = 8 * markers.size() + 3 * Math.sqrt(2 * 8 * markers.size());
        assertTrue(chiSquare > least && chiSquare < most, "chi-square " + chiSquare);
    }

    private static double chiSquare(double[] errors, double[] covariance) {
        double[] factor = covariance.clone();
        assertTrue(Cholesky.factor(factor, 8), "the covariance is positive definite");
        double sum = 0;
        double[] whitened = new double[8];
        for (int i = 0; i < 8; i++) {
            double v = errors[i];
            for (int j = 0; j < i; j++) {
                v -= factor[8 * i + j] * whitened[j];
            }
            whitened[i] = v / factor[9 * i];
            sum += whitened[i] * whitened[i];
        }
        return sum;
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void storedCommandMakesTheStoredPhotoAgain(Path scene) throws IOException {
        List<String> args = new ArrayList<>();
        for (JsonElement word : truth(scene).getAsJsonArray("command")) {
            args.add(word.getAsString());
        }
        assertEquals(List.of("cellgauge", "simulate", "--cell"), args.subList(0, 3));
        args.set(3, ROOT.resolve(args.get(3)).toString());
        args.set(args.indexOf("--out") + 1, folder.toString());
        StringWriter messages = new StringWriter();
        int code = new CommandLine(new SimulateCommand()).setOut(new PrintWriter(new StringWriter()))
                .setErr(new PrintWriter(messages)).execute(args.subList(2, args.size()).toArray(new String[0]));
        assertEquals(0, code, messages.toString());
        // pixels, not files: another Java may compress them differently
        assertArrayEquals(pixels(scene.resolve("photo.png")), pixels(folder.resolve("photo.png")));
        JsonObject expected = truth(scene);
        JsonObject again = truth(folder);
        for (String key : List.of("camera", "references", "objects", "markers", "settings", "seed")) {
            assertAlike(expected.get(key), again.get(key), key);
        }
    }

    /** Equal but for the last digits of numbers, which another way to compute the same angle may change. */
    private static void assertAlike(JsonElement expected, JsonElement actual, String path) {
        if (expected.isJsonObject()) {
            assertEquals(expected.getAsJsonObject().keySet(), actual.getAsJsonObject().keySet(), path);
            for (String key : expected.getAsJsonObject().keySet()) {
                assertAlike(expected.getAsJsonObject().get(key), actual.getAsJsonObject().get(key), path + "." + key);
            }
        } else if (expected.isJsonArray()) {
            assertEquals(expected.getAsJsonArray().size(), actual.getAsJsonArray().size(), path);
            for (int i = 0; i < expected.getAsJsonArray().size(); i++) {
                assertAlike(expected.getAsJsonArray().get(i), actual.getAsJsonArray().get(i), path + "[" + i + "]");
            }
        } else if (expected.isJsonPrimitive() && expected.getAsJsonPrimitive().isNumber()) {
            assertEquals(expected.getAsDouble(), actual.getAsDouble(), 1e-9, path);
        } else {
            assertEquals(expected, actual, path);
        }
    }

    private static byte[] pixels(Path png) throws IOException {
        return ((DataBufferByte) ImageIO.read(png.toFile()).getRaster().getDataBuffer()).getData();
    }
}
