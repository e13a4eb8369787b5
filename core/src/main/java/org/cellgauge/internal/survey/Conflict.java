package org.cellgauge.internal.survey;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.cellgauge.internal.statistics.ChiSquare;

/**
 * How far something is from what was expected of it: the sum of squares of residuals in units of their deviations, and
 * the chance of as large a sum.
 *
 * @param chiSquare sum of squares
 * @param degrees how many of them are independent; 0 where nothing tells
 */
record Conflict(double chiSquare, int degrees) {
    /** Share of a variance below which a residual is no test: what was expected decides the fit alone there. */
    private static final double LEAST_SHARE = 0.01;

    /**
     * The conflict of residuals that are standard normal before a fit.
     *
     * @param residuals at the fit
     * @param explained covariance of what the fit leaves open of them: that of the residuals is one less this
     * @return the conflict
     */
    static Conflict of(double[] residuals, double[] explained) {
        int n = residuals.length;
        double[][] left = new double[n][n];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                left[i][j] = (i == j ? 1 : 0) - 0.5 * (explained[i * n + j] + explained[j * n + i]);
            }
        }
        EigenDecomposition eigen = new EigenDecomposition(new Array2DRowRealMatrix(left, false));
        double sum = 0;
        int degrees = 0;
        for (int k = 0; k < n; k++) {
            double variance = eigen.getRealEigenvalue(k);
            if (variance > LEAST_SHARE) {
                double along = 0;
                for (int i = 0; i < n; i++) {
                    along += eigen.getEigenvector(k).getEntry(i) * residuals[i];
                }
                sum += along * along / variance;
                degrees++;
            }
        }
        return new Conflict(sum, degrees);
    }

    double chance() {
        return ChiSquare.pValue(chiSquare, degrees);
    }
}
