package org.cellgauge.vision;

/**
 * The lattice of a marker: bands of cells in both directions, border included; immutable.
 *
 * <p>All cells are squares of one size but for the outermost: a border that is a whole number of cells and a half, as
 * square-binary markers of an odd grid have it, has half cells there. Places along an edge are in cells.
 */
final class MarkerGrid {
    private final int bands;
    private final int borderBands;
    private final boolean halved;

    private MarkerGrid(int bands, int borderBands, boolean halved) {
        this.bands = bands;
        this.borderBands = borderBands;
        this.halved = halved;
    }

    /**
     * A lattice.
     *
     * @param codeCells cells along the code, without the border
     * @param borderHalfCells width of the border on each side in halves of a cell, at least 1
     */
    static MarkerGrid of(int codeCells, int borderHalfCells) {
        int borderBands = (borderHalfCells + 1) / 2;
        return new MarkerGrid(codeCells + 2 * borderBands, borderBands, borderHalfCells % 2 != 0);
    }

    /** Bands along an edge: whole cells, and the half ones outside. */
    int bands() {
        return bands;
    }

    /** Bands of the black border on each side. */
    int borderBands() {
        return borderBands;
    }

    /** Cells along the code. */
    int codeCells() {
        return bands - 2 * borderBands;
    }

    /** Width of the border on each side, cells. */
    double borderCells() {
        return line(borderBands);
    }

    /** Width of the marker, cells. */
    double cells() {
        return line(bands);
    }

    /**
     * Where a band begins.
     *
     * @param band 0 to {@link #bands()}, which is the end of the last
     * @return distance from the marker's edge, cells
     */
    double line(int band) {
        if (!halved || band == 0) {
            return band;
        }
        return band == bands ? bands - 1 : band - 0.5;
    }

    /** Middle of a band, cells from the marker's edge. */
    double middle(int band) {
        return (line(band) + line(band + 1)) / 2;
    }

    /** Number of equal squares along an edge that the pattern can be put together of: cells, or halves of them. */
    int squares() {
        return halved ? 2 * (bands - 1) : bands;
    }

    /** The band that one of the equal squares lies in. */
    int bandOf(int square) {
        return halved ? (square + 1) / 2 : square;
    }
}
