package org.cellgauge.internal.posterior;

import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.StateLayout;

/**
 * Coordinates (dp in mm, w in rad, changes of unknown intrinsics, of the unknowns that markers share and of the added
 * noise, where it is unknown) about a base state: p the centroid of the references
 * in the camera frame, {@code R = exp(w) R_base}. Moves in them turn the camera about the scene, which takes the strong
 * correlation of position and rotation away.
 *
 * <p>For a fixed rotation the camera centre is {@code g - R^T p}, so a measure flat in the centre is flat in p.
 */
public final class CentredChart implements CameraChart {
    private final CameraState base;
    private final IntrinsicsPrior intrinsics;
    private final StateLayout layout;
    private final int poses;

    /**
     * A chart.
     *
     * @param base state of the coordinates 0; copied
     * @param intrinsics which intrinsics are unknown
     */
    public CentredChart(CameraState base, IntrinsicsPrior intrinsics) {
        this(base, intrinsics, false);
    }

    /**
     * A chart of a photo whose corners have errors in common.
     *
     * @param base state of the coordinates 0, with as many shared unknowns as there are; copied
     * @param intrinsics which intrinsics are unknown
     * @param noiseUnknown whether the added noise is a coordinate, the last
     */
    public CentredChart(CameraState base, IntrinsicsPrior intrinsics, boolean noiseUnknown) {
        this.base = base.copy();
        this.intrinsics = intrinsics;
        layout = StateLayout.of(base.views(), intrinsics, base.unknowns.length).withNoise(noiseUnknown);
        poses = layout.poses();
    }

    @Override
    public StateLayout layout() {
        return layout;
    }

    @Override
    public void decode(double[] x, CameraState out) {
        out.setMoved(base, x, 0);
        for (int i = 0; i < intrinsics.count(); i++) {
            out.intrinsics[intrinsics.index(i)] += x[layout.intrinsics() + i];
        }
        for (int j = 0; j < layout.sharedCount(); j++) {
            out.unknowns[j] += x[layout.shared() + j];
        }
        if (layout.isNoiseUnknown()) {
            out.noise += x[layout.noise()];
        }
    }

    @Override
    public double[] encode(CameraState state) {
        double[] x = java.util.Arrays.copyOf(state.stepFrom(base), dimension());
        for (int i = 0; i < intrinsics.count(); i++) {
            x[layout.intrinsics() + i] = state.intrinsics[intrinsics.index(i)] - base.intrinsics[intrinsics.index(i)];
        }
        for (int j = 0; j < layout.sharedCount(); j++) {
            x[layout.shared() + j] = state.unknowns[j] - base.unknowns[j];
        }
        if (layout.isNoiseUnknown()) {
            x[layout.noise()] = state.noise - base.noise;
        }
        return x;
    }

    @Override
    public double logMeasure(double[] x) {
        double sum = logMeasure(x, 3);
        for (int w = StateLayout.POSE + 3; w < poses; w += StateLayout.POSE) {
            sum += logMeasure(x, w);
        }
        return sum;
    }

    private static double logMeasure(double[] x, int w) {
        double squared = x[w] * x[w] + x[w + 1] * x[w + 1] + x[w + 2] * x[w + 2];
        // every rotation has one vector of length up to pi; longer ones would count it twice
        return squared > Math.PI * Math.PI ? Double.NEGATIVE_INFINITY
                : Rotations.logHaarDensity(x[w], x[w + 1], x[w + 2]);
    }
}
