package org.cellgauge.vision;

import java.util.Arrays;

/**
 * Takes specks out of a binary image whose contours no polygon would come from: on textured ground there are tens of
 * thousands of them, and to follow each takes as long as all the rest of finding squares.
 *
 * <p>What is left has the contours that it had. A blob of n pixels that touch each other at their sides is walked about
 * in at most 2 (n - 1) steps from pixel to pixel, as a tree of them is, which has the longest way about it. And a
 * polygon whose corners are pixels of a blob lies within the octagon about their centres. So what is taken out is below
 * the least length of a contour, or below the least area of a polygon. Pixels on their own go 64 at a time; most other
 * blobs are seen whole in a window of 8 x 8 pixels, as the bits of a number. Not thread-safe.
 */
final class Specks {
    /** Rows of a window, as many as columns: a byte each, the first one lowest. */
    static final int WINDOW = 8;
    /** Of a blob of more no octagon is asked for: most are no specks. */
    private static final int MOST_PIXELS = 80;
    private static final int FIRST_COLUMN_OF_BLOB = 3;
    private static final long FIRST_BLOB_PIXEL = 1L << FIRST_COLUMN_OF_BLOB;
    private static final long ROW = 0xFF;
    private static final long LEFT_COLUMN = 0x0101_0101_0101_0101L;
    private static final long RIGHT_COLUMN = LEFT_COLUMN << WINDOW - 1;
    /** Where a blob may go on outside of the window, to the left, to the right and below. */
    private static final long BORDER = LEFT_COLUMN | RIGHT_COLUMN | ROW << WINDOW * (WINDOW - 1);
    /** What a polygon within that border has at most, px². */
    private static final double AREA_IN_WINDOW = (WINDOW - 3) * (WINDOW - 2);

    /** Rows that the stages of taking out stars look at. */
    private static final int ROWS_KEPT = 4;
    private static final int PIXELS_OF_STAR = 5;

    private final int mostOfShort;
    private final double areaOfPolygon;
    private double leastArea;
    private final int[] found = new int[MOST_PIXELS + 5];
    private long[] words = new long[0];
    private int stride;
    /** Dark pixels with two neighbours or more, and the middles of stars, by row number modulo their count. */
    private final long[][] forked = new long[ROWS_KEPT][0];
    private final long[][] middles = new long[ROWS_KEPT][0];

    /**
     * Specks.
     *
     * @param leastContour pixels of the shortest contour that is followed
     * @param leastArea of a polygon, px²
     */
    Specks(int leastContour, double leastArea) {
        this.mostOfShort = Math.min(MOST_PIXELS, leastContour / 2);
        this.areaOfPolygon = leastArea;
        this.leastArea = leastArea;
    }

    /**
     * Says where polygons lie.
     *
     * @param inImage whether where their blobs do; else, as under a lens, nothing is known of their area
     */
    void setPolygons(boolean inImage) {
        leastArea = inImage ? areaOfPolygon : 0;
    }

    /**
     * Takes them out of a part of an image, in which all blobs lie that lie in it in part.
     *
     * @param dark the image
     * @param left of the part
     * @param top of the part
     * @param right where it ends
     * @param bottom where it ends
     */
    void takeOut(DarkBits dark, int left, int top, int right, int bottom) {
        words = dark.words();
        stride = dark.stride();
        takeOutStars(dark, left, top, right, bottom);
        for (int y = top; y < bottom; y++) {
            int end = dark.indexOf(right - 1, y);
            for (int at = dark.indexOf(left, y); at <= end; at++) {
                long here = words[at];
                if (here == 0) {
                    continue;
                }
                // dark, and neither on the left of it nor above
                long starts = here & ~(here << 1 | words[at - 1] >>> Long.SIZE - 1 | words[at - stride]);
                for (; starts != 0; starts &= starts - 1) {
                    takeOutAt(at * Long.SIZE + Long.numberOfTrailingZeros(starts));
                }
            }
        }
    }

    /**
     * Takes out what is a pixel and at most its four neighbours, in three stages that each are a row behind the one
     * before: pixels with two neighbours or more; pixels with no such neighbour, the middles of stars; these, and what
     * is beside them.
     */
    private void takeOutStars(DarkBits dark, int left, int top, int right, int bottom) {
        int first = dark.indexOf(left, top);
        int count = dark.indexOf(right - 1, top) - first + 1;
        long inFirst = -1L << left;
        long inLast = -1L >>> -right;
        shape(count);
        // most rows of most images are not dark at all
        boolean isDark = false;
        boolean wasDark = false;
        for (int y = top; y < bottom + 2; y++, first += stride) {
            boolean wasDarkBefore = wasDark;
            wasDark = isDark;
            isDark = y < bottom && isAnyDark(first, count);
            long[] of = forked[y % ROWS_KEPT];
            if (isDark) {
                findForked(first, count, of);
            } else {
                Arrays.fill(of, 0);
            }
            long[] found = middles[(y + ROWS_KEPT - 1) % ROWS_KEPT];
            if (wasDark) {
                findMiddles(first - stride, count, y, found);
                found[1] &= inFirst;
                found[count] &= inLast;
            } else {
                Arrays.fill(found, 0);
            }
            if (wasDarkBefore) {
                takeOutAbout(first - 2 * stride, count, y);
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

    private void shape(int count) {
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

    /**
     * Takes out the blob of a pixel if it is a speck. None of its pixels lies on the left or above this one; where one
     * lies further up, the blob was there when that was looked at, and stays.
     *
     * @param pixel its place in all bits
     */
    private void takeOutAt(int pixel) {
        int window = pixel - FIRST_COLUMN_OF_BLOB;
        long seen = windowAt(window);
        long blob = FIRST_BLOB_PIXEL;
        long smaller;
        do {
            smaller = blob;
            blob |= (blob << 1 & ~LEFT_COLUMN | blob >>> 1 & ~RIGHT_COLUMN | blob << WINDOW | blob >>> WINDOW) & seen;
        } while (blob != smaller);
        if ((blob & rowAt(window - stride * Long.SIZE)) != 0) {
            return;
        }
        if ((blob & BORDER) != 0) {
            followFrom(pixel);
        } else if (AREA_IN_WINDOW < leastArea || Long.bitCount(blob) <= mostOfShort) {
            takeOut(blob, window);
        }
    }

    private long windowAt(int window) {
        long seen = 0;
        int at = window >> 6;
        int shift = window & Long.SIZE - 1;
        if (shift <= Long.SIZE - WINDOW) {
            for (int row = 0; row < Long.SIZE; row += WINDOW, at += stride) {
                seen |= (words[at] >>> shift & ROW) << row;
            }
        } else {
            for (int row = 0; row < Long.SIZE; row += WINDOW, at += stride) {
                seen |= (words[at] >>> shift | words[at + 1] << -shift) << row & ROW << row;
            }
        }
        return seen;
    }

    private void takeOut(long blob, int window) {
        int at = window >> 6;
        int shift = window & Long.SIZE - 1;
        boolean whole = shift <= Long.SIZE - WINDOW;
        for (long rest = blob; rest != 0; rest >>>= WINDOW, at += stride) {
            words[at] &= ~((rest & ROW) << shift);
            if (!whole) {
                words[at + 1] &= ~((rest & ROW) >>> -shift);
            }
        }
    }

    /** Eight pixels of a row from a place on. */
    private long rowAt(int from) {
        int at = from >> 6;
        return (words[at] >>> from | words[at + 1] << 1 << Long.SIZE - 1 - (from & Long.SIZE - 1)) & ROW;
    }

    /** The same, pixel by pixel. */
    private void followFrom(int pixel) {
        int down = stride * Long.SIZE;
        int firstOfRow = pixel / down * down;
        int[] blob = found;
        blob[0] = pixel;
        int size = 1;
        take(pixel);
        boolean stays = false;
        // at most four for each, beside those that there are
        for (int next = 0; next < size && size <= MOST_PIXELS; next++) {
            int at = blob[next];
            blob[size] = at + 1;
            size += take(at + 1);
            blob[size] = at + down;
            size += take(at + down);
            blob[size] = at - 1;
            size += take(at - 1);
            blob[size] = at - down;
            size += take(at - down);
            stays |= at < firstOfRow;
        }
        if (stays || size > MOST_PIXELS || size > mostOfShort && octagon(size) >= leastArea) {
            for (int k = 0; k < size; k++) {
                words[blob[k] >> 6] |= 1L << blob[k];
            }
        }
    }

    /** Takes out a pixel; 1 if it was dark, else 0. */
    private int take(int pixel) {
        int at = pixel >> 6;
        long word = words[at];
        words[at] = word & ~(1L << pixel);
        return (int) (word >>> pixel & 1);
    }

    /** Area of the octagon about the centres of the pixels found, px². */
    private double octagon(int count) {
        int left = Integer.MAX_VALUE;
        int right = Integer.MIN_VALUE;
        int top = Integer.MAX_VALUE;
        int bottom = Integer.MIN_VALUE;
        int leastSum = Integer.MAX_VALUE;
        int mostSum = Integer.MIN_VALUE;
        int leastDifference = Integer.MAX_VALUE;
        int mostDifference = Integer.MIN_VALUE;
        int down = stride * Long.SIZE;
        for (int k = 0; k < count; k++) {
            int x = found[k] % down;
            int y = found[k] / down;
            left = Math.min(left, x);
            right = Math.max(right, x);
            top = Math.min(top, y);
            bottom = Math.max(bottom, y);
            leastSum = Math.min(leastSum, x + y);
            mostSum = Math.max(mostSum, x + y);
            leastDifference = Math.min(leastDifference, x - y);
            mostDifference = Math.max(mostDifference, x - y);
        }
        return (right - left) * (bottom - top) - triangle(leastSum - left - top) - triangle(right + bottom - mostSum)
                - triangle(leastDifference - left + bottom) - triangle(right - top - mostDifference);
    }

    private static double triangle(int side) {
        return side * side / 2.0;
    }
}
