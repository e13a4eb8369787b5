package org.cellgauge.internal.plan;

import java.util.stream.IntStream;
import org.cellgauge.internal.geometry.Cholesky;

/**
 * What a set of observations is to be good for, by Fisher information: the largest variance of some linear functions of
 * the unknowns, each in its own unit; with room for one evaluation, so not thread-safe.
 *
 * <p>{@code f(I) = max_a sum_r c_r^T I^-1 c_r + d_r}, over functions a of all views and the rows r of each,
 * is convex in the information I and falls with it: E- and G-optimal designs are of this kind (Pukelsheim, "Optimal Design of Experiments", 2006, chapter 6).
 */
public final class Design {
    private final int n;
    private final double[][] rows;
    /** Where the rows of each function end. */
    private final int[] ends;
    private final double[] own;
    private final double[] factor;
    private final double[] scratch;

    /**
     * Functions of one row each.
     *
     * @param n number of unknowns
     * @param rows as in {@link #Design(int, double[][], double[], int[])}
     * @param own as there
     */
    public Design(int n, double[][] rows, double[] own) {
        this(n, rows, own, IntStream.rangeClosed(1, own.length).toArray());
    }

    /**
     * Functions of the unknowns of one view.
     *
     * @param n number of unknowns
     * @param rows the functions, n values each; in such units that 1 is what is asked for
     * @param own variance of each row beside what the unknowns leave
     * @param ends of each function the row after its last: variances of its rows add up
     */
    public Design(int n, double[][] rows, double[] own, int[] ends) {
        this.n = n;
        this.rows = rows;
        this.own = own;
        this.ends = ends;
        factor = new double[n * n];
        scratch = new double[n];
    }

    /** Number of unknowns. */
    public int unknowns() {
        return n;
    }

    /** Number of functions. */
    public int functions() {
        return ends.length;
    }

    /** The row after the last of a function; its first is that of the function before. */
    int end(int a) {
        return a < 0 ? 0 : ends[a];
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
        int row = 0;
        for (int end : ends) {
            double sum = 0;
            while (row < end) {
                sum += variance(row++);
            }
            worst = Math.max(worst, sum);
        }
        return worst;
    }

    /** Of a row, by the information factored last. */
    private double variance(int row) {
        System.arraycopy(rows[row], 0, scratch, 0, n);
        Cholesky.solveLower(factor, n, scratch);
        double sum = own[row];
        for (int i = 0; i < n; i++) {
            sum += scratch[i] * scratch[i];
        }
        return sum;
    }

    /**
     * All variances, and for each row {@code x_r = I^-1 c_r}: the derivative of the variance by the information is
     * the sum of {@code -x_r x_r^T}.
     *
     * @param information n x n
     * @param variances receives one for each function
     * @param solutions receives n values for each row
     * @return false where the information is singular
     */
    boolean variances(double[] information, double[] variances, double[][] solutions) {
        System.arraycopy(information, 0, factor, 0, n * n);
        if (!Cholesky.factor(factor, n)) {
            return false;
        }
        for (int a = 0; a < ends.length; a++) {
            variances[a] = 0;
            for (int row = end(a - 1); row < ends[a]; row++) {
                variances[a] += variance(row);
                System.arraycopy(scratch, 0, solutions[row], 0, n);
                Cholesky.solveUpper(factor, n, solutions[row]);
            }
        }
        return true;
    }
}
