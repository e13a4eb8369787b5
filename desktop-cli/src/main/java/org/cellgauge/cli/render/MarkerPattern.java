package org.cellgauge.cli.render;

import boofcv.alg.drawing.FiducialImageEngine;
import boofcv.alg.fiducial.square.FiducialSquareGenerator;
import boofcv.alg.fiducial.square.FiducialSquareHammingGenerator;
import boofcv.factory.fiducial.ConfigHammingMarker;
import boofcv.factory.fiducial.HammingDictionary;
import java.util.Locale;

/**
 * The black and white cells of a marker, seen from the front with the marker upright; immutable.
 *
 * <p>The cells are read off the picture that BoofCV's own generators draw ({@link FiducialSquareGenerator},
 * {@link FiducialSquareHammingGenerator}), so a marker here is what a user of BoofCV prints. Every family is a square
 * lattice of equal cells: a border of black cells around the code.
 */
public final class MarkerPattern {
    /** BoofCV's default border of square-binary markers is a quarter of the width: two of eight cells. */
    private static final int BINARY_CELLS = 8;
    private static final int BINARY_CODE_CELLS = 4;
    private static final int BINARY_IDS = 4096;
    private static final int PIXELS_PER_CELL = 8;

    private final int cells;
    private final boolean[] white;

    private MarkerPattern(int cells, boolean[] white) {
        this.cells = cells;
        this.white = white;
    }

    /**
     * The pattern of a marker.
     *
     * @param familyName as in the cell file: {@code square-binary}, or a name of BoofCV's {@link HammingDictionary} in
     *     lower case with hyphens
     * @param id marker id, from 0 on
     * @return its pattern
     * @throws IllegalArgumentException if there is no such family, or the family has no such id
     */
    public static MarkerPattern of(String familyName, int id) {
        FiducialImageEngine engine = new FiducialImageEngine();
        int cells;
        if (familyName.equals("square-binary")) {
            requireId(familyName, id, BINARY_IDS);
            cells = BINARY_CELLS;
            int width = cells * PIXELS_PER_CELL;
            engine.configure(0, width);
            FiducialSquareGenerator generator = new FiducialSquareGenerator(engine);
            generator.setMarkerWidth(width);
            generator.setWhiteBorderDoc(0);
            generator.generate((long) id, BINARY_CODE_CELLS);
        } else {
            ConfigHammingMarker dictionary = ConfigHammingMarker.loadDictionary(dictionary(familyName));
            requireId(familyName, id, dictionary.encoding.size);
            // the border of every predefined dictionary is a whole number of cells: one
            cells = (int) Math.round(dictionary.gridWidth / (1 - 2 * dictionary.borderWidthFraction));
            int width = cells * PIXELS_PER_CELL;
            engine.configure(0, width);
            FiducialSquareHammingGenerator generator = new FiducialSquareHammingGenerator(dictionary);
            generator.setRenderer(engine);
            generator.setMarkerWidth(width);
            generator.generate(id);
        }
        boolean[] white = new boolean[cells * cells];
        for (int row = 0; row < cells; row++) {
            for (int column = 0; column < cells; column++) {
                white[row * cells + column] = engine.getGray().get(column * PIXELS_PER_CELL + PIXELS_PER_CELL / 2,
                        row * PIXELS_PER_CELL + PIXELS_PER_CELL / 2) > 127;
            }
        }
        return new MarkerPattern(cells, white);
    }

    /**
     * A square of one colour, for pictures with a known area.
     *
     * @return an all black pattern of one cell
     */
    public static MarkerPattern solidBlack() {
        return new MarkerPattern(1, new boolean[1]);
    }

    private static HammingDictionary dictionary(String familyName) {
        for (HammingDictionary d : HammingDictionary.allPredefined()) {
            if (d.name().toLowerCase(Locale.ROOT).replace('_', '-').equals(familyName)) {
                return d;
            }
        }
        throw new IllegalArgumentException("no marker family is named '" + familyName + "'");
    }

    private static void requireId(String familyName, int id, int ids) {
        if (id < 0 || id >= ids) {
            throw new IllegalArgumentException("the family " + familyName + " has the ids 0 to " + (ids - 1) + ", not "
                    + id);
        }
    }

    /**
     * Number of cells along an edge, border included.
     *
     * @return at least 1
     */
    public int cells() {
        return cells;
    }

    /**
     * Whether a cell is white.
     *
     * @param row from the top, 0 to {@link #cells()} - 1
     * @param column from the left, 0 to {@link #cells()} - 1
     * @return false for a black cell
     */
    public boolean isWhite(int row, int column) {
        return white[row * cells + column];
    }
}
