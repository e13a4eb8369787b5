package org.cellgauge.statistics;

import java.util.function.ToDoubleFunction;
import org.cellgauge.internal.statistics.Autocovariance;
import org.cellgauge.internal.statistics.BetaRank;
import org.cellgauge.internal.statistics.BucketSort;
import org.cellgauge.internal.statistics.DrawsWork;
import org.cellgauge.internal.statistics.ParetoTail;
import org.cellgauge.internal.statistics.Quantiles;
import org.cellgauge.internal.statistics.RankScores;
import org.cellgauge.internal.statistics.Sums;

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
 * <p>Immutable. An object keeps the draws, for {@link #mcseQuantile(double)}.
 */
public final class ChainDiagnostics {
    /** Fewest draws per chain for which a split R-hat is defined. */
    public static final int MIN_DRAWS = 4;

    /** Quantiles whose sizes make that of the tails (V section 4.3). */
    private static final double LOW_TAIL = 0.05;
    private static final double HIGH_TAIL = 0.95;

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
    private final int chainCount;
    private final int drawsPerChain;
    /** All draws, chain after chain. */
    private final double[] draws;
    private final double[] sorted;
    private final double mean;
    private final double std;
    private final double rHatBulk;
    private final double rHatFolded;
    private final double essBulk;
    private final double essLowTail;
    private final double essHighTail;
    private final double essSquaredDeviation;
    private final double mcseSd;
    private final DrawsWork.Pool works;

    private ChainDiagnostics(double[] draws, int chains, DrawsWork.Pool works, DrawsWork work) {
        this.chainCount = chains;
        this.drawsPerChain = draws.length / chains;
        this.draws = draws;
        this.works = works;
        this.status = statusOf(draws, chains);
        int[] order;
        if (status == Status.NON_FINITE || draws.length == 0) {
            order = new int[0];
            this.sorted = new double[0];
            this.mean = Double.NaN;
            this.std = Double.NaN;
        } else {
            this.sorted = new double[draws.length];
            order = BucketSort.sort(draws, sorted, work);
            this.mean = Sums.mean(sorted, 0, sorted.length);
            this.std = Math.sqrt(Sums.variance(sorted, 0, sorted.length));
        }
        if (status != Status.OK) {
            this.rHatBulk = Double.NaN;
            this.rHatFolded = Double.NaN;
            this.essBulk = Double.NaN;
            this.essLowTail = Double.NaN;
            this.essHighTail = Double.NaN;
            this.essSquaredDeviation = Double.NaN;
            this.mcseSd = Double.NaN;
            return;
        }
        double median = Quantiles.medianOfSorted(sorted);
        int[] orderOfHalves = orderOfHalves(order);
        double[] ascending = sorted;
        if (orderOfHalves.length < order.length) {
            double[] halves = halves(work);
            ascending = new double[orderOfHalves.length];
            for (int i = 0; i < ascending.length; i++) {
                ascending[i] = halves[orderOfHalves[i]];
            }
        }
        RankScores scores = work.scores(ascending.length);
        double[] ofHalves = work.values(ascending.length);
        scores.fill(ascending, orderOfHalves, ofHalves);
        this.rHatBulk = rHat(ofHalves);
        this.essBulk = effectiveSize(ofHalves);
        fold(ascending, orderOfHalves, median, work);
        scores.fill(work.distances(ascending.length), work.ofDistances(ascending.length), ofHalves);
        this.rHatFolded = rHat(ofHalves);
        this.essLowTail = essBelow(LOW_TAIL, work);
        this.essHighTail = essBelow(HIGH_TAIL, work);
        double scale = scale();
        double[] halves = halves(work);
        for (int i = 0; i < halves.length; i++) {
            double d = (halves[i] - mean) / scale;
            halves[i] = d * d;
        }
        this.essSquaredDeviation = effectiveSize(halves);
        double second = 0;
        double fourth = 0;
        for (double x : draws) {
            double d = (x - mean) / scale;
            second += d * d;
            fourth += d * d * (d * d);
        }
        second /= draws.length;
        fourth /= draws.length;
        double varianceOfVariance = Math.max(0, fourth - second * second) / essSquaredDeviation;
        this.mcseSd = scale * Math.sqrt(varianceOfVariance / second / 4);
    }

    /** Sizes do not depend on shift and scale; taking both out keeps squares of extreme draws from overflowing. */
    private double scale() {
        return Math.max(sorted[sorted.length - 1] - mean, mean - sorted[0]);
    }

    /**
     * How heavy the tails of the draws are: {@link ParetoTail}. Computed at each call.
     *
     * @return k of the heavier tail; NaN where the diagnostics do not exist
     */
    public double paretoK() {
        double tail = essTail();
        return status == Status.OK && tail > 0
                ? ParetoTail.k(sorted, Math.min(1, tail / sorted.length)) : Double.NaN;
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
        for (int c = 0; c < chains.length; c++) {
            if (chains[c].length != chains[0].length) {
                throw new IllegalArgumentException("chains must have the same number of draws: chain 0 has "
                        + chains[0].length + ", chain " + c + " has " + chains[c].length);
            }
        }
        return of(joined(chains), chains.length, new DrawsWork.Pool());
    }

    /**
     * Diagnoses one parameter of many.
     *
     * @param draws of all chains, one chain after the other, equally many of each; taken over
     * @param chains how many, at least 1
     * @param works work space that all of them share
     * @return the diagnostics
     */
    public static ChainDiagnostics of(double[] draws, int chains, DrawsWork.Pool works) {
        DrawsWork work = works.take();
        try {
            return new ChainDiagnostics(draws, chains, works, work);
        } finally {
            works.giveBack(work);
        }
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
        return chainCount;
    }

    /**
     * Number of draws per chain.
     *
     * @return the count
     */
    public int drawsPerChain() {
        return drawsPerChain;
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
        return Math.min(essLowTail, essHighTail);
    }

    /**
     * Effective sample size for the mean, from the draws as they are. Computed at each call: few ask.
     *
     * @return the size in draws; NaN where it does not exist
     */
    public double essMean() {
        return sizeBy(work -> effectiveSize(deviations(work)));
    }

    /**
     * Effective sample size for the standard deviation, from the absolute deviations from the mean. Computed at each
     * call: few ask.
     *
     * @return the size in draws; NaN where it does not exist
     */
    public double essSd() {
        return sizeBy(work -> {
            double[] absolute = deviations(work);
            for (int i = 0; i < absolute.length; i++) {
                absolute[i] = Math.abs(absolute[i]);
            }
            return effectiveSize(absolute);
        });
    }

    private double sizeBy(ToDoubleFunction<DrawsWork> computed) {
        if (status != Status.OK) {
            return Double.NaN;
        }
        DrawsWork work = works.take();
        try {
            return computed.applyAsDouble(work);
        } finally {
            works.giveBack(work);
        }
    }

    private double[] deviations(DrawsWork work) {
        double[] halves = halves(work);
        double scale = scale();
        for (int i = 0; i < halves.length; i++) {
            halves[i] = (halves[i] - mean) / scale;
        }
        return halves;
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
        // the tails' are known, and asked for again by every result
        return probability == LOW_TAIL ? essLowTail : probability == HIGH_TAIL ? essHighTail
                : sizeBy(work -> essBelow(probability, work));
    }

    /**
     * Monte Carlo standard error of the mean. Computed at each call.
     *
     * @return the error, in the unit of the draws; NaN where it does not exist
     */
    public double mcseMean() {
        return std / Math.sqrt(essMean());
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
        int total = sorted.length;
        BetaRank ranks = new BetaRank(size * probability + 1, size * (1 - probability) + 1, total);
        // Normal probabilities of one standard deviation to either side, as rounded by V and its implementations
        int low = ranks.floor(0.1586553, -1);
        int high = ranks.floor(0.8413447, 1) + 1;
        double lowValue = sorted[Math.max(low, 1) - 1];
        double highValue = sorted[Math.min(high, total) - 1];
        return (highValue - lowValue) / 2;
    }

    /**
     * The verdict on this parameter.
     *
     * @return the verdict; {@link Convergence#NOT_CONVERGED} without {@link Status#OK}
     */
    public Convergence convergence() {
        return Convergence.of(rHat(), essBulk, essTail());
    }

    private static Status statusOf(double[] draws, int chains) {
        int each = draws.length / chains;
        boolean constant = false;
        for (int c = 0; c < chains; c++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = c * each; i < (c + 1) * each; i++) {
                if (!Double.isFinite(draws[i])) {
                    return Status.NON_FINITE;
                }
                low = Math.min(low, draws[i]);
                high = Math.max(high, draws[i]);
            }
            // Compared as numbers, so that a chain of 0.0 and -0.0 counts as constant
            constant |= low == high;
        }
        if (each < MIN_DRAWS) {
            return Status.TOO_SHORT;
        }
        return constant ? Status.CONSTANT : Status.OK;
    }

    private static void requireProbability(double probability) {
        if (!(probability > 0 && probability < 1)) {
            throw new IllegalArgumentException("probability must lie in (0, 1), was " + probability);
        }
    }

    private static double[] joined(double[][] chains) {
        int n = chains[0].length;
        double[] all = new double[chains.length * n];
        for (int c = 0; c < chains.length; c++) {
            System.arraycopy(chains[c], 0, all, c * n, n);
        }
        return all;
    }

    /** Draws per half chain. */
    private int half() {
        return drawsPerChain / 2;
    }

    /** All halves one after the other, to be changed: all draws but those in the middle of odd chains. */
    private double[] halves(DrawsWork work) {
        double[] halves = work.values(2 * half() * chainCount);
        if (drawsPerChain % 2 == 0) {
            System.arraycopy(draws, 0, halves, 0, draws.length);
            return halves;
        }
        for (int c = 0; c < chainCount; c++) {
            System.arraycopy(draws, c * drawsPerChain, halves, 2 * c * half(), half());
            System.arraycopy(draws, c * drawsPerChain + half() + 1, halves, (2 * c + 1) * half(), half());
        }
        return halves;
    }

    /** Where the draws of all halves stand in {@link #halves}, ascending, from where they stand among all draws. */
    private int[] orderOfHalves(int[] order) {
        if (drawsPerChain % 2 == 0) {
            return order;
        }
        int[] out = new int[2 * half() * chainCount];
        int size = 0;
        for (int at : order) {
            int chain = at / drawsPerChain;
            int draw = at % drawsPerChain;
            if (draw != half()) {
                // every chain before this one lacks its middle draw, as does this one where the draw comes later
                out[size++] = at - chain - (draw > half() ? 1 : 0);
            }
        }
        return out;
    }

    /**
     * Fills in the distances from the median, ascending, and where they stand. Those above it are sorted as they are,
     * those below it the other way round, so that merging is enough.
     */
    private static void fold(double[] ascending, int[] order, double median, DrawsWork work) {
        int n = ascending.length;
        double[] distances = work.distances(n);
        int[] ofDistances = work.ofDistances(n);
        int above = 0;
        while (above < n && ascending[above] < median) {
            above++;
        }
        int below = above - 1;
        for (int i = 0; i < n; i++) {
            boolean fromAbove = below < 0
                    || above < n && ascending[above] - median <= median - ascending[below];
            int from = fromAbove ? above++ : below--;
            distances[i] = Math.abs(ascending[from] - median);
            ofDistances[i] = order[from];
        }
    }

    /** V section 3.1, over halves one after the other. NaN if no half moves and all stand at the same place. */
    private double rHat(double[] halves) {
        int n = half();
        double[] means = new double[2 * chainCount];
        double within = 0;
        for (int h = 0; h < means.length; h++) {
            means[h] = Sums.mean(halves, h * n, (h + 1) * n);
            within += Sums.variance(halves, h * n, (h + 1) * n);
        }
        within /= means.length;
        double betweenOverN = Sums.variance(means, 0, means.length);
        return Math.sqrt((n - 1.0) / n + betweenOverN / within);
    }

    private double essBelow(double probability, DrawsWork work) {
        double quantile = Quantiles.ofSorted(sorted, probability);
        double[] indicator = halves(work);
        for (int i = 0; i < indicator.length; i++) {
            indicator[i] = indicator[i] <= quantile ? 1 : 0;
        }
        return effectiveSize(indicator);
    }

    /** V section 3.2, over halves one after the other, which are changed. */
    private double effectiveSize(double[] halves) {
        int n = half();
        if (n < MIN_DRAWS_FOR_ESS / 2) {
            return Double.NaN;
        }
        Autocovariance autocovariance = new Autocovariance(halves, n);
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
        double size = 2.0 * chainCount * n;
        return size / Math.max(tau, 1 / Math.log10(size));
    }

    private static double rho(Autocovariance autocovariance, int lag, double within, double total) {
        return 1 - (within - autocovariance.at(lag)) / total;
    }
}
