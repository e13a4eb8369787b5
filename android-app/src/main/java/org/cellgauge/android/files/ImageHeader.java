package org.cellgauge.android.files;

import java.util.zip.CRC32;
import org.cellgauge.cell.InputRefusedException;

/**
 * What a PNG or JPEG file says of itself before it is decoded, and whether all of it is there. Android's decoder makes
 * a picture of half a file without a word, with the rest of it grey or black.
 */
final class ImageHeader {
    private static final int[] PNG = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    private static final int PNG_CHUNK_FRAME = 12;
    private static final int TYPE_IEND = 0x49454E44;
    private static final int CRITICAL_BIT = 0x20000000;
    private static final int CMYK_COMPONENTS = 4;

    private ImageHeader() {
    }

    /**
     * Refuses what is no whole PNG or JPEG file.
     *
     * @param file its bytes
     * @param name its name, for messages
     * @throws InputRefusedException if it is empty, of another format, cut short, damaged or in CMYK colours
     */
    static void judge(byte[] file, String name) {
        if (file.length == 0) {
            throw new InputRefusedException(name, FileRefusal.EMPTY);
        }
        if (isPng(file)) {
            judgePng(file, name);
        } else if (u8(file, 0) == 0xFF && u8(file, 1) == 0xD8) {
            judgeJpeg(file, name);
        } else {
            throw new InputRefusedException(name, other(file));
        }
    }

    private static boolean isPng(byte[] file) {
        for (int i = 0; i < PNG.length; i++) {
            if (u8(file, i) != PNG[i]) {
                return false;
            }
        }
        return true;
    }

    private static FileRefusal other(byte[] file) {
        String begin = new String(file, 0, Math.min(file.length, 12), java.nio.charset.StandardCharsets.ISO_8859_1);
        if (begin.startsWith("GIF8") || begin.startsWith("BM") || begin.startsWith("RIFF") || begin.startsWith("II*\0")
                || begin.startsWith("MM\0*")) {
            return FileRefusal.OTHER_FORMAT;
        }
        if (begin.indexOf("ftyp") == 4) {
            return FileRefusal.HEIC;
        }
        return FileRefusal.UNKNOWN_FORMAT;
    }

    private static void judgePng(byte[] file, String name) {
        int at = PNG.length;
        CRC32 crc = new CRC32();
        while (true) {
            long length = u32(file, at, name);
            int type = (int) u32(file, at + 4, name);
            if (length > file.length - (long) at - PNG_CHUNK_FRAME) {
                throw cutShort(name);
            }
            int end = at + 8 + (int) length;
            // other chunks hold remarks, which are not used
            if ((type & CRITICAL_BIT) == 0) {
                crc.reset();
                crc.update(file, at + 4, (int) length + 4);
                if (crc.getValue() != u32(file, end, name)) {
                    throw new InputRefusedException(name, FileRefusal.DAMAGED);
                }
            }
            if (type == TYPE_IEND) {
                return;
            }
            at = end + 4;
        }
    }

    private static void judgeJpeg(byte[] file, String name) {
        int at = 2;
        while (true) {
            // markers may be filled up with any number of 0xFF before them
            while (u8(file, at) == 0xFF && u8(file, at + 1) == 0xFF) {
                at++;
            }
            if (at + 1 >= file.length) {
                throw cutShort(name);
            }
            if (u8(file, at) != 0xFF) {
                throw new InputRefusedException(name, FileRefusal.DAMAGED_JPEG);
            }
            int marker = u8(file, at + 1);
            at += 2;
            if (marker == 0xD9) {
                return;
            }
            if (marker == 0x01 || marker >= 0xD0 && marker <= 0xD8) {
                continue;
            }
            if (at + 2 > file.length) {
                throw cutShort(name);
            }
            int length = u8(file, at) << 8 | u8(file, at + 1);
            if (length < 2 || at + length > file.length) {
                throw cutShort(name);
            }
            boolean frame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
            if (frame && u8(file, at + 7) == CMYK_COMPONENTS) {
                throw new InputRefusedException(name, FileRefusal.CMYK);
            }
            at += length;
            if (marker == 0xDA) {
                at = afterScan(file, at);
            }
        }
    }

    /** Where the coded pixels of a scan end: at the next marker that is no restart and no stuffed byte. */
    private static int afterScan(byte[] file, int from) {
        int at = from;
        while (at + 1 < file.length) {
            if (u8(file, at) == 0xFF) {
                int next = u8(file, at + 1);
                if (next != 0 && !(next >= 0xD0 && next <= 0xD7) && next != 0xFF) {
                    return at;
                }
            }
            at++;
        }
        return file.length;
    }

    /** A byte, or -1 behind the end. */
    private static int u8(byte[] file, int at) {
        return at < file.length ? file[at] & 0xFF : -1;
    }

    private static long u32(byte[] file, int at, String name) {
        if (at + 4 > file.length) {
            throw cutShort(name);
        }
        return (long) u8(file, at) << 24 | u8(file, at + 1) << 16 | u8(file, at + 2) << 8 | u8(file, at + 3);
    }

    private static InputRefusedException cutShort(String name) {
        return new InputRefusedException(name, FileRefusal.CUT_SHORT);
    }
}
