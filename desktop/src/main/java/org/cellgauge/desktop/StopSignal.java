package org.cellgauge.desktop;

import io.reactivex.rxjava3.core.Flowable;
import io.reactivex.rxjava3.subjects.CompletableSubject;

/** Ends a batch early: what is being checked is given up, what is done is written. May be given from any thread. */
public final class StopSignal {
    private final CompletableSubject given = CompletableSubject.create();

    /** Gives the signal; again it means nothing. */
    public void stop() {
        given.onComplete();
    }

    /**
     * Whether it was given.
     *
     * @return for good, once it was
     */
    public boolean isGiven() {
        return given.hasComplete();
    }

    /** Ends when it is given. */
    Flowable<Object> end() {
        return given.toFlowable();
    }
}
