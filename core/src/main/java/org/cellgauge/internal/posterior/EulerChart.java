package org.cellgauge.internal.posterior;

import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.StateLayout;

/**
 * The thesis' coordinates: camera position in the world (mm), Euler angles psi, theta, phi (rad) of worldFromCamera,
 * the values of unknown intrinsics, of the unknowns that markers share and of the added noise, where it is unknown.
 */
public final class EulerChart implements CameraChart {
    private final double[] centroidMm;
    private final CameraState known;
    private final IntrinsicsPrior intrinsics;
    private final StateLayout layout;
    private final double[] worldFromCamera = new double[9];

    /**
     * A chart.
     *
     * @param centroidMm centroid of the references in the world, 3 values, mm; copied
     * @param known gives the intrinsics that are not estimated; copied
     * @param intrinsics which intrinsics are unknown
     */
    public EulerChart(double[] centroidMm, CameraState known, IntrinsicsPrior intrinsics) {
        this(centroidMm, known, intrinsics, false);
    }

    /**
     * A chart of a photo whose corners have errors in common.
     *
     * @param centroidMm centroid of the references in the world, 3 values, mm; copied
     * @param known gives the intrinsics that are not estimated, and how many shared unknowns there are; copied
     * @param intrinsics which intrinsics are unknown
     * @param noiseUnknown whether the added noise is a coordinate, the last
     */
    public EulerChart(double[] centroidMm, CameraState known, IntrinsicsPrior intrinsics, boolean noiseUnknown) {
        this.centroidMm = centroidMm.clone();
        this.known = known.copy();
        this.intrinsics = intrinsics;
        layout = StateLayout.of(1, intrinsics, known.unknowns.length).withNoise(noiseUnknown);
    }

    @Override
    public StateLayout layout() {
        return layout;
    }

    @Override
    public void decode(double[] x, CameraState out) {
        out.copyFrom(known);
        for (int i = 0; i < intrinsics.count(); i++) {
            out.intrinsics[intrinsics.index(i)] = x[layout.intrinsics() + i];
        }
        System.arraycopy(x, layout.shared(), out.unknowns, 0, out.unknowns.length);
        if (layout.isNoiseUnknown()) {
            out.noise = x[layout.noise()];
        }
        Rotations.fromEuler(x[3], x[4], x[5], worldFromCamera);
        Rotations.transpose(worldFromCamera, out.rotation);
        double dx = centroidMm[0] - x[0];
        double dy = centroidMm[1] - x[1];
        double dz = centroidMm[2] - x[2];
        for (int i = 0; i < 3; i++) {
            out.offset[i] = out.rotation[3 * i] * dx + out.rotation[3 * i + 1] * dy + out.rotation[3 * i + 2] * dz;
        }
    }

    @Override
    public double[] encode(CameraState state) {
        double[] x = new double[dimension()];
        RigidTransform setFromCamera = state.cameraFromSet().inverse();
        double[] t = setFromCamera.translationMm();
        double[] e = setFromCamera.eulerRad();
        for (int i = 0; i < 3; i++) {
            x[i] = t[i] + centroidMm[i];
            x[3 + i] = e[i];
        }
        for (int i = 0; i < intrinsics.count(); i++) {
            x[layout.intrinsics() + i] = state.intrinsics[intrinsics.index(i)];
        }
        System.arraycopy(state.unknowns, 0, x, layout.shared(), state.unknowns.length);
        if (layout.isNoiseUnknown()) {
            x[layout.noise()] = state.noise;
        }
        return x;
    }

    @Override
    public double logMeasure(double[] x) {
        return Math.log(Math.abs(Math.cos(x[4])));
    }
}
