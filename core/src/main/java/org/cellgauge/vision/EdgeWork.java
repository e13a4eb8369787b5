package org.cellgauge.vision;

import java.util.ArrayDeque;

/**
 * Work space for the pixels beside one side of a marker: some hundred kilobytes where markers are large, so that
 * markers share it. Nothing in it outlives the side it was used for.
 */
final class EdgeWork {
    final BandPixels band = new BandPixels();
    final PatternLight pattern;
    final PaperEdge paper = new PaperEdge();

    // of each pixel of the band
    double[] depths = new double[0];
    double[] shares = new double[0];
    double[] ofBlur = new double[0];
    double[] asked = new double[0];
    int[] places = new int[0];

    // of each pixel about the inner edge of the border
    double[] lights = new double[0];
    double[] greys = new double[0];
    double[] byLights = new double[0];
    double[] insides = new double[0];
    double[] outlineShares = new double[0];
    double[] outlineByDistance = new double[0];
    double[] outlineByBlur = new double[0];

    private EdgeWork(MarkerGrid grid) {
        this.pattern = new PatternLight(grid);
    }

    /** Makes room for what is known of so many pixels of the band. */
    void reserve(int count) {
        if (shares.length < count) {
            int length = count + count / 4 + 64;
            depths = new double[length];
            shares = new double[length];
            ofBlur = new double[length];
            asked = new double[length];
            places = new int[length];
        }
    }

    /** The same for pixels about the inner edge. */
    void reserveInner(int count) {
        reserve(count);
        if (lights.length < count) {
            int length = count + count / 4 + 64;
            lights = new double[length];
            greys = new double[length];
            byLights = new double[length];
            insides = new double[length];
            outlineShares = new double[length];
            outlineByDistance = new double[length];
            outlineByBlur = new double[length];
        }
    }

    /** As many of them as markers are fitted at once. Safe for threads. */
    static final class Pool {
        private final MarkerGrid grid;
        private final ArrayDeque<EdgeWork> free = new ArrayDeque<>();

        /**
         * For markers of one family.
         *
         * @param grid lattice of its markers
         */
        Pool(MarkerGrid grid) {
            this.grid = grid;
        }

        /** One that nobody else has until it is given back. */
        synchronized EdgeWork take() {
            EdgeWork work = free.pollLast();
            return work != null ? work : new EdgeWork(grid);
        }

        /** Gives it back. */
        synchronized void giveBack(EdgeWork work) {
            free.addLast(work);
        }
    }
}
