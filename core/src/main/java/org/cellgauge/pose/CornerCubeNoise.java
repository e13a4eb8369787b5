package org.cellgauge.pose;

import java.util.Arrays;
import org.cellgauge.cell.Placement;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.Projection;

/**
 * Residual covariance of the thesis' likelihood: every corner on its own, with deviations read off a projected box.
 *
 * <p>The eight vertices of the axis-aligned world box around the corner, half extents kappa times the placement
 * deviations, are projected; the deviation in u is the largest distance in u of a vertex from the projected corner,
 * likewise in v (thesis, section 5.3). Corners of one marker are taken as independent, which they are not: see
 * {@link RigidMarkerNoise}. Rotation of the placement and corner noise have no part in it.
 *
 * <p>Not thread-safe: it holds scratch arrays.
 */
public final class CornerCubeNoise implements ReferenceNoise {
    private final ReferenceView view;
    private final double kappa;
    private final double[] stdPx;

    /**
     * The noise of a view.
     *
     * @param view references with their placement precision
     * @param kappa half extent of the box in placement deviations, positive; 0.5 is a box of side sigma
     * @throws IllegalArgumentException if kappa is not positive
     */
    public CornerCubeNoise(ReferenceView view, double kappa) {
        if (!(kappa > 0)) {
            throw new IllegalArgumentException("kappa must be positive, not " + kappa);
        }
        this.view = view;
        this.kappa = kappa;
        this.stdPx = new double[8];
    }

    /**
     * Half extent of the box in placement deviations.
     *
     * @return kappa
     */
    public double kappa() {
        return kappa;
    }

    @Override
    public boolean covariance(CameraState state, int marker, double[] placementPx2, double[] pixelPx2) {
        double[] half = new double[3];
        Placement placement = view.references().get(marker).placement();
        for (int i = 0; i < 3; i++) {
            half[i] = kappa * placement.stdMm(i);
        }
        Arrays.fill(placementPx2, 0);
        Arrays.fill(pixelPx2, 0);
        double[] centre = new double[2];
        double[] vertex = new double[2];
        for (int k = 0; k < 4; k++) {
            if (!cornerStdPx(state, view.points(), 12 * marker + 3 * k, half, 0, centre, vertex, stdPx, 2 * k)) {
                return false;
            }
        }
        for (int i = 0; i < 8; i++) {
            placementPx2[9 * i] = stdPx[i] * stdPx[i];
        }
        return true;
    }

    /**
     * Projects one corner and the box around it. Allocates nothing.
     *
     * @param state pose and intrinsics
     * @param points corners relative to the centre of the set, world axes, mm
     * @param at index of the corner's x in {@code points}
     * @param half half extents of the box along the world axes, mm
     * @param halfAt index of the x extent in {@code half}
     * @param centrePx receives the projected corner, 2 values
     * @param vertexPx scratch, 2 values
     * @param stdPx receives the deviations in u and v
     * @param stdAt index of the deviation in u in {@code stdPx}
     * @return false if the corner or a vertex is not in front of the camera
     */
    public static boolean cornerStdPx(CameraState state, double[] points, int at, double[] half, int halfAt,
            double[] centrePx, double[] vertexPx, double[] stdPx, int stdAt) {
        double[] r = state.rotation;
        double[] intrinsics = state.intrinsics;
        double x = points[at];
        double y = points[at + 1];
        double z = points[at + 2];
        double cx = r[0] * x + r[1] * y + r[2] * z + state.offset[0];
        double cy = r[3] * x + r[4] * y + r[5] * z + state.offset[1];
        double cz = r[6] * x + r[7] * y + r[8] * z + state.offset[2];
        if (!Projection.project(intrinsics, cx, cy, cz, centrePx, 0)) {
            return false;
        }
        double hx = half[halfAt];
        double hy = half[halfAt + 1];
        double hz = half[halfAt + 2];
        if (isIdeal(intrinsics)) {
            return idealStdPx(r, cx, cy, cz, hx, hy, hz, intrinsics, stdPx, stdAt);
        }
        double largestU = 0;
        double largestV = 0;
        for (int i = -1; i <= 1; i += 2) {
            double ax = cx + i * hx * r[0];
            double ay = cy + i * hx * r[3];
            double az = cz + i * hx * r[6];
            for (int j = -1; j <= 1; j += 2) {
                double bx = ax + j * hy * r[1];
                double by = ay + j * hy * r[4];
                double bz = az + j * hy * r[7];
                for (int k = -1; k <= 1; k += 2) {
                    if (!Projection.project(intrinsics, bx + k * hz * r[2], by + k * hz * r[5], bz + k * hz * r[8],
                            vertexPx, 0)) {
                        return false;
                    }
                    largestU = Math.max(largestU, Math.abs(vertexPx[0] - centrePx[0]));
                    largestV = Math.max(largestV, Math.abs(vertexPx[1] - centrePx[1]));
                }
            }
        }
        stdPx[stdAt] = largestU;
        stdPx[stdAt + 1] = largestV;
        return true;
    }

    private static boolean isIdeal(double[] intrinsics) {
        return intrinsics[PinholeCamera.K1] == 0 && intrinsics[PinholeCamera.K2] == 0
                && intrinsics[PinholeCamera.K3] == 0 && intrinsics[PinholeCamera.P1] == 0
                && intrinsics[PinholeCamera.P2] == 0 && intrinsics[PinholeCamera.SKEW] == 0;
    }

    /** The same without distortion, where a vertex takes one division: most of the time of this likelihood goes here. */
    private static boolean idealStdPx(double[] r, double cx, double cy, double cz, double hx, double hy, double hz,
            double[] intrinsics, double[] stdPx, int stdAt) {
        double u0 = cx / cz;
        double v0 = cy / cz;
        double xx = hx * r[0];
        double xy = hx * r[3];
        double xz = hx * r[6];
        double yx = hy * r[1];
        double yy = hy * r[4];
        double yz = hy * r[7];
        double zx = hz * r[2];
        double zy = hz * r[5];
        double zz = hz * r[8];
        // the vertex nearest to the camera decides whether all are in front of it
        if (!(cz - Math.abs(xz) - Math.abs(yz) - Math.abs(zz) > 0)) {
            return false;
        }
        double largestU = 0;
        double largestV = 0;
        // four pairs of opposite vertices
        for (int pair = 0; pair < 4; pair++) {
            double signY = (pair & 1) == 0 ? 1 : -1;
            double signZ = (pair & 2) == 0 ? 1 : -1;
            double dx = xx + signY * yx + signZ * zx;
            double dy = xy + signY * yy + signZ * zy;
            double dz = xz + signY * yz + signZ * zz;
            double near = 1 / (cz + dz);
            double far = 1 / (cz - dz);
            largestU = Math.max(largestU, Math.max(Math.abs((cx + dx) * near - u0), Math.abs((cx - dx) * far - u0)));
            largestV = Math.max(largestV, Math.max(Math.abs((cy + dy) * near - v0), Math.abs((cy - dy) * far - v0)));
        }
        stdPx[stdAt] = intrinsics[PinholeCamera.FX] * largestU;
        stdPx[stdAt + 1] = intrinsics[PinholeCamera.FY] * largestV;
        return true;
    }
}
