package org.cellgauge.android.apk;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Function;
import javax.imageio.ImageIO;
import org.cellgauge.android.probe.CheckProbe;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Shrinking leaves every figure as it is: R8's class files, with D8's replacements for Android 8, run on this JVM
 * beside the code that went into them. The dex file of the release comes from the same rules, but from another run of
 * R8, and needs a device to run.
 */
class ShrunkCodeTest {
    private static final Path ROOT = Path.of(System.getProperty("cellgauge.root", "."));

    private static URLClassLoader shrunk;

    @BeforeAll
    static void openShrunkCode() throws IOException {
        URL[] places = {Path.of(System.getProperty("cellgauge.shrunk.jar")).toUri().toURL(),
            Path.of(System.getProperty("cellgauge.shrunk.resources")).toUri().toURL()};
        // nothing but these and the JDK
        shrunk = new URLClassLoader(places, ClassLoader.getPlatformClassLoader());
    }

    @AfterAll
    static void closeShrunkCode() throws IOException {
        shrunk.close();
    }

    @SuppressWarnings("unchecked")
    private static Function<Map<String, Object>, String> shrunkProbe() throws ReflectiveOperationException {
        Class<?> type = shrunk.loadClass(CheckProbe.class.getName());
        assertNotSame(CheckProbe.class, type);
        return (Function<Map<String, Object>, String>) type.getConstructor().newInstance();
    }

    private static Map<String, Object> input(String scene, String preset) throws IOException {
        Path folder = ROOT.resolve("fixtures").resolve(scene);
        BufferedImage photo = ImageIO.read(folder.resolve("photo.png").toFile());
        assertEquals(BufferedImage.TYPE_BYTE_GRAY, photo.getType());
        return Map.of("cell", Files.readString(folder.resolve("cell.yaml")),
                "camera", Files.readString(folder.resolve("camera.yaml")),
                "luminance", ((DataBufferByte) photo.getRaster().getDataBuffer()).getData(),
                "width", photo.getWidth(), "height", photo.getHeight(), "preset", preset);
    }

    /** Otherwise every comparison below would be of the same code with itself. */
    @Test
    void shrunkCodeIsShrunk() {
        String unused = "org.apache.commons.math3.random.SobolSequenceGenerator";
        assertThrows(ClassNotFoundException.class, () -> shrunk.loadClass(unused));
    }

    /**
     * Markers, poses, deviations, diagnostics and every drawn line, to the last digit. Between them the scenes need the
     * lens' tables, a dictionary that is read from a file, unknown focal lengths, both likelihoods and two samplers.
     */
    @ParameterizedTest
    @CsvSource({"lifted-4, default, pass", "distorted-4, default, ", "apriltag-4, default, ", "plane-4, focal, ",
        "plane-3, thesis, not-converged"})
    void wholeCheckComesOutTheSame(String scene, String preset, String verdict) throws Exception {
        Map<String, Object> input = input(scene, preset);
        String expected = new CheckProbe().apply(input);
        assertTrue(expected.contains("\"r_hat_max\": "), "the unshrunk check came to a result: " + expected);
        if (verdict != null) {
            assertTrue(expected.contains("\"verdict\": \"" + verdict + "\""), expected.substring(0, 3000));
        }
        assertEquals(expected, shrunkProbe().apply(input));
    }

    /** Messages come from far inside the YAML reader. */
    @ParameterizedTest
    @CsvSource({"std_deg: 0.2, std_deg: [0.2", "size_mm: 47, size_mm: -47", "square-binary, square-binarry",
        "target:, tarrget:"})
    void faultsAreRefusedInTheSameWords(String right, String wrong) throws Exception {
        Map<String, Object> input = new HashMap<>(input("lifted-4", "default"));
        input.put("cell", ((String) input.get("cell")).replace(right, wrong));
        String expected = new CheckProbe().apply(input);
        assertTrue(expected.startsWith("refused: cell.yaml"), expected);
        assertEquals(expected, shrunkProbe().apply(input));
    }
}
