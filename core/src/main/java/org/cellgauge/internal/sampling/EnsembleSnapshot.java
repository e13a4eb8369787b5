package org.cellgauge.internal.sampling;

import java.util.Collections;
import java.util.List;
import org.cellgauge.sampling.AcceptanceCount;

/**
 * Where an ensemble stands after a round: running statistics over all chains and acceptance; immutable once published.
 */
public final class EnsembleSnapshot {
    private final int iterationsPerChain;
    private final RunningSummary summary;
    private final List<AcceptanceCount> acceptance;
    private final boolean last;

    EnsembleSnapshot(int iterationsPerChain, RunningSummary summary, List<AcceptanceCount> acceptance, boolean last) {
        this.iterationsPerChain = iterationsPerChain;
        this.summary = summary;
        this.acceptance = Collections.unmodifiableList(acceptance);
        this.last = last;
    }

    /**
     * Iterations done by each chain, warm-up included.
     *
     * @return at least 1
     */
    public int iterationsPerChain() {
        return iterationsPerChain;
    }

    /**
     * Running statistics over the kept draws of all chains, merged in the order of the chains.
     *
     * @return not to be changed
     */
    public RunningSummary summary() {
        return summary;
    }

    /**
     * Acceptance per named proposal over all chains, warm-up included.
     *
     * @return unmodifiable
     */
    public List<AcceptanceCount> acceptance() {
        return acceptance;
    }

    /**
     * Whether the ensemble has finished.
     *
     * @return true for the last snapshot of a run that was not cancelled
     */
    public boolean last() {
        return last;
    }
}
