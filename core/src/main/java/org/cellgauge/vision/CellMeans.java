package org.cellgauge.vision;

import boofcv.struct.image.GrayU8;
import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * Marks pixels that are darker than a share of the mean about them, in rows of tiles: that of the 20 x 20 pixels about
 * the middles of cells of 4 x 4, and between these interpolated, down to rows and pairs of pixels: so eight pixels at a
 * time are compared with theirs. (One mean for a whole cell gives steps in blurred edges, and squares are lost.) Not
 * thread-safe: sums are kept. Several may mark other rows of one image at a time.
 */
final class CellMeans {
    private static final int TILE = LocalMeanThreshold.TILE;
    private static final int CELL = LocalMeanThreshold.CELL;
    private static final int REACH = LocalMeanThreshold.REACH;
    private static final int CELLS = TILE / CELL;
    /** Rows of cells whose limits are kept: of a tile, and one more on each side. */
    private static final int LIMITED = CELLS + 2;
    /** Limits of cells are in parts of a grey level. */
    private static final int PARTS = 8;
    private static final long EIGHTHS = 8;
    /** Rows of tiles whose cells' sums are kept. */
    private static final int KEPT = 3;
    private static final int NONE = -1;
    /** Pixels that a mean is over. */
    private static final int WHOLE = (2 * REACH + 1) * CELL * (2 * REACH + 1) * CELL;
    /** A sum of a mean's pixels, of 17 bits, times so many bits of what it is to be multiplied with stays below 32. */
    private static final int RECIPROCAL_BITS = 20;
    private static final long EVERY_SECOND = TileContrast.EVERY_SECOND;
    private static final long BEYOND_EACH = TileContrast.BEYOND_EACH;
    private static final int BITS = TileContrast.BITS;
    private static final long IN_EACH = TileContrast.IN_EACH;
    private static final ByteBuffer NO_PIXELS = ByteBuffer.allocate(0);

    private final int percent;
    private final TileContrast contrast;
    private final DarkBits dark;
    /** Those of the image at hand, to be read eight at a time. */
    private ByteBuffer pixels = NO_PIXELS;
    private int width;
    private int height;
    private int tilesAcross;
    private int tilesDown;
    private int cellsAcross;
    private int cellsDown;
    /** Of the pixels of each cell, in three rows of tiles, by row number modulo their count. */
    private int[] sums = new int[0];
    /** Which row of tiles these are of, in each tile of those rows. */
    private int[] summed = new int[0];
    /** Sums of cells below each other, about a row of cells. */
    private int[] columns = new int[0];
    /** The row, and its cells from and to which, of these; or none. */
    private int columnsOf;
    private int columnsFrom;
    private int columnsTo;
    /** The brightest grey that is dark in the middle of each cell of a row, in parts. */
    private int[] limits = new int[0];
    /**
     * The same between the middles, of four pairs of pixels in a number, in rows of cells by row number modulo their
     * count; in quarters of parts.
     */
    private final long[][] ofPairs = new long[LIMITED][0];
    /** Which row of cells these are of, and from and to which tile. */
    private final int[] limited = new int[LIMITED];
    private final int[] limitedFrom = new int[LIMITED];
    private final int[] limitedTo = new int[LIMITED];
    /** Tiles from and to which cells are summed, and those of them that are gone through, of each run of a row. */
    private int[] runs = new int[0];

    /**
     * Means.
     *
     * @param percent of the mean at which black begins, below 100
     * @param contrast which tiles to go through
     * @param dark where pixels are marked
     */
    CellMeans(int percent, TileContrast contrast, DarkBits dark) {
        this.percent = percent;
        this.contrast = contrast;
        this.dark = dark;
    }

    private void reshape(int toWidth, int toHeight) {
        if (toWidth == width && toHeight == height) {
            return;
        }
        width = toWidth;
        height = toHeight;
        tilesAcross = LocalMeanThreshold.tiles(width);
        tilesDown = LocalMeanThreshold.tiles(height);
        cellsAcross = (width + CELL - 1) / CELL;
        cellsDown = (height + CELL - 1) / CELL;
        sums = new int[cellsAcross * CELLS * KEPT];
        summed = new int[tilesAcross * KEPT];
        columns = new int[cellsAcross];
        limits = new int[cellsAcross];
        for (int row = 0; row < LIMITED; row++) {
            ofPairs[row] = new long[(cellsAcross + 1) / 2];
        }
        runs = new int[4 * (tilesAcross / 2 + 1)];
    }

    /** Marks what is dark in a part of an image, all in tiles, the last ones not with it. */
    void mark(GrayU8 input, int left, int top, int right, int bottom) {
        reshape(input.width, input.height);
        pixels = TileContrast.eightAtATime(input);
        Arrays.fill(summed, NONE);
        Arrays.fill(limited, NONE);
        columnsOf = NONE - 1;
        for (int down = top; down < bottom; down++) {
            int count = findRuns(down, left, right);
            for (int r = 0; r < 4 * count; r += 4) {
                sumCells(input, runs[r], Math.max(0, down - 1), runs[r + 1], Math.min(tilesDown, down + 2));
                int last = Math.min(cellsDown - 1, CELLS * (down + 1));
                for (int row = Math.max(0, CELLS * down - 1); row <= last; row++) {
                    findLimits(row, runs[r], runs[r + 1], runs[r + 2], runs[r + 3]);
                }
                int end = Math.min(width, TILE * runs[r + 3]);
                for (int row = CELLS * down; row < Math.min(cellsDown, CELLS * (down + 1)); row++) {
                    long[] own = ofPairs[row % LIMITED];
                    int y = CELL * row;
                    mark(input, y + 1, y, TILE * runs[r + 2], end, own, ofPairs[Math.max(0, row - 1) % LIMITED]);
                    mark(input, y + 2, y + 3, TILE * runs[r + 2], end, own,
                            ofPairs[Math.min(cellsDown - 1, row + 1) % LIMITED]);
                }
            }
        }
        pixels = NO_PIXELS;
    }

    /** Fills the runs of a window's row of tiles. */
    private int findRuns(int down, int left, int right) {
        int count = 0;
        for (int across = left; across < right; across++) {
            if (!contrast.mayBeDark(across, down)) {
                continue;
            }
            int last = 4 * count - 4;
            // windows reach into the tiles beside
            if (count > 0 && runs[last + 1] >= across - 1) {
                runs[last + 1] = Math.min(tilesAcross, across + 2);
                runs[last + 3] = across + 1;
                continue;
            }
            runs[last + 4] = Math.max(0, across - 1);
            runs[last + 5] = Math.min(tilesAcross, across + 2);
            runs[last + 6] = across;
            runs[last + 7] = across + 1;
            count++;
        }
        return count;
    }

    /** Sums the pixels of cells in those of some tiles where that is yet to be done. */
    private void sumCells(GrayU8 input, int left, int top, int right, int bottom) {
        for (int down = top; down < bottom; down++) {
            for (int across = left; across < right; across++) {
                int tile = down % KEPT * tilesAcross + across;
                if (summed[tile] == down) {
                    continue;
                }
                summed[tile] = down;
                if (TILE * (across + 1) <= width && TILE * (down + 1) <= height) {
                    sumWhole(input, across, down);
                } else {
                    sumPart(input, across, down);
                }
            }
        }
    }

    private void sumWhole(GrayU8 input, int across, int down) {
        ByteBuffer in = pixels;
        int stride = input.stride;
        int at = input.startIndex + TILE * down * stride + TILE * across;
        int cell = CELLS * (down % KEPT) * cellsAcross + CELLS * across;
        for (int row = 0; row < CELLS; row++) {
            for (int half = 0; half < CELLS; half += 2) {
                // four sums of two columns each
                long sum = 0;
                for (int y = 0, from = at + CELL * half; y < CELL; y++, from += stride) {
                    long eight = in.getLong(from);
                    sum += (eight & EVERY_SECOND) + (eight >>> Byte.SIZE & EVERY_SECOND);
                }
                sum += sum >>> BITS;
                sums[cell + half] = (int) sum & 0xFFFF;
                sums[cell + half + 1] = (int) (sum >>> 2 * BITS) & 0xFFFF;
            }
            at += CELL * stride;
            cell += cellsAcross;
        }
    }

    private void sumPart(GrayU8 input, int across, int down) {
        for (int v = CELLS * down; v < Math.min(cellsDown, CELLS * (down + 1)); v++) {
            for (int u = CELLS * across; u < Math.min(cellsAcross, CELLS * (across + 1)); u++) {
                int sum = 0;
                for (int y = CELL * v; y < Math.min(height, CELL * (v + 1)); y++) {
                    for (int x = CELL * u; x < Math.min(width, CELL * (u + 1)); x++) {
                        sum += input.data[input.startIndex + y * input.stride + x] & 0xFF;
                    }
                }
                sums[v % (CELLS * KEPT) * cellsAcross + u] = sum;
            }
        }
    }

    /** Finds the limits of a row of cells, in tiles of which those beside are summed as well. */
    private void findLimits(int row, int leftBeside, int rightBeside, int left, int right) {
        int slot = row % LIMITED;
        if (limited[slot] == row && limitedFrom[slot] <= left && right <= limitedTo[slot]) {
            return;
        }
        limited[slot] = row;
        limitedFrom[slot] = left;
        limitedTo[slot] = right;
        int top = Math.max(0, row - REACH);
        int bottom = Math.min(cellsDown, row + REACH + 1);
        sumColumns(row, CELLS * leftBeside, Math.min(cellsAcross, CELLS * rightBeside));
        int rows = Math.min(height, CELL * bottom) - CELL * top;
        // those on each side are interpolated with
        int first = Math.max(0, CELLS * left - 1);
        int end = Math.min(cellsAcross, CELLS * right + 1);
        int whole = Math.min(end, Math.max(first, REACH));
        int endOfWhole = rows * CELL * (2 * REACH + 1) < WHOLE ? whole
                : Math.max(whole, Math.min(end, width / CELL - REACH));
        limitBorder(rows, first, whole);
        limitWhole(whole, endOfWhole);
        limitBorder(rows, endOfWhole, end);
        interpolate(CELLS * left, Math.min(cellsAcross, CELLS * right), ofPairs[slot]);
    }

    /** Limits of pairs of pixels of some cells, the first of them even, in their row. */
    private void interpolate(int from, int to, long[] pairs) {
        int[] of = limits;
        int last = cellsAcross - 1;
        long before = of[Math.max(0, from - 1)];
        long one = of[from];
        for (int cell = from; cell < to; cell += 2) {
            long two = of[Math.min(last, cell + 1)];
            long after = of[Math.min(last, cell + 2)];
            pairs[cell / 2] = 3 * one + before | 3 * one + two << BITS | one + 3 * two << 2 * BITS
                    | 3 * two + after << 3 * BITS;
            before = two;
            one = after;
        }
    }

    /** Sums cells below each other about a row, by the sums about the row above where that is what there is. */
    private void sumColumns(int row, int from, int to) {
        int[] ofColumns = columns;
        int[] ofCells = sums;
        if (columnsOf == row - 1 && columnsFrom <= from && to <= columnsTo && row > REACH && row + REACH < cellsDown) {
            int added = slot(row + REACH);
            int left = slot(row - REACH - 1);
            for (int x = from; x < to; x++) {
                ofColumns[x] += ofCells[added + x] - ofCells[left + x];
            }
        } else {
            Arrays.fill(ofColumns, from, to, 0);
            for (int of = Math.max(0, row - REACH); of <= Math.min(cellsDown - 1, row + REACH); of++) {
                int at = slot(of);
                for (int x = from; x < to; x++) {
                    ofColumns[x] += ofCells[at + x];
                }
            }
        }
        columnsOf = row;
        columnsFrom = from;
        columnsTo = to;
    }

    /** Where the sums of a row of cells begin. */
    private int slot(int row) {
        return row % (CELLS * KEPT) * cellsAcross;
    }

    private void limitWhole(int from, int to) {
        int[] ofColumns = columns;
        int[] found = limits;
        int share = PARTS * percent;
        int divisor = 100 * WHOLE;
        int factor = (int) (((long) share << RECIPROCAL_BITS) / divisor);
        for (int x = from; x < to; x++) {
            int sum = ofColumns[x - 2] + ofColumns[x - 1] + ofColumns[x] + ofColumns[x + 1] + ofColumns[x + 2];
            // it or one less; several at a time, as no division is
            int quotient = sum * factor >>> RECIPROCAL_BITS;
            int left = sum * share - quotient * divisor;
            found[x] = quotient + (left + (Integer.MIN_VALUE - divisor) >>> Integer.SIZE - 1);
        }
    }

    /** Cells of which some that the mean is over would lie outside, or in part. */
    private void limitBorder(int rows, int from, int to) {
        for (int x = from; x < to; x++) {
            int left = Math.max(0, x - REACH);
            int right = Math.min(cellsAcross, x + REACH + 1);
            int sum = 0;
            for (int u = left; u < right; u++) {
                sum += columns[u];
            }
            int across = Math.min(width, CELL * right) - CELL * left;
            limits[x] = PARTS * percent * sum / (100 * rows * across);
        }
    }

    /**
     * Marks what is dark in the two rows of a cell that lie towards another one: the limit of the row next to its
     * middle is by seven eighths its own and by one the other's, that of the row beyond by five and three.
     */
    private void mark(GrayU8 input, int next, int beyond, int from, int to, long[] own, long[] other) {
        int end = from;
        if (Math.max(next, beyond) < height) {
            end += (to - from) / Long.BYTES * Long.BYTES;
            markWhole(input, next, beyond, from, end, own, other);
        }
        markPart(input, next, end, to, own, other, 1);
        markPart(input, beyond, end, to, own, other, 3);
    }

    private void markWhole(GrayU8 input, int next, int beyond, int from, int to, long[] own, long[] other) {
        ByteBuffer in = pixels;
        long[] words = dark.words();
        int inNext = input.startIndex + next * input.stride;
        int inBeyond = input.startIndex + beyond * input.stride;
        int x = from;
        while (x < to) {
            int end = Math.min(to, dark.endOf(x));
            int atNext = dark.indexOf(x, next);
            int atBeyond = dark.indexOf(x, beyond);
            long bitsOfNext = 0;
            long bitsOfBeyond = 0;
            for (; x < end; x += Long.BYTES) {
                // four numbers in one are added up as one: what they borrow from each other, they give back
                long ofOwn = own[x >> 3];
                long towards = other[x >> 3] - ofOwn;
                long limit = EIGHTHS * ofOwn + towards;
                bitsOfNext |= darkOf(in.getLong(inNext + x), limit) << x;
                bitsOfBeyond |= darkOf(in.getLong(inBeyond + x), limit + 2 * towards) << x;
            }
            words[atNext] |= bitsOfNext;
            words[atBeyond] |= bitsOfBeyond;
        }
    }

    /** The same of one row, pixel by pixel, if it is in the image. */
    private void markPart(GrayU8 input, int y, int from, int to, long[] own, long[] other, int ofOther) {
        if (y >= height) {
            return;
        }
        int at = input.startIndex + y * input.stride;
        for (int x = from; x < to; x++) {
            int four = x / Long.BYTES;
            long limits = (EIGHTHS - ofOther) * own[four] + ofOther * other[four] >>> Byte.SIZE;
            if ((input.data[at + x] & 0xFF) <= (limits >>> x % Long.BYTES / 2 * BITS & 0xFF)) {
                dark.words()[dark.indexOf(x, y)] |= 1L << x;
            }
        }
    }

    /** Which of eight pixels are not above limits, of four pairs of them, in eighths of quarters of parts. */
    private static long darkOf(long eight, long pairs) {
        long limit = pairs >>> Byte.SIZE & EVERY_SECOND | BEYOND_EACH;
        // the bit above a grey is left where the limit is not below it
        long even = limit - (eight & EVERY_SECOND) >>> Byte.SIZE & IN_EACH;
        long odd = limit - (eight >>> Byte.SIZE & EVERY_SECOND) & BEYOND_EACH;
        return DarkBits.ofEight(even | odd);
    }
}
