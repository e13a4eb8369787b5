package org.cellgauge.vision;

import java.util.Arrays;

/**
 * Takes out of a binary image what is a pixel and at most its four neighbours, 64 pixels at a time, in three stages
 * that each are a row behind the one before: dark pixels with two dark neighbours or more; those with no such
 * neighbour, the middles of stars; these, and what is beside them. Not thread-safe.
 */
final class Stars {
    /** Pixels of the largest. */
    static final int MOST_PIXELS = 5;
    /** Rows on each side of a middle that tell that it is one. */
    static final int REACH = 2;
    private static final int ROWS_KEPT = 4;

    /** By row number modulo their count, with a number on each side. */
    private final long[][] forked = new long[ROWS_KEPT][0];
    private final long[][] middles = new long[ROWS_KEPT][0];
    private long[] words = new long[0];
    private int stride;

    /**
     * Takes out the stars whose middles lie in a part of an image. No pixel outside of its columns is beside a dark one
     * in them, and two rows on each side of it are looked at, within other limits.
     *
     * @param dark the image
     * @param left of the part
     * @param top of the part
     * @param right where it ends
     * @param bottom where it ends
     * @param first row from which on pixels may have dark ones below and above them
     * @param end row from which on they may not
     */
    void takeOut(DarkBits dark, int left, int top, int right, int bottom, int first, int end) {
        words = dark.words();
        stride = dark.stride();
        int at = dark.indexOf(left, first);
        int count = dark.indexOf(right - 1, first) - at + 1;
        long inFirst = -1L << left;
        long inLast = -1L >>> -right;
        clear(count);
        // most rows of most images are not dark at all
        boolean isDark = false;
        boolean wasDark = false;
        for (int y = first; y < end + 2; y++, at += stride) {
            boolean wasDarkBefore = wasDark;
            wasDark = isDark;
            isDark = y < end && isAnyDark(at, count);
            long[] of = forked[y % ROWS_KEPT];
            if (isDark) {
                findForked(at, count, of);
            } else {
                Arrays.fill(of, 0);
            }
            long[] found = middles[(y + ROWS_KEPT - 1) % ROWS_KEPT];
            if (wasDark && y > top && y <= bottom) {
                findMiddles(at - stride, count, y, found);
                found[1] &= inFirst;
                found[count] &= inLast;
            } else {
                Arrays.fill(found, 0);
            }
            if (wasDarkBefore) {
                takeOutAbout(at - 2 * stride, count, y);
            }
        }
    }

    private boolean isAnyDark(int first, int count) {
        long any = 0;
        for (int i = first; i < first + count; i++) {
            any |= words[i];
        }
        return any != 0;
    }

    private void clear(int count) {
        for (int row = 0; row < ROWS_KEPT; row++) {
            if (forked[row].length < count + 2) {
                forked[row] = new long[count + 2];
                middles[row] = new long[count + 2];
            }
            Arrays.fill(forked[row], 0);
            Arrays.fill(middles[row], 0);
        }
    }

    /** Those of a row's dark pixels with two neighbours or more. */
    private void findForked(int first, int count, long[] found) {
        long[] of = words;
        int down = stride;
        for (int i = 0; i < count; i++) {
            long here = of[first + i];
            long before = here << 1 | of[first + i - 1] >>> Long.SIZE - 1;
            long after = here >>> 1 | of[first + i + 1] << Long.SIZE - 1;
            long above = of[first + i - down];
            long below = of[first + i + down];
            found[i + 1] = here & (before & after | above & below | (before | after) & (above | below));
        }
    }

    /** Those of a row's dark pixels with no such neighbour. */
    private void findMiddles(int first, int count, int next, long[] found) {
        long[] of = words;
        long[] above = forked[(next + ROWS_KEPT - 2) % ROWS_KEPT];
        long[] here = forked[(next + ROWS_KEPT - 1) % ROWS_KEPT];
        long[] below = forked[next % ROWS_KEPT];
        for (int i = 0; i < count; i++) {
            long beside = here[i + 1] << 1 | here[i] >>> Long.SIZE - 1 | here[i + 1] >>> 1
                    | here[i + 2] << Long.SIZE - 1;
            found[i + 1] = of[first + i] & ~(beside | above[i + 1] | below[i + 1]);
        }
    }

    /** Takes out those of a row's pixels that are such, or have such a neighbour. */
    private void takeOutAbout(int first, int count, int next) {
        long[] of = words;
        long[] above = middles[(next + ROWS_KEPT - 3) % ROWS_KEPT];
        long[] here = middles[(next + ROWS_KEPT - 2) % ROWS_KEPT];
        long[] below = middles[(next + ROWS_KEPT - 1) % ROWS_KEPT];
        for (int i = 0; i < count; i++) {
            long about = here[i + 1] | here[i + 1] << 1 | here[i] >>> Long.SIZE - 1 | here[i + 1] >>> 1
                    | here[i + 2] << Long.SIZE - 1 | above[i + 1] | below[i + 1];
            of[first + i] &= ~about;
        }
    }
}
