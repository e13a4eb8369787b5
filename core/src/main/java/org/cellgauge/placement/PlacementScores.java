package org.cellgauge.placement;

import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
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
    /** The whitened residuals' change by each coordinate, 8 values of its own reference's. */
    private final double[][] directions;
    /** By each column of a cause, those of all references. */
    private final double[][] across;
    /**
     * What unknowns take of the scores: their covariance is that of the directions less the sum of f f^T over these
     * columns, first those of the pose, then those swept out. Kept so, drawing and covariances cost as much as there
     * are references, not its square.
     */
    private final double[][] taken;
    private final int ofPose;
    /** Derivative of each reference's whitened residuals by the pose's unknowns, 8 rows. */
    private final double[][] jacobians;
    /** The pose's columns by its own unknowns, and what priors add to their draws; lower triangles, row by row. */
    private final double[] poseFactor;
    private final double[] priorFactor;
    /** Which column each of the others was made by. */
    private final int[] swept;

    /** The same with the scores of a direction swept out. */
    private PlacementScores(PlacementScores other, double[] scores, double[] column, int by) {
        mode = other.mode;
        firstOfCauses = other.firstOfCauses;
        size = other.size;
        whole = other.whole;
        directions = other.directions;
        across = other.across;
        ofPose = other.ofPose;
        jacobians = other.jacobians;
        poseFactor = other.poseFactor;
        priorFactor = other.priorFactor;
        this.scores = scores;
        taken = Arrays.copyOf(other.taken, other.taken.length + 1);
        taken[other.taken.length] = column;
        swept = Arrays.copyOf(other.swept, other.swept.length + 1);
        swept[other.swept.length] = by;
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
        ofPose = mode.dimension();
        RigidMarkerNoise geometry = new RigidMarkerNoise(view, 1).about(mode.placed());
        CameraState state = mode.state();
        double[] whitening = mode.whitening();
        double[] byPlacement = new double[8 * COORDINATES];
        directions = new double[firstOfCauses][8];
        double[][] byPose = new double[size][ofPose];
        double[] information = new double[ofPose * ofPose];
        jacobians = new double[view.size()][];
        for (int m = 0; m < view.size(); m++) {
            geometry.jacobian(state, m, byPlacement);
            Placement placement = view.references().get(m).placement();
            double[] residual = mode.whitenedResiduals(m);
            double[] jacobian = mode.jacobian(m);
            jacobians[m] = jacobian;
            for (int i = 0; i < 8; i++) {
                for (int k = 0; k < ofPose; k++) {
                    for (int l = 0; l < ofPose; l++) {
                        information[k * ofPose + l] += jacobian[i * ofPose + k] * jacobian[i * ofPose + l];
                    }
                }
            }
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
                    for (int k = 0; k < ofPose; k++) {
                        byPose[at][k] += d * jacobian[i * ofPose + k];
                    }
                }
            }
        }
        across = new double[columnsOfCauses][];
        int next = 0;
        for (CausePattern cause : causes) {
            for (double[] column : cause.columnsPx) {
                across[next] = whitened(column, view.size(), whitening);
                addAcross(firstOfCauses + next, across[next], view.size(), byPose);
                next++;
            }
        }
        poseFactor = mode.covariance();
        if (!Cholesky.factor(poseFactor, ofPose)) {
            throw new IllegalStateException("covariance of the pose is not definite");
        }
        taken = new double[ofPose][size];
        for (int a = 0; a < size; a++) {
            for (int k = 0; k < ofPose; k++) {
                for (int l = k; l < ofPose; l++) {
                    taken[k][a] += byPose[a][l] * poseFactor[l * ofPose + k];
                }
            }
        }
        priorFactor = priorFactor(information);
        swept = new int[0];
    }

    /**
     * What is left of the identity where photos alone do not tell the unknowns, as a factor: with L the factor of their
     * covariance, I - L^T J^T J L, which is nothing where there are no priors.
     */
    private double[] priorFactor(double[] information) {
        double[] left = new double[ofPose * ofPose];
        for (int a = 0; a < ofPose; a++) {
            for (int b = 0; b < ofPose; b++) {
                double sum = a == b ? 1 + NOTHING_LEFT : 0;
                for (int k = a; k < ofPose; k++) {
                    for (int l = b; l < ofPose; l++) {
                        sum -= poseFactor[k * ofPose + a] * information[k * ofPose + l] * poseFactor[l * ofPose + b];
                    }
                }
                left[a * ofPose + b] = sum;
            }
        }
        // rounding may leave less than nothing: then there are no priors
        return Cholesky.factor(left, ofPose) ? left : new double[ofPose * ofPose];
    }

    /**
     * Draws all scores as they are where nothing is off: normal numbers for every corner, taken through the fit.
     *
     * @param random source of randomness
     * @param out receives one value per score
     */
    void draw(RandomGenerator random, double[] out) {
        Arrays.fill(out, 0, size, 0);
        double[] byPose = new double[ofPose];
        double[] residual = new double[8];
        for (int m = 0; m < firstOfCauses / COORDINATES; m++) {
            for (int i = 0; i < 8; i++) {
                residual[i] = random.nextGaussian();
            }
            for (int c = COORDINATES * m; c < COORDINATES * (m + 1); c++) {
                for (int i = 0; i < 8; i++) {
                    out[c] += directions[c][i] * residual[i];
                }
            }
            for (int c = 0; c < across.length; c++) {
                for (int i = 0; i < 8; i++) {
                    out[firstOfCauses + c] += across[c][8 * m + i] * residual[i];
                }
            }
            for (int i = 0; i < 8; i++) {
                for (int k = 0; k < ofPose; k++) {
                    byPose[k] += jacobians[m][i * ofPose + k] * residual[i];
                }
            }
        }
        double[] normal = new double[ofPose];
        for (int k = 0; k < ofPose; k++) {
            normal[k] = random.nextGaussian();
        }
        for (int k = 0; k < ofPose; k++) {
            double of = 0;
            for (int l = k; l < ofPose; l++) {
                of += poseFactor[l * ofPose + k] * byPose[l];
            }
            for (int l = 0; l <= k; l++) {
                of += priorFactor[k * ofPose + l] * normal[l];
            }
            for (int a = 0; a < size; a++) {
                out[a] -= taken[k][a] * of;
            }
        }
        for (int s = 0; s < swept.length; s++) {
            double[] column = taken[ofPose + s];
            double share = out[swept[s]] / column[swept[s]];
            for (int a = 0; a < size; a++) {
                out[a] -= column[a] * share;
            }
        }
    }

    /** Covariance of two scores. */
    private double covariance(int a, int b) {
        double s = beforeFit(a, b);
        for (double[] column : taken) {
            s -= column[a] * column[b];
        }
        return s;
    }

    /** Covariance of two scores if no unknown took anything of them: none where they are of different references. */
    private double beforeFit(int a, int b) {
        if (a >= firstOfCauses && b >= firstOfCauses) {
            return product(across[a - firstOfCauses], 0, across[b - firstOfCauses]);
        } else if (a >= firstOfCauses) {
            return product(across[a - firstOfCauses], 8 * (b / COORDINATES), directions[b]);
        } else if (b >= firstOfCauses) {
            return product(across[b - firstOfCauses], 8 * (a / COORDINATES), directions[a]);
        }
        return a / COORDINATES == b / COORDINATES ? product(directions[a], 0, directions[b]) : 0;
    }

    /**
     * Covariances of the score of a direction with all scores.
     *
     * @param first the score that it begins with
     * @param direction by score from there on
     * @param ofOne room for one value per score
     * @param out receives one value per score
     */
    void covariances(int first, double[] direction, double[] ofOne, double[] out) {
        Arrays.fill(out, 0, size, 0);
        for (int c = 0; c < direction.length; c++) {
            if (direction[c] != 0) {
                for (int a = 0; a < size; a++) {
                    ofOne[a] = beforeFit(first + c, a);
                }
                for (double[] column : taken) {
                    double own = column[first + c];
                    for (int a = 0; a < size; a++) {
                        ofOne[a] -= own * column[a];
                    }
                }
                for (int a = 0; a < size; a++) {
                    out[a] += direction[c] * ofOne[a];
                }
            }
        }
    }

    /**
     * What unknowns take of the score of a direction: the covariance of two directions of different references is minus
     * the product of what is taken of them.
     *
     * @return one value per unknown of the pose and per column swept out
     */
    double[] taken(int first, double[] direction) {
        double[] out = new double[taken.length];
        for (int k = 0; k < out.length; k++) {
            for (int c = 0; c < direction.length; c++) {
                out[k] += direction[c] * taken[k][first + c];
            }
        }
        return out;
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
        double own = covariance(column, column);
        if (!(own > ABSORBED * whole[column])) {
            return this;
        }
        double[] left = scores.clone();
        double[] taking = new double[size];
        double share = scores[column] / own;
        for (int a = 0; a < size; a++) {
            double with = covariance(a, column);
            left[a] -= with * share;
            taking[a] = with / Math.sqrt(own);
        }
        return new PlacementScores(this, left, taking, column);
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
                out[a * columns + b] = covariance(first + a, first + b);
            }
            // what is left by rounding alone is nothing
            out[a * (columns + 1)] -= ABSORBED * whole[first + a];
        }
        return out;
    }

    /** How much of chi-square an unknown size of a column takes: distributed like that of one degree of freedom. */
    double explained(int column) {
        double own = covariance(column, column);
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
                sum += direction[c] == 0 || other[e] == 0 ? 0
                        : direction[c] * other[e] * covariance(first + c, second + e);
            }
        }
        return sum;
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
