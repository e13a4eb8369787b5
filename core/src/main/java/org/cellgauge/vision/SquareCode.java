package org.cellgauge.vision;

import boofcv.factory.fiducial.ConfigHammingMarker;
import org.jspecify.annotations.Nullable;

/**
 * Tells a marker by how dark its cells are, in any of the four ways it may be turned: in a grid of square-binary by its
 * one black corner, in a dictionary by the code that differs least. Not thread-safe: the last reading is kept.
 */
final class SquareCode {
    /** How much a cell that is neither clearly dark nor bright counts of one that is wrong; BoofCV's. */
    private static final double DOUBTFUL_PER_WRONG = 0.5;

    private final int cells;
    /** White cells of each marker as bits, row by row, the first the highest; null for square-binary. */
    private final long @Nullable [] codes;
    private final int smallestDistance;
    private final boolean[] black;
    private final boolean[] turning;
    private long id;
    private int turns;

    /** A code for the markers of a family. */
    SquareCode(FamilyPatterns patterns) {
        this.cells = patterns.grid().codeCells();
        this.black = new boolean[cells * cells];
        this.turning = new boolean[cells * cells];
        ConfigHammingMarker dictionary = patterns.dictionary();
        this.codes = dictionary == null ? null : codes(dictionary, cells * cells);
        this.smallestDistance = dictionary == null ? 0 : dictionary.minimumHamming;
    }

    private static long[] codes(ConfigHammingMarker dictionary, int bits) {
        if (bits > Long.SIZE) {
            throw new IllegalArgumentException("codes of " + bits + " cells");
        }
        long[] codes = new long[dictionary.encoding.size()];
        for (int id = 0; id < codes.length; id++) {
            for (int bit = bits - 1; bit >= 0; bit--) {
                codes[id] = codes[id] << 1 | dictionary.encoding.get(id).pattern.get(bit);
            }
        }
        return codes;
    }

    /**
     * Reads a square.
     *
     * @param dark number of dark places in each cell of the code, row by row
     * @param places number of places in each
     * @return whether it is a marker's
     */
    boolean read(int[] dark, int places) {
        int doubtful = 0;
        int blackCells = 0;
        for (int cell = 0; cell < black.length; cell++) {
            black[cell] = 2 * dark[cell] > places;
            blackCells += black[cell] ? 1 : 0;
            doubtful += 4 * Math.min(dark[cell], places - dark[cell]) >= places ? 1 : 0;
        }
        // a plain square may be no more wrong than the nearest code is
        return codes == null ? readGrid()
                : readCode(codes, doubtful, Math.min(blackCells, black.length - blackCells));
    }

    /** The id of what was read last. */
    long id() {
        return id;
    }

    /** By how many quarters clockwise what was read last has to be turned to stand upright. */
    int turns() {
        return turns;
    }

    private boolean readGrid() {
        int last = cells - 1;
        int blackCorners = 0;
        int seen = 0;
        // from the lower left, where the black corner belongs, against the clock: where turns would bring it from
        int[] corners = {last * cells, last * cells + last, last, 0};
        for (int i = 0; i < 4; i++) {
            if (black[corners[i]]) {
                blackCorners++;
                seen = i;
            }
        }
        if (blackCorners != 1) {
            return false;
        }
        for (turns = 0; turns < seen; turns++) {
            turn();
        }
        id = 0;
        int bit = 0;
        for (int row = last; row >= 0; row--) {
            for (int column = 0; column < cells; column++) {
                boolean corner = (row == 0 || row == last) && (column == 0 || column == last);
                if (!corner) {
                    id |= (black[row * cells + column] ? 1L : 0) << bit++;
                }
            }
        }
        return true;
    }

    private boolean readCode(long[] ofIds, int doubtful, int wrongIfPlain) {
        int least = Integer.MAX_VALUE;
        for (int turned = 0; turned < 4 && least > 0; turned++) {
            long seen = 0;
            for (boolean isBlack : black) {
                seen = seen << 1 | (isBlack ? 0 : 1);
            }
            for (int i = 0; i < ofIds.length && least > 0; i++) {
                int wrong = Long.bitCount(seen ^ ofIds[i]);
                if (wrong < least) {
                    least = wrong;
                    id = i;
                    turns = turned;
                }
            }
            turn();
        }
        return least + DOUBTFUL_PER_WRONG * doubtful <= smallestDistance && least < wrongIfPlain;
    }

    /** Turns the cells by a quarter, clockwise. */
    private void turn() {
        for (int row = 0; row < cells; row++) {
            for (int column = 0; column < cells; column++) {
                turning[row * cells + column] = black[(cells - 1 - column) * cells + row];
            }
        }
        System.arraycopy(turning, 0, black, 0, black.length);
    }
}
