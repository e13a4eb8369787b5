package org.cellgauge.cell;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.cellgauge.warning.Refusal;
import org.jspecify.annotations.Nullable;

/**
 * A family of square fiducial markers: BoofCV's square-binary, or one of its predefined Hamming-coded dictionaries.
 *
 * <p>The table repeats what BoofCV 1.2.2 holds, because this package knows no image library; a test of the package that
 * detects compares the two. Some dictionaries hold a few markers that cannot be told apart by any detector: the same
 * code under two ids, or a code that looks the same after a quarter or half turn. These ids are named
 * {@linkplain #isAmbiguous ambiguous} and a cell may not use them.
 */
public final class MarkerFamily {
    /** BoofCV's square-binary markers: a 4x4 grid inside a border of a quarter of the width, without checksum. */
    public static final MarkerFamily SQUARE_BINARY = new MarkerFamily("SQUARE_BINARY", 4096);

    private static final List<MarkerFamily> ALL = Collections.unmodifiableList(Arrays.asList(
            SQUARE_BINARY,
            new MarkerFamily("ARUCO_ORIGINAL", 1024, 1023),
            new MarkerFamily("ARUCO_MIP_16h3", 250),
            new MarkerFamily("ARUCO_MIP_25h7", 100),
            new MarkerFamily("ARUCO_MIP_36h12", 250),
            new MarkerFamily("ARUCO_OCV_4x4_1000", 1000,
                    1, 2, 20, 31, 60, 75, 82, 85, 118, 192, 209, 212, 221, 252, 294, 371, 400, 424, 425, 438, 469,
                    489, 507, 530, 558, 580, 581, 595, 605, 620, 634, 648, 660, 679, 692, 718, 723, 725, 730, 748,
                    750, 763, 771, 772, 785, 809, 820, 831, 834, 876, 885, 896, 902, 922, 944, 950, 958),
            new MarkerFamily("ARUCO_OCV_5x5_1000", 1000),
            new MarkerFamily("ARUCO_OCV_6x6_1000", 1000),
            new MarkerFamily("ARUCO_OCV_7x7_1000", 1000),
            new MarkerFamily("APRILTAG_16h5", 30),
            new MarkerFamily("APRILTAG_25h7", 242),
            new MarkerFamily("APRILTAG_25h9", 35),
            new MarkerFamily("APRILTAG_36h10", 2320),
            new MarkerFamily("APRILTAG_36h11", 587)));

    private final String name;
    private final String dictionary;
    private final int size;
    private final int[] ambiguous;

    private MarkerFamily(String dictionary, int size, int... ambiguous) {
        this.name = dictionary.toLowerCase(Locale.ROOT).replace('_', '-');
        this.dictionary = dictionary;
        this.size = size;
        this.ambiguous = ambiguous;
    }

    /**
     * The family of a name.
     *
     * @param name as in a cell file, for instance {@code apriltag-36h11}
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
        for (MarkerFamily family : ALL) {
            if (family.name.equals(name)) {
                return family;
            }
        }
        return null;
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
     * The name of BoofCV's {@code HammingDictionary} constant.
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
     * Number of markers.
     *
     * @return ids run from 0 to this minus 1
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
     * Whether this is the square-binary family.
     *
     * @return false for the Hamming-coded dictionaries
     */
    public boolean isSquareBinary() {
        return this == SQUARE_BINARY;
    }

    @Override
    public String toString() {
        return name;
    }
}
