package org.cellgauge.desktop.reproduce;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.cellgauge.desktop.ResultFolder;
import org.cellgauge.desktop.StopSignal;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.settings.ObjectNoise;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The page in docs is what the command writes, and runs go on where they were stopped. */
class ReproductionTest {
    private static final Path DOCS = Path.of(System.getProperty("cellgauge.root", "."), "docs");
    private static final Assumptions USUAL = Assumptions.usual();

    @TempDir
    Path folder;

    private static Reproduction.Listener collecting(List<String> done, List<Double> seconds) {
        return (name, number, count, took) -> {
            done.add(name);
            seconds.add(took);
        };
    }

    /**
     * Four chains of the thesis. Random numbers hang on every bit of the corners, and the page has those of a rendered
     * photo: medians have to lie among the page's twenty chains, and what is printed stands there as it is.
     */
    @Test
    void tableOfThePageIsTheOneThatTheCommandGives() throws IOException {
        List<String> done = new ArrayList<>();
        List<Double> seconds = new ArrayList<>();
        Reproduction reproduction = new Reproduction(true, folder, "a version");
        String table = reproduction.text(List.of("7.2"), 2, new StopSignal(), collecting(done, seconds)).orElseThrow();
        List<String> page = Files.readAllLines(DOCS.resolve(Reproduction.PAGE));
        int heading = page.indexOf(table.lines().findFirst().orElseThrow());
        assertTrue(heading > 0, "the page has the table");
        List<String> rows = table.lines().toList();
        int compared = 0;
        for (int i = 0; i < rows.size(); i++) {
            String[] ours = rows.get(i).split(" \\| ");
            String[] theirs = page.get(heading + i).split(" \\| ");
            if (ours.length > 5 && ours[0].matches("\\| \\d+")) {
                assertEquals(List.of(ours).subList(0, 4), List.of(theirs).subList(0, 4));
                String[] medians = ours[4].split(", ");
                String[] spreads = theirs[5].split(", ");
                for (int k = 0; k < medians.length; k++) {
                    String[] range = spreads[k].split(" to ");
                    double median = Double.parseDouble(medians[k]);
                    assertTrue(Double.parseDouble(range[0]) <= median && median <= Double.parseDouble(range[1]),
                            page.get(heading + i) + " against " + rows.get(i));
                    compared++;
                }
            }
        }
        assertEquals(10, compared);
        // the same again is kept, and of another version nothing is
        String again = reproduction.text(List.of("7.2"), 1, new StopSignal(), collecting(done, seconds)).orElseThrow();
        assertEquals(table, again);
        assertEquals(List.of("camera-3", "camera-3"), done);
        assertTrue(seconds.get(0) > 0 && seconds.get(1) == 0, seconds.toString());
    }

    @Test
    void whatIsStoppedGivesNoPage() {
        StopSignal stop = new StopSignal();
        stop.stop();
        List<String> done = new ArrayList<>();
        assertEquals(Optional.empty(), new Reproduction(true, folder, "1").page(2, stop,
                collecting(done, new ArrayList<>())));
        assertEquals(List.of(), done);
        assertFalse(Files.exists(folder.resolve(Reproduction.PAGE)));
    }

    /** Rows of the decision table, made anew. */
    @Test
    void decisionTableOfThePageIsTheOneThatTheCodeGives() throws IOException {
        String page = Files.readString(DOCS.resolve(Reproduction.PAGE));
        for (String arrangement : Layout.ARRANGEMENTS) {
            List<String> cells = new ArrayList<>();
            for (double std : USUAL.at("layouts").at("std_mm").numbers()) {
                cells.add(DecisionSection.both(new Layout(arrangement, 5, std, 100, 0.1).forecast(USUAL,
                        cameraPart())));
            }
            String row = "| 5, " + DecisionSection.words(arrangement) + " | " + String.join(" | ", cells) + " |";
            assertTrue(page.contains(row), "not in docs/thesis.md: " + row);
        }
    }

    private static CheckSettings cameraPart() {
        return CheckSettings.builder().likelihood(LikelihoodModel.RIGID_MARKER).objectNoise(ObjectNoise.NONE).build();
    }

    /** Converged chains of an implementation that shares no code with this one. */
    @Test
    void forecastsAgreeWithTheIndependentImplementationWithinFivePercent() {
        DataNode arrangements = DataNode.ofResource("advice.yaml").at("independent").at("rigid-marker");
        int compared = 0;
        for (String arrangement : arrangements.keys()) {
            for (String std : arrangements.at(arrangement).keys()) {
                String[] figures = arrangements.at(arrangement).at(std).text().split(" ");
                for (int i = 0; i < figures.length; i += 2) {
                    double[] ours = new Layout(arrangement, 2 + i / 2, Double.parseDouble(std), 47, 0.3)
                            .forecast(USUAL, cameraPart());
                    assertTrue(DecisionSection.beyondRounding(figures[i], DecisionTable.worst(ours)) < 0.05,
                            arrangement + " " + std + ": " + ours[2]);
                    assertTrue(DecisionSection.beyondRounding(figures[i + 1], DecisionTable.lateral(ours)) < 0.05,
                            arrangement + " " + std + ": " + ours[0]);
                    compared += 2;
                }
            }
        }
        assertEquals(60, compared);
    }

    /** A slip of the pen in the transcribed tables would be taken for a fault of the thesis. */
    @Test
    void printedTablesAreWhole() {
        Map<String, PrintedTable> tables = PrintedTable.all();
        Map<String, SetUp> setUps = SetUp.all();
        assertEquals(List.of("7.1", "7.2", "7.3", "8.3", "8.4", "8.5", "8.6", "8.7", "8.8", "8.9", "8.10", "8.11",
                "8.12", "8.13", "8.14", "9.1", "9.2", "9.3", "9.4", "9.5", "9.6", "9.7", "9.8"),
                List.copyOf(tables.keySet()));
        tables.values().forEach(table -> assertTrue(setUps.keySet().containsAll(table.setUps()), table.number()));
        // totals that the thesis prints
        assertEquals(List.of("2864", "7135"), tables.get("7.2").row("camera-3", "all", "accepted").figures());
        assertEquals(List.of("3074", "6925"), tables.get("7.3").row("camera-3-focal", "all", "accepted").figures());
        for (String number : List.of("7.2", "7.3")) {
            double[] sum = new double[2];
            for (PrintedTable.Row row : tables.get(number).rows()) {
                for (int i = 0; i < sum.length; i++) {
                    sum[i] += (row.whose().equals("all") ? -1 : 1) * row.values()[i];
                }
            }
            assertEquals(0, Math.abs(sum[0]) + Math.abs(sum[1]), number);
        }
        // Table 9.6 from 9.5, a table that was typed in by itself: geometric means over the three objects
        for (String setUp : tables.get("9.6").setUps()) {
            double product = 1;
            for (String id : List.of("5", "20", "30")) {
                product *= tables.get("9.5").row(setUp, id, "std").values()[2];
            }
            assertEquals(tables.get("9.6").row(setUp, "objects", "std").values()[2], Math.cbrt(product), 0.11, setUp);
        }
    }

    @Test
    void verdictsSayWhatLiesOutside() {
        PrintedTable.Row row = new PrintedTable.Row("any", "5", "std", List.of("2.0", "0.49", "7"));
        Figures figures = new Figures.Builder()
                .put("object.5.std", 1, 0.5, 1, 0, 0, 0, 4, 0.6, 6.4, 0, 0, 0)
                .put("same.object.5.std", 9, 9, 9, 0, 0, 0).put("right.object.5.std", 8, 8, 8, 0, 0, 0).build();
        Comparison comparison = Comparison.of(row, figures, List.of(5));
        // 0.49 may have been 0.495, but not 0.5; 7 was 6.5 at least
        assertEquals("does not agree: y below all 2 chains; z above all 2", comparison.verdict());
        assertFalse(comparison.agrees());
        PrintedTable.Row rounded = new PrintedTable.Row("any", "5", "std", List.of("2.0", "0.5", "6"));
        assertEquals("agrees within the spread, a factor of 6.4",
                Comparison.of(rounded, figures, List.of(5)).verdict());
    }

    /** What does not fit together any more is made again: other assumptions, another version, a damaged file. */
    @Test
    void figuresAreKeptByWhatMadeThem() throws IOException {
        Work work = new Work("a piece", "made of this", () -> new Figures.Builder().put("x", 1, Double.NaN).build());
        KeptFigures kept = new KeptFigures(ResultFolder.into(folder), "1");
        assertEquals(Optional.empty(), kept.of(work));
        kept.keep(work, work.figures().get());
        assertEquals("{\"x\":[1.0,null]}", kept.of(work).orElseThrow().json());
        assertEquals(Optional.empty(), new KeptFigures(ResultFolder.into(folder), "2").of(work));
        assertEquals(Optional.empty(), kept.of(new Work("a piece", "made of that", work.figures())));
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                Files.writeString(file, "{\"x\":[1.0,");
            }
        }
        assertEquals(Optional.empty(), kept.of(work));
    }

    @Test
    void changedAssumptionsAreOthers() {
        List<String> identities = new ArrayList<>(List.of(USUAL.identity()));
        USUAL.changes().values().forEach(change -> identities.add(change.identity()));
        assertEquals(identities.size(), identities.stream().distinct().count());
        Assumptions elsewhere = USUAL.changes().get("camera of Table 9.1");
        assertNotEquals(USUAL.worldFromCamera("usual").toString(), elsewhere.worldFromCamera("usual").toString());
        // what is not changed stays
        assertEquals(USUAL.objects("plane").toString(), elsewhere.objects("plane").toString());
    }
}
