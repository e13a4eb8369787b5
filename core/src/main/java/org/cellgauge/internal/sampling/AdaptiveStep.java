package org.cellgauge.internal.sampling;

import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.statistics.RunningMoments;

/**
 * Adaptive Metropolis: Gaussian steps with 2.38²/n times the covariance of the draws so far (Haario, Saksman, Tamminen,
 * "An adaptive Metropolis algorithm", Bernoulli 2001; the factor of Gelman, Roberts and Gilks 1996). One step in twenty
 * is a hundredth as long in variance, so that a covariance learnt too wide cannot freeze the chain.
 *
 * <p>It learns during the warm-up alone. Afterwards the step is fixed and the chain is an ordinary Metropolis chain.
 */
public final class AdaptiveStep implements Proposal {
    private static final double SHORT_STEP_SHARE = 0.05;
    private static final double SHORT_STEP_FACTOR = 0.1;
    private static final int REFACTOR_EVERY = 100;
    private static final int FORGET_FIRST = 2000;

    private final int dimension;
    private final double[] factor;
    private final double[] trial;
    private final double[] gaussians;
    private final RunningMoments moments;
    private long taken;
    private boolean learning = true;

    /**
     * A step.
     *
     * @param covariance first guess of the target's covariance, n x n row by row, positive definite; copied
     * @param dimension n
     * @throws IllegalArgumentException if the guess is not positive definite
     */
    public AdaptiveStep(double[] covariance, int dimension) {
        this.dimension = dimension;
        factor = covariance.clone();
        if (!Cholesky.factor(factor, dimension)) {
            throw new IllegalArgumentException("covariance is not positive definite");
        }
        trial = new double[dimension * dimension];
        gaussians = new double[dimension];
        moments = new RunningMoments(dimension);
    }

    @Override
    public String name() {
        return "adaptive";
    }

    /** Ends the learning: from here on the step is fixed. */
    public void freeze() {
        learning = false;
    }

    /**
     * Whether it still learns.
     *
     * @return false after {@link #freeze()}
     */
    public boolean learning() {
        return learning;
    }

    @Override
    public double propose(double[] from, double[] to, RandomGenerator random) {
        if (learning) {
            learn(from);
        }
        double scale = 2.38 / Math.sqrt(dimension);
        if (random.nextDouble() < SHORT_STEP_SHARE) {
            scale *= SHORT_STEP_FACTOR;
        }
        for (int i = 0; i < dimension; i++) {
            gaussians[i] = random.nextGaussian();
        }
        for (int i = 0; i < dimension; i++) {
            double s = 0;
            for (int k = 0; k <= i; k++) {
                s += factor[i * dimension + k] * gaussians[k];
            }
            to[i] = from[i] + scale * s;
        }
        return 0;
    }

    private void learn(double[] x) {
        moments.add(x);
        taken++;
        // a short stretch of a chain shows less than its target's spread: wait for a quarter of the way again
        if (taken % REFACTOR_EVERY == 0 && moments.count() >= Math.max(20L * dimension, taken / 4)) {
            for (int i = 0; i < dimension; i++) {
                for (int j = 0; j <= i; j++) {
                    trial[i * dimension + j] = moments.covariance(i, j);
                }
            }
            // a chain that has hardly moved has no covariance to learn from yet
            if (Cholesky.factor(trial, dimension)) {
                System.arraycopy(trial, 0, factor, 0, trial.length);
            }
        }
        if (taken % FORGET_FIRST == 0 && Long.bitCount(taken / FORGET_FIRST) == 1) {
            // early draws come from before the chain has found the bulk: forget them at 2000, 4000, 8000, …
            moments.clear();
        }
    }
}
