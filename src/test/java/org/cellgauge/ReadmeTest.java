package org.cellgauge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.cellgauge.cli.Main;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What the README shows is what its first command gives. */
class ReadmeTest {
    private static final Path ROOT = Path.of(System.getProperty("cellgauge.root", "."));
    private static final Path SCENE = ROOT.resolve("fixtures/lifted-4");
    @TempDir
    static Path folder;
    private static String printed;

    @BeforeAll
    static void runTheFirstCommand() {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        int code = Main.commandLine().setOut(new PrintWriter(out)).setErr(new PrintWriter(err))
                .execute("check", "--cell", SCENE.resolve("cell.yaml").toString(),
                        SCENE.resolve("photo.png").toString(), "--out", folder.toString());
        assertEquals(0, code, err.toString());
        printed = out.toString();
    }

    /** Grey values differ by a rounding here and there between Java versions, not by a line that moved. */
    @Test
    void pictureIsTheOneThatTheCommandPaints() throws IOException {
        BufferedImage shown = ImageIO.read(SCENE.resolve("overlay.png").toFile());
        BufferedImage painted = ImageIO.read(folder.resolve("photo.overlay.png").toFile());
        assertEquals(shown.getWidth(), painted.getWidth());
        assertEquals(shown.getHeight(), painted.getHeight());
        long different = 0;
        for (int y = 0; y < shown.getHeight(); y++) {
            for (int x = 0; x < shown.getWidth(); x++) {
                int a = shown.getRGB(x, y);
                int b = painted.getRGB(x, y);
                int distance = Math.abs((a >> 16 & 255) - (b >> 16 & 255)) + Math.abs((a >> 8 & 255) - (b >> 8 & 255))
                        + Math.abs((a & 255) - (b & 255));
                different += distance > 24 ? 1 : 0;
            }
        }
        // one digit of a label that reads otherwise is some 60 pixels
        assertTrue(different < 30, different + " pixels differ");
    }

    @Test
    void tableIsTheOneThatTheCommandPrints() throws IOException {
        List<String> readme = Files.readAllLines(ROOT.resolve("README.md"), StandardCharsets.UTF_8);
        int from = readme.indexOf("Camera in world");
        int to = readme.indexOf("…");
        assertTrue(from > 0 && to > from + 8, "the README shows a table");
        for (String line : readme.subList(from, to)) {
            assertTrue(printed.contains(line), "not printed: " + line + "\n" + printed);
        }
    }

    /** What docs/files.md shows of draws runs over those of the first command, where Python has the modules. */
    @ParameterizedTest
    @MethodSource("snippets")
    void snippetsOfTheDocumentsRun(String snippet) throws IOException, InterruptedException {
        Python.Ran ran = Python.run(snippet.replace("cellgauge-out/", folder + "/"), folder);
        assertEquals(0, ran.code(), ran.printed());
        assertTrue(ran.printed().contains("camera_x_mm"), ran.printed());
    }

    static List<String> snippets() throws IOException {
        List<String> found = Python.snippets(ROOT.resolve("docs/files.md"));
        assertEquals(2, found.size(), "snippets in the document");
        return found;
    }
}
