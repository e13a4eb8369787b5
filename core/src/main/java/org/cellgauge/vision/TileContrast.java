package org.cellgauge.vision;

import boofcv.struct.image.GrayU8;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Which tiles of an image may have dark pixels: most of an image is plain, and where the darkest pixel is brighter than
 * the share of the brightest at which dark begins, no pixel about it can be dark. Looked at is every second pixel of
 * every second row. A dark speck of a single pixel may then be missed on plain ground, which is nobody's marker; about
 * anything larger all is found. Not thread-safe, but for {@link #look} at other rows.
 */
final class TileContrast {
    private static final int TILE = LocalMeanThreshold.TILE;
    private static final int STEP = 2;
    /** How far tiles of one surface may differ, grey levels: noise takes its darkest pixel now here, now there. */
    private static final int SLACK = 2;
    /** Every second one of eight pixels, in a number of 16 bits each. */
    static final long EVERY_SECOND = 0x00FF_00FF_00FF_00FFL;
    static final long BEYOND_EACH = 0x0100_0100_0100_0100L;
    static final int BITS = 16;
    static final long IN_EACH = 0x0001_0001_0001_0001L;
    private static final long SIGN_OF_EACH = 0x8000_8000_8000_8000L;
    private static final int LARGEST = 0x7FFF;

    private final int percent;
    private int width;
    private int height;
    private int tilesAcross;
    private int tilesDown;
    /** Of each tile, the darkest and the brightest pixel that was looked at; of half of them if these have contrast. */
    private int[] darkest = new int[0];
    private int[] brightest = new int[0];
    /** Whether these are the greys themselves; else no pixel is beyond them. */
    private boolean[] exact = new boolean[0];
    private boolean[] contrasting = new boolean[0];
    /** The same of each tile of a row, with the two above and below it. */
    private int[] darkestOfThree = new int[0];
    private int[] brightestOfThree = new int[0];

    /**
     * Tiles.
     *
     * @param percent of the mean at which black begins, below 100
     */
    TileContrast(int percent) {
        this.percent = percent;
    }

    /** Takes the size of an image. */
    void reshape(int toWidth, int toHeight) {
        width = toWidth;
        height = toHeight;
        tilesAcross = LocalMeanThreshold.tiles(width);
        tilesDown = LocalMeanThreshold.tiles(height);
        darkest = new int[tilesAcross * tilesDown];
        brightest = new int[tilesAcross * tilesDown];
        exact = new boolean[tilesAcross * tilesDown];
        contrasting = new boolean[tilesAcross * tilesDown];
        darkestOfThree = new int[tilesAcross];
        brightestOfThree = new int[tilesAcross];
    }

    /** Whether a tile of a part that was gone through may have dark pixels. */
    boolean mayBeDark(int across, int down) {
        return contrasting[down * tilesAcross + across];
    }

    /**
     * Finds out which tiles of a part may have dark pixels, when it has been {@linkplain #look looked at} with a tile
     * on each side.
     */
    void find(GrayU8 input, int left, int top, int right, int bottom) {
        ByteBuffer pixels = eightAtATime(input);
        for (int down = top; down < bottom; down++) {
            spanRows(down, left, right);
            for (int across = left; across < right; across++) {
                contrasting[down * tilesAcross + across] = mayHaveContrast(across)
                        && hasContrast(input, pixels, across, down);
            }
        }
    }

    static ByteBuffer eightAtATime(GrayU8 input) {
        return ByteBuffer.wrap(input.data).order(ByteOrder.LITTLE_ENDIAN);
    }

    /**
     * Finds the darkest and the brightest pixel of tiles, or limits to them: most tiles are of the same surface as the
     * one before, and whether all pixels are within limits is seen for four at a time.
     */
    void look(GrayU8 input, int left, int top, int right, int bottom) {
        ByteBuffer pixels = eightAtATime(input);
        int low = 1;
        int high = 0;
        for (int down = top; down < bottom; down++) {
            for (int across = left; across < right; across++) {
                int tile = down * tilesAcross + across;
                boolean whole = TILE * (across + 1) <= width && TILE * (down + 1) <= height;
                int at = input.startIndex + TILE * down * input.stride + TILE * across;
                exact[tile] = low > high || !whole || !areWithin(pixels, at, STEP * input.stride, low, high);
                darkest[tile] = low;
                brightest[tile] = high;
                if (exact[tile]) {
                    measure(input, pixels, across, down);
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
    private boolean areWithin(ByteBuffer in, int first, int stride, int low, int high) {
        // the sign of a sum shows a pixel beyond
        long fromLow = IN_EACH * (LARGEST + low);
        long toHigh = IN_EACH * (LARGEST - high);
        long beyond = 0;
        int at = first;
        for (int row = 0; row < TILE; row += STEP) {
            long left = in.getLong(at) & EVERY_SECOND;
            long right = in.getLong(at + Long.BYTES) & EVERY_SECOND;
            beyond |= fromLow - left | left + toHigh | fromLow - right | right + toHigh;
            at += stride;
        }
        return (beyond & SIGN_OF_EACH) == 0;
    }

    private void measure(GrayU8 input, ByteBuffer pixels, int across, int down) {
        boolean whole = TILE * (across + 1) <= width && TILE * (down + 1) <= height;
        if (whole) {
            measureWhole(input, pixels, across, down);
        } else {
            measurePart(input, across, down);
        }
        exact[down * tilesAcross + across] = true;
    }

    private void measureWhole(GrayU8 input, ByteBuffer in, int across, int down) {
        int tile = down * tilesAcross + across;
        int at = input.startIndex + TILE * down * input.stride + TILE * across;
        long low = EVERY_SECOND;
        long high = 0;
        darkest[tile] = 255;
        brightest[tile] = 0;
        // on a texture half of them have contrast enough
        for (int row = 0; row < TILE && !isContrasting(darkest[tile], brightest[tile]); row += TILE / 2) {
            for (int of = 0; of < TILE / 2; of += STEP) {
                long left = in.getLong(at) & EVERY_SECOND;
                long right = in.getLong(at + Long.BYTES) & EVERY_SECOND;
                long over = excess(left, right);
                low -= excess(low, left - over);
                high += excess(right + over, high);
                at += STEP * input.stride;
            }
            for (int shift = 0; shift < Long.SIZE; shift += BITS) {
                darkest[tile] = Math.min(darkest[tile], (int) (low >>> shift) & 0xFF);
                brightest[tile] = Math.max(brightest[tile], (int) (high >>> shift) & 0xFF);
            }
        }
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

    /** Whether the darker of two pixels may be dark about the brighter one. */
    private boolean isContrasting(int low, int high) {
        return 100 * low <= percent * high;
    }

    /** Whether a pixel may be dark in a tile, by the limits of its row. */
    private boolean mayHaveContrast(int across) {
        int before = Math.max(0, across - 1);
        int after = Math.min(tilesAcross - 1, across + 1);
        int low = Math.min(darkestOfThree[across], Math.min(darkestOfThree[before], darkestOfThree[after]));
        int high = Math.max(brightestOfThree[across], Math.max(brightestOfThree[before], brightestOfThree[after]));
        return isContrasting(low, high);
    }

    /** Whether a pixel may be dark in a tile, by what it and the tiles about it have in them. */
    private boolean hasContrast(GrayU8 input, ByteBuffer pixels, int across, int down) {
        int tile = down * tilesAcross + across;
        if (exact[tile] && isContrasting(darkest[tile], brightest[tile])) {
            return true;
        }
        int low = 255;
        int high = 0;
        for (int y = Math.max(0, down - 1); y <= Math.min(tilesDown - 1, down + 1); y++) {
            for (int x = Math.max(0, across - 1); x <= Math.min(tilesAcross - 1, across + 1); x++) {
                if (!exact[y * tilesAcross + x]) {
                    measure(input, pixels, x, y);
                }
                low = Math.min(low, darkest[y * tilesAcross + x]);
                high = Math.max(high, brightest[y * tilesAcross + x]);
            }
        }
        return isContrasting(low, high);
    }
}
