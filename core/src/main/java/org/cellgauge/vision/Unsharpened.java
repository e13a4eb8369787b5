package org.cellgauge.vision;

import java.util.Arrays;

/**
 * Grey values about one marker as they were before an unsharp mask made {@code s = u + a (u - G u)} of them, G a
 * Gaussian sampled at whole pixels.
 *
 * <p>The mask multiplies every frequency by 1 to 1 + a, so it can be undone: {@code (1 + a) u - a G u = s} by
 * Richardson's rounds with Chebyshev's acceleration (Saad, "Iterative Methods for Sparse Linear Systems", 2003,
 * algorithm 12.1), each of which shrinks what is left by (r - 1) / (r + 1), r being the root of 1 + a. What comes out
 * has the noise that was there before the mask, independent from pixel to pixel if it was so then, and all that is
 * fitted to it holds as for a photo that nobody sharpened. Where sharpening went over the ends of the scale, a value
 * says no more than that: given its neighbours, s reaches white where u reaches a limit of that pixel's own ({@link
 * #cap}), and black likewise ({@link #floor}). Not thread-safe; arrays are kept.
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
    /** By how much the last round moved each value. */
    private double[] change = new double[0];
    private double[] blurred = new double[0];
    /** The same with a border, before and after, and in between, blurred along rows. */
    private double[] wide = new double[0];
    private double[] ofRows = new double[0];
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
            change = new double[size];
            sharpened = new double[size];
            clippedAt = new int[size];
            blurred = new double[size];
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
        Arrays.fill(change, 0, size, 0);
        setLikely(blurPx, radiusPx);
        double changed = Double.POSITIVE_INFINITY;
        double ratio = (2 + amount) / amount;
        double rho = 1 / ratio;
        double length = 2 / (2 + amount);
        double momentum = 0;
        for (int round = 0; round < MAX_ROUNDS && changed > SETTLED_GREY; round++) {
            blur(weights);
            // clipped values are found by another rule, and each of their rounds goes by the one before it alone
            if (round > 0 && clipped == 0) {
                double last = rho;
                rho = 1 / (2 * ratio - last);
                momentum = rho * last;
                length = 4 * rho / amount;
            }
            step(size, amount, momentum, length);
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

    private void step(int size, double amount, double momentum, double length) {
        double[] s = sharpened;
        double[] u = before;
        double[] around = blurred;
        double[] d = change;
        double[] to = next;
        for (int i = 0; i < size; i++) {
            double moved = momentum * d[i] + length * (s[i] - (1 + amount) * u[i] + amount * around[i]);
            d[i] = moved;
            to[i] = u[i] + moved;
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

    /**
     * Blurs {@link #before} along rows and columns; beyond its border it goes on as there. With that border about it
     * all rows are one long loop without conditions, which is several times as fast as a short one for each.
     */
    private void blur(double[] weights) {
        // the weights are taken in twos, be it that there is no second
        int border = weights.length;
        int stride = width + 2 * border;
        int size = stride * (height + 2 * border);
        if (wide.length < size) {
            wide = new double[size];
            ofRows = new double[size];
        }
        for (int y = 0; y < height; y++) {
            int start = (y + border) * stride;
            System.arraycopy(before, y * width, wide, start + border, width);
            Arrays.fill(wide, start, start + border, before[y * width]);
            Arrays.fill(wide, start + border + width, start + stride, before[(y + 1) * width - 1]);
        }
        int first = border * stride;
        int end = first + height * stride;
        blur(wide, ofRows, first + border, end - border, 1, weights);
        for (int k = 1; k <= border; k++) {
            System.arraycopy(ofRows, first, ofRows, first - k * stride, stride);
            System.arraycopy(ofRows, end - stride, ofRows, end + (k - 1) * stride, stride);
        }
        blur(ofRows, wide, first + border, end - border, stride, weights);
        for (int y = 0; y < height; y++) {
            System.arraycopy(wide, (y + border) * stride + border, blurred, y * width, width);
        }
    }

    /** Blurs some numbers of an array, with as many beside them as weights reach, so far apart. */
    private static void blur(double[] in, double[] out, int from, int to, int apart, double[] weights) {
        for (int k = 0; k < weights.length; k += 2) {
            double one = weights[k];
            double two = k + 1 < weights.length ? weights[k + 1] : 0;
            int near = k * apart;
            int far = (k + 1) * apart;
            if (k == 0) {
                for (int i = from; i < to; i++) {
                    out[i] = one * in[i] + two * (in[i - far] + in[i + far]);
                }
            } else {
                for (int i = from; i < to; i++) {
                    out[i] += one * (in[i - near] + in[i + near]) + two * (in[i - far] + in[i + far]);
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
