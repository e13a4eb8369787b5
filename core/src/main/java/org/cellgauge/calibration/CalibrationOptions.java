package org.cellgauge.calibration;

/**
 * How a camera is calibrated; immutable.
 *
 * @param lens {@link #AUTO}, or one of {@link Calibration#lenses()}
 * @param warp coefficients of the board's warp, 0 to 5; {@link #BY_PHOTOS}: 2 where photos allow
 * @param aspect whether the board's stretch in y is unknown
 * @param distanceMm distance at which deviations of the projection are stated in mm; 0: where the photos' targets were
 */
public record CalibrationOptions(String lens, int warp, Aspect aspect, double distanceMm) {
    /** Two radial coefficients, or a richer lens where photos that were held out are better explained by it. */
    public static final String AUTO = "auto";
    /** As the photos allow. */
    public static final int BY_PHOTOS = -1;
    /** Most coefficients of a warp. */
    public static final int MOST_WARP = 5;
    /** What is usual. */
    public static final CalibrationOptions USUAL = new CalibrationOptions(AUTO, BY_PHOTOS, Aspect.BY_PHOTOS, 0);

    /** Whether the board's stretch is unknown. */
    public enum Aspect {
        /** It is as stated. */
        STATED,
        /** Its deviation is a few parts in a thousand. */
        UNKNOWN,
        /** Unknown where the target was turned about the camera's axis from photo to photo. */
        BY_PHOTOS
    }

    /**
     * Options.
     *
     * @throws IllegalArgumentException if there is no such lens or warp, or the distance is negative
     */
    public CalibrationOptions {
        if (!lens.equals(AUTO) && !Calibration.lenses().contains(lens)) {
            throw new IllegalArgumentException("no lens model: " + lens);
        }
        if (warp < BY_PHOTOS || warp > MOST_WARP || !(distanceMm >= 0)) {
            throw new IllegalArgumentException("no warp of " + warp + " coefficients at " + distanceMm + " mm");
        }
    }

    /**
     * The same with another lens.
     *
     * @param name {@link #AUTO}, or one of {@link Calibration#lenses()}
     * @return new options
     */
    public CalibrationOptions withLens(String name) {
        return new CalibrationOptions(name, warp, aspect, distanceMm);
    }

    /**
     * The same with another warp.
     *
     * @param coefficients 0 to 5, or {@link #BY_PHOTOS}
     * @return new options
     */
    public CalibrationOptions withWarp(int coefficients) {
        return new CalibrationOptions(lens, coefficients, aspect, distanceMm);
    }

    /**
     * The same with another aspect.
     *
     * @param choice whether it is unknown
     * @return new options
     */
    public CalibrationOptions withAspect(Aspect choice) {
        return new CalibrationOptions(lens, warp, choice, distanceMm);
    }
}
