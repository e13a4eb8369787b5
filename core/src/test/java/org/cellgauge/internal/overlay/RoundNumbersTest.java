package org.cellgauge.internal.overlay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class RoundNumbersTest {
    @Test
    void roundsUpAndDownToTheSeries() {
        double[][] cases = {{1, 1, 1}, {1.01, 2, 1}, {3, 5, 2}, {5, 5, 5}, {7, 10, 5}, {10, 10, 10}, {61.5, 100, 50},
            {999, 1000, 500}, {1000, 1000, 1000}, {0.1, 0.1, 0.1}, {0.03, 0.05, 0.02}, {0.00021, 0.0005, 0.0002}};
        for (double[] c : cases) {
            assertEquals(c[1], RoundNumbers.atLeast(c[0]), 1e-12 * c[1], "at least " + c[0]);
            assertEquals(c[2], RoundNumbers.atMost(c[0]), 1e-12 * c[2], "at most " + c[0]);
        }
    }

    @Test
    void refusesWhatHasNoRoundNumber() {
        for (double v : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThrows(IllegalArgumentException.class, () -> RoundNumbers.atLeast(v));
            assertThrows(IllegalArgumentException.class, () -> RoundNumbers.atMost(v));
        }
    }
}
