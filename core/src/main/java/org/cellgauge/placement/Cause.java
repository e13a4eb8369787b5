package org.cellgauge.placement;

import java.util.Locale;

/**
 * What may be wrong where references do not fit together: each moves the corners of all of them, or of some, in a
 * pattern of its own.
 */
public enum Cause {
    /** All markers are larger or smaller than stated, as printers make them: share of the size. */
    MARKER_SIZE,
    /** The markers of one stated size are larger or smaller: share of the size. */
    SIZE_OF_SOME,
    /** All edges lie off, as light, blur and a wrong tone curve move them: px into the dark. */
    EDGE_SHIFT,
    /** The focal length is another one than the camera file has: share of it. */
    FOCAL_LENGTH,
    /** The principal point is elsewhere: px in x and y. */
    PRINCIPAL_POINT,
    /** The radial distortion is another one: change of the lens's first coefficient. */
    DISTORTION,
    /** Positions along one world axis lie farther apart or closer together, as a stretched drawing has them: share. */
    STRETCH,
    /** All positions lie farther apart or closer together: factor on them. */
    POSITION_SCALE,
    /** Positions are stated in another unit: how many millimetres it has. */
    POSITION_UNIT,
    /** Sizes of markers are stated in another unit: how many millimetres it has. */
    SIZE_UNIT,
    /** One reference stands elsewhere, so far off that no more is said of it. */
    REFERENCE_ELSEWHERE,
    /** One reference stands off its place or is turned: {@link MisplacedReference}. */
    REFERENCE_OFF,
    /** Two references have each other's ids. */
    EXCHANGED,
    /** One reference is turned about its normal: quarter turns, counter-clockwise as one looks at it. */
    TURNED,
    /** All markers are turned about their normals, as where corners are counted from another one: quarter turns. */
    ALL_TURNED,
    /** A world axis points the other way. */
    MIRRORED,
    /** Rotations are stated in radians. */
    RADIANS;

    /**
     * Whether it is or is not, and has no size that could be small.
     *
     * @return true where it can only be tried outright
     */
    public boolean isOutright() {
        switch (this) {
            case POSITION_UNIT:
            case SIZE_UNIT:
            case EXCHANGED:
            case TURNED:
            case ALL_TURNED:
            case MIRRORED:
            case RADIANS:
                return true;
            default:
                return false;
        }
    }

    /**
     * Its word in files.
     *
     * @return for instance {@code marker-size}
     */
    public String key() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
