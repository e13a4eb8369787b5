package org.cellgauge.internal.posterior;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.pose.AddedNoise;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceView;
import org.jspecify.annotations.Nullable;

/**
 * Likelihood of rigidly misplaced references: the residuals of each reference are Gaussian with the covariance of
 * {@link org.cellgauge.internal.pose.RigidMarkerNoise}, frozen at the posterior's own mode.
 *
 * <p>{@code log L = sum_m [ sum_i log W_m,ii - |W_m r_m|² / 2 ]}, W_m the whitening matrix of reference m; the
 * log-determinant is kept, so that modes with different frozen covariances can be compared. Placement errors d are
 * linearised at those of the mode, d_m: the residual is {@code projection(d_m) - J_m d_m - observed}, which has the
 * same distribution and costs the same, for what is added to the observed corners is frozen as well.
 *
 * <p>Whitened once (with an unknown noise: once for every step of it) and not factored in the loop; allocates nothing
 * then. Unknowns that markers share move the residuals along their columns; along {@link LooseAxes} references are
 * linear about places that move with the camera. Not thread-safe.
 */
public final class RigidMarkerLikelihood implements CameraLikelihood {
    private static final int PACKED = NoiseWhitening.PACKED;

    private final double[] points;
    private final double[] observed;
    private final double[] columns;
    private final int unknowns;
    private final double[] stated;
    private final double logDeterminant;
    private final @Nullable NoiseWhitening noise;
    private final @Nullable LooseAxes loose;
    private final double[] byShift;
    private final double[] shift;
    private final double[] offset = new double[3];
    private final double[] residuals = new double[8];
    private final double[] uv = new double[2];

    /**
     * A likelihood.
     *
     * @param view references and their observed corners
     * @param whitening 64 values per reference, lower triangular 8x8 row by row, 1/px; copied
     */
    public RigidMarkerLikelihood(ReferenceView view, double[] whitening) {
        this(view, view.pointsMm(), view.observedPx(), whitening, null);
    }

    /**
     * The likelihood frozen at a mode: corners where its placement errors have moved them, and its whitening.
     *
     * @param view references and their observed corners
     * @param mode a mode of the camera pose that shows them
     */
    public RigidMarkerLikelihood(ReferenceView view, PoseMode mode) {
        this(view, mode.pointsMm(), mode.comparedPx(), mode.whitening(), mode);
    }

    private RigidMarkerLikelihood(ReferenceView view, double[] points, double[] observed, double[] whitening,
            @Nullable PoseMode mode) {
        this.points = points;
        this.observed = observed;
        loose = mode == null ? null : loose(view, mode);
        shift = new double[loose == null ? 0 : loose.count()];
        byShift = loose == null || mode == null ? shift : loose.columns(points, mode.state());
        columns = view.columnsPx();
        unknowns = view.unknowns();
        noise = null;
        int markers = view.size();
        if (whitening.length != 64 * markers) {
            throw new IllegalArgumentException("needs 64 whitening values per reference");
        }
        stated = new double[PACKED * markers];
        double sum = 0;
        for (int m = 0; m < markers; m++) {
            int at = PACKED * m;
            for (int i = 0; i < 8; i++) {
                for (int j = 0; j <= i; j++) {
                    stated[at++] = whitening[64 * m + 8 * i + j];
                }
                sum += Math.log(whitening[64 * m + 9 * i]);
            }
        }
        logDeterminant = sum;
    }

    /**
     * The likelihood frozen at a mode, with an unknown noise: corners where the mode's placement errors have moved
     * them, and what placement adds to the covariances there.
     *
     * @param view references and their observed corners
     * @param mode a mode of the camera pose that shows them, at any added noise
     * @param errors errors of these corners, with an added noise
     */
    public RigidMarkerLikelihood(ReferenceView view, PoseMode mode, CornerErrors errors) {
        points = mode.pointsMm();
        observed = mode.comparedPx();
        loose = loose(view, mode);
        shift = new double[loose == null ? 0 : loose.count()];
        byShift = loose == null ? shift : loose.columns(points, mode.state());
        columns = view.columnsPx();
        unknowns = view.unknowns();
        stated = new double[0];
        logDeterminant = 0;
        List<Integer> ids = new ArrayList<>();
        view.references().forEach(r -> ids.add(r.id()));
        noise = new NoiseWhitening(errors, ids, mode.placementPx2());
    }

    private static @Nullable LooseAxes loose(ReferenceView view, PoseMode mode) {
        LooseAxes axes = new LooseAxes(view, mode);
        return axes.count() == 0 ? null : axes;
    }

    @Override
    public double at(CameraState state) {
        double[] r = state.rotation;
        double[] intrinsics = state.intrinsics;
        double[] t = state.offset;
        if (loose != null) {
            loose.shift(state, shift, offset);
            t = offset;
        }
        double tx = t[0];
        double ty = t[1];
        double tz = t[2];
        Lens lens = state.lens;
        // a skew is rare; written out as well it would cost every likelihood a tenth
        boolean written = !lens.isDistorting(intrinsics) && intrinsics[PinholeCamera.SKEW] == 0;
        double fx = intrinsics[PinholeCamera.FX];
        double fy = intrinsics[PinholeCamera.FY];
        double cx = intrinsics[PinholeCamera.CX];
        double cy = intrinsics[PinholeCamera.CY];
        double[] packed = stated;
        double logDiagonal = logDeterminant;
        if (noise != null) {
            int node = AddedNoise.node(state.noise);
            packed = noise.at(node);
            logDiagonal = noise.logDeterminant(node);
        }
        double squares = 0;
        for (int p = 0, o = 0, w = 0; p < points.length; o += 8, w += PACKED) {
            for (int k = 0; k < 8; k += 2, p += 3) {
                double px = points[p];
                double py = points[p + 1];
                double pz = points[p + 2];
                double x = r[0] * px + r[1] * py + r[2] * pz + tx;
                double y = r[3] * px + r[4] * py + r[5] * pz + ty;
                double z = r[6] * px + r[7] * py + r[8] * pz + tz;
                if (!written) {
                    if (!lens.project(intrinsics, x, y, z, uv, 0)) {
                        return Double.NEGATIVE_INFINITY;
                    }
                    residuals[k] = uv[0] - observed[o + k];
                    residuals[k + 1] = uv[1] - observed[o + k + 1];
                } else {
                    if (!(z > 0)) {
                        return Double.NEGATIVE_INFINITY;
                    }
                    double inverseZ = 1 / z;
                    residuals[k] = fx * x * inverseZ + cx - observed[o + k];
                    residuals[k + 1] = fy * y * inverseZ + cy - observed[o + k + 1];
                }
            }
            if (unknowns > 0) {
                alongColumns(state.unknowns, o);
            }
            if (loose != null) {
                alongLooseAxes(o);
            }
            squares += whitenedSquares(packed, w);
        }
        double value = logDiagonal - 0.5 * squares;
        return Double.isNaN(value) ? Double.NEGATIVE_INFINITY : value;
    }

    /** Moves the residuals of the reference whose corners start at an index by what markers share. */
    private void alongColumns(double[] nu, int o) {
        for (int i = 0, c = o * unknowns; i < 8; i++) {
            double sum = 0;
            for (int j = 0; j < unknowns; j++) {
                sum += columns[c++] * nu[j];
            }
            residuals[i] += sum;
        }
    }

    /** The same by where the references have moved with the camera; a loop of its own, since it is rarely needed. */
    private void alongLooseAxes(int o) {
        for (int i = 0, c = o * shift.length; i < 8; i++) {
            for (double by : shift) {
                residuals[i] -= byShift[c++] * by;
            }
        }
    }

    /**
     * Squared length of the whitened residuals of the reference whose matrix starts at an index. Written out: with a
     * loop over rows of growing length the whole likelihood takes twice as long.
     */
    private double whitenedSquares(double[] m, int w) {
        double r0 = residuals[0];
        double r1 = residuals[1];
        double r2 = residuals[2];
        double r3 = residuals[3];
        double r4 = residuals[4];
        double r5 = residuals[5];
        double r6 = residuals[6];
        double r7 = residuals[7];
        double s0 = m[w] * r0;
        double s1 = m[w + 1] * r0 + m[w + 2] * r1;
        double s2 = m[w + 3] * r0 + m[w + 4] * r1 + m[w + 5] * r2;
        double s3 = m[w + 6] * r0 + m[w + 7] * r1 + m[w + 8] * r2 + m[w + 9] * r3;
        double s4 = m[w + 10] * r0 + m[w + 11] * r1 + m[w + 12] * r2 + m[w + 13] * r3 + m[w + 14] * r4;
        double s5 = m[w + 15] * r0 + m[w + 16] * r1 + m[w + 17] * r2 + m[w + 18] * r3 + m[w + 19] * r4 + m[w + 20] * r5;
        double s6 = m[w + 21] * r0 + m[w + 22] * r1 + m[w + 23] * r2 + m[w + 24] * r3 + m[w + 25] * r4 + m[w + 26] * r5
                + m[w + 27] * r6;
        double s7 = m[w + 28] * r0 + m[w + 29] * r1 + m[w + 30] * r2 + m[w + 31] * r3 + m[w + 32] * r4 + m[w + 33] * r5
                + m[w + 34] * r6 + m[w + 35] * r7;
        return s0 * s0 + s1 * s1 + s2 * s2 + s3 * s3 + s4 * s4 + s5 * s5 + s6 * s6 + s7 * s7;
    }
}
