package org.cellgauge.vision;

import boofcv.alg.drawing.FiducialImageEngine;
import boofcv.alg.fiducial.qrcode.PackedBits32;
import boofcv.alg.fiducial.square.FiducialSquareGenerator;
import boofcv.alg.fiducial.square.FiducialSquareHammingGenerator;
import boofcv.factory.fiducial.ConfigHammingMarker;
import boofcv.factory.fiducial.HammingDictionary;
import org.cellgauge.cell.MarkerFamily;
import org.jspecify.annotations.Nullable;

/**
 * The black and white cells of a family's markers, border included, marker upright: read off the pictures that BoofCV's
 * own generators draw, so that a marker here is what a user of BoofCV prints. Where its table of a dictionary is not
 * the dictionary ({@link OpenCv4x4}), BoofCV is given the right one.
 */
public final class FamilyPatterns {
    private static final int PIXELS_PER_CELL = 4;

    private final MarkerFamily family;
    /** Null for families of BoofCV's that have no table. */
    private final @Nullable ConfigHammingMarker dictionary;
    private final MarkerGrid grid;

    /**
     * Patterns of a family.
     *
     * @param family any family
     */
    public FamilyPatterns(MarkerFamily family) {
        this.family = family;
        this.dictionary = family.isSquareBinary() ? null : dictionary(family);
        // BoofCV's default border of square-binary markers is a quarter of the width; all dictionaries have one cell
        this.grid = MarkerGrid.of(family.codeCells(), dictionary == null ? family.codeCells() : 2);
    }

    private static ConfigHammingMarker dictionary(MarkerFamily family) {
        HammingDictionary name = HammingDictionary.valueOf(family.dictionaryName());
        ConfigHammingMarker whole = ConfigHammingMarker.loadDictionary(name);
        if (name == HammingDictionary.ARUCO_OCV_4x4_1000) {
            whole.encoding.reset();
            for (int id = 0; id < family.size(); id++) {
                whole.addMarker(OpenCv4x4.code(id));
            }
            whole.minimumHamming = OpenCv4x4.smallestDistance(family.size());
        }
        while (whole.encoding.size > family.size()) {
            whole.encoding.removeTail();
        }
        if (family.isHalfTurned()) {
            whole.encoding.forEach(marker -> turnHalf(marker.pattern));
        }
        return whole;
    }

    /** Half a turn puts the cells in the opposite order. */
    private static void turnHalf(PackedBits32 code) {
        for (int i = 0, k = code.size - 1; i < k; i++, k--) {
            int bit = code.get(i);
            code.set(i, code.get(k));
            code.set(k, bit);
        }
    }

    /** What BoofCV calls the dictionary; null for square-binary. */
    @Nullable ConfigHammingMarker dictionary() {
        return dictionary;
    }

    /** The lattice of the family's markers. */
    MarkerGrid grid() {
        return grid;
    }

    /**
     * The pattern of one marker.
     *
     * @param id an id of the family
     * @return bands x bands values row by row from the top left, true for white
     */
    boolean[] white(int id) {
        int width = (int) (grid.cells() * PIXELS_PER_CELL);
        FiducialImageEngine engine = new FiducialImageEngine();
        engine.configure(0, width);
        if (dictionary == null) {
            FiducialSquareGenerator generator = new FiducialSquareGenerator(engine);
            generator.setMarkerWidth(width);
            generator.setWhiteBorderDoc(0);
            generator.generate((long) id, family.codeCells());
        } else {
            FiducialSquareHammingGenerator generator = new FiducialSquareHammingGenerator(dictionary);
            generator.setRenderer(engine);
            generator.setMarkerWidth(width);
            generator.generate(id);
        }
        int bands = grid.bands();
        boolean[] white = new boolean[bands * bands];
        for (int i = 0; i < white.length; i++) {
            white[i] = engine.getGray().get(pixel(i % bands), pixel(i / bands)) > 127;
        }
        return white;
    }

    /**
     * Number of equal squares along an edge that a marker can be put together of, border included.
     *
     * @return at least 6
     */
    public int squares() {
        return grid.squares();
    }

    /**
     * The pattern of one marker as equal squares.
     *
     * @param id an id of the family
     * @return squares x squares values row by row from the top left, true for white
     */
    public boolean[] whiteSquares(int id) {
        boolean[] white = white(id);
        boolean[] squares = new boolean[squares() * squares()];
        for (int i = 0; i < squares.length; i++) {
            squares[i] = white[grid.bandOf(i / squares()) * grid.bands() + grid.bandOf(i % squares())];
        }
        return squares;
    }

    private int pixel(int band) {
        return (int) (grid.middle(band) * PIXELS_PER_CELL);
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
     * @param white a pattern of bands x bands values
     * @return the pattern turned clockwise
     */
    boolean[] turnedClockwise(boolean[] white) {
        int bands = grid.bands();
        boolean[] turned = new boolean[white.length];
        for (int row = 0; row < bands; row++) {
            for (int column = 0; column < bands; column++) {
                turned[row * bands + column] = white[(bands - 1 - column) * bands + row];
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
