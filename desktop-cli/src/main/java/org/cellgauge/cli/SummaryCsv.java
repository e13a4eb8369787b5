package org.cellgauge.cli;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.check.CheckResult;
import org.cellgauge.estimate.ObjectEstimate;

/** The table of a run, {@code summary.csv}: one row per photo and object (RFC 4180). What is unknown is left empty. */
final class SummaryCsv {
    private static final String[] COLUMNS = {"input", "name", "verdict", "object", "seen", "x_mm", "y_mm", "z_mm",
        "std_x_mm", "std_y_mm", "std_z_mm", "grip_x_mm", "grip_y_mm", "grip_z_mm", "grip_std_x_mm", "grip_std_y_mm",
        "grip_std_z_mm", "worst_std_mm", "target_std_mm", "within_target", "converged", "r_hat_max", "ess_bulk_min",
        "ess_tail_min", "mcse_std_rel_max", "reason"};

    private final StringBuilder text = new StringBuilder();

    /** A table of a header alone. */
    SummaryCsv() {
        line(List.of(COLUMNS));
    }

    /** Adds the rows of a result: each object of the cell, or one row where it has none. */
    void add(CheckInput input, CheckResult result) {
        if (result.cell().objects().isEmpty()) {
            row(input, result, null, null);
        }
        for (ObjectMarker marker : result.cell().objects()) {
            row(input, result, marker, result.estimate().object(marker.id()));
        }
    }

    /** Adds the row of an input that gave no result. */
    void add(CheckInput input, String verdict, String reason) {
        List<String> cells = new ArrayList<>(List.of(input.file().toString(), input.name(), verdict));
        while (cells.size() < COLUMNS.length - 1) {
            cells.add("");
        }
        cells.add(reason);
        line(cells);
    }

    private void row(CheckInput input, CheckResult result, ObjectMarker marker, ObjectEstimate object) {
        List<String> cells = new ArrayList<>(List.of(input.file().toString(), input.name(), result.verdict().key()));
        cells.add(marker == null ? "" : String.valueOf(marker.id()));
        cells.add(marker == null ? "" : String.valueOf(object != null));
        numbers(cells, object == null ? null : object.pose().mean());
        numbers(cells, object == null ? null : object.pose().std());
        boolean grip = object != null && object.grip() != null;
        numbers(cells, grip ? object.grip().meanMm() : null);
        numbers(cells, grip ? object.grip().stdMm() : null);
        cells.add(object == null ? "" : number(object.worstStdMm()));
        cells.add(number(result.cell().targetStdMm().orElse(Double.NaN)));
        boolean judged = object != null && result.cell().targetStdMm().isPresent()
                && CheckText.caution(result).isEmpty();
        cells.add(judged ? String.valueOf(result.referenceCheck().meets(object,
                result.cell().targetStdMm().getAsDouble())) : "");
        cells.add(String.valueOf(result.diagnostics().converged()));
        cells.add(number(result.diagnostics().rHatMax()));
        cells.add(number(result.diagnostics().essBulkMin()));
        cells.add(number(result.diagnostics().essTailMin()));
        cells.add(number(result.diagnostics().mcseStdRelMax()));
        cells.add(result.reason());
        line(cells);
    }

    private static void numbers(List<String> cells, double[] values) {
        for (int i = 0; i < 3; i++) {
            cells.add(values == null ? "" : number(values[i]));
        }
    }

    private static String number(double value) {
        return Double.isFinite(value) ? Double.toString(value) : "";
    }

    private void line(List<String> cells) {
        for (int i = 0; i < cells.size(); i++) {
            String cell = cells.get(i);
            boolean quote = cell.contains(",") || cell.contains("\"") || cell.contains("\n") || cell.contains("\r");
            text.append(i == 0 ? "" : ",").append(quote ? '"' + cell.replace("\"", "\"\"") + '"' : cell);
        }
        text.append("\r\n");
    }

    /** The table so far. */
    String text() {
        return text.toString();
    }
}
