package org.cellgauge.internal.overlay;

import org.cellgauge.statistics.Ellipse;
import org.jspecify.annotations.Nullable;

/**
 * How an image must be turned, and perhaps mirrored, to stand upright on a display: first clockwise by quarter turns,
 * then mirrored left to right; immutable.
 *
 * <p>Positions are px with pixel centres at +0.5, so that mapping an image of size (w, h) takes u to w - u and not to
 * w - 1 - u.
 */
public final class ImageOrientation {
    /** Neither turned nor mirrored. */
    public static final ImageOrientation IDENTITY = new ImageOrientation(0, false);

    private static final int QUARTERS = 4;
    private static final int QUARTER_DEG = 90;

    private final int quarterTurns;
    private final boolean mirrored;

    private ImageOrientation(int quarterTurns, boolean mirrored) {
        this.quarterTurns = quarterTurns;
        this.mirrored = mirrored;
    }

    /**
     * An orientation.
     *
     * @param quarterTurnsClockwise how often the image is turned clockwise by 90 degrees; any number, negative ones
     *     turn the other way
     * @param mirrored whether it is then mirrored left to right
     * @return the orientation
     */
    public static ImageOrientation of(int quarterTurnsClockwise, boolean mirrored) {
        return new ImageOrientation(Math.floorMod(quarterTurnsClockwise, QUARTERS), mirrored);
    }

    /**
     * The orientation of a camera's image on the display of a handheld device. An image of the back camera is turned by
     * (sensor - display), one of the front camera by (sensor + display) and then mirrored, as users expect of a mirror
     * (Android's reference of {@code CameraCharacteristics.SENSOR_ORIENTATION} and {@code Display.getRotation}).
     *
     * @param sensorOrientationDeg angle by which the image must be turned clockwise to be upright on the display in the
     *     device's natural orientation: 0, 90, 180 or 270
     * @param displayRotationDeg rotation of what is drawn from the device's natural orientation, clockwise, opposite to
     *     how the device was turned: 0, 90, 180 or 270
     * @param frontFacing whether the camera looks the way the display does
     * @return the orientation
     * @throws IllegalArgumentException if an angle is no multiple of 90 degrees
     */
    public static ImageOrientation of(int sensorOrientationDeg, int displayRotationDeg, boolean frontFacing) {
        if (sensorOrientationDeg % QUARTER_DEG != 0 || displayRotationDeg % QUARTER_DEG != 0) {
            throw new IllegalArgumentException("angles must be multiples of 90 degrees, not " + sensorOrientationDeg
                    + " and " + displayRotationDeg);
        }
        int sensor = sensorOrientationDeg / QUARTER_DEG;
        int display = displayRotationDeg / QUARTER_DEG;
        return of(frontFacing ? sensor + display : sensor - display, frontFacing);
    }

    /**
     * How often the image is turned clockwise by 90 degrees.
     *
     * @return 0 to 3
     */
    public int quarterTurnsClockwise() {
        return quarterTurns;
    }

    /**
     * Whether the turned image is mirrored left to right.
     *
     * @return true if so
     */
    public boolean mirrored() {
        return mirrored;
    }

    /**
     * Whether nothing is to be done.
     *
     * @return true if the image is neither turned nor mirrored
     */
    public boolean isIdentity() {
        return quarterTurns == 0 && !mirrored;
    }

    /**
     * Width of the upright image.
     *
     * @param widthPx width of the image as it comes
     * @param heightPx its height
     * @return px
     */
    public int uprightWidthPx(int widthPx, int heightPx) {
        return quarterTurns % 2 == 0 ? widthPx : heightPx;
    }

    /**
     * Height of the upright image.
     *
     * @param widthPx width of the image as it comes
     * @param heightPx its height
     * @return px
     */
    public int uprightHeightPx(int widthPx, int heightPx) {
        return quarterTurns % 2 == 0 ? heightPx : widthPx;
    }

    /**
     * Where a position of the image lies in the upright image.
     *
     * @param u position in the image as it comes, px
     * @param v the same downwards
     * @param widthPx width of the image as it comes
     * @param heightPx its height
     * @return u, v in the upright image, px
     */
    public double[] map(double u, double v, int widthPx, int heightPx) {
        double[] uv = {u, v};
        map(uv, 0, widthPx, heightPx);
        return uv;
    }

    /** The same in place: u and v at an index of an array. */
    void map(double[] uv, int at, int widthPx, int heightPx) {
        double u = uv[at];
        double v = uv[at + 1];
        double x;
        double y;
        switch (quarterTurns) {
            case 1:
                x = heightPx - v;
                y = u;
                break;
            case 2:
                x = widthPx - u;
                y = heightPx - v;
                break;
            case 3:
                x = v;
                y = widthPx - u;
                break;
            default:
                x = u;
                y = v;
                break;
        }
        uv[at] = mirrored ? uprightWidthPx(widthPx, heightPx) - x : x;
        uv[at + 1] = y;
    }

    /**
     * Where positions of the image lie in the upright image.
     *
     * @param pointsPx u0, v0, u1, v1, … in the image as it comes
     * @param widthPx width of the image as it comes
     * @param heightPx its height
     * @return as many values, in the upright image
     */
    public double[] map(double[] pointsPx, int widthPx, int heightPx) {
        double[] out = pointsPx.clone();
        for (int i = 0; i + 1 < out.length; i += 2) {
            map(out, i, widthPx, heightPx);
        }
        return out;
    }

    /**
     * An ellipse of the image in the upright image.
     *
     * @param ellipse in px of the image as it comes, or null
     * @param widthPx width of the image as it comes
     * @param heightPx its height
     * @return the same ellipse in the upright image; null for null
     */
    public @Nullable Ellipse map(@Nullable Ellipse ellipse, int widthPx, int heightPx) {
        if (ellipse == null || isIdentity()) {
            return ellipse;
        }
        double[] centre = map(ellipse.centreX(), ellipse.centreY(), widthPx, heightPx);
        // clockwise on the screen is from u towards v
        double turned = ellipse.angleRad() + quarterTurns * Math.PI / 2;
        return new Ellipse(centre[0], centre[1], ellipse.semiMajor(), ellipse.semiMinor(),
                mirrored ? Math.PI - turned : turned);
    }

    /**
     * The way back: what takes the upright image to the image as it comes. Give its methods the size of the upright
     * image.
     *
     * @return the inverse
     */
    public ImageOrientation inverse() {
        // undoing a mirror and then a turn is the same turn and then the mirror
        return mirrored ? this : of(-quarterTurns, false);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ImageOrientation && ((ImageOrientation) other).quarterTurns == quarterTurns
                && ((ImageOrientation) other).mirrored == mirrored;
    }

    @Override
    public int hashCode() {
        return 2 * quarterTurns + (mirrored ? 1 : 0);
    }

    @Override
    public String toString() {
        return quarterTurns * QUARTER_DEG + " degrees clockwise" + (mirrored ? ", mirrored" : "");
    }
}
