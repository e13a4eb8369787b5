package org.cellgauge.posterior;

import org.cellgauge.geometry.MarkerGeometry;
import org.cellgauge.geometry.Projection;
import org.cellgauge.geometry.Rotations;
import org.cellgauge.pose.CameraState;

/**
 * Posterior of an object marker's pose in the camera frame given its own corners: Gaussian corner noise, flat position,
 * uniform rotation, in the centred chart (dp in mm, w in rad) about a base pose. Allocates nothing; not thread-safe.
 *
 * <p>The base may be moved between evaluations: where intrinsics are sampled, each draw has its own.
 */
public final class ObjectPosterior implements LogDensity {
    private final double[] points;
    private final double[] observed;
    private final double inverseVariance;
    private final CameraState base = new CameraState();
    private final CameraState state = new CameraState();
    private final double[] uv = new double[2];

    /**
     * A posterior.
     *
     * @param cornersPx observed corners, 8 values, px; copied
     * @param sizeMm outer edge of the marker, mm
     * @param pixelStdPx standard deviation of each corner coordinate, px, positive
     * @param base pose and intrinsics of the coordinates 0; copied
     */
    public ObjectPosterior(double[] cornersPx, double sizeMm, double pixelStdPx, CameraState base) {
        points = MarkerGeometry.cornersMm(sizeMm);
        observed = cornersPx.clone();
        inverseVariance = 1 / (pixelStdPx * pixelStdPx);
        this.base.copyFrom(base);
    }

    /**
     * Moves the base; coordinates then mean other poses.
     *
     * @param newBase pose and intrinsics of the coordinates 0; copied
     */
    public void setBase(CameraState newBase) {
        base.copyFrom(newBase);
    }

    @Override
    public int dimension() {
        return 6;
    }

    @Override
    public double at(double[] x) {
        double squared = x[3] * x[3] + x[4] * x[4] + x[5] * x[5];
        if (!(squared <= Math.PI * Math.PI)) {
            return Double.NEGATIVE_INFINITY;
        }
        state.setMoved(base, x, 0);
        double[] r = state.rotation;
        double sum = 0;
        for (int k = 0; k < 4; k++) {
            double px = points[3 * k];
            double py = points[3 * k + 1];
            // the marker is flat: its corners have z = 0 in their own frame
            if (!Projection.project(state.intrinsics, r[0] * px + r[1] * py + state.offset[0],
                    r[3] * px + r[4] * py + state.offset[1], r[6] * px + r[7] * py + state.offset[2], uv, 0)) {
                return Double.NEGATIVE_INFINITY;
            }
            double du = uv[0] - observed[2 * k];
            double dv = uv[1] - observed[2 * k + 1];
            sum += du * du + dv * dv;
        }
        double value = Rotations.logHaarDensity(x[3], x[4], x[5]) - 0.5 * sum * inverseVariance;
        return value == value ? value : Double.NEGATIVE_INFINITY;
    }

    /**
     * The pose of a point of the chart.
     *
     * @param x coordinates
     * @param out receives the pose in the camera frame and the base's intrinsics
     */
    public void decode(double[] x, CameraState out) {
        out.setMoved(base, x, 0);
    }
}
