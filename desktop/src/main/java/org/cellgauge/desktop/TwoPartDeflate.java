package org.cellgauge.desktop;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import java.util.zip.Adler32;
import java.util.zip.Deflater;

/**
 * Rows of bytes in the zlib format (RFC 1950), deflated (RFC 1951) in two halves at a time. The second half knows the
 * end of the first, so that next to nothing is lost; where the two meet lies an empty block, which ends on a byte. A
 * thread asks for one row after another, so that they need not all be there at a time.
 */
final class TwoPartDeflate {
    /** Deflate, with a window of 32 kB. */
    private static final int METHOD_AND_WINDOW = 0x78;
    private static final int WINDOW = 1 << 15;
    /** The two bytes of the head are divisible by this. */
    private static final int HEAD_CHECK = 31;
    /** Both parts of a check sum are modulo this. */
    private static final int ADLER_BASE = 65521;
    private static final int LEAST_ROOM = 1 << 10;

    private final int rowLength;
    private final Supplier<Rows> each;
    private final int level;

    private TwoPartDeflate(int rowLength, Supplier<Rows> rows, int level) {
        this.rowLength = rowLength;
        this.each = rows;
        this.level = level;
    }

    /** Where rows come from. */
    interface Rows {
        /**
         * Puts a row into an array.
         *
         * @param number of the row, from 0
         * @param into an array of a row's length
         */
        void put(int number, byte[] into);
    }

    /**
     * Deflates.
     *
     * @param count how many rows there are
     * @param rowLength their length, bytes, positive
     * @param rows gives where they come from, to each of two threads its own
     * @param level zlib's, 1 to 9
     * @param besides runs one half; the result is the same on whatever thread
     * @return the rows as a zlib stream
     */
    static byte[] zlib(int count, int rowLength, Supplier<Rows> rows, int level, Executor besides) {
        TwoPartDeflate deflate = new TwoPartDeflate(rowLength, rows, level);
        int middle = count / 2;
        CompletableFuture<Half> later = CompletableFuture.supplyAsync(() -> deflate.half(middle, count, true), besides);
        Half first = deflate.half(0, middle, false);
        Half second = later.join();
        ByteBuffer all = ByteBuffer.allocate(2 + first.bytes.remaining() + second.bytes.remaining() + 4);
        // how hard was tried, of which readers make nothing
        int head = METHOD_AND_WINDOW << 8 | (level == 1 ? 0 : level < 6 ? 1 : level == 6 ? 2 : 3) << 6;
        all.putShort((short) (head + HEAD_CHECK - head % HEAD_CHECK));
        long length = (long) (count - middle) * rowLength;
        return all.put(first.bytes).put(second.bytes).putInt(combined(first.sum, second.sum, length)).array();
    }

    /** What became of half of the rows, and their check sum. */
    private record Half(ByteBuffer bytes, long sum) {
    }

    private Half half(int from, int to, boolean isLast) {
        Deflater deflater = new Deflater(level, true);
        Adler32 sum = new Adler32();
        Rows rows = each.get();
        byte[] row = new byte[rowLength];
        byte[] out = new byte[(int) Math.min(Integer.MAX_VALUE / 2, LEAST_ROOM + (long) (to - from) * rowLength / 4)];
        int count = 0;
        try {
            learn(deflater, rows, from);
            for (int y = from; y < to; y++) {
                rows.put(y, row);
                sum.update(row);
                deflater.setInput(row);
                while (!deflater.needsInput()) {
                    out = out.length - count < LEAST_ROOM ? Arrays.copyOf(out, 2 * out.length) : out;
                    count += deflater.deflate(out, count, out.length - count);
                }
            }
            if (isLast) {
                deflater.finish();
            }
            boolean isAll = false;
            while (!isAll) {
                out = out.length - count < LEAST_ROOM ? Arrays.copyOf(out, 2 * out.length) : out;
                count += deflater.deflate(out, count, out.length - count,
                        isLast ? Deflater.NO_FLUSH : Deflater.SYNC_FLUSH);
                isAll = count < out.length;
            }
            return new Half(ByteBuffer.wrap(out, 0, count), sum.getValue());
        } finally {
            deflater.end();
        }
    }

    /** Tells what lies before a row. */
    private void learn(Deflater deflater, Rows rows, int before) {
        int known = Math.min(before, (WINDOW + rowLength - 1) / rowLength);
        if (known > 0) {
            byte[] row = new byte[rowLength];
            ByteBuffer all = ByteBuffer.allocate(known * rowLength);
            for (int y = before - known; y < before; y++) {
                rows.put(y, row);
                all.put(row);
            }
            int most = Math.min(WINDOW, all.capacity());
            deflater.setDictionary(all.array(), all.capacity() - most, most);
        }
    }

    /** The check sum of two parts (RFC 1950, 9) by those of each; the second one is as long. */
    private static int combined(long first, long second, long length) {
        long ofBytes = (first & 0xFFFF) + (second & 0xFFFF) - 1 + ADLER_BASE;
        long ofSums = (first >>> 16) + (second >>> 16) + length % ADLER_BASE * ((first & 0xFFFF) - 1 + ADLER_BASE);
        return (int) (ofSums % ADLER_BASE << 16 | ofBytes % ADLER_BASE);
    }
}
