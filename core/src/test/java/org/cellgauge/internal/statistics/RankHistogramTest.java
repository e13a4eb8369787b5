package org.cellgauge.internal.statistics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RankHistogramTest {
    @Test
    void everyBinHoldsAsManyRanks() {
        RankHistogram h = new RankHistogram(99, 20);
        for (int rank = 0; rank <= 99; rank++) {
            h.add(rank);
        }
        for (int count : h.counts()) {
            assertEquals(5, count);
        }
        assertEquals(100, h.total());
        assertEquals(5, h.expectedPerBin(), 0);
        assertEquals(0, h.chiSquare(), 0);
        assertEquals(1, h.pValue(), 0);
    }

    @Test
    void ranksFallIntoTheirBins() {
        RankHistogram h = new RankHistogram(5, 3);
        for (int rank : new int[] {0, 1, 1, 2, 5}) {
            h.add(rank);
        }
        assertArrayEquals(new int[] {3, 1, 1}, h.counts());
    }

    /** Values of scipy.stats.chisquare, SciPy 1.17.1. */
    @ParameterizedTest
    @CsvSource({"12 8 15 5, 5.8, 0.1217566197112538", "40 10 9 41, 38.48, 2.23669985548465e-08",
        "3 0 2 5 10, 14.5, 0.0058589387079510296"})
    void statisticAndProbabilityAreThoseOfSciPy(String counts, double statistic, double p) {
        String[] cells = counts.split(" ");
        RankHistogram h = new RankHistogram(cells.length - 1, cells.length);
        for (int bin = 0; bin < cells.length; bin++) {
            for (int i = 0; i < Integer.parseInt(cells[bin]); i++) {
                h.add(bin);
            }
        }
        assertEquals(statistic, h.chiSquare(), 1e-12 * statistic);
        assertEquals(p, h.pValue(), 1e-9 * p);
    }

    @Test
    void rankCountsTheDrawsBelow() {
        assertEquals(2, RankHistogram.rankOf(0.5, new double[] {1, 0.2, 0.5, -3}));
        assertEquals(0, RankHistogram.rankOf(-9, new double[] {1, 0.2}));
        assertEquals(2, RankHistogram.rankOf(9, new double[] {1, 0.2}));
        assertThrows(IllegalArgumentException.class, () -> RankHistogram.rankOf(Double.NaN, new double[] {1}));
        assertThrows(IllegalArgumentException.class, () -> RankHistogram.rankOf(0, new double[] {Double.NaN}));
    }

    @ParameterizedTest
    @CsvSource({"1.0, 0, true", "0.6, 0, false", "1.6, 0, false", "1.0, 0.4, false"})
    void calibrationTellsRightPosteriorsFromWrongOnes(double stdFactor, double bias, boolean right) {
        // Truth ~ N(0, 1), one observation with unit noise: the posterior is N(y / 2, 1 / 2)
        RandomGenerator random = new Well19937c(31);
        RankHistogram h = new RankHistogram(39, 10);
        double[] draws = new double[39];
        for (int n = 0; n < 1000; n++) {
            double truth = random.nextGaussian();
            double y = truth + random.nextGaussian();
            for (int i = 0; i < draws.length; i++) {
                draws[i] = y / 2 + bias + stdFactor * Math.sqrt(0.5) * random.nextGaussian();
            }
            h.add(RankHistogram.rankOf(truth, draws));
        }
        // A right posterior fails once in 1000 seeds; the wrong ones are many orders beyond
        assertEquals(right, h.pValue() > 1e-3, "p " + h.pValue());
        if (!right) {
            assertTrue(h.pValue() < 1e-9);
        }
    }

    @Test
    void mergedHistogramsAddUp() {
        RankHistogram a = new RankHistogram(3, 2);
        RankHistogram b = new RankHistogram(3, 2);
        a.add(0);
        b.add(3);
        b.add(2);
        a.merge(b);
        assertArrayEquals(new int[] {1, 2}, a.counts());
        assertEquals(3, a.total());
        assertEquals(2, b.total());
        assertEquals(3, a.band(0.9).trials());
        assertEquals(0.5, a.band(0.9).probability(), 0);
    }

    @Test
    void emptyHistogramHasNoProbabilityAndWrongInputIsRefused() {
        RankHistogram h = new RankHistogram(3, 2);
        assertTrue(Double.isNaN(h.chiSquare()));
        assertTrue(Double.isNaN(h.pValue()));
        assertThrows(IllegalArgumentException.class, () -> h.add(4));
        assertThrows(IllegalArgumentException.class, () -> h.add(-1));
        assertThrows(IllegalArgumentException.class, () -> h.merge(new RankHistogram(7, 2)));
        assertThrows(IllegalArgumentException.class, () -> new RankHistogram(10, 4));
        assertThrows(IllegalArgumentException.class, () -> new RankHistogram(0, 1));
        assertThrows(IllegalArgumentException.class, () -> h.band(0.9));
    }
}
