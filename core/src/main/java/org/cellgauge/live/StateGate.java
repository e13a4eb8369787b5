package org.cellgauge.live;

import io.reactivex.rxjava3.core.Scheduler;
import io.reactivex.rxjava3.disposables.Disposable;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** Lets states out at a bounded rate, the urgent ones at once, and never holds back the last one. For one worker. */
final class StateGate {
    private final Scheduler.Worker worker;
    private final Consumer<LiveState> out;
    private long intervalMs;
    private boolean opened;
    private long lastMs;
    private @Nullable LiveState held;
    private Disposable timer = Disposable.disposed();

    StateGate(Scheduler.Worker worker, Consumer<LiveState> out) {
        this.worker = worker;
        this.out = out;
    }

    /** Changes the shortest time between states that are not urgent. */
    void setIntervalMs(long intervalMs) {
        this.intervalMs = intervalMs;
        if (held != null) {
            offer(held, false);
        }
    }

    /** Lets a state out now or, where it is not urgent and comes too early, later, unless a newer one replaces it. */
    void offer(LiveState state, boolean urgent) {
        long waitMs = urgent || !opened ? 0 : waitMs();
        held = state;
        timer.dispose();
        if (waitMs == 0) {
            flush();
        } else {
            timer = worker.schedule(this::flush, waitMs, TimeUnit.MILLISECONDS);
        }
    }

    private long waitMs() {
        long sinceMs = worker.now(TimeUnit.MILLISECONDS) - lastMs;
        // a clock that was set back says nothing
        return sinceMs < 0 ? 0 : Math.max(0, intervalMs - sinceMs);
    }

    /** Lets out what is held back. */
    void flush() {
        timer.dispose();
        if (held != null) {
            LiveState state = held;
            held = null;
            opened = true;
            lastMs = worker.now(TimeUnit.MILLISECONDS);
            out.accept(state);
        }
    }
}
