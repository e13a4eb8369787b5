package org.cellgauge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.cellgauge.examples.CheckFolder;
import org.cellgauge.examples.CheckPhoto;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** The examples run as they stand, and the README shows a part of one. */
@Isolated("System.out is the whole virtual machine's")
class ExamplesTest {
    private static final Path ROOT = Path.of(System.getProperty("cellgauge.root", "."));
    private static final Path SCENE = ROOT.resolve("fixtures/lifted-4");
    private static final Pattern OBJECT = Pattern.compile("object (\\d+): x (\\S+) y (\\S+) z (\\S+) mm,"
            + " std (\\S+) (\\S+) (\\S+) mm");

    @Test
    void checkedPhotoHasItsObjectsWhereTheTruthHasThem() throws IOException {
        String printed = printedBy(() -> CheckPhoto.main(SCENE.resolve("cell.yaml").toString(),
                SCENE.resolve("photo.png").toString()));
        assertTrue(printed.startsWith("PASS: "), printed);
        JsonObject truth = JsonParser.parseString(Files.readString(SCENE.resolve("photo.truth.json")))
                .getAsJsonObject();
        Matcher line = OBJECT.matcher(printed);
        int objects = 0;
        while (line.find()) {
            objects++;
            double[] true3 = positionMm(truth, Integer.parseInt(line.group(1)));
            for (int axis = 0; axis < 3; axis++) {
                double std = Double.parseDouble(line.group(5 + axis));
                assertTrue(std > 0.1 && std < 3, printed);
                assertEquals(true3[axis], Double.parseDouble(line.group(2 + axis)), 4 * std, line.group());
            }
        }
        assertEquals(3, objects, printed);
    }

    @Test
    void checkedFolderHasALineForEachPhotoAndItsFiles(@TempDir Path folder) throws IOException {
        Path photos = Files.createDirectories(folder.resolve("photos"));
        Files.copy(SCENE.resolve("photo.png"), photos.resolve("b.png"));
        Files.write(photos.resolve("a.png"), new byte[9]);
        String printed = printedBy(() -> CheckFolder.main(SCENE.resolve("cell.yaml").toString(), photos.toString(),
                folder.resolve("results").toString()));
        assertEquals(List.of("1 of 2, a: refused", "2 of 2, b: pass", "2 photos: 1 refused, 1 pass"),
                printed.lines().toList());
        assertTrue(Files.readString(folder.resolve("results/report.html")).contains("photo-2"));
        assertTrue(Files.exists(folder.resolve("results/b.result.json")));
    }

    private interface Example {
        void run() throws IOException;
    }

    private static String printedBy(Example example) throws IOException {
        PrintStream before = System.out;
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        System.setOut(new PrintStream(bytes, true, StandardCharsets.UTF_8));
        try {
            example.run();
        } finally {
            System.setOut(before);
        }
        return bytes.toString(StandardCharsets.UTF_8);
    }

    private static double[] positionMm(JsonObject truth, int id) {
        JsonArray position = truth.getAsJsonObject("objects").getAsJsonObject("" + id).getAsJsonObject("pose")
                .getAsJsonArray("position_mm");
        return IntStream.range(0, 3).mapToDouble(axis -> position.get(axis).getAsDouble()).toArray();
    }

    @Test
    void readmeShowsTheExampleAsItRuns() throws IOException {
        String source = Files.readString(ROOT.resolve("examples/java/org/cellgauge/examples/CheckPhoto.java"));
        String readme = Files.readString(ROOT.resolve("README.md"));
        String shown = source.substring(source.indexOf("README: from here") + "README: from here".length(),
                source.indexOf("// README: to here"));
        List<String> lines = shown.lines().filter(line -> !line.isBlank())
                .map(line -> line.replaceFirst(" {8}", "")).toList();
        int at = readme.indexOf(lines.get(0));
        String block = at < 0 ? "" : readme.substring(at, readme.indexOf("```", at));
        assertEquals(lines, block.lines().filter(line -> !line.isBlank()).toList());
    }
}
