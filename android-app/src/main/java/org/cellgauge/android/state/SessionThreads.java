package org.cellgauge.android.state;

import io.reactivex.rxjava3.core.Flowable;
import io.reactivex.rxjava3.core.Scheduler;
import io.reactivex.rxjava3.schedulers.Schedulers;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.CheckSettings;
import org.cellgauge.live.LiveCheck;
import org.cellgauge.live.LivePace;
import org.cellgauge.live.LiveState;
import org.cellgauge.vision.Detections;

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
     * @param watch clock of the check, and where frames are looked at; null: a thread of its own
     * @param chains where chains are led; null with {@code watch}
     */
    public SessionThreads(Scheduler states, Scheduler files, Scheduler watch, Scheduler chains) {
        this(states, files, watch, chains, new ExecutorService[0]);
    }

    private SessionThreads(Scheduler states, Scheduler files, Scheduler watch, Scheduler chains,
            ExecutorService[] own) {
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
        return new SessionThreads(Schedulers.from(states), Schedulers.from(files), null, null,
                new ExecutorService[] {states, files});
    }

    Scheduler states() {
        return states;
    }

    Scheduler files() {
        return files;
    }

    /** A live check on these threads. */
    Flowable<LiveState> check(Flowable<Detections> frames, Cell cell, CheckSettings settings, Flowable<LivePace> pace) {
        return watch == null ? LiveCheck.states(frames, cell, settings, pace)
                : LiveCheck.states(frames, cell, settings, pace, watch, chains);
    }

    /** Ends the threads that belong to the session alone, once they have done what they are at. */
    void close() {
        for (ExecutorService service : own) {
            service.shutdown();
        }
    }
}
