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
    private final boolean whiteAround;

    private MarkerPattern(int cells, boolean[] white, boolean whiteAround) {
        this.cells = cells;
        this.white = white;
        this.whiteAround = whiteAround;
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
        return new MarkerPattern(patterns.squares(), patterns.whiteSquares(id), true);
    }

    /**
     * A square of one colour, for pictures with a known area.
     *
     * @return an all black pattern of one cell
     */
    public static MarkerPattern solidBlack() {
        return new MarkerPattern(1, new boolean[1], true);
    }

    /**
     * The pattern with black and white exchanged, the paper around it included.
     *
     * @return another pattern
     */
    public MarkerPattern inverted() {
        boolean[] out = new boolean[white.length];
        for (int i = 0; i < out.length; i++) {
            out[i] = !white[i];
        }
        return new MarkerPattern(cells, out, !whiteAround);
    }

    /**
     * The pattern as a mirror shows it, left and right exchanged.
     *
     * @return another pattern
     */
    public MarkerPattern mirrored() {
        boolean[] out = new boolean[white.length];
        for (int i = 0; i < out.length; i++) {
            out[i] = white[i / cells * cells + cells - 1 - i % cells];
        }
        return new MarkerPattern(cells, out, whiteAround);
    }

    /**
     * The pattern turned in its place.
     *
     * @param quarters by how many quarters clockwise; negative: counter-clockwise
     * @return another pattern
     */
    public MarkerPattern turnedClockwise(int quarters) {
        boolean[] out = white;
        for (int turn = 0; turn < Math.floorMod(quarters, 4); turn++) {
            boolean[] next = new boolean[out.length];
            for (int i = 0; i < next.length; i++) {
                next[i] = out[(cells - 1 - i % cells) * cells + i / cells];
            }
            out = next;
        }
        return new MarkerPattern(cells, out, whiteAround);
    }

    /**
     * Whether the paper around the marker is white.
     *
     * @return false for an {@linkplain #inverted() inverted} one
     */
    public boolean isWhiteAround() {
        return whiteAround;
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
