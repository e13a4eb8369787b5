package org.cellgauge.desktop;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.cellgauge.check.Conformity;
import org.cellgauge.internal.warning.Printable;
import org.cellgauge.output.ChainsView;
import org.cellgauge.output.ResultRow;
import org.cellgauge.output.ResultView;

/**
 * Rows of the table of a run, {@code summary.csv}: one per photo and object (RFC 4180). What is unknown is left empty.
 * A text that begins like a formula has an apostrophe before it.
 */
final class SummaryCsv {
    private static final String[] COLUMNS = {"input", "name", "verdict", "object", "seen", "x_mm", "y_mm", "z_mm",
        "std_x_mm", "std_y_mm", "std_z_mm", "grip_x_mm", "grip_y_mm", "grip_z_mm", "grip_std_x_mm", "grip_std_y_mm",
        "grip_std_z_mm", "worst_std_mm", "target_std_mm", "within_target", "probability",
        "probability_mcse", "probability_asked", "converged", "r_hat_max", "ess_bulk_min",
        "ess_tail_min", "mcse_std_rel_max", "reason", "action"};

    private static final String FORMULA = "=+-@";

    private SummaryCsv() {
    }

    /** The header. */
    static String header() {
        return line(List.of(COLUMNS));
    }

    /** The rows of a result: each object of the cell, or one row where it has none. */
    static String rows(CheckInput input, ResultView view) {
        if (view.objects().isEmpty()) {
            return row(input, view, null);
        }
        StringBuilder rows = new StringBuilder();
        view.objects().forEach(object -> rows.append(row(input, view, object)));
        return rows.toString();
    }

    /** The row of an input that gave no result. */
    static String row(CheckInput input, String verdict, String reason) {
        List<String> cells = new ArrayList<>(List.of(text(input.file().toString()), text(input.name()), verdict));
        while (cells.size() < COLUMNS.length - 2) {
            cells.add("");
        }
        cells.add(text(reason));
        cells.add("");
        return line(cells);
    }

    private static String row(CheckInput input, ResultView view, ResultRow object) {
        List<String> cells = new ArrayList<>(List.of(text(input.file().toString()), text(input.name()),
                view.verdict().key()));
        boolean seen = object != null && object.seen();
        cells.add(object == null ? "" : String.valueOf(object.id().getAsInt()));
        cells.add(object == null ? "" : String.valueOf(seen));
        boolean shown = seen && view.showsFigures();
        numbers(cells, shown ? object.mean() : null);
        numbers(cells, shown ? object.std() : null);
        ResultRow grip = shown ? view.grip(object.id().getAsInt()) : null;
        numbers(cells, grip != null ? grip.mean() : null);
        numbers(cells, grip != null ? grip.std() : null);
        cells.add(shown ? number(view.worstStdMm(object)) : "");
        cells.add(number(view.targetStdMm().orElse(Double.NaN)));
        cells.add(seen && object.withinTarget() != null ? String.valueOf(object.withinTarget()) : "");
        conformity(cells, shown ? leastSure(object, grip) : null);
        ChainsView chains = view.chains();
        cells.add(String.valueOf(chains.converged()));
        cells.add(number(chains.rHatMax()));
        cells.add(number(chains.essBulkMin()));
        cells.add(number(chains.essTailMin()));
        cells.add(number(chains.mcseStdRelMax()));
        cells.add(text(view.reason()));
        cells.add(view.action() == null ? "" : text(view.action()));
        return line(cells);
    }

    /** The tolerance of position or gripping point that is kept least surely, or null. */
    private static Conformity leastSure(ResultRow object, ResultRow grip) {
        return Stream.concat(object.conformities().stream(), grip == null ? Stream.empty()
                : grip.conformities().stream())
                .min(Comparator.comparingDouble(c -> c.probability() - c.asked())).orElse(null);
    }

    private static void conformity(List<String> cells, Conformity c) {
        cells.add(c == null ? "" : number(c.probability()));
        cells.add(c == null ? "" : number(c.mcse()));
        cells.add(c == null ? "" : number(c.asked()));
    }

    private static void numbers(List<String> cells, double[] values) {
        for (int i = 0; i < 3; i++) {
            cells.add(values == null ? "" : number(values[i]));
        }
    }

    /** A text that no program of tables takes for a formula, however a file is called. */
    private static String text(String text) {
        String printable = Printable.of(text);
        return printable.isEmpty() || FORMULA.indexOf(printable.charAt(0)) < 0 ? printable : "'" + printable;
    }

    private static String number(double value) {
        return Double.isFinite(value) ? Double.toString(value) : "";
    }

    private static String line(List<String> cells) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < cells.size(); i++) {
            String cell = cells.get(i);
            boolean quote = cell.contains(",") || cell.contains("\"") || cell.contains("\n") || cell.contains("\r");
            text.append(i == 0 ? "" : ",").append(quote ? '"' + cell.replace("\"", "\"\"") + '"' : cell);
        }
        return text.append("\r\n").toString();
    }
}
