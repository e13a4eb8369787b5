package org.cellgauge.internal.survey;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.cellgauge.cell.Measurement;
import org.cellgauge.cell.RobotPrecision;
import org.jspecify.annotations.Nullable;

/**
 * What was measured of references besides placing them, as residuals that are standard normal beforehand; immutable.
 *
 * <p>Touched points are {@code x + b + w × x + R t}: b and w say where the robot's base stands, t where its tool ends
 * in the tool's frame, R how the tool was turned; b, w and t are the same for all of them. References on one plane obey
 * {@code n · (x - o) = c + p u · (x - o) + q v · (x - o)} with c, p and q unknown; n is the normal of their stated
 * places, u and v span their plane.
 */
final class SharedMeasurements {
    /** Adds a multiple of the derivative of a reference's place along a direction to a row. */
    @FunctionalInterface
    interface PlaceRow {
        void add(int reference, double x, double y, double z, double[] row);
    }

    /** Residuals and their derivatives. */
    static final class Rows {
        /** By row: the index of its measurement, -1 for what is known beforehand of robot and planes. */
        final int[] measurements;
        final double[] residuals;
        /** By row: derivatives by all that photos share; empty where they are not asked for. */
        final double[][] rows;

        Rows(int count, int unknowns) {
            measurements = new int[count];
            residuals = new double[count];
            rows = new double[count][unknowns];
            Arrays.fill(measurements, -1);
        }
    }

    private static final double OPEN_PLANE_MM = 1e4;
    private static final double OPEN_SLOPE = 1;

    private final SurveyLayout layout;
    private final double[] stated;
    private final int count;
    private final List<double[]> planes = new ArrayList<>();

    SharedMeasurements(SurveyLayout layout, double[] statedPlaces) {
        this.layout = layout;
        this.stated = statedPlaces;
        int rows = layout.isRobotUnknown() ? SurveyLayout.POSE + SurveyLayout.TOOL : 0;
        for (Measurement m : layout.measurements) {
            if (m instanceof Measurement.OnePlane plane) {
                planes.add(frame(plane));
                rows += SurveyLayout.PLANE + plane.members().size();
            } else {
                rows += m instanceof Measurement.Touched ? 3 : 1;
            }
        }
        count = rows;
    }

    /** Origin, then normal and two directions of the plane of some references' stated places. */
    private double[] frame(Measurement.OnePlane plane) {
        double[] out = new double[12];
        int n = plane.members().size();
        double[] at = new double[3 * n];
        for (int k = 0; k < n; k++) {
            System.arraycopy(stated, 3 * layout.reference(plane.members().get(k)), at, 3 * k, 3);
            for (int i = 0; i < 3; i++) {
                out[i] += at[3 * k + i] / n;
            }
        }
        // the two members that span the largest area with the origin tell the normal well enough: slopes are unknown
        double largest = -1;
        for (int a = 0; a < n; a++) {
            for (int b = 0; b < a; b++) {
                double[] p = {at[3 * a] - out[0], at[3 * a + 1] - out[1], at[3 * a + 2] - out[2]};
                double[] q = {at[3 * b] - out[0], at[3 * b + 1] - out[1], at[3 * b + 2] - out[2]};
                double[] c = cross(p, q);
                double area = length(c);
                if (area > largest && area > 0) {
                    largest = area;
                    for (int i = 0; i < 3; i++) {
                        out[3 + i] = c[i] / area;
                        out[6 + i] = p[i] / length(p);
                    }
                }
            }
        }
        double[] v = cross(new double[] {out[3], out[4], out[5]}, new double[] {out[6], out[7], out[8]});
        System.arraycopy(v, 0, out, 9, 3);
        return out;
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private static double length(double[] a) {
        return Math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    }

    /** Half the sum of squares. */
    double cost(double[] places, double[] values) {
        if (count == 0) {
            return 0;
        }
        double sum = 0;
        for (double r : rows(places, null, values).residuals) {
            sum += r * r;
        }
        return 0.5 * sum;
    }

    /** Adds information and gradient, both triangles. */
    void add(double[] places, PlaceRow placeRow, double @Nullable [] values, double[] information,
            double[] gradient) {
        if (count == 0) {
            return;
        }
        int n = layout.size;
        Rows rows = rows(places, placeRow, values == null ? new double[n] : values);
        for (int r = 0; r < count; r++) {
            double[] row = rows.rows[r];
            for (int a = 0; a < n; a++) {
                if (row[a] != 0) {
                    gradient[a] += row[a] * rows.residuals[r];
                    for (int b = 0; b < n; b++) {
                        information[a * n + b] += row[a] * row[b];
                    }
                }
            }
        }
    }

    /** All rows; without derivatives where nobody gives those of places. */
    Rows rows(double[] places, @Nullable PlaceRow placeRow, double[] values) {
        Rows out = new Rows(count, placeRow == null ? 0 : layout.size);
        PlaceRow by = placeRow == null ? (reference, x, y, z, row) -> { } : placeRow;
        boolean derivatives = placeRow != null;
        int at = 0;
        int plane = 0;
        for (int k = 0; k < layout.measurements.size(); k++) {
            Measurement m = layout.measurements.get(k);
            int first = at;
            if (m instanceof Measurement.Distance distance) {
                distance(distance, places, by, out, at++);
            } else if (m instanceof Measurement.Height height) {
                int above = layout.reference(height.above());
                int below = layout.reference(height.below());
                double w = 1 / height.stdMm();
                out.residuals[at] = (places[3 * above + 2] - places[3 * below + 2] - height.mm()) * w;
                by.add(above, 0, 0, w, out.rows[at]);
                by.add(below, 0, 0, -w, out.rows[at++]);
            } else if (m instanceof Measurement.Touched touched) {
                touched(touched, places, values, derivatives, by, out, at);
                at += 3;
            } else if (m instanceof Measurement.OnePlane one) {
                plane(one, plane++, places, values, derivatives, by, out, at);
                at += one.members().size();
            }
            Arrays.fill(out.measurements, first, at, k);
        }
        priors(values, derivatives, out, at);
        return out;
    }

    private void distance(Measurement.Distance m, double[] places, PlaceRow by, Rows out, int at) {
        int from = layout.reference(m.from());
        int to = layout.reference(m.to());
        double[] d = new double[3];
        for (int i = 0; i < 3; i++) {
            d[i] = places[3 * to + i] - places[3 * from + i];
        }
        double length = length(d);
        double w = 1 / (m.stdMm() * length);
        out.residuals[at] = (length - m.mm()) / m.stdMm();
        by.add(to, w * d[0], w * d[1], w * d[2], out.rows[at]);
        by.add(from, -w * d[0], -w * d[1], -w * d[2], out.rows[at]);
    }

    private void touched(Measurement.Touched m, double[] places, double[] values, boolean derivatives, PlaceRow by,
            Rows out, int at) {
        int reference = layout.reference(m.id());
        int robot = layout.firstRobot;
        double[] seen = m.worldFromTool().translationMm();
        double[] tool = m.worldFromTool().rotation();
        double[] x = {places[3 * reference], places[3 * reference + 1], places[3 * reference + 2]};
        double[] turn = {values[robot + 3], values[robot + 4], values[robot + 5]};
        double[] moved = cross(turn, x);
        for (int i = 0; i < 3; i++) {
            double w = 1 / m.std().stdMm(i);
            double sum = x[i] + values[robot + i] + moved[i] - seen[i];
            for (int c = 0; c < 3; c++) {
                sum += tool[3 * i + c] * values[robot + 6 + c];
            }
            out.residuals[at + i] = sum * w;
            if (derivatives) {
                double[] row = out.rows[at + i];
                double[] axis = {i == 0 ? w : 0, i == 1 ? w : 0, i == 2 ? w : 0};
                // row i of 1 + [turn]x
                double[] turning = cross(axis, turn);
                by.add(reference, axis[0] + turning[0], axis[1] + turning[1], axis[2] + turning[2], row);
                row[robot + i] += w;
                for (int c = 0; c < 3; c++) {
                    row[robot + 6 + c] += w * tool[3 * i + c];
                }
                int next = (i + 1) % 3;
                int last = (i + 2) % 3;
                row[robot + 3 + next] += w * x[last];
                row[robot + 3 + last] -= w * x[next];
            }
        }
    }

    private void plane(Measurement.OnePlane m, int plane, double[] places, double[] values, boolean derivatives,
            PlaceRow by, Rows out, int first) {
        double[] f = planes.get(plane);
        int open = layout.firstPlane + SurveyLayout.PLANE * plane;
        double w = 1 / m.stdMm();
        for (int k = 0; k < m.members().size(); k++) {
            int reference = layout.reference(m.members().get(k));
            double[] d = new double[3];
            for (int i = 0; i < 3; i++) {
                d[i] = places[3 * reference + i] - f[i];
            }
            double height = f[3] * d[0] + f[4] * d[1] + f[5] * d[2];
            double u = f[6] * d[0] + f[7] * d[1] + f[8] * d[2];
            double v = f[9] * d[0] + f[10] * d[1] + f[11] * d[2];
            out.residuals[first + k] = (height - values[open] - values[open + 1] * u - values[open + 2] * v) * w;
            if (derivatives) {
                double[] row = out.rows[first + k];
                double[] along = new double[3];
                for (int i = 0; i < 3; i++) {
                    along[i] = w * (f[3 + i] - values[open + 1] * f[6 + i] - values[open + 2] * f[9 + i]);
                }
                by.add(reference, along[0], along[1], along[2], row);
                row[open] -= w;
                row[open + 1] -= w * u;
                row[open + 2] -= w * v;
            }
        }
    }

    /** What is known beforehand of the robot; of planes next to nothing. */
    private void priors(double[] values, boolean derivatives, Rows out, int first) {
        int at = first;
        RobotPrecision robot = layout.cell.joint().robot();
        for (int i = layout.firstRobot; i < layout.size; i++) {
            int k = i - layout.firstRobot;
            double std;
            if (i >= layout.firstPlane) {
                std = (i - layout.firstPlane) % SurveyLayout.PLANE == 0 ? OPEN_PLANE_MM : OPEN_SLOPE;
            } else if (robot == null) {
                throw new IllegalStateException("touched points need the precision of the robot");
            } else {
                std = Math.max(1e-9, k < 3 ? robot.base().stdMm(k)
                        : k < SurveyLayout.POSE ? robot.base().stdRad() : robot.toolStdMm());
            }
            out.residuals[at] = values[i] / std;
            if (derivatives) {
                out.rows[at][i] = 1 / std;
            }
            at++;
        }
    }
}
