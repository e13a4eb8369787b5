package org.cellgauge.vision;

import boofcv.alg.drawing.FiducialImageEngine;
import boofcv.alg.fiducial.square.FiducialSquareGenerator;
import boofcv.alg.fiducial.square.FiducialSquareHammingGenerator;
import boofcv.factory.fiducial.ConfigHammingMarker;
import boofcv.factory.fiducial.HammingDictionary;
import org.cellgauge.cell.MarkerFamily;

/**
 * The black and white cells of a family's markers, border included, marker upright: read off the pictures that BoofCV's
 * own generators draw, so that a marker here is what a user of BoofCV prints. Every family is a square lattice of equal
 * cells, a border of black ones around the code.
 */
public final class FamilyPatterns {
    private static final int PIXELS_PER_CELL = 4;
    /** BoofCV's default border of square-binary markers is a quarter of the width: two of eight cells. */
    private static final int BINARY_CELLS = 8;
    private static final int BINARY_CODE_CELLS = 4;

    private final MarkerFamily family;
    private final ConfigHammingMarker dictionary;
    private final int cells;

    /**
     * Patterns of a family.
     *
     * @param family any family
     */
    public FamilyPatterns(MarkerFamily family) {
        this.family = family;
        if (family.isSquareBinary()) {
            dictionary = null;
            cells = BINARY_CELLS;
        } else {
            dictionary = ConfigHammingMarker.loadDictionary(HammingDictionary.valueOf(family.dictionaryName()));
            // the border of every predefined dictionary is a whole number of cells: one
            cells = (int) Math.round(dictionary.gridWidth / (1 - 2 * dictionary.borderWidthFraction));
        }
    }

    /** Cells along an edge, border included. */
    public int cells() {
        return cells;
    }

    /**
     * The pattern of one marker.
     *
     * @param id an id of the family
     * @return cells x cells values row by row from the top left, true for white
     */
    public boolean[] white(int id) {
        int width = cells * PIXELS_PER_CELL;
        FiducialImageEngine engine = new FiducialImageEngine();
        engine.configure(0, width);
        if (family.isSquareBinary()) {
            FiducialSquareGenerator generator = new FiducialSquareGenerator(engine);
            generator.setMarkerWidth(width);
            generator.setWhiteBorderDoc(0);
            generator.generate((long) id, BINARY_CODE_CELLS);
        } else {
            FiducialSquareHammingGenerator generator = new FiducialSquareHammingGenerator(dictionary);
            generator.setRenderer(engine);
            generator.setMarkerWidth(width);
            generator.generate(id);
        }
        boolean[] white = new boolean[cells * cells];
        for (int i = 0; i < white.length; i++) {
            int column = i % cells * PIXELS_PER_CELL + PIXELS_PER_CELL / 2;
            int row = i / cells * PIXELS_PER_CELL + PIXELS_PER_CELL / 2;
            white[i] = engine.getGray().get(column, row) > 127;
        }
        return white;
    }

    /**
     * Number of misread cells that cannot make one marker of another: the largest below half the family's smallest
     * distance.
     *
     * @return 0 for families without a checksum
     */
    int correctable() {
        return dictionary == null ? 0 : Math.max(0, (dictionary.minimumHamming - 1) / 2);
    }

    /**
     * A pattern turned by a quarter.
     *
     * @param white a pattern of {@link #cells()} squared values
     * @return the pattern turned clockwise
     */
    boolean[] turnedClockwise(boolean[] white) {
        boolean[] turned = new boolean[white.length];
        for (int row = 0; row < cells; row++) {
            for (int column = 0; column < cells; column++) {
                turned[row * cells + column] = white[(cells - 1 - column) * cells + row];
            }
        }
        return turned;
    }

    /**
     * Number of cells in which two patterns differ.
     *
     * @param a a pattern
     * @param b a pattern of the same size
     * @return 0 or more
     */
    static int differences(boolean[] a, boolean[] b) {
        int count = 0;
        for (int i = 0; i < a.length; i++) {
            if (a[i] != b[i]) {
                count++;
            }
        }
        return count;
    }
}
