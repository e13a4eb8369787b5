package org.cellgauge.posterior;

import org.cellgauge.geometry.Rotations;
import org.cellgauge.pose.CameraState;
import org.cellgauge.pose.IntrinsicsPrior;

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
    private final int unknowns;
    private final boolean noiseUnknown;

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
        this.base = new CameraState().copyFrom(base);
        this.intrinsics = intrinsics;
        this.noiseUnknown = noiseUnknown;
        unknowns = base.unknowns.length;
    }

    @Override
    public int dimension() {
        return 6 + intrinsics.count() + unknowns + (noiseUnknown ? 1 : 0);
    }

    @Override
    public void decode(double[] x, CameraState out) {
        out.setMoved(base, x, 0);
        for (int i = 0; i < intrinsics.count(); i++) {
            out.intrinsics[intrinsics.index(i)] += x[6 + i];
        }
        int first = 6 + intrinsics.count();
        for (int j = 0; j < unknowns; j++) {
            out.unknowns[j] += x[first + j];
        }
        if (noiseUnknown) {
            out.noise += x[first + unknowns];
        }
    }

    @Override
    public double[] encode(CameraState state) {
        double[] x = java.util.Arrays.copyOf(state.stepFrom(base), dimension());
        for (int i = 0; i < intrinsics.count(); i++) {
            x[6 + i] = state.intrinsics[intrinsics.index(i)] - base.intrinsics[intrinsics.index(i)];
        }
        int first = 6 + intrinsics.count();
        for (int j = 0; j < unknowns; j++) {
            x[first + j] = state.unknowns[j] - base.unknowns[j];
        }
        if (noiseUnknown) {
            x[first + unknowns] = state.noise - base.noise;
        }
        return x;
    }

    @Override
    public double logMeasure(double[] x) {
        double squared = x[3] * x[3] + x[4] * x[4] + x[5] * x[5];
        // every rotation has one vector of length up to pi; longer ones would count it twice
        return squared > Math.PI * Math.PI ? Double.NEGATIVE_INFINITY : Rotations.logHaarDensity(x[3], x[4], x[5]);
    }
}
