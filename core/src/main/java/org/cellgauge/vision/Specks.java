package org.cellgauge.vision;

import boofcv.struct.image.GrayU8;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Takes specks out of a binary image whose contours no polygon would come from: on textured ground there are tens of
 * thousands of them, and to follow each takes as long as all the rest of finding squares.
 *
 * <p>What is left has the contours that it had. A blob of n pixels that touch each other at their sides is walked about
 * in at most 2 (n - 1) steps from pixel to pixel, as a tree of them is, which has the longest way about it. And a
 * polygon whose corners are pixels of a blob lies within the octagon about their centres. So what is taken out is below
 * the least length of a contour, or below the least area of a polygon. Not thread-safe.
 */
final class Specks {
    /** Of a blob of more no octagon is asked for: most are no specks. */
    private static final int MOST_PIXELS = 80;
    private static final long FIRST_OF_EIGHT = 0x0101_0101_0101_0101L;

    private final int mostOfShort;
    private final double areaOfPolygon;
    private double leastArea;
    private int first;
    private final int[] found = new int[MOST_PIXELS + 5];
    private byte[] pixels = new byte[0];
    private int stride;

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
     * Takes them out.
     *
     * @param binary pixels of 0 and 1, the outermost of which are set to 0
     */
    void takeOut(GrayU8 binary) {
        pixels = binary.data;
        stride = binary.stride;
        first = binary.startIndex;
        clearBorder(binary.width, binary.height);
        ByteBuffer eight = ByteBuffer.wrap(pixels).order(ByteOrder.LITTLE_ENDIAN);
        for (int y = 1; y < binary.height - 1; y++) {
            int from = first + y * stride + 1;
            int end = from + binary.width - 2;
            int at = from;
            for (; at + Long.BYTES <= end; at += Long.BYTES) {
                long here = eight.getLong(at);
                if (here == 0) {
                    continue;
                }
                // dark, and neither on the left of it nor above
                long starts = here & ~(here << Byte.SIZE | pixels[at - 1]) & ~eight.getLong(at - stride)
                        & FIRST_OF_EIGHT;
                for (; starts != 0; starts &= starts - 1) {
                    takeOutAt(at + (Long.numberOfTrailingZeros(starts) >> 3));
                }
            }
            for (; at < end; at++) {
                if (pixels[at] != 0 && pixels[at - 1] == 0 && pixels[at - stride] == 0) {
                    takeOutAt(at);
                }
            }
        }
    }

    private void clearBorder(int width, int height) {
        for (int x = 0; x < width; x++) {
            pixels[first + x] = 0;
            pixels[first + (height - 1) * stride + x] = 0;
        }
        for (int y = 0; y < height; y++) {
            pixels[first + y * stride] = 0;
            pixels[first + y * stride + width - 1] = 0;
        }
    }

    /** Takes out the blob of a pixel if it is a speck; no other of its pixels lies on the left or above this one. */
    private void takeOutAt(int pixel) {
        byte[] dark = pixels;
        int down = stride;
        if ((dark[pixel + 1] | dark[pixel + down]) == 0) {
            // a pixel on its own, as a third of them are
            dark[pixel] = 0;
            return;
        }
        int[] blob = found;
        dark[pixel] = 0;
        blob[0] = pixel;
        int size = 1;
        // at most four for each, beside those that there are
        for (int next = 0; next < size && size <= MOST_PIXELS; next++) {
            int at = blob[next];
            int right = dark[at + 1];
            dark[at + 1] = 0;
            blob[size] = at + 1;
            size += right;
            int below = dark[at + down];
            dark[at + down] = 0;
            blob[size] = at + down;
            size += below;
            int left = dark[at - 1];
            dark[at - 1] = 0;
            blob[size] = at - 1;
            size += left;
            int above = dark[at - down];
            dark[at - down] = 0;
            blob[size] = at - down;
            size += above;
        }
        if (size > MOST_PIXELS || size > mostOfShort && octagon(size) >= leastArea) {
            for (int k = 0; k < size; k++) {
                dark[blob[k]] = 1;
            }
        }
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
        for (int k = 0; k < count; k++) {
            int x = (found[k] - first) % stride;
            int y = (found[k] - first) / stride;
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
