package org.cellgauge.cell;

/** How precisely a reference marker was placed: standard deviations of its rigid placement error; immutable. */
public final class Placement {
    private final double stdXMm;
    private final double stdYMm;
    private final double stdZMm;
    private final double stdRad;

    /**
     * A placement precision.
     *
     * @param stdXMm standard deviation along world x, mm, not negative
     * @param stdYMm standard deviation along world y, mm, not negative
     * @param stdZMm standard deviation along world z, mm, not negative
     * @param stdRad standard deviation of each component of the small rotation vector about the marker's own centre,
     *     rad, not negative
     * @throws IllegalArgumentException if a value is negative or not finite
     */
    public Placement(double stdXMm, double stdYMm, double stdZMm, double stdRad) {
        if (!(stdXMm >= 0 && stdYMm >= 0 && stdZMm >= 0 && stdRad >= 0)
                || !Double.isFinite(stdXMm + stdYMm + stdZMm + stdRad)) {
            throw new IllegalArgumentException("placement deviations must be finite and not negative");
        }
        this.stdXMm = stdXMm;
        this.stdYMm = stdYMm;
        this.stdZMm = stdZMm;
        this.stdRad = stdRad;
    }

    /**
     * Standard deviation along a world axis.
     *
     * @param axis 0, 1 or 2 for x, y, z
     * @return mm
     */
    public double stdMm(int axis) {
        return axis == 0 ? stdXMm : axis == 1 ? stdYMm : stdZMm;
    }

    /**
     * Standard deviation of each component of the rotation vector about the marker's centre.
     *
     * @return rad
     */
    public double stdRad() {
        return stdRad;
    }
}
