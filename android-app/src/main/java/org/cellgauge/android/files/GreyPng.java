package org.cellgauge.android.files;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.GreyImage;

/**
 * Writes grey pictures as PNG files of 8 bits per pixel, without loss. Android's own encoder knows colour only and
 * would make them three times as large.
 *
 * <p>Format: W3C, "Portable Network Graphics (PNG) Specification (Third Edition)", chunks IHDR, sRGB or gAMA where the
 * picture's tone curve is known, IDAT and IEND; every row is stored as differences from the one above (filter "Up").
 */
final class GreyPng {
    private static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    private static final byte BITS = 8;
    private static final byte GREY = 0;
    private static final byte FILTER_UP = 2;
    private static final int HEADER_BYTES = 13;
    private static final byte PERCEPTUAL = 0;
    private static final double GAMMA_UNIT = 100_000;

    private GreyPng() {
    }

    /**
     * Encodes a picture.
     *
     * @param image the picture
     * @return the bytes of the file
     */
    static byte[] encode(GreyImage image) {
        int width = image.widthPx();
        int height = image.heightPx();
        ByteArrayOutputStream out = new ByteArrayOutputStream(width * height / 2 + 1024);
        out.write(SIGNATURE, 0, SIGNATURE.length);
        byte[] header = new byte[HEADER_BYTES];
        putInt(header, 0, width);
        putInt(header, 4, height);
        header[8] = BITS;
        header[9] = GREY;
        chunk(out, "IHDR", header);
        toneCurve(out, image.toneCurve());
        chunk(out, "IDAT", pixels(image));
        chunk(out, "IEND", new byte[0]);
        return out.toByteArray();
    }

    /** What the command line must start from when it makes the figures again. */
    private static void toneCurve(ByteArrayOutputStream out, ToneCurve toneCurve) {
        if (toneCurve == ToneCurve.SRGB) {
            chunk(out, "sRGB", new byte[] {PERCEPTUAL});
        } else if (toneCurve != null) {
            byte[] gamma = new byte[4];
            // one over the gamma at middle grey: that of a power
            putInt(gamma, 0, (int) Math.round(GAMMA_UNIT * Math.log(toneCurve.grey(0.5)) / Math.log(0.5)));
            chunk(out, "gAMA", gamma);
        }
    }

    private static byte[] pixels(GreyImage image) {
        int width = image.widthPx();
        ByteArrayOutputStream out = new ByteArrayOutputStream(width * image.heightPx() / 2 + 1024);
        Deflater deflater = new Deflater(Deflater.DEFAULT_COMPRESSION);
        byte[] luminance = image.luminance();
        byte[] row = new byte[width + 1];
        row[0] = FILTER_UP;
        try (DeflaterOutputStream rows = new DeflaterOutputStream(out, deflater, 1 << 14)) {
            for (int y = 0; y < image.heightPx(); y++) {
                int at = image.offset() + y * image.rowStride();
                for (int x = 0; x < width; x++) {
                    int above = y == 0 ? 0 : luminance[at - image.rowStride() + x];
                    row[x + 1] = (byte) (luminance[at + x] - above);
                }
                rows.write(row, 0, row.length);
            }
        } catch (IOException e) {
            throw new IllegalStateException("writing into memory cannot fail", e);
        } finally {
            deflater.end();
        }
        return out.toByteArray();
    }

    private static void chunk(ByteArrayOutputStream out, String type, byte[] data) {
        byte[] typeAndData = new byte[4 + data.length];
        for (int i = 0; i < 4; i++) {
            typeAndData[i] = (byte) type.charAt(i);
        }
        System.arraycopy(data, 0, typeAndData, 4, data.length);
        CRC32 crc = new CRC32();
        crc.update(typeAndData, 0, typeAndData.length);
        byte[] number = new byte[4];
        putInt(number, 0, data.length);
        out.write(number, 0, number.length);
        out.write(typeAndData, 0, typeAndData.length);
        putInt(number, 0, (int) crc.getValue());
        out.write(number, 0, number.length);
    }

    private static void putInt(byte[] to, int at, int value) {
        to[at] = (byte) (value >>> 24);
        to[at + 1] = (byte) (value >>> 16);
        to[at + 2] = (byte) (value >>> 8);
        to[at + 3] = (byte) value;
    }
}
