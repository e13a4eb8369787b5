package org.cellgauge.desktop;

import java.io.EOFException;
import java.io.IOException;
import java.util.zip.DataFormatException;
import org.cellgauge.vision.GreyImage;

/**
 * Reads Netpbm's grey and colour images, PGM and PPM, as text (P2, P3) or bytes (P5, P6): the first image of a file.
 * Values are shares of the largest one that the file states (pgm(5), ppm(5)).
 */
final class NetpbmImage {
    private static final int MAX_VALUE = 65_535;
    private static final int BYTE = 256;

    private final byte[] bytes;
    private final boolean colours;
    private final boolean text;
    private int at = 2;
    private final int widthPx;
    private final int heightPx;
    private final int largest;

    /**
     * Reads the head of an image.
     *
     * @param bytes the file; begins with P2, P3, P5 or P6
     * @throws IOException if it ends within the head
     * @throws DataFormatException if the head is none
     */
    NetpbmImage(byte[] bytes) throws IOException, DataFormatException {
        this.bytes = bytes;
        this.colours = bytes[1] == '3' || bytes[1] == '6';
        this.text = bytes[1] == '2' || bytes[1] == '3';
        this.widthPx = number();
        this.heightPx = number();
        this.largest = number();
        if (largest < 1 || largest > MAX_VALUE) {
            throw new DataFormatException("its largest value is " + largest + ", not from 1 to " + MAX_VALUE);
        }
        if (!text) {
            at++;
        }
    }

    int widthPx() {
        return widthPx;
    }

    int heightPx() {
        return heightPx;
    }

    /**
     * The pixels.
     *
     * @throws IOException if the file ends before the last of them
     * @throws DataFormatException if a value is none
     */
    GreyImage grey() throws IOException, DataFormatException {
        byte[] grey = new byte[widthPx * heightPx];
        double scale = 255.0 / largest;
        for (int i = 0; i < grey.length; i++) {
            double value = colours ? ImageFiles.luma(value(), value(), value()) : value();
            grey[i] = (byte) Math.round(scale * value);
        }
        return GreyImage.packed(grey, widthPx, heightPx);
    }

    private int value() throws IOException, DataFormatException {
        int value = text ? number() : largest < BYTE ? next() : next() * BYTE + next();
        if (value > largest) {
            throw new DataFormatException("a value of " + value + " is above the stated largest, " + largest);
        }
        return value;
    }

    private int next() throws EOFException {
        if (at >= bytes.length) {
            throw new EOFException();
        }
        return bytes[at++] & 0xFF;
    }

    /** A decimal number after blanks and comments. */
    private int number() throws IOException, DataFormatException {
        int c = next();
        while (c == '#' || Character.isWhitespace(c)) {
            if (c == '#') {
                while (c != '\n' && c != '\r') {
                    c = next();
                }
            } else {
                c = next();
            }
        }
        long number = 0;
        if (c < '0' || c > '9') {
            throw new DataFormatException("a number is missing");
        }
        while (c >= '0' && c <= '9') {
            number = Math.min(Integer.MAX_VALUE, 10 * number + c - '0');
            if (at == bytes.length) {
                return (int) number;
            }
            c = next();
        }
        at--;
        return (int) number;
    }
}
