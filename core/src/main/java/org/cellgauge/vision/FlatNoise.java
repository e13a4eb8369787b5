package org.cellgauge.vision;

import java.util.Arrays;

/**
 * How the noise of pixels near each other hangs together, as flat ground about markers shows it: a wall, a table, white
 * paper. Noise of a camera is independent from pixel to pixel, or smooth where colours were interpolated and noise was
 * filtered; an unsharp mask makes it blue, so that neighbours differ by more than they would. Not thread-safe.
 *
 * <p>Ground is taken in tiles. From each the plane that fits it best is taken off, and with it a little of the noise,
 * for which correlations are corrected: by the trace of the hat matrix and how much smooth noise there is. Tiles whose
 * variance is larger than is usual for flat ones have an edge or a pattern and are left out, as are those at the ends
 * of the scale. Most photos' noise is not blue, which a few tiles tell.
 */
final class FlatNoise {
    /** Places of a neighbour, px along one axis and the other, in either direction and either way round. */
    static final int[][] LAGS = {{1, 0}, {1, 1}, {2, 0}, {2, 1}, {3, 0}};
    /** How far about a marker ground is looked at, px. */
    private static final int ABOUT_PX = 48;
    /** Kept clear between a marker and ground, px. */
    private static final int CLEAR_PX = 3;
    private static final int TILE = 16;
    private static final int PIXELS = TILE * TILE;
    private static final int PLANE = 3;
    private static final int MOST_TILES = 192;
    private static final int LEAST_TILES = 12;
    /** Tiles by which noise that is not blue at all is told at once, and by how many deviations. */
    private static final int FIRST_TILES = 48;
    private static final double SURELY_NOT = 2;
    /** Of tiles in order of their variance, this share is surely flat if a good part of the ground is. */
    private static final double SURELY_FLAT = 0.25;
    /** Variance of 253 degrees of freedom varies by a twelfth; ground of another brightness has other noise. */
    private static final double LARGEST_VARIANCE = 1.6;
    /** Variance of rounding to whole grey levels, independent from pixel to pixel where noise is larger. */
    private static final double ROUNDING = 1.0 / 12;
    private static final double LEAST_VARIANCE = 4 * ROUNDING;

    /**
     * Squares of what is left of the correlations by the mask that explains them best, in the variance of white noise's
     * and {@link #MODEL_STD}: more is no mask's doing.
     */
    private static final double MOST_MISFIT = 30;
    /** How much like white noise that of a camera is before a mask, as a correlation. */
    private static final double MODEL_STD = 0.007;
    private static final double LEAST_AMOUNT = 0.1;
    private static final double LARGEST_AMOUNT = 4;
    private static final double AMOUNT_STEP = 1.3;
    private static final double LEAST_RADIUS_PX = 0.4;
    private static final double LARGEST_RADIUS_PX = 4;
    private static final double RADIUS_STEP = 1.2;

    private final int[][][] ways = new int[LAGS.length][][];
    /** What the plane takes of the products of white noise of variance 1, by lag; and how many pairs a tile has. */
    private final double[] taken = new double[LAGS.length];
    private final int[] pairsOfTile = new int[LAGS.length];
    private final double slopeSquares;
    private final int[] tileX = new int[MOST_TILES];
    private final int[] tileY = new int[MOST_TILES];
    private int places;
    private final int[] taking = new int[PIXELS];
    private final double[] ofPlane = new double[TILE];
    /** What is left of a tile without its plane. */
    private final double[] grey = new double[PIXELS];
    private final double[] variances = new double[MOST_TILES];
    private final double[] sorted = new double[MOST_TILES];
    private final double[] products = new double[MOST_TILES * LAGS.length];
    private int tiles;
    private int flat;
    private final double[] correlation = new double[LAGS.length];

    FlatNoise() {
        double squares = 0;
        for (int k = 0; k < TILE; k++) {
            squares += TILE * centred(k) * centred(k);
        }
        slopeSquares = squares;
        for (int l = 0; l < LAGS.length; l++) {
            ways[l] = ways(LAGS[l]);
            for (int[] way : ways[l]) {
                for (int i = 0; i < PIXELS; i++) {
                    int x = i % TILE;
                    int y = i / TILE;
                    int x2 = x + way[0];
                    int y2 = y + way[1];
                    if (x2 >= 0 && x2 < TILE && y2 < TILE) {
                        pairsOfTile[l]++;
                        taken[l] += 1.0 / PIXELS
                                + (centred(x) * centred(x2) + centred(y) * centred(y2)) / slopeSquares;
                    }
                }
            }
        }
    }

    /** Neighbours at a lag of which no two are each other's opposites; none is above. */
    private static int[][] ways(int[] lag) {
        if (lag[1] == 0) {
            return new int[][] {{lag[0], 0}, {0, lag[0]}};
        }
        if (lag[0] == lag[1]) {
            return new int[][] {{lag[0], lag[0]}, {-lag[0], lag[0]}};
        }
        return new int[][] {{lag[0], lag[1]}, {-lag[0], lag[1]}, {lag[1], lag[0]}, {-lag[1], lag[0]}};
    }

    private static double centred(int k) {
        return k - (TILE - 1) / 2.0;
    }

    /** Forgets what ground there was. */
    void clear() {
        places = 0;
        flat = 0;
    }

    /**
     * Takes note of the ground about a marker.
     *
     * @param image the photo
     * @param cornersPx 8 values: u, v of the marker's corners, px
     */
    void add(GreyImage image, double[] cornersPx) {
        double left = Double.POSITIVE_INFINITY;
        double top = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double bottom = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < 8; i += 2) {
            left = Math.min(left, cornersPx[i]);
            right = Math.max(right, cornersPx[i]);
            top = Math.min(top, cornersPx[i + 1]);
            bottom = Math.max(bottom, cornersPx[i + 1]);
        }
        int x0 = Math.max(0, (int) left - ABOUT_PX);
        int y0 = Math.max(0, (int) top - ABOUT_PX);
        int x1 = Math.min(image.widthPx(), (int) right + ABOUT_PX) - TILE;
        int y1 = Math.min(image.heightPx(), (int) bottom + ABOUT_PX) - TILE;
        for (int y = y0; y <= y1; y += TILE) {
            for (int x = x0; x <= x1; x += TILE) {
                boolean onMarker = x < right + CLEAR_PX && x + TILE > left - CLEAR_PX && y < bottom + CLEAR_PX
                        && y + TILE > top - CLEAR_PX;
                if (!onMarker && places < MOST_TILES) {
                    tileX[places] = x;
                    tileY[places++] = y;
                }
            }
        }
    }

    /**
     * Works out how the noise of the ground hangs together.
     *
     * @param image the photo
     * @param most correlation of pixels beside each other that is of interest: where it surely is larger, the others
     *     are not worked out
     * @param few whether a few tiles are enough, and the correlations need not be well known
     * @return whether there is flat ground enough, with noise enough, and neighbours may hang together by no more
     */
    boolean measure(GreyImage image, double most, boolean few) {
        int step = Math.max(1, places / FIRST_TILES);
        if (few) {
            return gather(image, step, LAGS.length) && correlation[0] < most;
        }
        if (!gather(image, step, 1) || correlation[0] > most + SURELY_NOT * Math.sqrt(variance(0))) {
            return false;
        }
        return gather(image, 1, LAGS.length) && correlation[0] < most;
    }

    private boolean gather(GreyImage image, int step, int lags) {
        tiles = 0;
        for (int t = 0; t < places; t += step) {
            addTile(image, tileX[t], tileY[t], lags);
        }
        return conclude(lags);
    }

    private void addTile(GreyImage image, int x0, int y0, int lags) {
        if (!take(image, x0, y0)) {
            return;
        }
        double variance = flatten() / (PIXELS - PLANE);
        if (variance < LEAST_VARIANCE) {
            return;
        }
        variances[tiles] = variance;
        for (int l = 0; l < lags; l++) {
            double ofLag = 0;
            for (int[] way : ways[l]) {
                ofLag += products(way[0], way[1]);
            }
            products[tiles * LAGS.length + l] = ofLag;
        }
        tiles++;
    }

    /** Takes a tile from the image; whether none of it is at an end of the scale. */
    private boolean take(GreyImage image, int x0, int y0) {
        byte[] in = image.luminance();
        int[] out = taking;
        int atEnds = 0;
        for (int y = 0, i = 0; y < TILE; y++) {
            int at = image.offset() + (y0 + y) * image.rowStride() + x0;
            for (int x = 0; x < TILE; x++) {
                int value = in[at + x] & 0xFF;
                // negative at either end
                atEnds |= value - 1 | 254 - value;
                out[i++] = value;
            }
        }
        return atEnds >= 0;
    }

    /** Takes the plane that fits a tile best off it; the sum of the squares of what is left. */
    private double flatten() {
        int sum = 0;
        int byColumn = 0;
        int byRow = 0;
        for (int y = 0, i = 0; y < TILE; y++) {
            int ofRow = 0;
            for (int x = 0; x < TILE; x++) {
                int value = taking[i++];
                ofRow += value;
                byColumn += x * value;
            }
            sum += ofRow;
            byRow += y * ofRow;
        }
        double mean = (double) sum / PIXELS;
        double byX = (byColumn + centred(0) * sum) / slopeSquares;
        double byY = (byRow + centred(0) * sum) / slopeSquares;
        for (int x = 0; x < TILE; x++) {
            ofPlane[x] = byX * centred(x);
        }
        double[] left = grey;
        double even = 0;
        double odd = 0;
        for (int y = 0, i = 0; y < TILE; y++) {
            double ofRow = mean + byY * centred(y);
            for (int x = 0; x < TILE; x += 2, i += 2) {
                double here = taking[i] - (ofRow + ofPlane[x]);
                double beside = taking[i + 1] - (ofRow + ofPlane[x + 1]);
                left[i] = here;
                left[i + 1] = beside;
                even += here * here;
                odd += beside * beside;
            }
        }
        return even + odd;
    }

    private double products(int byX, int byY) {
        double[] of = grey;
        int from = Math.max(0, -byX);
        int to = TILE - Math.max(0, byX);
        int step = byY * TILE + byX;
        // several sums, as each addition waits for the one before it
        double first = 0;
        double second = 0;
        double third = 0;
        double fourth = 0;
        for (int y = 0; y < TILE - byY; y++) {
            int i = y * TILE + from;
            int end = y * TILE + to;
            for (; i + 3 < end; i += 4) {
                first += of[i] * of[i + step];
                second += of[i + 1] * of[i + 1 + step];
                third += of[i + 2] * of[i + 2 + step];
                fourth += of[i + 3] * of[i + 3 + step];
            }
            for (; i < end; i++) {
                first += of[i] * of[i + step];
            }
        }
        return first + second + (third + fourth);
    }

    private boolean conclude(int lags) {
        Arrays.fill(correlation, 0);
        flat = 0;
        if (tiles < LEAST_TILES) {
            return false;
        }
        System.arraycopy(variances, 0, sorted, 0, tiles);
        Arrays.sort(sorted, 0, tiles);
        double most = LARGEST_VARIANCE * sorted[(int) (SURELY_FLAT * tiles)];
        for (int t = 0; t < tiles; t++) {
            if (variances[t] > most) {
                continue;
            }
            flat++;
            for (int l = 0; l < lags; l++) {
                correlation[l] += products[t * LAGS.length + l] / pairsOfTile[l] / (variances[t] - ROUNDING);
            }
        }
        double smooth = 1;
        for (int l = 0; l < lags; l++) {
            correlation[l] /= flat;
            smooth += 2 * ways[l].length * correlation[l];
        }
        for (int l = 0; l < lags; l++) {
            correlation[l] += Math.max(0, smooth) * taken[l] / pairsOfTile[l];
        }
        return flat >= LEAST_TILES;
    }

    /**
     * Whether an unsharp mask may have made of white noise what was measured. A pattern of a few pixels' period, as a
     * screen or a cloth has, makes neighbours differ too.
     *
     * @return whether a mask explains the correlations
     */
    boolean isOfAMask() {
        double[] ofMask = new double[LAGS.length];
        double least = Double.POSITIVE_INFINITY;
        for (double amount = LEAST_AMOUNT; amount <= LARGEST_AMOUNT; amount *= AMOUNT_STEP) {
            for (double radius = LEAST_RADIUS_PX; radius <= LARGEST_RADIUS_PX; radius *= RADIUS_STEP) {
                Unsharpened.noiseCorrelation(amount, radius, ofMask);
                least = Math.min(least, misfit(ofMask));
            }
        }
        return least < MOST_MISFIT;
    }

    /**
     * How far the correlations are from others.
     *
     * @param expected correlation at each of {@link #LAGS}
     * @return sum of the squared differences, each in its variance
     */
    double misfit(double[] expected) {
        double misfit = 0;
        for (int l = 0; l < LAGS.length; l++) {
            double off = correlation[l] - expected[l];
            misfit += weight(l) * off * off;
        }
        return misfit;
    }

    /**
     * How much a correlation counts: inverse of its variance, with what cameras' noise before a mask is not white.
     *
     * @param lag index in {@link #LAGS}
     * @return positive
     */
    double weight(int lag) {
        return 1 / (MODEL_STD * MODEL_STD + variance(lag));
    }

    /**
     * Correlation of the noise, after {@link #measure} has found it of interest.
     *
     * @param lag index in {@link #LAGS}
     * @return -1 to 1, rounding to whole grey levels left out
     */
    double correlation(int lag) {
        return correlation[lag];
    }

    /**
     * Variance of a correlation where noise is white.
     *
     * @param lag index in {@link #LAGS}
     * @return positive
     */
    double variance(int lag) {
        return 1.0 / (flat * (double) pairsOfTile[lag]);
    }
}
