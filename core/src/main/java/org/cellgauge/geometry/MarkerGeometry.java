package org.cellgauge.geometry;

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
        for (int i = 0; i < CORNERS; i++) {
            corners[3 * i] = SIGN_X[i] * sizeMm / 2;
            corners[3 * i + 1] = SIGN_Y[i] * sizeMm / 2;
        }
        return corners;
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
}
