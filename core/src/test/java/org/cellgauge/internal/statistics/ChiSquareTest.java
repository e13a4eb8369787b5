package org.cellgauge.internal.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class ChiSquareTest {

    /** With two degrees of freedom the upper tail is exp(-x / 2). */
    @Test
    void pValueOfTwoSquares() {
        for (double x : new double[] {0, 0.1, 1, 3, 10, 30}) {
            assertEquals(Math.exp(-x / 2), ChiSquare.pValue(x, 2), 1e-14, "at " + x);
        }
    }

    /** The limit at 1 % of 8 degrees of freedom as in any table of the distribution. */
    @Test
    void pValueOfEightSquares() {
        assertEquals(0.01, ChiSquare.pValue(20.090, 8), 1e-5);
    }

    @Test
    void nothingTestedHasNone() {
        assertEquals(Double.NaN, ChiSquare.pValue(0, 0));
        assertEquals(Double.NaN, ChiSquare.pValue(Double.NaN, 8));
        assertEquals(Double.NaN, ChiSquare.pValue(Double.POSITIVE_INFINITY, 8));
    }
}
