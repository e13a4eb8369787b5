package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;

/**
 * One printed row against what the experiment gives: chains of the thesis, its posterior converged, the default.
 *
 * @param row as printed
 * @param coordinates figure by figure
 */
record Comparison(PrintedTable.Row row, List<Coordinate> coordinates) {
    private static final List<String> POSE = List.of("x", "y", "z", "psi", "theta", "phi");
    private static final int ANGLES = 3;
    /** From so many times on, a spread is told. */
    private static final double WIDE = 1.5;

    /**
     * One figure.
     *
     * @param name of the coordinate
     * @param printed NaN where it is missing
     * @param halfDigit by how much rounding may have changed it
     * @param repeated of every chain
     * @param same of the thesis' posterior, converged
     * @param right of the default; NaN where there is no such figure
     * @param decimals to show, -1 for those of a deviation
     */
    record Coordinate(String name, double printed, double halfDigit, double[] repeated, double same, double right,
            int decimals) {
        boolean isPrinted() {
            return Double.isFinite(printed);
        }

        boolean isBelow() {
            return printed + halfDigit < Words.min(repeated);
        }

        boolean isAbove() {
            return printed - halfDigit > Words.max(repeated);
        }

        String shown(double value) {
            return !Double.isFinite(value) ? "–" : decimals < 0 ? Words.std(value) : Words.fixed(value, decimals);
        }
    }

    /** Holds a row against figures of its set-up. */
    static Comparison of(PrintedTable.Row row, Figures figures, List<Integer> objects) {
        List<Coordinate> coordinates = new ArrayList<>();
        double[] printed = row.values();
        boolean counted = row.what().equals("accepted");
        for (int i = 0; i < printed.length; i++) {
            boolean pose = !row.whose().equals("focal") && !counted;
            boolean angle = pose && i >= ANGLES;
            boolean mean = row.what().equals("mean");
            double[] repeated = counted ? figures.column("accepted." + row.whose(), 2, i)
                    : repeated(row, figures, objects, i);
            if (angle && mean) {
                for (int k = 0; k < repeated.length; k++) {
                    repeated[k] = near(repeated[k], printed[i]);
                }
            }
            double same = counted ? Double.NaN : one(row, figures, objects, "same.", i);
            double right = counted ? Double.NaN : one(row, figures, objects, "right.", i);
            String name = counted ? i == 0 ? "accepted" : "rejected" : pose ? POSE.get(i) : i == 0 ? "fx" : "fy";
            coordinates.add(new Coordinate(name, printed[i], Double.isNaN(printed[i]) ? 0 : row.halfDigit(i), repeated,
                    angle && mean ? near(same, printed[i]) : same, angle && mean ? near(right, printed[i]) : right,
                    counted ? 0 : angle ? 3 : mean ? 1 : -1));
        }
        return new Comparison(row, coordinates);
    }

    private static double near(double angle, double other) {
        double about = Double.isNaN(other) ? Math.PI : other;
        return angle + 2 * Math.PI * Math.rint((about - angle) / (2 * Math.PI));
    }

    private static double[] repeated(PrintedTable.Row row, Figures figures, List<Integer> objects, int i) {
        if (!row.whose().equals("objects")) {
            return column(figures, name("", row), i);
        }
        List<double[]> each = objects.stream()
                .map(id -> column(figures, "object." + id + "." + row.what(), i)).toList();
        double[] means = new double[each.get(0).length];
        for (int k = 0; k < means.length; k++) {
            int chain = k;
            means[k] = Words.geometricMean(each.stream().mapToDouble(of -> of[chain]).toArray());
        }
        return means;
    }

    private static double one(PrintedTable.Row row, Figures figures, List<Integer> objects, String prefix, int i) {
        if (!row.whose().equals("objects")) {
            return column(figures, name(prefix, row), i)[0];
        }
        return Words.geometricMean(objects.stream()
                .mapToDouble(id -> column(figures, prefix + "object." + id + "." + row.what(), i)[0]).toArray());
    }

    private static String name(String prefix, PrintedTable.Row row) {
        boolean object = Character.isDigit(row.whose().charAt(0));
        return prefix + (object ? "object." : "") + row.whose() + "." + row.what();
    }

    private static double[] column(Figures figures, String name, int i) {
        return figures.column(name, name.contains("focal.") ? 2 : 6, i);
    }

    String printed() {
        return row.figures().stream().map(f -> f.equals("-") ? "–" : f).collect(Collectors.joining(", "));
    }

    String median() {
        return joined(c -> Words.median(c.repeated()));
    }

    String spread() {
        return coordinates.stream().map(c -> c.shown(Words.min(c.repeated())) + " to "
                + c.shown(Words.max(c.repeated()))).collect(Collectors.joining(", "));
    }

    String same() {
        return joined(Coordinate::same);
    }

    String right() {
        return joined(Coordinate::right);
    }

    private String joined(ToDoubleFunction<Coordinate> figure) {
        String all = coordinates.stream().map(c -> c.shown(figure.applyAsDouble(c))).collect(Collectors.joining(", "));
        return all.matches("[–, ]+") ? "" : all;
    }

    /**
     * Figures that can be judged: how objects really were turned is not known, so their mean angles say nothing.
     */
    private List<Coordinate> judged() {
        boolean object = Character.isDigit(row.whose().charAt(0)) || row.whose().equals("objects");
        return coordinates.stream().limit(object && row.what().equals("mean") ? ANGLES : POSE.size())
                .filter(Coordinate::isPrinted).toList();
    }

    /** Whether every printed figure lies among those of the chains. */
    boolean agrees() {
        return judged().stream().noneMatch(c -> c.isBelow() || c.isAbove());
    }

    /** Whether a printed figure lies below those of all chains. */
    boolean hasBelow() {
        return judged().stream().anyMatch(Coordinate::isBelow);
    }

    /** In words. */
    String verdict() {
        List<Coordinate> printed = judged();
        if (printed.isEmpty()) {
            return "not to be judged: the object's pose is not known";
        }
        String below = names(printed.stream().filter(Coordinate::isBelow).toList());
        String above = names(printed.stream().filter(Coordinate::isAbove).toList());
        if (below.isEmpty() && above.isEmpty()) {
            double factor = row.what().equals("std") ? printed.stream()
                    .mapToDouble(c -> Words.max(c.repeated()) / Words.min(c.repeated()))
                    .filter(Double::isFinite).max().orElse(1) : 1;
            return "agrees within the spread" + (factor > WIDE ? ", a factor of " + Words.std(factor) : "");
        }
        int chains = coordinates.get(0).repeated().length;
        return "does not agree: " + (below.isEmpty() ? "" : below + " below all " + chains + " chains")
                + (below.isEmpty() || above.isEmpty() ? "" : "; ")
                + (above.isEmpty() ? "" : above + " above all " + chains);
    }

    private static String names(List<Coordinate> some) {
        return Words.and(some.stream().map(Coordinate::name).toList());
    }
}
