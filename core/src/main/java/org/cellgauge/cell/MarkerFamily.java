package org.cellgauge.cell;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.cellgauge.warning.Refusal;
import org.jspecify.annotations.Nullable;

/**
 * A family of square fiducial markers: BoofCV's square-binary grids, or a dictionary of codes with a checksum (ArUco,
 * AprilTag), whole or its first markers, as OpenCV names them.
 *
 * <p>The table repeats what BoofCV 1.2.2 and OpenCV hold, because this package knows no image library; tests of the
 * package that detects compare. Some dictionaries hold a few markers that cannot be told apart by any detector: the
 * same code under two ids, or a code that looks the same after a quarter or half turn. These ids are named
 * {@linkplain #isAmbiguous ambiguous} and a cell may not use them.
 */
public final class MarkerFamily {
    /** BoofCV's usual square-binary markers: a 4x4 grid inside a border of a quarter of the width, without checksum. */
    public static final MarkerFamily SQUARE_BINARY = squareBinary(4);

    private static final List<MarkerFamily> ALL = Collections.unmodifiableList(Arrays.asList(
            SQUARE_BINARY, squareBinary(3), squareBinary(5), squareBinary(6), squareBinary(7), squareBinary(8),
            coded("ARUCO_ORIGINAL", 5, 1024, 1023),
            coded("ARUCO_MIP_16h3", 4, 250),
            coded("ARUCO_MIP_25h7", 5, 100),
            coded("ARUCO_MIP_36h12", 6, 250),
            openCv(4, 1000), openCv(4, 50), openCv(4, 100), openCv(4, 250),
            openCv(5, 1000), openCv(5, 50), openCv(5, 100), openCv(5, 250),
            openCv(6, 1000), openCv(6, 50), openCv(6, 100), openCv(6, 250),
            openCv(7, 1000), openCv(7, 50), openCv(7, 100), openCv(7, 250),
            coded("APRILTAG_16h5", 4, 30),
            coded("APRILTAG_25h7", 5, 242),
            coded("APRILTAG_25h9", 5, 35),
            coded("APRILTAG_36h10", 6, 2320),
            coded("APRILTAG_36h11", 6, 587)));

    private final String name;
    private final String dictionary;
    private final int codeCells;
    private final int size;
    private final int[] ambiguous;
    private final boolean halfTurned;
    private final MarkerFamily asOpenCvDraws;

    private MarkerFamily(String name, String dictionary, int codeCells, int size, int... ambiguous) {
        this.name = name;
        this.dictionary = dictionary;
        this.codeCells = codeCells;
        this.size = size;
        this.ambiguous = ambiguous;
        this.halfTurned = false;
        this.asOpenCvDraws = dictionary.startsWith("APRILTAG") ? new MarkerFamily(this) : this;
    }

    /** An AprilTag family whose markers are turned by half a turn. */
    private MarkerFamily(MarkerFamily upright) {
        this.name = upright.name;
        this.dictionary = upright.dictionary;
        this.codeCells = upright.codeCells;
        this.size = upright.size;
        this.ambiguous = upright.ambiguous;
        this.halfTurned = true;
        this.asOpenCvDraws = this;
    }

    private static MarkerFamily squareBinary(int codeCells) {
        // four corners tell the orientation; ids are whole numbers of 32 bits, of which the large grids have more
        int bits = codeCells * codeCells - 4;
        String grid = codeCells == 4 ? "" : "-" + codeCells + "x" + codeCells;
        return new MarkerFamily("square-binary" + grid, "", codeCells,
                bits < 31 ? 1 << bits : Integer.MAX_VALUE);
    }

    private static MarkerFamily coded(String dictionary, int codeCells, int size, int... ambiguous) {
        return new MarkerFamily(dictionary.toLowerCase(Locale.ROOT).replace('_', '-'), dictionary, codeCells, size,
                ambiguous);
    }

    /** The first markers of a dictionary of OpenCV. */
    private static MarkerFamily openCv(int codeCells, int size) {
        String grid = "ARUCO_OCV_" + codeCells + "x" + codeCells + "_";
        return new MarkerFamily((grid + size).toLowerCase(Locale.ROOT).replace('_', '-'), grid + "1000", codeCells,
                size);
    }

    /**
     * The family of a name.
     *
     * @param name as in a cell file, for instance {@code apriltag-36h11}; large letters, underscores, spaces and the
     *     names of OpenCV ({@code DICT_4X4_50}) and the AprilTag library ({@code tag36h11}) mean the same family
     * @return the family
     * @throws IllegalArgumentException if there is no family of this name; the message says which name may be meant
     */
    public static MarkerFamily of(String name) {
        MarkerFamily family = find(name);
        if (family == null) {
            throw new IllegalArgumentException(
                    Refusal.of(CellRefusal.NO_FAMILY, name, suggestion(name)).toString());
        }
        return family;
    }

    /** Which family may be meant by a name that none has. */
    static Refusal suggestion(String name) {
        return Suggestions.remedy(name, ALL.stream().map(f -> f.name).collect(Collectors.toList()));
    }

    /** The family of a name, or null. */
    static @Nullable MarkerFamily find(String name) {
        String letters = letters(name);
        String own = letters.startsWith("dict") ? letters.substring("dict".length()) : letters;
        for (MarkerFamily family : ALL) {
            String known = letters(family.name);
            if (own.equals(known) || own.equals(known.replace("arucoocv", "")) || own.equals(known.replace("ocv", ""))
                    || own.equals(known.replace("apriltag", "tag")) || own.equals(known.replace("mip", ""))) {
                return family;
            }
        }
        return own.equals("squarebinary4x4") ? SQUARE_BINARY : null;
    }

    /** A name without what tools write differently: large letters, hyphens, underscores, spaces. */
    private static String letters(String name) {
        return name.toLowerCase(Locale.ROOT).replaceAll("[-_ ]", "");
    }

    /**
     * All families.
     *
     * @return unmodifiable, square-binary first
     */
    public static List<MarkerFamily> all() {
        return ALL;
    }

    /**
     * The name of the cell file.
     *
     * @return for instance {@code square-binary}, {@code apriltag-36h11}
     */
    public String familyName() {
        return name;
    }

    /**
     * The name of BoofCV's {@code HammingDictionary} constant that has the family's markers first.
     *
     * @return for instance {@code APRILTAG_36h11}
     * @throws IllegalStateException for square-binary, which is no dictionary
     */
    public String dictionaryName() {
        if (isSquareBinary()) {
            throw new IllegalStateException("square-binary is no Hamming dictionary");
        }
        return dictionary;
    }

    /**
     * Size of the code's grid.
     *
     * @return cells along it, without the black border: 3 to 8
     */
    public int codeCells() {
        return codeCells;
    }

    /**
     * Number of markers.
     *
     * @return ids run from 0 to this minus 1; square-binary grids from 6x6 on have more, whose ids do not go into an
     *     {@code int}
     */
    public int size() {
        return size;
    }

    /**
     * Whether the family has a marker of this id.
     *
     * @param id any number
     * @return true from 0 to {@link #size()} minus 1
     */
    public boolean has(int id) {
        return id >= 0 && id < size;
    }

    /**
     * Whether a marker cannot be told from another one of its family, or from itself turned.
     *
     * @param id marker id
     * @return true if a detector may report another id or another orientation for a perfect picture of it
     */
    public boolean isAmbiguous(int id) {
        return Arrays.binarySearch(ambiguous, id) >= 0;
    }

    /**
     * Whether this is a square-binary grid.
     *
     * @return false for the Hamming-coded dictionaries
     */
    public boolean isSquareBinary() {
        return dictionary.isEmpty();
    }

    /**
     * The family with its markers as OpenCV draws them and orders their corners: AprilTags by half a turn from the
     * AprilTag library's, the others as they are.
     *
     * @return the family whose upright is OpenCV's; the same each time
     */
    public MarkerFamily asOpenCvDraws() {
        return asOpenCvDraws;
    }

    /**
     * Whether its markers are turned by half a turn against the library that they come from.
     *
     * @return true for AprilTags {@linkplain #asOpenCvDraws() as OpenCV draws them}
     */
    public boolean isHalfTurned() {
        return halfTurned;
    }

    @Override
    public String toString() {
        return name;
    }
}
