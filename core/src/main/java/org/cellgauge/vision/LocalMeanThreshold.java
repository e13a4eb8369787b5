package org.cellgauge.vision;

import boofcv.abst.filter.binary.InputToBinary;
import boofcv.struct.image.GrayU8;
import boofcv.struct.image.ImageType;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Marks pixels that are darker than a share of the mean about them, as BoofCV's local mean does. The mean is that of
 * the 20 x 20 pixels about the middles of cells of 4 x 4, and between these interpolated, down to rows and pairs of
 * pixels: so eight pixels at a time are compared with theirs. (One mean for a whole cell gives steps in blurred edges,
 * and squares are lost.) BoofCV's own blurs the whole image twice first, which takes half of the time to find markers
 * in a plain scene.
 *
 * <p>Most of an image is plain: where the darkest pixel is brighter than that share of the brightest, no pixel about it
 * can be dark. So the image is first looked at in tiles, in every second pixel of every second row, and only tiles with
 * such a contrast in them or beside them are gone through. A dark speck of a single pixel may then be missed on plain
 * ground, which is nobody's marker; about anything larger all is found.
 *
 * <p>Outside of the {@link SearchWindows} of a frame nothing is looked at; inside, all is as in the whole image. What
 * is dark lies in some {@linkplain #places() places}, outside of which pixels are cleared or left as they were. Not
 * thread-safe: sums are kept.
 */
final class LocalMeanThreshold implements InputToBinary<GrayU8> {
    /** Width and height of a tile, px. */
    static final int TILE = 16;
    /** Width and height of a cell, px. */
    static final int CELL = 4;
    /** Cells on each side of a cell that its mean is over; at the border, those that there are. In the tiles beside. */
    static final int REACH = 2;
    private static final int CELLS = TILE / CELL;
    /** Rows of cells of a tile, and one more on each side. */
    private static final int ROWS = CELLS + 2;
    /** Limits of cells are in parts of a grey level. */
    private static final int PARTS = 8;
    /** How much the limit of a cell counts in each of its rows, and how much that of the nearest other, in eighths. */
    private static final int[] OWN = {5, 7, 7, 5};
    private static final int[] OTHER = {3, 1, 1, 3};
    private static final int STEP = 2;
    /** Rows of tiles whose cells' sums are kept. */
    private static final int KEPT = 3;
    private static final int NONE = -1;
    /** Pixels that a mean is over. */
    private static final int WHOLE = (2 * REACH + 1) * CELL * (2 * REACH + 1) * CELL;
    private static final int RECIPROCAL_BITS = 40;
    /** To divide a number of 27 bits by a hundred means' pixels, to less than a part (Hacker's Delight, 10-9). */
    private static final long RECIPROCAL = (1L << RECIPROCAL_BITS) / (100 * WHOLE) + 1;
    /** How far tiles of one surface may differ, grey levels: noise takes its darkest pixel now here, now there. */
    private static final int SLACK = 2;
    /** More places than these are gone through as their window: each keeps its contours. */
    private static final int MOST_PLACES = 32;
    private static final ByteBuffer NO_PIXELS = ByteBuffer.allocate(0);
    /** Every second one of eight pixels, in a number of 16 bits each. */
    private static final long EVERY_SECOND = 0x00FF_00FF_00FF_00FFL;
    private static final long BEYOND_EACH = 0x0100_0100_0100_0100L;
    private static final int BITS = 16;
    private static final long IN_EACH = 0x0001_0001_0001_0001L;
    private static final long SIGN_OF_EACH = 0x8000_8000_8000_8000L;
    private static final int LARGEST = 0x7FFF;

    private final int percent;
    /** Those of the image at hand, to be read eight at a time. */
    private ByteBuffer pixels = NO_PIXELS;
    private final SearchWindows windows;
    private @Nullable Specks specks;
    private final DarkBits dark;
    private final Rectangles places = new Rectangles();
    private final Rectangles ofWindow = new Rectangles();
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
    /** The brightest grey that is dark in the middle of each cell of a row, in parts. */
    private int[] limits = new int[0];
    /** The same between the middles, of four pairs of pixels in a number, by rows of cells; in quarters of parts. */
    private final long[][] ofPairs = new long[ROWS][0];
    /** Of each tile, the darkest and the brightest pixel that was looked at. */
    private int[] darkest = new int[0];
    private int[] brightest = new int[0];
    /** Whether these are the greys themselves; else no pixel is beyond them. */
    private boolean[] exact = new boolean[0];
    private boolean[] contrasting = new boolean[0];
    /** The same of each tile of a row, with the two above and below it. */
    private int[] darkestOfThree = new int[0];
    private int[] brightestOfThree = new int[0];
    /** Tiles from and to which cells are summed, and those of them that are gone through, of each run of a row. */
    private int[] runs = new int[0];

    /**
     * A threshold.
     *
     * @param percent of the mean at which black begins, below 100
     * @param windows where pixels are asked for
     * @param dark work space, which those may share that are not used at a time
     */
    LocalMeanThreshold(int percent, SearchWindows windows, DarkBits dark) {
        this.percent = percent;
        this.windows = windows;
        this.dark = dark;
    }

    /** Where pixels are asked for. */
    SearchWindows windows() {
        return windows;
    }

    /** Has specks taken out of what is dark. */
    void takeOut(Specks ofContours) {
        specks = ofContours;
    }

    /** Parts of the last image that have all dark pixels in them. */
    Rectangles places() {
        return places;
    }

    @Override
    public void process(GrayU8 input, GrayU8 output) {
        reshape(input.width, input.height);
        output.reshape(width, height);
        dark.reshape(width, height);
        places.clear();
        pixels = ByteBuffer.wrap(input.data).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < windows.count(); i++) {
            process(input, output, windows.left(i) / TILE, windows.top(i) / TILE,
                    tiles(Math.min(width, windows.right(i))), tiles(Math.min(height, windows.bottom(i))));
        }
        pixels = NO_PIXELS;
    }

    private static int tiles(int px) {
        return (px + TILE - 1) / TILE;
    }

    /** Marks what is dark in a window of tiles, the last ones not with it. */
    private void process(GrayU8 input, GrayU8 output, int left, int top, int right, int bottom) {
        lookForContrast(input, Math.max(0, left - 1), Math.max(0, top - 1), Math.min(tilesAcross, right + 1),
                Math.min(tilesDown, bottom + 1));
        Arrays.fill(summed, NONE);
        for (int down = top; down < bottom; down++) {
            findContrast(input, down, left, right);
            int count = findRuns(down, left, right);
            for (int r = 0; r < 4 * count; r += 4) {
                sumCells(input, runs[r], Math.max(0, down - 1), runs[r + 1], Math.min(tilesDown, down + 2));
                int end = Math.min(width, TILE * runs[r + 3]);
                for (int row = 0; row < ROWS; row++) {
                    int cells = CELLS * down - 1 + row;
                    if (cells >= 0 && cells < cellsDown) {
                        findLimits(cells, runs[r], runs[r + 1], runs[r + 2], runs[r + 3], ofPairs[row]);
                    }
                }
                for (int y = TILE * down; y < Math.min(height, TILE * (down + 1)); y++) {
                    int cells = y / CELL;
                    int other = y % CELL < CELL / 2 ? Math.max(0, cells - 1) : Math.min(cellsDown - 1, cells + 1);
                    mark(input, y, TILE * runs[r + 2], end, ofPairs[cells - CELLS * down + 1], OWN[y % CELL],
                            ofPairs[other - CELLS * down + 1], OTHER[y % CELL]);
                }
            }
        }
        if (specks != null) {
            specks.takeOut(dark, TILE * left, TILE * top, Math.min(width, TILE * right),
                    Math.min(height, TILE * bottom));
        }
        findPlaces(output, left, top, right, bottom);
    }

    /** Finds out which tiles of a row may have dark pixels. */
    private void findContrast(GrayU8 input, int down, int left, int right) {
        spanRows(down, left, right);
        for (int across = left; across < right; across++) {
            contrasting[down * tilesAcross + across] = mayHaveContrast(across) && hasContrast(input, across, down);
        }
    }

    /** Finds the places of a window of tiles that was gone through, and writes them. */
    private void findPlaces(GrayU8 output, int left, int top, int right, int bottom) {
        ofWindow.clear();
        for (int down = top; down < bottom; down++) {
            int from = left;
            for (int across = left; across <= right; across++) {
                // mostly it is noise that may be dark, and is not
                if (across == right || !contrasting[down * tilesAcross + across]
                        || !dark.isAnyDark(TILE * across, TILE * down, TILE)) {
                    ofWindow.add(TILE * from, TILE * down, Math.min(width, TILE * across),
                            Math.min(height, TILE * (down + 1)));
                    from = across + 1;
                }
            }
        }
        if (ofWindow.count() > MOST_PLACES) {
            ofWindow.clear();
            ofWindow.add(TILE * left, TILE * top, Math.min(width, TILE * right), Math.min(height, TILE * bottom));
        }
        for (int i = 0; i < ofWindow.count(); i++) {
            dark.write(ofWindow.left(i), ofWindow.top(i), ofWindow.right(i), ofWindow.bottom(i), output);
            places.add(ofWindow.left(i), ofWindow.top(i), ofWindow.right(i), ofWindow.bottom(i));
        }
    }

    private void reshape(int toWidth, int toHeight) {
        if (toWidth == width && toHeight == height) {
            return;
        }
        width = toWidth;
        height = toHeight;
        tilesAcross = tiles(width);
        tilesDown = tiles(height);
        cellsAcross = (width + CELL - 1) / CELL;
        cellsDown = (height + CELL - 1) / CELL;
        sums = new int[cellsAcross * CELLS * KEPT];
        summed = new int[tilesAcross * KEPT];
        columns = new int[cellsAcross];
        limits = new int[cellsAcross];
        for (int row = 0; row < ROWS; row++) {
            ofPairs[row] = new long[(cellsAcross + 1) / 2];
        }
        darkest = new int[tilesAcross * tilesDown];
        brightest = new int[tilesAcross * tilesDown];
        exact = new boolean[tilesAcross * tilesDown];
        contrasting = new boolean[tilesAcross * tilesDown];
        darkestOfThree = new int[tilesAcross];
        brightestOfThree = new int[tilesAcross];
        runs = new int[4 * (tilesAcross / 2 + 1)];
    }

    /**
     * Finds the darkest and the brightest pixel of tiles, or limits to them: most tiles are of the same surface as the
     * one before, and whether all pixels are within limits is seen for four at a time.
     */
    private void lookForContrast(GrayU8 input, int left, int top, int right, int bottom) {
        int low = 1;
        int high = 0;
        for (int down = top; down < bottom; down++) {
            for (int across = left; across < right; across++) {
                int tile = down * tilesAcross + across;
                boolean whole = TILE * (across + 1) <= width && TILE * (down + 1) <= height;
                int at = input.startIndex + TILE * down * input.stride + TILE * across;
                exact[tile] = !whole || !areWithin(at, STEP * input.stride, low, high);
                darkest[tile] = low;
                brightest[tile] = high;
                if (exact[tile]) {
                    measure(input, across, down);
                    // limits with a contrast of their own would say nothing of any tile
                    if (100 * (darkest[tile] - SLACK) > percent * (brightest[tile] + SLACK)) {
                        low = darkest[tile] - SLACK;
                        high = Math.min(255, brightest[tile] + SLACK);
                    }
                }
            }
        }
    }

    /** Whether no pixel of a tile is darker or brighter than that. */
    private boolean areWithin(int first, int stride, int low, int high) {
        // the sign of a sum shows a pixel beyond
        long fromLow = IN_EACH * (LARGEST + low);
        long toHigh = IN_EACH * (LARGEST - high);
        long beyond = 0;
        ByteBuffer in = pixels;
        int at = first;
        for (int row = 0; row < TILE; row += STEP) {
            long left = in.getLong(at) & EVERY_SECOND;
            long right = in.getLong(at + Long.BYTES) & EVERY_SECOND;
            beyond |= fromLow - left | left + toHigh | fromLow - right | right + toHigh;
            at += stride;
        }
        return (beyond & SIGN_OF_EACH) == 0;
    }

    private void measure(GrayU8 input, int across, int down) {
        boolean whole = TILE * (across + 1) <= width && TILE * (down + 1) <= height;
        if (whole) {
            measureWhole(input, across, down);
        } else {
            measurePart(input, across, down);
        }
        exact[down * tilesAcross + across] = true;
    }

    private void measureWhole(GrayU8 input, int across, int down) {
        ByteBuffer in = pixels;
        int at = input.startIndex + TILE * down * input.stride + TILE * across;
        long low = EVERY_SECOND;
        long high = 0;
        for (int row = 0; row < TILE; row += STEP) {
            long left = in.getLong(at) & EVERY_SECOND;
            long right = in.getLong(at + Long.BYTES) & EVERY_SECOND;
            long over = excess(left, right);
            low -= excess(low, left - over);
            high += excess(right + over, high);
            at += STEP * input.stride;
        }
        int darkestOfAll = 255;
        int brightestOfAll = 0;
        for (int shift = 0; shift < Long.SIZE; shift += BITS) {
            darkestOfAll = Math.min(darkestOfAll, (int) (low >>> shift) & 0xFF);
            brightestOfAll = Math.max(brightestOfAll, (int) (high >>> shift) & 0xFF);
        }
        darkest[down * tilesAcross + across] = darkestOfAll;
        brightest[down * tilesAcross + across] = brightestOfAll;
    }

    /** By how much each of four pixels is brighter than another; 0 where it is darker. */
    private static long excess(long pixels, long others) {
        long differences = (pixels | BEYOND_EACH) - others;
        long brighter = differences >>> Byte.SIZE & IN_EACH;
        return differences & (brighter << Byte.SIZE) - brighter;
    }

    private void measurePart(GrayU8 input, int across, int down) {
        byte[] in = input.data;
        int low = 255;
        int high = 0;
        int left = TILE * across;
        int right = Math.min(width, left + TILE);
        for (int y = TILE * down; y < Math.min(height, TILE * (down + 1)); y += STEP) {
            int at = input.startIndex + y * input.stride;
            for (int i = at + left; i < at + right; i += STEP) {
                int grey = in[i] & 0xFF;
                low = Math.min(low, grey);
                high = Math.max(high, grey);
            }
        }
        darkest[down * tilesAcross + across] = low;
        brightest[down * tilesAcross + across] = high;
    }

    /** Fills the runs of a window's row of tiles. */
    private int findRuns(int down, int left, int right) {
        int count = 0;
        for (int across = left; across < right; across++) {
            if (!contrasting[down * tilesAcross + across]) {
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

    /** Finds limits to the pixels of each tile and of those above and below it, in a window and beside. */
    private void spanRows(int down, int left, int right) {
        int above = tilesAcross * Math.max(0, down - 1);
        int at = tilesAcross * down;
        int below = tilesAcross * Math.min(tilesDown - 1, down + 1);
        int[] low = darkest;
        int[] high = brightest;
        int[] lowest = darkestOfThree;
        int[] highest = brightestOfThree;
        int end = Math.min(tilesAcross, right + 1);
        for (int x = Math.max(0, left - 1); x < end; x++) {
            lowest[x] = Math.min(low[at + x], Math.min(low[above + x], low[below + x]));
        }
        for (int x = Math.max(0, left - 1); x < end; x++) {
            highest[x] = Math.max(high[at + x], Math.max(high[above + x], high[below + x]));
        }
    }

    /** Whether a pixel may be dark in a tile, by the limits of its row. */
    private boolean mayHaveContrast(int across) {
        int before = Math.max(0, across - 1);
        int after = Math.min(tilesAcross - 1, across + 1);
        int low = Math.min(darkestOfThree[across], Math.min(darkestOfThree[before], darkestOfThree[after]));
        int high = Math.max(brightestOfThree[across], Math.max(brightestOfThree[before], brightestOfThree[after]));
        return 100 * low <= percent * high;
    }

    /** Whether a pixel may be dark in a tile, by what it and the tiles about it have in them. */
    private boolean hasContrast(GrayU8 input, int across, int down) {
        int low = 255;
        int high = 0;
        for (int y = Math.max(0, down - 1); y <= Math.min(tilesDown - 1, down + 1); y++) {
            for (int x = Math.max(0, across - 1); x <= Math.min(tilesAcross - 1, across + 1); x++) {
                if (!exact[y * tilesAcross + x]) {
                    measure(input, x, y);
                }
                low = Math.min(low, darkest[y * tilesAcross + x]);
                high = Math.max(high, brightest[y * tilesAcross + x]);
            }
        }
        return 100 * low <= percent * high;
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
    private void findLimits(int row, int leftBeside, int rightBeside, int left, int right, long[] pairs) {
        int top = Math.max(0, row - REACH);
        int bottom = Math.min(cellsDown, row + REACH + 1);
        sumColumns(top, bottom, CELLS * leftBeside, Math.min(cellsAcross, CELLS * rightBeside));
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
        for (int cell = CELLS * left; cell < Math.min(cellsAcross, CELLS * right); cell += 2) {
            long one = limits[cell];
            long two = limits[Math.min(cellsAcross - 1, cell + 1)];
            long before = limits[Math.max(0, cell - 1)];
            long after = limits[Math.min(cellsAcross - 1, cell + 2)];
            pairs[cell / 2] = 3 * one + before | 3 * one + two << BITS | one + 3 * two << 2 * BITS
                    | 3 * two + after << 3 * BITS;
        }
    }

    private void sumColumns(int top, int bottom, int from, int to) {
        int[] ofColumns = columns;
        Arrays.fill(ofColumns, from, to, 0);
        for (int row = top; row < bottom; row++) {
            int at = row % (CELLS * KEPT) * cellsAcross;
            for (int x = from; x < to; x++) {
                ofColumns[x] += sums[at + x];
            }
        }
    }

    private void limitWhole(int from, int to) {
        int[] ofColumns = columns;
        int[] found = limits;
        long share = (long) PARTS * percent * RECIPROCAL;
        for (int x = from; x < to; x++) {
            int sum = ofColumns[x - 2] + ofColumns[x - 1] + ofColumns[x] + ofColumns[x + 1] + ofColumns[x + 2];
            found[x] = (int) (sum * share >>> RECIPROCAL_BITS);
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

    private void mark(GrayU8 input, int y, int from, int to, long[] own, int ofOwn, long[] other, int ofOther) {
        ByteBuffer in = pixels;
        int at = input.startIndex + y * input.stride;
        int x = from;
        while (x < to) {
            int word = dark.indexOf(x, y);
            int end = Math.min(to, dark.endOf(x));
            long bits = 0;
            for (; x + Long.BYTES <= end; x += Long.BYTES) {
                long eight = in.getLong(at + x);
                long limit = limit(own[x / Long.BYTES] * ofOwn + other[x / Long.BYTES] * ofOther);
                // the bit above a grey is left where the limit is not below it
                long even = limit - (eight & EVERY_SECOND) >>> Byte.SIZE & IN_EACH;
                long odd = limit - (eight >>> Byte.SIZE & EVERY_SECOND) & BEYOND_EACH;
                bits |= DarkBits.ofEight(even | odd) << x;
            }
            for (; x < end; x++) {
                long limit = limit(own[x / Long.BYTES] * ofOwn + other[x / Long.BYTES] * ofOther)
                        >>> x % Long.BYTES / 2 * BITS & 0xFF;
                bits |= (input.data[at + x] & 0xFF) <= limit ? 1L << x : 0;
            }
            dark.words()[word] |= bits;
        }
    }

    /** Limits of four pairs of pixels, with another bit above, of eighths of quarters of parts. */
    private static long limit(long pairs) {
        return pairs >>> Byte.SIZE & EVERY_SECOND | BEYOND_EACH;
    }

    @Override
    public ImageType<GrayU8> getInputType() {
        return ImageType.SB_U8;
    }
}
