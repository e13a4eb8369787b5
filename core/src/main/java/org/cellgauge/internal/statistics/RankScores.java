package org.cellgauge.internal.statistics;

/**
 * Normal scores of ranks: rank r of n, counted from 1, becomes the normal quantile of (r - 3/8) / (n + 1/4) (Blom,
 * "Statistical Estimates and Transformed Beta-Variables", 1958); ties share their average rank.
 */
public final class RankScores {
    private final int total;
    /** Scores of whole ranks. */
    private final double[] byRank;

    /**
     * Scores of so many ranks.
     *
     * @param total how many numbers are ranked, at least 1
     */
    public RankScores(int total) {
        this.total = total;
        this.byRank = new double[total];
        for (int r = 1; 2 * r <= total; r++) {
            byRank[r - 1] = score(r);
            byRank[total - r] = -byRank[r - 1];
        }
    }

    /** How many numbers are ranked. */
    int total() {
        return total;
    }

    private double score(double rank) {
        return NormalQuantile.of((rank - 0.375) / (total + 0.25));
    }

    /**
     * Scores of numbers.
     *
     * @param ascending the numbers, sorted, as many as there are ranks
     * @param order where each of them stood
     * @param scores filled with the score of each where it stood
     */
    public void fill(double[] ascending, int[] order, double[] scores) {
        for (int first = 0, next; first < total; first = next) {
            next = first + 1;
            while (next < total && ascending[next] == ascending[first]) {
                next++;
            }
            if (next == first + 1) {
                scores[order[first]] = byRank[first];
                continue;
            }
            // Ranks first + 1..next are shared by all that are equal
            double score = score((first + 1 + next) / 2.0);
            for (int i = first; i < next; i++) {
                scores[order[i]] = score;
            }
        }
    }
}
