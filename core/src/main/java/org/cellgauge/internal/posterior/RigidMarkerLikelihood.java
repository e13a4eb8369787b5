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

    /** Corners of all references, each coordinate in an array of its own: a loop over them takes several at once. */
    private final double[] xs;
    private final double[] ys;
    private final double[] zs;
    private final double[] observedU;
    private final double[] observedV;
    private final double[] columns;
    private final int unknowns;
    private final double[] stated;
    private final double logDeterminant;
    private final @Nullable NoiseWhitening noise;
    private final @Nullable LooseAxes loose;
    private final double[] byShift;
    private final double[] shift;
    private final double[] offset = new double[3];
    /** Residuals of all corners and how far before the camera they are, of the state looked at. */
    private final double[] residualU;
    private final double[] residualV;
    private final double[] depth;
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
        this(view, points, observed, mode, packed(whitening, view.size()), logDeterminant(whitening), null);
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
        this(view, mode.pointsMm(), mode.comparedPx(), mode, new double[0], 0,
                new NoiseWhitening(errors, ids(view), mode.placementPx2()));
    }

    private RigidMarkerLikelihood(ReferenceView view, double[] points, double[] observed, @Nullable PoseMode mode,
            double[] stated, double logDeterminant, @Nullable NoiseWhitening noise) {
        int corners = 4 * view.size();
        xs = coordinate(points, 0, 3);
        ys = coordinate(points, 1, 3);
        zs = coordinate(points, 2, 3);
        observedU = coordinate(observed, 0, 2);
        observedV = coordinate(observed, 1, 2);
        residualU = new double[corners];
        residualV = new double[corners];
        depth = new double[corners];
        loose = mode == null ? null : loose(view, mode);
        shift = new double[loose == null ? 0 : loose.count()];
        byShift = loose == null || mode == null ? shift : loose.columns(points, mode.state());
        columns = view.columnsPx();
        unknowns = view.unknowns();
        this.stated = stated;
        this.logDeterminant = logDeterminant;
        this.noise = noise;
    }

    /** The lower triangles of all references, one after the other. */
    private static double[] packed(double[] whitening, int markers) {
        if (whitening.length != 64 * markers) {
            throw new IllegalArgumentException("needs 64 whitening values per reference");
        }
        double[] out = new double[PACKED * markers];
        int at = 0;
        for (int m = 0; m < markers; m++) {
            for (int i = 0; i < 8; i++) {
                for (int j = 0; j <= i; j++) {
                    out[at++] = whitening[64 * m + 8 * i + j];
                }
            }
        }
        return out;
    }

    private static double logDeterminant(double[] whitening) {
        double sum = 0;
        for (int m = 0; m < whitening.length / 64; m++) {
            for (int i = 0; i < 8; i++) {
                sum += Math.log(whitening[64 * m + 9 * i]);
            }
        }
        return sum;
    }

    private static List<Integer> ids(ReferenceView view) {
        List<Integer> ids = new ArrayList<>();
        view.references().forEach(r -> ids.add(r.id()));
        return ids;
    }

    /** Every so manieth value from the first one asked for on. */
    private static double[] coordinate(double[] values, int first, int every) {
        double[] out = new double[values.length / every];
        for (int i = 0; i < out.length; i++) {
            out[i] = values[every * i + first];
        }
        return out;
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
        Lens lens = state.lens;
        // a skew is rare; written out as well it would cost every likelihood a tenth
        boolean seen = !lens.isDistorting(intrinsics) && intrinsics[PinholeCamera.SKEW] == 0
                ? project(r, t, intrinsics) : project(lens, r, t, intrinsics);
        if (!seen) {
            return Double.NEGATIVE_INFINITY;
        }
        double[] packed = stated;
        double logDiagonal = logDeterminant;
        if (noise != null) {
            int node = AddedNoise.node(state.noise);
            packed = noise.at(node);
            logDiagonal = noise.logDeterminant(node);
        }
        double squares = 0;
        int references = depth.length / 4;
        for (int m = 0; m < references; m++) {
            if (unknowns > 0) {
                alongColumns(state.unknowns, 4 * m);
            }
            if (loose != null) {
                alongLooseAxes(4 * m);
            }
            int w = PACKED * m;
            squares += withLastSquares(firstSquares(packed, w, 4 * m), packed, w, 4 * m);
        }
        double value = logDiagonal - 0.5 * squares;
        return Double.isNaN(value) ? Double.NEGATIVE_INFINITY : value;
    }

    /** Residuals of all corners of a lens that does not distort; false where one is not in front of the camera. */
    private boolean project(double[] r, double[] t, double[] intrinsics) {
        double r0 = r[0];
        double r1 = r[1];
        double r2 = r[2];
        double r3 = r[3];
        double r4 = r[4];
        double r5 = r[5];
        double r6 = r[6];
        double r7 = r[7];
        double r8 = r[8];
        double tx = t[0];
        double ty = t[1];
        double tz = t[2];
        double fx = intrinsics[PinholeCamera.FX];
        double fy = intrinsics[PinholeCamera.FY];
        double cx = intrinsics[PinholeCamera.CX];
        double cy = intrinsics[PinholeCamera.CY];
        // no branch, so that the processor takes several corners at once
        for (int i = 0; i < depth.length; i++) {
            double x = r0 * xs[i] + r1 * ys[i] + r2 * zs[i] + tx;
            double y = r3 * xs[i] + r4 * ys[i] + r5 * zs[i] + ty;
            double z = r6 * xs[i] + r7 * ys[i] + r8 * zs[i] + tz;
            double inverseZ = 1 / z;
            depth[i] = z;
            residualU[i] = fx * x * inverseZ + cx - observedU[i];
            residualV[i] = fy * y * inverseZ + cy - observedV[i];
        }
        for (double z : depth) {
            if (!(z > 0)) {
                return false;
            }
        }
        return true;
    }

    /** The same of any lens. */
    private boolean project(Lens lens, double[] r, double[] t, double[] intrinsics) {
        for (int i = 0; i < depth.length; i++) {
            if (!lens.project(intrinsics, r[0] * xs[i] + r[1] * ys[i] + r[2] * zs[i] + t[0],
                    r[3] * xs[i] + r[4] * ys[i] + r[5] * zs[i] + t[1],
                    r[6] * xs[i] + r[7] * ys[i] + r[8] * zs[i] + t[2], uv, 0)) {
                return false;
            }
            residualU[i] = uv[0] - observedU[i];
            residualV[i] = uv[1] - observedV[i];
        }
        return true;
    }

    /** Moves the residuals of the reference whose corners start at an index by what markers share. */
    private void alongColumns(double[] nu, int corner) {
        for (int k = corner, c = 2 * corner * unknowns; k < corner + 4; k++, c += 2 * unknowns) {
            residualU[k] += along(columns, c, nu);
            residualV[k] += along(columns, c + unknowns, nu);
        }
    }

    private static double along(double[] row, int first, double[] by) {
        double sum = 0;
        for (int j = 0; j < by.length; j++) {
            sum += row[first + j] * by[j];
        }
        return sum;
    }

    /** The same by where the references have moved with the camera; a loop of its own, since it is rarely needed. */
    private void alongLooseAxes(int corner) {
        for (int k = corner, c = 2 * corner * shift.length; k < corner + 4; k++) {
            for (double by : shift) {
                residualU[k] -= byShift[c++] * by;
            }
            for (double by : shift) {
                residualV[k] -= byShift[c++] * by;
            }
        }
    }

    /**
     * Squared length of the first six whitened residuals of the reference whose matrix and corners start at these
     * indices. Written out: with a loop over rows of growing length the whole likelihood takes twice as long. In two
     * methods, since the compiler puts none of more than 325 bytes into the loop that calls it.
     */
    private double firstSquares(double[] m, int w, int corner) {
        double r0 = residualU[corner];
        double r1 = residualV[corner];
        double r2 = residualU[corner + 1];
        double r3 = residualV[corner + 1];
        double r4 = residualU[corner + 2];
        double r5 = residualV[corner + 2];
        double s0 = m[w] * r0;
        double s1 = m[w + 1] * r0 + m[w + 2] * r1;
        double s2 = m[w + 3] * r0 + m[w + 4] * r1 + m[w + 5] * r2;
        double s3 = m[w + 6] * r0 + m[w + 7] * r1 + m[w + 8] * r2 + m[w + 9] * r3;
        double s4 = m[w + 10] * r0 + m[w + 11] * r1 + m[w + 12] * r2 + m[w + 13] * r3 + m[w + 14] * r4;
        double s5 = m[w + 15] * r0 + m[w + 16] * r1 + m[w + 17] * r2 + m[w + 18] * r3 + m[w + 19] * r4 + m[w + 20] * r5;
        return s0 * s0 + s1 * s1 + s2 * s2 + s3 * s3 + s4 * s4 + s5 * s5;
    }

    /** The same with the last two added. */
    private double withLastSquares(double first, double[] m, int w, int corner) {
        double r0 = residualU[corner];
        double r1 = residualV[corner];
        double r2 = residualU[corner + 1];
        double r3 = residualV[corner + 1];
        double r4 = residualU[corner + 2];
        double r5 = residualV[corner + 2];
        double r6 = residualU[corner + 3];
        double s6 = m[w + 21] * r0 + m[w + 22] * r1 + m[w + 23] * r2 + m[w + 24] * r3 + m[w + 25] * r4 + m[w + 26] * r5
                + m[w + 27] * r6;
        double s7 = m[w + 28] * r0 + m[w + 29] * r1 + m[w + 30] * r2 + m[w + 31] * r3 + m[w + 32] * r4 + m[w + 33] * r5
                + m[w + 34] * r6 + m[w + 35] * residualV[corner + 3];
        return first + s6 * s6 + s7 * s7;
    }
}
