package org.cellgauge.statistics;

import java.util.Arrays;
import org.apache.commons.math3.distribution.BetaDistribution;
import org.apache.commons.math3.special.Erf;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
import org.cellgauge.internal.statistics.ParetoTail;
import org.cellgauge.internal.statistics.Quantiles;
import org.cellgauge.internal.statistics.RunningMoments;
import org.jspecify.annotations.Nullable;

/**
 * Convergence diagnostics of one scalar parameter over several Markov chains.
 *
 * <p>Source: Vehtari, Gelman, Simpson, Carpenter &amp; B&uuml;rkner 2021, "Rank-normalization, folding, and
 * localization: an improved R-hat for assessing convergence of MCMC", Bayesian Analysis 16(2), 667-718, called V below.
 * Where the paper leaves a choice, version 1.6 of the R package {@code posterior} is followed:
 *
 * <ul>
 *   <li>Every chain is split into its first and its last half; of an odd number of draws the middle one is left out.
 *       One chain is therefore enough for R-hat, though it cannot show what the chain never visited.
 *   <li>Ranks run over all halves together, ties share their average rank, and rank r of S becomes the normal quantile
 *       of (r - 3/8) / (S + 1/4) (V section 4.1).
 *   <li>Folded draws are the absolute deviations from the median of all draws, taken before the split (V section 4.2);
 *       with an even number of draws the order does not matter.
 *   <li>Effective sample sizes combine the chains' autocovariances (V section 3.2) over Geyer's initial positive and
 *       initial monotone sequences (Geyer 1992, "Practical Markov chain Monte Carlo", Statistical Science 7(4)), with
 *       the term that lessens the variance for antithetic chains. Such chains may have more effective draws than draws;
 *       the size is capped at S log10(S).
 *   <li>The size for the standard deviation is that of the absolute deviation from the mean ({@code posterior} 1.6;
 *       earlier versions, and ArviZ, use squares: {@link #essSquaredDeviation()}).
 *   <li>The standard error of the standard deviation is the first-order one from the fourth moment, without assuming
 *       normal draws (Kenney &amp; Keeping 1951, "Mathematics of Statistics", part 2, p. 141), with the size of the
 *       squared deviation. Earlier versions assumed normal draws.
 * </ul>
 *
 * <p>A chain that is constant, holds a non-finite draw or is too short has no R-hat: {@link #status()} says so and
 * every diagnostic is NaN. Never is 1 returned for lack of evidence. One stuck chain among several is enough for
 * {@link Status#CONSTANT}.
 *
 * <p>Effective sample sizes need chains of at least {@value #MIN_DRAWS_FOR_ESS} draws, because Geyer's sequence cannot
 * be judged on fewer lags; below, they are NaN while R-hat exists.
 *
 * <p>Immutable. An object keeps its own copy of the draws, for {@link #mcseQuantile(double)}.
 */
public final class ChainDiagnostics {
    /** Fewest draws per chain for which a split R-hat is defined. */
    public static final int MIN_DRAWS = 4;

    /** Fewest draws per chain for which effective sample sizes are defined. */
    public static final int MIN_DRAWS_FOR_ESS = 12;

    /** Whether the diagnostics exist. */
    public enum Status {
        /** They exist. */
        OK,
        /** At least one chain never moved. */
        CONSTANT,
        /** At least one draw is infinite or NaN. */
        NON_FINITE,
        /** The chains have fewer than {@link ChainDiagnostics#MIN_DRAWS} draws each. */
        TOO_SHORT
    }

    private final Status status;
    private final double[][] chains;
    private final double[] sorted;
    private final double mean;
    private final double std;
    private final double rHatBulk;
    private final double rHatFolded;
    private final double essBulk;
    private final double essTail;
    private final double essMean;
    private final double essSd;
    private final double essSquaredDeviation;
    private final double mcseMean;
    private final double mcseSd;

    private ChainDiagnostics(double[][] chains) {
        this.chains = chains;
        this.status = statusOf(chains);
        if (status == Status.NON_FINITE || chains[0].length == 0) {
            this.sorted = new double[0];
            this.mean = Double.NaN;
            this.std = Double.NaN;
        } else {
            double[] all = flatten(chains);
            Arrays.sort(all);
            this.sorted = all;
            RunningMoments moments = new RunningMoments(1);
            for (int i = 0; i < all.length; i++) {
                moments.add(all, i);
            }
            this.mean = moments.mean(0);
            this.std = moments.std(0);
        }
        if (status != Status.OK) {
            this.rHatBulk = Double.NaN;
            this.rHatFolded = Double.NaN;
            this.essBulk = Double.NaN;
            this.essTail = Double.NaN;
            this.essMean = Double.NaN;
            this.essSd = Double.NaN;
            this.essSquaredDeviation = Double.NaN;
            this.mcseMean = Double.NaN;
            this.mcseSd = Double.NaN;
            return;
        }
        double median = Quantiles.medianOfSorted(sorted);
        double[][] bulk = normalScores(split(chains));
        this.rHatBulk = rHat(bulk);
        this.rHatFolded = rHat(normalScores(split(deviations(chains, median, 1, false))));
        this.essBulk = effectiveSize(bulk);
        this.essTail = Math.min(essBelow(0.05), essBelow(0.95));
        // Sizes do not depend on shift and scale; taking both out keeps squares of extreme draws from overflowing
        double scale = Math.max(sorted[sorted.length - 1] - mean, mean - sorted[0]);
        double[][] absolute = deviations(chains, mean, scale, false);
        double[][] squares = deviations(chains, mean, scale, true);
        this.essMean = effectiveSize(split(chains, mean, scale));
        this.essSd = effectiveSize(split(absolute));
        this.essSquaredDeviation = effectiveSize(split(squares));
        this.mcseMean = std / Math.sqrt(essMean);
        double second = 0;
        double fourth = 0;
        for (double[] chain : squares) {
            for (double s : chain) {
                second += s;
                fourth += s * s;
            }
        }
        second /= sorted.length;
        fourth /= sorted.length;
        double varianceOfVariance = Math.max(0, fourth - second * second) / essSquaredDeviation;
        this.mcseSd = scale * Math.sqrt(varianceOfVariance / second / 4);
    }

    /**
     * How heavy the tails of the draws are: {@link ParetoTail}. Computed at each call.
     *
     * @return k of the heavier tail; NaN where the diagnostics do not exist
     */
    public double paretoK() {
        return status == Status.OK && essTail > 0
                ? ParetoTail.k(sorted, Math.min(1, essTail / sorted.length)) : Double.NaN;
    }

    /**
     * Diagnoses one parameter.
     *
     * @param chains draws after warm-up, {@code [chain][draw]}; one chain or more, of equal length
     * @return the diagnostics
     * @throws IllegalArgumentException if there is no chain, or chains differ in length
     */
    public static ChainDiagnostics of(double[][] chains) {
        if (chains.length == 0) {
            throw new IllegalArgumentException("at least one chain is needed");
        }
        double[][] copy = new double[chains.length][];
        for (int c = 0; c < chains.length; c++) {
            if (chains[c].length != chains[0].length) {
                throw new IllegalArgumentException("chains must have the same number of draws: chain 0 has "
                        + chains[0].length + ", chain " + c + " has " + chains[c].length);
            }
            copy[c] = chains[c].clone();
        }
        return new ChainDiagnostics(copy);
    }

    /**
     * Whether the diagnostics exist.
     *
     * @return {@link Status#OK} if they do, otherwise why not
     */
    public Status status() {
        return status;
    }

    /**
     * Number of chains.
     *
     * @return the count, at least 1
     */
    public int chainCount() {
        return chains.length;
    }

    /**
     * Number of draws per chain.
     *
     * @return the count
     */
    public int drawsPerChain() {
        return chains[0].length;
    }

    /**
     * Mean of all draws.
     *
     * @return the mean; NaN if a draw is not finite or there is none
     */
    public double mean() {
        return mean;
    }

    /**
     * Standard deviation of all draws (divisor n - 1).
     *
     * @return the standard deviation; NaN if a draw is not finite or there are fewer than two
     */
    public double std() {
        return std;
    }

    /**
     * Rank-normalised split R-hat: the larger of {@link #rHatBulk()} and {@link #rHatFolded()} (V section 4.2).
     *
     * @return R-hat; infinite if no half of a chain moves, but they stand apart; NaN without {@link Status#OK}
     */
    public double rHat() {
        return Math.max(rHatBulk, rHatFolded);
    }

    /**
     * Rank-normalised split R-hat of the draws: do the chains agree about the location?
     *
     * @return R-hat; NaN without {@link Status#OK}
     */
    public double rHatBulk() {
        return rHatBulk;
    }

    /**
     * Rank-normalised split R-hat of the absolute deviations from the median: do the chains agree about the spread?
     *
     * @return R-hat; NaN without {@link Status#OK}
     */
    public double rHatFolded() {
        return rHatFolded;
    }

    /**
     * Bulk effective sample size: that of the rank-normalised draws (V section 4.1).
     *
     * @return the size in draws, all chains together; NaN where it does not exist
     */
    public double essBulk() {
        return essBulk;
    }

    /**
     * Tail effective sample size: the smaller of those of the 5 % and the 95 % quantile (V section 4.3).
     *
     * @return the size in draws; NaN where it does not exist, also if ties leave no draw above the 95 % quantile
     */
    public double essTail() {
        return essTail;
    }

    /**
     * Effective sample size for the mean, from the draws as they are.
     *
     * @return the size in draws; NaN where it does not exist
     */
    public double essMean() {
        return essMean;
    }

    /**
     * Effective sample size for the standard deviation, from the absolute deviations from the mean.
     *
     * @return the size in draws; NaN where it does not exist
     */
    public double essSd() {
        return essSd;
    }

    /**
     * Effective sample size of the squared deviation from the mean, that is for the variance.
     *
     * @return the size in draws; NaN where it does not exist
     */
    public double essSquaredDeviation() {
        return essSquaredDeviation;
    }

    /**
     * Effective sample size for a quantile, from the indicator of draws up to the sample quantile (V section 4.3).
     *
     * @param probability of the quantile, in (0, 1)
     * @return the size in draws; NaN where it does not exist, also if ties leave no draw above the quantile
     * @throws IllegalArgumentException if the probability is outside (0, 1)
     */
    public double essQuantile(double probability) {
        requireProbability(probability);
        return status == Status.OK ? essBelow(probability) : Double.NaN;
    }

    /**
     * Monte Carlo standard error of the mean.
     *
     * @return the error, in the unit of the draws; NaN where it does not exist
     */
    public double mcseMean() {
        return mcseMean;
    }

    /**
     * Monte Carlo standard error of the standard deviation.
     *
     * @return the error, in the unit of the draws; NaN where it does not exist
     */
    public double mcseSd() {
        return mcseSd;
    }

    /**
     * The sample quantile of all draws (type 7 of Hyndman &amp; Fan 1996).
     *
     * @param probability of the quantile, in (0, 1)
     * @return the quantile; NaN if a draw is not finite or there is none
     * @throws IllegalArgumentException if the probability is outside (0, 1)
     */
    public double quantile(double probability) {
        requireProbability(probability);
        return sorted.length == 0 ? Double.NaN : Quantiles.ofSorted(sorted, probability);
    }

    /**
     * Monte Carlo standard error of a quantile: half the distance between the order statistics at the 16 % and 84 %
     * points of Beta(n p + 1, n (1 - p) + 1), n being {@link #essQuantile(double)} (V section 4.4).
     *
     * @param probability of the quantile, in (0, 1)
     * @return the error, in the unit of the draws; NaN where it does not exist
     * @throws IllegalArgumentException if the probability is outside (0, 1)
     */
    public double mcseQuantile(double probability) {
        double size = essQuantile(probability);
        if (Double.isNaN(size)) {
            return Double.NaN;
        }
        // The solver's default of 1e-9 could pick a neighbouring order statistic among many draws. The generator is
        // null because no numbers are drawn
        BetaDistribution beta =
                new BetaDistribution(null, size * probability + 1, size * (1 - probability) + 1, 1e-13);
        int total = sorted.length;
        // Normal probabilities of one standard deviation to either side, as rounded by V and its implementations
        double low = Math.floor(beta.inverseCumulativeProbability(0.1586553) * total);
        double high = Math.ceil(beta.inverseCumulativeProbability(0.8413447) * total);
        double lowValue = sorted[(int) Math.max(low, 1) - 1];
        double highValue = sorted[(int) Math.min(high, total) - 1];
        return (highValue - lowValue) / 2;
    }

    /**
     * The verdict on this parameter.
     *
     * @return the verdict; {@link Convergence#NOT_CONVERGED} without {@link Status#OK}
     */
    public Convergence convergence() {
        return Convergence.of(rHat(), essBulk, essTail);
    }

    private static Status statusOf(double[][] chains) {
        boolean constant = false;
        for (double[] chain : chains) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (double x : chain) {
                if (!Double.isFinite(x)) {
                    return Status.NON_FINITE;
                }
                low = Math.min(low, x);
                high = Math.max(high, x);
            }
            // Compared as numbers, so that a chain of 0.0 and -0.0 counts as constant
            constant |= low == high;
        }
        if (chains[0].length < MIN_DRAWS) {
            return Status.TOO_SHORT;
        }
        return constant ? Status.CONSTANT : Status.OK;
    }

    private static void requireProbability(double probability) {
        if (!(probability > 0 && probability < 1)) {
            throw new IllegalArgumentException("probability must lie in (0, 1), was " + probability);
        }
    }

    private static double[] flatten(double[][] chains) {
        int n = chains[0].length;
        double[] all = new double[chains.length * n];
        for (int c = 0; c < chains.length; c++) {
            System.arraycopy(chains[c], 0, all, c * n, n);
        }
        return all;
    }

    private static double[][] split(double[][] chains) {
        int n = chains[0].length;
        int half = n / 2;
        double[][] halves = new double[2 * chains.length][];
        for (int c = 0; c < chains.length; c++) {
            halves[2 * c] = Arrays.copyOfRange(chains[c], 0, half);
            halves[2 * c + 1] = Arrays.copyOfRange(chains[c], n - half, n);
        }
        return halves;
    }

    private static double[][] split(double[][] chains, double shift, double scale) {
        double[][] halves = split(chains);
        for (double[] half : halves) {
            for (int i = 0; i < half.length; i++) {
                half[i] = (half[i] - shift) / scale;
            }
        }
        return halves;
    }

    private static double[][] deviations(double[][] chains, double centre, double scale, boolean squared) {
        double[][] out = new double[chains.length][chains[0].length];
        for (int c = 0; c < chains.length; c++) {
            for (int i = 0; i < out[c].length; i++) {
                double d = Math.abs(chains[c][i] - centre) / scale;
                out[c][i] = squared ? d * d : d;
            }
        }
        return out;
    }

    /** Normal quantiles of the ranks over all halves together. */
    private static double[][] normalScores(double[][] halves) {
        double[] all = flatten(halves);
        Arrays.sort(all);
        double[] ofFirst = scoresOfSorted(all);
        double[][] scores = new double[halves.length][halves[0].length];
        for (int c = 0; c < halves.length; c++) {
            for (int i = 0; i < scores[c].length; i++) {
                scores[c][i] = ofFirst[lowerBound(all, halves[c][i])];
            }
        }
        return scores;
    }

    /** The score of each value of a sorted series, where the first of equal ones stands. */
    private static double[] scoresOfSorted(double[] all) {
        double[] scores = new double[all.length];
        for (int first = 0, next; first < all.length; first = next) {
            next = first + 1;
            while (next < all.length && all[next] == all[first]) {
                next++;
            }
            // Ranks first + 1..next, counted from 1, are shared by all that are equal
            double rank = (first + 1 + next) / 2.0;
            double p = (rank - 0.375) / (all.length + 0.25);
            scores[first] = Math.sqrt(2) * Erf.erfInv(2 * p - 1);
        }
        return scores;
    }

    private static int lowerBound(double[] sorted, double x) {
        int low = 0;
        int high = sorted.length;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (sorted[middle] < x) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** V section 3.1, over chains that are already split. NaN if no half moves and all stand at the same place. */
    private static double rHat(double[][] halves) {
        int n = halves[0].length;
        RunningMoments means = new RunningMoments(1);
        double within = 0;
        double[] box = new double[1];
        for (double[] half : halves) {
            RunningMoments moments = new RunningMoments(1);
            for (int i = 0; i < n; i++) {
                moments.add(half, i);
            }
            moments.mean(box);
            means.add(box);
            within += moments.covariance(0, 0);
        }
        within /= halves.length;
        double betweenOverN = means.covariance(0, 0);
        return Math.sqrt((n - 1.0) / n + betweenOverN / within);
    }

    private double essBelow(double probability) {
        double quantile = Quantiles.ofSorted(sorted, probability);
        double[][] indicator = new double[chains.length][chains[0].length];
        for (int c = 0; c < chains.length; c++) {
            for (int i = 0; i < indicator[c].length; i++) {
                indicator[c][i] = chains[c][i] <= quantile ? 1 : 0;
            }
        }
        return effectiveSize(split(indicator));
    }

    /** V section 3.2, over chains that are already split. */
    private static double effectiveSize(double[][] halves) {
        int n = halves[0].length;
        int m = halves.length;
        if (n < MIN_DRAWS_FOR_ESS / 2) {
            return Double.NaN;
        }
        Autocovariance autocovariance = new Autocovariance(halves);
        double within = autocovariance.at(0) * n / (n - 1.0);
        double total = autocovariance.at(0) + autocovariance.varianceOfMeans();
        if (!(total > 0)) {
            // No half moves and all stand at the same place (or a NaN): nothing to base a size on
            return Double.NaN;
        }
        // Autocorrelations rho(0), rho(1), ... in pairs of an even and the following odd lag. For reversible chains
        // the sums of pairs are positive and decreasing (Geyer 1992, section 3.3); where the estimates stop being so,
        // only noise follows.
        double previousPair = 1 + rho(autocovariance, 1, within, total);
        double sum = 0;
        double tail = 1;
        int lag = 0;
        double pair = previousPair;
        while (lag < n - 5 && pair > 0) {
            // The pair at this lag counts in full, cut down to the pair before it if it exceeds it
            previousPair = Math.min(previousPair, pair);
            sum += previousPair;
            lag += 2;
            double even = rho(autocovariance, lag, within, total);
            pair = even + rho(autocovariance, lag + 1, within, total);
            // Half of the next even lag still counts: it lowers the variance for antithetic chains, whose odd lags
            // are negative. A negative even lag counts only if its pair was accepted.
            tail = even > 0 || pair >= 0 ? even : 0;
        }
        double tau = -1 + 2 * sum + tail;
        double draws = (double) m * n;
        return draws / Math.max(tau, 1 / Math.log10(draws));
    }

    private static double rho(Autocovariance autocovariance, int lag, double within, double total) {
        return 1 - (within - autocovariance.at(lag)) / total;
    }

    /**
     * Mean over the halves of their autocovariances (divisor n at every lag), lag by lag as they are asked for.
     *
     * <p>Chains that mix well need a dozen lags, for which summing products is far cheaper than a Fourier transform;
     * chains that do not need thousands, for which it is the other way round.
     */
    private static final class Autocovariance {
        private static final int DIRECT_LAGS = 96;

        private final double[][] centred;
        private final RunningMoments means = new RunningMoments(1);
        private double @Nullable [] transformed;

        Autocovariance(double[][] halves) {
            centred = new double[halves.length][];
            for (int h = 0; h < halves.length; h++) {
                double mean = 0;
                for (double x : halves[h]) {
                    mean += x;
                }
                mean /= halves[h].length;
                means.add(new double[] {mean});
                centred[h] = halves[h].clone();
                for (int i = 0; i < centred[h].length; i++) {
                    centred[h][i] -= mean;
                }
            }
        }

        double varianceOfMeans() {
            return means.covariance(0, 0);
        }

        double at(int lag) {
            if (lag < DIRECT_LAGS && transformed == null) {
                double sum = 0;
                for (double[] x : centred) {
                    for (int i = lag; i < x.length; i++) {
                        sum += x[i] * x[i - lag];
                    }
                }
                return sum / centred[0].length / centred.length;
            }
            if (transformed == null) {
                transformed = transform();
            }
            return transformed[lag];
        }

        private double[] transform() {
            int n = centred[0].length;
            double[] out = new double[n];
            // Padding to twice the length keeps the circular correlation of the transform from wrapping around
            int size = Integer.highestOneBit(2 * n - 1) << 1;
            double[][] data = new double[2][size];
            for (double[] x : centred) {
                Arrays.fill(data[0], 0);
                Arrays.fill(data[1], 0);
                System.arraycopy(x, 0, data[0], 0, n);
                FastFourierTransformer.transformInPlace(data, DftNormalization.STANDARD, TransformType.FORWARD);
                for (int k = 0; k < size; k++) {
                    double re = data[0][k];
                    double im = data[1][k];
                    data[0][k] = re * re + im * im;
                    data[1][k] = 0;
                }
                FastFourierTransformer.transformInPlace(data, DftNormalization.STANDARD, TransformType.INVERSE);
                for (int t = 0; t < n; t++) {
                    out[t] += data[0][t] / n / centred.length;
                }
            }
            return out;
        }
    }
}
