package org.cellgauge.estimate;

import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.estimate.Matrices;

/**
 * A pose with its uncertainty; immutable.
 *
 * <p>Order of the values and of {@link #covariance()}: x, y, z in mm, then psi, theta, phi in rad (see
 * {@link org.cellgauge.geometry.RigidTransform#ofEuler}). Order of {@link #tangentCovariance()}: x, y, z in mm in the
 * world, then the rotation vector in world axes in rad, {@code R = exp(w) R_mean}; it is well defined where Euler
 * angles are not.
 */
public final class PoseEstimate {
    private final String frame;
    private final double[] mean;
    private final double[][] covariance;
    private final double[][] tangentCovariance;
    private final RigidTransform meanTransform;

    /**
     * An estimate.
     *
     * @param frame whose pose it is and in which frame, for instance {@code camera in world}
     * @param mean 6 values; copied
     * @param covariance 6x6; copied
     * @param tangentCovariance 6x6; copied
     * @param meanTransform the mean pose, its rotation averaged in the tangent space
     */
    public PoseEstimate(String frame, double[] mean, double[][] covariance, double[][] tangentCovariance,
            RigidTransform meanTransform) {
        this.frame = frame;
        this.mean = mean.clone();
        this.covariance = Matrices.copy(covariance);
        this.tangentCovariance = Matrices.copy(tangentCovariance);
        this.meanTransform = meanTransform;
    }

    /**
     * Whose pose it is and in which frame.
     *
     * @return for instance {@code object in world}
     */
    public String frame() {
        return frame;
    }

    /**
     * Mean: position and mean directions of the Euler angles.
     *
     * @return a copy of x, y, z in mm and psi, theta, phi in rad, in (-pi, pi]
     */
    public double[] mean() {
        return mean.clone();
    }

    /**
     * Standard deviations, the roots of the covariance's diagonal.
     *
     * @return a new array of 6 values, mm and rad
     */
    public double[] std() {
        double[] std = new double[6];
        for (int i = 0; i < 6; i++) {
            std[i] = Math.sqrt(covariance[i][i]);
        }
        return std;
    }

    /**
     * Covariance of position and Euler angles.
     *
     * @return a copy, 6x6, mm and rad
     */
    public double[][] covariance() {
        return Matrices.copy(covariance);
    }

    /**
     * Covariance of position and rotation vector, both in world axes.
     *
     * @return a copy, 6x6, mm and rad
     */
    public double[][] tangentCovariance() {
        return Matrices.copy(tangentCovariance);
    }

    /**
     * Covariance of the position.
     *
     * @return a new 3x3 matrix, world axes, mm²
     */
    public double[][] positionCovarianceMm2() {
        return Matrices.block(covariance, 3);
    }

    /**
     * The mean pose as a transform.
     *
     * @return worldFromCamera or worldFromObject
     */
    public RigidTransform meanTransform() {
        return meanTransform;
    }
}
