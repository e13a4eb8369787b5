package org.cellgauge.internal.estimate;

import java.util.Arrays;

/** Small helpers on matrices of rows. */
public final class Matrices {
    private Matrices() {
    }

    public static double[][] copy(double[][] a) {
        double[][] out = new double[a.length][];
        for (int i = 0; i < a.length; i++) {
            out[i] = a[i].clone();
        }
        return out;
    }

    /** Sets all to zero. */
    public static void clear(double[][] a) {
        for (double[] row : a) {
            Arrays.fill(row, 0);
        }
    }

    /** The leading n x n block. */
    public static double[][] block(double[][] a, int n) {
        double[][] out = new double[n][n];
        for (int i = 0; i < n; i++) {
            System.arraycopy(a[i], 0, out[i], 0, n);
        }
        return out;
    }

    /** a b a^T added to a symmetric out, for a of rows x n and a symmetric b of n x n row by row. */
    public static void addSandwich(double[][] a, double[] b, int n, double[][] out) {
        addSandwich(a, b, n, out, new double[n]);
    }

    /** The same with work space of at least n values. */
    public static void addSandwich(double[][] a, double[] b, int n, double[][] out, double[] ab) {
        for (int i = 0; i < a.length; i++) {
            Arrays.fill(ab, 0, n, 0);
            for (int k = 0; k < n; k++) {
                for (int l = 0; l < n; l++) {
                    ab[l] += a[i][k] * b[k * n + l];
                }
            }
            for (int j = 0; j <= i; j++) {
                double s = 0;
                for (int l = 0; l < n; l++) {
                    s += ab[l] * a[j][l];
                }
                out[i][j] += s;
                // symmetric to the last digit
                out[j][i] = out[i][j];
            }
        }
    }
}
