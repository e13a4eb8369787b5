package org.cellgauge.internal.posterior;

import org.cellgauge.internal.pose.AddedNoise;
import org.cellgauge.internal.pose.CameraState;

/**
 * Prior of what the markers of a photo share: unknowns standard normal beforehand, and the added noise with all that is
 * known of it apart from the references' likelihood. Immutable.
 */
public final class SharedPrior {
    private final double[] logNoise;

    /**
     * A prior.
     *
     * @param logNoise logarithm of the density of the added noise at each node of the grid of {@link AddedNoise}, up to
     *     a constant; null where the noise is stated; copied
     */
    public SharedPrior(double[] logNoise) {
        this.logNoise = logNoise == null ? null : logNoise.clone();
    }

    /**
     * Log density. Allocates nothing.
     *
     * @param state of the photo
     * @return up to a constant
     */
    public double logDensity(CameraState state) {
        double sum = 0;
        for (double nu : state.unknowns) {
            sum -= 0.5 * nu * nu;
        }
        if (logNoise != null) {
            // beyond the grid the Gaussian goes on: the corners say no more there
            int node = AddedNoise.node(state.noise);
            double at = AddedNoise.atNode(node);
            sum += logNoise[node] - 0.5 * (state.noise * state.noise - at * at);
        }
        return sum;
    }
}
