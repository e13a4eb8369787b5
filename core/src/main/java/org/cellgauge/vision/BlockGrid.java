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

    // first across columns, then across rows
    private final long[][] count = new long[2][BLOCK];
    private final double[][] sum = new double[2][BLOCK];
    private final double[][] squares = new double[2][BLOCK];

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
        double edge = Math.max(LEAST_EDGE, EDGE_NOISES * noiseGrey);
        for (int y = Math.max(0, y0); y < Math.min(y1, image.heightPx() - 1); y++) {
            for (int x = Math.max(0, x0); x < Math.min(x1, image.widthPx() - 1); x++) {
                int here = image.get(x, y);
                gather(0, x % BLOCK, Math.abs(image.get(x + 1, y) - here), edge);
                gather(1, y % BLOCK, Math.abs(image.get(x, y + 1) - here), edge);
            }
        }
    }

    private void gather(int axis, int place, int difference, double edge) {
        if (difference <= edge) {
            count[axis][place]++;
            sum[axis][place] += difference;
            squares[axis][place] += difference * difference;
        }
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
