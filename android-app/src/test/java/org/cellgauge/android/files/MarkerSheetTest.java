package org.cellgauge.android.files;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.api.Test;

/** The printed page, put on pixels by a reader of its own and searched for markers. */
class MarkerSheetTest {
    private static final double MM_PER_POINT = 25.4 / 72;
    private static final int PX_PER_MM = 4;
    private static final Pattern RECTANGLE = Pattern.compile("([-.\\d]+) ([-.\\d]+) ([-.\\d]+) ([-.\\d]+) re ?");
    private static final Pattern BOX = Pattern.compile("/MediaBox \\[0 0 ([.\\d]+) ([.\\d]+)\\]");
    private static final Pattern LINE = Pattern.compile("([.\\d]+) ([.\\d]+) m ([.\\d]+) ([.\\d]+) l S");

    private static String guideCell() throws IOException {
        File file = new File(System.getProperty("cellgauge.root"), "android-app/src/main/assets/guide/cell.yaml");
        return new String(Files.readAllBytes(file.toPath()), StandardCharsets.UTF_8);
    }

    private static Cell cell() throws IOException {
        return CellReader.read(guideCell(), "cell.yaml", PinholeCamera.ideal(1280, 720, 1000, 1000, 640, 360));
    }

    private static String text(Cell cell) {
        return new String(MarkerSheet.of(cell), StandardCharsets.US_ASCII);
    }

    private static List<String> pages(String pdf) {
        List<String> pages = new ArrayList<>();
        Matcher m = Pattern.compile("stream\n(.*?)\nendstream", Pattern.DOTALL).matcher(pdf);
        while (m.find()) {
            pages.add(m.group(1));
        }
        return pages;
    }

    /** What is filled is black; lines to cut along are drawn, and left out here. */
    private static GreyImage image(String page, double widthMm, double heightMm) {
        int width = (int) Math.ceil(widthMm * PX_PER_MM);
        int height = (int) Math.ceil(heightMm * PX_PER_MM);
        double[] black = new double[width * height];
        for (String line : page.split("\n")) {
            Matcher m = RECTANGLE.matcher(line);
            if (m.matches()) {
                double scale = MM_PER_POINT * PX_PER_MM;
                double x = Double.parseDouble(m.group(1)) * scale;
                double bottom = heightMm * PX_PER_MM - Double.parseDouble(m.group(2)) * scale;
                double right = x + Double.parseDouble(m.group(3)) * scale;
                double top = bottom - Double.parseDouble(m.group(4)) * scale;
                for (int j = (int) top; j <= Math.min(height - 1, (int) bottom); j++) {
                    for (int i = (int) x; i <= Math.min(width - 1, (int) right); i++) {
                        black[j * width + i] += Math.max(0, Math.min(right, i + 1) - Math.max(x, i))
                                * Math.max(0, Math.min(bottom, j + 1) - Math.max(top, j));
                    }
                }
            }
        }
        byte[] grey = new byte[width * height];
        for (int i = 0; i < grey.length; i++) {
            grey[i] = (byte) Math.round(230 - 200 * Math.min(1, black[i]));
        }
        return GreyImage.packed(grey, width, height);
    }

    private static void assertPrints(Cell cell, int pages, int... ids) {
        String pdf = text(cell);
        assertEquals(pages, pages(pdf).size());
        Matcher box = BOX.matcher(pdf);
        assertTrue(box.find());
        double widthMm = Double.parseDouble(box.group(1)) * MM_PER_POINT;
        double heightMm = Double.parseDouble(box.group(2)) * MM_PER_POINT;
        TreeSet<Integer> found = new TreeSet<>();
        for (String page : pages(pdf)) {
            GreyImage image = image(page, widthMm, heightMm);
            Cell seen = new Cell(PinholeCamera.ideal(image.widthPx(), image.heightPx(), 1000, 1000,
                    image.widthPx() / 2.0, image.heightPx() / 2.0), cell.family(), cell.references(), cell.objects(),
                    OptionalDouble.empty(), OptionalDouble.empty());
            Detections detections = BoofMarkerDetector.forCell(seen).detect(image, "page");
            for (MarkerObservation marker : detections.markers()) {
                found.add(marker.id());
                double[] c = marker.cornersPx();
                double size = size(cell, marker.id()) * PX_PER_MM;
                for (int k = 0; k < 8; k += 2) {
                    assertEquals(size, Math.hypot(c[(k + 2) % 8] - c[k], c[(k + 3) % 8] - c[k + 1]), 0.2,
                            "side of marker " + marker.id());
                }
                assertTrue(c[0] < c[2] && Math.abs(c[1] - c[3]) < 0.2, "marker " + marker.id() + " stands upright");
                assertTrue(page.contains("(" + marker.id() + "   "), "its id stands below it");
            }
        }
        TreeSet<Integer> expected = new TreeSet<>();
        Arrays.stream(ids).forEach(expected::add);
        assertEquals(expected, found);
    }

    private static double size(Cell cell, int id) {
        return cell.references().stream().filter(r -> r.id() == id).mapToDouble(r -> r.sizeMm()).findFirst()
                .orElseGet(() -> cell.objects().stream().filter(o -> o.id() == id).mapToDouble(o -> o.sizeMm())
                        .findFirst().getAsDouble());
    }

    @Test
    void markersOfTheExampleAreOnOnePageTrueToSize() throws IOException {
        assertPrints(cell(), 1, 944, 1234, 911, 22, 5, 20, 30);
    }

    private static Reference reference(int id) throws IOException {
        Reference like = cell().references().get(0);
        return new Reference(id, 30, like.worldFromMarker(), like.placement());
    }

    @Test
    void otherFamiliesAndSizesTakeAsManyPagesAsTheyNeed() throws IOException {
        Cell cell = cell();
        Cell large = new Cell(cell.camera(), MarkerFamily.of("tag36h11"), List.of(reference(4)),
                List.of(new ObjectMarker(1, 240, null), new ObjectMarker(2, 240, null), new ObjectMarker(3, 30, null)),
                OptionalDouble.empty(), OptionalDouble.empty());
        assertPrints(large, 3, 1, 2, 3, 4);
    }

    @Test
    void rulerIsAHundredMillimetresLong() throws IOException {
        Matcher line = LINE.matcher(text(cell()));
        assertTrue(line.find());
        assertEquals(100, (Double.parseDouble(line.group(3)) - Double.parseDouble(line.group(1))) * MM_PER_POINT, 0.01);
    }

    /** Readers find objects by the table at the end. */
    @Test
    void tableOfObjectsPointsAtThem() throws IOException {
        String pdf = text(cell());
        int table = Integer.parseInt(pdf.replaceAll("(?s).*startxref\n(\\d+)\n%%EOF\n", "$1"));
        String[] lines = pdf.substring(table).split("\n");
        assertEquals("xref", lines[0]);
        int count = Integer.parseInt(lines[1].substring(2));
        for (int i = 1; i < count; i++) {
            assertEquals(20, lines[2 + i].length() + 1);
            int offset = Integer.parseInt(lines[2 + i].substring(0, 10));
            assertTrue(pdf.startsWith(i + " 0 obj\n", offset), "object " + i);
        }
        Matcher stream = Pattern.compile("/Length (\\d+) >>\nstream\n").matcher(pdf);
        assertTrue(stream.find());
        assertTrue(pdf.startsWith("\nendstream", stream.end() + Integer.parseInt(stream.group(1))));
    }
}
