package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** Figure 9.4: deviations with the focal length explored, by the number of references. */
final class EvolutionSection implements Section {
    private static final int FEWEST = 2;
    private static final int MOST = 6;
    private static final List<String> AXES = List.of("x", "y", "z");

    private final PrintedTable printed;
    private final List<Integer> objects;
    private final List<Work> works = new ArrayList<>();

    EvolutionSection(Assumptions assumptions, Map<String, SetUp> setUps, PrintedTable printed, Effort effort) {
        this.printed = printed;
        objects = List.copyOf(assumptions.objects("chapter-9-numbers").keySet());
        printed.setUps().forEach(name ->
                works.add(SetUpWork.of(Objects.requireNonNull(setUps.get(name)), assumptions, effort)));
    }

    @Override
    public String id() {
        return "figure-9.4";
    }

    @Override
    public String title() {
        return "Figure 9.4: evolution of uncertainty with the number of references";
    }

    @Override
    public List<Work> needs() {
        return works;
    }

    @Override
    public void write(Page page, Results results) {
        page.heading(3, title());
        page.paragraph("Focal length explored, 20 mm; geometric means over the objects, as in Table 9.6. From two "
                + "references "
                + "to six: " + Words.and(List.of(change("plane", 0, results), change("plane", 2, results),
                        change("raised", 0, results), change("raised", 2, results))) + ".");
        for (String arrangement : List.of("plane", "raised")) {
            for (int axis = 0; axis < AXES.size(); axis += 2) {
                page.picture("figure-9.4-" + arrangement + "-" + AXES.get(axis) + ".svg",
                        "Deviation of " + AXES.get(axis) + " by the number of references, " + arrangement,
                        diagram(arrangement, axis, results));
            }
        }
    }

    /** How a deviation goes from the fewest references to the most. */
    private String change(String arrangement, int axis, Results results) {
        Comparison.Coordinate few = coordinate(arrangement, FEWEST, axis, results);
        Comparison.Coordinate many = coordinate(arrangement, MOST, axis, results);
        return AXES.get(axis) + (arrangement.equals("plane") ? " in the plane" : " with one raised") + " printed "
                + Words.std(few.printed()) + " to " + Words.std(many.printed()) + ", right " + Words.std(few.right())
                + " to " + Words.std(many.right()) + " mm";
    }

    private Comparison.Coordinate coordinate(String arrangement, int count, int axis, Results results) {
        String name = "focal-" + arrangement + "-" + count;
        return Comparison.of(printed.row(name, "objects", "std"), results.of(name), objects).coordinates().get(axis);
    }

    private Svg diagram(String arrangement, int axis, Results results) {
        double[] counts = new double[MOST - FEWEST + 1];
        double[][] curves = new double[6][counts.length];
        for (int i = 0; i < counts.length; i++) {
            counts[i] = FEWEST + i;
            Comparison.Coordinate c = coordinate(arrangement, FEWEST + i, axis, results);
            curves[0][i] = c.printed();
            curves[1][i] = Words.median(c.repeated());
            curves[2][i] = c.same();
            curves[3][i] = c.right();
            curves[4][i] = Words.min(c.repeated());
            curves[5][i] = Words.max(c.repeated());
        }
        double high = 0;
        double low = Double.POSITIVE_INFINITY;
        for (double[] curve : curves) {
            high = Math.max(high, Words.max(curve));
            low = Math.min(low, Words.min(curve));
        }
        Svg svg = new Svg(430, 280, "std of " + AXES.get(axis) + (arrangement.equals("plane") ? ", all in the plane"
                : ", one raised"), Svg.Axis.linear("references", FEWEST, MOST),
                Svg.Axis.logarithmic("mm", low, high))
                .legend("printed", Svg.ORANGE).legend("repeated", Svg.BLUE).legend("converged", Svg.GREEN)
                .legend("right", Svg.BLACK);
        String[] colours = {Svg.ORANGE, Svg.BLUE, Svg.GREEN, Svg.BLACK};
        for (int k = 0; k < colours.length; k++) {
            svg.line(counts, curves[k], colours[k], 2);
            for (int i = 0; i < counts.length; i++) {
                svg.point(counts[i], curves[k][i], colours[k], 3, true);
                if (k == 1) {
                    svg.bar(counts[i], curves[4][i], curves[5][i], Svg.BLUE, 1.5);
                }
            }
        }
        return svg;
    }
}
