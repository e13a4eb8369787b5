package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Random;
import java.util.concurrent.Executor;
import java.util.zip.Deflater;
import java.util.zip.InflaterInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TwoPartDeflateTest {
    @ParameterizedTest
    @CsvSource({"0, 1, 2", "1, 1, 2", "2, 1, 9", "3, 1, 6", "10, 100, 1", "7, 32768, 2", "7, 32769, 5", "1, 65537, 2",
        "2, 70000, 3", "1000, 1000, 2"})
    void inflatesToWhatItWas(int rows, int rowLength, int level) throws IOException {
        int length = rows * rowLength;
        byte[] repetitive = repetitive(length);
        byte[] noise = new byte[length];
        new Random(2).nextBytes(noise);

        assertArrayEquals(repetitive, inflated(zlib(repetitive, rowLength, level, Runnable::run)));
        assertArrayEquals(noise, inflated(zlib(noise, rowLength, level, Runnable::run)));
    }

    @Test
    void isTheSameOnAnotherThread() {
        byte[] data = repetitive(300_000);

        assertArrayEquals(zlib(data, 1000, 2, Runnable::run),
                zlib(data, 1000, 2, task -> new Thread(task).start()));
    }

    /** Against zlib in one piece: the second half finds in the first what it repeats. */
    @Test
    void losesNextToNothing() {
        // one half that repeats nothing within itself, twice, as far apart as the window reaches
        byte[] half = new byte[30_000];
        new Random(3).nextBytes(half);
        byte[] data = new byte[2 * half.length];
        System.arraycopy(half, 0, data, 0, half.length);
        System.arraycopy(half, 0, data, half.length, half.length);
        Deflater whole = new Deflater(6);
        whole.setInput(data);
        whole.finish();
        int usual = whole.deflate(new byte[data.length]);
        whole.end();

        int two = zlib(data, 3000, 6, Runnable::run).length;

        assertTrue(usual < 1.1 * half.length, "bytes in one piece: " + usual);
        assertTrue(two < usual + 100, "bytes in two: " + two + ", in one piece: " + usual);
    }

    @Test
    void headIsZlibs() {
        for (int level = 1; level <= 9; level++) {
            Deflater usual = new Deflater(level);
            usual.setInput(new byte[10]);
            usual.finish();
            byte[] expected = new byte[100];
            usual.deflate(expected);
            usual.end();
            byte[] actual = zlib(new byte[10], 5, level, Runnable::run);

            assertEquals(expected[0], actual[0], "level " + level);
            assertEquals(expected[1], actual[1], "level " + level);
        }
    }

    private static byte[] zlib(byte[] data, int rowLength, int level, Executor besides) {
        return TwoPartDeflate.zlib(data.length / rowLength, rowLength,
                () -> (y, into) -> System.arraycopy(data, y * rowLength, into, 0, rowLength), level, besides);
    }

    private static byte[] repetitive(int length) {
        byte[] data = new byte[length];
        Random random = new Random(1);
        for (int i = 0; i < length; i++) {
            data[i] = (byte) (i > 100 && random.nextInt(10) > 0 ? data[i - 97] : random.nextInt());
        }
        return data;
    }

    private static byte[] inflated(byte[] zlib) throws IOException {
        try (InflaterInputStream in = new InflaterInputStream(new ByteArrayInputStream(zlib))) {
            return in.readAllBytes();
        }
    }
}
