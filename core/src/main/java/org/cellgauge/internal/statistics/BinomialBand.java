package org.cellgauge.internal.statistics;

import org.apache.commons.math3.distribution.BetaDistribution;
import org.apache.commons.math3.distribution.BinomialDistribution;

/**
 * The counts that n independent trials of known success probability give with a stated confidence: is a count of hits
 * of claimed coverage regions one that an honest claim would give?
 *
 * <p>Exact, from the binomial distribution: each tail outside the band holds at most half of what the confidence
 * leaves. Because counts are whole, the band usually holds more than the confidence; {@link #coverage()} says how much.
 *
 * <p>Immutable.
 */
public final class BinomialBand {
    private final int trials;
    private final double probability;
    private final double confidence;
    private final int lower;
    private final int upper;

    private BinomialBand(int trials, double probability, double confidence, int lower, int upper) {
        this.trials = trials;
        this.probability = probability;
        this.confidence = confidence;
        this.lower = lower;
        this.upper = upper;
    }

    /**
     * The band for a claimed probability.
     *
     * @param trials number of trials n, at least 1
     * @param probability of success in each, in [0, 1]
     * @param confidence that the band holds the count, in (0, 1)
     * @return the band
     * @throws IllegalArgumentException if an argument is out of range
     */
    public static BinomialBand of(int trials, double probability, double confidence) {
        requireTrials(trials);
        requireConfidence(confidence);
        if (!(probability >= 0 && probability <= 1)) {
            throw new IllegalArgumentException("probability must lie in [0, 1], was " + probability);
        }
        if (probability == 0 || probability == 1) {
            int certain = probability == 0 ? 0 : trials;
            return new BinomialBand(trials, probability, confidence, certain, certain);
        }
        double tail = (1 - confidence) / 2;
        int lower = new BinomialDistribution(null, trials, probability).inverseCumulativeProbability(tail);
        // The upper end by the count of failures: 1 - tail would lose the digits of a small tail
        int upper = trials
                - new BinomialDistribution(null, trials, 1 - probability).inverseCumulativeProbability(tail);
        return new BinomialBand(trials, probability, confidence, lower, upper);
    }

    /**
     * The exact confidence interval of an unknown success probability (Clopper &amp; Pearson 1934, "The use of
     * confidence or fiducial limits illustrated in the case of the binomial", Biometrika 26(4)): quantiles of
     * Beta(k, n - k + 1) and Beta(k + 1, n - k).
     *
     * @param successes number of successes k, in [0, n]
     * @param trials number of trials n, at least 1
     * @param confidence of the interval, in (0, 1)
     * @return lower and upper end, in [0, 1]
     * @throws IllegalArgumentException if an argument is out of range
     */
    public static double[] clopperPearson(int successes, int trials, double confidence) {
        requireTrials(trials);
        requireConfidence(confidence);
        if (successes < 0 || successes > trials) {
            throw new IllegalArgumentException("successes must lie in [0, " + trials + "], were " + successes);
        }
        double tail = (1 - confidence) / 2;
        return new double[] {lowerLimit(successes, trials, tail), 1 - lowerLimit(trials - successes, trials, tail)};
    }

    private static double lowerLimit(int successes, int trials, double tail) {
        if (successes == 0) {
            return 0;
        }
        return new BetaDistribution(null, successes, trials - successes + 1.0, 1e-13)
                .inverseCumulativeProbability(tail);
    }

    /**
     * Number of trials.
     *
     * @return the count
     */
    public int trials() {
        return trials;
    }

    /**
     * Success probability in each trial.
     *
     * @return the probability, in [0, 1]
     */
    public double probability() {
        return probability;
    }

    /**
     * Confidence that was asked for.
     *
     * @return the confidence, in (0, 1)
     */
    public double confidence() {
        return confidence;
    }

    /**
     * Smallest count in the band.
     *
     * @return the count, in [0, n]
     */
    public int lower() {
        return lower;
    }

    /**
     * Largest count in the band.
     *
     * @return the count, in [lower, n]
     */
    public int upper() {
        return upper;
    }

    /**
     * Whether a count lies in the band.
     *
     * @param count number of successes
     * @return true if it does, both ends included
     */
    public boolean contains(int count) {
        return count >= lower && count <= upper;
    }

    /**
     * Probability that the count lies in the band.
     *
     * @return the probability, at least the confidence
     */
    public double coverage() {
        BinomialDistribution counts = new BinomialDistribution(null, trials, probability);
        return counts.cumulativeProbability(upper) - counts.cumulativeProbability(lower - 1);
    }

    private static void requireTrials(int trials) {
        if (trials < 1) {
            throw new IllegalArgumentException("at least one trial is needed, got " + trials);
        }
    }

    private static void requireConfidence(double confidence) {
        if (!(confidence > 0 && confidence < 1)) {
            throw new IllegalArgumentException("confidence must lie in (0, 1), was " + confidence);
        }
    }
}
