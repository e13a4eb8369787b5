package org.cellgauge.vision;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.geometry.PinholeCamera;

/**
 * Tells a marker from one of another grid that can be read as if it were one.
 *
 * <p>Middles of cells alone do not: every 3x3 square-binary marker reads as some 4x4 one. So where the light between
 * the middles is not what the reading makes of it ({@link PatternReader#misfit}), the square is read in each other
 * lattice that markers have, and the one that explains it much better is its own. Not thread-safe.
 */
final class OtherGrids {
    /** No other grid is asked for below this deviation, as a share of the step from black to white. */
    private static final double FITS = 0.06;
    /** A grid explains a square better where it leaves less than this share of the deviation. */
    private static final double BETTER = 0.5;
    /** A grid is not looked at closely where its middles alone leave so many times that deviation. */
    private static final double ROUGHLY = 1.5;
    private static final int SMALLEST = 3;
    private static final int LARGEST = 8;

    private final PinholeCamera camera;
    private final MarkerGrid own;
    private final List<MarkerGrid> grids = new ArrayList<>();
    private final List<PatternReader> readers = new ArrayList<>();

    OtherGrids(PinholeCamera camera, MarkerGrid own) {
        this.camera = camera;
        this.own = own;
    }

    /**
     * Whether another grid explains a square much better.
     *
     * @param misfit what is left in its own, see {@link PatternReader#misfit}
     * @param image the image
     * @param cornersPx corners of the square
     * @param scale tone curve
     * @param marker its fitted sides
     * @return false where nothing better is known
     */
    boolean explainBetter(double misfit, GreyImage image, double[] cornersPx, GreyScale scale, MarkerEdges marker) {
        if (misfit < FITS) {
            return false;
        }
        prepare();
        double dark = marker.darkGrey();
        double bright = marker.brightGrey();
        double blurPx = marker.blurPx();
        double enough = BETTER * misfit;
        double roughly = ROUGHLY * enough;
        for (int i = 0; i < grids.size(); i++) {
            boolean[] white = new boolean[grids.get(i).bands() * grids.get(i).bands()];
            PatternReader reader = readers.get(i);
            // nearly all of them do not do so by far
            if (reader.readRoughly(image, cornersPx, scale, dark, bright, blurPx, white)
                    && reader.misfit(image, scale, dark, bright, white, roughly) < roughly
                    && reader.readAnew(image, cornersPx, scale, dark, bright, blurPx, white)
                    && reader.misfit(image, scale, dark, bright, white, enough) < enough) {
                return true;
            }
        }
        return false;
    }

    /** The lattices of square-binary grids, and of codes in a border of one cell. */
    private void prepare() {
        if (!grids.isEmpty()) {
            return;
        }
        for (int codeCells = SMALLEST; codeCells <= LARGEST; codeCells++) {
            for (int borderHalfCells : new int[] {codeCells, 2}) {
                MarkerGrid grid = MarkerGrid.of(codeCells, borderHalfCells);
                if (grid.bands() != own.bands() || grid.borderBands() != own.borderBands()) {
                    grids.add(grid);
                    readers.add(new PatternReader(camera, grid));
                }
            }
        }
    }
}
