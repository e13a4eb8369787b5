package org.cellgauge.internal.statistics;

/** What every covariance matrix must satisfy before it is used. */
public final class CovarianceChecks {
    /** Largest asymmetry, relative to the two standard deviations, that passes for rounding. */
    static final double ASYMMETRY = 1e-9;

    /** Most negative eigenvalue of a correlation matrix that passes for rounding. */
    static final double NEGATIVE = 1e-9;

    private CovarianceChecks() {}

    /**
     * Checks shape, finiteness, symmetry and the diagonal, and returns the standard deviations.
     *
     * @param covariance matrix of any size
     * @param dimension expected size
     * @return square roots of the diagonal
     * @throws IllegalArgumentException if a check fails
     */
    public static double[] standardDeviations(double[][] covariance, int dimension) {
        if (covariance.length != dimension) {
            throw new IllegalArgumentException(
                    "expected a covariance of " + dimension + " rows, got " + covariance.length);
        }
        double[] std = new double[dimension];
        for (int i = 0; i < dimension; i++) {
            if (covariance[i].length != dimension) {
                throw new IllegalArgumentException("expected a covariance of " + dimension + " columns, row " + i
                        + " has " + covariance[i].length);
            }
            for (double c : covariance[i]) {
                if (!Double.isFinite(c)) {
                    throw new IllegalArgumentException("covariance holds " + c + " in row " + i);
                }
            }
            if (covariance[i][i] < 0) {
                throw new IllegalArgumentException("variance " + i + " is negative: " + covariance[i][i]);
            }
            std[i] = Math.sqrt(covariance[i][i]);
        }
        for (int i = 0; i < dimension; i++) {
            for (int j = 0; j < i; j++) {
                double scale = std[i] * std[j];
                if (Math.abs(covariance[i][j] - covariance[j][i]) > ASYMMETRY * scale) {
                    throw new IllegalArgumentException("covariance is not symmetric: (" + i + ", " + j + ") is "
                            + covariance[i][j] + ", (" + j + ", " + i + ") is " + covariance[j][i]);
                }
                if (Math.abs(covariance[i][j]) > scale * (1 + NEGATIVE)) {
                    throw notPositive("components " + i + " and " + j + " would have a correlation beyond 1");
                }
            }
        }
        return std;
    }

    public static void requireFinite(double[] vector, String name) {
        for (double x : vector) {
            if (!Double.isFinite(x)) {
                throw new IllegalArgumentException(name + " holds " + x);
            }
        }
    }

    static IllegalArgumentException notPositive(String why) {
        return new IllegalArgumentException("covariance is not positive semi-definite: " + why);
    }
}
