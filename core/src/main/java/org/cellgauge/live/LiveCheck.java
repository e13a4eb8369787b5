package org.cellgauge.live;

import io.reactivex.rxjava3.core.BackpressureStrategy;
import io.reactivex.rxjava3.core.Flowable;
import io.reactivex.rxjava3.core.Scheduler;
import org.cellgauge.cell.Cell;
import org.cellgauge.internal.live.IdleThreads;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;

/**
 * A check that goes on over the frames of a camera.
 *
 * <p>One frame at a time is the <em>key frame</em>. It is estimated at once: mode and Laplace's approximation. When a
 * second frame shows that the camera is held still, chains run on the key frame's corners; later frames only test
 * whether it still is. When it moves, the newest frame becomes the key frame, old chains end, and the search for the
 * mode starts at the last one. While it moves from frame to frame there are quick looks and nothing else, no more often
 * than states are shown ({@link LivePace#updateIntervalMs()}); between them the last one's figures stay.
 *
 * <p>The figures are those of the key frame alone. Corners of successive frames are not averaged: a camera held still
 * sees the same pixels again, so that most of what is wrong with a corner (how pixels fall on its edges, defocus,
 * light, placement, calibration) is wrong in the same way in the next frame, and an average would claim a precision
 * that it does not have. The result of a key frame is exactly that of {@link org.cellgauge.check.CellCheck#run} with
 * its detections and the same settings: chains are tuned and started from the frame's own initial estimate, whatever
 * came before.
 *
 * <p><em>Still</em> is a camera in whose frames the outlines of the markers lie over those of the key frame: a hand
 * moves the view as a whole, by some pixels from frame to frame, and no figure changes by that. The view may move by
 * the side of the smallest reference, at most 3 % of the picture. Besides, no marker may move: each may be 3 px in an
 * image of 1280 px width (in proportion at other sizes) from where the motion of the references puts it, never less
 * than six deviations of the difference of two noisy coordinates, and as much more as markers at another distance seem
 * to move. For chains to start, half of both. The difference keeps tremor at the limit from restarting every frame.
 * Until they start, a frame whose edges are clearly sharper than the key frame's takes its place.
 *
 * <p>A marker of the cell that the key frame lacks restarts the check once two frames in a row show it. One that is
 * missing from a frame or two changes nothing but {@link LiveState#missingIds()}; after 15 frames the check restarts
 * without it. Three frames without any reference, or one that shows motion besides, and the state is
 * {@link LiveState.Phase#SEARCHING}: it keeps nothing of the figures there were. A frame that cannot be estimated makes
 * it {@link LiveState.Phase#REFUSED}, and the next frame is tried.
 */
public final class LiveCheck {
    private LiveCheck() {
    }

    /**
     * States of a live check, on threads of its own.
     *
     * <dl>
     * <dt><b>Backpressure:</b></dt>
     * <dd>Latest value on both sides: frames and paces are requested without bound, and while one frame is worked on
     * only the newest waits; a slow subscriber misses states but always gets the newest. States that bring nothing but
     * newer statistics or a newer frame come no faster than {@link LivePace#updateIntervalMs()}; a new phase or key
     * frame comes at once.</dd>
     * <dt><b>Scheduler:</b></dt>
     * <dd>One thread of its own takes the frames, estimates key frames and emits; one more leads the chains, which step
     * on {@link LivePace#chainThreads()} others. All end soon after the subscription. Do not block in {@code onNext} of
     * the subscriber: observe on another scheduler.</dd>
     * <dt><b>Error handling:</b></dt>
     * <dd>Frames that cannot be estimated are states and no errors. An error of {@code frames} or {@code pace}, or a
     * fault of the program, ends the stream with it. When the frames end, the key frame counts as held still, its check
     * runs to its end, and the stream completes. Cancelling stops everything at once.</dd>
     * </dl>
     *
     * @param frames markers of successive frames, one at a time, on any thread; of the size of the cell's camera
     * @param cell the cell
     * @param settings how to go about it; of its threads and {@link LivePace#chainThreads()} the
     *     smaller number counts
     * @param pace how much work it may do; {@link LivePace#FULL} until its first item, its last one when it has ended
     * @return states; each subscription is a live check of its own
     */
    public static Flowable<LiveState> states(Flowable<Detections> frames, Cell cell, CheckSettings settings,
            Flowable<LivePace> pace) {
        return Flowable.defer(() -> states(frames, cell, settings, pace, IdleThreads.one("cellgauge-live"),
                IdleThreads.oneForEachWorker("cellgauge-live-chains")));
    }

    /**
     * States of a live check on given schedulers; see {@link #states(Flowable, Cell, CheckSettings, Flowable)}.
     *
     * @param frames markers of successive frames
     * @param cell the cell
     * @param settings how to go about it
     * @param pace how much work it may do
     * @param watch its clock; one worker of it takes the frames, estimates key frames and emits
     * @param chains one worker of it per key frame leads the chains and is blocked by them; it must interrupt its
     *     thread when disposed, or chains end a little later
     * @return states
     */
    public static Flowable<LiveState> states(Flowable<Detections> frames, Cell cell, CheckSettings settings,
            Flowable<LivePace> pace, Scheduler watch, Scheduler chains) {
        return Flowable.create(emitter -> new LiveSession(emitter, cell, settings, watch, chains).start(frames, pace),
                BackpressureStrategy.LATEST);
    }
}
