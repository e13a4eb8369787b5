package org.cellgauge.placement;

import java.util.List;
import org.cellgauge.cell.Placement;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.pose.RigidMarkerNoise;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;
import org.jspecify.annotations.Nullable;

/**
 * What the residuals of a fit say of the placement of its references, and of causes that move the corners of all, in
 * the model linearised at the mode.
 *
 * <p>Coordinate c of reference m (shift along world x, y, z, then turn about x, y, z), one stated deviation long, moves
 * the whitened residuals along d. Its score is {@code d^T P r}, with {@code P = I - J C J^T} what the fit leaves of
 * residuals; under the model all scores together are normal with the covariance {@code d^T P d'} (score test of a mean
 * shift: Cook and Weisberg, "Residuals and Influence in Regression", 1982, section 2.2). The columns of a {@link
 * CausePattern} are directions like these, only that they lie across all references.
 */
final class PlacementScores {
    /** Coordinates of a placement: shifts along x, y, z, turns about x, y, z. */
    static final int COORDINATES = 6;
    /** Share of a direction's information below which what the fit leaves of it is rounding. */
    private static final double ABSORBED = 1e-9;
    /** Eigenvalue of what is left of residuals below which the fit has absorbed the direction. */
    private static final double NOTHING_LEFT = 1e-6;

    private final PoseMode mode;
    /** Where the columns of the causes begin: after all coordinates of all references. */
    private final int firstOfCauses;
    private final int size;
    private final double[] scores;
    private final double[] whole;
    private final double[] covariance;

    /** The same with the scores of a direction swept out. */
    private PlacementScores(PlacementScores other, double[] scores, double[] covariance) {
        mode = other.mode;
        firstOfCauses = other.firstOfCauses;
        size = other.size;
        whole = other.whole;
        this.scores = scores;
        this.covariance = covariance;
    }

    PlacementScores(ReferenceView view, PoseMode mode, List<CausePattern> causes) {
        this.mode = mode;
        firstOfCauses = COORDINATES * view.size();
        int columnsOfCauses = 0;
        for (CausePattern cause : causes) {
            columnsOfCauses += cause.columnsPx.length;
        }
        size = firstOfCauses + columnsOfCauses;
        scores = new double[size];
        whole = new double[size];
        covariance = new double[size * size];
        int columns = mode.dimension();
        RigidMarkerNoise geometry = new RigidMarkerNoise(view, 1).about(mode.placed());
        CameraState state = mode.state();
        double[] whitening = mode.whitening();
        double[] byPlacement = new double[8 * COORDINATES];
        double[][] directions = new double[firstOfCauses][8];
        double[][] byPose = new double[size][columns];
        for (int m = 0; m < view.size(); m++) {
            geometry.jacobian(state, m, byPlacement);
            Placement placement = view.references().get(m).placement();
            double[] residual = mode.whitenedResiduals(m);
            double[] jacobian = mode.jacobian(m);
            for (int c = 0; c < COORDINATES; c++) {
                int at = COORDINATES * m + c;
                double std = c < 3 ? placement.stdMm(c) : placement.stdRad();
                for (int i = 0; i < 8; i++) {
                    double d = 0;
                    for (int k = 0; k <= i; k++) {
                        d += whitening[64 * m + 8 * i + k] * byPlacement[COORDINATES * k + c] * std;
                    }
                    directions[at][i] = d;
                    whole[at] += d * d;
                    // residuals are projected minus observed: a marker that is off by +s is predicted at -s
                    scores[at] -= d * residual[i];
                    for (int k = 0; k < columns; k++) {
                        byPose[at][k] += d * jacobian[i * columns + k];
                    }
                }
            }
        }
        double[][] across = new double[columnsOfCauses][];
        int next = 0;
        for (CausePattern cause : causes) {
            for (double[] column : cause.columnsPx) {
                across[next] = whitened(column, view.size(), whitening);
                addAcross(firstOfCauses + next, across[next], view.size(), byPose);
                next++;
            }
        }
        double[] ofPose = mode.covariance();
        for (int a = 0; a < size; a++) {
            double[] gain = new double[columns];
            for (int k = 0; k < columns; k++) {
                for (int l = 0; l < columns; l++) {
                    gain[l] += byPose[a][k] * ofPose[k * columns + l];
                }
            }
            for (int b = 0; b <= a; b++) {
                double s = 0;
                if (a >= firstOfCauses) {
                    s = b >= firstOfCauses ? product(across[a - firstOfCauses], 0, across[b - firstOfCauses])
                            : product(across[a - firstOfCauses], 8 * (b / COORDINATES), directions[b]);
                } else if (a / COORDINATES == b / COORDINATES) {
                    s = product(directions[a], 0, directions[b]);
                }
                for (int k = 0; k < columns; k++) {
                    s -= gain[k] * byPose[b][k];
                }
                covariance[a * size + b] = s;
                covariance[b * size + a] = s;
            }
        }
    }

    private static double[] whitened(double[] column, int references, double[] whitening) {
        double[] out = new double[column.length];
        for (int m = 0; m < references; m++) {
            for (int i = 0; i < 8; i++) {
                double d = 0;
                for (int k = 0; k <= i; k++) {
                    d += whitening[64 * m + 8 * i + k] * column[8 * m + k];
                }
                out[8 * m + i] = d;
            }
        }
        return out;
    }

    private void addAcross(int at, double[] direction, int references, double[][] byPose) {
        int columns = mode.dimension();
        for (int m = 0; m < references; m++) {
            double[] residual = mode.whitenedResiduals(m);
            double[] jacobian = mode.jacobian(m);
            for (int i = 0; i < 8; i++) {
                double d = direction[8 * m + i];
                whole[at] += d * d;
                scores[at] -= d * residual[i];
                for (int k = 0; k < columns; k++) {
                    byPose[at][k] += d * jacobian[i * columns + k];
                }
            }
        }
    }

    private static double product(double[] a, int from, double[] b) {
        double s = 0;
        for (int i = 0; i < b.length; i++) {
            s += a[from + i] * b[i];
        }
        return s;
    }

    /** Number of scores: six per reference, then the columns of all causes. */
    int size() {
        return size;
    }

    /** Where the columns of causes begin. */
    int firstOfCauses() {
        return firstOfCauses;
    }

    /**
     * The same scores if the size of a column is unknown: what the fit would leave of them if it had that unknown, too.
     *
     * @return this where nothing is left of the column
     */
    PlacementScores without(int column) {
        double own = covariance[column * size + column];
        if (!(own > ABSORBED * whole[column])) {
            return this;
        }
        double[] left = scores.clone();
        double[] leftCovariance = covariance.clone();
        for (int a = 0; a < size; a++) {
            double gain = covariance[a * size + column] / own;
            left[a] -= gain * scores[column];
            for (int b = 0; b < size; b++) {
                leftCovariance[a * size + b] -= gain * covariance[column * size + b];
            }
        }
        return new PlacementScores(this, left, leftCovariance);
    }

    /**
     * The sizes of one or two columns that fit best if they alone are unknown.
     *
     * @return null where nothing is left of them
     */
    double @Nullable [] best(int first, int columns) {
        double[] information = information(first, columns);
        if (!Cholesky.factor(information, columns)) {
            return null;
        }
        double[] out = new double[columns];
        System.arraycopy(scores, first, out, 0, columns);
        Cholesky.solveLower(information, columns, out);
        Cholesky.solveUpper(information, columns, out);
        return out;
    }

    /** Standard deviation of the worst told of these sizes. */
    double bestStd(int first, int columns) {
        double[] covariance = Cholesky.inverse(information(first, columns), columns);
        double most = 0;
        for (int c = 0; c < columns && covariance != null; c++) {
            most = Math.max(most, Math.sqrt(covariance[c * (columns + 1)]));
        }
        return most;
    }

    private double[] information(int first, int columns) {
        double[] out = new double[columns * columns];
        for (int a = 0; a < columns; a++) {
            for (int b = 0; b < columns; b++) {
                out[a * columns + b] = covariance[(first + a) * size + first + b];
            }
            // what is left by rounding alone is nothing
            out[a * (columns + 1)] -= ABSORBED * whole[first + a];
        }
        return out;
    }

    /** How much of chi-square an unknown size of a column takes: distributed like that of one degree of freedom. */
    double explained(int column) {
        double own = covariance[column * size + column];
        return own > ABSORBED * whole[column] ? scores[column] * scores[column] / own : 0;
    }

    /**
     * Score of a direction.
     *
     * @param first the score that it begins with: six times the reference, or a column of a cause
     * @param direction by score from there on; of a reference in stated deviations
     */
    double score(int first, double[] direction) {
        double sum = 0;
        for (int c = 0; c < direction.length; c++) {
            sum += direction[c] * scores[first + c];
        }
        return sum;
    }

    /**
     * Variance of that score under the model: of a reference at most 1, and 1 where neither the pose nor corner noise
     * takes anything of it; 0 where all that is left is rounding.
     */
    double variance(int first, double[] direction) {
        double all = 0;
        for (int c = 0; c < direction.length; c++) {
            all += direction[c] * direction[c] * whole[first + c];
        }
        double sum = covariance(first, direction, first, direction);
        return sum > ABSORBED * all ? sum : 0;
    }

    /** Covariance of the scores of two directions. */
    double covariance(int first, double[] direction, int second, double[] other) {
        double sum = 0;
        for (int c = 0; c < direction.length; c++) {
            for (int e = 0; e < other.length; e++) {
                sum += direction[c] * other[e] * covariance[(first + c) * size + second + e];
            }
        }
        return sum;
    }

    /**
     * Scores as products with independent standard normal numbers: a lower triangular matrix, row by row, whose product
     * with its own transpose is their covariance (but for a billionth, which keeps it definite).
     */
    double[] factor() {
        double[] l = covariance.clone();
        for (int i = 0; i < size; i++) {
            l[i * size + i] += ABSORBED * (whole[i] > 0 ? whole[i] : 1);
        }
        if (!Cholesky.factor(l, size)) {
            throw new IllegalStateException("covariance of scores is not definite");
        }
        return l;
    }

    /**
     * Chi-square of the residuals of one reference, normalised by the covariance that the model gives them after the
     * fit, and its degrees of freedom: what the fit has absorbed is left out.
     *
     * @return chi-square, degrees of freedom
     */
    double[] chiSquare(int reference) {
        EigenDecomposition_F64<DMatrixRMaj> eigen = DecompositionFactory_DDRM.eig(8, true, true);
        if (!eigen.decompose(new DMatrixRMaj(8, 8, true, mode.redundancy(reference)))) {
            return new double[] {Double.NaN, 0};
        }
        double[] residual = mode.whitenedResiduals(reference);
        double sum = 0;
        int degrees = 0;
        for (int k = 0; k < 8; k++) {
            double variance = eigen.getEigenvalue(k).getReal();
            if (variance > NOTHING_LEFT) {
                double along = 0;
                for (int i = 0; i < 8; i++) {
                    along += eigen.getEigenVector(k).get(i, 0) * residual[i];
                }
                sum += along * along / variance;
                degrees++;
            }
        }
        return new double[] {sum, degrees};
    }
}
