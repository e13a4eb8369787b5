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
    /** Efficiency below which a component per mode is not enough. */
    private static final double ENOUGH_EFFICIENCY = 0.7;
    private static final int SPREAD_COMPONENTS = 8;
    private static final double SPREAD_SCALE = 0.4;
    private static final int SPREAD_ROUNDS = 10;
    private static final int SPREAD_DRAWS_FACTOR = 3;

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
     * @param drawsPerRound draws of each of up to six rounds, some hundred per dimension; more where one component
     *     per mode does not fit
     * @param random source of randomness
     * @return the best mixture met and its efficiency
     */
    public static ImportanceTuning tune(LogDensity density, StudentTMixture start, int drawsPerRound,
            RandomGenerator random) {
        ImportanceTuning plain = iterate(density, start, drawsPerRound, ROUNDS, random);
        if (plain.efficiency > ENOUGH_EFFICIENCY) {
            return plain;
        }
        // a bent or heavy-tailed target is covered by several components side by side, started where the weight is
        StudentTMixture spread = spread(density, plain.proposal, drawsPerRound, random);
        if (spread == null) {
            return plain;
        }
        ImportanceTuning rich = iterate(density, spread, SPREAD_DRAWS_FACTOR * drawsPerRound, SPREAD_ROUNDS, random);
        return rich.efficiency > plain.efficiency ? rich : plain;
    }

    private static ImportanceTuning iterate(LogDensity density, StudentTMixture start, int drawsPerRound, int rounds,
            RandomGenerator random) {
        int n = density.dimension();
        StudentTMixture mixture = start;
        StudentTMixture best = start;
        double bestEfficiency = -1;
        double[][] draws = new double[drawsPerRound][n];
        double[][] shares = new double[drawsPerRound][start.components()];
        double[] logWeights = new double[drawsPerRound];
        for (int round = 0; round <= rounds; round++) {
            weigh(density, mixture, draws, shares, logWeights, random);
            double efficiency = efficiency(logWeights, 1);
            if (efficiency > bestEfficiency) {
                bestEfficiency = efficiency;
                best = mixture;
            }
            if (round == rounds || efficiency > GOOD_EFFICIENCY) {
                break;
            }
            double power = 1;
            while (power > 1e-3 && efficiency(logWeights, power) < LEAST_EFFICIENCY_PER_ROUND) {
                power *= 0.7;
            }
            mixture = refit(mixture, draws, shares, normalised(logWeights, power), n);
        }
        return new ImportanceTuning(best, Math.max(bestEfficiency, 0));
    }

    private static void weigh(LogDensity density, StudentTMixture mixture, double[][] draws, double[][] shares,
            double[] logWeights, RandomGenerator random) {
        for (int i = 0; i < draws.length; i++) {
            mixture.draw(draws[i], random);
            double logTarget = density.at(draws[i]);
            logWeights[i] = logTarget - mixture.logDensity(draws[i]);
            if (shares != null) {
                mixture.responsibilities(shares[i]);
            }
        }
    }

    /** Several components at draws picked by their weight, each with a part of the target's spread; null without any. */
    private static StudentTMixture spread(LogDensity density, StudentTMixture mixture, int drawsPerRound,
            RandomGenerator random) {
        int n = density.dimension();
        double[][] draws = new double[drawsPerRound][n];
        double[] logWeights = new double[drawsPerRound];
        weigh(density, mixture, draws, null, logWeights, random);
        double[] weights = normalised(logWeights, 1);
        int components = mixture.components() + SPREAD_COMPONENTS;
        double[][] means = new double[components][];
        double[][] covariances = new double[components][];
        double[] componentWeights = new double[components];
        for (int k = 0; k < components; k++) {
            if (k < mixture.components()) {
                means[k] = mixture.mean(k);
                covariances[k] = mixture.scale(k);
                componentWeights[k] = mixture.weight(k);
                continue;
            }
            double u = random.nextDouble();
            int pick = 0;
            while (pick < draws.length - 1 && u >= weights[pick]) {
                u -= weights[pick++];
            }
            int parent = 0;
            double[] shares = new double[mixture.components()];
            mixture.logDensity(draws[pick]);
            mixture.responsibilities(shares);
            for (int c = 1; c < shares.length; c++) {
                parent = shares[c] > shares[parent] ? c : parent;
            }
            means[k] = draws[pick].clone();
            covariances[k] = mixture.scale(parent);
            for (int i = 0; i < covariances[k].length; i++) {
                covariances[k][i] *= SPREAD_SCALE;
            }
            componentWeights[k] = 1.0 / SPREAD_COMPONENTS;
        }
        return new StudentTMixture(means, covariances, componentWeights);
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

    /** Effective share of the draws, 1 / (N sum w²) (Kong 1992); 0 where no draw met the target at all. */
    private static double efficiency(double[] logWeights, double power) {
        boolean met = false;
        for (double w : logWeights) {
            met |= w > Double.NEGATIVE_INFINITY;
        }
        if (!met) {
            return 0;
        }
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
