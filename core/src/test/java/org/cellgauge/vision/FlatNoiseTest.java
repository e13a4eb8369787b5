package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Correlations of noise that was made with known ones; bounds are five deviations by the pairs that are counted. */
class FlatNoiseTest {
    private static final int SIDE = 200;
    /** A marker in the middle, smaller than what is kept clear of it. */
    private static final double[] CORNERS = {85, 85, 115, 85, 115, 115, 85, 115};
    private static final double FIVE = 5;
    private static final int PICTURES = 60;

    /** The plane that is taken off each tile takes 0.012 of it, for which is made up. */
    @Test
    void whiteNoiseHasNone() {
        assertMeans(new double[FlatNoise.LAGS.length], 0, 1);
    }

    @ParameterizedTest
    @CsvSource({"0.3, 1", "0.6, 1", "0.6, 0.7", "0.6, 1.5", "1, 1", "2.5, 2"})
    void aMaskMakesItBlueByItsKernel(double amount, double radius) {
        double[] direct = byKernel(amount, radius);
        double[] formula = new double[FlatNoise.LAGS.length];
        Unsharpened.noiseCorrelation(amount, radius, formula);
        assertArrayEquals(direct, formula, 1e-9);
        assertMeans(direct, amount, radius);
    }

    private static void assertMeans(double[] expected, double amount, double radius) {
        double[] means = new double[expected.length];
        double[] stds = new double[expected.length];
        for (int k = 0; k < PICTURES; k++) {
            FlatNoise noise = measured(i -> 120, masked(white(k, 1), amount, radius), 3);
            assertTrue(amount == 0 || noise.isOfAMask());
            for (int lag = 0; lag < expected.length; lag++) {
                means[lag] += noise.correlation(lag) / PICTURES;
                stds[lag] = Math.sqrt(noise.variance(lag) / PICTURES);
            }
        }
        for (int lag = 0; lag < expected.length; lag++) {
            assertEquals(expected[lag], means[lag], FIVE * stds[lag] + 5e-4, "lag " + lag);
        }
    }

    /** Light that falls off, a shelf's edge, and ground that is cut off at white take nothing from it. */
    @Test
    void slopesEdgesAndWhitesAreLeftOut() {
        double[] noise = masked(white(3, 2), 0.6, 1);
        FlatNoise plain = measured(i -> 120, noise, 2);
        FlatNoise other = measured(i -> {
            int x = i % SIDE;
            int y = i / SIDE;
            return y > 150 ? 255 : x < 60 ? 40 + 0.2 * y : 120 + 0.3 * (x + y);
        }, noise, 2);
        for (int lag = 0; lag < FlatNoise.LAGS.length; lag++) {
            assertEquals(plain.correlation(lag), other.correlation(lag), FIVE * Math.sqrt(other.variance(lag)));
        }
    }

    /** Colours interpolated from neighbours, or a texture: nothing that a mask makes. */
    @Test
    void smoothNoiseIsPositive() {
        double[] noise = white(4, 4);
        double[] smooth = new double[noise.length];
        for (int i = 0; i < smooth.length; i++) {
            smooth[i] = (noise[i] + noise[Math.max(0, i - 1)]) / 2;
        }
        // half along rows, nothing across
        assertEquals(0.25, measured(i -> 120, smooth, 2).correlation(0), 0.02);
    }

    /** Cloth: knots at every third pixel, fainter than the noise. */
    @Test
    void aPatternIsNoMask() {
        double[] noise = white(6, 2);
        for (int i = 0; i < noise.length; i++) {
            noise[i] += 2 * Math.cos(2 * Math.PI * (i % SIDE) / 3) * Math.cos(2 * Math.PI * (i / SIDE) / 3.0);
        }
        FlatNoise cloth = measured(i -> 120, noise, 2);
        assertTrue(cloth.correlation(0) < -0.05, "neighbours differ");
        assertFalse(cloth.isOfAMask());
    }

    @Test
    void tellsNothingWithoutGroundOrNoise() {
        FlatNoise none = new FlatNoise();
        none.clear();
        GreyImage still = image(i -> 120, new double[SIDE * SIDE]);
        GreyImage noisy = image(i -> 120, white(5, 2));
        assertFalse(none.measure(noisy, 1, false));
        none.add(still, CORNERS);
        assertFalse(none.measure(still, 1, false), "no noise");
        none.clear();
        none.add(noisy, CORNERS);
        assertTrue(none.measure(noisy, 1, false));
        assertTrue(none.measure(noisy, 1, true), "a few tiles");
        assertFalse(none.measure(noisy, -0.02, true), "of no interest: white");
        assertFalse(none.measure(noisy, -0.02, false), "of no interest: white");
        GreyImage cutOff = image(i -> 252, white(5, 2));
        none.clear();
        none.add(cutOff, CORNERS);
        assertFalse(none.measure(cutOff, 1, false), "cut off at white");
        none.clear();
        none.add(noisy, new double[] {10, 10, 190, 10, 190, 190, 10, 190});
        assertFalse(none.measure(noisy, 1, false), "the marker fills the picture");
    }

    /** Of noise scaled to a deviation, grey levels, which does not matter but for rounding. */
    private static FlatNoise measured(IntToDoubleFunction ground, double[] noise, double std) {
        double[] scaled = noise.clone();
        double squares = 0;
        for (double v : noise) {
            squares += v * v / noise.length;
        }
        for (int i = 0; i < scaled.length; i++) {
            scaled[i] *= std / Math.sqrt(squares);
        }
        FlatNoise measured = new FlatNoise();
        measured.clear();
        GreyImage image = image(ground, scaled);
        measured.add(image, CORNERS);
        assertTrue(measured.measure(image, 1, false));
        return measured;
    }

    private static GreyImage image(IntToDoubleFunction ground, double[] noise) {
        byte[] grey = new byte[SIDE * SIDE];
        for (int i = 0; i < grey.length; i++) {
            grey[i] = (byte) Math.round(Math.max(0, Math.min(255, ground.applyAsDouble(i) + noise[i])));
        }
        return GreyImage.packed(grey, SIDE, SIDE);
    }

    private static double[] white(long seed, double std) {
        Random random = new Random(seed);
        double[] noise = new double[SIDE * SIDE];
        for (int i = 0; i < noise.length; i++) {
            noise[i] = std * random.nextGaussian();
        }
        return noise;
    }

    private static double[][] kernel(double amount, double radius) {
        int reach = (int) Math.ceil(4 * radius);
        double[][] kernel = new double[2 * reach + 1][2 * reach + 1];
        double total = 0;
        for (int y = -reach; y <= reach; y++) {
            for (int x = -reach; x <= reach; x++) {
                total += Math.exp(-(x * x + y * y) / (2 * radius * radius));
            }
        }
        for (int y = -reach; y <= reach; y++) {
            for (int x = -reach; x <= reach; x++) {
                kernel[y + reach][x + reach] = (x == 0 && y == 0 ? 1 + amount : 0)
                        - amount * Math.exp(-(x * x + y * y) / (2 * radius * radius)) / total;
            }
        }
        return kernel;
    }

    private static double[] masked(double[] noise, double amount, double radius) {
        double[][] kernel = kernel(amount, radius);
        int reach = kernel.length / 2;
        double[] out = new double[noise.length];
        for (int y = 0; y < SIDE; y++) {
            for (int x = 0; x < SIDE; x++) {
                for (int j = -reach; j <= reach; j++) {
                    for (int i = -reach; i <= reach; i++) {
                        out[y * SIDE + x] += kernel[j + reach][i + reach]
                                * noise[Math.floorMod(y + j, SIDE) * SIDE + Math.floorMod(x + i, SIDE)];
                    }
                }
            }
        }
        return out;
    }

    /** Correlations as sums of products of the mask's kernel with itself. */
    private static double[] byKernel(double amount, double radius) {
        double[][] kernel = kernel(amount, radius);
        double[] out = new double[FlatNoise.LAGS.length];
        double squares = products(kernel, 0, 0);
        for (int lag = 0; lag < out.length; lag++) {
            out[lag] = products(kernel, FlatNoise.LAGS[lag][0], FlatNoise.LAGS[lag][1]) / squares;
        }
        return out;
    }

    private static double products(double[][] kernel, int byX, int byY) {
        double sum = 0;
        for (int y = 0; y + byY < kernel.length; y++) {
            for (int x = 0; x + byX < kernel.length; x++) {
                sum += kernel[y][x] * kernel[y + byY][x + byX];
            }
        }
        return sum;
    }
}
