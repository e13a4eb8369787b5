package org.cellgauge.internal.estimate;

import org.cellgauge.estimate.IntrinsicsEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.statistics.Ellipse;

/** The 95 % region of a point in the world, carried into the image by the derivative of the projection at its mean. */
public final class ImageEllipses {
    private static final double PROBABILITY = 0.95;

    private ImageEllipses() {
    }

    /** The camera with the intrinsics that were estimated in place of the file's. */
    public static PinholeCamera camera(PinholeCamera file, IntrinsicsPrior unknown, IntrinsicsEstimate estimate) {
        if (estimate == null) {
            return file;
        }
        double[] intrinsics = file.intrinsics();
        double[] mean = estimate.mean();
        for (int i = 0; i < mean.length; i++) {
            intrinsics[unknown.index(i)] = mean[i];
        }
        return file.withIntrinsics(intrinsics);
    }

    /** The ellipse in px, or null where the point is not in front of the camera or its covariance is not finite. */
    public static Ellipse of(PinholeCamera camera, PoseEstimate cameraPose, double[] meanMm, double[][] covarianceMm2) {
        double[] p = cameraPose.meanTransform().inverse().apply(meanMm);
        double[] r = cameraPose.meanTransform().rotation();
        double[] uv = new double[2];
        double[] byPoint = new double[6];
        if (!camera.lens().projectWithDerivatives(camera.intrinsics(), p[0], p[1], p[2], uv, byPoint, null)) {
            return null;
        }
        double[][] byWorld = new double[2][3];
        for (int i = 0; i < 2; i++) {
            for (int j = 0; j < 3; j++) {
                for (int k = 0; k < 3; k++) {
                    byWorld[i][j] += byPoint[3 * i + k] * r[3 * j + k];
                }
            }
        }
        double[] flat = new double[9];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                flat[3 * i + j] = covarianceMm2[i][j];
                if (!Double.isFinite(flat[3 * i + j])) {
                    return null;
                }
            }
        }
        double[][] covariance = new double[2][2];
        Matrices.addSandwich(byWorld, flat, 3, covariance);
        return Ellipse.ofNormal(uv, covariance, PROBABILITY);
    }
}
