package org.cellgauge.vision;

import java.util.Arrays;

/**
 * Whether grey values went through blocks of 8 x 8 pixels, as those of a JPEG file do (ITU-T T.81, A.3.3): where much
 * was rounded off, neighbours differ more across the border of two blocks than within one. The grid may start
 * anywhere, as it does in a cropped photo. Not thread-safe.
 *
 * <p>Differences of neighbours are gathered by where they lie in the grid, those of edges left out; the border stands
 * out if its mean is larger than that of all others by more than chance (Fan and de Queiroz, IEEE Trans. Image
 * Processing 12, 2003, compare the same two kinds of differences).
 */
final class BlockGrid {
    private static final int BLOCK = 8;
    /** Larger differences are edges, grey levels; times the noise, and at least. */
    private static final double EDGE_NOISES = 3;
    private static final double LEAST_EDGE = 3;
    /** How much larger differences across borders are than others, and by how many standard errors. */
    private static final double LEAST_RATIO = 1.2;
    private static final double LEAST_DEVIATIONS = 8;
    /** Rows gathered at a time: of so many, sums of differences stay below {@link #ONE} and its multiples positive. */
    private static final int STRIP = 256;
    /** Counts one difference in a number that sums differences in its lower digits. */
    private static final int ONE = 1 << 16;

    // first across columns, then across rows
    private final long[][] count = new long[2][BLOCK];
    private final double[][] sum = new double[2][BLOCK];
    private final double[][] squares = new double[2][BLOCK];
    /** Grey values of a row and of the one below it. */
    private int[] here = new int[0];
    private int[] below = new int[0];
    /** Of each column of a strip, the differences across columns: count and sum in one number, and their squares. */
    private int[] across = new int[0];
    private int[] squaresAcross = new int[0];
    /** The same of differences across rows, by where these lie in the grid. */
    private int[][] ofColumns = new int[BLOCK][0];
    private int[][] squaresOfColumns = new int[BLOCK][0];

    /** Forgets what was gathered. */
    void clear() {
        for (int axis = 0; axis < 2; axis++) {
            Arrays.fill(count[axis], 0);
            Arrays.fill(sum[axis], 0);
            Arrays.fill(squares[axis], 0);
        }
    }

    /**
     * Gathers the neighbours of a part of an image; what lies outside of it is left out.
     *
     * @param image the image
     * @param x0 first column
     * @param y0 first row
     * @param x1 column after the last
     * @param y1 row after the last
     * @param noiseGrey noise of a pixel, standard deviation, grey levels
     */
    void add(GreyImage image, int x0, int y0, int x1, int y1, double noiseGrey) {
        int most = (int) Math.max(LEAST_EDGE, EDGE_NOISES * noiseGrey);
        int left = Math.max(0, x0);
        int right = Math.min(x1, image.widthPx() - 1);
        int bottom = Math.min(y1, image.heightPx() - 1);
        if (left >= right) {
            return;
        }
        for (int y = Math.max(0, y0); y < bottom; y += STRIP) {
            addStrip(image, left, right, y, Math.min(bottom, y + STRIP), most);
        }
    }

    private void addStrip(GreyImage image, int left, int right, int top, int bottom, int most) {
        int pixels = right - left;
        reserve(pixels);
        int[] row = here;
        int[] next = below;
        unpack(image, left, top, pixels + 1, row);
        for (int y = top; y < bottom; y++) {
            unpack(image, left, y + 1, pixels + 1, next);
            gatherAcross(row, pixels, most);
            gatherDown(row, next, pixels, most, ofColumns[y % BLOCK], squaresOfColumns[y % BLOCK]);
            int[] done = row;
            row = next;
            next = done;
        }
        for (int k = 0; k < BLOCK; k++) {
            conclude(0, (left + k) % BLOCK, across, squaresAcross, k, pixels, BLOCK);
            conclude(1, k, ofColumns[k], squaresOfColumns[k], 0, pixels, 1);
        }
    }

    /** Makes room for a strip, and forgets the one before. */
    private void reserve(int pixels) {
        if (across.length < pixels) {
            here = new int[pixels + 1];
            below = new int[pixels + 1];
            across = new int[pixels];
            squaresAcross = new int[pixels];
            ofColumns = new int[BLOCK][pixels];
            squaresOfColumns = new int[BLOCK][pixels];
            return;
        }
        Arrays.fill(across, 0, pixels, 0);
        Arrays.fill(squaresAcross, 0, pixels, 0);
        for (int place = 0; place < BLOCK; place++) {
            Arrays.fill(ofColumns[place], 0, pixels, 0);
            Arrays.fill(squaresOfColumns[place], 0, pixels, 0);
        }
    }

    private static void unpack(GreyImage image, int left, int y, int pixels, int[] out) {
        byte[] grey = image.luminance();
        int at = image.offset() + y * image.rowStride() + left;
        for (int x = 0; x < pixels; x++) {
            out[x] = grey[at + x] & 0xFF;
        }
    }

    private void gatherAcross(int[] row, int pixels, int most) {
        int[] sums = across;
        int[] ofSquares = squaresAcross;
        for (int x = 0; x < pixels; x++) {
            int difference = Math.abs(row[x + 1] - row[x]);
            // all bits where the difference is none of an edge
            int counts = difference - most - 1 >> 31;
            sums[x] += (difference | ONE) & counts;
            ofSquares[x] += difference * difference & counts;
        }
    }

    private static void gatherDown(int[] row, int[] next, int pixels, int most, int[] sums, int[] ofSquares) {
        for (int x = 0; x < pixels; x++) {
            int difference = Math.abs(next[x] - row[x]);
            int counts = difference - most - 1 >> 31;
            sums[x] += (difference | ONE) & counts;
            ofSquares[x] += difference * difference & counts;
        }
    }

    /** Adds the columns of a strip that lie at one place of the grid to what was gathered. */
    private void conclude(int axis, int place, int[] sums, int[] ofSquares, int first, int pixels, int step) {
        long gathered = 0;
        long differences = 0;
        long ofAll = 0;
        for (int x = first; x < pixels; x += step) {
            gathered += sums[x] / ONE;
            differences += sums[x] % ONE;
            ofAll += ofSquares[x];
        }
        count[axis][place] += gathered;
        sum[axis][place] += differences;
        squares[axis][place] += ofAll;
    }

    /**
     * Whether a grid shows, in rows and in columns.
     *
     * @return true if differences across its borders are clearly larger
     */
    boolean shows() {
        return stands(0) && stands(1);
    }

    /**
     * How much larger differences across borders are than others.
     *
     * @return as a share of these, mean of rows and columns; 0 where nothing was gathered
     */
    double excess() {
        return (excess(0) + excess(1)) / 2;
    }

    private double excess(int axis) {
        int border = border(axis);
        double usual = meanElsewhere(sum, axis, border);
        return usual > 0 ? mean(axis, border) / usual - 1 : 0;
    }

    private boolean stands(int axis) {
        int border = border(axis);
        double usual = meanElsewhere(sum, axis, border);
        if (!(usual > 0) || count[axis][border] == 0) {
            return false;
        }
        double variance = meanElsewhere(squares, axis, border) - usual * usual;
        double excess = mean(axis, border) - usual;
        return excess > (LEAST_RATIO - 1) * usual
                && excess > LEAST_DEVIATIONS * Math.sqrt(variance / count[axis][border]);
    }

    /** Where in a block differences are largest. */
    private int border(int axis) {
        int border = 0;
        for (int k = 1; k < BLOCK; k++) {
            if (mean(axis, k) > mean(axis, border)) {
                border = k;
            }
        }
        return border;
    }

    /** Mean of differences, or of their squares, but for those across the border; 0 where there are none. */
    private double meanElsewhere(double[][] of, int axis, int border) {
        long n = 0;
        double total = 0;
        for (int k = 0; k < BLOCK; k++) {
            if (k != border) {
                n += count[axis][k];
                total += of[axis][k];
            }
        }
        return n == 0 ? 0 : total / n;
    }

    private double mean(int axis, int place) {
        return count[axis][place] == 0 ? 0 : sum[axis][place] / count[axis][place];
    }
}
