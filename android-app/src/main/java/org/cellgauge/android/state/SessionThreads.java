package org.cellgauge.android.state;

import io.reactivex.rxjava3.core.Scheduler;
import io.reactivex.rxjava3.schedulers.Schedulers;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/** Where a session works; immutable. */
public final class SessionThreads {
    private final Scheduler states;
    private final Scheduler files;
    private final Scheduler watch;
    private final Scheduler chains;
    private final ExecutorService[] own;

    /**
     * Threads.
     *
     * @param states where states are made; one at a time
     * @param files where files are read and written and photos are searched for markers; one at a time
     * @param watch clock of the check, and where frames are looked at
     * @param chains where chains are led
     */
    public SessionThreads(Scheduler states, Scheduler files, Scheduler watch, Scheduler chains) {
        this(states, files, watch, chains, new ExecutorService[0]);
    }

    private SessionThreads(Scheduler states, Scheduler files, Scheduler watch, Scheduler chains, ExecutorService[] own) {
        this.states = states;
        this.files = files;
        this.watch = watch;
        this.chains = chains;
        this.own = own;
    }

    /**
     * Threads of the app.
     *
     * @return a new set, ended by {@link #close()}
     */
    public static SessionThreads ofApp() {
        ExecutorService states = Executors.newSingleThreadExecutor(r -> new Thread(r, "states"));
        ExecutorService files = Executors.newSingleThreadExecutor(r -> new Thread(r, "files"));
        return new SessionThreads(Schedulers.from(states), Schedulers.from(files), Schedulers.computation(),
                Schedulers.io(), new ExecutorService[] {states, files});
    }

    Scheduler states() {
        return states;
    }

    Scheduler files() {
        return files;
    }

    Scheduler watch() {
        return watch;
    }

    Scheduler chains() {
        return chains;
    }

    /** Ends the threads that belong to the session alone, once they have done what they are at. */
    void close() {
        for (ExecutorService service : own) {
            service.shutdown();
        }
    }
}
