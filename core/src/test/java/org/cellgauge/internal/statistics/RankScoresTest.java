package org.cellgauge.internal.statistics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.internal.sampling.RandomStreams;
import org.junit.jupiter.api.Test;

/** Order, normal scores and autocovariances of draws against other ways to compute them. */
class RankScoresTest {
    @Test
    void orderIsThatOfTheNumbers() {
        RandomGenerator random = RandomStreams.of(1);
        double[] values = new double[3000];
        for (int i = 0; i < values.length; i++) {
            values[i] = random.nextGaussian() * Math.pow(10, i % 40 - 20);
        }
        double[] special = {0.0, -0.0, Double.MAX_VALUE, -Double.MAX_VALUE, Double.MIN_VALUE, -Double.MIN_VALUE, 1, 1};
        System.arraycopy(special, 0, values, 100, special.length);
        double[] sorted = new double[values.length];
        int[] order = RadixSort.sort(values, sorted);
        double[] expected = values.clone();
        Arrays.sort(expected);
        assertArrayEquals(expected, sorted, 0);
        for (int i = 0; i < order.length; i++) {
            assertEquals(sorted[i], values[order[i]], 0);
        }
        assertArrayEquals(new int[0], RadixSort.sort(new double[0], new double[0]));
    }

    /** Of draws as chains give them, with repeats; with zeros of both signs; with far ones that crowd the rest. */
    @Test
    void bucketsSortAsDigitsDo() {
        RandomGenerator random = RandomStreams.of(2);
        double[] draws = new double[4000];
        double[] heavy = new double[4000];
        double[] zeros = new double[300];
        for (int i = 0; i < draws.length; i++) {
            draws[i] = i > 0 && random.nextInt(3) == 0 ? draws[i - 1] : 1000 + random.nextGaussian();
            heavy[i] = Math.exp(10 * random.nextGaussian());
        }
        for (int i = 0; i < zeros.length; i++) {
            zeros[i] = i % 3 == 0 ? 0.0 : i % 3 == 1 ? -0.0 : i - 150;
        }
        for (double[] values : new double[][] {draws, heavy, zeros, {}, {3}, {5, 5, 5}, {2, 1},
            {Double.MAX_VALUE, -Double.MAX_VALUE, 0}, {0, Double.MIN_VALUE, 0}}) {
            double[] sorted = new double[values.length];
            double[] expected = new double[values.length];
            assertArrayEquals(RadixSort.sort(values, expected),
                    BucketSort.sort(values, sorted, new DrawsWork.Pool().take()));
            for (int i = 0; i < sorted.length; i++) {
                assertEquals(Double.doubleToRawLongBits(expected[i]), Double.doubleToRawLongBits(sorted[i]));
            }
        }
    }

    @Test
    void quantilesAreThoseOfTheNormalDistribution() {
        NormalDistribution normal = new NormalDistribution(null, 0, 1);
        for (double p : new double[] {1e-200, 1e-14, 1e-9, 1e-4, 0.07, 0.0751, 0.3, 0.5}) {
            assertEquals(1, normal.cumulativeProbability(NormalQuantile.of(p)) / p, 1e-12, "of " + p);
        }
        for (double p : new double[] {0.51, 0.92, 0.93, 0.999}) {
            assertEquals(1, normal.cumulativeProbability(-NormalQuantile.of(p)) / (1 - p), 1e-12, "of " + p);
        }
    }

    @Test
    void tiesShareTheirAverageRank() {
        double[] scores = new double[4];
        new RankScores(4).fill(new double[] {1, 2, 2, 5}, new int[] {3, 0, 2, 1}, scores);
        NormalDistribution normal = new NormalDistribution(null, 0, 1);
        assertEquals(normal.inverseCumulativeProbability(0.625 / 4.25), scores[3], 1e-14);
        assertEquals(0, scores[0], 1e-15);
        assertEquals(0, scores[2], 1e-15);
        assertEquals(normal.inverseCumulativeProbability(3.625 / 4.25), scores[1], 1e-14);
    }

    /** Beyond the lag from which they come from transforms as well as before; an odd number of series, too. */
    @Test
    void autocovariancesAreMeansOfProducts() {
        RandomGenerator random = RandomStreams.of(2);
        int n = 203;
        double[] series = new double[3 * n];
        for (int i = 0; i < series.length; i++) {
            series[i] = 10 + random.nextGaussian() + (i % n == 0 ? 0 : 0.9 * (series[i - 1] - 10));
        }
        Autocovariance autocovariance = new Autocovariance(series.clone(), n);
        for (int lag : new int[] {0, 1, 2, 7, 95, 96, 150, 202, 3}) {
            double expected = 0;
            for (int s = 0; s < 3; s++) {
                double mean = Arrays.stream(series, s * n, (s + 1) * n).average().orElseThrow();
                for (int i = lag; i < n; i++) {
                    expected += (series[s * n + i] - mean) * (series[s * n + i - lag] - mean) / n / 3;
                }
            }
            assertEquals(expected, autocovariance.at(lag), 1e-12, "lag " + lag);
        }
    }
}
