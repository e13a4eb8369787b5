package org.cellgauge.internal.geometry;

import org.jspecify.annotations.Nullable;

/**
 * Cholesky factors of small symmetric positive definite matrices in plain arrays, row by row, without allocation.
 *
 * <p>Chains and least squares factor and solve 6x6 to 8x8 systems many thousands of times; library matrices would
 * allocate in every one. Algorithm: Golub and Van Loan, "Matrix Computations", 4th ed. 2013, section 4.2.
 */
public final class Cholesky {
    private Cholesky() {
    }

    /**
     * Factors a = L L^T in place.
     *
     * @param a n x n values row by row, symmetric (its lower triangle is read); receives L in the lower triangle and
     *     zeros above
     * @param n rows
     * @return false if the matrix is not positive definite (or not finite); {@code a} is then destroyed
     */
    public static boolean factor(double[] a, int n) {
        for (int j = 0; j < n; j++) {
            double d = a[j * n + j];
            for (int k = 0; k < j; k++) {
                d -= a[j * n + k] * a[j * n + k];
            }
            if (!(d > 0) || d == Double.POSITIVE_INFINITY) {
                return false;
            }
            double root = Math.sqrt(d);
            a[j * n + j] = root;
            for (int i = j + 1; i < n; i++) {
                double s = a[i * n + j];
                for (int k = 0; k < j; k++) {
                    s -= a[i * n + k] * a[j * n + k];
                }
                a[i * n + j] = s / root;
                a[j * n + i] = 0;
            }
        }
        return true;
    }

    /**
     * Solves L y = b.
     *
     * @param l lower factor, n x n
     * @param n rows
     * @param b right side, n values; receives y
     */
    public static void solveLower(double[] l, int n, double[] b) {
        for (int i = 0; i < n; i++) {
            double s = b[i];
            for (int k = 0; k < i; k++) {
                s -= l[i * n + k] * b[k];
            }
            b[i] = s / l[i * n + i];
        }
    }

    /**
     * Solves L^T x = y.
     *
     * @param l lower factor, n x n
     * @param n rows
     * @param y right side, n values; receives x
     */
    public static void solveUpper(double[] l, int n, double[] y) {
        for (int i = n - 1; i >= 0; i--) {
            double s = y[i];
            for (int k = i + 1; k < n; k++) {
                s -= l[k * n + i] * y[k];
            }
            y[i] = s / l[i * n + i];
        }
    }

    /**
     * Inverse of a lower factor, itself lower.
     *
     * @param l lower factor, n x n
     * @param n rows
     * @param out n x n; must not be l
     */
    public static void invertLower(double[] l, int n, double[] out) {
        for (int j = 0; j < n; j++) {
            for (int i = 0; i < j; i++) {
                out[i * n + j] = 0;
            }
            out[j * n + j] = 1 / l[j * n + j];
            for (int i = j + 1; i < n; i++) {
                double s = 0;
                for (int k = j; k < i; k++) {
                    s -= l[i * n + k] * out[k * n + j];
                }
                out[i * n + j] = s / l[i * n + i];
            }
        }
    }

    /**
     * Inverse of a symmetric positive definite matrix.
     *
     * @param a n x n values row by row; left as it is
     * @param n rows
     * @return a new array with the inverse, or null if the matrix is not positive definite
     */
    public static double @Nullable [] inverse(double[] a, int n) {
        double[] out = new double[n * n];
        return inverse(a.clone(), n, new double[n * n], out) ? out : null;
    }

    /**
     * Inverse of a symmetric positive definite matrix, in arrays of the caller's.
     *
     * @param l n x n values row by row; receives the lower factor
     * @param n rows
     * @param k work space, n x n; receives the inverse of the factor
     * @param out receives the inverse, n x n
     * @return false if the matrix is not positive definite; {@code out} is then left as it is
     */
    public static boolean inverse(double[] l, int n, double[] k, double[] out) {
        if (!factor(l, n)) {
            return false;
        }
        invertLower(l, n, k);
        for (int i = 0; i < n; i++) {
            for (int j = 0; j <= i; j++) {
                double s = 0;
                for (int m = i; m < n; m++) {
                    s += k[m * n + i] * k[m * n + j];
                }
                out[i * n + j] = s;
                out[j * n + i] = s;
            }
        }
        return true;
    }

    /**
     * Half the logarithm of the determinant of a = L L^T.
     *
     * @param l lower factor, n x n
     * @param n rows
     * @return the sum of the logarithms of the diagonal
     */
    public static double halfLogDeterminant(double[] l, int n) {
        double s = 0;
        for (int i = 0; i < n; i++) {
            s += Math.log(l[i * n + i]);
        }
        return s;
    }
}
