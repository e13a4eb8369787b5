package org.cellgauge.posterior;

import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.geometry.Rotations;
import org.cellgauge.pose.CameraState;
import org.cellgauge.pose.IntrinsicsPrior;

/**
 * The thesis' coordinates: camera position in the world (mm), Euler angles psi, theta, phi (rad) of worldFromCamera,
 * and the values of unknown intrinsics.
 */
public final class EulerChart implements CameraChart {
    private final double[] centroidMm;
    private final CameraState known;
    private final IntrinsicsPrior intrinsics;
    private final double[] worldFromCamera = new double[9];

    /**
     * A chart.
     *
     * @param centroidMm centroid of the references in the world, 3 values, mm; copied
     * @param known gives the intrinsics that are not estimated; copied
     * @param intrinsics which intrinsics are unknown
     */
    public EulerChart(double[] centroidMm, CameraState known, IntrinsicsPrior intrinsics) {
        this.centroidMm = centroidMm.clone();
        this.known = new CameraState().copyFrom(known);
        this.intrinsics = intrinsics;
    }

    @Override
    public int dimension() {
        return 6 + intrinsics.count();
    }

    @Override
    public void decode(double[] x, CameraState out) {
        System.arraycopy(known.intrinsics, 0, out.intrinsics, 0, known.intrinsics.length);
        for (int i = 0; i < intrinsics.count(); i++) {
            out.intrinsics[intrinsics.index(i)] = x[6 + i];
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
            x[6 + i] = state.intrinsics[intrinsics.index(i)];
        }
        return x;
    }

    @Override
    public double logMeasure(double[] x) {
        return Math.log(Math.abs(Math.cos(x[4])));
    }
}
