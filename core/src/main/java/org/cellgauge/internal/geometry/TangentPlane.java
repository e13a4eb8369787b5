package org.cellgauge.internal.geometry;

import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;

/**
 * A part of a wide image without its distortion: directions are carried from the camera on to the plane that touches
 * the sphere of directions at an axis chosen near them (the gnomonic projection), where straight lines are straight.
 * One plane before the optical axis, as it serves other lenses, would draw what a fisheye sees at its border out
 * without end.
 *
 * <p>Its coordinates are x/z and y/z in the frame of the axis, {@link #toNormalised}; or px, {@link #toPlane}, turned
 * and stretched so that near the axis they are the image's own. Mutable work space, not thread-safe; allocates nothing
 * once it is made.
 */
public final class TangentPlane {
    private final Lens lens;
    private final double[] parameters;
    /** Rows are the axes of the plane and the axis it is aimed along, in the camera frame. */
    private final double[] planeFromCamera = new double[9];
    private final double[] ray = new double[3];
    private final double[] normalised = new double[2];
    private final double[] centrePx = new double[2];
    private final double[] byPoint = new double[6];
    // derivative of the pixel position by x/z, y/z at the axis
    private double uByX;
    private double uByY;
    private double vByX;
    private double vByY;

    /**
     * A plane that has to be aimed first.
     *
     * @param camera the camera
     */
    public TangentPlane(PinholeCamera camera) {
        this.lens = camera.lens();
        this.parameters = camera.intrinsics();
    }

    /**
     * Aims the plane along the mean direction of places in the image.
     *
     * @param px u, v of the places, one after the other; those where the lens shows nothing are left out
     * @return whether there is such a direction: false, with the plane unusable, if no place shows anything or they
     *     show directions all around
     */
    public boolean aim(double[] px) {
        double x = 0;
        double y = 0;
        double z = 0;
        for (int i = 0; i + 1 < px.length; i += 2) {
            if (!lens.toRay(parameters, px[i], px[i + 1], ray)) {
                continue;
            }
            double length = Math.sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]);
            x += ray[0] / length;
            y += ray[1] / length;
            z += ray[2] / length;
        }
        double length = Math.sqrt(x * x + y * y + z * z);
        if (!(length > 1e-6)) {
            return false;
        }
        return along(x / length, y / length, z / length);
    }

    private boolean along(double x, double y, double z) {
        if (!lens.projectWithDerivatives(parameters, x, y, z, centrePx, byPoint, null)) {
            return false;
        }
        // the camera's axis that is the most across
        double[] r = planeFromCamera;
        boolean useX = Math.abs(x) <= Math.abs(y);
        double along = useX ? x : y;
        r[0] = (useX ? 1 : 0) - along * x;
        r[1] = (useX ? 0 : 1) - along * y;
        r[2] = -along * z;
        double length = Math.sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
        for (int i = 0; i < 3; i++) {
            r[i] /= length;
        }
        r[3] = y * r[2] - z * r[1];
        r[4] = z * r[0] - x * r[2];
        r[5] = x * r[1] - y * r[0];
        r[6] = x;
        r[7] = y;
        r[8] = z;
        uByX = byPoint[0] * r[0] + byPoint[1] * r[1] + byPoint[2] * r[2];
        uByY = byPoint[0] * r[3] + byPoint[1] * r[4] + byPoint[2] * r[5];
        vByX = byPoint[3] * r[0] + byPoint[4] * r[1] + byPoint[5] * r[2];
        vByY = byPoint[3] * r[3] + byPoint[4] * r[4] + byPoint[5] * r[5];
        return uByX * vByY - uByY * vByX != 0;
    }

    /**
     * The rotation into the frame of the plane, whose z is the axis it is aimed along.
     *
     * @return a copy, planeFromCamera, 9 values row by row
     */
    public double[] planeFromCamera() {
        return planeFromCamera.clone();
    }

    /**
     * A pose in the camera frame of one in the frame of the plane.
     *
     * @param planeFromBody the pose
     * @return cameraFromBody
     */
    public RigidTransform inCamera(RigidTransform planeFromBody) {
        return RigidTransform.of(planeFromCamera, new double[3]).inverse().compose(planeFromBody);
    }

    /**
     * Where a place in the image is seen in the frame of the plane.
     *
     * @param u pixel x
     * @param v pixel y
     * @param out receives x/z and y/z
     * @return false, with {@code out} untouched, if the lens shows nothing there or it is at a right angle to the axis
     *     of the plane or further off
     */
    public boolean toNormalised(double u, double v, double[] out) {
        if (!lens.toRay(parameters, u, v, ray)) {
            return false;
        }
        double[] r = planeFromCamera;
        double z = r[6] * ray[0] + r[7] * ray[1] + r[8] * ray[2];
        if (!(z > 0)) {
            return false;
        }
        out[0] = (r[0] * ray[0] + r[1] * ray[1] + r[2] * ray[2]) / z;
        out[1] = (r[3] * ray[0] + r[4] * ray[1] + r[5] * ray[2]) / z;
        return true;
    }

    /**
     * The place on the plane of one in the image.
     *
     * @param u pixel x
     * @param v pixel y
     * @param out receives the place, px, 2 values
     * @param at index of the first
     * @return as {@link #toNormalised}
     */
    public boolean toPlane(double u, double v, double[] out, int at) {
        if (!toNormalised(u, v, normalised)) {
            return false;
        }
        out[at] = centrePx[0] + uByX * normalised[0] + uByY * normalised[1];
        out[at + 1] = centrePx[1] + vByX * normalised[0] + vByY * normalised[1];
        return true;
    }

    /**
     * The place in the image of one on the plane: the inverse of {@link #toPlane}.
     *
     * @param x place on the plane, px
     * @param y place on the plane, px
     * @param out receives u and v, px
     * @param at index of u
     * @return false, with {@code out} untouched, if the lens cannot see it
     */
    public boolean toImage(double x, double y, double[] out, int at) {
        double dx = x - centrePx[0];
        double dy = y - centrePx[1];
        double determinant = uByX * vByY - uByY * vByX;
        double a = (vByY * dx - uByY * dy) / determinant;
        double b = (uByX * dy - vByX * dx) / determinant;
        double[] r = planeFromCamera;
        return lens.project(parameters, a * r[0] + b * r[3] + r[6], a * r[1] + b * r[4] + r[7],
                a * r[2] + b * r[5] + r[8], out, at);
    }
}
