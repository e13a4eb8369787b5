package org.cellgauge.vision;

import boofcv.abst.filter.binary.InputToBinary;
import boofcv.struct.image.GrayU8;
import boofcv.struct.image.ImageType;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Marks pixels that are darker than a share of the mean about them, as BoofCV's local mean does, in one pass: sums of
 * columns slide down the image, and differences of their running sum give the mean along each row. BoofCV's own blurs
 * the whole image twice first, which takes half of the time to find markers in a plain scene.
 *
 * <p>Most of an image is plain: where the darkest pixel is brighter than that share of the brightest, no pixel about it
 * can be dark. So the image is first looked at in tiles, in every second pixel of every second row, and only tiles with
 * such a contrast in them or beside them are gone through. A dark speck of a single pixel may then be missed on plain
 * ground, which is nobody's marker; about anything larger all is found. Rows are unpacked once and kept while they are
 * in the window, and every loop does one thing: so nearly all of them run on several pixels at a time.
 *
 * <p>Outside of the {@link SearchWindows} of a frame nothing is looked at; inside, all is as in the whole image. What
 * is dark lies in some {@linkplain #places() places}, outside of which pixels are cleared or left as they were. Not
 * thread-safe: sums and rows are kept.
 */
final class LocalMeanThreshold implements InputToBinary<GrayU8> {
    /** Width and height of a tile, px; at least the radius, so that windows end in the tiles beside. */
    static final int TILE = 16;
    private static final int STEP = 2;
    private static final int NOWHERE = -2;
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

    private final int radius;
    private final int percent;
    /** Those of the image at hand, to be read eight at a time. */
    private ByteBuffer pixels = NO_PIXELS;
    private final SearchWindows windows;
    private final Rectangles places = new Rectangles();
    private final Rectangles ofWindow = new Rectangles();
    private int width;
    private int height;
    private int tilesAcross;
    private int tilesDown;
    private int[] columns = new int[0];
    /** Sums of columns from the start of a run up to, not with, each column. */
    private int[] before = new int[0];
    private int[] dark = new int[0];
    /** The rows in the window, and one more, by row number modulo their count. */
    private int[][] unpacked = new int[0][];
    /** Of each tile, the darkest and the brightest pixel that was looked at. */
    private int[] darkest = new int[0];
    private int[] brightest = new int[0];
    /** Whether these are the greys themselves; else no pixel is beyond them. */
    private boolean[] exact = new boolean[0];
    private boolean[] contrasting = new boolean[0];
    /** The same of each tile of a row, with the two above and below it. */
    private int[] darkestOfThree = new int[0];
    private int[] brightestOfThree = new int[0];
    /** The row about which each tile's columns are summed. */
    private int[] summedAbout = new int[0];
    /** Tiles from and to which columns are summed, and those of them that are gone through, of each run of a row. */
    private int[] runs = new int[0];

    /**
     * A threshold.
     *
     * @param radius pixels on each side of a pixel that its mean is over, up to {@value #TILE}; at the border, those
     *     that there are
     * @param percent of the mean at which black begins
     * @param windows where pixels are asked for
     */
    LocalMeanThreshold(int radius, int percent, SearchWindows windows) {
        this.radius = radius;
        this.percent = percent;
        this.windows = windows;
    }

    /** Where pixels are asked for. */
    SearchWindows windows() {
        return windows;
    }

    /** Parts of the last image that have all dark pixels in them. */
    Rectangles places() {
        return places;
    }

    @Override
    public void process(GrayU8 input, GrayU8 output) {
        reshape(input.width, input.height);
        output.reshape(width, height);
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
        Arrays.fill(summedAbout, NOWHERE);
        for (int down = top; down < bottom; down++) {
            findContrast(input, down, left, right);
            int first = down * TILE;
            int end = Math.min(height, first + TILE);
            int count = findRuns(down, left, right);
            for (int r = 0; r < 4 * count; r += 4) {
                for (int across = runs[r]; across < runs[r + 1]; across++) {
                    if (summedAbout[across] != first - 1) {
                        sumAbout(first - 1, across, input);
                    }
                    summedAbout[across] = end - 1;
                }
                for (int y = first; y < end; y++) {
                    slideTo(y, TILE * runs[r], Math.min(width, TILE * runs[r + 1]), input);
                    mark(y, TILE * runs[r + 2], Math.min(width, TILE * runs[r + 3]), output);
                }
            }
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

    /** Finds the places of a window of tiles that was gone through, and clears what was not in the output. */
    private void findPlaces(GrayU8 output, int left, int top, int right, int bottom) {
        ofWindow.clear();
        ByteBuffer marked = ByteBuffer.wrap(output.data).order(ByteOrder.LITTLE_ENDIAN);
        for (int down = top; down < bottom; down++) {
            int from = left;
            for (int across = left; across <= right; across++) {
                // mostly it is noise that may be dark, and is not
                if (across == right || !contrasting[down * tilesAcross + across]
                        || !isDark(output, marked, across, down)) {
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
            for (int down = ofWindow.top(i) / TILE; down < tiles(ofWindow.bottom(i)); down++) {
                clearPlain(output, down, ofWindow.left(i) / TILE, tiles(ofWindow.right(i)));
            }
            places.add(ofWindow.left(i), ofWindow.top(i), ofWindow.right(i), ofWindow.bottom(i));
        }
    }

    /** Whether a tile that was gone through has dark pixels. */
    private boolean isDark(GrayU8 output, ByteBuffer marked, int across, int down) {
        int end = output.startIndex + Math.min(width, TILE * (across + 1));
        for (int y = TILE * down; y < Math.min(height, TILE * (down + 1)); y++) {
            int at = output.startIndex + y * output.stride + TILE * across;
            int rowEnd = end + y * output.stride;
            for (; at + Long.BYTES <= rowEnd; at += Long.BYTES) {
                if (marked.getLong(at) != 0) {
                    return true;
                }
            }
            for (; at < rowEnd; at++) {
                if (marked.get(at) != 0) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Clears a row of tiles, but for those that are gone through: in these every pixel is marked or cleared. */
    private void clearPlain(GrayU8 output, int down, int left, int right) {
        int across = left;
        while (across < right) {
            int from = across;
            while (across < right && !contrasting[down * tilesAcross + across]) {
                across++;
            }
            for (int y = TILE * down; from < across && y < Math.min(height, TILE * (down + 1)); y++) {
                int at = output.startIndex + y * output.stride;
                Arrays.fill(output.data, at + TILE * from, at + Math.min(width, TILE * across), (byte) 0);
            }
            across++;
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
        columns = new int[width];
        before = new int[width + 1];
        dark = new int[width];
        unpacked = new int[2 * radius + 2][width];
        darkest = new int[tilesAcross * tilesDown];
        brightest = new int[tilesAcross * tilesDown];
        exact = new boolean[tilesAcross * tilesDown];
        contrasting = new boolean[tilesAcross * tilesDown];
        darkestOfThree = new int[tilesAcross];
        brightestOfThree = new int[tilesAcross];
        summedAbout = new int[tilesAcross];
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

    /** Sums the columns of a tile anew, over the rows about one, which may lie just above the image. */
    private void sumAbout(int y, int across, GrayU8 input) {
        int from = TILE * across;
        int to = Math.min(width, from + TILE);
        Arrays.fill(columns, from, to, 0);
        for (int v = Math.max(0, y - radius); v <= Math.min(height - 1, y + radius); v++) {
            add(unpack(input, v, from, to), from, to);
        }
    }

    /** Moves the sums of columns down by one row, and sums them up along it. */
    private void slideTo(int y, int from, int to, GrayU8 input) {
        boolean enters = y + radius < height;
        boolean leaves = y - radius - 1 >= 0;
        if (enters && leaves) {
            exchange(unpack(input, y + radius, from, to), row(y - radius - 1), from, to);
        } else if (enters) {
            add(unpack(input, y + radius, from, to), from, to);
        } else if (leaves) {
            subtract(row(y - radius - 1), from, to);
        }
        int[] sums = columns;
        int[] upTo = before;
        int sum = 0;
        upTo[from] = 0;
        for (int x = from; x < to; x++) {
            sum += sums[x];
            upTo[x + 1] = sum;
        }
    }

    private void mark(int y, int from, int to, GrayU8 output) {
        int rows = Math.min(height - 1, y + radius) - Math.max(0, y - radius) + 1;
        int at = output.startIndex + y * output.stride;
        byte[] out = output.data;
        int[] found = dark;
        int[] in = row(y);
        int first = Math.min(to, Math.max(from, radius));
        int last = Math.max(first, Math.min(to, width - radius));
        border(from, first, rows, in, out, at);
        compare(in, first, last, rows * (2 * radius + 1) * 100);
        for (int x = first; x < last; x++) {
            out[at + x] = (byte) found[x];
        }
        border(last, to, rows, in, out, at);
    }

    private void compare(int[] in, int first, int last, int whole) {
        int[] upTo = before;
        int[] found = dark;
        int share = percent;
        int left = -radius;
        int right = radius + 1;
        for (int x = first; x < last; x++) {
            found[x] = (share * (upTo[x + right] - upTo[x + left]) - in[x] * whole >>> 31) ^ 1;
        }
    }

    /** Pixels whose window is cut off on the left or right. */
    private void border(int first, int last, int rows, int[] in, byte[] out, int to) {
        for (int x = first; x < last; x++) {
            int left = Math.max(0, x - radius);
            int right = Math.min(width, x + radius + 1);
            int count = rows * (right - left);
            out[to + x] = (byte) (in[x] * count * 100 <= percent * (before[right] - before[left]) ? 1 : 0);
        }
    }

    private int[] row(int y) {
        return unpacked[y % unpacked.length];
    }

    private int[] unpack(GrayU8 input, int y, int from, int to) {
        byte[] in = input.data;
        int at = input.startIndex + y * input.stride;
        int[] row = row(y);
        for (int x = from; x < to; x++) {
            row[x] = in[at + x] & 0xFF;
        }
        return row;
    }

    private void add(int[] row, int from, int to) {
        int[] sums = columns;
        for (int x = from; x < to; x++) {
            sums[x] += row[x];
        }
    }

    private void subtract(int[] row, int from, int to) {
        int[] sums = columns;
        for (int x = from; x < to; x++) {
            sums[x] -= row[x];
        }
    }

    private void exchange(int[] enters, int[] leaves, int from, int to) {
        int[] sums = columns;
        for (int x = from; x < to; x++) {
            sums[x] += enters[x] - leaves[x];
        }
    }

    @Override
    public ImageType<GrayU8> getInputType() {
        return ImageType.SB_U8;
    }
}
