package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** Tables 8.1 and 8.15: what was expected to matter, what the thesis found, and what does. */
final class ExpectationSection implements Section {
    /** By so much a deviation has to change to count as changed. */
    private static final double NOTABLE = 0.1;
    private static final List<Integer> OBJECTS = List.of(5, 20, 30);

    private final List<Work> works = new ArrayList<>();
    private final Map<String, PrintedTable> tables;

    /** One factor: two experiments that differ in it alone. */
    private record Factor(String name, String expected, String found, String from, String to, String tables, int axis) {
    }

    private static final List<Factor> FACTORS = List.of(
            new Factor("plane of the objects", "no", "no", "plane-3-high", "lifted-plane-3-high", "8.8 8.13", 2),
            new Factor("plane of the references, z", "yes, but only of objects in a different plane",
                    "yes, of all objects, but only significantly in z", "plane-3-high", "raised-3-high", "8.8 8.9", 2),
            new Factor("plane of the references, x", "as above", "as above", "plane-3-high", "raised-3-high", "8.8 8.9",
                    0),
            new Factor("plane of the references at 5 mm, z", "as above", "no (section 8.4.3.1)", "plane-3-low",
                    "raised-3-low", "8.6 8.6", 2),
            new Factor("measurement deviation, 5 to 20 mm, x", "yes, always", "yes, always and with high impact",
                    "plane-3-low", "plane-3-high", "8.6 8.6", 0),
            new Factor("measurement deviation, 5 to 20 mm, z", "as above", "as above", "plane-3-low", "plane-3-high",
                    "8.6 8.6", 2),
            new Factor("number of references, 2 to 4, x", "yes, always", "yes, but slightly", "plane-2-high",
                    "plane-4-high", "8.8 8.8", 0),
            new Factor("number of references, 2 to 4, z", "as above", "as above", "plane-2-high", "plane-4-high",
                    "8.8 8.8", 2));

    ExpectationSection(Assumptions assumptions, Map<String, SetUp> setUps, Map<String, PrintedTable> tables,
            Effort effort) {
        this.tables = tables;
        FACTORS.stream().flatMap(f -> List.of(f.from(), f.to()).stream()).distinct().forEach(name ->
                works.add(SetUpWork.of(Objects.requireNonNull(setUps.get(name)), assumptions, effort)));
    }

    @Override
    public String id() {
        return "8.15";
    }

    @Override
    public List<String> alsoCalled() {
        return List.of("8.1");
    }

    @Override
    public String title() {
        return "Tables 8.1 and 8.15: expectations, and what came of them";
    }

    @Override
    public List<Work> needs() {
        return works;
    }

    @Override
    public void write(Page page, Results results) {
        page.heading(3, title());
        page.paragraph("By what factor the deviation changes (root mean square over the objects): as printed, by "
                + "chains of the "
                + "thesis (median, lowest to highest), converged, and by default. (The last row of Table 8.15 is "
                + "missing in "
                + "the copy; the text has it.)");
        List<List<String>> rows = new ArrayList<>();
        for (Factor factor : FACTORS) {
            Figures from = results.of(factor.from());
            Figures to = results.of(factor.to());
            double[] before = chains(from, factor.axis());
            double[] after = chains(to, factor.axis());
            String[] numbers = factor.tables().split(" ");
            double printed = printed(numbers[1], factor.to(), factor.axis())
                    / printed(numbers[0], factor.from(), factor.axis());
            double right = one("right.", to, factor.axis()) / one("right.", from, factor.axis());
            rows.add(List.of(factor.name(), factor.expected(), factor.found(), Words.fixed(printed, 2),
                    Words.fixed(Words.median(after) / Words.median(before), 2) + " ("
                            + Words.fixed(Words.min(after) / Words.max(before), 2) + " to "
                            + Words.fixed(Words.max(after) / Words.min(before), 2) + ")",
                    Words.fixed(one("same.", to, factor.axis()) / one("same.", from, factor.axis()), 2),
                    Words.fixed(right, 2),
                    Math.abs(right - 1) < NOTABLE ? "no" : "yes, " + (right < 1 ? "lower" : "higher")));
        }
        page.table(List.of("factor", "expected (8.1)", "found (8.15)", "printed", "repeated", "converged", "right",
                "does it matter?"), rows);
        page.paragraph("By the rigid likelihood a raised reference changes little where placement is the largest "
                + "error, since "
                + "every reference then tells its own tilt by its four corners; it does lower z where corners count "
                + "on their "
                + "own, or where placement is fine ([decision "
                + "table](#table-816-which-set-up-reaches-which-accuracy)).");
    }

    private static double[] chains(Figures figures, int axis) {
        double[][] each = OBJECTS.stream().map(id -> figures.column("object." + id + ".std", 6, axis))
                .toArray(double[][]::new);
        double[] rms = new double[each[0].length];
        for (int k = 0; k < rms.length; k++) {
            rms[k] = Words.rms(new double[] {each[0][k], each[1][k], each[2][k]});
        }
        return rms;
    }

    /** Root mean square over the objects along one axis. */
    static double one(String prefix, Figures figures, int axis) {
        return Words.rms(OBJECTS.stream().mapToDouble(id -> figures.all(prefix + "object." + id + ".std")[axis])
                .toArray());
    }

    private double printed(String table, String setUp, int axis) {
        return Words.rms(OBJECTS.stream().mapToDouble(id -> Objects.requireNonNull(tables.get(table))
                .row(setUp, Integer.toString(id), "std").values()[axis]).toArray());
    }
}
