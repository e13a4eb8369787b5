package org.cellgauge.vision;

import java.util.Arrays;

/**
 * Grey values about one marker as they were before an unsharp mask made {@code s = u + a (u - G u)} of them, G a
 * Gaussian sampled at whole pixels.
 *
 * <p>The mask multiplies every frequency by 1 to 1 + a, so it can be undone: {@code u = (s + a G u) / (1 + a)} by
 * fixed-point rounds (Jacobi), each of which shrinks what is left by a / (1 + a) or more. What comes out has the noise
 * that was there before the mask, independent from pixel to pixel if it was so then, and all that is fitted to it holds
 * as for a photo that nobody sharpened. Where sharpening went over the ends of the scale, a value says no more
 * than that: given its neighbours, s reaches white where u reaches a limit of that pixel's own ({@link #cap}), and
 * black likewise ({@link #floor}). Not thread-safe; arrays are kept.
 */
final class Unsharpened {
    private static final double WHITE = 255;
    /** Where the Gaussian is cut off, deviations. */
    private static final double REACH = 4;
    private static final int MAX_ROUNDS = 24;
    /** A round that changes no grey value by more than this is the last. */
    private static final double SETTLED_GREY = 0.01;
    private static final int FREQUENCIES = 24;
    private static final int LIKELY = 64;
    private static final int LARGEST_Z = 8;
    private static final int Z_STEPS = 32;

    private int firstX;
    private int firstY;
    private int width;
    private int height;
    private GreyImage image = GreyImage.packed(new byte[1], 1, 1);
    private double[] sharpened = new double[0];
    private int[] clippedAt = new int[0];
    private double[] before = new double[0];
    private double[] next = new double[0];
    private double[] blurred = new double[0];
    private double[] rows = new double[0];
    private double[] padded = new double[0];
    private double[] level = new double[0];
    private double[] cap = new double[0];
    private double[] floor = new double[0];
    private final double[] likely = new double[LIKELY + 1];

    /**
     * Undoes the mask in a part of an image.
     *
     * @param of the image; kept
     * @param x0 first column, in the image
     * @param y0 first row, in the image
     * @param x1 last column, in the image
     * @param y1 last row, in the image
     * @param amount of the mask, positive
     * @param radiusPx deviation of its Gaussian, positive, px
     * @param dark grey level of the marker's black
     * @param bright grey level of its white
     * @param blurPx deviation of the blur of its edges, pixels' own width included, px
     */
    void undo(GreyImage of, int x0, int y0, int x1, int y1, double amount, double radiusPx, double dark,
            double bright, double blurPx) {
        image = of;
        firstX = x0;
        firstY = y0;
        width = x1 - x0 + 1;
        height = y1 - y0 + 1;
        int size = width * height;
        if (before.length < size) {
            before = new double[size];
            next = new double[size];
            sharpened = new double[size];
            clippedAt = new int[size];
            blurred = new double[size];
            rows = new double[size];
            level = new double[size];
            cap = new double[size];
            floor = new double[size];
        }
        double[] weights = weights(radiusPx);
        double own = weights[0] * weights[0];
        double ofOwn = 1 + amount - amount * own;
        int clipped = 0;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int i = y * width + x;
                int grey = of.get(x0 + x, y0 + y);
                sharpened[i] = grey;
                if (grey == 0 || grey == (int) WHITE) {
                    clippedAt[clipped++] = i;
                }
            }
        }
        System.arraycopy(sharpened, 0, before, 0, size);
        setLikely(blurPx, radiusPx);
        double changed = Double.POSITIVE_INFINITY;
        for (int round = 0; round < MAX_ROUNDS && changed > SETTLED_GREY; round++) {
            blur(weights);
            step(size, amount, next);
            for (int k = 0; k < clipped; k++) {
                int i = clippedAt[k];
                double limit = (sharpened[i] + amount * (blurred[i] - own * before[i])) / ofOwn;
                double likely = likely(blurred[i], dark, bright);
                next[i] = sharpened[i] == 0 ? Math.min(limit, likely) : Math.max(limit, likely);
            }
            changed = largestChange(size, next);
            double[] old = before;
            before = next;
            next = old;
        }
        blur(weights);
        for (int i = 0; i < size; i++) {
            double others = amount * (blurred[i] - own * before[i]);
            cap[i] = (WHITE + others) / ofOwn;
            floor[i] = others / ofOwn;
            level[i] = (sharpened[i] + others) / ofOwn;
        }
    }

    /**
     * Prepares what a pixel is likely to be, by what its surroundings are: as at a straight edge, of which the pixel
     * sees the share Phi(d / blur) and its surroundings Phi(d / hypot(blur, radius)).
     */
    private void setLikely(double blurPx, double radiusPx) {
        double wider = Math.hypot(blurPx, radiusPx) / blurPx;
        int next = 0;
        for (int k = 0; k <= LIKELY; k++) {
            double share = (double) k / LIKELY;
            while (next < LARGEST_Z * Z_STEPS && EdgeProfile.tabulated(deviations(next)) < share) {
                next++;
            }
            likely[k] = EdgeProfile.tabulated(deviations(next) * wider);
        }
    }

    private static double deviations(int step) {
        return (double) step / Z_STEPS - LARGEST_Z / 2.0;
    }

    private double likely(double around, double dark, double bright) {
        double at = LIKELY * Math.max(0, Math.min(1, (around - dark) / Math.max(1, bright - dark)));
        int i = Math.min(LIKELY - 1, (int) at);
        return dark + (bright - dark) * (likely[i] + (at - i) * (likely[i + 1] - likely[i]));
    }

    /** Weights of a sample itself and of those 1, 2, ... samples away in a Gaussian of so many samples' deviation. */
    static double[] weights(double radius) {
        double[] weights = new double[(int) Math.ceil(REACH * radius) + 1];
        double total = 0;
        for (int k = 0; k < weights.length; k++) {
            weights[k] = Math.exp(-0.5 * k * k / (radius * radius));
            total += k == 0 ? weights[k] : 2 * weights[k];
        }
        for (int k = 0; k < weights.length; k++) {
            weights[k] /= total;
        }
        return weights;
    }

    /**
     * Mean of the logarithm of the mask's gain over all frequencies: the logarithm of its Jacobian, per pixel.
     *
     * @param amount of the mask, at least 0
     * @param radiusPx deviation of its Gaussian, positive, px
     * @return 0 for no mask, below log(1 + amount)
     */
    static double meanLogGain(double amount, double radiusPx) {
        double[] ofGaussian = gain(radiusPx);
        double mean = 0;
        for (double along : ofGaussian) {
            for (double across : ofGaussian) {
                mean += Math.log1p(amount * (1 - along * across)) / (FREQUENCIES * FREQUENCIES);
            }
        }
        return mean;
    }

    /**
     * How white noise hangs together after a mask: its kernel, of which a Gaussian of two axes is part, times itself.
     *
     * @param amount of the mask, at least 0
     * @param radiusPx deviation of its Gaussian, positive, px
     * @param correlation receives the correlation of pixels that are {@link FlatNoise#LAGS} from each other
     */
    static void noiseCorrelation(double amount, double radiusPx, double[] correlation) {
        double[] weights = weights(radiusPx);
        double own = weights[0] * weights[0];
        double ofBlurred = shared(weights, 0) * shared(weights, 0);
        double between = 2 * amount * (1 + amount);
        double total = (1 + amount) * (1 + amount) - between * own + amount * amount * ofBlurred;
        for (int l = 0; l < correlation.length; l++) {
            int x = FlatNoise.LAGS[l][0];
            int y = FlatNoise.LAGS[l][1];
            double direct = x < weights.length ? weights[x] * weights[y] : 0;
            correlation[l] = (amount * amount * shared(weights, x) * shared(weights, y) - between * direct) / total;
        }
    }

    /** What two blurred samples that far apart share of those that they were made of: weights times weights. */
    private static double shared(double[] weights, int apart) {
        double sum = 0;
        for (int k = 1 - weights.length; k + apart < weights.length; k++) {
            sum += weights[Math.abs(k)] * weights[Math.abs(k + apart)];
        }
        return sum;
    }

    /** What a sampled Gaussian leaves of frequencies from 0 to the half of one per pixel. */
    private static double[] gain(double radiusPx) {
        double[] weights = weights(radiusPx);
        double[] gain = new double[FREQUENCIES];
        for (int f = 0; f < FREQUENCIES; f++) {
            gain[f] = weights[0];
            for (int k = 1; k < weights.length; k++) {
                gain[f] += 2 * weights[k] * Math.cos(Math.PI * (f + 0.5) / FREQUENCIES * k);
            }
        }
        return gain;
    }

    private void step(int size, double amount, double[] to) {
        double[] s = sharpened;
        double[] u = before;
        double[] around = blurred;
        double length = 2 / (2 + amount);
        for (int i = 0; i < size; i++) {
            to[i] = u[i] + length * (s[i] - (1 + amount) * u[i] + amount * around[i]);
        }
    }

    private double largestChange(int size, double[] now) {
        double[] then = before;
        double largest = 0;
        for (int i = 0; i < size; i++) {
            largest = Math.max(largest, Math.abs(now[i] - then[i]));
        }
        return largest;
    }

    /** Blurs {@link #before} along rows and columns; beyond its border it goes on as there. */
    private void blur(double[] weights) {
        int size = width * height;
        int reach = weights.length - 1;
        if (padded.length < width + 2 * reach) {
            padded = new double[width + 2 * reach];
        }
        for (int start = 0; start < size; start += width) {
            // a row that goes on beyond its ends leaves a loop without conditions, which is several times as fast
            System.arraycopy(before, start, padded, reach, width);
            Arrays.fill(padded, 0, reach, before[start]);
            Arrays.fill(padded, reach + width, width + 2 * reach, before[start + width - 1]);
            for (int x = 0; x < width; x++) {
                rows[start + x] = weights[0] * padded[reach + x];
            }
            for (int k = 1; k <= reach; k++) {
                double weight = weights[k];
                for (int x = 0; x < width; x++) {
                    rows[start + x] += weight * (padded[reach + x - k] + padded[reach + x + k]);
                }
            }
        }
        for (int y = 0; y < height; y++) {
            int to = y * width;
            for (int x = 0; x < width; x++) {
                blurred[to + x] = weights[0] * rows[to + x];
            }
            for (int k = 1; k <= reach; k++) {
                double weight = weights[k];
                int above = Math.max(0, y - k) * width;
                int below = Math.min(height - 1, y + k) * width;
                for (int x = 0; x < width; x++) {
                    blurred[to + x] += weight * (rows[above + x] + rows[below + x]);
                }
            }
        }
    }

    private int index(int x, int y) {
        return x < firstX || y < firstY || x >= firstX + width || y >= firstY + height ? -1
                : (y - firstY) * width + x - firstX;
    }

    /**
     * A grey value before the mask.
     *
     * @param x column in the image
     * @param y row in the image
     * @return grey level; {@link #cap} where sharpening has reached white, {@link #floor} where it has reached black,
     *     the sharpened one outside the part
     */
    double get(int x, int y) {
        int i = index(x, y);
        return i < 0 ? image.get(x, y) : level[i];
    }

    /** From which value on a pixel is white after the mask, its neighbours being what they are, grey levels. */
    double cap(int x, int y) {
        int i = index(x, y);
        return i < 0 ? WHITE : cap[i];
    }

    /** Up to which value a pixel is black after the mask, its neighbours being what they are, grey levels. */
    double floor(int x, int y) {
        int i = index(x, y);
        return i < 0 ? 0 : floor[i];
    }

    /**
     * As {@link GreyImage#interpolate}.
     *
     * @param u pixel x, centres at +0.5
     * @param v pixel y, centres at +0.5
     * @return 0 to 255
     */
    double interpolate(double u, double v) {
        double x = Math.min(Math.max(u - 0.5, 0), image.widthPx() - 1.0);
        double y = Math.min(Math.max(v - 0.5, 0), image.heightPx() - 1.0);
        int x0 = (int) x;
        int y0 = (int) y;
        int x1 = Math.min(x0 + 1, image.widthPx() - 1);
        int y1 = Math.min(y0 + 1, image.heightPx() - 1);
        double top = get(x0, y0) + (x - x0) * (get(x1, y0) - get(x0, y0));
        double bottom = get(x0, y1) + (x - x0) * (get(x1, y1) - get(x0, y1));
        return Math.max(0, Math.min(WHITE, top + (y - y0) * (bottom - top)));
    }
}
