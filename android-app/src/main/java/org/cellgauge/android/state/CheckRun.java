package org.cellgauge.android.state;

import io.reactivex.rxjava3.core.Flowable;
import io.reactivex.rxjava3.disposables.SerialDisposable;
import io.reactivex.rxjava3.functions.Consumer;
import io.reactivex.rxjava3.processors.FlowableProcessor;
import io.reactivex.rxjava3.processors.PublishProcessor;
import java.util.Arrays;
import org.cellgauge.android.files.CellDocument;
import org.cellgauge.android.files.Photo;
import org.cellgauge.cell.Cell;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.live.LivePace;
import org.cellgauge.live.LiveState;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;

/** One check: a cell with its camera, over the frames of that camera or over one photo. */
final class CheckRun {
    /** A key frame is chosen while the next few frames come: at 30 frames a second this is a quarter of one. */
    private static final int RECENT_FRAMES = 8;

    private final int number;
    private final CellDocument document;
    private final Cell cell;
    private final boolean lensEstimated;
    private final Photo photo;
    private final OneDetector detector;
    private FusedViews fused;
    private long lastJudged;
    private final RecentFrames recent = new RecentFrames(RECENT_FRAMES);
    private final FlowableProcessor<Detections> frames = PublishProcessor.<Detections>create().toSerialized();
    /** Stopped before it has begun, it never begins. */
    private final SerialDisposable subscription = new SerialDisposable();

    /**
     * A check that has not begun.
     *
     * @param number tells it from others of its session
     * @param document the cell
     * @param camera the camera of the frames to come
     * @param lensEstimated whether its lens was not measured and is estimated along, see {@link LensKnowledge}
     * @param photo the one photo that is checked, or null: frames come
     * @param detector looks for markers
     */
    CheckRun(int number, CellDocument document, PinholeCamera camera, boolean lensEstimated, Photo photo,
            OneDetector detector) {
        this.number = number;
        this.document = document;
        this.cell = seenBy(document, camera);
        this.lensEstimated = lensEstimated;
        this.photo = photo;
        this.detector = detector;
    }

    /** The cell with a camera: how well a calibration is known goes along where the camera is of it, and scales. */
    private static Cell seenBy(CellDocument document, PinholeCamera camera) {
        PinholeCamera calibration = document.calibration();
        boolean calibrated = calibration != null && camera.lens() == calibration.lens()
                && calibration.hasShape(camera.widthPx(), camera.heightPx())
                && Arrays.equals(camera.intrinsics(),
                        calibration.resized(camera.widthPx(), camera.heightPx()).intrinsics());
        return calibrated ? document.cell().scaledTo(camera.widthPx(), camera.heightPx())
                : document.cell().withCamera(camera);
    }

    /**
     * Begins; a photo is searched for markers in this call.
     *
     * @param general how checks go about it
     * @param pace how much work it may do
     * @param threads where it works
     * @param states gets what it knows
     * @param faults gets what should not happen
     */
    void start(CheckSettings general, Flowable<LivePace> pace, SessionThreads threads, Consumer<LiveState> states,
            Consumer<Throwable> faults) {
        CheckSettings settings = LensKnowledge.settings(general, cell.camera(), !lensEstimated);
        Flowable<Detections> input = photo == null ? frames
                : Flowable.just(detector.detect(this, photo.luminance(), photo.name()));
        subscription.set(threads.check(input, cell, settings, pace).subscribe(state -> {
            try {
                states.accept(state);
            } catch (OutOfMemoryError e) {
                // RxJava would throw it on, to the thread, and Android end the app
                faults.accept(e);
            }
        }, faults));
    }

    /**
     * Looks for markers in a frame, hands them on and returns them; the frame may change afterwards. One that comes
     * after the end is not looked at: null.
     */
    Detections frame(GreyImage image, String name) {
        if (isStopped()) {
            return null;
        }
        Detections found = detector.detect(this, image, name);
        recent.keep(found, image);
        frames.onNext(found);
        return found;
    }

    /** No frame comes any more: the one that figures belong to is checked to its end. */
    void endFrames() {
        frames.onComplete();
    }

    /**
     * Takes a view that was judged together with those before; for one thread.
     *
     * @param view markers of its key frame
     * @param general how checks go about it
     * @return all views so far that fit each other
     */
    FusedViews fuse(Detections view, CheckSettings general) {
        if (fused == null) {
            fused = FusedViews.none(cell, LensKnowledge.settings(general, cell.camera(), !lensEstimated));
        }
        fused = fused.with(view);
        return fused;
    }

    /** Whether a view has been judged that was not before; for one thread. */
    boolean isNewlyJudged(LiveState state) {
        boolean newly = photo == null && state.phase() == LiveState.Phase.RESULT
                && state.keyFrameNumber() != lastJudged;
        lastJudged = newly ? state.keyFrameNumber() : lastJudged;
        return newly;
    }

    /** Says which frame the figures belong to, or that there are none: its pixels stay until it is another. */
    void choose(Detections keyFrame) {
        recent.choose(keyFrame);
    }

    /** Takes the pixels that figures belong to; null where there are none. */
    Photo photoOf(Detections keyFrame) {
        return keyFrame == null ? null : photo != null ? photo : recent.take(keyFrame);
    }

    void stop() {
        subscription.dispose();
        detector.release(this);
    }

    boolean isStopped() {
        return subscription.isDisposed();
    }

    /** Whether frames of a camera are checked, and not one photo. */
    boolean isOfFrames() {
        return photo == null;
    }

    int number() {
        return number;
    }

    Cell cell() {
        return cell;
    }

    boolean lensEstimated() {
        return lensEstimated;
    }

    /** Whether frames of a camera belong to this check. */
    boolean fits(CellDocument other, PinholeCamera camera, boolean estimated) {
        return photo == null && other == document && estimated == lensEstimated
                && camera.lens() == cell.camera().lens()
                && camera.widthPx() == cell.camera().widthPx() && camera.heightPx() == cell.camera().heightPx()
                && Arrays.equals(camera.intrinsics(), cell.camera().intrinsics());
    }
}
