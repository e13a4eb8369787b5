package org.cellgauge.internal.plan;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * Which few of many candidates to take so that a design is best: candidates each add information to every view, and
 * exclude each other where they stand in each other's way.
 *
 * <p>Greedy choice, then exchanges of one for another until none is better (Fedorov, "Theory of Optimal
 * Experiments", 1972; Cook and Nachtsheim, "A comparison of algorithms for constructing exact D-optimal designs",
 * 1980). A lower bound on what any such set can reach comes from its convex relaxation: each candidate is taken with
 * a weight of 0 to 1 ({@link #bound}). Same candidates, same result; not thread-safe.
 */
public final class SubsetSearch {
    /** May two candidates stand at the same time? */
    public interface Compatibility {
        /**
         * Whether both may be taken.
         *
         * @param a a candidate
         * @param b another
         * @return false where they stand in each other's way
         */
        boolean both(int a, int b);
    }

    /**
     * A choice.
     *
     * @param members indices of candidates, rising, unmodifiable
     * @param worst what it reaches
     */
    public record Choice(List<Integer> members, double worst) {
    }

    private static final int ROUNDS = 50;
    /** Candidates to begin with: those that are best alone. */
    private static final int STARTS = 8;
    /** Above so many sets only exchanges are tried. */
    private static final long EXHAUSTIVE = 20_000;
    private static final double BETTER = 1 - 1e-9;
    private static final double[] SHARPNESS = {10, 30, 100, 300, 1000};

    private final List<Design> views;
    private final double[][] base;
    private final double[][][] candidates;
    private final Compatibility compatible;
    private final double[][] sums;

    /**
     * A search.
     *
     * @param views what is asked for, view by view
     * @param base information without candidates, by view
     * @param candidates information of each candidate, by view
     * @param compatible which may stand together
     */
    public SubsetSearch(List<Design> views, double[][] base, double[][][] candidates, Compatibility compatible) {
        this.views = views;
        this.base = base;
        this.candidates = candidates;
        this.compatible = compatible;
        sums = new double[views.size()][];
        for (int v = 0; v < sums.length; v++) {
            sums[v] = new double[base[v].length];
        }
    }

    /**
     * What a set reaches. Allocates nothing.
     *
     * @param members indices of candidates
     * @param count so many of them
     * @return the largest variance over all views
     */
    public double worst(int[] members, int count) {
        double worst = 0;
        for (int v = 0; v < sums.length; v++) {
            double[] sum = sums[v];
            System.arraycopy(base[v], 0, sum, 0, sum.length);
            for (int i = 0; i < count; i++) {
                double[] added = candidates[members[i]][v];
                for (int e = 0; e < sum.length; e++) {
                    sum[e] += added[e];
                }
            }
            worst = Math.max(worst, views.get(v).worst(sum));
        }
        return worst;
    }

    /**
     * The best set that greedy choice and exchanges find, begun with each of some candidates.
     *
     * @param size how many, at least 1
     * @return the choice; null where no so many fit together
     */
    public @Nullable Choice best(int size) {
        Choice best = null;
        for (int first : firsts(size == 1 ? 1 : STARTS)) {
            Choice found = from(first, size);
            if (found != null && (best == null || found.worst() < best.worst() * BETTER)) {
                best = found;
            }
        }
        return best;
    }

    /** Candidates that are best alone, best first. */
    private int[] firsts(int most) {
        Integer[] order = new Integer[candidates.length];
        double[] alone = new double[candidates.length];
        int[] member = new int[1];
        for (int c = 0; c < order.length; c++) {
            order[c] = c;
            member[0] = c;
            alone[c] = worst(member, 1);
        }
        Arrays.sort(order, (a, b) -> Double.compare(alone[a], alone[b]));
        return Arrays.stream(order).limit(most).mapToInt(c -> c).toArray();
    }

    private @Nullable Choice from(int first, int size) {
        int[] members = new int[size];
        members[0] = first;
        for (int count = 1; count < size; count++) {
            if (!fill(members, count, count)) {
                return null;
            }
        }
        double now = worst(members, size);
        for (int round = 0; round < ROUNDS; round++) {
            double before = now;
            for (int slot = 0; slot < size; slot++) {
                now = exchanged(members, size, slot, now);
            }
            if (!(now < before * BETTER)) {
                break;
            }
        }
        return choice(members, now);
    }

    private static Choice choice(int[] members, double worst) {
        return new Choice(Arrays.stream(members).sorted().boxed().collect(Collectors.toList()), worst);
    }

    /** Puts into a slot what is best beside the first so many. */
    private boolean fill(int[] members, int slot, int count) {
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int c = 0; c < candidates.length; c++) {
            if (fits(c, members, count, slot)) {
                members[slot] = c;
                double reached = worst(members, count + 1);
                if (best < 0 || reached < least) {
                    least = reached;
                    best = c;
                }
            }
        }
        if (best >= 0) {
            members[slot] = best;
        }
        return best >= 0;
    }

    private double exchanged(int[] members, int size, int slot, double now) {
        int best = members[slot];
        double least = now;
        for (int c = 0; c < candidates.length; c++) {
            if (fits(c, members, size, slot)) {
                members[slot] = c;
                double reached = worst(members, size);
                if (reached < least * BETTER) {
                    least = reached;
                    best = c;
                }
            }
        }
        members[slot] = best;
        return least;
    }

    private boolean fits(int c, int[] members, int count, int except) {
        for (int i = 0; i < count; i++) {
            if (i != except && (members[i] == c || !compatible.both(members[i], c))) {
                return false;
            }
        }
        return true;
    }

    /**
     * The best set of all, by trying every one.
     *
     * @param size how many
     * @return the choice; null where no so many fit together, or there are too many to try
     */
    public @Nullable Choice exhaustive(int size) {
        double sets = 1;
        for (int i = 0; i < size; i++) {
            sets *= (candidates.length - i) / (double) (i + 1);
        }
        if (sets > EXHAUSTIVE) {
            return null;
        }
        int[] members = new int[size];
        int[] best = new int[size];
        double least = tried(members, 0, 0, best, Double.POSITIVE_INFINITY);
        return least < Double.POSITIVE_INFINITY ? choice(best, least) : null;
    }

    private double tried(int[] members, int count, int from, int[] best, double least) {
        if (count == members.length) {
            double reached = worst(members, count);
            if (reached < least) {
                System.arraycopy(members, 0, best, 0, count);
                return reached;
            }
            return least;
        }
        double most = least;
        for (int c = from; c < candidates.length; c++) {
            if (fits(c, members, count, count)) {
                members[count] = c;
                most = tried(members, count + 1, c + 1, best, most);
            }
        }
        return most;
    }

    /**
     * What no set of some candidates can be better than, whichever of them are compatible: weights w_j of 0 to 1 that
     * add to its size take the place of yes and no. With multipliers lambda_a of the functions, the tangent of the
     * convex {@code sum_a lambda_a f_a} at any w lies below it, and its least value over all weights, taken by the size
     * largest slopes, is a bound. Weights are improved by steps towards these (Frank and Wolfe, "An algorithm for
     * quadratic programming", 1956; Jaggi 2013), with lambda a soft maximum that sharpens.
     *
     * @param size how many, at least 1
     * @param steps so many steps: more of them, a closer bound
     * @return a lower bound of {@link Choice#worst()}; 0 where nothing can be said
     */
    public double bound(int size, int steps) {
        int count = candidates.length;
        double[] weights = new double[count];
        Arrays.fill(weights, Math.min(1, (double) size / count));
        double[][] at = new double[views.size()][];
        double[][] variances = new double[views.size()][];
        double[][][] solutions = new double[views.size()][][];
        for (int v = 0; v < at.length; v++) {
            at[v] = new double[base[v].length];
            variances[v] = new double[views.get(v).functions()];
            solutions[v] = new double[views.get(v).end(variances[v].length - 1)][views.get(v).unknowns()];
        }
        double[] slopes = new double[count];
        double best = 0;
        for (int step = 0; step < steps; step++) {
            double sharpness = SHARPNESS[Math.min(SHARPNESS.length - 1, step * SHARPNESS.length / steps)];
            double value = tangent(weights, at, variances, solutions, sharpness, slopes);
            if (Double.isNaN(value)) {
                return best;
            }
            boolean[] chosen = smallest(slopes, size);
            double low = value;
            for (int c = 0; c < count; c++) {
                low += slopes[c] * ((chosen[c] ? 1 : 0) - weights[c]);
            }
            best = Math.max(best, low);
            move(weights, chosen, at, 2.0 / (step % (steps / SHARPNESS.length + 1) + 3));
        }
        return best;
    }

    /** Value of the weighted functions at some weights, and their slopes; NaN where the information is singular. */
    private double tangent(double[] weights, double[][] at, double[][] variances, double[][][] solutions,
            double sharpness, double[] slopes) {
        double worst = 0;
        for (int v = 0; v < at.length; v++) {
            System.arraycopy(base[v], 0, at[v], 0, at[v].length);
            for (int c = 0; c < weights.length; c++) {
                if (weights[c] > 0) {
                    double[] added = candidates[c][v];
                    for (int e = 0; e < added.length; e++) {
                        at[v][e] += weights[c] * added[e];
                    }
                }
            }
            if (!views.get(v).variances(at[v], variances[v], solutions[v])) {
                return Double.NaN;
            }
            for (double variance : variances[v]) {
                worst = Math.max(worst, variance);
            }
        }
        double total = 0;
        for (double[] ofView : variances) {
            for (double variance : ofView) {
                total += Math.exp(sharpness * (variance / worst - 1));
            }
        }
        Arrays.fill(slopes, 0);
        double value = 0;
        for (int v = 0; v < at.length; v++) {
            int n = views.get(v).unknowns();
            double[] outer = new double[n * n];
            for (int a = 0; a < variances[v].length; a++) {
                double lambda = Math.exp(sharpness * (variances[v][a] / worst - 1)) / total;
                value += lambda * variances[v][a];
                for (int row = views.get(v).end(a - 1); row < views.get(v).end(a); row++) {
                    double[] x = solutions[v][row];
                    for (int i = 0; i < n; i++) {
                        for (int j = 0; j < n; j++) {
                            outer[i * n + j] += lambda * x[i] * x[j];
                        }
                    }
                }
            }
            for (int c = 0; c < slopes.length; c++) {
                double[] added = candidates[c][v];
                double sum = 0;
                for (int e = 0; e < added.length; e++) {
                    sum += added[e] * outer[e];
                }
                slopes[c] -= sum;
            }
        }
        return value;
    }

    private static boolean[] smallest(double[] slopes, int size) {
        boolean[] chosen = new boolean[slopes.length];
        for (int k = 0; k < Math.min(size, slopes.length); k++) {
            int best = -1;
            for (int c = 0; c < slopes.length; c++) {
                if (!chosen[c] && (best < 0 || slopes[c] < slopes[best])) {
                    best = c;
                }
            }
            chosen[best] = true;
        }
        return chosen;
    }

    private void move(double[] weights, boolean[] chosen, double[][] scratch, double share) {
        double best = Double.POSITIVE_INFINITY;
        double step = share;
        for (double tried = share; tried > share / 64; tried /= 2) {
            double reached = reached(weights, chosen, tried, scratch);
            if (reached < best) {
                best = reached;
                step = tried;
            }
        }
        for (int c = 0; c < weights.length; c++) {
            weights[c] += step * ((chosen[c] ? 1 : 0) - weights[c]);
        }
    }

    private double reached(double[] weights, boolean[] chosen, double step, double[][] scratch) {
        double worst = 0;
        for (int v = 0; v < scratch.length; v++) {
            double[] sum = scratch[v];
            System.arraycopy(base[v], 0, sum, 0, sum.length);
            for (int c = 0; c < weights.length; c++) {
                double weight = weights[c] + step * ((chosen[c] ? 1 : 0) - weights[c]);
                double[] added = candidates[c][v];
                for (int e = 0; e < sum.length; e++) {
                    sum[e] += weight * added[e];
                }
            }
            worst = Math.max(worst, views.get(v).worst(sum));
        }
        return worst;
    }
}
