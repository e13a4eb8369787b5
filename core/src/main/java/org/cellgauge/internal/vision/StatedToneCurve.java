package org.cellgauge.internal.vision;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.InflaterInputStream;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.IccToneCurve;

/**
 * What an image file says of its tone curve, in the notes that stand beside its pixels.
 *
 * <p>Formats: W3C, "Portable Network Graphics (PNG) Specification (Third Edition)", 11.3.2 (iCCP before sRGB before
 * gAMA); ITU-T T.81 (JPEG), Annex B; ICC.1:2022, B.4 (profiles in JPEG files); CIPA DC-008 (Exif 2.32), 4.6.5
 * (ColorSpace, Gamma); TIFF 6.0, section 2.
 *
 * <p>Image libraries read all of a file's metadata, makers' private notes included, and believe the lengths it claims;
 * what is wanted here is three tags and a curve. Every length is bounded, and whatever is damaged counts as not said:
 * it must not keep anyone from the pixels.
 */
public final class StatedToneCurve {
    private static final long PNG = 0x89504E47L;
    private static final int JPEG = 0xFFD8;
    private static final int BMP = 0x424D;
    private static final long GIF = 0x47494638L;
    private static final long TIFF_LITTLE = 0x49492A00L;
    private static final long TIFF_BIG = 0x4D4D002AL;
    private static final int LITTLE_ENDIAN = 0x4949;
    private static final int MAX_PROFILE_BYTES = 4 << 20;
    private static final int MAX_PARTS = 1000;

    private static final long CHUNK_SRGB = 0x73524742L;
    private static final long CHUNK_GAMMA = 0x67414D41L;
    private static final long CHUNK_PROFILE = 0x69434350L;
    private static final long CHUNK_PIXELS = 0x49444154L;
    private static final long CHUNK_END = 0x49454E44L;
    private static final double GAMMA_UNIT = 100_000;

    private static final int START_OF_SCAN = 0xDA;
    private static final int END_OF_IMAGE = 0xD9;
    private static final int APP1 = 0xE1;
    private static final int APP2 = 0xE2;
    private static final byte[] EXIF = "Exif\0\0".getBytes(StandardCharsets.ISO_8859_1);
    private static final byte[] ICC = "ICC_PROFILE\0".getBytes(StandardCharsets.ISO_8859_1);

    private static final int TAG_EXIF = 0x8769;
    private static final int TAG_PROFILE = 0x8773;
    private static final int TAG_COLOUR_SPACE = 0xA001;
    private static final int TAG_GAMMA = 0xA500;
    private static final int COLOUR_SPACE_SRGB = 1;
    private static final int COLOUR_SPACE_ADOBE = 2;
    private static final double ADOBE_GAMMA = 2.2;

    private final Source source;
    private final byte[] value = new byte[4];
    private boolean littleEndian;
    private long at;

    private StatedToneCurve(Source source) {
        this.source = source;
    }

    /** Bytes of a file, wherever they are. */
    @FunctionalInterface
    public interface Source {
        /**
         * Reads bytes.
         *
         * @param position of the first one, from 0
         * @param into is filled
         * @throws IOException if they cannot be read, or the file ends before
         */
        void read(long position, byte[] into) throws IOException;
    }

    /**
     * The curve that a file states.
     *
     * @param file the file
     * @return the curve; sRGB for JPEG, BMP and GIF files that say nothing, since nothing else is stored so by custom;
     *     null where nothing is said, or nothing that can be read
     */
    public static ToneCurve of(Source file) {
        try {
            StatedToneCurve reader = new StatedToneCurve(file);
            long first = reader.unsigned(4);
            if (first == PNG) {
                return reader.ofPng();
            }
            if (first >> 16 == JPEG) {
                ToneCurve stated = reader.ofJpeg();
                return stated == null ? ToneCurve.SRGB : stated;
            }
            if (first == TIFF_LITTLE || first == TIFF_BIG) {
                return reader.ofTiff();
            }
            return first >> 16 == BMP || first == GIF ? ToneCurve.SRGB : null;
        } catch (IOException | RuntimeException e) {
            return null;
        }
    }

    /**
     * The curve that a file states.
     *
     * @param file all of its bytes
     * @return as {@link #of(Source)}
     */
    public static ToneCurve of(byte[] file) {
        return of(inMemory(file));
    }

    private static Source inMemory(byte[] bytes) {
        return (position, into) -> {
            if (position < 0 || position > bytes.length - into.length) {
                throw new EOFException("the file ends before");
            }
            System.arraycopy(bytes, (int) position, into, 0, into.length);
        };
    }

    // ---- PNG

    private ToneCurve ofPng() throws IOException {
        ToneCurve ofProfile = null;
        ToneCurve ofGamma = null;
        boolean srgb = false;
        long chunk = 8;
        for (int i = 0; i < MAX_PARTS; i++) {
            at = chunk;
            long length = unsigned(4);
            long type = unsigned(4);
            if (type == CHUNK_PIXELS || type == CHUNK_END) {
                break;
            }
            if (type == CHUNK_SRGB) {
                srgb = true;
            } else if (type == CHUNK_GAMMA) {
                ofGamma = IccToneCurve.gamma(GAMMA_UNIT / unsigned(4));
            } else if (type == CHUNK_PROFILE) {
                ofProfile = profileOfPng(bytes(length));
            }
            chunk += 12 + length;
        }
        return ofProfile != null ? ofProfile : srgb ? ToneCurve.SRGB : ofGamma;
    }

    /** Name, end of the name, method 0, compressed profile. */
    private static ToneCurve profileOfPng(byte[] chunk) {
        int end = 0;
        while (end < chunk.length - 2 && chunk[end] != 0) {
            end++;
        }
        ToneCurve curve = null;
        try (InputStream profile = new InflaterInputStream(new ByteArrayInputStream(chunk, end + 2,
                chunk.length - end - 2))) {
            curve = profile(bounded(profile));
        } catch (IOException | RuntimeException e) {
            // its name may still say it
        }
        // the curve before the name: there are profiles named "sRGB linear"
        return curve == null && new String(chunk, 0, end, StandardCharsets.ISO_8859_1).startsWith("sRGB")
                ? ToneCurve.SRGB : curve;
    }

    private static byte[] bounded(InputStream in) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        byte[] buffer = new byte[8192];
        int n = in.read(buffer);
        while (n >= 0 && out.size() < MAX_PROFILE_BYTES) {
            out.write(buffer, 0, n);
            n = in.read(buffer);
        }
        return out.toByteArray();
    }

    // ---- JPEG

    private ToneCurve ofJpeg() {
        ToneCurve ofExif = null;
        Map<Integer, byte[]> parts = new TreeMap<>();
        try {
            long segment = 2;
            for (int i = 0; i < MAX_PARTS; i++) {
                at = segment;
                long marker = unsigned(2);
                if (marker == 0xFFFF) {
                    segment++;       // fill bytes
                    continue;
                }
                if (marker >> 8 != 0xFF || (marker & 0xFF) == START_OF_SCAN || (marker & 0xFF) == END_OF_IMAGE) {
                    break;
                }
                long length = unsigned(2);
                if (marker == (0xFF00 | APP1) && ofExif == null) {
                    byte[] data = bytes(length - 2);
                    ofExif = startsWith(data, EXIF) ? ofExif(Arrays.copyOfRange(data, EXIF.length, data.length)) : null;
                } else if (marker == (0xFF00 | APP2)) {
                    byte[] data = bytes(length - 2);
                    if (startsWith(data, ICC)) {
                        // its number, from 1, and how many there are
                        parts.put(data[ICC.length] & 0xFF, Arrays.copyOfRange(data, ICC.length + 2, data.length));
                    }
                }
                segment += 2 + length;
            }
        } catch (IOException | RuntimeException e) {
            // what came before it still holds
        }
        ByteArrayOutputStream whole = new ByteArrayOutputStream();
        for (byte[] part : parts.values()) {
            whole.write(part, 0, part.length);
        }
        ToneCurve ofProfile = profile(whole.toByteArray());
        return ofProfile != null ? ofProfile : ofExif;
    }

    private static boolean startsWith(byte[] data, byte[] begin) {
        return data.length > begin.length + 2 && Arrays.equals(Arrays.copyOf(data, begin.length), begin);
    }

    private static ToneCurve ofExif(byte[] tiff) {
        try {
            return new StatedToneCurve(inMemory(tiff)).ofTiff();
        } catch (IOException | RuntimeException e) {
            return null;
        }
    }

    private static ToneCurve profile(byte[] icc) {
        try {
            return IccToneCurve.of(icc);
        } catch (RuntimeException e) {
            return null;
        }
    }

    // ---- TIFF, and Exif, which has its structure

    private ToneCurve ofTiff() throws IOException {
        at = 0;
        littleEndian = unsigned(2) == LITTLE_ENDIAN;
        at = 4;
        Tags tags = new Tags();
        directory(unsigned(4), tags);
        if (tags.exif > 0) {
            directory(tags.exif, tags);
        }
        if (tags.profile != null) {
            return tags.profile;
        }
        if (tags.colourSpace == COLOUR_SPACE_SRGB) {
            return ToneCurve.SRGB;
        }
        if (tags.gamma != null) {
            return tags.gamma;
        }
        return tags.colourSpace == COLOUR_SPACE_ADOBE ? IccToneCurve.gamma(ADOBE_GAMMA) : null;
    }

    /** What a file's directories say. */
    private static final class Tags {
        private long exif;
        private long colourSpace;
        private ToneCurve gamma;
        private ToneCurve profile;
    }

    private void directory(long offset, Tags tags) throws IOException {
        at = offset;
        long count = Math.min(unsigned(2), MAX_PARTS);
        for (int i = 0; i < count; i++) {
            at = offset + 2 + 12L * i;
            int tag = (int) unsigned(2);
            at += 2;        // the type: each of these tags has one
            long length = unsigned(4);
            switch (tag) {
                case TAG_EXIF:
                    tags.exif = unsigned(4);
                    break;
                case TAG_COLOUR_SPACE:
                    tags.colourSpace = unsigned(2);
                    break;
                case TAG_GAMMA:
                    at = unsigned(4);
                    double numerator = unsigned(4);
                    tags.gamma = IccToneCurve.gamma(numerator / unsigned(4));
                    break;
                case TAG_PROFILE:
                    at = unsigned(4);
                    tags.profile = profile(bytes(length));
                    break;
                default:
                    // nothing about tones
            }
        }
    }

    // ---- numbers

    private long unsigned(int bytes) throws IOException {
        byte[] raw = bytes == value.length ? value : new byte[bytes];
        source.read(at, raw);
        at += bytes;
        long number = 0;
        for (int i = 0; i < bytes; i++) {
            number = number << 8 | raw[littleEndian ? bytes - 1 - i : i] & 0xFF;
        }
        return number;
    }

    private byte[] bytes(long length) throws IOException {
        if (length < 0 || length > MAX_PROFILE_BYTES) {
            throw new IOException(length + " bytes are no note about tones");
        }
        byte[] bytes = new byte[(int) length];
        source.read(at, bytes);
        at += length;
        return bytes;
    }
}
