package org.cellgauge.android.state;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.File;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
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

    @Test
    void comesBackAsItWas() throws IOException {
        FrozenFrameFile.Frame written = frame(1);
        new FrozenFrameFile(folder.toFile()).write(written);
        FrozenFrameFile.Frame read = new FrozenFrameFile(folder.toFile()).read();
        assertEquals("frame-1.png", read.photo().name());
        assertArrayEquals(written.photo().luminance().luminance(), read.photo().luminance().luminance());
        assertEquals(written.orientation(), read.orientation());
    }

    @Test
    void whatIsSaidOfItsTonesComesBackToo() throws IOException {
        FrozenFrameFile file = new FrozenFrameFile(folder.toFile());
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
        FrozenFrameFile file = new FrozenFrameFile(folder.toFile());
        file.write(frame(1));
        file.write(frame(2));
        assertEquals("frame-2.png", file.read().photo().name());
    }

    @Test
    void everyDamageMakesItNone() throws IOException {
        FrozenFrameFile file = new FrozenFrameFile(folder.toFile());
        file.write(frame(1));
        File stored = folder.resolve("frozen-frame").toFile();
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
        FrozenFrameFile file = new FrozenFrameFile(folder.toFile());
        assertNull(file.read());
        file.write(frame(1));
        file.clear();
        assertNull(file.read());
    }

    @Test
    void folderThatCannotBeWrittenIsAnErrorAndNoHalfFile() {
        File missing = folder.resolve("missing").toFile();
        assertThrows(IOException.class, () -> new FrozenFrameFile(missing).write(frame(1)));
        assertNull(new FrozenFrameFile(missing).read());
    }
}
