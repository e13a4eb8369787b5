package org.cellgauge.desktop;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.zip.Adler32;
import java.util.zip.Deflater;

/**
 * Bytes in the zlib format (RFC 1950), deflated (RFC 1951) in two halves at a time. The second half knows the end of
 * the first, so that next to nothing is lost; where the two meet lies an empty block, which ends on a byte.
 */
final class TwoPartDeflate {
    /** Deflate, with a window of 32 kB. */
    private static final int METHOD_AND_WINDOW = 0x78;
    private static final int WINDOW = 1 << 15;
    /** The two bytes of the head are divisible by this. */
    private static final int HEAD_CHECK = 31;

    private TwoPartDeflate() {
    }

    /**
     * Deflates.
     *
     * @param data what is to be deflated
     * @param level zlib's, 1 to 9
     * @param besides runs one half; the result is the same on whatever thread
     * @return data as a zlib stream
     */
    static byte[] zlib(byte[] data, int level, Executor besides) {
        int middle = data.length / 2;
        CompletableFuture<ByteBuffer> second = CompletableFuture.supplyAsync(
                () -> half(data, middle, data.length, level, true), besides);
        ByteBuffer first = half(data, 0, middle, level, false);
        Adler32 check = new Adler32();
        check.update(data);
        ByteBuffer rest = second.join();
        ByteBuffer all = ByteBuffer.allocate(2 + first.remaining() + rest.remaining() + 4);
        // how hard was tried, of which readers make nothing
        int head = METHOD_AND_WINDOW << 8 | (level == 1 ? 0 : level < 6 ? 1 : level == 6 ? 2 : 3) << 6;
        all.putShort((short) (head + HEAD_CHECK - head % HEAD_CHECK));
        return all.put(first).put(rest).putInt((int) check.getValue()).array();
    }

    private static ByteBuffer half(byte[] data, int from, int to, int level, boolean isLast) {
        Deflater deflater = new Deflater(level, true);
        try {
            int known = Math.min(from, WINDOW);
            if (known > 0) {
                deflater.setDictionary(data, from - known, known);
            }
            deflater.setInput(data, from, to - from);
            if (isLast) {
                deflater.finish();
            }
            byte[] out = new byte[(to - from) / 2 + 64];
            int count = 0;
            while (true) {
                int written = deflater.deflate(out, count, out.length - count,
                        isLast ? Deflater.NO_FLUSH : Deflater.SYNC_FLUSH);
                count += written;
                if (count < out.length) {
                    return ByteBuffer.wrap(out, 0, count);
                }
                out = Arrays.copyOf(out, 2 * out.length);
            }
        } finally {
            deflater.end();
        }
    }
}
