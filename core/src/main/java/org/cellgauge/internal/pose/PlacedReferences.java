package org.cellgauge.internal.pose;

import org.cellgauge.internal.geometry.Rotations;

/**
 * Where references are taken to stand: each moved rigidly off its nominal place by a placement error. A model that is
 * linear in placement errors is linearised here; immutable but for who makes one and has not shown it yet.
 *
 * <p>An error is a shift along the world axes in mm and a rotation vector w about the marker's own centre in world axes
 * in rad: a corner at the arm a from the centre stands at {@code centre + shift + exp(w) a}, exactly.
 */
public final class PlacedReferences {
    private final double[] errors;
    private final double[] points;
    private final double[] arms;
    private final double[] turns;

    private PlacedReferences(double[] errors, double[] points, double[] arms, double[] turns) {
        this.errors = errors;
        this.points = points;
        this.arms = arms;
        this.turns = turns;
    }

    /**
     * References that stand where the cell file has them.
     *
     * @param view the references
     * @return their places without errors
     */
    public static PlacedReferences nominal(Observations view) {
        return view.nominal();
    }

    /**
     * References moved by placement errors.
     *
     * @param view the references
     * @param errors 6 values per reference: shift along world x, y, z in mm, rotation vector in world axes in rad;
     *     copied
     * @return where they stand
     * @throws IllegalArgumentException if there are not 6 values per reference
     */
    public static PlacedReferences of(Observations view, double[] errors) {
        int n = view.size();
        if (errors.length != 6 * n) {
            throw new IllegalArgumentException("needs " + 6 * n + " values, not " + errors.length);
        }
        PlacedReferences placed = new PlacedReferences(new double[errors.length], new double[view.points().length],
                new double[view.points().length], new double[9 * n]);
        placed.set(view, errors);
        return placed;
    }

    /** A copy that shares nothing. */
    PlacedReferences copy() {
        return new PlacedReferences(errors.clone(), points.clone(), arms.clone(), turns.clone());
    }

    /** Moves references to where others of as many corners stand: only of who made this object and has not shown it. */
    void set(PlacedReferences other) {
        System.arraycopy(other.errors, 0, errors, 0, errors.length);
        System.arraycopy(other.points, 0, points, 0, points.length);
        System.arraycopy(other.arms, 0, arms, 0, arms.length);
        System.arraycopy(other.turns, 0, turns, 0, turns.length);
    }

    /** Moves them by placement errors; likewise. */
    void set(Observations view, double[] to) {
        System.arraycopy(to, 0, errors, 0, errors.length);
        double[] nominal = view.points();
        double[] nominalArms = view.arms();
        double[] turn = new double[9];
        for (int m = 0; m < view.size(); m++) {
            double wx = errors[6 * m + 3];
            double wy = errors[6 * m + 4];
            double wz = errors[6 * m + 5];
            Rotations.exp(wx, wy, wz, turn);
            for (int k = 3 * view.blocks().firstPoint(m); k < 3 * view.blocks().firstPoint(m + 1); k += 3) {
                for (int i = 0; i < 3; i++) {
                    arms[k + i] = turn[3 * i] * nominalArms[k] + turn[3 * i + 1] * nominalArms[k + 1]
                            + turn[3 * i + 2] * nominalArms[k + 2];
                    points[k + i] = nominal[k + i] + (errors[6 * m + i] + arms[k + i] - nominalArms[k + i]);
                }
            }
            Rotations.leftJacobian(wx, wy, wz, turn);
            System.arraycopy(turn, 0, turns, 9 * m, 9);
        }
    }

    /**
     * The placement errors.
     *
     * @return a copy, 6 values per reference: shift along world x, y, z in mm, rotation vector in world axes in rad
     */
    public double[] errors() {
        return errors.clone();
    }

    /** One of the errors, by reference and coordinate. */
    double error(int marker, int coordinate) {
        return errors[6 * marker + coordinate];
    }

    /** Corners relative to the nominal centroid, 3 values per point, world axes, mm; shared in the package. */
    double[] points() {
        return points;
    }

    /** Corners relative to their own marker's centre, 3 values per point, world axes, mm; shared. */
    double[] arms() {
        return arms;
    }

    /** Left Jacobians of the rotation vectors, 9 values per reference row by row; shared. */
    double[] turns() {
        return turns;
    }
}
