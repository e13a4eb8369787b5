package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class UnsharpenedTest {
    private static final int SIZE = 48;

    /** A blurred slanted edge with noise, grey levels. */
    private static double[] edge(double dark, double bright, double noise, long seed) {
        RandomGenerator random = new Well19937c(seed);
        EdgeProfile profile = new EdgeProfile();
        double nx = Math.cos(0.3);
        double ny = Math.sin(0.3);
        profile.turn(nx, ny);
        double[] grey = new double[SIZE * SIZE];
        for (int i = 0; i < grey.length; i++) {
            profile.at((i % SIZE - SIZE / 2.0) * nx + (i / SIZE - SIZE / 2.0) * ny, 0.5);
            grey[i] = dark + (bright - dark) * profile.share + noise * random.nextGaussian();
        }
        return grey;
    }

    /** The mask by the sum over all pixels around, as its definition has it; beyond the border all is as there. */
    private static double[] sharpened(double[] grey, double amount, double radius) {
        double[] out = new double[grey.length];
        int reach = (int) Math.ceil(4 * radius);
        for (int i = 0; i < grey.length; i++) {
            double sum = 0;
            double weights = 0;
            for (int dy = -reach; dy <= reach; dy++) {
                for (int dx = -reach; dx <= reach; dx++) {
                    double w = Math.exp(-0.5 * (dx * dx + dy * dy) / (radius * radius));
                    int x = Math.max(0, Math.min(SIZE - 1, i % SIZE + dx));
                    int y = Math.max(0, Math.min(SIZE - 1, i / SIZE + dy));
                    weights += w;
                    sum += w * grey[y * SIZE + x];
                }
            }
            out[i] = grey[i] + amount * (grey[i] - sum / weights);
        }
        return out;
    }

    private static GreyImage image(double[] grey) {
        byte[] bytes = new byte[grey.length];
        for (int i = 0; i < grey.length; i++) {
            bytes[i] = (byte) Math.round(Math.max(0, Math.min(255, grey[i])));
        }
        return GreyImage.packed(bytes, SIZE, SIZE);
    }

    /** What is left is the rounding to whole levels, which undoing makes smaller: at most half a level by K's norm. */
    @ParameterizedTest
    @CsvSource({"0.3, 1", "0.6, 1", "1, 0.6", "0.6, 2"})
    void greyComesBackAsItWasBeforeTheMask(double amount, double radius) {
        double[] grey = edge(60, 190, 2, 5);
        Unsharpened levels = new Unsharpened();
        levels.undo(image(sharpened(grey, amount, radius)), 0, 0, SIZE - 1, SIZE - 1, amount, radius, 60, 190, 0.6);
        double squares = 0;
        for (int i = 0; i < grey.length; i++) {
            double off = levels.get(i % SIZE, i / SIZE) - grey[i];
            assertEquals(0, off, 0.8);
            squares += off * off / grey.length;
        }
        assertTrue(Math.sqrt(squares) < Math.sqrt(1.0 / 12), "rms " + Math.sqrt(squares));
    }

    /** Overshoot beyond white is a limit, not above the value that was there; what is beside it is right. */
    @Test
    void whatIsCutOffIsALimitAndItsNeighboursAreRight() {
        double[] grey = edge(60, 245, 0, 5);
        double[] after = sharpened(grey, 1, 1);
        Unsharpened levels = new Unsharpened();
        levels.undo(image(after), 0, 0, SIZE - 1, SIZE - 1, 1, 1, 60, 245, 0.6);
        int cut = 0;
        for (int i = 0; i < grey.length; i++) {
            double level = levels.get(i % SIZE, i / SIZE);
            double cap = levels.cap(i % SIZE, i / SIZE);
            if (after[i] >= 255.5) {
                cut++;
                assertEquals(cap, level, 1e-9);
                assertTrue(cap < grey[i] + 0.8, cap + " against " + grey[i]);
            } else {
                assertEquals(grey[i], level, 1.2);
                // half a level of rounding may put a pixel beside its limit
                assertTrue(level < cap + 1e-9 && (after[i] > 254 || cap > grey[i] - 0.8), cap + " beside " + grey[i]);
            }
        }
        assertTrue(cut > SIZE, cut + " pixels cut off");
    }

    /** Of a wide mask, which leaves hardly any frequency as it was; and of none. */
    @Test
    void logarithmOfTheGain() {
        assertEquals(Math.log(1.5), Unsharpened.meanLogGain(0.5, 20), 0.02);
        assertEquals(0, Unsharpened.meanLogGain(0, 1), 1e-12);
    }

    /** Rounded to whole grey levels in between, which is a hundredth of this noise. */
    @Test
    void undoingLeavesTheNoiseThatWasThere() {
        double[] noise = edge(128, 128, 20, 7);
        double before = correlation(undone(sharpened(noise, 0, 1), 1e-9));
        assertTrue(correlation(undone(sharpened(noise, 0.5, 1), 1e-9)) < before - 0.04, "blue after a mask");
        assertEquals(before, correlation(undone(sharpened(noise, 0.5, 1), 0.5)), 0.005);
    }

    private static double[] undone(double[] grey, double amount) {
        Unsharpened levels = new Unsharpened();
        levels.undo(image(grey), 0, 0, SIZE - 1, SIZE - 1, amount, 1, 0, 255, 0.6);
        double[] out = new double[grey.length];
        for (int i = 0; i < out.length; i++) {
            out[i] = levels.get(i % SIZE, i / SIZE) - 128;
        }
        return out;
    }

    private static double correlation(double[] noise) {
        double products = 0;
        double squares = 0;
        for (int i = 1; i < noise.length; i++) {
            products += i % SIZE == 0 ? 0 : noise[i] * noise[i - 1];
            squares += i % SIZE == 0 ? 0 : (noise[i] * noise[i] + noise[i - 1] * noise[i - 1]) / 2;
        }
        return products / squares;
    }
}
