package org.cellgauge.internal.survey;

import java.util.Arrays;
import org.cellgauge.internal.sampling.OwnThreads;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.statistics.ChainDiagnostics;
import org.cellgauge.statistics.Convergence;

/**
 * Draws of what all photos of a survey share, as steps off its mode, from several chains; and whether they suffice.
 */
final class SurveyDraws {
    private static final long STREAM = 11;

    private final int chains;
    private final int[] quantities;
    /** By chain, then quantity, then draw. */
    private double[][][] values;
    private int draws;
    private long evaluations;
    private long accepted;
    private Convergence convergence = Convergence.NOT_CONVERGED;
    private double worstRHat = Double.NaN;
    private double leastBulk = Double.NaN;
    private double leastTail = Double.NaN;

    private SurveyDraws(int chains, int[] quantities) {
        this.chains = chains;
        this.quantities = quantities;
        values = new double[chains][quantities.length][0];
    }

    /**
     * Draws until they suffice.
     *
     * @param quantities which of the shared unknowns are looked at
     * @param chains number of chains
     * @param atLeast draws of a chain before convergence is looked at
     * @param atMost draws of a chain at most
     */
    static SurveyDraws of(SurveyFit fit, int[] quantities, int chains, long seed, int threads, int atLeast,
            int atMost) {
        SurveyDraws out = new SurveyDraws(chains, quantities);
        SurveyChain[] running = new SurveyChain[chains];
        OwnThreads.forEach(chains, threads, c -> {
            running[c] = new SurveyChain(fit, fit.model.another(), RandomStreams.of(seed, STREAM, c));
            running[c].tune();
        });
        // one size of steps for all: that most of them found
        double[] found = new double[chains];
        for (int c = 0; c < chains; c++) {
            found[c] = running[c].persistence();
        }
        Arrays.sort(found);
        for (SurveyChain chain : running) {
            chain.stepAs(found[chains / 2]);
        }
        int target = Math.min(atLeast, atMost);
        while (true) {
            out.extend(running, target, threads);
            out.diagnose();
            if (out.convergence == Convergence.CONVERGED || target >= atMost) {
                break;
            }
            target = (int) Math.min(atMost, 2L * target);
        }
        for (SurveyChain chain : running) {
            out.evaluations += chain.evaluations();
            out.accepted += chain.accepted();
        }
        return out;
    }

    private void extend(SurveyChain[] running, int target, int threads) {
        int from = draws;
        OwnThreads.forEach(chains, threads, c -> {
            for (int q = 0; q < quantities.length; q++) {
                values[c][q] = Arrays.copyOf(values[c][q], target);
            }
            for (int i = from; i < target; i++) {
                running[c].advance();
                for (int q = 0; q < quantities.length; q++) {
                    values[c][q][i] = running[c].offMode()[quantities[q]];
                }
            }
        });
        draws = target;
    }

    private void diagnose() {
        convergence = Convergence.CONVERGED;
        worstRHat = 0;
        leastBulk = Double.POSITIVE_INFINITY;
        leastTail = Double.POSITIVE_INFINITY;
        for (int q = 0; q < quantities.length; q++) {
            double[][] of = new double[chains][];
            for (int c = 0; c < chains; c++) {
                of[c] = values[c][q];
            }
            ChainDiagnostics d = ChainDiagnostics.of(of);
            if (d.status() != ChainDiagnostics.Status.OK) {
                convergence = Convergence.NOT_CONVERGED;
                continue;
            }
            convergence = convergence.worse(d.convergence());
            worstRHat = Math.max(worstRHat, d.rHat());
            leastBulk = Math.min(leastBulk, d.essBulk());
            leastTail = Math.min(leastTail, d.essTail());
        }
    }

    /** Mean of the steps off the mode. */
    double[] mean() {
        double[] mean = new double[quantities.length];
        for (int q = 0; q < mean.length; q++) {
            for (int c = 0; c < chains; c++) {
                mean[q] += Arrays.stream(values[c][q]).sum() / ((double) draws * chains);
            }
        }
        return mean;
    }

    /** Covariance of all of them, row by row. */
    double[] covariance() {
        int n = quantities.length;
        double[] mean = mean();
        double[] out = new double[n * n];
        for (int a = 0; a < n; a++) {
            for (int b = 0; b <= a; b++) {
                double sum = 0;
                for (int c = 0; c < chains; c++) {
                    double[] x = values[c][a];
                    double[] y = values[c][b];
                    for (int i = 0; i < draws; i++) {
                        sum += (x[i] - mean[a]) * (y[i] - mean[b]);
                    }
                }
                out[a * n + b] = sum / ((double) draws * chains - 1);
                out[b * n + a] = out[a * n + b];
            }
        }
        return out;
    }

    double worstRHat() {
        return worstRHat;
    }

    double leastBulk() {
        return leastBulk;
    }

    double leastTail() {
        return leastTail;
    }

    int chains() {
        return chains;
    }

    /** One draw of one of the first shared unknowns, off the mode. */
    double value(int chain, int quantity, int draw) {
        return values[chain][quantity][draw];
    }

    Convergence convergence() {
        return convergence;
    }

    int draws() {
        return draws;
    }

    long evaluations() {
        return evaluations;
    }

    double acceptance() {
        return (double) accepted / evaluations;
    }
}
