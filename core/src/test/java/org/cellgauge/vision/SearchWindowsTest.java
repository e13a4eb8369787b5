package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class SearchWindowsTest {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 720;

    private final SearchWindows windows = new SearchWindows();

    private static double[] square(double left, double top, double side) {
        return new double[] {left, top, left + side, top, left + side, top + side, left, top + side};
    }

    /** A frame with one marker. */
    private void frame(int id, double left, double top, double side) {
        windows.begin(WIDTH, HEIGHT);
        windows.see(id, square(left, top, side));
        windows.keep(id, square(left, top, side), true);
        windows.end();
    }

    private void assertShows(int window, double left, double top, double right, double bottom) {
        assertTrue(windows.left(window) <= left && windows.top(window) <= top && windows.right(window) >= right
                && windows.bottom(window) >= bottom, "window " + window);
    }

    private int area() {
        int area = 0;
        for (int i = 0; i < windows.count(); i++) {
            area += (windows.right(i) - windows.left(i)) * (windows.bottom(i) - windows.top(i));
        }
        return area;
    }

    @Test
    void aWindowReachesAsFarAsTheMarkerMayHaveMoved() {
        frame(1, 600, 300, 32);
        windows.begin(WIDTH, HEIGHT);
        assertEquals(1, windows.count());
        assertShows(0, 600 - 16, 300 - 16, 632 + 16, 332 + 16);
        assertTrue(area() < 120 * 120);
        frame(1, 560, 300, 32);
        windows.begin(WIDTH, HEIGHT);
        assertFalse(windows.areWhole());
        assertShows(0, 560 - 76, 300 - 16, 592 + 76, 332 + 16);
        assertTrue(windows.bottom(0) < 332 + 50);
    }

    @Test
    void windowsEndWithTheImage() {
        windows.begin(WIDTH, HEIGHT);
        windows.keep(1, square(3, 690, 20), true);
        windows.keep(2, square(1255, 5, 20), true);
        windows.end();
        windows.begin(WIDTH, HEIGHT);
        assertEquals(2, windows.count());
        for (int i = 0; i < 2; i++) {
            assertTrue(windows.left(i) >= 0 && windows.top(i) >= 0 && windows.right(i) <= WIDTH
                    && windows.bottom(i) <= HEIGHT);
        }
    }

    /** In a row each would touch the next; the last one comes first, so that the window in the middle joins two. */
    @Test
    void windowsDoNotTouch() {
        windows.begin(WIDTH, HEIGHT);
        windows.keep(1, square(100, 100, 20), true);
        windows.keep(2, square(240, 100, 20), true);
        windows.keep(3, square(170, 100, 20), true);
        windows.keep(4, square(700, 500, 20), true);
        windows.end();
        windows.begin(WIDTH, HEIGHT);
        assertEquals(2, windows.count());
        int joined = windows.left(0) < 500 ? 0 : 1;
        assertShows(joined, 100 - 16, 100 - 16, 260 + 16, 120 + 16);
        assertShows(1 - joined, 700 - 16, 500 - 16, 720 + 16, 520 + 16);
    }

    @Test
    void moreThanHalfOfTheImageIsAllOfIt() {
        frame(1, 100, 100, 500);
        windows.begin(WIDTH, HEIGHT);
        assertTrue(windows.areWhole());
    }

    @Test
    void everyTenthFrameIsSearchedAsAWhole() {
        for (int i = 0; i < 40; i++) {
            frame(1, 600 + i, 300, 32);
            assertEquals(i % 10 == 0, windows.areWhole(), "frame " + i);
        }
    }

    @Test
    void ofTwoThatReadTheSameEachIsAskedFor() {
        windows.begin(WIDTH, HEIGHT);
        windows.keep(1, square(100, 100, 20), true);
        windows.keep(1, square(700, 500, 20), true);
        // the inner edge of the second
        windows.keep(1, square(702, 502, 16), true);
        windows.end();
        assertEquals(2, windows.markers());
        windows.begin(WIDTH, HEIGHT);
        windows.see(1, square(705, 503, 20));
        windows.see(1, square(706, 504, 16));
        assertTrue(windows.missMarkers());
        windows.see(1, square(102, 101, 20));
        assertFalse(windows.missMarkers());
    }

    /** What the search took for a marker, and the light did not, has a window; a frame without it is a frame. */
    @Test
    void whatIsNoMarkerIsNotAskedFor() {
        windows.begin(WIDTH, HEIGHT);
        windows.keep(1, square(100, 100, 20), true);
        windows.keep(2, square(700, 500, 20), false);
        windows.end();
        windows.begin(WIDTH, HEIGHT);
        assertEquals(2, windows.count());
        windows.see(1, square(100, 100, 20));
        assertFalse(windows.missMarkers());
    }

    /** A marker near the limit of blur is seen now and then: it goes on as it went, and is waited for. */
    @Test
    void aMissingMarkerIsWaitedForWhereItWouldBe() {
        for (int i = 0; i < 3; i++) {
            windows.begin(WIDTH, HEIGHT);
            windows.keep(1, square(100, 100, 20), true);
            windows.keep(2, square(400 + 30 * i, 500, 20), true);
            windows.end();
        }
        for (int i = 3; i < 6; i++) {
            frame(1, 100, 100, 20);
        }
        windows.begin(WIDTH, HEIGHT);
        assertEquals(2, windows.count());
        int missing = windows.top(0) > 300 ? 0 : 1;
        assertShows(missing, 400 + 30 * 6 - 16, 500, 420 + 30 * 6 + 16, 520);
        for (int i = 7; i < 14; i++) {
            frame(1, 100, 100, 20);
        }
        windows.begin(WIDTH, HEIGHT);
        assertFalse(windows.areWhole());
        assertEquals(1, windows.count());
    }
}
