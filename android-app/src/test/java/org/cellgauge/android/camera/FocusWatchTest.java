package org.cellgauge.android.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Collections;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.vision.PhotoLight;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** When the focus is searched again, and when it is left alone. */
class FocusWatchTest {
    private static final long FRAME_NS = 100_000_000;

    private final FocusWatch watch = new FocusWatch();
    private long timeNs;

    /** One upright square marker 5, and how blurred it is; px. */
    static Detections seen(int width, int height, double left, double top, double side, double blurPx) {
        return seen(5, width, height, left, top, side, blurPx);
    }

    private static Detections seen(int id, int width, int height, double left, double top, double side,
            double blurPx) {
        MarkerObservation marker = new MarkerObservation(id, new double[] {left, top, left + side, top, left + side,
            top + side, left, top + side});
        return new Detections("frame", width, height, Collections.singletonList(marker), Collections.emptyList(),
                new PhotoLight(ToneCurve.SRGB, true, blurPx, 1, 100, 0));
    }

    private static Detections at(double left, double side, double blurPx) {
        return seen(1280, 720, left, 300, side, blurPx);
    }

    @BeforeEach
    void focusedOnAMarker() {
        watch.scanned(0);
        assertEquals(0, scansIn(40, at(600, 60, 0.7)));
    }

    /** How many of the next frames, all alike, ask for a scan. */
    private int scansIn(int frames, Detections each) {
        int scans = 0;
        for (int i = 0; i < frames; i++) {
            timeNs += FRAME_NS;
            scans += watch.isDue(each, timeNs) ? 1 : 0;
        }
        return scans;
    }

    @Test
    void anotherDistanceIsFocusedAnewAfterAFewFrames() {
        assertEquals(0, scansIn(20, at(600, 60 * 1.13, 0.7)));
        // five of them
        assertEquals(0, scansIn(4, at(594, 60 * 1.2, 0.7)));
        assertEquals(1, scansIn(1, at(594, 60 * 1.2, 0.7)));
        assertTrue(scansIn(10, at(604, 60 / 1.2, 0.7)) > 0);
    }

    /** 15 % are 15 % either way: as many times as large, or as small. */
    @Test
    void aSixthLargerIsAnotherDistance() {
        assertTrue(scansIn(10, at(595, 60 * 1.155, 0.7)) > 0);
        watch.scanned(timeNs);
        assertEquals(0, scansIn(40, at(600, 60, 0.7)));
        assertTrue(scansIn(10, at(604, 60 / 1.155, 0.7)) > 0);
    }

    @Test
    void framesThatShowItMustComeInARow() {
        for (int i = 0; i < 5; i++) {
            assertEquals(0, scansIn(4, at(594, 72, 0.7)));
            assertEquals(0, scansIn(1, at(600, 60, 0.7)));
        }
    }

    /** A hand that trembles by 10 px of 1280 holds still; the view of the whole cell moves by more. */
    @Test
    void aTremorIsStill() {
        int scans = 0;
        for (int i = 0; i < 10; i++) {
            scans += scansIn(1, at(i % 2 == 0 ? 589 : 599, 72, 0.7));
        }
        assertTrue(scans > 0);
    }

    @Test
    void otherMarkersAreAnotherViewAndOnesThatTakeTurnsAreNotStill() {
        assertTrue(scansIn(10, seen(7, 1280, 720, 600, 300, 60, 0.7)) > 0);
        watch.scanned(timeNs);
        assertEquals(0, scansIn(40, at(600, 60, 0.7)));
        for (int i = 0; i < 20; i++) {
            assertEquals(0, scansIn(1, seen(7 + i % 2, 1280, 720, 600, 300, 60, 0.7)));
        }
    }

    @Test
    void anotherPartOfTheCellIsFocusedAnew() {
        assertEquals(0, scansIn(20, at(300, 60, 0.7)));
        assertTrue(scansIn(10, at(200, 60, 0.7)) > 0);
    }

    @Test
    void markersThatGetLessSharpAreFocusedAnew() {
        assertEquals(0, scansIn(20, at(600, 60, 1.3)));
        assertTrue(scansIn(10, at(600, 60, 1.4)) > 0);
    }

    @Test
    void whileTheViewMovesNothingIsFocused() {
        for (int i = 0; i < 50; i++) {
            assertEquals(0, scansIn(1, at(600 - 14 * i, 90, 2)));
        }
    }

    @Test
    void afterAScanThereIsAPauseAndTheViewIsWhatItShowed() {
        watch.scanned(timeNs);
        assertEquals(0, scansIn(3, at(600, 60, 0.7)));
        // 2.9 s of the pause of 3 s
        assertEquals(0, scansIn(26, at(590, 80, 0.7)));
        assertEquals(1, scansIn(1, at(590, 80, 0.7)));
        watch.scanned(timeNs);
        assertEquals(0, scansIn(60, at(590, 80, 0.7)));
    }

    @Test
    void withoutMarkersOrAScanNothingIsKnown() {
        Detections nothing = new Detections("frame", 1280, 720, Collections.emptyList());
        assertEquals(0, scansIn(60, nothing));
        FocusWatch fresh = new FocusWatch();
        for (Detections d : Arrays.asList(at(600, 60, 0.7), at(600, 200, 5))) {
            assertFalse(fresh.isDue(d, timeNs));
        }
    }
}
