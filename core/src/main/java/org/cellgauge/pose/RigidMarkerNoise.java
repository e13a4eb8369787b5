package org.cellgauge.pose;

import java.util.Arrays;
import org.cellgauge.cell.Placement;

/**
 * Residual covariance of rigidly misplaced references: {@code J S J^T + C}, C the covariance of the corners' own errors
 * ({@code sigma² I} where their noise is one stated deviation) and S the covariance of the
 * placement error (translation along the world axes, rotation about the marker's own centre) and J the 8x6 derivative
 * of the projected corners by it. It is what remains when six Gaussian nuisance parameters per reference are integrated
 * out of a linearised model (Gelman et al., "Bayesian Data Analysis", 3rd ed. 2013, section 14.2). It is linearised
 * where the references are taken to stand ({@link PlacedReferences}): at their nominal places unless stated otherwise.
 *
 * <p>Not thread-safe: it holds scratch arrays.
 */
public final class RigidMarkerNoise implements ReferenceNoise {
    private final ReferenceView view;
    private final PlacedReferences placed;
    private final double pixelStdPx;
    private final CornerErrors errors;
    private final double noise;
    private final double[] uv = new double[2];
    private final double[] byPoint = new double[6];
    private final double[] jacobian = new double[48];

    /**
     * The noise of a view.
     *
     * @param view references with their placement precision
     * @param pixelStdPx standard deviation of each corner coordinate, px, positive
     * @throws IllegalArgumentException if the deviation is not positive
     */
    public RigidMarkerNoise(ReferenceView view, double pixelStdPx) {
        if (!(pixelStdPx > 0)) {
            throw new IllegalArgumentException("pixel deviation must be positive, not " + pixelStdPx);
        }
        this.view = view;
        this.placed = PlacedReferences.nominal(view);
        this.pixelStdPx = pixelStdPx;
        errors = null;
        noise = 0;
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
    }

    private RigidMarkerNoise(RigidMarkerNoise other, PlacedReferences placed) {
        this.view = other.view;
        this.placed = placed;
        this.pixelStdPx = other.pixelStdPx;
        this.errors = other.errors;
        this.noise = other.noise;
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
        Placement placement = view.references().get(marker).placement();
        for (int i = 0; i < 8; i++) {
            for (int j = 0; j <= i; j++) {
                double s = 0;
                for (int k = 0; k < 6; k++) {
                    double std = k < 3 ? placement.stdMm(k) : placement.stdRad();
                    s += jacobian[6 * i + k] * jacobian[6 * j + k] * std * std;
                }
                placementPx2[8 * i + j] = s;
                placementPx2[8 * j + i] = s;
            }
        }
        if (errors != null) {
            errors.covariance(view.references().get(marker).id(), noise, pixelPx2);
            return true;
        }
        Arrays.fill(pixelPx2, 0);
        for (int i = 0; i < 8; i++) {
            pixelPx2[9 * i] = pixelStdPx * pixelStdPx;
        }
        return true;
    }

    @Override
    public double noise() {
        return noise;
    }

    /**
     * Derivative of the projected corners of one reference by its placement error.
     *
     * @param state pose and intrinsics
     * @param marker index of the reference
     * @param out 8x6 row by row: (u, v) of each corner by (translation along world x, y, z in mm; rotation vector about
     *     the marker's centre in world axes, rad)
     * @return false if a corner is not in front of the camera
     */
    public boolean jacobian(CameraState state, int marker, double[] out) {
        double[] r = state.rotation;
        double[] points = placed.points();
        double[] arms = placed.arms();
        double[] t = placed.turns();
        int turn = 9 * marker;
        for (int k = 0; k < 4; k++) {
            int at = 12 * marker + 3 * k;
            double x = points[at];
            double y = points[at + 1];
            double z = points[at + 2];
            if (!state.lens.projectWithDerivatives(state.intrinsics, r[0] * x + r[1] * y + r[2] * z + state.offset[0],
                    r[3] * x + r[4] * y + r[5] * z + state.offset[1], r[6] * x + r[7] * y + r[8] * z + state.offset[2],
                    uv, byPoint, null)) {
                return false;
            }
            for (int row = 0; row < 2; row++) {
                int b = 3 * row;
                int o = 6 * (2 * k + row);
                double gx = byPoint[b] * r[0] + byPoint[b + 1] * r[3] + byPoint[b + 2] * r[6];
                double gy = byPoint[b] * r[1] + byPoint[b + 1] * r[4] + byPoint[b + 2] * r[7];
                double gz = byPoint[b] * r[2] + byPoint[b + 1] * r[5] + byPoint[b + 2] * r[8];
                out[o] = gx;
                out[o + 1] = gy;
                out[o + 2] = gz;
                // a small rotation e moves the corner by e x arm, so its derivative is arm x gradient
                double ex = arms[at + 1] * gz - arms[at + 2] * gy;
                double ey = arms[at + 2] * gx - arms[at] * gz;
                double ez = arms[at] * gy - arms[at + 1] * gx;
                // and a change dw of the rotation vector turns by e = T dw, T its left Jacobian
                for (int c = 0; c < 3; c++) {
                    out[o + 3 + c] = ex * t[turn + c] + ey * t[turn + 3 + c] + ez * t[turn + 6 + c];
                }
            }
        }
        return true;
    }
}
