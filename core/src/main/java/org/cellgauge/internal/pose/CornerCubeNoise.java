package org.cellgauge.internal.pose;

import java.util.Arrays;
import org.cellgauge.cell.Placement;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;

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
        double[] centres = new double[8];
        if (!markerStdPx(state, view.points(), 12 * marker, half, 0, centres, stdPx)) {
            return false;
        }
        for (int i = 0; i < 8; i++) {
            placementPx2[9 * i] = stdPx[i] * stdPx[i];
        }
        return true;
    }

    /**
     * Projects the four corners of a marker and the boxes around them. Allocates nothing.
     *
     * @param state pose and intrinsics
     * @param points corners relative to the centre of the set, world axes, mm
     * @param at index of the first corner's x in {@code points}
     * @param half half extents of the box along the world axes, mm
     * @param halfAt index of the x extent in {@code half}
     * @param centresPx receives the projected corners, 8 values
     * @param stdPx receives the deviations in u and v of each corner, 8 values
     * @return false if the lens cannot see a corner or a vertex
     */
    public static boolean markerStdPx(CameraState state, double[] points, int at, double[] half, int halfAt,
            double[] centresPx, double[] stdPx) {
        double[] r = state.rotation;
        double[] intrinsics = state.intrinsics;
        Lens lens = state.lens;
        // image axes along those of the camera, and no lens that bends
        boolean ideal = !lens.isDistorting(intrinsics) && intrinsics[PinholeCamera.SKEW] == 0;
        boolean wide = lens.isWide();
        double hx = half[halfAt];
        double hy = half[halfAt + 1];
        double hz = half[halfAt + 2];
        // half edges of the box in the camera frame
        double xx = hx * r[0];
        double xy = hx * r[3];
        double xz = hx * r[6];
        double yx = hy * r[1];
        double yy = hy * r[4];
        double yz = hy * r[7];
        double zx = hz * r[2];
        double zy = hz * r[5];
        double zz = hz * r[8];
        // depths of the vertices of one half from the corner; the other half is opposite
        double d0 = Math.abs(xz + yz + zz);
        double d1 = Math.abs(xz - yz + zz);
        double d2 = Math.abs(xz + yz - zz);
        double d3 = Math.abs(xz - yz - zz);
        double deepest = Math.max(Math.max(d0, d1), Math.max(d2, d3));
        for (int k = 0, p = at; k < 8; k += 2, p += 3) {
            double x = points[p];
            double y = points[p + 1];
            double z = points[p + 2];
            double cx = r[0] * x + r[1] * y + r[2] * z + state.offset[0];
            double cy = r[3] * x + r[4] * y + r[5] * z + state.offset[1];
            double cz = r[6] * x + r[7] * y + r[8] * z + state.offset[2];
            // the vertex nearest to the camera decides whether all are in front of it
            if (!wide && !(cz - deepest > 0)) {
                return false;
            }
            if (!ideal) {
                boolean seen = lens.project(intrinsics, cx, cy, cz, centresPx, k);
                stdPx[k] = 0;
                stdPx[k + 1] = 0;
                for (int i = -1; i <= 1; i += 2) {
                    for (int j = -1; j <= 1; j += 2) {
                        seen = seen && widen(lens, intrinsics, cx + xx + i * yx + j * zx, cy + xy + i * yy + j * zy,
                                cz + xz + i * yz + j * zz, centresPx, stdPx, k);
                        seen = seen && widen(lens, intrinsics, cx - xx - i * yx - j * zx, cy - xy - i * yy - j * zy,
                                cz - xz - i * yz - j * zz, centresPx, stdPx, k);
                    }
                }
                if (!seen) {
                    return false;
                }
                continue;
            }
            double inverse = 1 / cz;
            double u = cx * inverse;
            double v = cy * inverse;
            // with (dx, dy, dz) from corner to vertex: (cx + dx) / (cz + dz) - u = (dx - u dz) / (cz + dz); of two
            // opposite vertices the nearer one is farther off in the image, so that each pair takes one division
            double n0 = 1 / (cz - d0);
            double n1 = 1 / (cz - d1);
            double n2 = 1 / (cz - d2);
            double n3 = 1 / (cz - d3);
            stdPx[k] = intrinsics[PinholeCamera.FX] * largest(xx - u * xz, yx - u * yz, zx - u * zz, n0, n1, n2, n3);
            stdPx[k + 1] = intrinsics[PinholeCamera.FY]
                    * largest(xy - v * xz, yy - v * yz, zy - v * zz, n0, n1, n2, n3);
            centresPx[k] = intrinsics[PinholeCamera.FX] * u + intrinsics[PinholeCamera.CX];
            centresPx[k + 1] = intrinsics[PinholeCamera.FY] * v + intrinsics[PinholeCamera.CY];
        }
        return true;
    }

    private static double largest(double a, double b, double c, double n0, double n1, double n2, double n3) {
        double plus = a + c;
        double minus = a - c;
        return Math.max(Math.max(Math.abs(plus + b) * n0, Math.abs(plus - b) * n1),
                Math.max(Math.abs(minus + b) * n2, Math.abs(minus - b) * n3));
    }

    /** Widens the deviations of a corner to one vertex through a lens with distortion. */
    private static boolean widen(Lens lens, double[] intrinsics, double x, double y, double z, double[] centresPx,
            double[] stdPx, int k) {
        double u = centresPx[k];
        double v = centresPx[k + 1];
        if (!lens.project(intrinsics, x, y, z, centresPx, k)) {
            return false;
        }
        stdPx[k] = Math.max(stdPx[k], Math.abs(centresPx[k] - u));
        stdPx[k + 1] = Math.max(stdPx[k + 1], Math.abs(centresPx[k + 1] - v));
        centresPx[k] = u;
        centresPx[k + 1] = v;
        return true;
    }
}
