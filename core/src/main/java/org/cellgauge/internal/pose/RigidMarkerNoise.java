package org.cellgauge.internal.pose;

import java.util.Arrays;

/**
 * Residual covariance of rigidly misplaced references: {@code J S J^T + C}, C the covariance of the corners' own errors
 * ({@code sigma² I} where their noise is one stated deviation) and S the covariance of the
 * placement error (translation along the world axes, rotation about the marker's own centre) and J the derivative of
 * the projected corners by it, 8x6 in one view and of the corners in all of them in several. It is what remains when
 * six Gaussian nuisance parameters per reference are integrated out of a linearised model (Gelman et al., "Bayesian
 * Data Analysis", 3rd ed. 2013, section 14.2). It is linearised where the references are taken to stand ({@link
 * PlacedReferences}): at their nominal places unless stated otherwise.
 *
 * <p>Not thread-safe: it holds scratch arrays.
 */
public final class RigidMarkerNoise implements ReferenceNoise {
    private final Observations view;
    private final PlacedReferences placed;
    private final double pixelStdPx;
    private final CornerErrors errors;
    private final double noise;
    private final double[] uv = new double[2];
    private final double[] byPoint = new double[6];
    private final double[] jacobian;
    private final double[] rooted;

    /**
     * The noise of a view.
     *
     * @param view references with their placement precision
     * @param pixelStdPx standard deviation of each corner coordinate, px, positive
     * @throws IllegalArgumentException if the deviation is not positive
     */
    public RigidMarkerNoise(Observations view, double pixelStdPx) {
        if (!(pixelStdPx > 0)) {
            throw new IllegalArgumentException("pixel deviation must be positive, not " + pixelStdPx);
        }
        this.view = view;
        this.placed = PlacedReferences.nominal(view);
        this.pixelStdPx = pixelStdPx;
        errors = null;
        noise = 0;
        jacobian = new double[StateLayout.POSE * view.blocks().mostRows()];
        rooted = jacobian.clone();
    }

    /**
     * The noise of a view whose corners have covariances of their own.
     *
     * @param view references with their placement precision
     * @param errors errors of the corners
     * @param noise the u of their added noise; ignored where it is stated
     */
    public RigidMarkerNoise(ReferenceView view, CornerErrors errors, double noise) {
        this.view = view;
        this.placed = PlacedReferences.nominal(view);
        this.errors = errors.isPlain() ? null : errors;
        this.noise = noise;
        pixelStdPx = errors.statedStdPx();
        jacobian = new double[StateLayout.POSE * view.blocks().mostRows()];
        rooted = jacobian.clone();
    }

    private RigidMarkerNoise(RigidMarkerNoise other, PlacedReferences placed) {
        this.view = other.view;
        this.placed = placed;
        this.pixelStdPx = other.pixelStdPx;
        this.errors = other.errors;
        this.noise = other.noise;
        jacobian = other.jacobian.clone();
        rooted = jacobian.clone();
    }

    @Override
    public RigidMarkerNoise about(PlacedReferences other) {
        return new RigidMarkerNoise(this, other);
    }

    @Override
    public boolean hasRigidPlacement() {
        return true;
    }

    @Override
    public boolean placementJacobian(CameraState state, int marker, double[] out) {
        return jacobian(state, marker, out);
    }

    @Override
    public boolean covariance(CameraState state, int marker, double[] placementPx2, double[] pixelPx2) {
        if (!jacobian(state, marker, jacobian)) {
            return false;
        }
        int rows = view.blocks().rows(marker);
        Body body = view.bodies().get(marker);
        if (body.isIndependentlyPlaced()) {
            independent(body, rows, placementPx2);
        } else {
            correlated(body, rows, placementPx2);
        }
        if (errors != null) {
            errors.covariance(body.id(), noise, pixelPx2);
            return true;
        }
        Arrays.fill(pixelPx2, 0, rows * rows, 0);
        for (int i = 0; i < rows; i++) {
            pixelPx2[(rows + 1) * i] = pixelStdPx * pixelStdPx;
        }
        return true;
    }

    /**
     * The part by placement whose coordinates are independent; written out, as it is done for every state of a chain.
     */
    private void independent(Body body, int rows, double[] placementPx2) {
        double[] j = jacobian;
        double s0 = body.placementRoot(0, 0);
        double s1 = body.placementRoot(1, 1);
        double s2 = body.placementRoot(2, 2);
        double s3 = body.placementRoot(3, 3);
        double s4 = body.placementRoot(4, 4);
        double s5 = body.placementRoot(5, 5);
        for (int i = 0; i < rows; i++) {
            int a = 6 * i;
            double j0 = j[a];
            double j1 = j[a + 1];
            double j2 = j[a + 2];
            double j3 = j[a + 3];
            double j4 = j[a + 4];
            double j5 = j[a + 5];
            for (int k = 0, b = 0; k <= i; k++, b += 6) {
                double s = j0 * j[b] * s0 * s0 + j1 * j[b + 1] * s1 * s1 + j2 * j[b + 2] * s2 * s2
                        + j3 * j[b + 3] * s3 * s3 + j4 * j[b + 4] * s4 * s4 + j5 * j[b + 5] * s5 * s5;
                placementPx2[rows * i + k] = s;
                placementPx2[rows * k + i] = s;
            }
        }
    }

    /** The part by placement as {@code (J L) (J L)^T}, L the root of a covariance that is not diagonal. */
    private void correlated(Body body, int rows, double[] placementPx2) {
        for (int i = 0; i < rows; i++) {
            for (int a = 0; a < 6; a++) {
                double s = 0;
                for (int k = a; k < 6; k++) {
                    s += jacobian[6 * i + k] * body.placementRoot(k, a);
                }
                rooted[6 * i + a] = s;
            }
            for (int j = 0; j <= i; j++) {
                double s = 0;
                for (int a = 0; a < 6; a++) {
                    s += rooted[6 * i + a] * rooted[6 * j + a];
                }
                placementPx2[rows * i + j] = s;
                placementPx2[rows * j + i] = s;
            }
        }
    }

    @Override
    public double noise() {
        return noise;
    }

    /**
     * Derivative of the projected points of one body, in all views that show it, by its placement error.
     *
     * @param state poses and intrinsics
     * @param marker index of the body
     * @param out coordinates x 6 row by row, of a marker in one view 8x6: (u, v) of each point by (translation along
     *     world x, y, z in mm; rotation vector about the body's origin in world axes, rad)
     * @return false if a point is not in front of a camera
     */
    public boolean jacobian(CameraState state, int marker, double[] out) {
        BlockLayout blocks = view.blocks();
        double[] r = state.rotation;
        double[] points = placed.points();
        double[] arms = placed.arms();
        double[] t = placed.turns();
        int turn = 9 * marker;
        int first = 3 * blocks.firstPoint(marker);
        int end = 3 * blocks.firstPoint(marker + 1);
        int o = 0;
        for (int time = 0; time < blocks.timesSeen(marker); time++) {
            int v = 3 * blocks.view(marker, time);
            double r0 = r[3 * v];
            double r1 = r[3 * v + 1];
            double r2 = r[3 * v + 2];
            double r3 = r[3 * v + 3];
            double r4 = r[3 * v + 4];
            double r5 = r[3 * v + 5];
            double r6 = r[3 * v + 6];
            double r7 = r[3 * v + 7];
            double r8 = r[3 * v + 8];
            for (int at = first; at < end; at += 3) {
                double x = points[at];
                double y = points[at + 1];
                double z = points[at + 2];
                if (!state.lens.projectWithDerivatives(state.intrinsics,
                        r0 * x + r1 * y + r2 * z + state.offset[v],
                        r3 * x + r4 * y + r5 * z + state.offset[v + 1],
                        r6 * x + r7 * y + r8 * z + state.offset[v + 2], uv, byPoint, null)) {
                    return false;
                }
                for (int b = 0; b < 6; b += 3, o += 6) {
                    double gx = byPoint[b] * r0 + byPoint[b + 1] * r3 + byPoint[b + 2] * r6;
                    double gy = byPoint[b] * r1 + byPoint[b + 1] * r4 + byPoint[b + 2] * r7;
                    double gz = byPoint[b] * r2 + byPoint[b + 1] * r5 + byPoint[b + 2] * r8;
                    out[o] = gx;
                    out[o + 1] = gy;
                    out[o + 2] = gz;
                    // a small rotation e moves the point by e x arm, so its derivative is arm x gradient
                    double ex = arms[at + 1] * gz - arms[at + 2] * gy;
                    double ey = arms[at + 2] * gx - arms[at] * gz;
                    double ez = arms[at] * gy - arms[at + 1] * gx;
                    // and a change dw of the rotation vector turns by e = T dw, T its left Jacobian
                    for (int c = 0; c < 3; c++) {
                        out[o + 3 + c] = ex * t[turn + c] + ey * t[turn + 3 + c] + ez * t[turn + 6 + c];
                    }
                }
            }
        }
        return true;
    }
}
