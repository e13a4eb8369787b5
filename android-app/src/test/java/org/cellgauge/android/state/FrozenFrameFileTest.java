package org.cellgauge.android.state;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.cellgauge.android.files.Photo;
import org.cellgauge.internal.overlay.ImageOrientation;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.GreyImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A frozen frame outlives the process, and a damaged one is none. */
class FrozenFrameFileTest {
    @TempDir
    private Path folder;

    private static FrozenFrameFile.Frame frame(int seed) {
        byte[] grey = new byte[7 * 5];
        new Random(seed).nextBytes(grey);
        return new FrozenFrameFile.Frame(new Photo("frame-" + seed + ".png", GreyImage.packed(grey, 7, 5)),
                ImageOrientation.of(3, true));
    }

    private FrozenFrameFile file(String id) {
        return new FrozenFrameFile(folder.toFile(), id);
    }

    @Test
    void comesBackAsItWas() throws IOException {
        FrozenFrameFile.Frame written = frame(1);
        file("a").write(written);
        FrozenFrameFile.Frame read = file("a").read();
        assertEquals("frame-1.png", read.photo().name());
        assertArrayEquals(written.photo().luminance().luminance(), read.photo().luminance().luminance());
        assertEquals(written.orientation(), read.orientation());
    }

    @Test
    void whatIsSaidOfItsTonesComesBackToo() throws IOException {
        FrozenFrameFile file = file("a");
        file.write(frame(1));
        assertNull(file.read().photo().luminance().toneCurve());
        for (ToneCurve curve : new ToneCurve[] {ToneCurve.SRGB, ToneCurve.gamma(1.8)}) {
            GreyImage image = frame(1).photo().luminance().withToneCurve(curve);
            file.write(new FrozenFrameFile.Frame(new Photo("frame.png", image), ImageOrientation.of(0, false)));
            assertEquals(curve.words(), file.read().photo().luminance().toneCurve().words());
        }
    }

    @Test
    void newestReplacesTheOneBefore() throws IOException {
        FrozenFrameFile file = file("a");
        file.write(frame(1));
        file.write(frame(2));
        assertEquals("frame-2.png", file.read().photo().name());
    }

    @Test
    void everyDamageMakesItNone() throws IOException {
        FrozenFrameFile file = file("a");
        file.write(frame(1));
        File stored = folder.resolve("frozen-frame-a").toFile();
        byte[] whole = Files.readAllBytes(stored.toPath());
        for (int length = 0; length < whole.length; length++) {
            Files.write(stored.toPath(), Arrays.copyOf(whole, length));
            assertNull(file.read(), "cut after " + length + " bytes");
        }
        Files.write(stored.toPath(), whole);
        assertNotNull(file.read());
        try (RandomAccessFile damaged = new RandomAccessFile(stored, "rw")) {
            damaged.write(0);
        }
        assertNull(file.read());
    }

    @Test
    void noneWithoutOneAndNoneAfterItWasCleared() throws IOException {
        FrozenFrameFile file = file("a");
        assertNull(file.read());
        file.write(frame(1));
        file.clear();
        assertNull(file.read());
    }

    @Test
    void folderThatCannotBeWrittenIsAnErrorAndNoHalfFile() {
        File missing = folder.resolve("missing").toFile();
        assertThrows(IOException.class, () -> new FrozenFrameFile(missing, "a").write(frame(1)));
        assertNull(new FrozenFrameFile(missing, "a").read());
    }

    @Test
    void screensHaveFilesOfTheirOwn() throws IOException {
        file("a").write(frame(1));
        file("b").write(frame(2));
        assertEquals("frame-1.png", file("a").read().photo().name());
        assertEquals("frame-2.png", file("b").read().photo().name());
        file("a").clear();
        assertNull(file("a").read());
        assertEquals("frame-2.png", file("b").read().photo().name());
        assertNotEquals(FrozenFrameFile.newId(), FrozenFrameFile.newId());
        assertEquals("frame-1.png", written(file(FrozenFrameFile.newId())).read().photo().name());
        assertThrows(IllegalArgumentException.class, () -> file("../elsewhere"));
    }

    private static FrozenFrameFile written(FrozenFrameFile file) throws IOException {
        file.write(frame(1));
        return file;
    }

    @Test
    void leftoversGoAfterAWeekOrWhereThereAreMany() throws IOException {
        long now = 1_700_000_000_000L;
        long day = TimeUnit.DAYS.toMillis(1);
        // of versions that had one file for all screens
        Files.write(folder.resolve("frozen-frame"), new byte[1]);
        assertTrue(folder.resolve("frozen-frame").toFile().setLastModified(now - 8 * day));
        assertTrue(written(file("a"), now - 30 * day).exists());
        File recent = written(file("b"), now - 6 * day);
        File old = written(file("c"), now - 8 * day);
        file("a").clearLeftovers(now);
        assertNotNull(file("a").read(), "its own is kept, however old");
        assertTrue(recent.exists());
        assertFalse(old.exists());
        assertFalse(folder.resolve("frozen-frame").toFile().exists());
        for (int i = 0; i < 9; i++) {
            written(file("d" + i), now - i * 1000);
        }
        file("a").clearLeftovers(now);
        assertNotNull(file("d7").read());
        assertNull(file("d8").read());
        assertNull(file("b").read());
    }

    private File written(FrozenFrameFile file, long atMs) throws IOException {
        written(file);
        File stored = folder.resolve("frozen-frame-" + file.id()).toFile();
        assertTrue(stored.setLastModified(atMs));
        return stored;
    }
}
