package org.cellgauge.internal.statistics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.util.CombinatoricsUtils;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class BinomialBandTest {
    /** Ends and coverage from the probabilities of scipy.stats.binom, SciPy 1.17.1. */
    @ParameterizedTest
    @CsvSource({"100, 0.95, 0.99, 89, 100, 0.9957258175336338", "1000, 0.95, 0.95, 936, 963, 0.9580952682226538",
        "20, 0.5, 0.9, 6, 14, 0.9586105346679689", "400, 0.68, 0.999, 241, 302, 0.9991346823865696",
        "10, 0.01, 0.9, 0, 1, 0.995733799757168"})
    void bandIsThatOfSciPy(int n, double p, double confidence, int lower, int upper, double coverage) {
        BinomialBand band = BinomialBand.of(n, p, confidence);
        assertEquals(lower, band.lower());
        assertEquals(upper, band.upper());
        assertEquals(coverage, band.coverage(), 1e-12);
        assertTrue(band.contains(lower) && band.contains(upper));
        assertFalse(band.contains(lower - 1) || band.contains(upper + 1));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.02, 0.3, 0.5, 0.81, 0.97})
    void tailsOutsideHoldAtMostHalfEachAndNoNarrowerBandDoes(double p) {
        int n = 40;
        double confidence = 0.9;
        double[] probability = new double[n + 1];
        for (int k = 0; k <= n; k++) {
            probability[k] = CombinatoricsUtils.binomialCoefficientDouble(n, k) * Math.pow(p, k)
                    * Math.pow(1 - p, n - k);
        }
        BinomialBand band = BinomialBand.of(n, p, confidence);
        assertTrue(sum(probability, 0, band.lower() - 1) <= 0.05);
        assertTrue(sum(probability, 0, band.lower()) > 0.05);
        assertTrue(sum(probability, band.upper() + 1, n) <= 0.05);
        assertTrue(sum(probability, band.upper(), n) > 0.05);
        assertEquals(sum(probability, band.lower(), band.upper()), band.coverage(), 1e-12);
        assertTrue(band.coverage() >= confidence);
    }

    @Test
    void certainTrialsHaveOneCount() {
        BinomialBand never = BinomialBand.of(5, 0, 0.95);
        BinomialBand always = BinomialBand.of(5, 1, 0.95);
        assertEquals(0, never.lower());
        assertEquals(0, never.upper());
        assertEquals(1, never.coverage(), 0);
        assertEquals(5, always.lower());
        assertEquals(5, always.upper());
        assertEquals(1, always.coverage(), 0);
    }

    /** Values of scipy.stats.binomtest(k, n).proportion_ci(c, 'exact'), SciPy 1.17.1. */
    @ParameterizedTest
    @CsvSource({"0, 10, 0.95, 0, 0.30849710781876294", "10, 10, 0.95, 0.6915028921812371, 1",
        "7, 20, 0.95, 0.1539092047845412, 0.5921885345328283", "190, 200, 0.99, 0.8960378442460285, 0.9811645116951897",
        "1, 1, 0.9, 0.05, 1"})
    void clopperPearsonIsThatOfSciPy(int k, int n, double confidence, double lower, double upper) {
        assertArrayEquals(new double[] {lower, upper}, BinomialBand.clopperPearson(k, n, confidence), 1e-10);
    }

    @Test
    void claimIsInsideItsIntervalExactlyWhenTheCountIsInsideItsBand() {
        int n = 60;
        for (double p : new double[] {0.1, 0.37, 0.5, 0.9}) {
            BinomialBand band = BinomialBand.of(n, p, 0.95);
            for (int k = 0; k <= n; k++) {
                double[] interval = BinomialBand.clopperPearson(k, n, 0.95);
                assertEquals(band.contains(k), p >= interval[0] && p <= interval[1], p + " " + k);
            }
        }
    }

    @Test
    void impossibleInputIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> BinomialBand.of(0, 0.5, 0.9));
        assertThrows(IllegalArgumentException.class, () -> BinomialBand.of(1, 1.1, 0.9));
        assertThrows(IllegalArgumentException.class, () -> BinomialBand.of(1, Double.NaN, 0.9));
        assertThrows(IllegalArgumentException.class, () -> BinomialBand.of(1, 0.5, 1));
        assertThrows(IllegalArgumentException.class, () -> BinomialBand.clopperPearson(3, 2, 0.9));
        assertThrows(IllegalArgumentException.class, () -> BinomialBand.clopperPearson(-1, 2, 0.9));
        assertThrows(IllegalArgumentException.class, () -> BinomialBand.clopperPearson(1, 2, 0));
    }

    private static double sum(double[] values, int from, int to) {
        double sum = 0;
        for (int i = from; i <= to; i++) {
            sum += values[i];
        }
        return sum;
    }
}
