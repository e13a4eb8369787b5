package org.cellgauge.live;

import io.reactivex.rxjava3.core.Scheduler;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;

/** Hands values of any thread to a worker, and where it is slow only the newest. */
final class Latest<T> {
    private final Scheduler.Worker worker;
    private final Consumer<T> consumer;
    private final AtomicReference<T> newest = new AtomicReference<>();

    /**
     * A hand-over.
     *
     * @param worker where the consumer runs
     * @param consumer takes the values, one at a time
     */
    Latest(Scheduler.Worker worker, Consumer<T> consumer) {
        this.worker = worker;
        this.consumer = consumer;
    }

    /** Leaves a value; one that waits is replaced by it. */
    void offer(T value) {
        if (newest.getAndSet(value) == null) {
            worker.schedule(() -> consumer.accept(newest.getAndSet(null)));
        }
    }
}
