package org.cellgauge.live;

import java.util.Objects;

/**
 * How much work a live check may do: what a device that gets warm turns down; immutable.
 *
 * <p>Chains are never reduced below the settings' number, because convergence is judged over all of them (R-hat
 * compares chains with each other). What is stepped down are, in this order, rates, threads, and finally sampling
 * itself: without it there is a quick look and no more, and every figure stays preliminary. No figure depends on the
 * pace, only when it comes.
 */
public final class LivePace {
    /** Everything: as many threads as the settings have, at most four; all frames; five states a second. */
    public static final LivePace FULL = of(200, 0, 4, true);
    /** For a warm device: one thread, five frames and two states a second. */
    public static final LivePace REDUCED = of(500, 200, 1, true);
    /** For a hot device: no chains; two frames and two states a second. */
    public static final LivePace QUICK_LOOK_ONLY = of(500, 500, 1, false);

    private final long updateIntervalMs;
    private final long minFrameIntervalMs;
    private final int chainThreads;
    private final boolean sampling;

    private LivePace(long updateIntervalMs, long minFrameIntervalMs, int chainThreads, boolean sampling) {
        this.updateIntervalMs = updateIntervalMs;
        this.minFrameIntervalMs = minFrameIntervalMs;
        this.chainThreads = chainThreads;
        this.sampling = sampling;
    }

    /**
     * A pace.
     *
     * @param updateIntervalMs shortest time between two states that bring nothing but newer statistics or a newer
     *     frame, ms, at least 0
     * @param minFrameIntervalMs frames that come sooner than this after the last one are dropped before any work, ms,
     *     at least 0
     * @param chainThreads threads that chains step on, at least 1; more than there are chains, or than the settings
     *     have, make no difference
     * @param sampling whether chains run; false: quick looks only
     * @return the pace
     * @throws IllegalArgumentException if a value is out of range
     */
    public static LivePace of(long updateIntervalMs, long minFrameIntervalMs, int chainThreads, boolean sampling) {
        if (updateIntervalMs < 0 || minFrameIntervalMs < 0) {
            throw new IllegalArgumentException("intervals must not be negative: " + updateIntervalMs + " ms, "
                    + minFrameIntervalMs + " ms");
        }
        if (chainThreads < 1) {
            throw new IllegalArgumentException("chains need at least 1 thread, not " + chainThreads);
        }
        return new LivePace(updateIntervalMs, minFrameIntervalMs, chainThreads, sampling);
    }

    /**
     * Shortest time between two states that bring nothing but newer statistics or a newer frame. What changes the phase
     * or the key frame comes at once.
     *
     * @return ms
     */
    public long updateIntervalMs() {
        return updateIntervalMs;
    }

    /**
     * Shortest time between two frames that are looked at.
     *
     * @return ms
     */
    public long minFrameIntervalMs() {
        return minFrameIntervalMs;
    }

    /**
     * Threads that chains step on.
     *
     * @return at least 1
     */
    public int chainThreads() {
        return chainThreads;
    }

    /**
     * Whether chains run.
     *
     * @return false for quick looks only
     */
    public boolean sampling() {
        return sampling;
    }

    @Override
    public boolean equals(Object other) {
        if (!(other instanceof LivePace)) {
            return false;
        }
        LivePace o = (LivePace) other;
        return updateIntervalMs == o.updateIntervalMs && minFrameIntervalMs == o.minFrameIntervalMs
                && chainThreads == o.chainThreads && sampling == o.sampling;
    }

    @Override
    public int hashCode() {
        return Objects.hash(updateIntervalMs, minFrameIntervalMs, chainThreads, sampling);
    }

    @Override
    public String toString() {
        return "states every " + updateIntervalMs + " ms, frames every " + minFrameIntervalMs + " ms, "
                + (sampling ? chainThreads + " threads" : "no sampling");
    }
}
