package org.cellgauge.desktop.reproduce;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A table of the thesis, as printed; immutable.
 *
 * @param number such as {@code 8.5}
 * @param title its caption, in short
 * @param section where it stands
 * @param note what is to be known of the copy; empty where nothing is
 * @param rows its figures
 */
record PrintedTable(String number, String title, String section, String note, List<Row> rows) {
    /**
     * Figures of one kind.
     *
     * @param setUp the experiment
     * @param whose an object's id, {@code objects}, {@code camera}, {@code focal} or a proposal
     * @param what {@code mean}, {@code std} or {@code accepted}
     * @param figures as printed, a dash where the copy is damaged
     */
    record Row(String setUp, String whose, String what, List<String> figures) {
        /** The figures as numbers; NaN where they are missing. */
        double[] values() {
            return figures.stream().mapToDouble(f -> f.equals("-") ? Double.NaN : Double.parseDouble(f)).toArray();
        }

        /** By how much a figure may differ from what it was rounded from. */
        double halfDigit(int figure) {
            String digits = figures.get(figure);
            int point = digits.indexOf('.');
            return 0.5 * Math.pow(10, point < 0 ? 0 : point + 1 - digits.length());
        }
    }

    /** All tables of the file, by number. */
    static Map<String, PrintedTable> all() {
        DataNode file = DataNode.ofResource("printed.yaml");
        Map<String, PrintedTable> all = new LinkedHashMap<>();
        for (String number : file.keys()) {
            DataNode table = file.at(number);
            List<Row> rows = new ArrayList<>();
            for (DataNode row : table.at("rows").items()) {
                List<String> cells = row.texts();
                rows.add(new Row(cells.get(0), cells.get(1), cells.get(2), List.of(cells.get(3).split(" "))));
            }
            all.put(number, new PrintedTable(number, table.at("title").text(), table.at("section").text(),
                    table.has("note") ? table.at("note").text() : "", List.copyOf(rows)));
        }
        return all;
    }

    /** Set-ups whose figures it has, in their order. */
    List<String> setUps() {
        return rows.stream().map(Row::setUp).distinct().toList();
    }

    /** The row of a set-up. */
    Row row(String setUp, String whose, String what) {
        return rows.stream()
                .filter(r -> r.setUp().equals(setUp) && r.whose().equals(whose) && r.what().equals(what)).findFirst()
                .orElseThrow(() -> new IllegalStateException(number + " has no " + what + " of " + whose));
    }
}
