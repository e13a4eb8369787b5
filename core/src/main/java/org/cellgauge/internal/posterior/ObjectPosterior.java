package org.cellgauge.internal.posterior;

import java.util.Collections;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.pose.AddedNoise;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.sampling.LogDensity;
import org.jspecify.annotations.Nullable;

/**
 * Posterior of an object marker's pose in the camera frame given its own corners: Gaussian corner noise, flat position,
 * uniform rotation, in the centred chart (dp in mm, w in rad) about a base pose. Allocates nothing; not thread-safe.
 *
 * <p>The base may be moved between evaluations, {@link #setBase}: where intrinsics are sampled, each draw has its own.
 * What the image shows of a marker is its place by its depth; with another focal length the depth is another and so,
 * by the same factor, is its deviation, while places across the line of sight and turns keep theirs. The depth
 * coordinate is therefore counted in shares of the base's depth. What the marker has in common with others may change
 * as well, {@link #setShared}: the base then moves along as the fitted pose would, to first order, and coordinates are
 * stretched as its deviations would be. Either way the density in them stays nearly the same.
 */
public final class ObjectPosterior implements LogDensity {
    private final double[] points;
    private final double[] observed;
    private final double inverseVariance;
    private final CameraState base = new CameraState();
    /** With the intrinsics of the base. */
    private final CameraState state = new CameraState();
    private final double[] uv = new double[2];
    private final double[] residuals = new double[8];
    private final double[] stretched = new double[6];
    private final @Nullable Shared shared;
    private double @Nullable [] packed;
    private double stretch = 1;
    private final double firstDepthMm;
    private double depthStretch = 1;

    /** What the marker has in common with others. */
    private static final class Shared {
        final CornerErrors errors;
        final double[] corners;
        final double[] columns;
        final double[] byUnknown;
        final CameraState mode;
        final double[] step = new double[6];
        final NoiseWhitening whitening;
        final double[] stretches;

        Shared(CornerErrors errors, int id, double[] byUnknown, CameraState mode, boolean stretching) {
            this.errors = errors;
            this.byUnknown = byUnknown.clone();
            this.mode = mode.copy();
            corners = errors.cornersPx(id);
            columns = errors.columns(id);
            whitening = new NoiseWhitening(errors, Collections.singletonList(id), new double[64]);
            stretches = new double[AddedNoise.NODES];
            double atMode = errors.meanVariancePx2(id, mode.noise);
            for (int i = 0; i < stretches.length; i++) {
                stretches[i] = stretching ? Math.sqrt(errors.meanVariancePx2(id, AddedNoise.atNode(i)) / atMode) : 1;
            }
        }
    }

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
        shared = null;
        this.base.copyFrom(base);
        state.copyIntrinsics(base);
        firstDepthMm = base.offset[2];
    }

    /**
     * A posterior of a marker whose corners have a covariance and errors in common with others.
     *
     * @param errors errors of the photo's corners
     * @param id marker id
     * @param sizeMm outer edge of the marker, mm
     * @param byUnknown change of the fitted pose by each shared unknown, 6 x unknowns row by row; copied
     * @param base pose of the coordinates 0 at its own intrinsics, shared unknowns and noise; copied
     * @param stretching whether coordinates are stretched with the noise; not where the pose has a second mode, whose
     *     place stays where it is
     */
    public ObjectPosterior(CornerErrors errors, int id, double sizeMm, double[] byUnknown, CameraState base,
            boolean stretching) {
        points = MarkerGeometry.cornersMm(sizeMm);
        observed = new double[8];
        inverseVariance = Double.NaN;
        shared = new Shared(errors, id, byUnknown, base, stretching);
        firstDepthMm = base.offset[2];
        setShared(base);
    }

    /**
     * Takes shared unknowns and noise from a draw; the base moves along.
     *
     * @param camera the draw; its pose and intrinsics are of no account
     * @throws IllegalStateException if the marker shares nothing
     */
    public void setShared(CameraState camera) {
        if (shared == null) {
            throw new IllegalStateException("this marker shares nothing with others");
        }
        int q = camera.unknowns.length;
        for (int i = 0; i < 8; i++) {
            double sum = shared.corners[i];
            for (int j = 0; j < q; j++) {
                sum -= shared.columns[i * q + j] * camera.unknowns[j];
            }
            observed[i] = sum;
        }
        for (int i = 0; i < 6; i++) {
            double sum = 0;
            for (int j = 0; j < q; j++) {
                sum += shared.byUnknown[i * q + j] * (camera.unknowns[j] - shared.mode.unknowns[j]);
            }
            shared.step[i] = sum;
        }
        base.setMoved(shared.mode, shared.step, 0);
        state.copyIntrinsics(base);
        int node = shared.errors.added() == null ? 0 : AddedNoise.node(camera.noise);
        packed = shared.whitening.at(node);
        stretch = shared.errors.added() == null ? 1 : shared.stretches[node];
    }

    /**
     * Moves the base, as another focal length does; coordinates then mean other poses.
     *
     * @param newBase pose and intrinsics of the coordinates 0; copied
     */
    public void setBase(CameraState newBase) {
        base.copyFrom(newBase);
        state.copyIntrinsics(base);
        depthStretch = newBase.offset[2] / firstDepthMm;
    }

    /**
     * Observed corners less what is shared.
     *
     * @return 8 values, px; shared with this posterior, not to be changed
     */
    public double[] shiftedPx() {
        return observed;
    }

    /**
     * The pose of the coordinates 0.
     *
     * @param out receives pose, intrinsics and shared unknowns of the base
     */
    public void base(CameraState out) {
        out.copyFrom(base);
    }

    @Override
    public int dimension() {
        return 6;
    }

    @Override
    public double at(double[] x) {
        double[] step = x;
        if (stretch != 1 || depthStretch != 1) {
            step = stretched;
            stretch(x);
        }
        double squared = step[3] * step[3] + step[4] * step[4] + step[5] * step[5];
        if (!(squared <= Math.PI * Math.PI)) {
            return Double.NEGATIVE_INFINITY;
        }
        state.setPoseMoved(base, step, 0);
        double[] r = state.rotation;
        double sum = 0;
        for (int k = 0; k < 4; k++) {
            double px = points[3 * k];
            double py = points[3 * k + 1];
            // the marker is flat: its corners have z = 0 in their own frame
            if (!state.lens.project(state.intrinsics, r[0] * px + r[1] * py + state.offset[0],
                    r[3] * px + r[4] * py + state.offset[1], r[6] * px + r[7] * py + state.offset[2], uv, 0)) {
                return Double.NEGATIVE_INFINITY;
            }
            double du = uv[0] - observed[2 * k];
            double dv = uv[1] - observed[2 * k + 1];
            residuals[2 * k] = du;
            residuals[2 * k + 1] = dv;
            sum += du * du + dv * dv;
        }
        double squares = packed == null ? sum * inverseVariance : whitenedSquares(packed);
        double value = Rotations.logHaarDensity(step[3], step[4], step[5]) - 0.5 * squares;
        return Double.isNaN(value) ? Double.NEGATIVE_INFINITY : value;
    }

    private double whitenedSquares(double[] packed) {
        double squares = 0;
        for (int i = 0, at = 0; i < 8; i++) {
            double s = 0;
            for (int j = 0; j <= i; j++) {
                s += packed[at++] * residuals[j];
            }
            squares += s * s;
        }
        return squares;
    }

    /**
     * The pose of a point of the chart.
     *
     * @param x coordinates
     * @param out receives the pose in the camera frame and the base's intrinsics
     */
    public void decode(double[] x, CameraState out) {
        stretch(x);
        out.setMoved(base, stretched, 0);
    }

    private void stretch(double[] x) {
        for (int i = 0; i < 6; i++) {
            stretched[i] = stretch * x[i];
        }
        stretched[2] *= depthStretch;
    }
}
