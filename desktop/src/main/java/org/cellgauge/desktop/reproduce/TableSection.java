package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.ToDoubleFunction;

/** A printed table beside what its experiments give. */
final class TableSection implements Section {
    private static final int ROW_PX = 64;
    private static final int EDGE_PX = 160;
    private static final double[] OFFSETS = {-0.25, 0, 0.25};
    /** A deviation that is no more than rounding of a chain that stands still. */
    private static final double NOTHING = 1e-9;

    private final PrintedTable table;
    private final Map<String, SetUp> setUps;
    private final Assumptions assumptions;
    private final Effort effort;

    TableSection(PrintedTable table, Map<String, SetUp> setUps, Assumptions assumptions, Effort effort) {
        this.table = table;
        this.setUps = setUps;
        this.assumptions = assumptions;
        this.effort = effort;
    }

    @Override
    public String id() {
        return table.number();
    }

    @Override
    public String title() {
        return "Table " + table.number() + ": " + table.title();
    }

    @Override
    public List<Work> needs() {
        return table.setUps().stream().map(name -> SetUpWork.of(setUp(name), assumptions, effort)).toList();
    }

    private SetUp setUp(String name) {
        return Objects.requireNonNull(setUps.get(name), () -> "no set-up is called " + name);
    }

    @Override
    public void write(Page page, Results results) {
        List<Comparison> comparisons = table.rows().stream().map(row -> Comparison.of(row,
                results.of(row.setUp()),
                List.copyOf(assumptions.objects(setUp(row.setUp()).objects()).keySet()))).toList();
        page.heading(3, title());
        page.paragraph(("Section " + table.section() + ". " + table.note()).strip());
        boolean counts = comparisons.stream().allMatch(c -> c.row().what().equals("accepted"));
        List<List<String>> rows = new ArrayList<>();
        for (Comparison c : comparisons) {
            List<String> cells = new ArrayList<>(List.of(Integer.toString(rows.size() + 1),
                    setUp(c.row().setUp()).words(), whose(c.row()), c.printed(), c.median(), c.spread()));
            cells.addAll(counts ? List.of() : List.of(c.same(), c.right()));
            cells.add(c.verdict());
            rows.add(cells);
        }
        List<String> head = new ArrayList<>(List.of("", "experiment", "figures", "printed",
                "repeated, median of " + effort.seeds(), "lowest to highest"));
        head.addAll(counts ? List.of() : List.of("converged", "right"));
        head.add("verdict");
        page.table(head, rows);
        page.paragraph(inAll(comparisons, results));
        List<Comparison> deviations = comparisons.stream()
                .filter(c -> c.row().what().equals("std") && c.coordinates().size() >= OFFSETS.length).toList();
        if (deviations.size() > 1) {
            page.picture("table-" + table.number() + ".svg", "Deviations of Table " + table.number(),
                    diagram(deviations, comparisons));
        }
    }

    private static String whose(PrintedTable.Row row) {
        String of = Character.isDigit(row.whose().charAt(0)) ? "object " + row.whose() : row.whose();
        return row.what().equals("accepted") ? row.whose() : row.what() + " of " + of;
    }

    /** How far chains of the thesis can be trusted here, which is the reason of most verdicts. */
    private String inAll(List<Comparison> comparisons, Results results) {
        long agreeing = comparisons.stream().filter(Comparison::agrees).count();
        List<Figures> figures = table.setUps().stream().map(results::of).toList();
        boolean objects = figures.stream().allMatch(f -> f.has("rhat.objects"));
        String of = objects ? "objects" : "camera";
        double rHat = Words.median(all(figures, "rhat." + of));
        double ess = Words.median(all(figures, "ess." + of));
        StringBuilder words = new StringBuilder("**" + agreeing + " of " + comparisons.size()
                + " rows agree within the spread of " + effort.seeds() + " chains.** ");
        words.append("R-hat of four chains, ").append(of).append(": ").append(Words.fixed(rHat, 2))
                .append(" (median), effective draws of each 5000: ").append(Words.std(ess)).append(". ");
        long smaller = comparisons.stream().filter(c -> c.row().what().equals("std") && c.hasBelow()).count();
        if (smaller > 0) {
            words.append("In ").append(smaller).append(smaller == 1 ? " row" : " rows")
                    .append(" a printed deviation is smaller than that of every chain: as described, and with the box ")
                    .append("that gives the acceptance of Table 7.2, the algorithm does not give it. ");
        }
        double[] ofConverged = ratios(comparisons, c -> Words.median(c.repeated()) / c.same());
        if (ofConverged.length > 0) {
            words.append("A chain of the thesis states ").append(Words.fixed(Words.median(ofConverged), 2))
                    .append(" of the converged deviation of its own posterior (median; ")
                    .append(Words.fixed(Words.min(ofConverged), 2)).append(" to ")
                    .append(Words.fixed(Words.max(ofConverged), 2)).append("). ");
        }
        double[] printedOfRight = ratios(comparisons, c -> c.printed() / c.right());
        if (printedOfRight.length > 0) {
            words.append("What is printed is ").append(Words.fixed(Words.median(printedOfRight), 2))
                    .append(" of what is right (median). ");
        }
        double[] turned = all(figures, "turned");
        long still = Arrays.stream(turned).filter(t -> t < NOTHING).count();
        if (still > 0) {
            words.append("In ").append(still).append(" of ").append(turned.length)
                    .append(" chains the camera never turned among the kept draws. ");
        }
        for (String name : table.setUps()) {
            if (results.of(name).one("same.converged") == 0) {
                words.append("The thesis' posterior of ").append(setUp(name).words())
                        .append(" did not converge either (R-hat ")
                        .append(Words.fixed(results.of(name).one("same.rhat"), 2))
                        .append("): its column is no figure to trust. ");
            }
            if (results.of(name).one("right.converged") == 0) {
                words.append("The default did not converge for ").append(setUp(name).words()).append(". ");
            }
        }
        return words.toString().strip();
    }

    private static double[] all(List<Figures> figures, String name) {
        return figures.stream().flatMapToDouble(f -> Arrays.stream(f.all(name))).toArray();
    }

    /** Of positions alone: of rotations as printed, often nothing is left after rounding. */
    private static double[] ratios(List<Comparison> comparisons, ToDoubleFunction<Comparison.Coordinate> ratio) {
        return comparisons.stream().filter(c -> c.row().what().equals("std"))
                .flatMap(c -> c.coordinates().stream().limit(OFFSETS.length)).mapToDouble(ratio)
                .filter(Double::isFinite).toArray();
    }

    private Svg diagram(List<Comparison> deviations, List<Comparison> all) {
        List<Comparison.Coordinate> drawn = deviations.stream()
                .flatMap(c -> c.coordinates().stream().limit(OFFSETS.length)).toList();
        double[] values = drawn.stream().flatMapToDouble(c -> Arrays.stream(new double[] {c.printed(),
            Words.min(c.repeated()), Words.max(c.repeated()), c.same(), c.right()}))
                .filter(v -> Double.isFinite(v) && v > 0).toArray();
        Svg svg = new Svg(EDGE_PX + ROW_PX * Math.max(6, deviations.size()), 300,
                "Table " + table.number() + ": std of x, y, z by row",
                Svg.Axis.linear("", -0.5, deviations.size() - 0.5),
                Svg.Axis.logarithmic("mm", Math.max(0.05, Words.min(values)), Words.max(values)))
                .legend("printed", Svg.ORANGE).legend("repeated", Svg.BLUE).legend("converged", Svg.GREEN)
                .legend("right", Svg.BLACK);
        for (int i = 0; i < deviations.size(); i++) {
            Comparison comparison = deviations.get(i);
            svg.under(i, Integer.toString(all.indexOf(comparison) + 1));
            for (int k = 0; k < OFFSETS.length; k++) {
                Comparison.Coordinate c = comparison.coordinates().get(k);
                double at = i + OFFSETS[k];
                svg.bar(at, Math.max(0.05, Words.min(c.repeated())), Words.max(c.repeated()), Svg.BLUE, 4);
                svg.point(at, Words.median(c.repeated()), Svg.BLUE, 3.5, true);
                svg.point(at, c.same(), Svg.GREEN, 4, false);
                svg.point(at, c.right(), Svg.BLACK, 3, true);
                svg.point(at, c.printed(), Svg.ORANGE, 4, true);
            }
        }
        return svg;
    }
}
