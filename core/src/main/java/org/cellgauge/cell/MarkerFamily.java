package org.cellgauge.cell;

/** A family of square fiducial markers: BoofCV's square-binary, or one of its Hamming-coded dictionaries. */
public final class MarkerFamily {
    /** BoofCV's square-binary markers: a 4x4 grid inside a border of a quarter of the width, without checksum. */
    public static final MarkerFamily SQUARE_BINARY = new MarkerFamily("square-binary", 4096);

    private final String name;
    private final int size;

    MarkerFamily(String name, int size) {
        this.name = name;
        this.size = size;
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
     * Number of markers.
     *
     * @return ids run from 0 to this minus 1
     */
    public int size() {
        return size;
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
