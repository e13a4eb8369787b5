package org.cellgauge.internal.geometry;

import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.jspecify.annotations.Nullable;

/** The square of a marker in its own frame: x right, y up, z out of the face, origin at the centre. */
public final class MarkerGeometry {
    /** Corners of a marker. */
    public static final int CORNERS = 4;
    private static final double[] SIGN_X = {-1, 1, 1, -1};
    private static final double[] SIGN_Y = {1, 1, -1, -1};

    private MarkerGeometry() {
    }

    /**
     * The corners in the order of every file and array of this project: top-left, top-right, bottom-right, bottom-left.
     *
     * @param sizeMm outer edge of the black border, mm, positive
     * @return 12 values: x, y, z of each corner in the marker's frame, mm
     */
    public static double[] cornersMm(double sizeMm) {
        double[] corners = new double[3 * CORNERS];
        cornersMm(sizeMm, corners);
        return corners;
    }

    /**
     * The same in an array of the caller's.
     *
     * @param sizeMm outer edge of the black border, mm, positive
     * @param out receives 12 values: x, y, z of each corner in the marker's frame, mm
     */
    public static void cornersMm(double sizeMm, double[] out) {
        for (int i = 0; i < CORNERS; i++) {
            out[3 * i] = SIGN_X[i] * sizeMm / 2;
            out[3 * i + 1] = SIGN_Y[i] * sizeMm / 2;
            out[3 * i + 2] = 0;
        }
    }

    /**
     * The corners of a marker whose pose is known.
     *
     * @param aFromMarker pose of the marker in some frame
     * @param sizeMm outer edge, mm
     * @return 12 values: x, y, z of each corner in that frame, mm
     */
    public static double[] cornersMm(RigidTransform aFromMarker, double sizeMm) {
        double[] corners = cornersMm(sizeMm);
        for (int i = 0; i < CORNERS; i++) {
            double[] moved = aFromMarker.apply(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]);
            System.arraycopy(moved, 0, corners, 3 * i, 3);
        }
        return corners;
    }

    /**
     * Where a camera sees the corners of a marker.
     *
     * @param camera intrinsics
     * @param cameraFromMarker pose of the marker in the camera frame
     * @param sizeMm outer edge, mm
     * @return 8 values: u, v of each corner, px; null if one is not in front of the camera
     */
    public static double @Nullable [] cornersPx(PinholeCamera camera, RigidTransform cameraFromMarker, double sizeMm) {
        double[] corners = cornersMm(cameraFromMarker, sizeMm);
        double[] px = new double[2 * CORNERS];
        for (int k = 0; k < CORNERS; k++) {
            double[] uv = camera.project(corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]);
            if (uv == null) {
                return null;
            }
            System.arraycopy(uv, 0, px, 2 * k, 2);
        }
        return px;
    }

    /**
     * Where a camera sees the corners of a marker that it sees from the front and wholly in the image.
     *
     * @param camera intrinsics
     * @param cameraFromMarker pose of the marker in the camera frame
     * @param sizeMm outer edge, mm
     * @return 8 values: u, v of each corner, px; null if it shows its back, or some corner is outside the image
     */
    public static double @Nullable [] seenPx(PinholeCamera camera, RigidTransform cameraFromMarker, double sizeMm) {
        double[] r = cameraFromMarker.rotation();
        double[] t = cameraFromMarker.translationMm();
        // the marker's normal must point towards the camera, which is at the origin
        if (!(r[2] * t[0] + r[5] * t[1] + r[8] * t[2] < 0)) {
            return null;
        }
        double[] corners = cornersMm(cameraFromMarker, sizeMm);
        double[] px = new double[2 * CORNERS];
        for (int k = 0; k < CORNERS; k++) {
            double[] uv = camera.image(corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]);
            if (uv == null || !(uv[0] >= 0 && uv[0] <= camera.widthPx() && uv[1] >= 0
                    && uv[1] <= camera.heightPx())) {
                return null;
            }
            System.arraycopy(uv, 0, px, 2 * k, 2);
        }
        return px;
    }
}
