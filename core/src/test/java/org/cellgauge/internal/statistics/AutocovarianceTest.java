package org.cellgauge.internal.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** Sums of products, as the definition has them, at every lag and whatever way they are computed. */
class AutocovarianceTest {
    /** Mean over the series of (1 / n) sum of (x_i - mean) (x_i+lag - mean). */
    private static double defined(double[] series, int length, int lag) {
        double sum = 0;
        int count = series.length / length;
        for (int s = 0; s < count; s++) {
            double mean = 0;
            for (int i = 0; i < length; i++) {
                mean += series[s * length + i] / length;
            }
            for (int i = 0; i + lag < length; i++) {
                sum += (series[s * length + i] - mean) * (series[s * length + i + lag] - mean) / length / count;
            }
        }
        return sum;
    }

    private static double[] autoregressive(int count, int length, double correlation) {
        Random random = new Random(7);
        double[] out = new double[count * length];
        for (int i = 1; i < out.length; i++) {
            out[i] = correlation * out[i - 1] + random.nextGaussian();
        }
        return out;
    }

    private static void everyLagAsDefined(int count, int length, double correlation) {
        double[] series = autoregressive(count, length, correlation);
        Autocovariance found = new Autocovariance(series.clone(), length);
        double variance = defined(series, length, 0);
        for (int lag = 0; lag < length; lag++) {
            assertEquals(defined(series, length, lag), found.at(lag), 1e-12 * variance,
                    count + " of " + length + ", lag " + lag);
        }
    }

    /** Lengths about powers of two, where the padding is least; one series and an odd number of them. */
    @Test
    void fastAndSlowSeriesOfAnyLength() {
        for (int length : new int[] {2, 3, 17, 97, 127, 128, 129, 341, 342, 500}) {
            for (double correlation : new double[] {0, 0.9, 0.999}) {
                everyLagAsDefined(1, length, correlation);
                everyLagAsDefined(3, length, correlation);
            }
        }
    }

    /** Lags may be asked for out of order. */
    @Test
    void lagsInAnyOrder() {
        double[] series = autoregressive(2, 300, 0.99);
        Autocovariance found = new Autocovariance(series.clone(), 300);
        for (int lag : new int[] {299, 0, 16, 17, 150, 95, 96}) {
            assertEquals(defined(series, 300, lag), found.at(lag), 1e-12 * defined(series, 300, 0), "lag " + lag);
        }
    }
}
