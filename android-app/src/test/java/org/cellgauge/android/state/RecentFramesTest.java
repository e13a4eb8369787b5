package org.cellgauge.android.state;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Collections;
import org.cellgauge.android.files.Photo;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;
import org.junit.jupiter.api.Test;

/** The pixels of the frame that figures belong to, out of arrays that are used again and again. */
class RecentFramesTest {
    private final RecentFrames frames = new RecentFrames(3);

    private static Detections detections(String name) {
        return new Detections(name, 4, 2, Collections.emptyList());
    }

    /** A frame full of one grey value, in an array with room around it, as cameras have. */
    private Detections keep(int grey) {
        Detections found = detections("frame " + grey);
        byte[] padded = new byte[1 + 2 * 6];
        Arrays.fill(padded, (byte) 255);
        for (int y = 0; y < 2; y++) {
            Arrays.fill(padded, 1 + 6 * y, 1 + 6 * y + 4, (byte) grey);
        }
        frames.keep(found, GreyImage.wrap(padded, 1, 6, 4, 2).withToneCurve(ToneCurve.gamma(1 + grey / 100.0)));
        Arrays.fill(padded, (byte) 0);
        return found;
    }

    private static byte[] grey(int value) {
        byte[] expected = new byte[8];
        Arrays.fill(expected, (byte) value);
        return expected;
    }

    @Test
    void chosenFrameKeepsItsPixelsWhateverComes() {
        keep(10);
        Detections key = keep(20);
        keep(30);
        Photo photo = frames.take(key);
        assertEquals("frame 20", photo.name());
        for (int i = 0; i < 10; i++) {
            keep(100 + i);
        }
        assertArrayEquals(grey(20), photo.luminance().luminance());
        assertEquals("gamma 1.2", photo.luminance().toneCurve().words());
        assertSame(photo, frames.take(key), "asked again, the same");
    }

    /** Eight frames of 12 million pixels would be half of what an app may have. */
    @Test
    void ofLargeFramesFewAreKept() {
        RecentFrames large = new RecentFrames(8);
        GreyImage image = GreyImage.packed(new byte[12_000_000], 4000, 3000);
        Detections[] found = new Detections[4];
        for (int i = 0; i < found.length; i++) {
            found[i] = new Detections("frame " + i, 4000, 3000, Collections.emptyList());
            large.keep(found[i], image);
        }
        assertNull(large.take(found[0]));
        assertEquals("frame 2", large.take(found[2]).name());
        assertEquals("frame 3", large.take(found[3]).name());
    }

    @Test
    void anotherFrameCanBeChosenAndTheFirstStaysWhole() {
        Detections first = keep(10);
        Photo before = frames.take(first);
        Detections second = keep(20);
        Photo after = frames.take(second);
        keep(30);
        keep(40);
        keep(50);
        assertArrayEquals(grey(10), before.luminance().luminance());
        assertArrayEquals(grey(20), after.luminance().luminance());
    }

    @Test
    void frameThatIsTooOldIsNotReplacedByAnother() {
        Detections old = keep(10);
        keep(20);
        keep(30);
        keep(40);
        keep(50);
        assertNull(frames.take(old));
    }

    @Test
    void chosenFrameStaysUntilAnotherIsChosen() {
        Detections key = keep(10);
        frames.choose(key);
        for (int i = 0; i < 10; i++) {
            keep(100 + i);
        }
        assertArrayEquals(grey(10), frames.take(key).luminance().luminance());
        Detections other = keep(20);
        frames.choose(other);
        frames.choose(keep(30));
        for (int i = 0; i < 4; i++) {
            keep(100 + i);
        }
        assertNull(frames.take(other));
    }

    @Test
    void framesThatNobodyTakesNeedNoNewArrays() {
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        GreyImage image = GreyImage.packed(new byte[1920 * 1080], 1920, 1080);
        Detections[] found = new Detections[30];
        Arrays.setAll(found, i -> new Detections("frame " + i, 1920, 1080, Collections.emptyList()));
        RecentFrames moving = new RecentFrames(8);
        long before = 0;
        for (int i = 0; i < found.length; i++) {
            if (i == 10) {
                before = threads.getThreadAllocatedBytes(Thread.currentThread().getId());
            }
            moving.keep(found[i], image);
            moving.choose(found[i]);
        }
        long bytes = threads.getThreadAllocatedBytes(Thread.currentThread().getId()) - before;
        // one frame is two million
        assertTrue(bytes < 10_000, bytes + " bytes");
    }

    @Test
    void noneTakenIsNone() {
        keep(10);
        assertNull(frames.take(null));
    }
}
