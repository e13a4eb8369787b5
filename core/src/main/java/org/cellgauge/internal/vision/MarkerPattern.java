package org.cellgauge.internal.vision;

import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.vision.FamilyPatterns;

/**
 * The black and white cells of a marker, seen from the front with the marker upright; immutable. A pattern whose border
 * is not a whole number of cells wide is put together of halves of cells.
 */
public final class MarkerPattern {
    private final int cells;
    private final boolean[] white;

    private MarkerPattern(int cells, boolean[] white) {
        this.cells = cells;
        this.white = white;
    }

    /**
     * The pattern of a marker.
     *
     * @param family its family
     * @param id marker id
     * @return its pattern
     * @throws IllegalArgumentException if the family has no such id
     */
    public static MarkerPattern of(MarkerFamily family, int id) {
        if (!family.has(id)) {
            throw new IllegalArgumentException("the family " + family + " has the ids 0 to " + (family.size() - 1)
                    + ", not " + id);
        }
        FamilyPatterns patterns = new FamilyPatterns(family);
        return new MarkerPattern(patterns.squares(), patterns.whiteSquares(id));
    }

    /**
     * A square of one colour, for pictures with a known area.
     *
     * @return an all black pattern of one cell
     */
    public static MarkerPattern solidBlack() {
        return new MarkerPattern(1, new boolean[1]);
    }

    /**
     * Number of cells along an edge, border included.
     *
     * @return at least 1
     */
    public int cells() {
        return cells;
    }

    /**
     * Whether a cell is white.
     *
     * @param row from the top, 0 to {@link #cells()} - 1
     * @param column from the left, 0 to {@link #cells()} - 1
     * @return false for a black cell
     */
    public boolean isWhite(int row, int column) {
        return white[row * cells + column];
    }
}
