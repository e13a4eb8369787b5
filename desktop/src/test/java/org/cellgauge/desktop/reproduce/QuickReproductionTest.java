package org.cellgauge.desktop.reproduce;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.cellgauge.desktop.StopSignal;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A quick run of all experiments says what the page in docs says, which has five times as many chains of the thesis,
 * rendered photos in place of exact corners, and deviations ten times as precise.
 */
class QuickReproductionTest {
    private static final Path DOCS = Path.of(System.getProperty("cellgauge.root", "."), "docs");
    private static final String CONCLUSIONS = "The conclusions, one by one";
    private static final int PRINTED = 3;
    private static final int MEDIAN = 4;
    private static final int RANGE = 5;
    private static final int CONVERGED = 6;
    private static final int RIGHT = 7;

    @TempDir
    static Path folder;
    private static List<Line> quick = List.of();
    private static List<Line> page = List.of();

    /** A row of a table, and the heading above it. */
    private record Line(String heading, List<String> cells) {
        static List<Line> of(Path file) throws IOException {
            List<Line> lines = new ArrayList<>();
            String heading = "";
            for (String line : Files.readAllLines(file)) {
                if (line.startsWith("#")) {
                    heading = line.replaceFirst("#+ ", "");
                } else if (line.startsWith("| ") && !line.startsWith("| ---") && line.endsWith("|")) {
                    String[] cells = line.substring(1, line.length() - 1).split(" \\| ");
                    lines.add(new Line(heading, Arrays.stream(cells).map(String::strip).toList()));
                }
            }
            return lines;
        }

        /** Of a table that sets what is printed beside ours. */
        boolean compares() {
            return cells.size() > RIGHT && cells.get(0).matches("\\d+") && heading.startsWith("Table ");
        }

        boolean deviationsOf(boolean focal) {
            return compares() && cells.get(2).startsWith("std of ") && !cells.get(2).contains("focal")
                    && cells.get(1).contains("focal length explored") == focal;
        }

        double[] numbers(int column) {
            return Arrays.stream(cells.get(column).split(", ")).mapToDouble(Double::parseDouble).toArray();
        }

        List<Object> key() {
            return List.of(heading, cells.subList(0, PRINTED + 1));
        }
    }

    @BeforeAll
    static void runAll() throws IOException {
        Reproduction reproduction = new Reproduction(true, folder, "a version");
        Path written = reproduction.page(2, new StopSignal(), (name, number, count, took) -> { }).orElseThrow();
        quick = Line.of(written);
        page = Line.of(DOCS.resolve(Reproduction.PAGE));
    }

    private static Map<Line, Line> pairs(Predicate<Line> which) {
        Map<Object, Line> counterparts = new LinkedHashMap<>();
        page.stream().filter(Line::compares).forEach(line -> counterparts.put(line.key(), line));
        Map<Line, Line> pairs = new LinkedHashMap<>();
        for (Line line : quick) {
            if (which.test(line)) {
                Line other = counterparts.get(line.key());
                assertTrue(other != null, "the page in docs has no such row: " + line);
                pairs.put(line, other);
            }
        }
        return pairs;
    }

    /** Of x, y and z: rotations are printed with a figure or none. */
    private static double[] ratios(Map<Line, Line> pairs, int column) {
        List<Double> ratios = new ArrayList<>();
        pairs.forEach((ours, theirs) -> {
            double[] a = ours.numbers(column);
            double[] b = theirs.numbers(column);
            for (int axis = 0; axis < 3; axis++) {
                ratios.add(a[axis] / b[axis]);
            }
        });
        return ratios.stream().mapToDouble(Double::doubleValue).sorted().toArray();
    }

    private static void alike(double[] ratios, double median, double most, double all) {
        int n = ratios.length;
        assertEquals(1, ratios[n / 2], median, "median of " + n);
        String worst = ratios[0] + " to " + ratios[n - 1];
        long beyond = Arrays.stream(ratios).filter(r -> Math.abs(Math.log(r)) > Math.log1p(most)).count();
        assertTrue(beyond <= n / 20, beyond + " of " + n + ", " + worst);
        assertTrue(ratios[0] > 1 / (1 + all) && ratios[n - 1] < 1 + all, worst);
    }

    /** What is printed stands in every row as it is, of all tables that compare figures. */
    @Test
    void everyRowOfThePageIsThere() {
        long rows = page.stream().filter(Line::compares).count();
        assertTrue(rows > 150, "rows: " + rows);
        assertEquals(rows, pairs(Line::compares).size());
    }

    /** Draws that give 20 % at worst give most deviations to some 5 %, and rounded figures differ by as much. */
    @Test
    void deviationsThatAreRightAreThoseOfThePage() {
        Map<Line, Line> known = pairs(line -> line.deviationsOf(false));
        assertTrue(known.size() > 60, "rows: " + known.size());
        alike(ratios(known, RIGHT), 0.03, 0.15, 0.4);
        alike(ratios(pairs(line -> line.deviationsOf(true)), RIGHT), 0.05, 0.2, 0.4);
    }

    /** The thesis' own posterior: with focal lengths explored and few references its tails are too long for a look. */
    @Test
    void convergedDeviationsOfTheThesisPosteriorAreThoseOfThePage() {
        alike(ratios(pairs(line -> line.deviationsOf(false)), CONVERGED), 0.03, 0.15, 0.4);
        alike(ratios(pairs(line -> line.deviationsOf(true) && line.cells().get(1).matches("[456] .*")), CONVERGED),
                0.05, 0.3, 0.6);
    }

    /** The median of four chains lies outside of what twenty span once in some hundred; means hang on the photo. */
    @Test
    void chainsOfTheThesisAreAmongThoseOfThePage() {
        int inside = 0;
        int all = 0;
        for (Map.Entry<Line, Line> pair : pairs(line -> line.compares() && line.cells().get(2).startsWith("std"))
                .entrySet()) {
            double[] medians = pair.getKey().numbers(MEDIAN);
            String[] ranges = pair.getValue().cells().get(RANGE).split(", ");
            for (int i = 0; i < medians.length; i++) {
                String[] range = ranges[i].split(" to ");
                all++;
                inside += Double.parseDouble(range[0]) <= medians[i]
                        && medians[i] <= Double.parseDouble(range[range.length - 1]) ? 1 : 0;
            }
        }
        assertTrue(all > 600 && inside > 0.95 * all, inside + " of " + all);
    }

    /** Whether a conclusion holds does not depend on how precisely it is looked at. */
    @Test
    void conclusionsHoldOrNotAsOnThePage() {
        List<List<String>> ours = conclusions(quick);
        assertTrue(ours.size() > 15, "conclusions: " + ours.size());
        assertEquals(conclusions(page), ours);
    }

    private static List<List<String>> conclusions(List<Line> lines) {
        return lines.stream().filter(line -> line.heading().equals(CONCLUSIONS)).map(line -> line.cells().subList(0, 3))
                .toList();
    }

    @Test
    void picturesOfThePageAreWritten() throws IOException {
        Matcher picture = Pattern.compile("!\\[[^]]*]\\(([^)]+)\\)")
                .matcher(Files.readString(folder.resolve(Reproduction.PAGE)));
        int count = 0;
        while (picture.find()) {
            String text = Files.readString(folder.resolve(picture.group(1)));
            assertTrue(text.startsWith("<svg") && text.strip().endsWith("</svg>"), picture.group(1));
            count++;
        }
        assertTrue(count > 20, "pictures: " + count);
    }
}
