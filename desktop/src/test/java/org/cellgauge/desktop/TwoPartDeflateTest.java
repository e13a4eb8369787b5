package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Random;
import java.util.zip.Deflater;
import java.util.zip.InflaterInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TwoPartDeflateTest {
    @ParameterizedTest
    @CsvSource({"0, 2", "1, 2", "2, 9", "3, 6", "1000, 1", "65535, 2", "65536, 5", "65537, 2", "1000000, 2"})
    void inflatesToWhatItWas(int length, int level) throws IOException {
        byte[] repetitive = repetitive(length);
        byte[] noise = new byte[length];
        new Random(2).nextBytes(noise);

        assertArrayEquals(repetitive, inflated(TwoPartDeflate.zlib(repetitive, level, Runnable::run)));
        assertArrayEquals(noise, inflated(TwoPartDeflate.zlib(noise, level, Runnable::run)));
    }

    @Test
    void isTheSameOnAnotherThread() {
        byte[] data = repetitive(300_000);

        assertArrayEquals(TwoPartDeflate.zlib(data, 2, Runnable::run),
                TwoPartDeflate.zlib(data, 2, task -> new Thread(task).start()));
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

        int two = TwoPartDeflate.zlib(data, 6, Runnable::run).length;

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
            byte[] actual = TwoPartDeflate.zlib(new byte[10], level, Runnable::run);

            assertEquals(expected[0], actual[0], "level " + level);
            assertEquals(expected[1], actual[1], "level " + level);
        }
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
