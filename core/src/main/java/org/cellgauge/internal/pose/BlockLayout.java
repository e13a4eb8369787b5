package org.cellgauge.internal.pose;

import java.util.Arrays;

/**
 * How the image coordinates of bodies lie in plain arrays; immutable.
 *
 * <p>A block is what all views show of one body: its errors of placement are the same in all of them, so that its
 * coordinates have one joint covariance, and blocks are independent of each other. Coordinates of a block are ordered
 * by view, then point, then u and v; those of all blocks stand one after another, and so do their square matrices, row
 * by row. A marker in one view is a block of four points, eight coordinates and 64 entries.
 */
public final class BlockLayout {
    private final int views;
    private final int[][] seenIn;
    private final int[] firstPoint;
    private final int[] firstRow;
    private final int[] firstEntry;

    private BlockLayout(int views, int[] points, int[][] seenIn) {
        int n = points.length;
        this.views = views;
        this.seenIn = seenIn;
        firstPoint = new int[n + 1];
        firstRow = new int[n + 1];
        firstEntry = new int[n + 1];
        for (int b = 0; b < n; b++) {
            int rows = 2 * points[b] * seenIn[b].length;
            firstPoint[b + 1] = firstPoint[b] + points[b];
            firstRow[b + 1] = firstRow[b] + rows;
            firstEntry[b + 1] = firstEntry[b] + rows * rows;
        }
    }

    /**
     * Markers in one view.
     *
     * @param markers number of markers, each of four points
     * @return the layout
     */
    public static BlockLayout ofMarkers(int markers) {
        int[] points = new int[markers];
        int[][] seenIn = new int[markers][];
        Arrays.fill(points, 4);
        Arrays.fill(seenIn, new int[1]);
        return new BlockLayout(1, points, seenIn);
    }

    /**
     * Bodies in several views.
     *
     * @param views number of views, at least 1
     * @param points number of points of each body
     * @param seenIn for each body the views that show all its points, ascending, at least one; copied
     * @return the layout
     * @throws IllegalArgumentException if a body is seen nowhere, or in a view that there is not
     */
    public static BlockLayout of(int views, int[] points, int[][] seenIn) {
        int[][] copy = new int[seenIn.length][];
        for (int b = 0; b < seenIn.length; b++) {
            copy[b] = seenIn[b].clone();
            for (int i = 0; i < copy[b].length; i++) {
                if (copy[b][i] <= (i == 0 ? -1 : copy[b][i - 1]) || copy[b][i] >= views) {
                    throw new IllegalArgumentException("views must ascend below " + views + ", not "
                            + Arrays.toString(copy[b]));
                }
            }
            if (copy[b].length == 0) {
                throw new IllegalArgumentException("body " + b + " is seen in no view");
            }
        }
        return new BlockLayout(views, points, copy);
    }

    /**
     * Number of views.
     *
     * @return at least 1
     */
    public int views() {
        return views;
    }

    /**
     * Number of blocks.
     *
     * @return one per body
     */
    public int blocks() {
        return seenIn.length;
    }

    /**
     * Number of points of a body.
     *
     * @param block index of the block
     * @return at least 1
     */
    public int points(int block) {
        return firstPoint[block + 1] - firstPoint[block];
    }

    /**
     * Where the points of a body begin.
     *
     * @param block index of the block, or the number of blocks for the end
     * @return index of its first point; that of its x is three times that
     */
    public int firstPoint(int block) {
        return firstPoint[block];
    }

    /**
     * Number of views that show a body.
     *
     * @param block index of the block
     * @return at least 1
     */
    public int timesSeen(int block) {
        return seenIn[block].length;
    }

    /**
     * One of the views that show a body.
     *
     * @param block index of the block
     * @param time 0 to timesSeen - 1
     * @return index of the view
     */
    public int view(int block, int time) {
        return seenIn[block][time];
    }

    /**
     * Number of image coordinates of a block.
     *
     * @param block index of the block
     * @return two per point and view that shows it
     */
    public int rows(int block) {
        return firstRow[block + 1] - firstRow[block];
    }

    /**
     * Where the image coordinates of a block begin.
     *
     * @param block index of the block, or the number of blocks for the end
     * @return index of the first
     */
    public int firstRow(int block) {
        return firstRow[block];
    }

    /**
     * Where the square matrix of a block begins.
     *
     * @param block index of the block, or the number of blocks for the end
     * @return index of its first entry
     */
    public int firstEntry(int block) {
        return firstEntry[block];
    }

    /**
     * Number of image coordinates of the largest block.
     *
     * @return 0 without blocks
     */
    public int mostRows() {
        int most = 0;
        for (int b = 0; b < blocks(); b++) {
            most = Math.max(most, rows(b));
        }
        return most;
    }

    /**
     * Whether this is nothing but markers in one view.
     *
     * @return true if every block has four points and is seen once
     */
    public boolean isMarkers() {
        for (int b = 0; b < blocks(); b++) {
            if (views != 1 || points(b) != 4) {
                return false;
            }
        }
        return true;
    }
}
