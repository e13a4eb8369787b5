package org.cellgauge.internal.sampling;

import org.apache.commons.math3.random.RandomGenerator;

/** Suggests the next point of a Metropolis chain. May hold scratch arrays: one instance per chain. */
public interface Proposal {
    /**
     * Name under which accepted and rejected suggestions are counted.
     *
     * @return short, unique within a chain
     */
    String name();

    /**
     * Suggests a point. Allocates nothing.
     *
     * @param from current point; not changed
     * @param to receives the suggestion; all of its coordinates are written
     * @param random source of randomness
     * @return {@code log q(from | to) - log q(to | from)}, the Hastings correction; 0 for a symmetric proposal
     */
    double propose(double[] from, double[] to, RandomGenerator random);
}
