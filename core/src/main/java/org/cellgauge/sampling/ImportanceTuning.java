package org.cellgauge.sampling;

import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.geometry.Cholesky;
import org.cellgauge.posterior.LogDensity;

/**
 * Fits a t mixture to a target by adaptive importance sampling (Cappé, Douc, Guillin, Marin, Robert, "Adaptive importance
 * sampling in general mixture classes", Statistics and Computing 2008): draws are weighted by target over mixture, and
 * weights, means and scales of the components become the weighted ones. Where the weights are very uneven they are first
 * flattened by a power below 1, so that a start far from the target is approached in steps.
 */
public final class ImportanceTuning {
    private static final int ROUNDS = 6;
    private static final double LEAST_EFFICIENCY_PER_ROUND = 0.1;
    private static final double GOOD_EFFICIENCY = 0.8;
    private static final double SMALLEST_WEIGHT = 1e-3;

    private final StudentTMixture proposal;
    private final double efficiency;

    private ImportanceTuning(StudentTMixture proposal, double efficiency) {
        this.proposal = proposal;
        this.efficiency = efficiency;
    }

    /**
     * Tunes a mixture.
     *
     * @param density target
     * @param start first guess, for instance Laplace's approximation at each mode
     * @param drawsPerRound draws of each of up to six rounds, some hundred per dimension
     * @param random source of randomness
     * @return the best mixture met and its efficiency
     */
    public static ImportanceTuning tune(LogDensity density, StudentTMixture start, int drawsPerRound,
            RandomGenerator random) {
        int n = density.dimension();
        StudentTMixture mixture = start;
        StudentTMixture best = start;
        double bestEfficiency = -1;
        double[][] draws = new double[drawsPerRound][n];
        double[][] shares = new double[drawsPerRound][start.components()];
        double[] logWeights = new double[drawsPerRound];
        for (int round = 0; round <= ROUNDS; round++) {
            for (int i = 0; i < drawsPerRound; i++) {
                mixture.draw(draws[i], random);
                double logTarget = density.at(draws[i]);
                logWeights[i] = logTarget - mixture.logDensity(draws[i]);
                mixture.responsibilities(shares[i]);
            }
            double efficiency = efficiency(logWeights, 1);
            if (efficiency > bestEfficiency) {
                bestEfficiency = efficiency;
                best = mixture;
            }
            if (round == ROUNDS || efficiency > GOOD_EFFICIENCY) {
                break;
            }
            double power = 1;
            while (power > 1e-3 && efficiency(logWeights, power) < LEAST_EFFICIENCY_PER_ROUND) {
                power *= 0.7;
            }
            StudentTMixture next = refit(mixture, draws, shares, normalised(logWeights, power), n);
            if (next == null) {
                break;
            }
            mixture = next;
        }
        return new ImportanceTuning(best, Math.max(bestEfficiency, 0));
    }

    private static StudentTMixture refit(StudentTMixture mixture, double[][] draws, double[][] shares,
            double[] weights, int n) {
        int components = mixture.components();
        double[][] means = new double[components][n];
        double[][] covariances = new double[components][n * n];
        double[] componentWeights = new double[components];
        for (int k = 0; k < components; k++) {
            double total = 0;
            double squares = 0;
            for (int i = 0; i < draws.length; i++) {
                double w = weights[i] * shares[i][k];
                total += w;
                squares += w * w;
                for (int d = 0; d < n; d++) {
                    means[k][d] += w * draws[i][d];
                }
            }
            componentWeights[k] = Math.max(total, SMALLEST_WEIGHT);
            // too few draws speak for this component to learn a covariance from: it stays as it was
            if (!(total > 0) || total * total / squares < 5.0 * n) {
                means[k] = mixture.mean(k);
                covariances[k] = mixture.scale(k);
                continue;
            }
            for (int d = 0; d < n; d++) {
                means[k][d] /= total;
            }
            for (int i = 0; i < draws.length; i++) {
                double w = weights[i] * shares[i][k] / total;
                for (int a = 0; a < n; a++) {
                    for (int b = 0; b <= a; b++) {
                        covariances[k][a * n + b] += w * (draws[i][a] - means[k][a]) * (draws[i][b] - means[k][b]);
                    }
                }
            }
            for (int a = 0; a < n; a++) {
                for (int b = 0; b < a; b++) {
                    covariances[k][b * n + a] = covariances[k][a * n + b];
                }
            }
            if (!Cholesky.factor(covariances[k].clone(), n)) {
                covariances[k] = mixture.scale(k);
            }
        }
        return new StudentTMixture(means, covariances, componentWeights);
    }

    private static double[] normalised(double[] logWeights, double power) {
        double largest = Double.NEGATIVE_INFINITY;
        for (double w : logWeights) {
            largest = Math.max(largest, w);
        }
        double[] weights = new double[logWeights.length];
        double sum = 0;
        for (int i = 0; i < weights.length; i++) {
            weights[i] = largest == Double.NEGATIVE_INFINITY ? 1 : Math.exp(power * (logWeights[i] - largest));
            sum += weights[i];
        }
        for (int i = 0; i < weights.length; i++) {
            weights[i] /= sum;
        }
        return weights;
    }

    /** Effective share of the draws, 1 / (N sum w²) (Kong 1992). */
    private static double efficiency(double[] logWeights, double power) {
        double sum = 0;
        for (double w : normalised(logWeights, power)) {
            sum += w * w;
        }
        return 1 / (sum * logWeights.length);
    }

    /**
     * The tuned mixture.
     *
     * @return a proposal
     */
    public StudentTMixture proposal() {
        return proposal;
    }

    /**
     * Effective share of importance draws from it: 1 for a mixture equal to the target.
     *
     * @return 0 to 1; estimated from one round of draws
     */
    public double efficiency() {
        return efficiency;
    }
}
