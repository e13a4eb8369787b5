package org.cellgauge.geometry;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A lens model: how directions become places in an image, as a function of its parameters; without state, so that one
 * object serves all cameras of the model and all threads.
 *
 * <p>Parameters travel as plain arrays beside it, because unknown ones change with every step of a chain. Every model
 * begins with the five values of {@link PinholeCamera}: fx, fy, cx, cy, skew (px), which take a place (xd, yd) of the
 * plane behind the lens to the pixel {@code u = fx xd + skew yd + cx, v = fy yd + cy}; what bends the rays follows.
 * Image size and values together are a {@link PinholeCamera}.
 *
 * <p>Points and rays are in the camera frame: x right, y down, z forward along the optical axis. Nothing here allocates
 * except {@link #parameterNames()}: the inner loops of the posterior stand on it. {@code LensContractTest} holds what
 * is said below for every lens.
 */
public interface Lens {
    /**
     * The model's name, as in camera files: {@code pinhole_radial_tangential} or {@code kannala_brandt}.
     *
     * @return the name
     */
    String modelName();

    /**
     * Names of the parameters, with their unit where they have one ({@code fx_px}); beginning with fx_px, fy_px, cx_px,
     * cy_px, skew_px.
     *
     * @return names in the order of parameter arrays, unmodifiable
     */
    List<String> parameterNames();

    /**
     * Length of a parameter array.
     *
     * @return the number of parameters, at least 5
     */
    int parameterCount();

    /**
     * Whether the images of straight lines bend: the one answer to whether a lens distorts. A skew does not bend.
     *
     * @param parameters values
     * @return false if the lens is an ideal pinhole, whose pixels are {@code u = fx x/z + skew y/z + cx, v = fy y/z +
     *     cy}
     */
    boolean isDistorting(double[] parameters);

    /**
     * Whether the lens may see directions at a right angle to its axis and beyond. If not, z is positive for all that
     * it sees, {@link #toRay} gives rays with z = 1, and one plane shows the whole undistorted image.
     *
     * @return true for a fisheye
     */
    boolean isWide();

    /**
     * Angle off the axis at which the model ends, because beyond it further directions would come back towards the
     * image's middle or there are no more directions: points beyond it must not be drawn. The decentring of a lens is
     * left out of account.
     *
     * @param parameters values
     * @return rad, to about 0.001 from below, above 0 and at most pi
     */
    double reachRad(double[] parameters);

    /**
     * Projects a point.
     *
     * @param parameters values
     * @param x x in the camera frame, mm
     * @param y y in the camera frame, mm
     * @param z z in the camera frame, mm
     * @param uv receives u and v, px, from {@code offset} on
     * @param offset index of u in {@code uv}
     * @return false, with {@code uv} untouched, if the point is none that the lens could see (at z not positive for a
     *     lens that is not wide; where the image would not move outwards with the angle for one that is) or its z is
     *     NaN; x or y that is NaN gives false or an image that is. True does not say that it is nearer to the axis than
     * {@link #reachRad}: that is not looked at for every point
     */
    boolean project(double[] parameters, double x, double y, double z, double[] uv, int offset);

    /**
     * Projects a point and gives the derivatives of its image.
     *
     * @param parameters values
     * @param x x in the camera frame, mm
     * @param y y in the camera frame, mm
     * @param z z in the camera frame, mm
     * @param uv receives u and v, px
     * @param byPoint receives the 2x3 derivative by (x, y, z) row by row, px/mm
     * @param byParameters receives the 2 x {@link #parameterCount()} derivative by the parameters row by row, or null
     *     where it is not wanted
     * @return false, with all outputs untouched, where {@link #project} gives false
     */
    boolean projectWithDerivatives(double[] parameters, double x, double y, double z, double[] uv, double[] byPoint,
            double @Nullable [] byParameters);

    /**
     * Inverse of the projection: the direction that a place in the image shows, nearest to the axis if the model has
     * several.
     *
     * @param parameters values
     * @param u pixel x
     * @param v pixel y
     * @param ray receives a vector along the direction, 3 values: with z = 1 for a lens that is not wide, else of
     *     length 1
     * @return false, with {@code ray} untouched, where no direction within the model's reach has its image there
     */
    boolean toRay(double[] parameters, double u, double v, double[] ray);
}
