package org.cellgauge.desktop;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.internal.warning.Printable;

/** A table of aligned columns for people: first columns flush left, numbers flush right, two spaces between. */
public final class TextTable {
    /** A character that no cell has. */
    private static final String BETWEEN = "\0";

    private final int leftColumns;
    /** Cells joined, since tables of thousands of rows are kept to their end. */
    private final List<String> rows = new ArrayList<>();

    /**
     * An empty table.
     *
     * @param leftColumns how many columns, from the first, are flush left
     */
    public TextTable(int leftColumns) {
        this.leftColumns = leftColumns;
    }

    /**
     * Adds a row; characters of names that command a terminal become spaces.
     *
     * @param cells one text per column
     * @return this
     */
    public TextTable row(String... cells) {
        String[] printable = new String[cells.length];
        for (int c = 0; c < cells.length; c++) {
            printable[c] = Printable.of(cells[c]);
        }
        rows.add(String.join(BETWEEN, printable));
        return this;
    }

    /**
     * The lines.
     *
     * @param indent what every line begins with
     * @return each row on its line, ended by a line feed
     */
    public String text(String indent) {
        int columns = 0;
        for (String row : rows) {
            columns = Math.max(columns, cells(row).length);
        }
        int[] width = new int[columns];
        for (String joined : rows) {
            String[] row = cells(joined);
            for (int c = 0; c < row.length; c++) {
                width[c] = Math.max(width[c], row[c].length());
            }
        }
        StringBuilder text = new StringBuilder();
        for (String joined : rows) {
            String[] row = cells(joined);
            StringBuilder line = new StringBuilder(indent);
            for (int c = 0; c < row.length; c++) {
                String padding = " ".repeat(width[c] - row[c].length());
                line.append(c == 0 ? "" : "  ").append(c < leftColumns ? row[c] + padding : padding + row[c]);
            }
            text.append(line.toString().stripTrailing()).append('\n');
        }
        return text.toString();
    }

    private static String[] cells(String row) {
        return row.split(BETWEEN, -1);
    }
}
