package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

class BlockGridTest {
    private static final int WIDTH = 150;
    private static final int HEIGHT = 700;
    private static final int STRIDE = 160;
    private static final int OFFSET = 7;
    private static final double NOISE = 2.2;

    @Test
    void findsBlocksWhereverTheyBegin() {
        GreyImage image = image(3, 6);
        BlockGrid grid = new BlockGrid();
        grid.add(image, 5, 9, 140, 690, NOISE);
        assertTrue(grid.shows());
        assertEquals(plainExcess(image, 5, 9, 140, 690), grid.excess(), 1e-12);
    }

    @Test
    void addsUpPartsAndLeavesOutWhatLiesOutside() {
        GreyImage image = image(3, 6);
        BlockGrid grid = new BlockGrid();
        grid.add(image, -20, -20, 61, 101, NOISE);
        grid.add(image, -20, 101, 61, HEIGHT + 5, NOISE);
        grid.add(image, 61, 0, WIDTH + 30, HEIGHT + 5, NOISE);
        grid.add(image, WIDTH + 3, 0, WIDTH + 30, HEIGHT, NOISE);
        assertEquals(plainExcess(image, 0, 0, WIDTH - 1, HEIGHT - 1), grid.excess(), 1e-12);
        grid.clear();
        assertEquals(0, grid.excess());
    }

    @Test
    void findsNoneInNoise() {
        BlockGrid grid = new BlockGrid();
        grid.add(image(0, 0), 0, 0, WIDTH, HEIGHT, NOISE);
        assertFalse(grid.shows());
    }

    /** Noise on a slope, with edges in it, and blocks of another brightness each that begin there; (0, 0): none. */
    private static GreyImage image(int left, int top) {
        Random random = new Random(5);
        byte[] pixels = new byte[OFFSET + STRIDE * HEIGHT];
        int[][] levels = new int[HEIGHT / 8 + 2][STRIDE / 8 + 2];
        for (int[] row : levels) {
            for (int i = 0; i < row.length; i++) {
                row[i] = left + top == 0 ? 0 : random.nextInt(7);
            }
        }
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < STRIDE && OFFSET + y * STRIDE + x < pixels.length; x++) {
                int edge = x % 50 > 25 ? 90 : 0;
                pixels[OFFSET + y * STRIDE + x] = (byte) (60 + edge + levels[(y + 8 - top) / 8][(x + 8 - left) / 8]
                        + random.nextInt(4));
            }
        }
        return GreyImage.wrap(pixels, OFFSET, STRIDE, WIDTH, HEIGHT);
    }

    /** The excess of the differences of these pixels to those beside and below, one by one; blocks as of (3, 6). */
    private static double plainExcess(GreyImage image, int left, int top, int right, int bottom) {
        double[][] sums = new double[2][2];
        double[][] counts = new double[2][2];
        for (int y = top; y < bottom; y++) {
            for (int x = left; x < right; x++) {
                int[] differences = {Math.abs(image.get(x + 1, y) - image.get(x, y)),
                    Math.abs(image.get(x, y + 1) - image.get(x, y))};
                boolean[] across = {x % 8 == 2, y % 8 == 5};
                for (int axis = 0; axis < 2; axis++) {
                    if (differences[axis] <= 3 * NOISE) {
                        sums[axis][across[axis] ? 1 : 0] += differences[axis];
                        counts[axis][across[axis] ? 1 : 0]++;
                    }
                }
            }
        }
        double excess = 0;
        for (int axis = 0; axis < 2; axis++) {
            excess += (sums[axis][1] / counts[axis][1] / (sums[axis][0] / counts[axis][0]) - 1) / 2;
        }
        return excess;
    }
}
