package org.cellgauge.vision;

import boofcv.struct.image.GrayU8;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/**
 * Which pixels of an image are dark, as the bits of numbers: 64 pixels of a row are looked at at once. About the image
 * lie pixels that are not dark: a row above, {@value #BELOW} below, and 64 pixels on each side. Not thread-safe.
 */
final class DarkBits {
    /** Rows below the image, so that a {@linkplain Specks#WINDOW window} from its last row on ends in them. */
    static final int BELOW = 8;
    private static final int IN_WORD = Long.SIZE;
    /** Times this, eight bytes of 0 or 1 have their bits in the uppermost byte, the first one's lowest. */
    private static final long TO_BITS = 0x0102_0408_1020_4080L;
    private static final int TO_UPPERMOST = 56;
    private static final long IN_EACH = 0x0101_0101_0101_0101L;
    private static final long ANOTHER_BIT_OF_EACH = 0x8040_2010_0804_0201L;
    private static final long UP_TO_SIGN = 0x7F7F_7F7F_7F7F_7F7FL;

    private int height;
    private int stride;
    private long[] words = new long[0];

    /** Takes the size of an image, no pixel of which is dark yet. */
    void reshape(int toWidth, int toHeight) {
        height = toHeight;
        stride = (toWidth + IN_WORD - 1) / IN_WORD + 2;
        int count = stride * (height + 1 + BELOW);
        if (words.length < count) {
            words = new long[count];
        } else {
            Arrays.fill(words, 0, count, 0);
        }
    }

    /** Numbers from a pixel to the one below it. */
    int stride() {
        return stride;
    }

    /** The numbers, that of pixel 0, 0 in the lowest bit of the one at {@link #indexOf}. */
    long[] words() {
        return words;
    }

    /** Where the number with a pixel is. */
    int indexOf(int x, int y) {
        return (y + 1) * stride + 1 + x / IN_WORD;
    }

    /** Where the pixels end that are in one number with a pixel. */
    int endOf(int x) {
        return (x / IN_WORD + 1) * IN_WORD;
    }

    /** The bits of eight pixels of 0 or 1 in a byte each, the first one lowest. */
    static long ofEight(long pixels) {
        return pixels * TO_BITS >>> TO_UPPERMOST;
    }

    /**
     * Whether any pixel is dark of a part that lies within one number of each row.
     *
     * @param left of the part
     * @param top of the part
     * @param size its width and height, less than 64, as far as the image goes
     */
    boolean isAnyDark(int left, int top, int size) {
        long any = 0;
        int end = Math.min(height, top + size);
        for (int y = top, at = indexOf(left, top); y < end; y++, at += stride) {
            any |= words[at];
        }
        return (any >>> left % IN_WORD & (1L << size) - 1) != 0;
    }

    /**
     * Writes a part as pixels of 0 and 1.
     *
     * @param left divisible by eight
     * @param top of the part
     * @param right where it ends
     * @param bottom where it ends
     * @param to an image of this size
     */
    void write(int left, int top, int right, int bottom, GrayU8 to) {
        ByteBuffer eight = ByteBuffer.wrap(to.data).order(ByteOrder.LITTLE_ENDIAN);
        for (int y = top; y < bottom; y++) {
            int at = to.startIndex + y * to.stride;
            Arrays.fill(to.data, at + left, at + right, (byte) 0);
            for (int x = left; x < right; x = endOf(x)) {
                long word = words[indexOf(x, y)] >>> x % IN_WORD;
                for (int u = x; word != 0 && u < right; u += Byte.SIZE, word >>>= Byte.SIZE) {
                    long spread = (word & 0xFF) * IN_EACH & ANOTHER_BIT_OF_EACH;
                    if (u + Byte.SIZE <= right) {
                        eight.putLong(at + u, spread + UP_TO_SIGN >>> Byte.SIZE - 1 & IN_EACH);
                    } else {
                        for (int k = 0; u + k < right; k++) {
                            to.data[at + u + k] = (byte) (word >>> k & 1);
                        }
                    }
                }
            }
        }
    }
}
