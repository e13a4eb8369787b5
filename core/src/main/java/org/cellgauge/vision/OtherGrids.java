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
    /**
     * No other grid is asked for below this deviation, as a share of the step from black to white; and for each px that
     * edges are sharper than {@link #SHARP_PX}, since the blur of reading is then no Gaussian. Drawn markers of cells
     * of 4 to 8 px leave up to 0.126 in their own grid at a blur of 0.1 px, 0.072 at 0.4 and 0.049 at 0.7, where those
     * of others leave at least 0.17, 0.12 and 0.088.
     */
    private static final double FITS = 0.06;
    private static final double FITS_PER_PX = 0.12;
    private static final double SHARP_PX = 0.6;
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
        double blurPx = marker.blurPx();
        if (misfit < FITS + FITS_PER_PX * Math.max(0, SHARP_PX - blurPx)) {
            return false;
        }
        prepare();
        double dark = marker.darkGrey();
        double bright = marker.brightGrey();
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
