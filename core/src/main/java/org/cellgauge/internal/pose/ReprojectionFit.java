package org.cellgauge.internal.pose;

import java.util.Arrays;
import java.util.function.Predicate;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.geometry.DampedGaussNewton;
import org.jspecify.annotations.Nullable;

/**
 * Least squares fit of a pose, or of those of several views, and of unknown intrinsics, to image corners, in the
 * centred chart.
 *
 * <p>Minimises {@code |r|²/2}, r stacking per block {@code W (projected - observed)} with W the whitening matrix
 * (inverse of the Cholesky factor of the joint covariance of all that the views show of one body), one row per unknown
 * intrinsic, one per unknown that markers share ({@link CornerErrors}: observed corners less their columns count) and
 * six per view of a pose prior, by {@link DampedGaussNewton}.
 *
 * <p>Not thread-safe: it holds scratch arrays, so that a fit repeated for many draws allocates nothing.
 */
public final class ReprojectionFit {
    private static final int MAX_STEPS = 200;
    private static final double STEP_TOLERANCE = 1e-9;
    /** Length of a step, in its own deviations, below which a fit is taken to settle. */
    private static final double SETTLING = 0.3;

    private final double[] points;
    private final double[] observed;
    private final IntrinsicsPrior intrinsicsPrior;
    private final @Nullable PosePrior posePrior;
    private final double[] byUnknowns;
    private final BlockLayout blocks;
    private final StateLayout layout;
    private final int unknowns;
    private final int columns;
    private final int rows;
    private final double[] whitening;
    /** Null until weights are frozen. */
    private double @Nullable [] placement;
    /** The weights in an array that modes share; null where they have changed since. */
    private double @Nullable [] keptWhitening;
    private final double[] residuals;
    /** Residuals a step further. */
    private final double[] tried;
    private final double[] jacobian;
    private final double[] information;
    private final double[] gradient;
    /** Both null until something is fitted. */
    private @Nullable DampedGaussNewton solver;
    private @Nullable CameraState candidate;
    private final double[] uv = new double[2];
    private final double[] byPoint = new double[6];
    private double[] byIntrinsics = {};
    private final double[] factor;
    private final double[] inverseFactor;
    private double isotropicStdPx = Double.NaN;
    private double[][] squares = {};
    private final double[] plainResiduals;
    private final double[] plainJacobian;

    /**
     * A fit to markers in one view.
     *
     * @param points corners relative to the centre of their set, 12 values per marker, mm; not copied
     * @param observed corners in the image, 8 values per marker, px; not copied
     * @param intrinsicsPrior unknown intrinsics
     * @param posePrior prior of the pose, or null for a flat one
     */
    public ReprojectionFit(double[] points, double[] observed, IntrinsicsPrior intrinsicsPrior,
            @Nullable PosePrior posePrior) {
        this(points, observed, new double[0], 0, intrinsicsPrior, posePrior);
    }

    /**
     * A fit to markers in one view with unknowns that they share. States have to hold as many of them.
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
            IntrinsicsPrior intrinsicsPrior, @Nullable PosePrior posePrior) {
        this(BlockLayout.ofMarkers(points.length / 12), points, observed, byUnknowns, unknowns, intrinsicsPrior,
                posePrior);
    }

    /**
     * A fit to bodies in any number of views. States have to be of as many views, and to hold as many shared unknowns.
     *
     * @param blocks how the arrays are ordered
     * @param points points relative to the centre of the set, three values each, mm; not copied
     * @param observed points in the images, in the order of the blocks, px; not copied
     * @param byUnknowns change of these by each shared unknown, coordinates x unknowns row by row, px per unit; not
     *     copied
     * @param unknowns number of shared unknowns, standard normal beforehand
     * @param intrinsicsPrior unknown intrinsics, the same in all views
     * @param posePrior prior of the poses, or null for a flat one
     */
    public ReprojectionFit(BlockLayout blocks, double[] points, double[] observed, double[] byUnknowns, int unknowns,
            IntrinsicsPrior intrinsicsPrior, @Nullable PosePrior posePrior) {
        this.blocks = blocks;
        this.points = points;
        this.observed = observed;
        this.intrinsicsPrior = intrinsicsPrior;
        this.posePrior = posePrior;
        this.byUnknowns = byUnknowns;
        this.unknowns = unknowns;
        layout = StateLayout.of(blocks.views(), intrinsicsPrior, unknowns);
        columns = layout.size();
        int n = blocks.blocks();
        rows = blocks.firstRow(n) + intrinsicsPrior.count() + unknowns + (posePrior == null ? 0 : layout.poses());
        whitening = new double[blocks.firstEntry(n)];
        residuals = new double[rows];
        tried = new double[rows];
        jacobian = new double[rows * columns];
        information = new double[columns * columns];
        gradient = new double[columns];
        factor = new double[columns * columns];
        inverseFactor = new double[columns * columns];
        plainResiduals = new double[blocks.mostRows()];
        plainJacobian = new double[blocks.mostRows() * columns];
    }

    /**
     * Weighs all coordinates alike.
     *
     * @param stdPx standard deviation of each coordinate, px, positive
     */
    public void setIsotropic(double stdPx) {
        if (stdPx == isotropicStdPx) {
            return;
        }
        weightsChange();
        isotropicStdPx = stdPx;
        Arrays.fill(whitening, 0);
        for (int m = 0; m < blocks.blocks(); m++) {
            for (int i = 0; i < blocks.rows(m); i++) {
                whitening[blocks.firstEntry(m) + (blocks.rows(m) + 1) * i] = 1 / stdPx;
            }
        }
    }

    /**
     * Weighs by whitening matrices of the caller's.
     *
     * @param matrices lower triangular, row by row, of a marker in one view 8x8, 1/px; copied
     */
    public void setWhitening(double[] matrices) {
        weightsChange();
        System.arraycopy(matrices, 0, whitening, 0, whitening.length);
    }

    private void weightsChange() {
        keptWhitening = null;
        isotropicStdPx = Double.NaN;
    }

    /**
     * Weighs by a noise model, evaluated at a state and then kept.
     *
     * @param noise covariance of the residuals
     * @param state where it is evaluated
     * @return false if a corner is not in front of the camera there or a covariance is not positive definite
     */
    public boolean freeze(ReferenceNoise noise, CameraState state) {
        weightsChange();
        if (placement == null) {
            placement = new double[whitening.length];
            squares = new double[3][blocks.mostRows() * blocks.mostRows()];
        }
        return whitening(noise, state, blocks, whitening, placement, squares);
    }

    /**
     * Whitening matrices of a noise model at a state: inverses of the Cholesky factors of the covariances.
     *
     * @param noise covariance of the residuals
     * @param state where it is evaluated
     * @param blocks order of the coordinates
     * @param out receives a lower triangular matrix per block, row by row, of a marker in one view 8x8, 1/px
     * @return false if a corner is not in front of the camera there or a covariance is not positive definite
     */
    public static boolean whitening(ReferenceNoise noise, CameraState state, BlockLayout blocks, double[] out) {
        return whitening(noise, state, blocks, out, new double[blocks.firstEntry(blocks.blocks())],
                new double[3][blocks.mostRows() * blocks.mostRows()]);
    }

    private static boolean whitening(ReferenceNoise noise, CameraState state, BlockLayout blocks, double[] out,
            double[] placements, double[][] space) {
        double[] placement = space[0];
        double[] pixel = space[1];
        double[] inverse = space[2];
        for (int m = 0; m < blocks.blocks(); m++) {
            if (!noise.covariance(state, m, placement, pixel)) {
                return false;
            }
            int rows = blocks.rows(m);
            System.arraycopy(placement, 0, placements, blocks.firstEntry(m), rows * rows);
            for (int i = 0; i < rows * rows; i++) {
                placement[i] += pixel[i];
            }
            if (!Cholesky.factor(placement, rows)) {
                return false;
            }
            Cholesky.invertLower(placement, rows, inverse);
            System.arraycopy(inverse, 0, out, blocks.firstEntry(m), rows * rows);
        }
        return true;
    }

    /**
     * Fits from a start on. Residuals, derivative and information are then those at the result.
     *
     * @param state start; receives the result
     * @return half the sum of squares at the result, or NaN if a corner of the start is not in front of the camera
     */
    public double fit(CameraState state) {
        return fit(state, null);
    }

    /**
     * The same, given up where it settles at a place that is known: one that is near, and hardly left by a step.
     *
     * @param state start; receives the result, or a place near the known one
     * @param known tells such places; null to go to the end anyway
     * @return half the sum of squares at the result, or NaN if a corner of the start is not in front of the camera
     */
    double fit(CameraState state, @Nullable Predicate<CameraState> known) {
        if (solver == null) {
            solver = new DampedGaussNewton(columns, DampedGaussNewton.Damping.NIELSEN, MAX_STEPS);
        }
        double cost = solver.minimise(new Chart(state, known));
        return cost < Double.POSITIVE_INFINITY ? cost : Double.NaN;
    }

    private CameraState candidate() {
        if (candidate == null) {
            candidate = new CameraState(blocks.views());
        }
        return candidate;
    }

    /** The fit as the solver sees it: steps in the chart from the state that it started with. */
    private final class Chart implements DampedGaussNewton.Problem {
        private final CameraState state;
        private final CameraState candidate;
        private final @Nullable Predicate<CameraState> known;

        Chart(CameraState state, @Nullable Predicate<CameraState> known) {
            this.state = state;
            this.known = known;
            candidate = candidate();
        }

        @Override
        public double linearise(double[] toInformation, double[] toGradient) {
            double cost = evaluate(state, true);
            System.arraycopy(information, 0, toInformation, 0, information.length);
            System.arraycopy(gradient, 0, toGradient, 0, gradient.length);
            return cost;
        }

        @Override
        public double at(double[] step) {
            candidate.setMoved(state, step, 0);
            for (int i = 0; i < intrinsicsPrior.count(); i++) {
                candidate.intrinsics[intrinsicsPrior.index(i)] += step[layout.intrinsics() + i];
            }
            for (int j = 0; j < unknowns; j++) {
                candidate.unknowns[j] += step[layout.shared() + j];
            }
            // what is known of the state stays as it is: the step may not be taken
            return rows(candidate, false, tried);
        }

        @Override
        public void accept() {
            state.copyFrom(candidate);
        }

        @Override
        public boolean isEnough(double squaredStds, double before, double after, boolean accepted) {
            // the length of the step in its own standard deviations decides, so that units do not matter
            return squaredStds < STEP_TOLERANCE * STEP_TOLERANCE
                    || known != null && accepted && squaredStds < SETTLING * SETTLING && known.test(candidate);
        }
    }

    /**
     * Fills residuals, and where wanted the derivative, information and gradient, at a state.
     *
     * @param state where
     * @param withDerivatives whether {@link #jacobian()} and {@link #information()} are wanted as well
     * @return half the sum of squares, or +infinity if a corner is not in front of the camera
     */
    public double evaluate(CameraState state, boolean withDerivatives) {
        double cost = rows(state, withDerivatives, residuals);
        if (withDerivatives && cost < Double.POSITIVE_INFINITY) {
            for (int i = 0; i < columns; i += 2) {
                gradientOf(i, Math.min(i + 1, columns - 1));
                for (int j = 0; j <= i; j += 2) {
                    informationOf(i, Math.min(i + 1, columns - 1), j, Math.min(j + 1, columns - 1));
                }
            }
        }
        return cost;
    }

    /** The gradient by two unknowns. */
    private void gradientOf(int i0, int i1) {
        double g0 = 0;
        double g1 = 0;
        for (int k = 0, row = 0; k < rows; k++, row += columns) {
            double r = residuals[k];
            g0 += jacobian[row + i0] * r;
            g1 += jacobian[row + i1] * r;
        }
        gradient[i0] = g0;
        gradient[i1] = g1;
    }

    /** Two by two entries of the information: four sums side by side do not wait for each other. */
    private void informationOf(int i0, int i1, int j0, int j1) {
        double s00 = 0;
        double s01 = 0;
        double s10 = 0;
        double s11 = 0;
        for (int k = 0, row = 0; k < rows; k++, row += columns) {
            double a0 = jacobian[row + i0];
            double a1 = jacobian[row + i1];
            double b0 = jacobian[row + j0];
            double b1 = jacobian[row + j1];
            s00 += a0 * b0;
            s01 += a0 * b1;
            s10 += a1 * b0;
            s11 += a1 * b1;
        }
        setInformation(i0, j0, s00);
        setInformation(i0, j1, s01);
        setInformation(i1, j0, s10);
        setInformation(i1, j1, s11);
    }

    private void setInformation(int i, int j, double value) {
        information[i * columns + j] = value;
        information[j * columns + i] = value;
    }

    private double rows(CameraState state, boolean withDerivatives, double[] residuals) {
        if (!(state.intrinsics[PinholeCamera.FX] > 0 && state.intrinsics[PinholeCamera.FY] > 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double cost = 0;
        for (int m = 0; m < blocks.blocks(); m++) {
            for (int time = 0; time < blocks.timesSeen(m); time++) {
                if (!plainRows(state, m, time, withDerivatives)) {
                    return Double.POSITIVE_INFINITY;
                }
            }
            cost = isotropicStdPx > 0 ? scaled(m, withDerivatives, residuals, cost)
                    : whitened(m, withDerivatives, residuals, cost);
        }
        int ofCorners = blocks.firstRow(blocks.blocks());
        for (int i = 0; i < intrinsicsPrior.count(); i++) {
            int row = ofCorners + i;
            double r = intrinsicsPrior.whitened(i, state.intrinsics);
            residuals[row] = r;
            cost += 0.5 * r * r;
            if (withDerivatives) {
                Arrays.fill(jacobian, row * columns, (row + 1) * columns, 0);
                for (int k = 0; k <= i; k++) {
                    jacobian[row * columns + layout.intrinsics() + k] = intrinsicsPrior.whitening(i, k);
                }
            }
        }
        for (int j = 0; j < unknowns; j++) {
            int row = ofCorners + intrinsicsPrior.count() + j;
            double r = state.unknowns[j];
            residuals[row] = r;
            cost += 0.5 * r * r;
            if (withDerivatives) {
                Arrays.fill(jacobian, row * columns, (row + 1) * columns, 0);
                jacobian[row * columns + layout.shared() + j] = 1;
            }
        }
        if (posePrior != null) {
            int first = rows - layout.poses();
            posePrior.rows(state, residuals, withDerivatives ? jacobian : null, first, columns);
            for (int i = first; i < rows; i++) {
                cost += 0.5 * residuals[i] * residuals[i];
            }
        }
        return Double.isNaN(cost) ? Double.POSITIVE_INFINITY : cost;
    }

    /** Residuals and derivative of a block from those in px, all weighed alike; returns the cost with its own. */
    private double scaled(int block, boolean withDerivatives, double[] residuals, double before) {
        double weight = 1 / isotropicStdPx;
        int size = blocks.rows(block);
        int firstRow = blocks.firstRow(block);
        double cost = before;
        for (int i = 0; i < size; i++) {
            // no zero is negative, as in a sum
            double r = 0 + weight * plainResiduals[i];
            residuals[firstRow + i] = r;
            cost += 0.5 * r * r;
        }
        if (withDerivatives) {
            int first = firstRow * columns;
            for (int i = 0; i < size * columns; i++) {
                jacobian[first + i] = 0 + weight * plainJacobian[i];
            }
        }
        return cost;
    }

    /** The same weighed by the block's whitening matrix. */
    private double whitened(int block, boolean withDerivatives, double[] residuals, double before) {
        int size = blocks.rows(block);
        int firstRow = blocks.firstRow(block);
        int entry = blocks.firstEntry(block);
        double cost = before;
        for (int i = 0; i < size; i++, entry += size) {
            double r = 0;
            for (int k = 0; k <= i; k++) {
                r += whitening[entry + k] * plainResiduals[k];
            }
            residuals[firstRow + i] = r;
            cost += 0.5 * r * r;
            if (withDerivatives) {
                whitenDerivative(entry, i, (firstRow + i) * columns);
            }
        }
        return cost;
    }

    /** A row of the whitened derivative; the six of a pose are summed side by side, none waiting for another. */
    private void whitenDerivative(int entry, int i, int to) {
        int c = 0;
        for (; c + StateLayout.POSE <= columns; c += StateLayout.POSE) {
            double s0 = 0;
            double s1 = 0;
            double s2 = 0;
            double s3 = 0;
            double s4 = 0;
            double s5 = 0;
            for (int k = 0, at = c; k <= i; k++, at += columns) {
                double w = whitening[entry + k];
                s0 += w * plainJacobian[at];
                s1 += w * plainJacobian[at + 1];
                s2 += w * plainJacobian[at + 2];
                s3 += w * plainJacobian[at + 3];
                s4 += w * plainJacobian[at + 4];
                s5 += w * plainJacobian[at + 5];
            }
            jacobian[to + c] = s0;
            jacobian[to + c + 1] = s1;
            jacobian[to + c + 2] = s2;
            jacobian[to + c + 3] = s3;
            jacobian[to + c + 4] = s4;
            jacobian[to + c + 5] = s5;
        }
        for (; c < columns; c++) {
            double s = 0;
            for (int k = 0; k <= i; k++) {
                s += whitening[entry + k] * plainJacobian[k * columns + c];
            }
            jacobian[to + c] = s;
        }
    }

    /**
     * Residuals in px of one body in one of the views that show it, and their derivative by the chart, not whitened.
     */
    private boolean plainRows(CameraState state, int block, int time, boolean withDerivatives) {
        int view = blocks.view(block, time);
        int pose = layout.pose(view);
        int intrinsics = layout.intrinsics();
        double[] r = state.rotation;
        if (byIntrinsics.length != 2 * state.intrinsics.length) {
            byIntrinsics = new double[2 * state.intrinsics.length];
        }
        double r0 = r[9 * view];
        double r1 = r[9 * view + 1];
        double r2 = r[9 * view + 2];
        double r3 = r[9 * view + 3];
        double r4 = r[9 * view + 4];
        double r5 = r[9 * view + 5];
        double r6 = r[9 * view + 6];
        double r7 = r[9 * view + 7];
        double r8 = r[9 * view + 8];
        double tx = state.offset[3 * view];
        double ty = state.offset[3 * view + 1];
        double tz = state.offset[3 * view + 2];
        int count = intrinsicsPrior.count();
        boolean several = layout.views() > 1;
        int points = blocks.points(block);
        int first = blocks.firstRow(block);
        int row = 2 * time * points;
        for (int k = 0, at = 3 * blocks.firstPoint(block); k < points; k++, at += 3, row += 2) {
            double px = this.points[at];
            double py = this.points[at + 1];
            double pz = this.points[at + 2];
            double ax = r0 * px + r1 * py + r2 * pz;
            double ay = r3 * px + r4 * py + r5 * pz;
            double az = r6 * px + r7 * py + r8 * pz;
            double x = ax + tx;
            double y = ay + ty;
            double z = az + tz;
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
                    int start = (row + c) * columns;
                    int o = start + pose;
                    double gx = byPoint[b];
                    double gy = byPoint[b + 1];
                    double gz = byPoint[b + 2];
                    if (several) {
                        Arrays.fill(plainJacobian, start, start + intrinsics, 0);
                    }
                    plainJacobian[o] = gx;
                    plainJacobian[o + 1] = gy;
                    plainJacobian[o + 2] = gz;
                    // a small turn w moves the point by w x a, a being its arm from the centre of the set
                    plainJacobian[o + 3] = ay * gz - az * gy;
                    plainJacobian[o + 4] = az * gx - ax * gz;
                    plainJacobian[o + 5] = ax * gy - ay * gx;
                    for (int i = 0; i < count; i++) {
                        plainJacobian[start + intrinsics + i] =
                                byIntrinsics[c * state.intrinsics.length + intrinsicsPrior.index(i)];
                    }
                }
            }
            int coordinate = first + row;
            plainResiduals[row] = uv[0] - observed[coordinate];
            plainResiduals[row + 1] = uv[1] - observed[coordinate + 1];
            for (int c = 0; c < 2; c++) {
                int ofUnknowns = (coordinate + c) * unknowns;
                for (int j = 0; j < unknowns; j++) {
                    plainResiduals[row + c] += byUnknowns[ofUnknowns + j] * state.unknowns[j];
                    plainJacobian[(row + c) * columns + layout.shared() + j] = byUnknowns[ofUnknowns + j];
                }
            }
        }
        return true;
    }

    /**
     * Which unknowns the columns of the derivative are of.
     *
     * @return poses, unknown intrinsics, unknowns that markers share
     */
    public StateLayout layout() {
        return layout;
    }

    /**
     * How image coordinates are ordered.
     *
     * @return a block per marker or body
     */
    public BlockLayout blocks() {
        return blocks;
    }

    /**
     * What Laplace's method needs at a state that is taken for the mode, of this fit's weights as they are.
     *
     * @param state where; copied
     * @return the mode, or null where a corner is not in front of the camera, or the information is singular
     */
    public @Nullable PoseMode modeAt(CameraState state) {
        return modeAt(state, null);
    }

    /** The same of references whose placement errors are linearised at a place. */
    @Nullable PoseMode modeAt(CameraState state, @Nullable PlacedReferences placed) {
        double cost = evaluate(state, true);
        return cost < Double.POSITIVE_INFINITY ? PoseMode.of(this, state, cost, placed) : null;
    }

    /**
     * Number of unknowns: 6 per view, one per unknown intrinsic and one per unknown that markers share.
     *
     * @return columns of the derivative
     */
    public int columns() {
        return columns;
    }

    /**
     * Number of whitened residuals: two per point and view, one per unknown intrinsic and shared unknown, 6 per view
     * for a pose prior.
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
        double[] out = new double[jacobian.length];
        jacobianAt(state, out);
        return out;
    }

    /**
     * The same in an array of the caller's.
     *
     * @param state where
     * @param out receives rows x columns row by row
     * @throws IllegalStateException if a corner is not in front of the camera there
     */
    public void jacobianAt(CameraState state, double[] out) {
        if (!(evaluate(state, true) < Double.POSITIVE_INFINITY)) {
            throw new IllegalStateException("a corner is not in front of the camera");
        }
        System.arraycopy(jacobian, 0, out, 0, jacobian.length);
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

    /** Inverts the information of the last evaluation; false, with {@code out} as it was, where it is singular. */
    boolean invertInformation(double[] out) {
        System.arraycopy(information, 0, factor, 0, factor.length);
        return Cholesky.inverse(factor, columns, inverseFactor, out);
    }

    /** Half the logarithm of the determinant of a covariance of the unknowns; NaN where it is not positive definite. */
    double halfLogDeterminant(double[] covariance) {
        System.arraycopy(covariance, 0, factor, 0, factor.length);
        Cholesky.factor(factor, columns);
        return Cholesky.halfLogDeterminant(factor, columns);
    }

    /** Covariances by placement that were frozen, block by block, of the caller's; null where none were. */
    double @Nullable [] placement() {
        return placement == null ? null : placement.clone();
    }

    /** Weights in force, block by block, in an array that stays as it is: shared by the modes found with them. */
    double[] keptWhitening() {
        if (keptWhitening == null) {
            keptWhitening = whitening.clone();
        }
        return keptWhitening;
    }

    /**
     * Logarithm of the posterior mass around the state of the last evaluation, taken for a mode, by Laplace's method;
     * see {@link PoseMode#logWeight()}.
     *
     * @param halfChiSquare half the sum of squares there
     * @param covariance the inverse of the information there
     */
    double logWeight(double halfChiSquare, double[] covariance) {
        double logWhitening = 0;
        for (int m = 0; m < blocks.blocks(); m++) {
            int size = blocks.rows(m);
            for (int i = 0; i < size; i++) {
                logWhitening += Math.log(whitening[blocks.firstEntry(m) + (size + 1) * i]);
            }
        }
        return logWhitening - halfChiSquare + halfLogDeterminant(covariance);
    }

    /** Whitening matrices in force, block by block; shared. */
    double[] whitening() {
        return whitening;
    }

    /** Points relative to the centre of their set, three values each, mm; shared. */
    double[] points() {
        return points;
    }

    /** Points in the images, in the order of the blocks, px; shared. */
    double[] observed() {
        return observed;
    }
}
