package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.DataBufferByte;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import java.util.Random;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import javax.imageio.ImageIO;
import org.cellgauge.vision.GreyImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PlainPngTest {
    private static final int WIDTH = 37;
    private static final int HEIGHT = 29;
    private static final byte[] GREY = {8, 0, 0, 0, 0};

    /** Rows of any bytes are rows of some picture: ImageIO says of which. */
    @ParameterizedTest
    @CsvSource({"0, 1", "1, 1", "2, 1", "3, 1", "4, 1", "-1, 1", "-1, 3", "-1, 40"})
    void pixelsAreThoseOfImageIo(int filter, int chunks) throws IOException {
        byte[] rows = rows(filter);
        byte[] file = file(GREY, chunks, deflated(rows), "tEXt", "IDAT", "tIME");

        GreyImage read = PlainPng.of(file).flatMap(PlainPng::grey).orElseThrow();

        assertEquals(WIDTH, read.widthPx());
        assertEquals(HEIGHT, read.heightPx());
        assertArrayEquals(((DataBufferByte) ImageIO.read(new ByteArrayInputStream(file)).getRaster().getDataBuffer())
                .getData(), read.luminance());
    }

    @ParameterizedTest
    @CsvSource({"8, 2, 0", "16, 0, 0", "4, 0, 0", "8, 3, 0", "8, 4, 0", "8, 0, 1"})
    void othersAreLeftToImageIo(byte bits, byte colourType, byte interlaced) throws IOException {
        byte[] head = {bits, colourType, 0, 0, interlaced};
        assertTrue(PlainPng.of(file(head, 1, deflated(rows(0)), "IDAT")).isEmpty());
    }

    @Test
    void oddChunksAreLeftToImageIo() throws IOException {
        byte[] data = deflated(rows(0));
        assertTrue(PlainPng.of(file(GREY, 1, data, "IDAT")).isPresent());
        assertTrue(PlainPng.of(file(GREY, 1, data, "tRNS", "IDAT")).isEmpty());
        assertTrue(PlainPng.of(file(GREY, 1, data, "PLTE", "IDAT")).isEmpty());
        assertTrue(PlainPng.of(file(GREY, 1, data, "IDAT", "tEXt", "IDAT")).isEmpty());
        assertTrue(PlainPng.of(file(GREY, 1, data)).isEmpty());
    }

    @Test
    void damagedFilesAreLeftToImageIo() throws IOException {
        byte[] rows = rows(-1);
        byte[] file = file(GREY, 2, deflated(rows), "IDAT");
        for (int length = 8; length < file.length; length++) {
            assertTrue(read(Arrays.copyOf(file, length)).isEmpty(), "cut short at " + length);
        }
        byte[] unknownFilter = rows.clone();
        unknownFilter[5 * (WIDTH + 1)] = 5;
        assertTrue(read(file(GREY, 1, deflated(unknownFilter), "IDAT")).isEmpty());
        assertTrue(read(file(GREY, 1, deflated(Arrays.copyOf(rows, rows.length - 1)), "IDAT")).isEmpty());
        assertTrue(read(file(GREY, 1, deflated(Arrays.copyOf(rows, rows.length + 1)), "IDAT")).isEmpty());
        byte[] otherSum = deflated(rows);
        otherSum[otherSum.length - 1]++;
        assertTrue(read(file(GREY, 1, otherSum, "IDAT")).isEmpty());
    }

    private static Optional<GreyImage> read(byte[] file) {
        return PlainPng.of(file).flatMap(PlainPng::grey);
    }

    /** Rows of a filter, or, where it is negative, of each in turn. */
    private static byte[] rows(int filter) {
        byte[] rows = new byte[HEIGHT * (WIDTH + 1)];
        new Random(filter).nextBytes(rows);
        for (int y = 0; y < HEIGHT; y++) {
            rows[y * (WIDTH + 1)] = (byte) (filter < 0 ? (y + 4) % 5 : filter);
        }
        return rows;
    }

    private static byte[] deflated(byte[] rows) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (DeflaterOutputStream deflater = new DeflaterOutputStream(out, new Deflater(9))) {
            deflater.write(rows);
        }
        return out.toByteArray();
    }

    /** A file of chunks of these types, between head and end; data go into as many chunks as told. */
    private static byte[] file(byte[] kind, int chunks, byte[] data, String... types) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeLong(0x89504E470D0A1A0AL);
        chunk(out, "IHDR", ByteBuffer.allocate(13).putInt(WIDTH).putInt(HEIGHT).put(kind).array());
        for (String type : types) {
            if (type.equals("IDAT")) {
                int length = data.length / chunks + 1;
                for (int at = 0; at < data.length; at += length) {
                    chunk(out, type, Arrays.copyOfRange(data, at, Math.min(at + length, data.length)));
                }
            } else {
                chunk(out, type, new byte[7]);
            }
        }
        chunk(out, "IEND", new byte[0]);
        return bytes.toByteArray();
    }

    private static void chunk(DataOutputStream out, String type, byte[] data) throws IOException {
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 sum = new CRC32();
        sum.update(name);
        sum.update(data);
        out.writeInt(data.length);
        out.write(name);
        out.write(data);
        out.writeInt((int) sum.getValue());
    }
}
