package org.cellgauge.output;

import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.estimate.Matrices;
import org.cellgauge.internal.statistics.Angles;
import org.jspecify.annotations.Nullable;

/**
 * A pose as a result file has it: angles in (-pi, pi], NaN for what is not finite; immutable. Two are equal where a
 * file would hold the same of them.
 */
public final class PoseView extends Value {
    private final String frame;
    private final double[] mean;
    private final double[][] covariance;
    private final double[] tangentBaseRad;
    private final double[][] tangentCovariance;
    private final RigidTransform transform;

    private PoseView(String frame, double[] mean, double[][] covariance, double[] tangentBaseRad,
            double[][] tangentCovariance, RigidTransform transform) {
        this.frame = frame;
        this.mean = Figures.ownFinite(mean);
        this.covariance = Figures.ownFinite(covariance);
        this.tangentBaseRad = Figures.ownFinite(tangentBaseRad);
        this.tangentCovariance = Figures.ownFinite(tangentCovariance);
        this.transform = transform;
    }

    static PoseView of(PoseEstimate pose) {
        double[] mean = pose.mean();
        for (int i = 3; i < 6; i++) {
            mean[i] = Angles.wrapToPi(mean[i]);
        }
        double[] base = pose.meanTransform().eulerRad();
        for (int i = 0; i < 3; i++) {
            base[i] = Angles.wrapToPi(base[i]);
        }
        return new PoseView(pose.frame(), mean, pose.covariance(), base, pose.tangentCovariance(),
                pose.meanTransform());
    }

    /** A pose read back. */
    static PoseView read(String frame, double[] mean, double[][] covariance, double[] tangentBaseRad,
            double[][] tangentCovariance) {
        return new PoseView(frame, mean.clone(), Matrices.copy(covariance), tangentBaseRad.clone(),
                Matrices.copy(tangentCovariance), ofFigures(mean, tangentBaseRad));
    }

    /** The mean by the figures alone: to the last digit what a pose that is read back has. */
    RigidTransform ofFigures() {
        return ofFigures(mean, tangentBaseRad);
    }

    private static RigidTransform ofFigures(double[] mean, double[] baseRad) {
        return RigidTransform.ofEuler(mean[0], mean[1], mean[2], baseRad[0], baseRad[1], baseRad[2]);
    }

    /**
     * What it is the pose of, in what.
     *
     * @return {@code camera in world} or {@code object in world}
     */
    public String frame() {
        return frame;
    }

    /** The mean, shared within the package. */
    double[] sharedMean() {
        return mean;
    }

    /** The covariance, likewise. */
    double[][] sharedCovariance() {
        return covariance;
    }

    /**
     * The mean.
     *
     * @return x, y, z in mm, psi, theta, phi in rad; a new array
     */
    public double[] mean() {
        return mean.clone();
    }

    /**
     * Standard deviations.
     *
     * @return in the order of {@link #mean()}; a new array
     */
    public double[] std() {
        return Figures.std(covariance);
    }

    /**
     * The covariance.
     *
     * @return 6x6 in the order of {@link #mean()}; a copy
     */
    public double[][] covariance() {
        return Figures.finite(covariance);
    }

    /**
     * The rotation that {@link #tangentCovariance()} is about.
     *
     * @return psi, theta, phi in rad; a new array
     */
    public double[] tangentBaseRad() {
        return tangentBaseRad.clone();
    }

    /**
     * Covariance of position (mm) and rotation vector (rad), both in world axes.
     *
     * @return 6x6; a copy
     */
    public double[][] tangentCovariance() {
        return Figures.finite(tangentCovariance);
    }

    /**
     * The mean position and rotation.
     *
     * @return the transform from the body to the world; of a pose read back good to rounding
     */
    public RigidTransform transform() {
        return transform;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {frame, mean, covariance, tangentBaseRad, tangentCovariance};
    }
}
