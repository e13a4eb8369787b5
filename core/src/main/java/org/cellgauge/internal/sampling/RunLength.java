package org.cellgauge.internal.sampling;

/** How long an ensemble runs; immutable. */
public final class RunLength {
    private final int warmup;
    private final int firstRound;
    private final int iterations;

    /**
     * A run length.
     *
     * @param warmup iterations of each chain that are not kept, at least 0
     * @param firstRound iterations of the first round after the warm-up, at least 1; later rounds double the total
     * @param iterations largest number of iterations of each chain, warm-up included; more than the warm-up
     * @throws IllegalArgumentException if a number is out of range
     */
    public RunLength(int warmup, int firstRound, int iterations) {
        if (warmup < 0 || firstRound < 1 || iterations <= warmup) {
            throw new IllegalArgumentException("iterations (" + iterations + ") must exceed the warm-up (" + warmup
                    + ")");
        }
        this.warmup = warmup;
        this.firstRound = firstRound;
        this.iterations = iterations;
    }

    /**
     * Iterations of each chain that are not kept.
     *
     * @return at least 0
     */
    public int warmup() {
        return warmup;
    }

    /**
     * Largest number of iterations of each chain, warm-up included.
     *
     * @return more than the warm-up
     */
    public int iterations() {
        return iterations;
    }

    int firstRound() {
        return firstRound;
    }
}
