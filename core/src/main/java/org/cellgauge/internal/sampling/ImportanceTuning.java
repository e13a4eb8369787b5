package org.cellgauge.internal.sampling;

import java.util.Collections;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.special.Gamma;
import org.apache.commons.math3.util.KthSelector;
import org.cellgauge.internal.geometry.Cholesky;
import org.jspecify.annotations.Nullable;

/**
 * Fits a t mixture to a target by adaptive importance sampling (Cappé, Douc, Guillin, Marin, Robert, "Adaptive
 * importance sampling in general mixture classes", Statistics and Computing 2008): draws are weighted by target over
 * mixture, and weights, means and scales of the components become the weighted ones. Where the weights are very uneven
 * they are first flattened by a power below 1, so that a start far from the target is approached in steps.
 *
 * <p>Where one component per mode does not fit nearly as well as it would fit a Gaussian, more are spread over the
 * target, and then the tails are searched by a random walk: an independence chain that once gets to where its proposal
 * is far too thin stays there for thousands of steps, and importance draws do not show such places because they hardly
 * reach them.
 */
public final class ImportanceTuning {
    private static final int ROUNDS = 6;
    private static final double LEAST_EFFICIENCY_PER_ROUND = 0.1;
    /**
     * Share of what a Gaussian target gives at which a mixture will do: a chain needs a twentieth more steps than from
     * one that fits, some hundred, and one more round takes more evaluations than that. Where it stays below, the tails
     * are searched.
     */
    private static final double GOOD_SHARE = 0.95;
    /** Factor by which a round must better the efficiency to count as progress. */
    private static final double GAIN = 1.02;
    private static final double SMALLEST_WEIGHT = 1e-3;
    /**
     * Share of what a Gaussian target gives below which a component per mode is not enough: above it more of them cost
     * more evaluations than they save a run steps, and rounds end where one brings nothing; below it they go on, since
     * tails may yet be met.
     */
    private static final double ENOUGH_SHARE = 0.8;
    private static final int SPREAD_COMPONENTS = 8;
    private static final double SPREAD_SCALE = 0.4;
    private static final int SPREAD_ROUNDS = 10;
    private static final int SPREAD_DRAWS_FACTOR = 3;
    private static final int WALK_WARMUP = 1000;
    private static final int WALK_STEPS = 6000;
    private static final int WALK_THINNING = 4;
    /** Power of the target that the search of the tails walks over: below 1, so that it comes to them often. */
    private static final double TEMPER = 0.6;
    private static final int MOST_TAIL_COMPONENTS = 16;
    private static final double TAIL_WEIGHT = 0.01;
    /** Log of target over mixture, both normalised, from which on the mixture is too thin: a factor of four. */
    private static final double THIN = 1.4;
    /** Points per dimension that shape a component of the tails. */
    private static final int NEIGHBOURS = 15;

    private final StudentTMixture proposal;
    private final double efficiency;
    private final long evaluations;

    private ImportanceTuning(StudentTMixture proposal, double efficiency, long evaluations) {
        this.proposal = proposal;
        this.efficiency = efficiency;
        this.evaluations = evaluations;
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
        Scaled counted = new Scaled(density, 1);
        double ofGaussian = efficiencyOfGaussian(density.dimension());
        Round plain = iterate(counted, start, drawsPerRound, ROUNDS, ofGaussian, random);
        if (plain.efficiency > GOOD_SHARE * ofGaussian) {
            return new ImportanceTuning(plain.mixture, plain.efficiency, counted.evaluations);
        }
        Round best = plain;
        if (plain.efficiency <= ENOUGH_SHARE * ofGaussian) {
            // a bent or heavy-tailed target is covered by several components side by side, started where the weight is
            Round rich = iterate(counted, spread(plain, random), SPREAD_DRAWS_FACTOR * drawsPerRound, SPREAD_ROUNDS,
                    ofGaussian, random);
            best = rich.efficiency > plain.efficiency ? rich : plain;
        }
        StudentTMixture covering = withTails(counted, best, start.components(), random);
        double efficiency = covering == best.mixture ? best.efficiency
                : new Round(counted, covering, best.logWeights.length, random).efficiency;
        return new ImportanceTuning(covering, efficiency, counted.evaluations);
    }

    /** Draws of a mixture, weighted by target over mixture. */
    private static final class Round {
        final StudentTMixture mixture;
        final double[][] draws;
        /** Share of each component in the mixture's density at each draw. */
        final double[][] shares;
        final double[] logWeights;
        final double efficiency;

        Round(LogDensity density, StudentTMixture mixture, int count, RandomGenerator random) {
            this.mixture = mixture;
            draws = new double[count][density.dimension()];
            shares = new double[count][mixture.components()];
            logWeights = new double[count];
            for (int i = 0; i < count; i++) {
                mixture.draw(draws[i], random);
                double logTarget = density.at(draws[i]);
                logWeights[i] = logTarget - mixture.logDensity(draws[i]);
                mixture.responsibilities(shares[i]);
            }
            efficiency = efficiency(logWeights, 1);
        }
    }

    /** A power of a density, with a count of how often it was evaluated. */
    private static final class Scaled implements LogDensity {
        private final LogDensity density;
        private final double power;
        private long evaluations;

        Scaled(LogDensity density, double power) {
            this.density = density;
            this.power = power;
        }

        @Override
        public int dimension() {
            return density.dimension();
        }

        @Override
        public double at(double[] x) {
            evaluations++;
            return power * density.at(x);
        }
    }

    /**
     * Efficiency for a Gaussian target of the t with the same location and its covariance as scale matrix: the inverse
     * of the integral of target squared over t.
     *
     * @param dimension of the target
     * @return 0 to 1
     */
    static double efficiencyOfGaussian(int dimension) {
        double nu = StudentTMixture.DEGREES_OF_FREEDOM;
        double n = dimension;
        double logConstant = Math.log(2) + n / 2 * Math.log(Math.PI) - Gamma.logGamma(n / 2) - n * Math.log(2 * Math.PI)
                - Gamma.logGamma((nu + n) / 2) + Gamma.logGamma(nu / 2) + n / 2 * Math.log(nu * Math.PI);
        // the trapezium rule; it counts half of what the integrand is at 0, which is not 0 on a line
        double step = 0.1;
        double sum = n == 1 ? step / 2 * Math.exp(logConstant) : 0;
        for (double r = step; r < Math.sqrt(n) + 10; r += step) {
            sum += step * Math.exp(logConstant + (n - 1) * Math.log(r) - r * r + (nu + n) / 2 * Math.log1p(r * r / nu));
        }
        return 1 / sum;
    }

    /**
     * Adds components where the mixture is too thin: one at a time at the worst point of a random walk, shaped by the
     * points about it (Raftery and Bao, "Estimating and projecting trends in HIV/AIDS generalized epidemics using
     * incremental mixture importance sampling", Biometrics 2010, with a walk in place of importance draws).
     */
    private static StudentTMixture withTails(LogDensity density, Round fitted, int modes, RandomGenerator random) {
        StudentTMixture mixture = fitted.mixture;
        int n = density.dimension();
        int perWalk = WALK_STEPS / WALK_THINNING;
        double[][] points = new double[modes * perWalk][];
        double[] logTarget = new double[points.length];
        for (int m = 0; m < modes; m++) {
            if (!(density.at(mixture.mean(m)) > Double.NEGATIVE_INFINITY)) {
                return mixture;
            }
            AdaptiveStep step = new AdaptiveStep(mixture.scale(m), n);
            MetropolisChain walk = new MetropolisChain(new Scaled(density, TEMPER), Collections.singletonList(step),
                    mixture.mean(m), random);
            for (int i = 0; i < WALK_WARMUP; i++) {
                walk.step();
            }
            step.freeze();
            for (int i = 0; i < WALK_STEPS; i++) {
                walk.step();
                if (i % WALK_THINNING == 0) {
                    points[m * perWalk + i / WALK_THINNING] = walk.current().clone();
                    logTarget[m * perWalk + i / WALK_THINNING] = walk.logDensity() / TEMPER;
                }
            }
        }
        double limit = logMean(fitted.logWeights) + THIN;
        StudentTMixture covering = mixture;
        double[] logMixture = new double[points.length];
        for (int i = 0; i < points.length; i++) {
            logMixture[i] = mixture.logDensity(points[i]);
        }
        for (int added = 0; added < MOST_TAIL_COMPONENTS; added++) {
            int worst = 0;
            double most = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < points.length; i++) {
                double logRatio = logTarget[i] - logMixture[i];
                if (logRatio > most) {
                    most = logRatio;
                    worst = i;
                }
            }
            double[] covariance = most > limit ? covarianceAbout(points[worst], points, covering) : null;
            if (covariance == null) {
                break;
            }
            covering = with(covering, points[worst], covariance);
            StudentTMixture alone = new StudentTMixture(new double[][] {points[worst]}, new double[][] {covariance},
                    new double[] {1});
            for (int i = 0; i < points.length; i++) {
                double before = logMixture[i] + Math.log(1 - TAIL_WEIGHT);
                double more = alone.logDensity(points[i]) + Math.log(TAIL_WEIGHT);
                logMixture[i] = Math.max(before, more) + Math.log1p(Math.exp(-Math.abs(before - more)));
            }
        }
        return covering;
    }

    /** Logarithm of the mean of weights given by their logarithms. */
    private static double logMean(double[] logWeights) {
        double largest = Double.NEGATIVE_INFINITY;
        for (double w : logWeights) {
            largest = Math.max(largest, w);
        }
        double sum = 0;
        for (double w : logWeights) {
            sum += Math.exp(w - largest);
        }
        return largest + Math.log(sum / logWeights.length);
    }

    /** Covariance of the points about one of them; null if they span no volume. */
    private static double @Nullable [] covarianceAbout(double[] at, double[][] points, StudentTMixture mixture) {
        int n = at.length;
        double[] distances = squaredDistances(mixture.scale(mixture.heaviest()), at, points);
        double reach = new KthSelector().select(distances.clone(), null,
                Math.min(distances.length, NEIGHBOURS * n) - 1);
        double[] covariance = new double[n * n];
        int count = 0;
        for (int i = 0; i < points.length; i++) {
            if (distances[i] <= reach) {
                count++;
                for (int a = 0; a < n; a++) {
                    for (int b = 0; b < n; b++) {
                        covariance[a * n + b] += (points[i][a] - at[a]) * (points[i][b] - at[b]);
                    }
                }
            }
        }
        for (int a = 0; a < covariance.length; a++) {
            covariance[a] /= count;
        }
        return Cholesky.factor(covariance.clone(), n) ? covariance : null;
    }

    /** The mixture and one more component about a point. */
    private static StudentTMixture with(StudentTMixture mixture, double[] at, double[] covariance) {
        int k = mixture.components();
        double[][] means = new double[k + 1][];
        double[][] covariances = new double[k + 1][];
        double[] weights = new double[k + 1];
        for (int i = 0; i < k; i++) {
            means[i] = mixture.mean(i);
            covariances[i] = mixture.scale(i);
            weights[i] = mixture.weight(i) * (1 - TAIL_WEIGHT);
        }
        means[k] = at;
        covariances[k] = covariance;
        weights[k] = TAIL_WEIGHT;
        return new StudentTMixture(means, covariances, weights);
    }

    /** Squared Mahalanobis distances from a point; the covariance is overwritten by its factor. */
    private static double[] squaredDistances(double[] covariance, double[] at, double[][] points) {
        int n = at.length;
        Cholesky.factor(covariance, n);
        double[] whitened = new double[n];
        double[] distances = new double[points.length];
        for (int i = 0; i < points.length; i++) {
            for (int a = 0; a < n; a++) {
                double s = points[i][a] - at[a];
                for (int b = 0; b < a; b++) {
                    s -= covariance[a * n + b] * whitened[b];
                }
                whitened[a] = s / covariance[a * n + a];
                distances[i] += whitened[a] * whitened[a];
            }
        }
        return distances;
    }

    /** The round of the best mixture met. */
    private static Round iterate(LogDensity density, StudentTMixture start, int drawsPerRound, int rounds,
            double ofGaussian, RandomGenerator random) {
        Round round = new Round(density, start, drawsPerRound, random);
        Round best = round;
        boolean idle = false;
        for (int i = 0; i < rounds && best.efficiency <= GOOD_SHARE * ofGaussian
                && !(idle && best.efficiency > ENOUGH_SHARE * ofGaussian); i++) {
            double power = 1;
            while (power > 1e-3 && efficiency(round.logWeights, power) < LEAST_EFFICIENCY_PER_ROUND) {
                power *= 0.7;
            }
            round = new Round(density, refit(round, normalised(round.logWeights, power)), drawsPerRound, random);
            idle = round.efficiency <= GAIN * best.efficiency;
            best = round.efficiency > best.efficiency ? round : best;
        }
        return best;
    }

    /** Several components at draws picked by their weight, each with a part of the target's spread. */
    private static StudentTMixture spread(Round round, RandomGenerator random) {
        StudentTMixture mixture = round.mixture;
        double[][] draws = round.draws;
        double[] weights = normalised(round.logWeights, 1);
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
            double[] shares = round.shares[pick];
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

    private static StudentTMixture refit(Round round, double[] weights) {
        StudentTMixture mixture = round.mixture;
        double[][] draws = round.draws;
        double[][] shares = round.shares;
        int n = draws[0].length;
        int components = mixture.components();
        double[][] means = new double[components][n];
        double[][] covariances = new double[components][n * n];
        double[] componentWeights = new double[components];
        double[] off = new double[n];
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
            double[] mean = means[k];
            double[] covariance = covariances[k];
            for (int i = 0; i < draws.length; i++) {
                double w = weights[i] * shares[i][k] / total;
                double[] draw = draws[i];
                for (int a = 0; a < n; a++) {
                    off[a] = draw[a] - mean[a];
                    double weighted = w * off[a];
                    for (int b = 0; b <= a; b++) {
                        covariance[a * n + b] += weighted * off[b];
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

    /**
     * How often the target was evaluated for it.
     *
     * @return the count
     */
    public long evaluations() {
        return evaluations;
    }
}
