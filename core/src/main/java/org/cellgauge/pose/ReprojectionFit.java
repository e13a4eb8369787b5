package org.cellgauge.pose;

import org.cellgauge.geometry.Cholesky;
import org.cellgauge.geometry.PinholeCamera;

/**
 * Least squares fit of a pose, and of unknown intrinsics, to image corners: damped Gauss-Newton in the centred chart.
 *
 * <p>Minimises {@code |r|²/2}, r stacking per marker {@code W (projected - observed)} with W the whitening matrix
 * (inverse of the Cholesky factor of the residual covariance), one row per unknown intrinsic, one per unknown that
 * markers share ({@link CornerErrors}: observed corners less their columns count) and six per pose prior.
 * Damping is Marquardt's with Nielsen's update of the factor (Madsen, Nielsen, Tingleff, "Methods for non-linear least
 * squares problems", 2nd ed. 2004, algorithm 3.16).
 *
 * <p>Not thread-safe: it holds scratch arrays, so that a fit repeated for many draws allocates nothing.
 */
public final class ReprojectionFit {
    private static final int MAX_STEPS = 200;
    private static final double STEP_TOLERANCE = 1e-9;

    private final double[] points;
    private final double[] observed;
    private final IntrinsicsPrior intrinsicsPrior;
    private final PosePrior posePrior;
    private final double[] byUnknowns;
    private final int unknowns;
    private final int markers;
    private final int columns;
    private final int rows;
    private final double[] whitening;
    private final double[] placement;
    private final double[] residuals;
    private final double[] jacobian;
    private final double[] information;
    private final double[] damped;
    private final double[] gradient;
    private final double[] step;
    private final CameraState candidate = new CameraState();
    private final double[] uv = new double[2];
    private final double[] byPoint = new double[6];
    private double[] byIntrinsics = {};
    private final double[] plainResiduals = new double[8];
    private final double[] plainJacobian;

    /**
     * A fit.
     *
     * @param points corners relative to the centre of their set, 12 values per marker, mm; not copied
     * @param observed corners in the image, 8 values per marker, px; not copied
     * @param intrinsicsPrior unknown intrinsics
     * @param posePrior prior of the pose, or null for a flat one
     */
    public ReprojectionFit(double[] points, double[] observed, IntrinsicsPrior intrinsicsPrior, PosePrior posePrior) {
        this(points, observed, new double[0], 0, intrinsicsPrior, posePrior);
    }

    /**
     * A fit with unknowns that markers share. States have to hold as many of them.
     *
     * @param points corners relative to the centre of their set, 12 values per marker, mm; not copied
     * @param observed corners in the image, 8 values per marker, px; not copied
     * @param byUnknowns change of the observed corners by each shared unknown, 8 x unknowns row by row for each marker,
     *     px per unit; not copied
     * @param unknowns number of shared unknowns, standard normal beforehand
     * @param intrinsicsPrior unknown intrinsics
     * @param posePrior prior of the pose, or null for a flat one
     */
    public ReprojectionFit(double[] points, double[] observed, double[] byUnknowns, int unknowns,
            IntrinsicsPrior intrinsicsPrior, PosePrior posePrior) {
        this.points = points;
        this.observed = observed;
        this.intrinsicsPrior = intrinsicsPrior;
        this.posePrior = posePrior;
        this.byUnknowns = byUnknowns;
        this.unknowns = unknowns;
        markers = points.length / 12;
        columns = 6 + intrinsicsPrior.count() + unknowns;
        rows = 8 * markers + intrinsicsPrior.count() + unknowns + (posePrior == null ? 0 : 6);
        whitening = new double[64 * markers];
        placement = new double[64 * markers];
        residuals = new double[rows];
        jacobian = new double[rows * columns];
        information = new double[columns * columns];
        damped = new double[columns * columns];
        gradient = new double[columns];
        step = new double[columns];
        plainJacobian = new double[8 * columns];
    }

    /**
     * Weighs all coordinates alike.
     *
     * @param stdPx standard deviation of each coordinate, px, positive
     */
    public void setIsotropic(double stdPx) {
        java.util.Arrays.fill(whitening, 0);
        for (int m = 0; m < markers; m++) {
            for (int i = 0; i < 8; i++) {
                whitening[64 * m + 9 * i] = 1 / stdPx;
            }
        }
    }

    /**
     * Weighs by whitening matrices of the caller's.
     *
     * @param matrices 64 values per marker, lower triangular 8x8 row by row, 1/px; copied
     */
    public void setWhitening(double[] matrices) {
        System.arraycopy(matrices, 0, whitening, 0, whitening.length);
    }

    /**
     * Weighs by a noise model, evaluated at a state and then kept.
     *
     * @param noise covariance of the residuals
     * @param state where it is evaluated
     * @return false if a corner is not in front of the camera there or a covariance is not positive definite
     */
    public boolean freeze(ReferenceNoise noise, CameraState state) {
        return whitening(noise, state, markers, whitening, placement);
    }

    /**
     * Whitening matrices of a noise model at a state: inverses of the Cholesky factors of the covariances.
     *
     * @param noise covariance of the residuals
     * @param state where it is evaluated
     * @param markers number of references
     * @param out 64 values per reference, lower triangular 8x8 row by row, 1/px
     * @return false if a corner is not in front of the camera there or a covariance is not positive definite
     */
    public static boolean whitening(ReferenceNoise noise, CameraState state, int markers, double[] out) {
        return whitening(noise, state, markers, out, new double[64 * markers]);
    }

    private static boolean whitening(ReferenceNoise noise, CameraState state, int markers, double[] out,
            double[] placements) {
        double[] placement = new double[64];
        double[] pixel = new double[64];
        double[] inverse = new double[64];
        for (int m = 0; m < markers; m++) {
            if (!noise.covariance(state, m, placement, pixel)) {
                return false;
            }
            System.arraycopy(placement, 0, placements, 64 * m, 64);
            for (int i = 0; i < 64; i++) {
                placement[i] += pixel[i];
            }
            if (!Cholesky.factor(placement, 8)) {
                return false;
            }
            Cholesky.invertLower(placement, 8, inverse);
            System.arraycopy(inverse, 0, out, 64 * m, 64);
        }
        return true;
    }

    /**
     * Fits from a start on.
     *
     * @param state start; receives the result
     * @return half the sum of squares at the result, or NaN if a corner of the start is not in front of the camera
     */
    public double fit(CameraState state) {
        double cost = evaluate(state, true);
        if (!(cost < Double.POSITIVE_INFINITY)) {
            return Double.NaN;
        }
        double lambda = 1e-4;
        double growth = 2;
        for (int iteration = 0; iteration < MAX_STEPS; iteration++) {
            System.arraycopy(information, 0, damped, 0, damped.length);
            for (int i = 0; i < columns; i++) {
                damped[i * columns + i] += lambda * information[i * columns + i];
                step[i] = -gradient[i];
            }
            if (!Cholesky.factor(damped, columns)) {
                lambda = Math.max(lambda * growth, 1e-12);
                growth *= 2;
                if (lambda > 1e30) {
                    return cost;
                }
                continue;
            }
            Cholesky.solveLower(damped, columns, step);
            double whitenedLength = 0;
            for (double s : step) {
                whitenedLength += s * s;
            }
            Cholesky.solveUpper(damped, columns, step);
            move(state);
            // the length of the step in its own standard deviations decides, so that units do not matter
            boolean tiny = whitenedLength < STEP_TOLERANCE * STEP_TOLERANCE;
            double before = cost;
            double predicted = 0;
            for (int i = 0; i < columns; i++) {
                predicted -= step[i] * gradient[i];
                predicted += 0.5 * lambda * information[i * columns + i] * step[i] * step[i];
            }
            predicted *= 0.5;
            double after = costOnly(candidate);
            if (after <= before) {
                state.copyFrom(candidate);
                cost = evaluate(state, true);
                double ratio = predicted > 0 ? (before - after) / predicted : 1;
                double shrink = 2 * ratio - 1;
                lambda *= Math.max(1.0 / 3, 1 - shrink * shrink * shrink);
                growth = 2;
                if (tiny) {
                    return cost;
                }
            } else {
                if (tiny) {
                    return cost;
                }
                lambda *= growth;
                growth *= 2;
                if (lambda > 1e30) {
                    return cost;
                }
            }
        }
        return cost;
    }

    private void move(CameraState from) {
        candidate.setMoved(from, step, 0);
        for (int i = 0; i < intrinsicsPrior.count(); i++) {
            candidate.intrinsics[intrinsicsPrior.index(i)] += step[6 + i];
        }
        for (int j = 0; j < unknowns; j++) {
            candidate.unknowns[j] += step[columns - unknowns + j];
        }
    }

    private double costOnly(CameraState state) {
        return rows(state, false);
    }

    /**
     * Fills residuals, and where wanted the derivative, information and gradient, at a state.
     *
     * @param state where
     * @param withDerivatives whether {@link #jacobian()} and {@link #information()} are wanted as well
     * @return half the sum of squares, or +infinity if a corner is not in front of the camera
     */
    public double evaluate(CameraState state, boolean withDerivatives) {
        double cost = rows(state, withDerivatives);
        if (withDerivatives && cost < Double.POSITIVE_INFINITY) {
            for (int i = 0; i < columns; i++) {
                double g = 0;
                for (int k = 0; k < rows; k++) {
                    g += jacobian[k * columns + i] * residuals[k];
                }
                gradient[i] = g;
                for (int j = 0; j <= i; j++) {
                    double s = 0;
                    for (int k = 0; k < rows; k++) {
                        s += jacobian[k * columns + i] * jacobian[k * columns + j];
                    }
                    information[i * columns + j] = s;
                    information[j * columns + i] = s;
                }
            }
        }
        return cost;
    }

    private double rows(CameraState state, boolean withDerivatives) {
        if (!(state.intrinsics[PinholeCamera.FX] > 0 && state.intrinsics[PinholeCamera.FY] > 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double cost = 0;
        for (int m = 0; m < markers; m++) {
            if (!plainRows(state, m, withDerivatives)) {
                return Double.POSITIVE_INFINITY;
            }
            for (int i = 0; i < 8; i++) {
                int row = 8 * m + i;
                double r = 0;
                for (int k = 0; k <= i; k++) {
                    r += whitening[64 * m + 8 * i + k] * plainResiduals[k];
                }
                residuals[row] = r;
                cost += 0.5 * r * r;
                if (withDerivatives) {
                    for (int c = 0; c < columns; c++) {
                        double s = 0;
                        for (int k = 0; k <= i; k++) {
                            s += whitening[64 * m + 8 * i + k] * plainJacobian[k * columns + c];
                        }
                        jacobian[row * columns + c] = s;
                    }
                }
            }
        }
        for (int i = 0; i < intrinsicsPrior.count(); i++) {
            int row = 8 * markers + i;
            double r = intrinsicsPrior.whitened(i, state.intrinsics);
            residuals[row] = r;
            cost += 0.5 * r * r;
            if (withDerivatives) {
                java.util.Arrays.fill(jacobian, row * columns, (row + 1) * columns, 0);
                for (int k = 0; k <= i; k++) {
                    jacobian[row * columns + 6 + k] = intrinsicsPrior.whitening(i, k);
                }
            }
        }
        for (int j = 0; j < unknowns; j++) {
            int row = 8 * markers + intrinsicsPrior.count() + j;
            double r = state.unknowns[j];
            residuals[row] = r;
            cost += 0.5 * r * r;
            if (withDerivatives) {
                java.util.Arrays.fill(jacobian, row * columns, (row + 1) * columns, 0);
                jacobian[row * columns + columns - unknowns + j] = 1;
            }
        }
        if (posePrior != null) {
            int first = rows - 6;
            posePrior.rows(state, residuals, withDerivatives ? jacobian : null, first, columns);
            for (int i = first; i < rows; i++) {
                cost += 0.5 * residuals[i] * residuals[i];
            }
        }
        return Double.isNaN(cost) ? Double.POSITIVE_INFINITY : cost;
    }

    /** Residuals in px of one marker and their derivative by the chart, not yet whitened. */
    private boolean plainRows(CameraState state, int marker, boolean withDerivatives) {
        double[] r = state.rotation;
        if (byIntrinsics.length != 2 * state.intrinsics.length) {
            byIntrinsics = new double[2 * state.intrinsics.length];
        }
        for (int k = 0; k < 4; k++) {
            int at = 12 * marker + 3 * k;
            double ax = r[0] * points[at] + r[1] * points[at + 1] + r[2] * points[at + 2];
            double ay = r[3] * points[at] + r[4] * points[at + 1] + r[5] * points[at + 2];
            double az = r[6] * points[at] + r[7] * points[at + 1] + r[8] * points[at + 2];
            double x = ax + state.offset[0];
            double y = ay + state.offset[1];
            double z = az + state.offset[2];
            int row = 2 * k;
            if (!withDerivatives) {
                if (!state.lens.project(state.intrinsics, x, y, z, uv, 0)) {
                    return false;
                }
            } else {
                if (!state.lens.projectWithDerivatives(state.intrinsics, x, y, z, uv, byPoint, byIntrinsics)) {
                    return false;
                }
                for (int c = 0; c < 2; c++) {
                    int b = 3 * c;
                    int o = (row + c) * columns;
                    double gx = byPoint[b];
                    double gy = byPoint[b + 1];
                    double gz = byPoint[b + 2];
                    plainJacobian[o] = gx;
                    plainJacobian[o + 1] = gy;
                    plainJacobian[o + 2] = gz;
                    // a small turn w moves the point by w x a, a being its arm from the centre of the set
                    plainJacobian[o + 3] = ay * gz - az * gy;
                    plainJacobian[o + 4] = az * gx - ax * gz;
                    plainJacobian[o + 5] = ax * gy - ay * gx;
                    for (int i = 0; i < intrinsicsPrior.count(); i++) {
                        plainJacobian[o + 6 + i] =
                                byIntrinsics[c * state.intrinsics.length + intrinsicsPrior.index(i)];
                    }
                }
            }
            plainResiduals[row] = uv[0] - observed[8 * marker + row];
            plainResiduals[row + 1] = uv[1] - observed[8 * marker + row + 1];
            for (int c = 0; c < 2; c++) {
                int at8 = (8 * marker + row + c) * unknowns;
                for (int j = 0; j < unknowns; j++) {
                    plainResiduals[row + c] += byUnknowns[at8 + j] * state.unknowns[j];
                    plainJacobian[(row + c) * columns + columns - unknowns + j] = byUnknowns[at8 + j];
                }
            }
        }
        return true;
    }

    /**
     * Number of unknowns: 6, one per unknown intrinsic and one per unknown that markers share.
     *
     * @return columns of the derivative
     */
    public int columns() {
        return columns;
    }

    /**
     * Number of whitened residuals: 8 per marker, one per unknown intrinsic and shared unknown, 6 for a pose prior.
     *
     * @return rows of the derivative
     */
    public int rows() {
        return rows;
    }

    /**
     * Whitened derivative at a state.
     *
     * @param state where
     * @return a copy, rows x columns row by row
     * @throws IllegalStateException if a corner is not in front of the camera there
     */
    public double[] jacobianAt(CameraState state) {
        if (!(evaluate(state, true) < Double.POSITIVE_INFINITY)) {
            throw new IllegalStateException("a corner is not in front of the camera");
        }
        return jacobian.clone();
    }

    /** Whitened residuals of the last evaluation; shared, px over px. */
    double[] residuals() {
        return residuals;
    }

    /** Whitened derivative of the last evaluation, row by row; shared. */
    double[] jacobian() {
        return jacobian;
    }

    /** J^T J of the last evaluation, the Fisher information of the whitened problem; shared. */
    double[] information() {
        return information;
    }

    /** Covariances by placement that were frozen, 64 per marker; shared. */
    double[] placement() {
        return placement;
    }

    /** Whitening matrices in force, 64 per marker; shared. */
    double[] whitening() {
        return whitening;
    }

    /** Corners relative to the centre of their set, 12 values per marker, mm; shared. */
    double[] points() {
        return points;
    }

    /** Corners in the image, 8 values per marker, px; shared. */
    double[] observed() {
        return observed;
    }
}
