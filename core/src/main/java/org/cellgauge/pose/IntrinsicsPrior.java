package org.cellgauge.pose;

import org.cellgauge.geometry.PinholeCamera;

/**
 * Which intrinsics are unknown and what is known of them beforehand: independent Gaussians; immutable.
 *
 * <p>The prior is always proper: references in one plane alone do not determine a focal length, and a flat prior would
 * leave a posterior that cannot be normalised.
 */
public final class IntrinsicsPrior {
    /** All intrinsics are known. */
    public static final IntrinsicsPrior KNOWN = new IntrinsicsPrior(new int[0], new double[0], new double[0]);

    private final int[] indices;
    private final double[] means;
    private final double[] stds;

    private IntrinsicsPrior(int[] indices, double[] means, double[] stds) {
        this.indices = indices;
        this.means = means;
        this.stds = stds;
    }

    /**
     * Unknown focal lengths fx and fy, each N(camera's value, std²).
     *
     * @param camera gives the means
     * @param stdPx standard deviation, px, positive
     * @return the prior
     * @throws IllegalArgumentException if the deviation is not positive and finite
     */
    public static IntrinsicsPrior focal(PinholeCamera camera, double stdPx) {
        return of(camera, new int[] {PinholeCamera.FX, PinholeCamera.FY}, new double[] {stdPx, stdPx});
    }

    /**
     * Unknown intrinsics of any choice, each Gaussian about the camera's value.
     *
     * @param camera gives the means
     * @param indices indices of {@link PinholeCamera}; copied
     * @param stds standard deviations in the units of the values, positive; copied
     * @return the prior
     * @throws IllegalArgumentException if a deviation is not positive and finite
     */
    public static IntrinsicsPrior of(PinholeCamera camera, int[] indices, double[] stds) {
        double[] means = new double[indices.length];
        for (int i = 0; i < indices.length; i++) {
            means[i] = camera.get(indices[i]);
            if (!(stds[i] > 0) || !Double.isFinite(stds[i])) {
                throw new IllegalArgumentException("prior deviation must be positive, not " + stds[i]);
            }
        }
        return new IntrinsicsPrior(indices.clone(), means, stds.clone());
    }

    /**
     * Number of unknown intrinsics.
     *
     * @return 0 where all are known
     */
    public int count() {
        return indices.length;
    }

    /**
     * Which intrinsic the i-th unknown is.
     *
     * @param i 0 to count - 1
     * @return index of {@link PinholeCamera}
     */
    public int index(int i) {
        return indices[i];
    }

    /**
     * Prior mean of the i-th unknown.
     *
     * @param i 0 to count - 1
     * @return in the unit of the value
     */
    public double mean(int i) {
        return means[i];
    }

    /**
     * Prior standard deviation of the i-th unknown.
     *
     * @param i 0 to count - 1
     * @return in the unit of the value
     */
    public double std(int i) {
        return stds[i];
    }

    /**
     * Logarithm of the prior density at a state, up to a constant.
     *
     * @param intrinsics in the order of {@link PinholeCamera}
     * @return the logarithm; -infinity where a focal length is not positive
     */
    public double logDensity(double[] intrinsics) {
        double sum = 0;
        for (int i = 0; i < indices.length; i++) {
            double d = (intrinsics[indices[i]] - means[i]) / stds[i];
            sum -= 0.5 * d * d;
        }
        return intrinsics[PinholeCamera.FX] > 0 && intrinsics[PinholeCamera.FY] > 0 ? sum : Double.NEGATIVE_INFINITY;
    }
}
