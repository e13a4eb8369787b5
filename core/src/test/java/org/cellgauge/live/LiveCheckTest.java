package org.cellgauge.live;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.reactivex.rxjava3.core.Flowable;
import io.reactivex.rxjava3.core.Scheduler;
import io.reactivex.rxjava3.plugins.RxJavaPlugins;
import io.reactivex.rxjava3.processors.BehaviorProcessor;
import io.reactivex.rxjava3.processors.PublishProcessor;
import io.reactivex.rxjava3.schedulers.TestScheduler;
import io.reactivex.rxjava3.subscribers.TestSubscriber;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellRefusal;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.CheckUpdate;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.vision.PhotoLight;
import org.cellgauge.warning.CheckRefusal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

/** When a live check restarts, waits, samples and stops; time and threads are the tests' own. */
@Isolated("counts threads, and takes over what RxJava does with lost errors")
class LiveCheckTest {
    private static final CheckSettings SETTINGS = CheckSettings.builder().iterations(1200).threads(1).build();
    private static final Cell CELL = scene(0).cell();

    private final PublishProcessor<Detections> frames = PublishProcessor.create();
    private final BehaviorProcessor<LivePace> pace = BehaviorProcessor.createDefault(LivePace.of(0, 0, 1, true));
    private final TestScheduler watch = new TestScheduler();
    private final TestScheduler chains = new TestScheduler();
    private final Counting countedChains = new Counting(chains);

    /** Counts how often chains were started. */
    private static final class Counting extends Scheduler {
        private final Scheduler inner;
        private int workers;

        Counting(Scheduler inner) {
            this.inner = inner;
        }

        @Override
        public Worker createWorker() {
            workers++;
            return inner.createWorker();
        }
    }

    /** The camera moved by so many mm along x: 1 mm is about 0.54 px. */
    private static ThesisScene scene(double mm) {
        return ThesisScene.inPlane(4).placement(1, 0.003).target(3)
                .cameraAt(RigidTransform.ofEuler(418 + mm, 106, 1070, 3.08, 0.10, 0.02));
    }

    private static Detections noisy(double mm, long seed) {
        return scene(mm).detections(0.3, RandomStreams.of(seed), 0, 0);
    }

    private static Detections without(Detections frame, Integer... ids) {
        return only(frame, id -> !Arrays.asList(ids).contains(id));
    }

    private static Detections only(Detections frame, Predicate<Integer> kept) {
        List<MarkerObservation> markers = new ArrayList<>(frame.markers());
        markers.removeIf(m -> !kept.test(m.id()));
        return new Detections(frame.imageName(), frame.widthPx(), frame.heightPx(), markers);
    }

    /** The frame with one marker, or all where the id is 0, shifted to the right. */
    private static Detections shifted(Detections frame, int id, double px) {
        List<MarkerObservation> markers = new ArrayList<>();
        for (MarkerObservation m : frame.markers()) {
            double[] corners = m.cornersPx();
            for (int i = 0; i < 8; i += 2) {
                corners[i] += id == 0 || m.id() == id ? px : 0;
            }
            markers.add(new MarkerObservation(m.id(), corners));
        }
        return new Detections(frame.imageName(), frame.widthPx(), frame.heightPx(), markers);
    }

    private TestSubscriber<LiveState> start() {
        return start(SETTINGS);
    }

    private TestSubscriber<LiveState> start(CheckSettings settings) {
        TestSubscriber<LiveState> states =
                LiveCheck.states(frames, CELL, settings, pace, watch, countedChains).test();
        watch.triggerActions();
        return states;
    }

    private void send(Detections frame) {
        frames.onNext(frame);
        watch.triggerActions();
    }

    private void runChains() {
        chains.triggerActions();
        watch.triggerActions();
    }

    private static LiveState last(TestSubscriber<LiveState> states) {
        return states.values().get(states.values().size() - 1);
    }

    private static void assertSameResult(CheckResult a, CheckResult b) {
        assertEquals(a.layout().size(), b.layout().size());
        for (int c = 0; c < a.draws().size(); c++) {
            for (int q = 0; q < a.layout().size(); q++) {
                assertArrayEquals(a.draws().get(c).series(q), b.draws().get(c).series(q));
            }
        }
        assertEquals(a.reason(), b.reason());
        assertEquals(a.warnings(), b.warnings());
        assertArrayEquals(a.estimate().camera().mean(), b.estimate().camera().mean());
        assertArrayEquals(a.quickLook().camera().mean(), b.quickLook().camera().mean());
    }

    // ---- the course of a check

    @Test
    void theFirstFrameGivesAQuickLookAtOnceAndNoChains() {
        TestSubscriber<LiveState> states = start();
        states.assertEmpty();
        Detections frame = noisy(0, 1);
        send(frame);
        states.assertValueCount(1);
        LiveState state = last(states);
        assertEquals(LiveState.Phase.QUICK_LOOK, state.phase());
        assertSame(frame, state.keyFrame());
        assertSame(frame, state.detections());
        assertEquals(1, state.keyFrameNumber());
        assertEquals(0, state.displacementPx());
        assertNull(state.refusal());
        assertEquals(List.of(), state.missingIds());
        assertArrayEquals(CellCheck.stream(CELL, frame, SETTINGS).blockingFirst().estimate().camera().mean(),
                state.update().estimate().camera().mean());
        assertEquals(0, countedChains.workers);
    }

    @Test
    void chainsStartWithTheSecondStillFrameAndEndInTheResultOfTheKeyFrame() {
        TestSubscriber<LiveState> states = start();
        Detections first = noisy(0, 1);
        send(first);
        send(noisy(0, 2));
        assertEquals(1, countedChains.workers);
        assertEquals(LiveState.Phase.QUICK_LOOK, last(states).phase());
        runChains();
        LiveState state = last(states);
        assertEquals(LiveState.Phase.RESULT, state.phase());
        assertEquals(1, state.keyFrameNumber());
        assertEquals(2, state.frameNumber());
        assertSameResult(CellCheck.run(CELL, first, SETTINGS), state.update().result());
        // nothing is left to do while the camera stays where it is
        for (int i = 3; i < 10; i++) {
            send(noisy(0, i));
            runChains();
            assertSame(state.update().result(), last(states).update().result());
            assertEquals(i, last(states).frameNumber());
        }
        assertEquals(1, countedChains.workers);
    }

    @Test
    void whileTheViewMovesItIsLookedAtNoMoreOftenThanStatesAreShown() {
        TestSubscriber<LiveState> states = start();
        pace.onNext(LivePace.of(200, 0, 1, true));
        int frame = 0;
        for (; frame < 30; frame++) {
            // from one of eleven places to another that is far from it, and from those of the frames before
            send(noisy(30 * (7 * frame % 11 - 5), 20 + frame));
            watch.advanceTimeBy(33, TimeUnit.MILLISECONDS);
        }
        long keyFrames = states.values().stream().mapToLong(LiveState::keyFrameNumber).distinct().count();
        assertTrue(keyFrames >= 4 && keyFrames <= 5, "key frames in a second: " + keyFrames);
        assertEquals(0, countedChains.workers);
        // between two looks figures stay those of the last one, and it is known by how much the view has moved since
        double most = states.values().stream().mapToDouble(LiveState::displacementPx).max().orElse(0);
        assertTrue(most > 20, "displacement " + most);
        // where it comes to rest it is looked at, and sampled
        watch.advanceTimeBy(200, TimeUnit.MILLISECONDS);
        Detections rest = noisy(200, 90);
        send(rest);
        send(noisy(200, 91));
        assertSame(rest, last(states).keyFrame());
        assertEquals(1, countedChains.workers);
    }

    @Test
    void memoryThatDoesNotSufficeForChainsEndsTheStreamAndNotTheThread() {
        OutOfMemoryError full = new OutOfMemoryError();
        // RxJava by itself throws such an error on
        TestSubscriber<Object> chain = LiveSession.guarded(Flowable.defer(() -> {
            throw full;
        }), chains).test();
        chains.triggerActions();
        chain.assertError(full);
    }

    @Test
    void theResultDoesNotDependOnWhatTheCameraSawBefore() {
        TestSubscriber<LiveState> states = start();
        for (int i = 0; i < 8; i++) {
            send(noisy(-40 + 10 * i, 20 + i));
        }
        Detections frame = noisy(60, 30);
        send(frame);
        send(noisy(60, 31));
        runChains();
        assertEquals(LiveState.Phase.RESULT, last(states).phase());
        assertEquals(9, last(states).keyFrameNumber());
        assertSameResult(CellCheck.run(CELL, frame, SETTINGS), last(states).update().result());
    }

    @Test
    void theSearchForAMovedCamerasModeStartsAtTheLastOne() {
        TestSubscriber<LiveState> states = start();
        send(noisy(0, 1));
        RigidTransform lastMode = last(states).update().estimate().camera().meanTransform();
        Detections moved = noisy(60, 2);
        send(moved);
        assertEquals(2, last(states).keyFrameNumber());
        double[] found = last(states).update().estimate().camera().mean();
        assertArrayEquals(CellCheck.quickLook(CELL, moved, SETTINGS, lastMode).update().estimate().camera().mean(),
                found);
        // the same mode to what the search stops at, and not to the last digit, which tells one start from the other
        double[] anew = CellCheck.quickLook(CELL, moved, SETTINGS, null).update().estimate().camera().mean();
        assertArrayEquals(anew, found, 1e-3);
        assertFalse(Arrays.equals(anew, found));
    }

    @Test
    void aCameraThatMovesFromFrameToFrameGetsQuickLooksOnly() {
        TestSubscriber<LiveState> states = start();
        for (int i = 0; i < 12; i++) {
            send(noisy(60 * (i % 2), i));
            runChains();
            assertEquals(LiveState.Phase.QUICK_LOOK, last(states).phase());
            assertEquals(i + 1, last(states).keyFrameNumber());
        }
        states.assertValueCount(12);
        assertEquals(0, countedChains.workers);
    }

    @Test
    void motionEndsTheChainsAndTheNewestFrameBecomesTheKeyFrame() {
        TestSubscriber<LiveState> states = start();
        send(noisy(0, 1));
        send(noisy(0, 2));
        assertEquals(1, countedChains.workers);
        Detections moved = noisy(60, 3);
        send(moved);
        runChains();
        assertEquals(LiveState.Phase.QUICK_LOOK, last(states).phase());
        assertSame(moved, last(states).keyFrame());
        for (LiveState state : states.values()) {
            assertEquals(CheckUpdate.Phase.QUICK_LOOK, state.update().phase(), "the old chains say nothing more");
        }
    }

    @Test
    void aResultIsGivenUpWithTheFirstFrameThatMoved() {
        TestSubscriber<LiveState> states = start();
        send(noisy(0, 1));
        send(noisy(0, 2));
        runChains();
        assertEquals(LiveState.Phase.RESULT, last(states).phase());
        send(noisy(60, 3));
        assertEquals(LiveState.Phase.QUICK_LOOK, last(states).phase());
        assertNull(last(states).update().result());
        assertEquals(3, last(states).keyFrameNumber());
    }

    // ---- stillness

    @Test
    void displacementIsTheRootMeanSquareOfTheMarkerThatMovedMost() {
        Detections a = scene(0).exactDetections();
        List<MarkerObservation> markers = new ArrayList<>();
        for (MarkerObservation m : a.markers()) {
            double[] px = m.cornersPx();
            for (int k = 0; k < 4; k++) {
                px[2 * k] += m.id() == 5 ? 3 : 1;
                px[2 * k + 1] += m.id() == 5 ? 4 : 0;
            }
            markers.add(new MarkerObservation(m.id(), px));
        }
        // a marker that is not of the cell does not count
        markers.add(new MarkerObservation(77, new double[] {900, 600, 930, 600, 930, 630, 900, 630}));
        Detections b = new Detections("b", 1280, 720, markers);
        assertEquals(5, Stillness.displacementPx(CELL, a, b), 1e-9);
        assertEquals(1, Stillness.displacementPx(CELL, a, without(b, 5)), 1e-9);
        assertTrue(Double.isNaN(Stillness.displacementPx(CELL, a, only(b, id -> id == 77))));
        double[] one = a.find(5).cornersPx();
        one[0] += 8;
        Detections c = new Detections("c", 1280, 720, List.of(new MarkerObservation(5, one)));
        assertEquals(4, Stillness.displacementPx(CELL, a, c), 1e-9, "one corner of four by 8 px");
    }

    @Test
    void toleranceGrowsWithTheImageAndIsAboveTheNoise() {
        Detections wide = new Detections("", 1280, 720, List.of());
        Detections upright = new Detections("", 1080, 1920, List.of());
        assertEquals(3, Stillness.tolerancePx(wide, 0.05), 1e-12);
        assertEquals(4.5, Stillness.tolerancePx(upright, 0.05), 1e-12);
        assertEquals(6 * Math.sqrt(2), Stillness.tolerancePx(wide, 1), 1e-12);
    }

    @Test
    void tremorOfTheWholeViewRestartsNothingOnceChainsHaveStarted() {
        TestSubscriber<LiveState> states = start();
        Detections first = noisy(0, 1);
        send(first);
        // references are 25 px large: beyond half of it chains do not start
        send(shifted(first, 0, 14));
        assertEquals(2, last(states).keyFrameNumber());
        assertEquals(0, countedChains.workers);
        send(shifted(first, 0, 18));
        assertEquals(2, last(states).keyFrameNumber());
        assertEquals(4, last(states).displacementPx(), 1e-9);
        assertEquals(4, last(states).shiftXPx(), 1e-9);
        assertEquals(0, last(states).shiftYPx(), 1e-9);
        assertEquals(1, countedChains.workers);
        for (double px : new double[] {34, -6, 34, 20, -6}) {
            send(shifted(first, 0, px));
            assertEquals(2, last(states).keyFrameNumber());
        }
        send(shifted(first, 0, 45));
        assertEquals(9, last(states).keyFrameNumber());
        assertEquals(1, countedChains.workers);
    }

    /** A hand of 4 px: independent from frame to frame, which is the worst there is, and turned and nearer besides. */
    @Test
    void aTremblingHandKeepsItsVerdict() {
        TestSubscriber<LiveState> states = start();
        Random hand = new Random(5);
        Detections still = noisy(0, 1);
        int shown = 0;
        int frames = 300;
        for (int i = 0; i < frames; i++) {
            // 4 px root mean square of the distance
            double x = 4 / Math.sqrt(2) * hand.nextGaussian();
            double y = 4 / Math.sqrt(2) * hand.nextGaussian();
            send(moved(noisy(0, i), x, y, 1 + 0.002 * hand.nextGaussian(), 0.003 * hand.nextGaussian()));
            // chains take 20 frames
            if (i % 20 == 19) {
                runChains();
            }
            if (i >= 60 && last(states).phase() == LiveState.Phase.RESULT) {
                shown++;
            }
        }
        assertTrue(still.markers().size() > 0);
        assertTrue(shown >= 0.9 * (frames - 60), "a verdict on " + shown + " of " + (frames - 60) + " frames");
    }

    /** A sharper frame is worth waiting for until the chains have started, and never afterwards. */
    @Test
    void aSharperFrameOfTheSameViewTakesTheKeyFramesPlaceBeforeTheChains() {
        TestSubscriber<LiveState> states = start();
        Detections first = noisy(0, 1);
        send(blurred(first, 1.6));
        send(blurred(first, 0.9));
        assertEquals(2, last(states).keyFrameNumber());
        assertEquals(0, countedChains.workers);
        send(blurred(first, 0.8));
        assertEquals(2, last(states).keyFrameNumber(), "hardly sharper");
        assertEquals(1, countedChains.workers);
        send(blurred(first, 0.4));
        assertEquals(2, last(states).keyFrameNumber());
    }

    private static Detections blurred(Detections frame, double blurPx) {
        return new Detections(frame.imageName(), frame.widthPx(), frame.heightPx(), frame.markers(), List.of(),
                new PhotoLight(ToneCurve.LINEAR, false, blurPx, 1, 100, 0.05));
    }

    /** The frame shifted, turned and scaled about its middle. */
    private static Detections moved(Detections frame, double x, double y, double scale, double turnRad) {
        List<MarkerObservation> markers = new ArrayList<>();
        double c = scale * Math.cos(turnRad);
        double s = scale * Math.sin(turnRad);
        for (MarkerObservation m : frame.markers()) {
            double[] p = m.cornersPx();
            double[] q = new double[p.length];
            for (int i = 0; i < p.length; i += 2) {
                q[i] = 640 + x + c * (p[i] - 640) - s * (p[i + 1] - 360);
                q[i + 1] = 360 + y + s * (p[i] - 640) + c * (p[i + 1] - 360);
            }
            markers.add(new MarkerObservation(m.id(), q));
        }
        return new Detections(frame.imageName(), frame.widthPx(), frame.heightPx(), markers);
    }

    @Test
    void theMotionOfTheWholeIsToldApartFromThatOfAMarker() {
        Detections a = scene(0).exactDetections();
        ViewMotion whole = ViewMotion.between(CELL, a, moved(a, 3, -4, 1.01, 0.02));
        assertEquals(0, whole.besidesPx, 1e-9);
        assertTrue(whole.wholePx > 5);
        ViewMotion both = ViewMotion.between(CELL, a, moved(shifted(a, 5, 2), 3, -4, 1, 0));
        assertEquals(2, both.besidesPx, 1e-9);
        assertEquals(5, both.wholePx, 1e-9);
        assertEquals(3, both.shiftXPx, 1e-9);
        assertEquals(-4, both.shiftYPx, 1e-9);
        // of two references only a shift is told: a turn is besides
        Detections two = without(a, CELL.references().get(0).id(), CELL.references().get(1).id());
        assertTrue(ViewMotion.between(CELL, two, moved(two, 0, 0, 1, 0.02)).besidesPx > 1);
        assertTrue(Double.isNaN(ViewMotion.between(CELL, a, only(a, id -> id == 77)).wholePx));
    }

    @Test
    void anObjectThatAloneIsMovedRestartsTheCheck() {
        TestSubscriber<LiveState> states = start();
        Detections first = noisy(0, 1);
        send(first);
        send(first);
        send(shifted(first, 5, 3.2));
        assertEquals(3, last(states).keyFrameNumber());
    }

    // ---- markers that come and go

    @Test
    void aMarkerThatComesIntoViewRestartsOnceTwoFramesInARowShowIt() {
        TestSubscriber<LiveState> states = start();
        Detections whole = noisy(0, 1);
        Detections part = without(whole, 944);
        send(part);
        send(part);
        assertEquals(List.of(944), last(states).missingIds());
        assertEquals(List.of(944), last(states).missingReferences());
        send(whole);
        send(part);
        send(whole);
        assertEquals(1, last(states).keyFrameNumber(), "seen now and then");
        send(whole);
        assertEquals(6, last(states).keyFrameNumber());
        assertEquals(List.of(), last(states).missingIds());
    }

    @Test
    void aMarkerThatIsMissingForAWhileChangesNothingButOneThatIsGoneDoes() {
        TestSubscriber<LiveState> states = start();
        Detections whole = noisy(0, 1);
        send(whole);
        send(whole);
        runChains();
        for (int i = 0; i < 14; i++) {
            send(without(whole, 20));
            assertEquals(LiveState.Phase.RESULT, last(states).phase());
            assertEquals(List.of(20), last(states).missingObjects());
        }
        send(whole);
        assertEquals(List.of(), last(states).missingIds());
        for (int i = 0; i < 14; i++) {
            send(without(whole, 20));
        }
        assertEquals(1, last(states).keyFrameNumber());
        send(without(whole, 20));
        assertEquals(32, last(states).keyFrameNumber());
        assertNull(last(states).update().estimate().object(20));
    }

    @Test
    void withoutAReferenceItSearchesAndKeepsNoFigures() {
        TestSubscriber<LiveState> states = start();
        Detections whole = noisy(0, 1);
        Detections objects = only(whole, id -> id == 5 || id == 20);
        send(objects);
        LiveState searching = last(states);
        assertEquals(LiveState.Phase.SEARCHING, searching.phase());
        assertNull(searching.update());
        assertNull(searching.keyFrame());
        assertEquals(0, searching.keyFrameNumber());
        assertEquals(List.of(1234, 911, 944, 22), searching.missingReferences());
        assertEquals(List.of(30), searching.missingObjects());
        assertTrue(Double.isNaN(searching.displacementPx()));
        send(whole);
        send(whole);
        runChains();
        send(objects);
        send(objects);
        assertEquals(LiveState.Phase.RESULT, last(states).phase(), "a hand before the lens");
        send(objects);
        assertEquals(LiveState.Phase.SEARCHING, last(states).phase());
        assertNull(last(states).update());
        send(whole);
        assertEquals(LiveState.Phase.QUICK_LOOK, last(states).phase());
    }

    @Test
    void motionWithoutAReferenceIsSearchingAtOnce() {
        TestSubscriber<LiveState> states = start();
        Detections whole = noisy(0, 1);
        send(whole);
        send(whole);
        send(only(noisy(60, 2), id -> id == 5));
        assertEquals(LiveState.Phase.SEARCHING, last(states).phase());
        runChains();
        assertEquals(LiveState.Phase.SEARCHING, last(states).phase());
    }

    // ---- refusals

    /** Clipped frames of an unknown curve come and go with the exposure: they must not end the stream. */
    @Test
    void aFrameWhoseToneCurveIsOpenIsRefusedInWordsAndTheNextOneIsTried() {
        TestSubscriber<LiveState> states = start();
        Detections seen = noisy(0, 1);
        send(new Detections("clipped", seen.widthPx(), seen.heightPx(), seen.markers(), seen.warnings(),
                new PhotoLight(ToneCurve.SRGB, true, 0.7, 2, 100, 0.1).withOpenToneCurve()));
        assertEquals(LiveState.Phase.REFUSED, last(states).phase());
        assertEquals("clipped", last(states).refusal().place().file());
        assertEquals(CheckRefusal.TONE_CURVE_OPEN, last(states).refusal().kind());
        send(noisy(0, 2));
        assertEquals(LiveState.Phase.QUICK_LOOK, last(states).phase());
        states.assertNoErrors();
    }

    @Test
    void aFrameThatCannotBeEstimatedIsRefusedWithTheReasonAndTheNextOneIsTried() {
        TestSubscriber<LiveState> states = start();
        List<MarkerObservation> wrong = new ArrayList<>();
        for (MarkerObservation m : noisy(0, 1).markers()) {
            // all four corners at one point: of no pose
            double[] p = m.cornersPx();
            wrong.add(new MarkerObservation(m.id(), new double[] {p[0], p[1], p[0], p[1], p[0], p[1], p[0], p[1]}));
        }
        Detections bad = new Detections("bad", 1280, 720, wrong);
        send(bad);
        LiveState refused = last(states);
        assertEquals(LiveState.Phase.REFUSED, refused.phase());
        assertEquals("bad", refused.refusal().place().file());
        assertNull(refused.update());
        assertNull(refused.keyFrame());
        send(noisy(0, 2));
        assertEquals(LiveState.Phase.QUICK_LOOK, last(states).phase());
        assertNull(last(states).refusal());
        send(bad);
        assertEquals(LiveState.Phase.REFUSED, last(states).phase());
        runChains();
        assertNull(last(states).update());
    }

    @Test
    void aFrameOfAnotherSizeThanTheCamerasIsRefused() {
        TestSubscriber<LiveState> states = start();
        send(new Detections("small", 640, 480, noisy(0, 1).markers()));
        assertEquals(LiveState.Phase.REFUSED, last(states).phase());
        assertEquals(CellRefusal.IMAGE_SIZE, last(states).refusal().kind());
        assertEquals(Arrays.asList(640, 480, 1280, 720), last(states).refusal().arguments().subList(0, 4));
    }

    // ---- pace

    @Test
    void statesThatOnlyBringANewerFrameComeAtABoundedRateAndTheLastOneAlways() {
        pace.onNext(LivePace.of(200, 0, 1, true));
        TestSubscriber<LiveState> states = start();
        send(noisy(0, 1));
        send(noisy(0, 2));
        states.assertValueCount(1);
        runChains();
        states.assertValueCount(2);
        assertEquals(LiveState.Phase.RESULT, last(states).phase(), "the result waits for nothing");
        for (int i = 0; i < 100; i++) {
            send(noisy(0, 3 + i));
            watch.advanceTimeBy(10, TimeUnit.MILLISECONDS);
        }
        states.assertValueCount(2 + 5);
        send(noisy(0, 200));
        watch.advanceTimeBy(1, TimeUnit.SECONDS);
        assertEquals(103, last(states).frameNumber());
        pace.onNext(LivePace.of(50, 0, 1, true));
        int before = states.values().size();
        for (int i = 0; i < 100; i++) {
            send(noisy(0, 300 + i));
            watch.advanceTimeBy(10, TimeUnit.MILLISECONDS);
        }
        assertEquals(20, states.values().size() - before, 1);
    }

    @Test
    void framesThatComeTooSoonAreDroppedBeforeAnyWork() {
        pace.onNext(LivePace.of(0, 100, 1, true));
        TestSubscriber<LiveState> states = start();
        for (int i = 0; i < 40; i++) {
            // each of them would be a key frame of its own
            send(noisy(10 * i, i));
            watch.advanceTimeBy(25, TimeUnit.MILLISECONDS);
        }
        states.assertValueCount(10);
        for (int i = 0; i < 10; i++) {
            assertEquals(1 + 4 * i, states.values().get(i).keyFrameNumber());
        }
    }

    @Test
    void withoutSamplingFiguresStayPreliminaryUntilSamplingIsAllowed() {
        pace.onNext(LivePace.QUICK_LOOK_ONLY);
        TestSubscriber<LiveState> states = start();
        Detections first = noisy(0, 1);
        send(first);
        for (int i = 0; i < 5; i++) {
            watch.advanceTimeBy(1, TimeUnit.SECONDS);
            send(noisy(0, 2 + i));
            runChains();
            assertEquals(LiveState.Phase.QUICK_LOOK, last(states).phase());
        }
        assertEquals(0, countedChains.workers);
        pace.onNext(LivePace.FULL);
        watch.triggerActions();
        runChains();
        assertEquals(LiveState.Phase.RESULT, last(states).phase());
        assertSame(first, last(states).keyFrame());
        pace.onNext(LivePace.QUICK_LOOK_ONLY);
        watch.advanceTimeBy(1, TimeUnit.SECONDS);
        send(noisy(0, 9));
        assertEquals(LiveState.Phase.RESULT, last(states).phase(), "what is known stays known");
    }

    @Test
    void chainsThatMayNoLongerRunEndAndTheKeyFrameStays() {
        TestSubscriber<LiveState> states = start();
        send(noisy(0, 1));
        send(noisy(0, 2));
        pace.onNext(LivePace.of(0, 0, 1, false));
        watch.triggerActions();
        runChains();
        assertEquals(LiveState.Phase.QUICK_LOOK, last(states).phase());
        assertEquals(1, last(states).keyFrameNumber());
        pace.onNext(LivePace.of(0, 0, 1, true));
        watch.triggerActions();
        runChains();
        assertEquals(LiveState.Phase.RESULT, last(states).phase());
        assertEquals(1, last(states).keyFrameNumber());
        assertEquals(2, countedChains.workers);
    }

    @Test
    void aPaceOutOfRangeIsRefused() {
        for (Runnable wrong : new Runnable[] {() -> LivePace.of(-1, 0, 1, true), () -> LivePace.of(0, -1, 1, true),
            () -> LivePace.of(0, 0, 0, true)}) {
            org.junit.jupiter.api.Assertions.assertThrows(IllegalArgumentException.class, wrong::run);
        }
        assertEquals(LivePace.of(200, 0, 4, true), LivePace.FULL);
        assertFalse(LivePace.FULL.equals(LivePace.REDUCED));
    }

    // ---- newest first

    @Test
    void whileAFrameIsWorkedOnOnlyTheNewestWaits() {
        TestSubscriber<LiveState> states = start();
        for (int i = 1; i <= 5; i++) {
            frames.onNext(noisy(10 * i, i));
        }
        watch.triggerActions();
        states.assertValueCount(1);
        assertEquals(5, last(states).keyFrameNumber());
    }

    @Test
    void aSlowSubscriberGetsTheNewestState() {
        TestSubscriber<LiveState> slow =
                LiveCheck.states(frames, CELL, SETTINGS, pace, watch, countedChains).test(1);
        watch.triggerActions();
        for (int i = 1; i <= 6; i++) {
            send(noisy(10 * i, i));
        }
        slow.assertValueCount(1);
        slow.request(1);
        slow.assertValueCount(2);
        assertEquals(6, last(slow).frameNumber());
    }

    // ---- the end

    @Test
    void whenTheFramesEndTheKeyFrameIsCheckedToItsEnd() {
        TestSubscriber<LiveState> states = start();
        Detections only = noisy(0, 1);
        send(only);
        frames.onComplete();
        watch.triggerActions();
        states.assertNotComplete();
        runChains();
        states.assertComplete();
        assertSameResult(CellCheck.run(CELL, only, SETTINGS), last(states).update().result());
    }

    @Test
    void framesThatEndInNothingComplete() {
        TestSubscriber<LiveState> states = start();
        frames.onComplete();
        watch.triggerActions();
        states.assertComplete();
        states.assertNoValues();
    }

    @Test
    void anErrorOfTheFramesOrOfThePaceEndsTheStreamWithIt() {
        TestSubscriber<LiveState> states = start();
        send(noisy(0, 1));
        IllegalStateException lost = new IllegalStateException("camera lost");
        frames.onError(lost);
        watch.triggerActions();
        states.assertError(lost);
        assertFalse(pace.hasSubscribers());
    }

    @Test
    void cancellingLetsGoOfEverything() {
        TestSubscriber<LiveState> states = start();
        send(noisy(0, 1));
        send(noisy(0, 2));
        states.cancel();
        assertFalse(frames.hasSubscribers());
        assertFalse(pace.hasSubscribers());
        int count = states.values().size();
        runChains();
        assertEquals(count, states.values().size());
    }

    // ---- on threads of its own

    private static final CheckSettings ENDLESS = CheckSettings.builder().iterations(2_000_000_000).warmup(1000)
            .threads(2).build();

    private static int threads(String part) {
        int count = 0;
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            count += thread.isAlive() && thread.getName().contains(part) ? 1 : 0;
        }
        return count;
    }

    private static void awaitThreads(String part, int count) throws InterruptedException {
        for (int i = 0; i < 200 && threads(part) != count; i++) {
            TimeUnit.MILLISECONDS.sleep(20);
        }
        assertEquals(count, threads(part), part);
    }

    private static LiveState await(TestSubscriber<LiveState> states, Predicate<LiveState> wanted)
            throws InterruptedException {
        for (int i = 0; i < 1000; i++) {
            states.assertNoErrors();
            for (LiveState state : new ArrayList<>(states.values())) {
                if (wanted.test(state)) {
                    return state;
                }
            }
            TimeUnit.MILLISECONDS.sleep(10);
        }
        throw new AssertionError("no such state among " + states.values().size());
    }

    @Test
    void cancellingLeavesNoThreadAndMotionNoChain() throws InterruptedException {
        int before = threads("cellgauge");
        pace.onNext(LivePace.of(50, 0, 2, true));
        TestSubscriber<LiveState> states = LiveCheck.states(frames, CELL, ENDLESS, pace).test();
        frames.onNext(noisy(0, 1));
        await(states, s -> s.keyFrameNumber() == 1);
        frames.onNext(noisy(0, 2));
        await(states, s -> s.phase() == LiveState.Phase.SAMPLING);
        assertTrue(threads("cellgauge-chain") > 0);
        frames.onNext(noisy(60, 3));
        await(states, s -> s.keyFrameNumber() == 3);
        awaitThreads("cellgauge-chain", 0);
        awaitThreads("cellgauge-live-chains", 0);
        frames.onNext(noisy(60, 4));
        await(states, s -> s.keyFrameNumber() == 3 && s.phase() == LiveState.Phase.SAMPLING);
        states.cancel();
        awaitThreads("cellgauge", before);
    }

    /** On a tablet an error that reaches nobody ends the program. */
    @Test
    void chainsStoppedAtAnyMomentLeaveNeitherErrorsNorThreads() throws InterruptedException {
        List<Throwable> lost = new CopyOnWriteArrayList<>();
        RxJavaPlugins.setErrorHandler(lost::add);
        try {
            pace.onNext(LivePace.of(0, 0, 2, true));
            TestSubscriber<LiveState> states = LiveCheck.states(frames, CELL, SETTINGS, pace).test();
            for (int i = 0; i < 60; i++) {
                Detections here = noisy(20 * (i % 2), i);
                frames.onNext(here);
                TimeUnit.MILLISECONDS.sleep(2);
                frames.onNext(here);
                TimeUnit.MICROSECONDS.sleep(300L * i);
            }
            states.cancel();
            states.assertNoErrors();
            awaitThreads("cellgauge", 0);
        } finally {
            RxJavaPlugins.setErrorHandler(null);
        }
        assertEquals(List.of(), lost);
    }

    @Test
    void checksCancelledAtAnyMomentLeaveNeitherErrorsNorThreads() throws InterruptedException {
        List<Throwable> lost = new CopyOnWriteArrayList<>();
        RxJavaPlugins.setErrorHandler(lost::add);
        Random random = new Random(1);
        // states that come too early are timed: half of them are when nobody waits any more
        pace.onNext(LivePace.of(1, 0, 2, true));
        Detections here = noisy(0, 1);
        try {
            for (int i = 0; i < 300; i++) {
                TestSubscriber<LiveState> states = LiveCheck.states(frames, CELL, ENDLESS, pace).test();
                frames.onNext(here);
                TimeUnit.MICROSECONDS.sleep(random.nextInt(6000));
                frames.onNext(here);
                TimeUnit.MICROSECONDS.sleep(random.nextInt(12_000));
                states.cancel();
                states.assertNoErrors();
            }
            awaitThreads("cellgauge", 0);
        } finally {
            RxJavaPlugins.setErrorHandler(null);
        }
        assertEquals(List.of(), lost);
    }

    @Test
    void withoutSamplingRunningChainsEndAndFiguresAreThoseOfTheQuickLookAgain() throws InterruptedException {
        pace.onNext(LivePace.of(0, 0, 2, true));
        TestSubscriber<LiveState> states = LiveCheck.states(frames, CELL, ENDLESS, pace).test();
        frames.onNext(noisy(0, 1));
        await(states, s -> s.keyFrameNumber() == 1);
        frames.onNext(noisy(0, 2));
        await(states, s -> s.phase() == LiveState.Phase.SAMPLING);
        pace.onNext(LivePace.of(0, 0, 2, false));
        awaitThreads("cellgauge-live-chains", 0);
        awaitThreads("cellgauge-chain", 0);
        frames.onNext(noisy(0, 3));
        LiveState state = await(states, s -> s.frameNumber() == 3);
        assertEquals(LiveState.Phase.QUICK_LOOK, state.phase());
        assertEquals(CheckUpdate.Phase.QUICK_LOOK, state.update().phase());
        assertEquals(1, state.keyFrameNumber());
        states.cancel();
        awaitThreads("cellgauge", 0);
    }

    @Test
    void onItsOwnThreadsTheResultIsTheSame() throws InterruptedException {
        TestSubscriber<LiveState> states = LiveCheck.states(frames, CELL, SETTINGS, pace).test();
        Detections first = noisy(0, 1);
        frames.onNext(first);
        await(states, s -> s.keyFrameNumber() == 1);
        frames.onNext(noisy(0, 2));
        LiveState state = await(states, s -> s.phase() == LiveState.Phase.RESULT);
        assertSameResult(CellCheck.run(CELL, first, SETTINGS), state.update().result());
        states.cancel();
        awaitThreads("cellgauge", 0);
    }
}
