package org.cellgauge.warning;

import org.cellgauge.internal.warning.Printable;

/**
 * A place in an input: a file or photo, and in it a line, a column and a key as far as they are known; immutable.
 * Control characters in names are kept as spaces, and a long key is cut.
 */
public final class Place {
    private final String file;
    private final int line;
    private final int column;
    private final String key;

    private Place(String file, int line, int column, String key) {
        this.file = Printable.of(file);
        this.line = line;
        this.column = column;
        this.key = Printable.shortened(key);
    }

    /**
     * A file as a whole.
     *
     * @param file its name as people know it
     * @return the place
     */
    public static Place of(String file) {
        return new Place(file, 0, 0, "");
    }

    /**
     * A place in a file.
     *
     * @param file its name as people know it
     * @param line from 1 on; 0 where it is not known
     * @param column from 1 on; 0 where it is not known
     * @param key the path of a key; empty where there is none
     * @return the place
     */
    public static Place of(String file, int line, int column, String key) {
        return new Place(file, line, column, key);
    }

    /**
     * The file or photo.
     *
     * @return its name as people know it
     */
    public String file() {
        return file;
    }

    /**
     * The line.
     *
     * @return from 1 on, or 0 where it is not known
     */
    public int line() {
        return line;
    }

    /**
     * The column.
     *
     * @return from 1 on, or 0 where it is not known
     */
    public int column() {
        return column;
    }

    /**
     * The path of the key.
     *
     * @return as in {@code references.944.position_mm[1]}; empty where there is none
     */
    public String key() {
        return key;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Place && toString().equals(other.toString());
    }

    @Override
    public int hashCode() {
        return toString().hashCode();
    }

    /** The place in English, as in "cell.yaml, line 7, references.944". */
    @Override
    public String toString() {
        return file + (line > 0 ? ", line " + line : "") + (column > 0 ? ", column " + column : "")
                + (key.isEmpty() ? "" : ", " + key);
    }
}
