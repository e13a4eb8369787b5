package org.cellgauge.desktop;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.cellgauge.vision.GreyImage;

/**
 * Reads what most photos of cameras for measuring are: PNG files of 8 bits of grey, without transparency, row by row
 * (ISO/IEC 15948). ImageIO reads these as well, but has Java's part of painting loaded for it, which takes longer than
 * anything else before a first photo is looked at. What is not quite such a file, damaged ones included, is left to
 * ImageIO, and so is what to say of it.
 */
final class PlainPng {
    private static final int HEAD_LENGTH = 13;
    private static final int FIRST_CHUNK = 8;
    /** Length and type before a chunk's data, checksum behind it. */
    private static final int BEFORE_DATA = 8;
    private static final int AROUND_DATA = 12;
    private static final int IHDR = 0x49484452;
    private static final int IDAT = 0x49444154;
    private static final int IEND = 0x49454E44;
    private static final int TRNS = 0x74524E53;
    /** Set in the type of a chunk that readers need not know. */
    private static final int ANCILLARY = 0x20000000;
    /** Bits, colour type, and the only compression, filters and order that are read here. */
    private static final byte[] GREY_OF_8_BITS = {8, 0, 0, 0, 0};

    private final byte[] bytes;
    private final int widthPx;
    private final int heightPx;
    private final int firstData;

    private PlainPng(byte[] bytes, int widthPx, int heightPx, int firstData) {
        this.bytes = bytes;
        this.widthPx = widthPx;
        this.heightPx = heightPx;
        this.firstData = firstData;
    }

    /**
     * Looks at the chunks of a file.
     *
     * @param bytes a file that begins as PNG files do
     * @return empty where it is none that is read here
     */
    static Optional<PlainPng> of(byte[] bytes) {
        ByteBuffer in = ByteBuffer.wrap(bytes);
        int head = FIRST_CHUNK + BEFORE_DATA;
        if (bytes.length < head + HEAD_LENGTH || in.getInt(FIRST_CHUNK) != HEAD_LENGTH
                || in.getInt(FIRST_CHUNK + 4) != IHDR || in.getInt(head) < 1 || in.getInt(head + 4) < 1
                || !in.slice(head + 8, GREY_OF_8_BITS.length).equals(ByteBuffer.wrap(GREY_OF_8_BITS))) {
            return Optional.empty();
        }
        int firstData = 0;
        int at = FIRST_CHUNK + AROUND_DATA + HEAD_LENGTH;
        int before = IHDR;
        while (isWhole(in, at)) {
            int type = in.getInt(at + 4);
            if (type == IEND) {
                return firstData == 0 ? Optional.empty()
                        : Optional.of(new PlainPng(bytes, in.getInt(head), in.getInt(head + 4), firstData));
            }
            boolean isData = type == IDAT && (firstData == 0 || before == IDAT);
            if (!isData && ((type & ANCILLARY) == 0 || type == TRNS)) {
                return Optional.empty();
            }
            firstData = isData && firstData == 0 ? at : firstData;
            before = type;
            at += AROUND_DATA + in.getInt(at);
        }
        return Optional.empty();
    }

    private static boolean isWhole(ByteBuffer in, int at) {
        return at <= in.limit() - AROUND_DATA && in.getInt(at) >= 0 && in.getInt(at) <= in.limit() - at - AROUND_DATA;
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
     * @return the image, in an array of its own; empty where the file is damaged
     */
    Optional<GreyImage> grey() {
        byte[] grey = new byte[widthPx * heightPx];
        byte[] row = new byte[1 + widthPx];
        Rows rows = new Rows();
        try {
            for (int start = 0; start < grey.length; start += widthPx) {
                if (!rows.next(row) || !unfiltered(row, grey, start)) {
                    return Optional.empty();
                }
            }
            return rows.isEnd() ? Optional.of(GreyImage.packed(grey, widthPx, heightPx)) : Optional.empty();
        } catch (DataFormatException e) {
            return Optional.empty();
        } finally {
            rows.inflater.end();
        }
    }

    /** Adds to a row what its filter took off (9.2), with nothing above the first row and left of the first pixel. */
    private boolean unfiltered(byte[] row, byte[] grey, int start) {
        if (start == 0 && row[0] > 1) {
            // as if a black row were above: these are the rare ones
            byte[] two = new byte[2 * widthPx];
            boolean isFilter = unfiltered(row, two, widthPx);
            System.arraycopy(two, widthPx, grey, 0, widthPx);
            return isFilter;
        }
        switch (row[0]) {
            case 0 -> System.arraycopy(row, 1, grey, start, widthPx);
            case 1 -> addLeft(row, grey, start);
            case 2 -> addAbove(row, grey, start);
            case 3 -> addMean(row, grey, start);
            case 4 -> addPaeth(row, grey, start);
            default -> {
                return false;
            }
        }
        return true;
    }

    private void addLeft(byte[] row, byte[] grey, int start) {
        int left = 0;
        for (int x = 0; x < widthPx; x++) {
            left += row[x + 1];
            grey[start + x] = (byte) left;
        }
    }

    private void addAbove(byte[] row, byte[] grey, int start) {
        for (int x = 0; x < widthPx; x++) {
            grey[start + x] = (byte) (row[x + 1] + grey[start + x - widthPx]);
        }
    }

    private void addMean(byte[] row, byte[] grey, int start) {
        int left = 0;
        for (int x = 0; x < widthPx; x++) {
            left = row[x + 1] + (left + (grey[start + x - widthPx] & 0xFF) >> 1) & 0xFF;
            grey[start + x] = (byte) left;
        }
    }

    /** Of left, above and above left, the one next to left + above - above left; in this order where they are alike. */
    private void addPaeth(byte[] row, byte[] grey, int start) {
        int left = 0;
        int aboveLeft = 0;
        for (int x = 0; x < widthPx; x++) {
            int above = grey[start + x - widthPx] & 0xFF;
            int toLeft = Math.abs(above - aboveLeft);
            int toAbove = Math.abs(left - aboveLeft);
            int toAboveLeft = Math.abs(left + above - 2 * aboveLeft);
            int next = toLeft <= toAbove && toLeft <= toAboveLeft ? left : toAbove <= toAboveLeft ? above : aboveLeft;
            left = row[x + 1] + next & 0xFF;
            grey[start + x] = (byte) left;
            aboveLeft = above;
        }
    }

    /** The rows as they are stored, out of all the chunks of data. */
    private final class Rows {
        private final ByteBuffer in = ByteBuffer.wrap(bytes);
        private final Inflater inflater = new Inflater();
        private int chunk = firstData;

        /** Fills a row; false where there is no more of it. */
        boolean next(byte[] row) throws DataFormatException {
            int filled = 0;
            while (filled < row.length) {
                int more = inflater.inflate(row, filled, row.length - filled);
                if (more == 0 && !feed()) {
                    return false;
                }
                filled += more;
            }
            return true;
        }

        /** Whether nothing but the checksum is behind the last row, and that is right. */
        boolean isEnd() throws DataFormatException {
            byte[] beyond = new byte[1];
            while (!inflater.finished()) {
                int more = inflater.inflate(beyond);
                if (more > 0 || !inflater.finished() && !feed()) {
                    return false;
                }
            }
            return true;
        }

        private boolean feed() {
            if (!inflater.needsInput() || inflater.finished() || in.getInt(chunk + 4) != IDAT) {
                return false;
            }
            int length = in.getInt(chunk);
            inflater.setInput(bytes, chunk + BEFORE_DATA, length);
            chunk += AROUND_DATA + length;
            return true;
        }
    }
}
