package org.cellgauge.android.state;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;

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
        Photo photo = frames.choose(key);
        assertEquals("frame 20", photo.name());
        for (int i = 0; i < 10; i++) {
            keep(100 + i);
        }
        assertArrayEquals(grey(20), photo.luminance().luminance());
        assertEquals("gamma 1.2", photo.luminance().toneCurve().words());
        assertSame(photo, frames.choose(key), "asked again, the same");
    }

    /** Eight frames of 12 million pixels would be half of what an app may have. */
    @Test
    void ofLargeFramesFewAreKept() {
        RecentFrames large = new RecentFrames(8);
        GreyImage image = GreyImage.packed(new byte[12_000_000], 4000, 3000);
        Detections[] found = new Detections[3];
        for (int i = 0; i < found.length; i++) {
            found[i] = new Detections("frame " + i, 4000, 3000, Collections.emptyList());
            large.keep(found[i], image);
        }
        assertNull(large.choose(found[0]));
        assertEquals("frame 1", large.choose(found[1]).name());
        assertEquals("frame 2", large.choose(found[2]).name());
    }

    @Test
    void anotherFrameCanBeChosenAndTheFirstStaysWhole() {
        Detections first = keep(10);
        Photo before = frames.choose(first);
        Detections second = keep(20);
        Photo after = frames.choose(second);
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
        assertNull(frames.choose(old));
    }

    @Test
    void noneChosenIsNone() {
        keep(10);
        assertNull(frames.choose(null));
    }
}
