package org.cellgauge.live;

import io.reactivex.rxjava3.core.Flowable;
import io.reactivex.rxjava3.core.Scheduler;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.CheckSettings;
import org.cellgauge.vision.Detections;

/** A check that goes on over the frames of a camera. */
public final class LiveCheck {
    private LiveCheck() {
    }

    /**
     * States of a live check.
     *
     * @param frames markers of successive frames, on any thread
     * @param cell the cell
     * @param settings how to go about it
     * @param pace how much work it may do; {@link LivePace#FULL} until the first item
     * @return states
     */
    public static Flowable<LiveState> states(Flowable<Detections> frames, Cell cell, CheckSettings settings,
            Flowable<LivePace> pace) {
        throw new UnsupportedOperationException("not written yet");
    }

    /**
     * States of a live check on given schedulers.
     *
     * @param frames markers of successive frames, on any thread
     * @param cell the cell
     * @param settings how to go about it
     * @param pace how much work it may do; {@link LivePace#FULL} until the first item
     * @param watch its clock and where frames are looked at
     * @param chains where chains are led
     * @return states
     */
    public static Flowable<LiveState> states(Flowable<Detections> frames, Cell cell, CheckSettings settings,
            Flowable<LivePace> pace, Scheduler watch, Scheduler chains) {
        throw new UnsupportedOperationException("not written yet");
    }
}
