package org.cellgauge.internal.sampling;

import org.apache.commons.math3.random.RandomGenerator;

/** A symmetric step: independent Gaussians on some coordinates, the others held (Metropolis et al. 1953). */
public final class GaussianStep implements Proposal {
    private final String name;
    private final int first;
    private final int count;
    private final double std;
    private final double period;

    /**
     * A step.
     *
     * @param name name for the acceptance count
     * @param first first coordinate that moves
     * @param count number of coordinates that move
     * @param std standard deviation of the step, in their unit
     * @param period coordinates are wrapped to [0, period), for angles 2 pi; 0 for none
     */
    public GaussianStep(String name, int first, int count, double std, double period) {
        this.name = name;
        this.first = first;
        this.count = count;
        this.std = std;
        this.period = period;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public double propose(double[] from, double[] to, RandomGenerator random) {
        System.arraycopy(from, 0, to, 0, from.length);
        for (int i = first; i < first + count; i++) {
            double moved = from[i] + std * random.nextGaussian();
            if (period > 0) {
                moved -= period * Math.floor(moved / period);
                // a tiny negative value plus the period rounds to the period itself
                moved = moved < period ? moved : 0;
            }
            to[i] = moved;
        }
        return 0;
    }
}
