package org.cellgauge.internal.pose;

/**
 * What is known of the added noise of a photo: probabilities on the grid of {@link AddedNoise}; immutable.
 */
public final class NoiseBelief {
    private final AddedNoise added;
    private final double[] weights;
    private final double mean;
    private final double std;
    private final double variancePx2;

    /**
     * A belief.
     *
     * @param added what the u of the grid stands for
     * @param logWeights logarithm of the posterior at each node, up to a constant; -infinity where it is nothing
     */
    public NoiseBelief(AddedNoise added, double[] logWeights) {
        this.added = added;
        double most = Double.NEGATIVE_INFINITY;
        for (double w : logWeights) {
            most = Math.max(most, w);
        }
        weights = new double[logWeights.length];
        double sum = 0;
        double first = 0;
        double second = 0;
        double variance = 0;
        for (int i = 0; i < weights.length; i++) {
            double u = AddedNoise.atNode(i);
            weights[i] = Math.exp(logWeights[i] - most);
            sum += weights[i];
            first += weights[i] * u;
            second += weights[i] * u * u;
            variance += weights[i] * added.variancePx2AtNode(i);
        }
        for (int i = 0; i < weights.length; i++) {
            weights[i] /= sum;
        }
        mean = first / sum;
        std = Math.sqrt(Math.max(second / sum - mean * mean, AddedNoise.STEP * AddedNoise.STEP));
        variancePx2 = variance / sum;
    }

    /**
     * Probability of a node.
     *
     * @param node 0 to {@link AddedNoise#NODES} - 1
     * @return 0 to 1; all add to 1
     */
    public double weight(int node) {
        return weights[node];
    }

    /**
     * Mean of u.
     *
     * @return about standard normal beforehand
     */
    public double mean() {
        return mean;
    }

    /**
     * Standard deviation of u.
     *
     * @return at least a step of the grid
     */
    public double std() {
        return std;
    }

    /**
     * Where the added variance is its mean. To first order the covariance of a pose there is the mean of its
     * covariances over all u: the figure that a single one stands in with.
     *
     * @return u
     */
    public double ofMeanVariance() {
        return added.ofVariance(variancePx2);
    }

    /**
     * A quantile of the added noise.
     *
     * @param share 0 to 1
     * @return standard deviation, px
     */
    public double quantileStdPx(double share) {
        return Math.sqrt(added.variancePx2AtNode(quantileNode(share)));
    }

    /**
     * The node of a quantile.
     *
     * @param share 0 to 1
     * @return the first node up to which so much of the probability lies
     */
    int quantileNode(double share) {
        double sum = 0;
        for (int i = 0; i < weights.length; i++) {
            sum += weights[i];
            if (sum >= share) {
                return i;
            }
        }
        return weights.length - 1;
    }
}
