package org.cellgauge.vision;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Takes specks out of a binary image whose contours no polygon would come from: on textured ground there are tens of
 * thousands of them, and to follow each takes as long as all the rest of finding squares.
 *
 * <p>What is left has the contours that it had. A blob of n pixels that touch each other at their sides is walked about
 * in at most 2 (n - 1) steps from pixel to pixel, as a tree of them is, which has the longest way about it. And a
 * polygon whose corners are pixels of a blob lies within the octagon about their centres. So what is taken out is below
 * the least length of a contour, or below the least area of a polygon. {@link Stars} go first, many at a time; most
 * other blobs are seen whole in a window of 8 x 8 pixels, as the bits of a number.
 *
 * <p>Bands of rows may be gone through at a time: whether a blob goes hangs on that blob alone, so the same are left.
 * Else not thread-safe.
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

    /** Of a shorter one not all stars may go. */
    private static final int LEAST_CONTOUR = 2 * Stars.MOST_PIXELS;

    private final int mostOfShort;
    private final double areaOfPolygon;
    private double leastArea;
    private final List<Band> bands = new ArrayList<>();
    private int[] rows = {0, 0};

    /**
     * Specks.
     *
     * @param leastContour pixels of the shortest contour that is followed, at least {@value #LEAST_CONTOUR}
     * @param leastArea of a polygon, px²
     * @throws IllegalArgumentException where shorter contours are followed
     */
    Specks(int leastContour, double leastArea) {
        if (leastContour < LEAST_CONTOUR) {
            throw new IllegalArgumentException("contours of " + leastContour + " pixels");
        }
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
     * Begins to take them out of a part of an image, in which all blobs lie that lie in it in part.
     *
     * @param dark the image, which is not read yet
     * @param left of the part
     * @param right where it ends
     * @param ofBands rows at which bands begin, {@value #WINDOW} or more from one to the next, and where the last ends
     */
    void begin(DarkBits dark, int left, int right, int[] ofBands) {
        rows = ofBands;
        while (bands.size() < rows.length - 1) {
            bands.add(new Band());
        }
        for (Band band : bands) {
            band.begin(dark, left, right);
        }
    }

    /** Takes out those of a band that lie in it as a whole. All of it is marked; others may be marked meanwhile. */
    void takeOut(int band) {
        bands.get(band).takeOut(rows[band], rows[band + 1], band == 0, band == rows.length - 2);
    }

    /** Takes out those across the borders of bands, when all these are done. */
    void end() {
        Band any = bands.get(0);
        for (int i = 1; i < rows.length - 1; i++) {
            any.takeOutAbout(rows[i], rows[rows.length - 1]);
        }
        for (Band band : bands) {
            any.takeOutLeft(band);
        }
    }

    /** What a thread needs to go through a band. */
    private final class Band {
        private final Stars stars = new Stars();
        private final int[] found = new int[MOST_PIXELS + 5];
        private DarkBits dark = new DarkBits();
        private long[] words = new long[0];
        private int stride;
        private int left;
        private int right;
        /** Pixels from and to which this band is looked at. */
        private int first;
        private int end;
        /** Where blobs begin that go on in other bands. */
        private int[] acrossBands = new int[16];
        private int acrossCount;

        void begin(DarkBits in, int fromLeft, int toRight) {
            dark = in;
            words = in.words();
            stride = in.stride();
            left = fromLeft;
            right = toRight;
            acrossCount = 0;
        }

        void takeOut(int top, int bottom, boolean isFirst, boolean isLast) {
            int looked = isFirst ? top : top + 1;
            int lookedTo = isLast ? bottom : bottom - 1;
            stars.takeOut(dark, left, isFirst ? top : top + Stars.REACH, right,
                    isLast ? bottom : bottom - Stars.REACH, looked, lookedTo);
            // a row further there may be others' pixels
            first = isFirst ? 0 : pixelAt(looked);
            end = isLast ? Integer.MAX_VALUE : pixelAt(lookedTo);
            takeOutFrom(looked, isLast ? bottom : bottom - WINDOW + 1);
        }

        /** What lies across a border of bands, but for what {@link #takeOutLeft} is for. */
        void takeOutAbout(int border, int bottom) {
            int reach = Stars.REACH;
            stars.takeOut(dark, left, border - reach, right, Math.min(bottom, border + reach), border - reach - 1,
                    Math.min(bottom, border + reach + 1));
            first = 0;
            end = Integer.MAX_VALUE;
            takeOutFrom(border - WINDOW + 1, border + 1);
        }

        void takeOutLeft(Band of) {
            first = 0;
            end = Integer.MAX_VALUE;
            for (int i = 0; i < of.acrossCount; i++) {
                int pixel = of.acrossBands[i];
                if ((words[pixel >> 6] >>> pixel & 1) != 0) {
                    takeOutAt(pixel);
                }
            }
        }

        private int pixelAt(int y) {
            return dark.indexOf(0, y) / stride * stride * Long.SIZE;
        }

        private void takeOutFrom(int top, int bottom) {
            for (int y = top; y < bottom; y++) {
                int last = dark.indexOf(right - 1, y);
                for (int at = dark.indexOf(left, y); at <= last; at++) {
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
         * Takes out the blob of a pixel if it is a speck. None of its pixels lies on the left or above this one; where
         * one lies further up, the blob was there when that was looked at, and stays.
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
                long beside = blob << 1 & ~LEFT_COLUMN | blob >>> 1 & ~RIGHT_COLUMN;
                blob |= (beside | blob << WINDOW | blob >>> WINDOW) & seen;
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
                if (at < first || at >= end) {
                    leave(pixel);
                    stays = true;
                    break;
                }
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

        private void leave(int pixel) {
            if (acrossCount == acrossBands.length) {
                acrossBands = Arrays.copyOf(acrossBands, 2 * acrossCount);
            }
            acrossBands[acrossCount++] = pixel;
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
            return (right - left) * (bottom - top) - triangle(leastSum - left - top)
                    - triangle(right + bottom - mostSum) - triangle(leastDifference - left + bottom)
                    - triangle(right - top - mostDifference);
        }
    }

    private static double triangle(int side) {
        return side * side / 2.0;
    }
}
