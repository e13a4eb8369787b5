package org.cellgauge.android.screen;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import boofcv.concurrency.BoofConcurrency;
import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.cellgauge.android.R;
import org.cellgauge.android.device.ThermalLevel;
import org.cellgauge.android.files.Photo;
import org.cellgauge.android.state.Detectors;
import org.cellgauge.cell.Cell;
import org.cellgauge.live.LiveState;
import org.cellgauge.vision.MarkerDetector;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.annotation.Config;

/** What happens where the memory gets short, and what the app does not take of it. */
@RunWith(RobolectricTestRunner.class)
@Config(application = TestApp.class, qualifiers = Screen.TABLET_LANDSCAPE, minSdk = 27)
public class MemoryTest {
    private static final Fixture FIXTURE = Fixture.LIFTED;
    private static final Detectors TOO_LARGE = (cell, frames) -> (image, name) -> {
        throw new OutOfMemoryError("Failed to allocate a 2073616 byte allocation with 1048576 free bytes");
    };

    private static Screen live() {
        return Screen.live(FIXTURE.document(), 90, false);
    }

    // ---- it does not suffice

    @Test
    public void frameThatTheMemoryIsTooSmallForSaysWhatToDoAndTheAppGoesOn() {
        boolean[] enough = new boolean[1];
        Screen.app().detectors = (cell, frames) -> (enough[0] ? Detectors.OF_LIBRARY : TOO_LARGE).of(cell, frames);
        try (Screen screen = live()) {
            Screen.app().feed.frame(FIXTURE.image());
            screen.settle();
            assertEquals("Not enough memory", screen.text(R.id.banner_headline));
            assertEquals("The memory of this device does not suffice for the check. Close other apps, then choose the "
                    + "cell again; if that does not help, restart the device.", screen.text(R.id.reason));
            enough[0] = true;
            screen.chooseCell(FIXTURE.document());
            Screen.app().feed.opened(FIXTURE.cell().camera(), 90, false);
            screen.holdStillUntilResult(FIXTURE);
            assertEquals("Pass – target met", screen.text(R.id.banner_headline));
        }
    }

    @Test
    @Config(qualifiers = "de-" + Screen.TABLET_LANDSCAPE)
    public void frameThatTheMemoryIsTooSmallForSaysSoInGerman() {
        Screen.app().detectors = TOO_LARGE;
        try (Screen screen = live()) {
            Screen.app().feed.frame(FIXTURE.image());
            screen.settle();
            assertEquals("Zu wenig Speicher", screen.text(R.id.banner_headline));
            assertTrue(screen.text(R.id.reason), screen.text(R.id.reason).contains("Andere Apps schließen"));
        }
    }

    @Test
    public void photoThatTheMemoryIsTooSmallForIsRefused() {
        Screen.app().detectors = TOO_LARGE;
        try (Screen screen = Screen.start()) {
            screen.chooseCell(FIXTURE.document());
            screen.openPhoto(FIXTURE.photo());
            assertEquals("The photo was refused", screen.text(R.id.message_title));
            assertTrue(screen.text(R.id.message_text), screen.text(R.id.message_text).contains("take a smaller one"));
        }
    }

    @Test
    public void photoOrCellThatCannotBeReadForWantOfMemoryIsRefused() {
        try (Screen screen = Screen.start()) {
            Screen.app().library.cells.put("content://cells/large", () -> {
                throw new OutOfMemoryError();
            });
            screen.session().chooseCell("content://cells/large");
            screen.settle();
            assertTrue(screen.text(R.id.message_text), screen.text(R.id.message_text).contains("Close other apps"));
            screen.chooseCell(FIXTURE.document());
            Screen.app().library.photos.put("content://photos/large", () -> {
                throw new OutOfMemoryError();
            });
            screen.session().openPhoto("content://photos/large");
            screen.settle();
            assertEquals("The photo was refused", screen.text(R.id.message_title));
            assertTrue(screen.text(R.id.message_text), screen.text(R.id.message_text).contains("scale it down"));
        }
    }

    // ---- one detector

    /** The library's detectors; what is left of earlier ones when another is made is counted. */
    private static final class Counted implements Detectors {
        private final List<WeakReference<MarkerDetector>> made = new ArrayList<>();
        private int mostLeft;

        @Override
        public MarkerDetector of(Cell cell, boolean frames) {
            mostLeft = Math.max(mostLeft, left());
            MarkerDetector detector = Detectors.OF_LIBRARY.of(cell, frames);
            made.add(new WeakReference<>(detector));
            return detector;
        }

        int left() {
            // the collector may take its time
            for (int i = 0; i < 10 && count() > 0; i++) {
                System.gc();
            }
            return count();
        }

        private int count() {
            int left = 0;
            for (WeakReference<MarkerDetector> each : made) {
                left += each.get() == null ? 0 : 1;
            }
            return left;
        }
    }

    @Test
    public void aDetectorIsGoneBeforeTheNextIsMade() {
        Counted counted = new Counted();
        Screen.app().detectors = counted;
        Screen.app().levels.onNext(ThermalLevel.HOT);
        try (Screen screen = live()) {
            Screen.app().feed.frame(FIXTURE.image());
            screen.until("figures", () -> screen.state().phase() == LiveState.Phase.QUICK_LOOK);
            Photo photo = FIXTURE.photo();
            screen.openPhoto(photo);
            screen.until("quick look", () -> screen.state().phase() == LiveState.Phase.QUICK_LOOK
                    && screen.state().still() == photo);
            // a photo's is needed for that photo alone
            assertEquals(0, counted.left());
            Screen.app().levels.onNext(ThermalLevel.NORMAL);
            screen.until("result", () -> screen.state().verdict() != null);
            screen.chooseCell(FIXTURE.document());
            Screen.app().feed.opened(FIXTURE.cell().camera(), 90, false);
            Screen.app().feed.frame(FIXTURE.image());
            screen.until("figures", () -> screen.state().live() != null);
            assertEquals(1, counted.left());
            screen.openPhoto(photo);
            assertEquals(5, counted.made.size());
            assertEquals(0, counted.mostLeft);
        }
    }

    // ---- one thread

    private static Set<String> threads() {
        Set<String> names = new TreeSet<>();
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            names.add(thread.getName());
        }
        return names;
    }

    @Test
    @Config(minSdk = 26)
    public void framesAreSearchedOnTheThreadThatBringsThem() {
        Set<String> before = threads();
        try (Screen screen = live()) {
            Screen.app().feed.frame(FIXTURE.image());
            screen.until("figures", () -> screen.state().live() != null);
            assertFalse(BoofConcurrency.USE_CONCURRENT);
            for (String name : threads()) {
                assertTrue(name, before.contains(name) || !name.startsWith("ForkJoinPool"));
            }
        }
    }
}
