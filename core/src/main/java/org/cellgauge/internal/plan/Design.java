package org.cellgauge.internal.plan;

import org.cellgauge.internal.geometry.Cholesky;

/**
 * What a set of observations is to be good for, by Fisher information: the largest variance of some linear functions of
 * the unknowns, each in its own unit; with room for one evaluation, so not thread-safe.
 *
 * <p>{@code f(I) = max_a c_a^T I^-1 c_a + d_a}, over functions a of all views, is convex in the information I and falls
 * with it: E- and G-optimal designs are of this kind (Pukelsheim, "Optimal Design of Experiments", 2006, chapter 6).
 */
public final class Design {
    private final int n;
    private final double[][] rows;
    private final double[] own;
    private final double[] factor;
    private final double[] scratch;

    /**
     * Functions of the unknowns of one view.
     *
     * @param n number of unknowns
     * @param rows the functions, n values each; in such units that 1 is what is asked for
     * @param own variance of each beside what the unknowns leave
     */
    public Design(int n, double[][] rows, double[] own) {
        this.n = n;
        this.rows = rows;
        this.own = own;
        factor = new double[n * n];
        scratch = new double[n];
    }

    /** Number of unknowns. */
    public int unknowns() {
        return n;
    }

    /** Number of functions. */
    public int functions() {
        return own.length;
    }

    /**
     * The largest variance. Allocates nothing.
     *
     * @param information n x n
     * @return infinite where it is singular; 0 where there are no functions
     */
    public double worst(double[] information) {
        System.arraycopy(information, 0, factor, 0, n * n);
        if (!Cholesky.factor(factor, n)) {
            return Double.POSITIVE_INFINITY;
        }
        double worst = 0;
        for (int a = 0; a < own.length; a++) {
            worst = Math.max(worst, variance(a));
        }
        return worst;
    }

    /** Of the information factored last. */
    private double variance(int a) {
        System.arraycopy(rows[a], 0, scratch, 0, n);
        Cholesky.solveLower(factor, n, scratch);
        double sum = own[a];
        for (int i = 0; i < n; i++) {
            sum += scratch[i] * scratch[i];
        }
        return sum;
    }

    /**
     * All variances, and for each {@code x_a = I^-1 c_a}: the derivative of the variance by the information is
     * {@code -x_a x_a^T}.
     *
     * @param information n x n
     * @param variances receives one for each function
     * @param solutions receives n values for each function
     * @return false where the information is singular
     */
    boolean variances(double[] information, double[] variances, double[][] solutions) {
        System.arraycopy(information, 0, factor, 0, n * n);
        if (!Cholesky.factor(factor, n)) {
            return false;
        }
        for (int a = 0; a < own.length; a++) {
            variances[a] = variance(a);
            System.arraycopy(scratch, 0, solutions[a], 0, n);
            Cholesky.solveUpper(factor, n, solutions[a]);
        }
        return true;
    }
}
