package org.cellgauge.internal.statistics;

import java.util.Arrays;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
import org.jspecify.annotations.Nullable;

/**
 * Autocovariances of several series of equal length, each about its own mean, with the series' length as divisor at
 * every lag; their mean over the series. Two neighbouring lags at a time are computed as they are asked for.
 *
 * <p>Chains that mix well need a dozen lags, for which summing products is far cheaper than a Fourier transform;
 * chains that do not need thousands, for which it is the other way round.
 */
public final class Autocovariance {
    private static final int DIRECT_LAGS = 96;
    /** A series that is still so much like itself at this lag has not forgotten itself at {@link #DIRECT_LAGS}. */
    private static final int EARLY_LAG = 16;
    private static final double SLOW = 0.6;

    private final double[] centred;
    private final int length;
    private final int count;
    private final double varianceOfMeans;
    /** Autocovariances at the lag asked for last, even, and at the one after it. */
    private final double[] pair = new double[2];
    private int pairAt = -1;
    private double variance = Double.NaN;
    private double @Nullable [] transformed;

    /**
     * Prepares series.
     *
     * @param series one after the other; taken over, and changed
     * @param length of each, at least 2
     */
    public Autocovariance(double[] series, int length) {
        this.centred = series;
        this.length = length;
        this.count = series.length / length;
        double[] means = new double[count];
        for (int s = 0; s < count; s++) {
            means[s] = Sums.centre(series, s * length, (s + 1) * length);
        }
        this.varianceOfMeans = Sums.variance(means, 0, count);
    }

    /**
     * Variance of the series' means.
     *
     * @return it, divisor one less than their number; NaN of a single one
     */
    public double varianceOfMeans() {
        return varianceOfMeans;
    }

    /**
     * Mean autocovariance at a lag.
     *
     * @param lag from 0, below the length
     * @return the mean over the series
     */
    public double at(int lag) {
        if (transformed == null && lag >= DIRECT_LAGS) {
            transformed = transform(paddedSize(length + length / 2));
        }
        if (transformed != null) {
            if (lag >= transformed.length) {
                transformed = transform(paddedSize(2 * length - 1));
            }
            return transformed[lag];
        }
        int even = lag & ~1;
        if (even != pairAt) {
            products(even);
            pairAt = even;
            if (even == 0) {
                variance = pair[0];
            } else if (even == EARLY_LAG && pair[0] > SLOW * variance) {
                transformed = transform(paddedSize(length + length / 2));
            }
        }
        return pair[lag - even];
    }

    /** The power of two that holds so many points. */
    private static int paddedSize(int points) {
        return Integer.highestOneBit(points - 1) << 1;
    }

    /** Sums of products at a lag and the next: four sums each, so that no addition waits for the one before it. */
    private void products(int lag) {
        double[] x = centred;
        double first = 0;
        double second = 0;
        for (int s = 0; s < count; s++) {
            int end = (s + 1) * length;
            int from = s * length + lag + 1;
            double a0 = from - 1 < end ? x[from - 1] * x[from - 1 - lag] : 0;
            double a1 = 0;
            double a2 = 0;
            double a3 = 0;
            double b0 = 0;
            double b1 = 0;
            double b2 = 0;
            double b3 = 0;
            int i = from;
            for (; i < end - 3; i += 4) {
                int j = i - lag;
                double y0 = x[j];
                double y1 = x[j + 1];
                double y2 = x[j + 2];
                a0 += x[i] * y0;
                b0 += x[i] * x[j - 1];
                a1 += x[i + 1] * y1;
                b1 += x[i + 1] * y0;
                a2 += x[i + 2] * y2;
                b2 += x[i + 2] * y1;
                a3 += x[i + 3] * x[j + 3];
                b3 += x[i + 3] * y2;
            }
            for (; i < end; i++) {
                a0 += x[i] * x[i - lag];
                b0 += x[i] * x[i - lag - 1];
            }
            first += a0 + a1 + (a2 + a3);
            second += b0 + b1 + (b2 + b3);
        }
        pair[0] = first / length / count;
        pair[1] = second / length / count;
    }

    /**
     * Lags at once, as far as padding goes: a transform of {@code size} points is circular, and at lags above
     * {@code size - length} the end of a series would meet its own beginning. Sums of autocorrelations seldom need more
     * than half of all lags.
     *
     * <p>The transform of the summed power spectra: two series go through one transform, as real and imaginary part;
     * the power of both together is that of the complex series but for what is imaginary at the end.
     */
    private double[] transform(int size) {
        int n = length;
        double[][] data = new double[2][size];
        double[][] power = new double[2][size];
        for (int s = 0; s < count; s += 2) {
            for (int part = 0; part < 2; part++) {
                Arrays.fill(data[part], 0);
                if (s + part < count) {
                    System.arraycopy(centred, (s + part) * n, data[part], 0, n);
                }
            }
            FastFourierTransformer.transformInPlace(data, DftNormalization.STANDARD, TransformType.FORWARD);
            for (int k = 0; k < size; k++) {
                power[0][k] += data[0][k] * data[0][k] + data[1][k] * data[1][k];
            }
        }
        FastFourierTransformer.transformInPlace(power, DftNormalization.STANDARD, TransformType.INVERSE);
        double[] out = new double[Math.min(n, size - n + 1)];
        for (int t = 0; t < out.length; t++) {
            out[t] = power[0][t] / n / count;
        }
        return out;
    }
}
