package org.cellgauge.internal.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.apache.commons.math3.random.RandomGenerator;
import org.junit.jupiter.api.Test;

class RandomStreamsTest {
    @Test
    void streamRepeatsBySeedAndPath() {
        RandomGenerator a = RandomStreams.of(42, 1, 2);
        RandomGenerator b = RandomStreams.of(42, 1, 2);
        for (int i = 0; i < 1000; i++) {
            assertEquals(a.nextLong(), b.nextLong());
        }
    }

    @Test
    void seedsAndPathsThatDifferGiveOtherStreams() {
        long[][] paths = {{}, {0}, {0, 0}, {1}, {1, 0}, {0, 1}, {2}, {-1}, {1, 2}, {2, 1}, {3, 0}, {0, 3}, {1, 1},
            {1, 1, 1}};
        Set<Long> first = new HashSet<>();
        int streams = 0;
        for (long seed : new long[] {0, 1, -1, 2, 42, Long.MAX_VALUE, Long.MIN_VALUE}) {
            for (long[] path : paths) {
                first.add(RandomStreams.of(seed, path).nextLong());
                streams++;
            }
        }
        assertEquals(streams, first.size());
    }

    /** Neighbouring paths must not give shifted or alike numbers: correlations at several lags within their error. */
    @Test
    void neighbouringStreamsAreUncorrelated() {
        int n = 20_000;
        double[][] x = new double[4][n];
        for (int s = 0; s < 4; s++) {
            RandomGenerator random = RandomStreams.of(7, s);
            for (int i = 0; i < n; i++) {
                x[s][i] = random.nextGaussian();
            }
        }
        for (int a = 0; a < 4; a++) {
            for (int b = 0; b < a; b++) {
                for (int lag = 0; lag < 20; lag++) {
                    double sum = 0;
                    for (int i = lag; i < n; i++) {
                        sum += x[a][i] * x[b][i - lag];
                    }
                    assertTrue(Math.abs(sum / n) < 5 / Math.sqrt(n), "streams " + a + ", " + b + " lag " + lag);
                }
            }
        }
    }
}
