package org.cellgauge.internal.calibration;

import java.util.Arrays;
import org.cellgauge.geometry.Lens;
import org.cellgauge.internal.geometry.Cholesky;
import org.jspecify.annotations.Nullable;

/**
 * How sure the projection is over the image.
 *
 * <p>A direction's image moves with the lens's parameters, and moves just as much when the whole camera is turned. A
 * turn costs nobody anything, since poses are estimated with every photo; so the turn that makes good most of a change,
 * over the part of the image that the target covered, is taken out first (as mrcal's projection differences do).
 */
final class ProjectionMap {
    /** Places along the image's width. */
    static final int COLUMNS = 15;
    /** Places along its height. */
    static final int ROWS = 11;
    /** Weight of places that the target never covered, where the turn is looked for. */
    private static final double UNCOVERED = 1e-3;

    final double[] u = new double[COLUMNS * ROWS];
    final double[] v = new double[COLUMNS * ROWS];
    final boolean[] seen = new boolean[COLUMNS * ROWS];
    final double[] weight = new double[COLUMNS * ROWS];
    private final Lens lens;
    private final double[] rays = new double[3 * COLUMNS * ROWS];
    /** Derivatives by the unknowns, a turn taken out: 2 rows for every place. */
    private final double[] free;
    private final double[] byTurn = new double[6 * COLUMNS * ROWS];
    private final double[] turnFactor = new double[9];
    private final int unknowns;

    /**
     * The map of a fit.
     *
     * @param coverage shares of points by cell, {@link Coverage}
     */
    ProjectionMap(LensChoice choice, double[] values, int widthPx, int heightPx, Coverage coverage) {
        lens = choice.lens();
        unknowns = choice.unknowns();
        free = new double[2 * COLUMNS * ROWS * unknowns];
        double[] ray = new double[3];
        double[] uv = new double[2];
        double[] byPoint = new double[6];
        double[] byLens = new double[2 * lens.parameterCount()];
        double[] rowU = new double[unknowns];
        double[] rowV = new double[unknowns];
        for (int k = 0; k < u.length; k++) {
            int row = k / COLUMNS;
            u[k] = widthPx * (k % COLUMNS + 0.5) / COLUMNS;
            v[k] = heightPx * (row + 0.5) / ROWS;
            seen[k] = lens.toRay(values, u[k], v[k], ray)
                    && lens.projectWithDerivatives(values, ray[0], ray[1], ray[2], uv, byPoint, byLens);
            if (!seen[k]) {
                continue;
            }
            weight[k] = coverage.covers(u[k], v[k]) ? 1 : UNCOVERED;
            System.arraycopy(ray, 0, rays, 3 * k, 3);
            choice.select(byLens, rowU, rowV);
            System.arraycopy(rowU, 0, free, 2 * k * unknowns, unknowns);
            System.arraycopy(rowV, 0, free, (2 * k + 1) * unknowns, unknowns);
            for (int axis = 0; axis < 2; axis++) {
                double a = byPoint[3 * axis];
                double b = byPoint[3 * axis + 1];
                double c = byPoint[3 * axis + 2];
                byTurn[6 * k + 3 * axis] = c * ray[1] - b * ray[2];
                byTurn[6 * k + 3 * axis + 1] = a * ray[2] - c * ray[0];
                byTurn[6 * k + 3 * axis + 2] = b * ray[0] - a * ray[1];
            }
        }
        for (int k = 0; k < u.length; k++) {
            for (int row = 0; row < 2; row++) {
                for (int a = 0; a < 3; a++) {
                    for (int b = 0; b < 3; b++) {
                        turnFactor[3 * a + b] += weight[k] * byTurn[6 * k + 3 * row + a]
                                * byTurn[6 * k + 3 * row + b];
                    }
                }
            }
        }
        Cholesky.factor(turnFactor, 3);
        double[] column = new double[2 * u.length];
        for (int p = 0; p < unknowns; p++) {
            for (int i = 0; i < column.length; i++) {
                column[i] = free[i * unknowns + p];
            }
            takeTurnOut(column);
            for (int i = 0; i < column.length; i++) {
                free[i * unknowns + p] = column[i];
            }
        }
    }

    /** Takes out of shifts of all places (du, dv each) the turn that makes good most of them. */
    private void takeTurnOut(double[] shifts) {
        double[] turn = new double[3];
        for (int k = 0; k < u.length; k++) {
            for (int row = 0; row < 2; row++) {
                for (int a = 0; a < 3; a++) {
                    turn[a] += weight[k] * byTurn[6 * k + 3 * row + a] * shifts[2 * k + row];
                }
            }
        }
        Cholesky.solveLower(turnFactor, 3, turn);
        Cholesky.solveUpper(turnFactor, 3, turn);
        for (int k = 0; k < u.length; k++) {
            for (int row = 0; row < 2; row++) {
                for (int a = 0; a < 3; a++) {
                    shifts[2 * k + row] -= byTurn[6 * k + 3 * row + a] * turn[a];
                }
            }
        }
    }

    /**
     * Covariance at a place: of u, of u and v, of v, px².
     *
     * @param covariance of unknowns, those of the lens first
     * @param size rows of it
     */
    double[] covariance(int place, double[] covariance, int size) {
        double[] out = new double[3];
        int first = 2 * place * unknowns;
        int second = first + unknowns;
        for (int a = 0; a < unknowns; a++) {
            double su = 0;
            double sv = 0;
            for (int b = 0; b < unknowns; b++) {
                su += covariance[a * size + b] * free[first + b];
                sv += covariance[a * size + b] * free[second + b];
            }
            out[0] += free[first + a] * su;
            out[1] += free[first + a] * sv;
            out[2] += free[second + a] * sv;
        }
        return out;
    }

    /** Deviation at a place in the direction where it is largest, px. */
    double stdPx(int place, double[] covariance, int size) {
        double[] c = covariance(place, covariance, size);
        double mean = (c[0] + c[2]) / 2;
        return Math.sqrt(Math.max(0, mean + Math.hypot((c[0] - c[2]) / 2, c[1])));
    }

    /** Mean variance of a coordinate over the image, px²; infinite without a covariance. */
    double meanVariance(double @Nullable [] covariance, int size) {
        if (covariance == null) {
            return Double.POSITIVE_INFINITY;
        }
        double sum = 0;
        double of = 0;
        for (int k = 0; k < u.length; k++) {
            if (seen[k]) {
                double[] c = covariance(k, covariance, size);
                sum += (c[0] + c[2]) / 2;
                of++;
            }
        }
        return sum / of;
    }

    /** By how much the images of this map's directions differ between two sets of values: du, dv, px; NaN unseen. */
    double[] difference(double[] a, double[] b) {
        double[] shifts = new double[2 * u.length];
        double[] at = new double[4];
        boolean[] missing = new boolean[u.length];
        for (int k = 0; k < u.length; k++) {
            missing[k] = !seen[k] || !lens.project(a, rays[3 * k], rays[3 * k + 1], rays[3 * k + 2], at, 0)
                    || !lens.project(b, rays[3 * k], rays[3 * k + 1], rays[3 * k + 2], at, 2);
            if (!missing[k]) {
                shifts[2 * k] = at[0] - at[2];
                shifts[2 * k + 1] = at[1] - at[3];
            }
        }
        takeTurnOut(shifts);
        for (int k = 0; k < u.length; k++) {
            if (missing[k]) {
                Arrays.fill(shifts, 2 * k, 2 * k + 2, Double.NaN);
            }
        }
        return shifts;
    }
}
