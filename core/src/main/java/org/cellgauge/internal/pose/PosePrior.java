package org.cellgauge.internal.pose;

import java.util.Arrays;
import org.cellgauge.internal.geometry.Rotations;

/**
 * A weak proper prior on the camera pose, Gaussian in the centred chart about a given pose; immutable but for its base,
 * which is never changed.
 *
 * <p>With two references and large placement errors the data alone leave directions open; a result that rests on this
 * prior says so.
 */
public final class PosePrior {
    /** Deviation of places in the prior of a layout whose references leave directions open, mm. */
    public static final double WEAK_STD_MM = 1000;
    /** Deviation of rotations in it, rad. */
    public static final double WEAK_STD_RAD = 0.7;
    /** So many references may leave directions of the pose open. */
    private static final int TOO_FEW = 2;

    private final CameraState base;
    private final double stdMm;
    private final double stdRad;

    /**
     * A prior.
     *
     * @param base centre of the prior
     * @param stdMm standard deviation of each component of the position of the references' centroid in the camera
     *     frame, mm, positive
     * @param stdRad standard deviation of each component of the rotation vector, rad, positive
     */
    public PosePrior(CameraState base, double stdMm, double stdRad) {
        if (!(stdMm > 0 && stdRad > 0)) {
            throw new IllegalArgumentException("prior deviations must be positive");
        }
        this.base = base.copy();
        this.stdMm = stdMm;
        this.stdRad = stdRad;
    }

    /**
     * Whether references are so few that they may leave directions of the pose open.
     *
     * @param references number of references seen
     * @return true for at most two
     */
    public static boolean isNeededFor(int references) {
        return references <= TOO_FEW;
    }

    /**
     * The weak prior of such layouts.
     *
     * @param base centre of the prior
     * @return the prior
     */
    public static PosePrior weak(CameraState base) {
        return new PosePrior(base, WEAK_STD_MM, WEAK_STD_RAD);
    }

    /**
     * Standard deviation of each position component.
     *
     * @return mm
     */
    public double stdMm() {
        return stdMm;
    }

    /**
     * Standard deviation of each rotation component.
     *
     * @return rad
     */
    public double stdRad() {
        return stdRad;
    }

    /**
     * Logarithm of the density by (dp, w) at a state, up to a constant. Allocates nothing.
     *
     * @param state where
     * @param scratch9 9 values of scratch
     * @param scratch3 3 values of scratch
     * @return the logarithm
     */
    public double logDensity(CameraState state, double[] scratch9, double[] scratch3) {
        if (state.views() > 1) {
            throw new IllegalArgumentException("the density is that of one view");
        }
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            double d = (state.offset[i] - base.offset[i]) / stdMm;
            sum += d * d;
        }
        Rotations.multiplyTransposed(state.rotation, base.rotation, scratch9);
        Rotations.log(scratch9, scratch3, 0);
        for (int i = 0; i < 3; i++) {
            double d = scratch3[i] / stdRad;
            sum += d * d;
        }
        return -0.5 * sum;
    }

    /** Whitened residuals (6 per view) and their derivative by a step of the chart, appended to a fit's rows. */
    void rows(CameraState state, double[] residuals, double[] jacobian, int firstRow, int columns) {
        double[] step = state.stepFrom(base);
        double[] byTurn = new double[9];
        for (int i = 0; i < step.length; i++) {
            residuals[firstRow + i] = step[i] / (i % StateLayout.POSE < 3 ? stdMm : stdRad);
        }
        if (jacobian == null) {
            return;
        }
        Arrays.fill(jacobian, firstRow * columns, (firstRow + step.length) * columns, 0);
        for (int first = 0; first < step.length; first += StateLayout.POSE) {
            Rotations.inverseLeftJacobian(step[first + 3], step[first + 4], step[first + 5], byTurn);
            for (int i = 0; i < 3; i++) {
                jacobian[(firstRow + first + i) * columns + first + i] = 1 / stdMm;
                for (int j = 0; j < 3; j++) {
                    jacobian[(firstRow + first + 3 + i) * columns + first + 3 + j] = byTurn[3 * i + j] / stdRad;
                }
            }
        }
    }
}
