package org.cellgauge.internal.sampling;

/**
 * How long an ensemble runs.
 *
 * @param warmup iterations of each chain that are not kept, at least 0
 * @param firstRound iterations of the first round after the warm-up, at least 1; later ones as the draws ask for
 * @param iterations largest number of iterations of each chain, warm-up included; more than the warm-up
 */
public record RunLength(int warmup, int firstRound, int iterations) {

    /**
     * A run length.
     *
     * @throws IllegalArgumentException if a number is out of range
     */
    public RunLength {
        if (warmup < 0 || firstRound < 1 || iterations <= warmup) {
            throw new IllegalArgumentException("iterations (" + iterations + ") must exceed the warm-up (" + warmup
                    + ")");
        }
    }
}
