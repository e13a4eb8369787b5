package org.cellgauge.live;

import io.reactivex.rxjava3.core.Flowable;
import io.reactivex.rxjava3.core.FlowableEmitter;
import io.reactivex.rxjava3.core.Scheduler;
import io.reactivex.rxjava3.disposables.CompositeDisposable;
import io.reactivex.rxjava3.disposables.Disposable;
import io.reactivex.rxjava3.disposables.SerialDisposable;
import io.reactivex.rxjava3.subscribers.DisposableSubscriber;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellRefusal;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckUpdate;
import org.cellgauge.check.QuickLooks;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.jspecify.annotations.Nullable;

/**
 * One subscription of a live check. Everything that happens is handed to one worker, so that nothing below {@code on…}
 * needs a lock; chains run elsewhere.
 */
final class LiveSession {
    /** Share of the tolerance within which a second frame must be for chains to start; to leave takes all of it. */
    private static final double SETTLE_SHARE = 0.5;
    /** Frames without a reference after which the key frame is given up. */
    private static final int LOST_FRAMES = 3;
    /** Frames without a marker of the key frame after which the check restarts without it. */
    private static final int GONE_FRAMES = 15;

    private final FlowableEmitter<LiveState> emitter;
    private final Cell cell;
    private final CheckSettings settings;
    private final QuickLooks looks;
    private final Scheduler chainScheduler;
    private final Scheduler.Worker worker;
    private final StateGate gate;
    private final CompositeDisposable resources = new CompositeDisposable();
    private final SerialDisposable chains = new SerialDisposable();
    private volatile LivePace pace = LivePace.FULL;

    private final List<Integer> missingReferences = new ArrayList<>();
    private final List<Integer> missingObjects = new ArrayList<>();
    private double displacementPx = Double.NaN;
    private @Nullable ViewMotion motion;
    private Frame newest;
    private @Nullable Refusal refusal;
    private @Nullable KeyFrame key;
    private long keyMs;
    private @Nullable RigidTransform lastWorldFromCamera;
    private int framesWithoutReference;
    private Set<Integer> newcomers = new HashSet<>();
    private final Map<Integer, Integer> framesWithout = new HashMap<>();
    private boolean framesEnded;
    private @Nullable ChainRun running;
    private @Nullable LiveState last;

    /** A frame with its number. */
    private static final class Frame {
        final Detections detections;
        final long number;

        Frame(Detections detections, long number) {
            this.detections = detections;
            this.number = number;
        }
    }

    LiveSession(FlowableEmitter<LiveState> emitter, Cell cell, CheckSettings settings, Scheduler watch,
            Scheduler chainScheduler) {
        this.emitter = emitter;
        this.cell = cell;
        this.settings = settings;
        looks = new QuickLooks(cell, settings);
        this.chainScheduler = chainScheduler;
        worker = watch.createWorker();
        newest = new Frame(new Detections("", cell.camera().widthPx(), cell.camera().heightPx(), List.of()), 0);
        gate = new StateGate(worker, emitter::onNext);
        gate.setIntervalMs(pace.updateIntervalMs());
        resources.add(chains);
        resources.add(worker);
        emitter.setCancellable(resources::dispose);
    }

    void start(Flowable<Detections> frames, Flowable<LivePace> paces) {
        listen(paces, value -> {
            // at once for the threads of running chains and the frames to come
            pace = value;
            worker.schedule(guarded(this::onPace));
        }, () -> { });
        Latest<Frame> latest = new Latest<>(worker, frame -> guarded(() -> onFrame(frame)).run());
        AtomicLong count = new AtomicLong();
        AtomicLong lastMs = new AtomicLong(Long.MIN_VALUE);
        listen(frames, detections -> {
            long number = count.incrementAndGet();
            long nowMs = worker.now(TimeUnit.MILLISECONDS);
            long beforeMs = lastMs.get();
            if (beforeMs == Long.MIN_VALUE || nowMs < beforeMs || nowMs - beforeMs >= pace.minFrameIntervalMs()) {
                lastMs.set(nowMs);
                latest.offer(new Frame(detections, number));
            }
        }, () -> worker.schedule(guarded(this::onFramesEnded)));
    }

    private <T> void listen(Flowable<T> source, Consumer<T> onNext, Runnable onComplete) {
        DisposableSubscriber<T> subscriber = new DisposableSubscriber<T>() {
            @Override
            public void onNext(T value) {
                onNext.accept(value);
            }

            @Override
            public void onError(Throwable error) {
                worker.schedule(() -> fail(error));
            }

            @Override
            public void onComplete() {
                onComplete.run();
            }
        };
        resources.add(subscriber);
        source.subscribe(subscriber);
    }

    private Runnable guarded(Runnable action) {
        return () -> {
            try {
                action.run();
            } catch (RuntimeException | OutOfMemoryError e) {
                fail(e);
            }
        };
    }

    /**
     * The same stream on a scheduler, with memory that does not suffice as an error of it. RxJava throws that on, to
     * the thread, and Android ends a program for it.
     */
    static <T> Flowable<T> guarded(Flowable<T> source, Scheduler scheduler) {
        Flowable<T> caught = Flowable.fromPublisher(subscriber -> {
            try {
                source.subscribe(subscriber);
            } catch (OutOfMemoryError e) {
                subscriber.onError(e);
            }
        });
        return caught.subscribeOn(scheduler);
    }

    /** Ends the stream; what goes wrong after it was cancelled is nobody's concern. */
    private void fail(Throwable error) {
        emitter.tryOnError(error);
    }

    // ---- what happens

    private void onPace() {
        gate.setIntervalMs(pace.updateIntervalMs());
        KeyFrame held = key;
        if (held == null || held.finished()) {
            return;
        }
        if (!pace.sampling()) {
            stopChains();
            held.update = held.quickLook.update();
            publish();
        } else if (held.settled && running == null) {
            startChains(held);
        }
    }

    private void onFrame(Frame frame) {
        newest = frame;
        findMissing(frame.detections);
        motion = key == null ? null : ViewMotion.between(cell, key.detections, frame.detections);
        boolean referenceSeen = missingReferences.size() < cell.references().size();
        KeyFrame held = key;
        displacementPx = held == null ? Double.NaN
                : Stillness.displacementPx(cell, held.detections, frame.detections);
        if (!sizeFits(frame.detections)) {
            drop(Refusal.at(Place.of(frame.detections.imageName()), CellRefusal.IMAGE_SIZE,
                    frame.detections.widthPx(), frame.detections.heightPx(), cell.camera().widthPx(),
                    cell.camera().heightPx(), CellPhrase.CAMERA_OF_THIS_SIZE));
        } else if (!referenceSeen) {
            withoutReference();
        } else {
            framesWithoutReference = 0;
            boolean moved = held != null && held.refusal == null && moved(held);
            if (held == null || held.refusal != null || moved || markersChanged(held, frame.detections)
                    || !held.settled && held.isBlurredAgainst(frame.detections)) {
                if (!moved || held == null || held.settled || Double.isNaN(displacementPx) || isNextLookDue()) {
                    takeAsKeyFrame(frame);
                }
            } else {
                settle(held);
            }
        }
        publish();
    }

    private void onFramesEnded() {
        framesEnded = true;
        if (key != null) {
            settle(key);
        }
        completeIfDone();
    }

    private void onUpdate(ChainRun of, CheckUpdate update) {
        if (of == running) {
            of.frame.update = update;
            publish();
        }
    }

    private void onChainsEnded(ChainRun of) {
        if (of == running) {
            running = null;
            completeIfDone();
        }
    }

    private void onChainsFailed(ChainRun of, Throwable error) {
        if (of != running) {
            return;
        }
        if (!(error instanceof InputRefusedException)) {
            fail(error);
            return;
        }
        running = null;
        of.frame.refusal = ((InputRefusedException) error).refusal();
        // chains begin without it: with it the quick look of the next frame could accept what they refuse again
        lastWorldFromCamera = null;
        publish();
        completeIfDone();
    }

    private void completeIfDone() {
        if (framesEnded && running == null) {
            gate.flush();
            emitter.onComplete();
        }
    }

    // ---- the key frame

    private boolean sizeFits(Detections frame) {
        return frame.widthPx() == cell.camera().widthPx() && frame.heightPx() == cell.camera().heightPx();
    }

    private void withoutReference() {
        framesWithoutReference++;
        if (key == null || moved(key) || framesWithoutReference >= LOST_FRAMES) {
            drop(null);
        }
    }

    /**
     * Whether the newest frame is of another view than the key frame, or a marker stands elsewhere in it; before chains
     * have started half as far is too far.
     */
    private boolean moved(KeyFrame held) {
        ViewMotion seen = motion;
        if (seen == null || Double.isNaN(seen.wholePx)) {
            return missingReferences.size() < cell.references().size();
        }
        double share = held.settled ? 1 : SETTLE_SHARE;
        return seen.wholePx > share * held.viewTolerancePx
                || seen.besidesPx > share * Stillness.besidesPx(held.tolerancePx, seen.wholePx);
    }

    /**
     * Whether a view that goes on moving is worth another look: nobody reads figures that change with every frame, and
     * each costs as much memory as the frame has pixels. Until then the figures shown are those of the last look, and
     * go with the picture.
     */
    private boolean isNextLookDue() {
        long sinceMs = worker.now(TimeUnit.MILLISECONDS) - keyMs;
        // a clock that was set back says nothing
        return sinceMs < 0 || sinceMs >= pace.updateIntervalMs();
    }

    /** Whether a marker has come that the key frame lacks, twice in a row, or one has been gone for long. */
    private boolean markersChanged(KeyFrame held, Detections frame) {
        Set<Integer> now = new HashSet<>();
        boolean changed = false;
        for (int id : markersOfCell()) {
            boolean seen = frame.find(id) != null;
            boolean inKeyFrame = held.detections.find(id) != null;
            if (seen && !inKeyFrame) {
                now.add(id);
                changed |= newcomers.contains(id);
            }
            int without = seen || !inKeyFrame ? 0 : framesWithout.getOrDefault(id, 0) + 1;
            framesWithout.put(id, without);
            changed |= without >= GONE_FRAMES;
        }
        newcomers = now;
        return changed;
    }

    private List<Integer> markersOfCell() {
        List<Integer> ids = new ArrayList<>();
        cell.references().forEach(r -> ids.add(r.id()));
        cell.objects().forEach(o -> ids.add(o.id()));
        return ids;
    }

    private void drop(@Nullable Refusal why) {
        stopChains();
        key = null;
        refusal = why;
        displacementPx = Double.NaN;
        motion = null;
    }

    private void takeAsKeyFrame(Frame frame) {
        drop(null);
        newcomers.clear();
        framesWithout.clear();
        try {
            KeyFrame taken = new KeyFrame(cell, frame.detections, frame.number,
                    looks.of(frame.detections, lastWorldFromCamera));
            key = taken;
            keyMs = worker.now(TimeUnit.MILLISECONDS);
            lastWorldFromCamera = taken.update.estimate().camera().meanTransform();
            displacementPx = 0;
        } catch (InputRefusedException e) {
            refusal = e.refusal();
        }
    }

    private void settle(KeyFrame held) {
        held.settled = true;
        if (pace.sampling() && running == null && !held.finished()) {
            startChains(held);
        }
    }

    // ---- chains

    /**
     * Hears what chains have to say; all of it is handed to the worker, where a run that was stopped is not listened
     * to.
     */
    private final class ChainRun extends DisposableSubscriber<CheckUpdate> {
        private final KeyFrame frame;
        private final Latest<CheckUpdate> updates =
                new Latest<>(worker, update -> guarded(() -> onUpdate(this, update)).run());

        ChainRun(KeyFrame frame) {
            this.frame = frame;
        }

        @Override
        public void onNext(CheckUpdate update) {
            updates.offer(update);
        }

        @Override
        public void onError(Throwable error) {
            worker.schedule(guarded(() -> onChainsFailed(this, error)));
        }

        @Override
        public void onComplete() {
            worker.schedule(guarded(() -> onChainsEnded(this)));
        }
    }

    private void startChains(KeyFrame held) {
        Detections frame = held.detections;
        ChainRun run = new ChainRun(held);
        running = run;
        chains.set(run);
        // from the initial estimate and not from where the quick look began: the figures are those of this frame alone
        guarded(Flowable.defer(() -> CellCheck.quickLook(cell, frame, settings, null)
                .chains(() -> Math.min(settings.sampling().threads(), pace.chainThreads()))), chainScheduler)
                .subscribe(run);
    }

    private void stopChains() {
        running = null;
        chains.set(Disposable.disposed());
    }

    // ---- states

    private void findMissing(Detections frame) {
        missingReferences.clear();
        missingObjects.clear();
        for (Reference r : cell.references()) {
            if (frame.find(r.id()) == null) {
                missingReferences.add(r.id());
            }
        }
        for (ObjectMarker o : cell.objects()) {
            if (frame.find(o.id()) == null) {
                missingObjects.add(o.id());
            }
        }
    }

    private void publish() {
        LiveState state = state();
        boolean urgent = last == null || state.phase() != last.phase()
                || state.keyFrameNumber() != last.keyFrameNumber();
        last = state;
        gate.offer(state, urgent);
    }

    private LiveState state() {
        KeyFrame held = key;
        Refusal why = held == null ? refusal : held.refusal;
        LiveState.Phase phase;
        if (why != null) {
            phase = LiveState.Phase.REFUSED;
        } else if (held == null) {
            phase = LiveState.Phase.SEARCHING;
        } else {
            switch (held.update.phase()) {
                case RESULT:
                    phase = LiveState.Phase.RESULT;
                    break;
                case SAMPLING:
                    phase = LiveState.Phase.SAMPLING;
                    break;
                default:
                    phase = LiveState.Phase.QUICK_LOOK;
                    break;
            }
        }
        if (held == null || why != null) {
            return new LiveState(phase, newest.detections, newest.number, null, 0, null, missingReferences,
                    missingObjects, Double.NaN, 0, 0, why);
        }
        return new LiveState(phase, newest.detections, newest.number, held.detections, held.number, held.update,
                missingReferences, missingObjects, displacementPx, motion == null ? 0 : motion.shiftXPx,
                motion == null ? 0 : motion.shiftYPx, null);
    }
}
