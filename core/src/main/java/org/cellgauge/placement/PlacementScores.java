package org.cellgauge.placement;

import org.cellgauge.cell.Placement;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.pose.RigidMarkerNoise;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;

/**
 * What the residuals of a fit say of the placement of its references, in the model linearised at the mode.
 *
 * <p>Coordinate c of reference m (shift along world x, y, z, then turn about x, y, z), one stated deviation long, moves
 * the whitened residuals along d. Its score is {@code d^T P r}, with {@code P = I - J C J^T} what the fit leaves of
 * residuals; under the model all scores together are normal with the covariance {@code d^T P d'} (score test of a mean
 * shift: Cook and Weisberg, "Residuals and Influence in Regression", 1982, section 2.2).
 */
final class PlacementScores {
    /** Coordinates of a placement: shifts along x, y, z, turns about x, y, z. */
    static final int COORDINATES = 6;
    /** Share of a direction's information below which what the fit leaves of it is rounding. */
    private static final double ABSORBED = 1e-9;
    /** Eigenvalue of what is left of residuals below which the fit has absorbed the direction. */
    private static final double NOTHING_LEFT = 1e-6;

    private final PoseMode mode;
    private final int size;
    private final double[] scores;
    private final double[] whole;
    private final double[] covariance;

    PlacementScores(ReferenceView view, PoseMode mode) {
        this.mode = mode;
        size = COORDINATES * view.size();
        scores = new double[size];
        whole = new double[size];
        covariance = new double[size * size];
        int columns = mode.dimension();
        RigidMarkerNoise geometry = new RigidMarkerNoise(view, 1).about(mode.placed());
        CameraState state = mode.state();
        double[] whitening = mode.whitening();
        double[] byPlacement = new double[8 * COORDINATES];
        double[][] directions = new double[size][8];
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
                if (a / COORDINATES == b / COORDINATES) {
                    for (int i = 0; i < 8; i++) {
                        s += directions[a][i] * directions[b][i];
                    }
                }
                for (int k = 0; k < columns; k++) {
                    s -= gain[k] * byPose[b][k];
                }
                covariance[a * size + b] = s;
                covariance[b * size + a] = s;
            }
        }
    }

    /** Score of a direction of one reference's placement, given in stated deviations. */
    double score(int reference, double[] direction) {
        double sum = 0;
        for (int c = 0; c < COORDINATES; c++) {
            sum += direction[c] * scores[COORDINATES * reference + c];
        }
        return sum;
    }

    /**
     * Variance of that score under the model: at most 1, and 1 where neither the pose nor corner noise takes anything
     * of it; 0 where all that is left is rounding.
     */
    double variance(int reference, double[] direction) {
        double sum = 0;
        double all = 0;
        for (int c = 0; c < COORDINATES; c++) {
            int a = COORDINATES * reference + c;
            all += direction[c] * direction[c] * whole[a];
            for (int e = 0; e < COORDINATES; e++) {
                sum += direction[c] * direction[e] * covariance[a * size + COORDINATES * reference + e];
            }
        }
        return sum > ABSORBED * all ? sum : 0;
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
