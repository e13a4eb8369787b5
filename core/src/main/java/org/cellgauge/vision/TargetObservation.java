package org.cellgauge.vision;

/**
 * What one photo shows of a calibration target; immutable.
 */
public final class TargetObservation {
    private final String name;
    private final int widthPx;
    private final int heightPx;
    private final int[] points;
    private final double[] uvPx;

    /**
     * An observation.
     *
     * @param name the photo's, for messages
     * @param widthPx width of the photo
     * @param heightPx height of the photo
     * @param points indices into {@link TargetPoints}; none where the target was not found; copied
     * @param uvPx where they were seen, u and v of each, px, pixel centres at +0.5; copied
     */
    public TargetObservation(String name, int widthPx, int heightPx, int[] points, double[] uvPx) {
        if (uvPx.length != 2 * points.length) {
            throw new IllegalArgumentException(points.length + " points have " + uvPx.length + " coordinates");
        }
        this.name = name;
        this.widthPx = widthPx;
        this.heightPx = heightPx;
        this.points = points.clone();
        this.uvPx = uvPx.clone();
    }

    /**
     * The photo's name.
     *
     * @return as messages give it
     */
    public String name() {
        return name;
    }

    /**
     * Width of the photo.
     *
     * @return px
     */
    public int widthPx() {
        return widthPx;
    }

    /**
     * Height of the photo.
     *
     * @return px
     */
    public int heightPx() {
        return heightPx;
    }

    /**
     * How many points were seen.
     *
     * @return 0 where the target was not found
     */
    public int count() {
        return points.length;
    }

    /**
     * Which points were seen.
     *
     * @return indices into {@link TargetPoints}; a copy
     */
    public int[] points() {
        return points.clone();
    }

    /**
     * Where they were seen.
     *
     * @return u and v of each, px; a copy
     */
    public double[] uvPx() {
        return uvPx.clone();
    }
}
