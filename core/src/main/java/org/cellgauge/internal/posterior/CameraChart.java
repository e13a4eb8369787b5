package org.cellgauge.internal.posterior;

import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.StateLayout;

/**
 * Which pose of the references before the camera, and which unknown intrinsics, an array of coordinates stands for.
 * Implementations hold scratch arrays: one instance per thread.
 */
public interface CameraChart {
    /**
     * Which coordinates are of what.
     *
     * @return the layout
     */
    StateLayout layout();

    /**
     * Number of coordinates.
     *
     * @return size of the layout
     */
    default int dimension() {
        return layout().size();
    }

    /**
     * The state of a point of the chart. Allocates nothing.
     *
     * @param x coordinates
     * @param out receives pose and intrinsics
     */
    void decode(double[] x, CameraState out);

    /**
     * The coordinates of a state.
     *
     * @param state pose and intrinsics
     * @return a new array
     */
    double[] encode(CameraState state);

    /**
     * Log density of the measure flat in camera position and uniform over rotations, in these coordinates.
     *
     * @param x coordinates
     * @return up to a constant; -infinity where the chart is singular
     */
    double logMeasure(double[] x);
}
