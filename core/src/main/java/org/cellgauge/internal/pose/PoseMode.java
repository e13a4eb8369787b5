package org.cellgauge.internal.pose;

import java.util.Arrays;
import org.cellgauge.geometry.RigidTransform;
import org.jspecify.annotations.Nullable;

/**
 * A mode of a pose posterior with what Laplace's approximation needs: where it is, its Fisher information, and the
 * derivative of its whitened residuals; immutable.
 *
 * <p>Order of all matrices: that of {@link #layout()}, poses in the centred chart in the camera frame. What is asked of
 * a marker is, where bodies are of other points or seen in several views, answered for the whole block.
 */
public final class PoseMode {
    private final CameraState state;
    private final double[] jacobian;
    private final double[] residuals;
    private final double[] whitening;
    /** Null where weights were given otherwise. */
    private final double @Nullable [] placement;
    private final double[] points;
    private final double[] observed;
    private final @Nullable PlacedReferences placed;
    private final double[] covariance;
    private final int columns;
    private final StateLayout layout;
    private final BlockLayout blocks;
    private final double halfChiSquare;
    private final double logWeight;

    /**
     * Reads a mode off a converged fit.
     *
     * @param fit evaluated with derivatives at the state
     * @param state where the fit converged; copied
     * @param halfChiSquare half the sum of squares there
     * @param placed where placement errors were linearised, or null where there are none
     * @return the mode, or null where its information is singular
     */
    static @Nullable PoseMode of(ReprojectionFit fit, CameraState state, double halfChiSquare,
            @Nullable PlacedReferences placed) {
        double[] covariance = new double[fit.columns() * fit.columns()];
        return fit.invertInformation(covariance) ? new PoseMode(fit, state, halfChiSquare, placed, covariance) : null;
    }

    /** The same with the inverse of the fit's information there; kept. */
    PoseMode(ReprojectionFit fit, CameraState state, double halfChiSquare, @Nullable PlacedReferences placed,
            double[] covariance) {
        this.state = state.copy();
        this.jacobian = fit.jacobian().clone();
        this.residuals = fit.residuals().clone();
        this.whitening = fit.keptWhitening();
        this.placement = fit.placement();
        this.points = fit.points().clone();
        this.observed = fit.observed().clone();
        this.placed = placed;
        this.covariance = covariance;
        this.columns = fit.columns();
        this.layout = fit.layout();
        this.blocks = fit.blocks();
        this.halfChiSquare = halfChiSquare;
        logWeight = fit.logWeight(halfChiSquare, covariance);
    }

    /**
     * Where the mode is.
     *
     * @return a copy of the state
     */
    public CameraState state() {
        return state.copy();
    }

    /**
     * The pose of the mode, in the only view.
     *
     * @return cameraFromSet, points relative to the centre of their set
     */
    RigidTransform cameraFromSet() {
        return cameraFromSet(0);
    }

    /** The same in a view, 0 to views - 1. */
    RigidTransform cameraFromSet(int view) {
        return state.cameraFromSet(view);
    }

    /**
     * Which places of its matrices belong to what.
     *
     * @return the layout of the unknowns
     */
    public StateLayout layout() {
        return layout;
    }

    /**
     * How what it knows of image coordinates lies in arrays.
     *
     * @return a block per marker or body
     */
    public BlockLayout blocks() {
        return blocks;
    }

    /**
     * Number of unknowns.
     *
     * @return size of the layout
     */
    public int dimension() {
        return columns;
    }

    /**
     * Laplace covariance: the inverse of the Fisher information.
     *
     * @return a copy, dimension x dimension row by row; mm, rad and the intrinsics' units
     */
    public double[] covariance() {
        return covariance.clone();
    }

    /**
     * How far another state is from this mode in each unknown, in the standard deviations that Laplace's method gives
     * it.
     *
     * @param other a state of as many views, with any intrinsics
     * @return the sum of squares over the unknowns of the poses
     */
    double squaredStdsTo(CameraState other) {
        double[] step = other.stepFrom(state);
        double squared = 0;
        for (int i = 0; i < step.length; i++) {
            squared += step[i] * step[i] / covariance[i * columns + i];
        }
        return squared;
    }

    /**
     * How alike the rotations of another state and of this mode are in the first view.
     *
     * @param other a state
     * @return one and twice the cosine of the angle from one to the other
     */
    public double likeness(CameraState other) {
        double trace = 0;
        for (int i = 0; i < 9; i++) {
            trace += state.rotation[i] * other.rotation[i];
        }
        return trace;
    }

    /**
     * Half the sum of squared whitened residuals, priors included.
     *
     * @return not negative
     */
    public double halfChiSquare() {
        return halfChiSquare;
    }

    /**
     * Sum of squared whitened residuals of one marker.
     *
     * @param marker index of the marker
     * @return chi-square of its coordinates, 8 in one view
     */
    public double chiSquareOf(int marker) {
        double sum = 0;
        for (int i = blocks.firstRow(marker); i < blocks.firstRow(marker + 1); i++) {
            sum += residuals[i] * residuals[i];
        }
        return sum;
    }

    /**
     * Logarithm of the posterior mass around this mode by Laplace's method, up to a constant shared by the modes of one
     * posterior (Tierney and Kadane, "Accurate approximations for posterior moments and marginal densities", 1986).
     *
     * @return the logarithm
     */
    public double logWeight() {
        return logWeight;
    }

    /**
     * Whitening matrices frozen at this mode.
     *
     * @return a copy in the order of {@link #blocks()}, of a marker in one view lower triangular 8x8 row by row, 1/px
     */
    public double[] whitening() {
        return whitening.clone();
    }

    /**
     * An entry of the whitening matrix of one marker.
     *
     * @param marker index of the marker
     * @param row its row, of a marker in one view 0 to 7
     * @param column its column, likewise
     * @return 1/px; 0 above the diagonal
     */
    public double whitening(int marker, int row, int column) {
        return whitening[blocks.firstEntry(marker) + blocks.rows(marker) * row + column];
    }

    /**
     * Covariances of residuals by placement, frozen at this mode.
     *
     * @return a copy in the order of {@link #blocks()}, of a marker in one view 8x8 row by row, px²; zeros where
     *     weights were given otherwise
     */
    public double[] placementPx2() {
        return placement == null ? new double[whitening.length] : placement.clone();
    }

    /**
     * Corners of the markers where the model is linearised: moved by the placement errors that fit this mode best.
     *
     * @return a copy, 3 values per point relative to the centre of the set, mm
     */
    public double[] pointsMm() {
        return points.clone();
    }

    /**
     * What the projections of {@link #pointsMm()} are compared with: the image corners and, to first order, how far
     * each marker's placement error has moved them, so that the residuals are those of the nominal places. What markers
     * share is not taken off.
     *
     * @return a copy in the order of {@link #blocks()}, 8 values per marker in one view, px
     */
    public double[] comparedPx() {
        return observed.clone();
    }

    /**
     * Where the references are taken to stand at this mode.
     *
     * @return the linearisation point of placement errors
     * @throws IllegalStateException if the mode is of a fit that knows none
     */
    public PlacedReferences placed() {
        if (placed == null) {
            throw new IllegalStateException("this mode knows no placement errors");
        }
        return placed;
    }

    /**
     * How the estimate answers to the image corners of one marker: the gain {@code C J_m^T W_m} of the linearised fit.
     *
     * @param marker index of the marker
     * @return dimension x 8 (coordinates of its block) row by row: change of the estimate by change of each observed
     *     coordinate, per px
     */
    public double[] gain(int marker) {
        int rows = blocks.rows(marker);
        int first = blocks.firstRow(marker);
        double[] gain = new double[columns * rows];
        for (int c = 0; c < columns; c++) {
            for (int i = 0; i < rows; i++) {
                double s = 0;
                for (int k = 0; k < columns; k++) {
                    s += covariance[c * columns + k] * jacobian[(first + i) * columns + k];
                }
                for (int j = 0; j <= i; j++) {
                    gain[rows * c + j] += s * whitening[blocks.firstEntry(marker) + rows * i + j];
                }
            }
        }
        return gain;
    }

    /**
     * Whitened residuals of one marker, projected minus observed.
     *
     * @param marker index of the marker
     * @return a copy, 8 values in one view
     */
    public double[] whitenedResiduals(int marker) {
        return Arrays.copyOfRange(residuals, blocks.firstRow(marker), blocks.firstRow(marker + 1));
    }

    /**
     * Derivative of the whitened residuals of one marker by the unknowns.
     *
     * @param marker index of the marker
     * @return a copy, 8 (coordinates of its block) x dimension row by row
     */
    public double[] jacobian(int marker) {
        return Arrays.copyOfRange(jacobian, blocks.firstRow(marker) * columns, blocks.firstRow(marker + 1) * columns);
    }

    /**
     * The same in an array of the caller's.
     *
     * @param marker index of the marker
     * @param out receives 8 (coordinates of its block) x dimension row by row
     */
    public void copyJacobian(int marker, double[] out) {
        System.arraycopy(jacobian, blocks.firstRow(marker) * columns, out, 0, blocks.rows(marker) * columns);
    }

    /**
     * Covariance of the whitened residuals of one marker under the linearised model, {@code I - J C J^T}: what the fit
     * leaves of them.
     *
     * @param marker index of the marker
     * @return 8x8 (coordinates of its block squared) row by row; 0 in a direction that the pose absorbs entirely
     */
    public double[] redundancy(int marker) {
        int rows = blocks.rows(marker);
        int first = blocks.firstRow(marker);
        double[] out = new double[rows * rows];
        for (int i = 0; i < rows; i++) {
            for (int k = 0; k < rows; k++) {
                double s = i == k ? 1 : 0;
                for (int a = 0; a < columns; a++) {
                    for (int b = 0; b < columns; b++) {
                        s -= jacobian[(first + i) * columns + a] * covariance[a * columns + b]
                                * jacobian[(first + k) * columns + b];
                    }
                }
                out[rows * i + k] = s;
            }
        }
        return out;
    }

    /**
     * Sum of squared whitened residuals of one marker in the two directions that no rigid movement of it reaches, and
     * so neither pose nor placement explains.
     *
     * @param marker index of the marker
     * @return chi-square distributed with 2 degrees of freedom under the linearised model where nothing but the pose is
     *     unknown
     * @throws IllegalStateException if this is a mode of other bodies than markers, or of several views
     */
    public double squareChiSquare(int marker) {
        if (!blocks.isMarkers()) {
            throw new IllegalStateException("only a marker in one view leaves two such directions");
        }
        int first = blocks.firstRow(marker);
        double[] byPose = new double[8 * StateLayout.POSE];
        for (int i = 0; i < 8; i++) {
            System.arraycopy(jacobian, (first + i) * columns, byPose, StateLayout.POSE * i, StateLayout.POSE);
        }
        double sum = 0;
        for (double[] direction : Squareness.complement(byPose)) {
            double along = 0;
            for (int i = 0; i < 8; i++) {
                along += direction[i] * residuals[first + i];
            }
            sum += along * along;
        }
        return sum;
    }

    /**
     * Number of markers the fit rests on.
     *
     * @return at least 1
     */
    public int markers() {
        return blocks.blocks();
    }
}
