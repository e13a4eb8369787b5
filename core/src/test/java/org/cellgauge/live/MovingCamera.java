package org.cellgauge.live;

import io.reactivex.rxjava3.core.Flowable;
import io.reactivex.rxjava3.processors.PublishProcessor;
import io.reactivex.rxjava3.schedulers.TestScheduler;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.overlay.CellOverlay;
import org.cellgauge.internal.overlay.OverlayStyle;
import org.cellgauge.internal.overlay.Pen;
import org.cellgauge.internal.overlay.Shape;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.BoofMarkerDetector;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.DrawnMarkers;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.vision.MarkerObservation;

/**
 * A camera that moves over a cell, as a live check has it: markers of every frame of 1080p, a look when it is due, and
 * what is drawn over each state. All on the caller's thread, by a clock of its own, so that all of it is counted.
 */
public final class MovingCamera {
    private static final int WIDTH = 1920;
    private static final int HEIGHT = 1080;
    /** As many as come between two looks, and some more: no frame is of the place of the last look. */
    static final int PLACES = 11;
    private static final int FRAME_MS = 33;

    private final PublishProcessor<Detections> frames = PublishProcessor.create();
    private final TestScheduler watch = new TestScheduler();
    private final List<GreyImage> images = new ArrayList<>();
    private final BoofMarkerDetector detector;
    private final Set<Long> looks = new HashSet<>();
    private LiveState.Phase phase = LiveState.Phase.SEARCHING;
    private int next;
    private int drawn;

    /** Draws what it sees, and begins. */
    public MovingCamera() {
        Cell cell = scene(0).cell().scaledTo(WIDTH, HEIGHT);
        for (int place = 0; place < PLACES; place++) {
            images.add(image(place));
        }
        detector = BoofMarkerDetector.forFrames(cell);
        OverlayStyle style = OverlayStyle.PHOTO.withoutPanels();
        Pen pen = new Pen() {
            @Override
            public void moveTo(double u, double v) {
                drawn++;
            }

            @Override
            public void lineTo(double u, double v) {
                drawn++;
            }
        };
        LiveCheck.states(frames, cell, CheckSettings.builder().threads(1).build(), Flowable.just(LivePace.FULL), watch,
                new TestScheduler()).subscribe(state -> {
                    looks.add(state.keyFrameNumber());
                    phase = state.phase();
                    for (Shape shape : CellOverlay.of(cell, state.keyFrame(), state.update(), style).shapes()) {
                        shape.draw(pen);
                    }
                });
        watch.triggerActions();
    }

    private static ThesisScene scene(int place) {
        return ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.1).target(3).grip(20, 0, 0, 100)
                .cameraAt(RigidTransform.ofEuler(418 + 30 * (7 * place % PLACES - 5), 106, 1070, 3.08, 0.10, 0.02));
    }

    private static GreyImage image(int place) {
        DrawnMarkers picture = new DrawnMarkers(WIDTH, HEIGHT, 130);
        for (MarkerObservation marker : scene(place).exactDetections().markers()) {
            double[] corners = marker.cornersPx();
            for (int i = 0; i < corners.length; i++) {
                corners[i] *= WIDTH / (double) ThesisScene.CAMERA.widthPx();
            }
            picture.draw(MarkerFamily.SQUARE_BINARY, marker.id(), corners);
        }
        return picture.image();
    }

    /** The next frames of it, of which a second has 30. */
    public void move(int count) {
        for (int i = 0; i < count; i++) {
            frames.onNext(detector.detect(images.get(next), "frame"));
            next = (next + 1) % PLACES;
            watch.advanceTimeBy(FRAME_MS, TimeUnit.MILLISECONDS);
        }
    }

    /** Counts anew. */
    public void forget() {
        looks.clear();
        drawn = 0;
    }

    /** How many frames were looked at. */
    public int looks() {
        return looks.size();
    }

    /** How many points were drawn. */
    public int drawn() {
        return drawn;
    }

    /** What the last state is. */
    public LiveState.Phase phase() {
        return phase;
    }
}
