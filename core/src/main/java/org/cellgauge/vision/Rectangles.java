package org.cellgauge.vision;

import java.util.Arrays;

/** Parts of an image that do not touch each other. Not thread-safe. */
final class Rectangles {
    private static final int SIDES = 4;

    /** Left, top, right and bottom of each, px, the last two not with it. */
    private int[] bounds = new int[8 * SIDES];
    private int count;

    /** Takes all away. */
    void clear() {
        count = 0;
    }

    /** Adds one, as one with all that it touches: what is dark in both is followed from one into the other. */
    void add(int left, int top, int right, int bottom) {
        if (left >= right || top >= bottom) {
            return;
        }
        for (int i = 0; i < count; i++) {
            if (left <= right(i) && left(i) <= right && top <= bottom(i) && top(i) <= bottom) {
                int unitedLeft = Math.min(left, left(i));
                int unitedTop = Math.min(top, top(i));
                int unitedRight = Math.max(right, right(i));
                int unitedBottom = Math.max(bottom, bottom(i));
                count--;
                System.arraycopy(bounds, SIDES * count, bounds, SIDES * i, SIDES);
                // the larger one may touch others
                add(unitedLeft, unitedTop, unitedRight, unitedBottom);
                return;
            }
        }
        if (SIDES * count == bounds.length) {
            bounds = Arrays.copyOf(bounds, 2 * bounds.length);
        }
        bounds[SIDES * count] = left;
        bounds[SIDES * count + 1] = top;
        bounds[SIDES * count + 2] = right;
        bounds[SIDES * count + 3] = bottom;
        count++;
    }

    /** How many there are. */
    int count() {
        return count;
    }

    /** First column, px. */
    int left(int number) {
        return bounds[SIDES * number];
    }

    /** First row, px. */
    int top(int number) {
        return bounds[SIDES * number + 1];
    }

    /** Column after the last, px. */
    int right(int number) {
        return bounds[SIDES * number + 2];
    }

    /** Row after the last, px. */
    int bottom(int number) {
        return bounds[SIDES * number + 3];
    }
}
