package org.cellgauge.check;

import org.jspecify.annotations.Nullable;

/** One item of the stream of a check; immutable. */
public final class CheckUpdate {
    /** What an update brings. */
    public enum Phase {
        /** Laplace's approximation at the mode, before any chain has run. */
        QUICK_LOOK,
        /** Running statistics of the chains. */
        SAMPLING,
        /** The result; the last item. */
        RESULT
    }

    private final Phase phase;
    private final CellEstimate estimate;
    private final int iterationsPerChain;
    private final @Nullable CheckResult result;

    CheckUpdate(Phase phase, CellEstimate estimate, int iterationsPerChain, @Nullable CheckResult result) {
        this.phase = phase;
        this.estimate = estimate;
        this.iterationsPerChain = iterationsPerChain;
        this.result = result;
    }

    /**
     * What this update brings.
     *
     * @return the phase
     */
    public Phase phase() {
        return phase;
    }

    /**
     * Poses and uncertainties as known at this stage.
     *
     * @return the estimate
     */
    public CellEstimate estimate() {
        return estimate;
    }

    /**
     * Iterations each chain has run.
     *
     * @return 0 for the quick look
     */
    public int iterationsPerChain() {
        return iterationsPerChain;
    }

    /**
     * The result.
     *
     * @return null before the last update
     */
    public @Nullable CheckResult result() {
        return result;
    }
}
