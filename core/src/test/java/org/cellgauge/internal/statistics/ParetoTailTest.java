package org.cellgauge.internal.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.function.DoubleSupplier;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.statistics.ChainDiagnostics;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ParetoTailTest {
    private static double[] sorted(int n, DoubleSupplier draw) {
        double[] x = new double[n];
        for (int i = 0; i < n; i++) {
            x[i] = draw.getAsDouble();
        }
        Arrays.sort(x);
        return x;
    }

    private static double student(int degrees, RandomGenerator random) {
        double chi = 0;
        for (int i = 0; i < degrees; i++) {
            double g = random.nextGaussian();
            chi += g * g;
        }
        return random.nextGaussian() / Math.sqrt(chi / degrees);
    }

    /** Quantiles of a generalised Pareto distribution by inversion: the fit must find the shape they are drawn with. */
    @ParameterizedTest
    @ValueSource(doubles = {-0.4, -0.1, 0.1, 0.25, 0.5, 0.9})
    void shapeOfGeneralisedParetoDraws(double k) {
        RandomGenerator random = RandomStreams.of(91, Double.doubleToLongBits(k));
        int repeats = 50;
        int n = 400;
        double mean = 0;
        for (int r = 0; r < repeats; r++) {
            mean += ParetoTail.shape(sorted(n, () -> 7 * (Math.pow(1 - random.nextDouble(), -k) - 1) / k)) / repeats;
        }
        // a shape of n draws is good to (1 + k) / sqrt(n); the estimator's own bias is below a tenth of k + 0.1
        assertEquals(k, mean, 4 * (1 + Math.abs(k)) / Math.sqrt(n * (double) repeats) + 0.02);
    }

    /**
     * The heavier tail of t-distributed draws has k = 1/nu, approached from below; the larger of two tails from above.
     */
    @ParameterizedTest
    @CsvSource({"1, 1.0", "2, 0.5", "3, 0.333", "4, 0.25"})
    void tailsOfStudentsDrawsAreThoseOfTheirDegreesOfFreedom(int degrees, double k) {
        RandomGenerator random = RandomStreams.of(92, degrees);
        double mean = 0;
        int repeats = 20;
        for (int r = 0; r < repeats; r++) {
            mean += ParetoTail.k(sorted(20_000, () -> student(degrees, random)), 1) / repeats;
        }
        assertEquals(k, mean, 0.1);
    }

    @Test
    void normalDrawsHaveLightTailsAndStudentsWithThreeDegreesDoNot() {
        RandomGenerator random = RandomStreams.of(93);
        int heavy = 0;
        for (int r = 0; r < 100; r++) {
            double k = ParetoTail.k(sorted(8000, random::nextGaussian), 1);
            assertTrue(k < ParetoTail.LARGEST_FOR_STD, "normal draws: " + k);
            heavy += ParetoTail.k(sorted(8000, () -> student(3, random)), 1) > ParetoTail.LARGEST_FOR_STD ? 1 : 0;
        }
        assertTrue(heavy >= 90, heavy + " of 100 samples of t with 3 degrees of freedom");
    }

    /** What the threshold is about: how far standard deviations scatter against the error computed from their draws. */
    @ParameterizedTest
    @CsvSource({"3, 1.5, 1000", "12, 0, 1.25"})
    void errorsOfDeviationsAreWhatIsStatedBelowTheThresholdAndNotAbove(int degrees, double least, double most) {
        RandomGenerator random = RandomStreams.of(94, degrees);
        double truth = Math.sqrt(degrees / (degrees - 2.0));
        int repeats = 200;
        double squares = 0;
        for (int r = 0; r < repeats; r++) {
            double[][] chains = new double[4][500];
            for (double[] chain : chains) {
                for (int i = 0; i < chain.length; i++) {
                    chain[i] = student(degrees, random);
                }
            }
            ChainDiagnostics d = ChainDiagnostics.of(chains);
            squares += Math.pow((d.std() - truth) / d.mcseSd(), 2) / repeats;
        }
        double rms = Math.sqrt(squares);
        assertTrue(rms > least && rms < most, "errors over stated errors: " + rms);
    }

    @Test
    void tooFewOrEqualDrawsHaveNone() {
        assertTrue(Double.isNaN(ParetoTail.k(new double[] {1, 2, 3, 4, 5, 6, 7, 8}, 1)));
        assertTrue(Double.isNaN(ParetoTail.k(new double[1000], 1)));
    }
}
