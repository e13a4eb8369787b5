package org.cellgauge.android.state;

import io.reactivex.rxjava3.core.Flowable;
import io.reactivex.rxjava3.core.Scheduler;
import org.cellgauge.cell.Cell;
import org.cellgauge.internal.live.IdleThreads;
import org.cellgauge.live.LiveCheck;
import org.cellgauge.live.LivePace;
import org.cellgauge.live.LiveState;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;

/** Where a session works; immutable. */
public final class SessionThreads {
    private final Scheduler states;
    private final Scheduler files;
    private final Scheduler watch;
    private final Scheduler chains;

    /**
     * Threads.
     *
     * @param states where states are made; one at a time
     * @param files where files are read and written and photos are searched for markers; one at a time
     * @param watch clock of the check, and where frames are looked at; null: a thread of its own
     * @param chains where chains are led; null with {@code watch}
     */
    public SessionThreads(Scheduler states, Scheduler files, Scheduler watch, Scheduler chains) {
        this.states = states;
        this.files = files;
        this.watch = watch;
        this.chains = chains;
    }

    /**
     * Threads of the app.
     *
     * @return a new set; its threads end when there is nothing left to do
     */
    public static SessionThreads ofApp() {
        return new SessionThreads(IdleThreads.one("states"), IdleThreads.one("files"), null, null);
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
}
