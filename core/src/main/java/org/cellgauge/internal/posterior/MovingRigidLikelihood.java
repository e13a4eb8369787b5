package org.cellgauge.internal.posterior;

import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.pose.AddedNoise;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceNoise;
import org.cellgauge.internal.pose.ReferenceView;

/**
 * Likelihood of rigidly misplaced references with covariances that move with the pose: what
 * {@link RigidMarkerLikelihood} freezes at a mode is found anew at every state, and only the placement errors d_m about
 * which it is linear are kept:
 *
 * <p>{@code log L = sum_m [ -log det L_m - |L_m^-1 r_m|² / 2 ]}, {@code L_m L_m^T = J_m S J_m^T + C_m}, {@code r_m =
 * projection(d_m) - J_m d_m - observed}, J_m the derivative at the state.
 *
 * <p>For posteriors that reach far: with an unknown focal length, camera and references may stand a tenth nearer or
 * farther, by which the room that corners leave for the depth of every reference grows, and what a millimetre of it is
 * in the image shrinks. Frozen, focal lengths of simulated photos came out 0.6 stated deviations too short (references
 * placed to 20 mm). It costs some thirty times as much. Allocates nothing but once for every step of an unknown noise;
 * not thread-safe.
 */
public final class MovingRigidLikelihood implements CameraLikelihood {
    private final ReferenceView view;
    private final ReferenceNoise noise;
    private final CornerErrors errors;
    private final double[] points;
    private final double[] placed;
    private final double[] observed;
    private final double[] columns;
    private final int unknowns;
    private final double[][] ofNode = new double[AddedNoise.NODES][];
    private final double[] jacobian = new double[48];
    private final double[] covariance = new double[64];
    private final double[] pixel = new double[64];
    private final double[] residuals = new double[8];
    private final double[] uv = new double[2];

    /**
     * A likelihood.
     *
     * @param view references and their observed corners
     * @param mode a mode of the camera pose that shows them; its placement errors are linearised about
     * @param noise of the view, with rigid placement
     * @param errors errors of these corners, with an added noise that the state has; null where it is that of
     *     {@code noise}
     */
    public MovingRigidLikelihood(ReferenceView view, PoseMode mode, ReferenceNoise noise, CornerErrors errors) {
        this.view = view;
        this.noise = noise.about(mode.placed());
        this.errors = errors;
        points = mode.pointsMm();
        placed = mode.placed().errors();
        observed = view.observedPx();
        columns = view.columnsPx();
        unknowns = view.unknowns();
    }

    @Override
    public double at(CameraState state) {
        double[] r = state.rotation;
        double[] added = errors == null ? null : corners(AddedNoise.node(state.noise));
        double sum = 0;
        for (int m = 0; m < view.size(); m++) {
            if (!noise.covariance(state, m, covariance, pixel) || !noise.placementJacobian(state, m, jacobian)) {
                return Double.NEGATIVE_INFINITY;
            }
            for (int i = 0; i < 64; i++) {
                covariance[i] += added == null ? pixel[i] : added[64 * m + i];
            }
            for (int k = 0; k < 4; k++) {
                int p = 12 * m + 3 * k;
                double x = points[p];
                double y = points[p + 1];
                double z = points[p + 2];
                if (!state.lens.project(state.intrinsics, r[0] * x + r[1] * y + r[2] * z + state.offset[0],
                        r[3] * x + r[4] * y + r[5] * z + state.offset[1],
                        r[6] * x + r[7] * y + r[8] * z + state.offset[2], uv, 0)) {
                    return Double.NEGATIVE_INFINITY;
                }
                residuals[2 * k] = uv[0];
                residuals[2 * k + 1] = uv[1];
            }
            for (int i = 0; i < 8; i++) {
                double residual = residuals[i] - observed[8 * m + i];
                for (int c = 0; c < 6; c++) {
                    residual -= jacobian[6 * i + c] * placed[6 * m + c];
                }
                for (int j = 0; j < unknowns; j++) {
                    residual += columns[(8 * m + i) * unknowns + j] * state.unknowns[j];
                }
                residuals[i] = residual;
            }
            if (!Cholesky.factor(covariance, 8)) {
                return Double.NEGATIVE_INFINITY;
            }
            Cholesky.solveLower(covariance, 8, residuals);
            sum -= Cholesky.halfLogDeterminant(covariance, 8);
            for (double s : residuals) {
                sum -= 0.5 * s * s;
            }
        }
        return Double.isNaN(sum) ? Double.NEGATIVE_INFINITY : sum;
    }

    /** Covariances of the corners' own errors at a node of the added noise, 64 values per reference. */
    private double[] corners(int node) {
        if (ofNode[node] == null) {
            double[] made = new double[64 * view.size()];
            for (int m = 0; m < view.size(); m++) {
                errors.covariance(view.references().get(m).id(), AddedNoise.atNode(node), pixel);
                System.arraycopy(pixel, 0, made, 64 * m, 64);
            }
            ofNode[node] = made;
        }
        return ofNode[node];
    }
}
