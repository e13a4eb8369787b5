package org.cellgauge.internal.survey;

import java.util.Arrays;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Rotations;

/**
 * The motion that a step of a survey's unknowns has in common, taken along a rigid motion in place of its tangent. Not
 * thread-safe.
 *
 * <p>Photos tell how things stand to each other, to hundredths of a millimetre where corners are sharp, and nearly
 * nothing of all together: those turn about their centroid by what placement leaves open. Added up as a linear step
 * such a turn by w stretches a cell of size d by w² d / 2, which is a micrometre where 1 mm of placement is left open,
 * and may be a deviation of what the photos tell. Proposals along straight lines are then refused.
 *
 * <p>The common shift a and turn w are linear in the step, by least squares over the references that are seen. What is
 * left of the step, and how much the volume changes by the bend, is smaller than w by the ratio of errors of the
 * references to each other to their distances; the latter is left out.
 */
final class CommonMotion {
    private static final int POSE = SurveyLayout.POSE;

    private final SurveyLayout layout;
    private final int size;
    /** Common shift and turn by the step of all that photos share: six rows. */
    private final double[] motion;
    /** Shift of each reference by that step: three rows each. */
    private final double[] shifts;
    /** Positions at the mode about the centre: references, then objects. */
    private final double[] offsets;
    private final double[] cameraRotations;

    // work
    private final double[] common = new double[POSE];
    private final double[] turn = new double[9];
    private final double[] bent = new double[3];

    CommonMotion(SurveyFit fit, SurveyModel model) {
        layout = model.layout;
        size = layout.size;
        int references = layout.references.size();
        int objects = layout.objects.size();
        shifts = new double[3 * references * size];
        offsets = new double[3 * (references + objects)];
        motion = new double[POSE * size];
        model.measurementRows(fit.mode);
        double[] rows = new double[POSE * size];
        RealMatrix inertia = new Array2DRowRealMatrix(3, 3);
        RealMatrix moment = new Array2DRowRealMatrix(3, size);
        int seen = 0;
        for (int r = 0; r < references; r++) {
            model.referenceRows(r, rows);
            System.arraycopy(rows, 0, shifts, 3 * r * size, 3 * size);
            int id = layout.references.get(r).id();
            boolean isSeen = model.views.stream().anyMatch(v -> Arrays.stream(v.ids).anyMatch(i -> i == id));
            if (!isSeen) {
                continue;
            }
            seen++;
            double half = layout.references.get(r).sizeMm() / 2;
            add(offset(model.worldFromReference(fit.mode, r), model.centreMm), rows, half * half, inertia, moment);
        }
        for (int r = 0; r < references; r++) {
            System.arraycopy(offset(model.worldFromReference(fit.mode, r), model.centreMm), 0, offsets, 3 * r, 3);
        }
        for (int o = 0; o < objects; o++) {
            System.arraycopy(offset(SurveyState.get(fit.mode.objects, SurveyState.TRANSFORM * o), model.centreMm), 0,
                    offsets, 3 * (references + o), 3);
        }
        if (seen > 0) {
            for (int i = 0; i < 3 * size; i++) {
                motion[i] /= seen;
            }
            RealMatrix turns = MatrixUtils.inverse(inertia).multiply(moment);
            for (int i = 0; i < 3; i++) {
                System.arraycopy(turns.getRow(i), 0, motion, (3 + i) * size, size);
            }
        }
        cameraRotations = new double[9 * model.views.size()];
        for (int v = 0; v < model.views.size(); v++) {
            System.arraycopy(fit.mode.cameras[v], 0, cameraRotations, 9 * v, 9);
        }
    }

    private static double[] offset(RigidTransform pose, double[] centre) {
        double[] t = pose.translationMm();
        return new double[] {t[0] - centre[0], t[1] - centre[1], t[2] - centre[2]};
    }

    /** Adds one reference to the sums of least squares; its own turn counts by its corners. */
    private void add(double[] d, double[] rows, double ofItself, RealMatrix inertia, RealMatrix moment) {
        double square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        for (int i = 0; i < 3; i++) {
            inertia.addToEntry(i, i, square + ofItself);
            for (int j = 0; j < 3; j++) {
                inertia.addToEntry(i, j, -d[i] * d[j]);
            }
            int j = (i + 1) % 3;
            int k = (i + 2) % 3;
            for (int c = 0; c < size; c++) {
                motion[i * size + c] += rows[i * size + c];
                moment.addToEntry(i, c, d[j] * rows[k * size + c] - d[k] * rows[j * size + c]
                        + ofItself * rows[(3 + i) * size + c]);
            }
        }
    }

    /**
     * Bends a state that a step has led to in a straight line. Allocates nothing.
     *
     * @param step of all that photos share, off the mode
     * @param state where it has led, changed
     */
    void bend(double[] step, SurveyState state) {
        for (int i = 0; i < POSE; i++) {
            double sum = 0;
            for (int c = 0; c < size; c++) {
                sum += motion[i * size + c] * step[c];
            }
            common[i] = sum;
        }
        Rotations.exp(common[3], common[4], common[5], turn);
        int references = layout.references.size();
        for (int r = 0; r < references; r++) {
            double x = along(3 * r, step);
            double y = along(3 * r + 1, step);
            double z = along(3 * r + 2, step);
            bent(3 * r, x, y, z);
            for (int i = 0; i < 3; i++) {
                state.values[POSE * r + i] += bent[i];
            }
        }
        for (int o = 0; o < layout.objects.size(); o++) {
            int at = layout.firstObject + POSE * o;
            bent(3 * (references + o), step[at], step[at + 1], step[at + 2]);
            for (int i = 0; i < 3; i++) {
                state.objects[SurveyState.TRANSFORM * o + 9 + i] += bent[i];
            }
        }
        // the camera goes along: p - R exp(-w) a in place of p - R a
        double x = common[0] - (turn[0] * common[0] + turn[3] * common[1] + turn[6] * common[2]);
        double y = common[1] - (turn[1] * common[0] + turn[4] * common[1] + turn[7] * common[2]);
        double z = common[2] - (turn[2] * common[0] + turn[5] * common[1] + turn[8] * common[2]);
        for (int v = 0; v < state.cameras.length; v++) {
            for (int i = 0; i < 3; i++) {
                state.cameras[v][9 + i] += cameraRotations[9 * v + 3 * i] * x + cameraRotations[9 * v + 3 * i + 1] * y
                        + cameraRotations[9 * v + 3 * i + 2] * z;
            }
        }
    }

    private double along(int row, double[] step) {
        double sum = 0;
        for (int c = 0; c < size; c++) {
            sum += shifts[row * size + c] * step[c];
        }
        return sum;
    }

    /** How far the rigid motion leads a point off its tangent: {@code (exp(w) - 1) (d + rest) - w x d}. */
    private void bent(int at, double shiftX, double shiftY, double shiftZ) {
        double dx = offsets[at];
        double dy = offsets[at + 1];
        double dz = offsets[at + 2];
        double wx = common[4] * dz - common[5] * dy;
        double wy = common[5] * dx - common[3] * dz;
        double wz = common[3] * dy - common[4] * dx;
        double x = dx + shiftX - common[0] - wx;
        double y = dy + shiftY - common[1] - wy;
        double z = dz + shiftZ - common[2] - wz;
        bent[0] = turn[0] * x + turn[1] * y + turn[2] * z - x - wx;
        bent[1] = turn[3] * x + turn[4] * y + turn[5] * z - y - wy;
        bent[2] = turn[6] * x + turn[7] * y + turn[8] * z - z - wz;
    }
}
