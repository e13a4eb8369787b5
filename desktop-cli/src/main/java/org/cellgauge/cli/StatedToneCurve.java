package org.cellgauge.cli;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.zip.InflaterInputStream;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.cellgauge.light.ToneCurve;

/**
 * What an image file says of its tone curve, in what stands before its pixels.
 *
 * <p>Formats: W3C, "Portable Network Graphics (PNG) Specification (Third Edition)", 11.3.2 (iCCP before sRGB before
 * gAMA); ITU-T T.81 (JPEG), Annex B; ICC.1:2022, B.4 (profiles in JPEG files); CIPA DC-008 (Exif 2.32), 4.6.5
 * (ColorSpace, Gamma); TIFF 6.0, section 2.
 *
 * <p>Image libraries read all of a file's metadata, makers' private notes included, and believe the lengths it claims;
 * what is wanted here is three tags and a curve. Every length is bounded, and whatever is damaged counts as not said:
 * it must not keep anyone from the pixels.
 */
final class StatedToneCurve {
    private static final int PNG = 0x89504E47;
    private static final int JPEG = 0xFFD8;
    private static final int BMP = 0x424D;
    private static final int GIF = 0x47494638;
    private static final int TIFF_LITTLE = 0x49492A00;
    private static final int TIFF_BIG = 0x4D4D002A;
    private static final int MAX_PROFILE_BYTES = 4 << 20;
    private static final int MAX_PARTS = 1000;

    private static final int CHUNK_SRGB = 0x73524742;
    private static final int CHUNK_GAMMA = 0x67414D41;
    private static final int CHUNK_PROFILE = 0x69434350;
    private static final int CHUNK_PIXELS = 0x49444154;
    private static final int CHUNK_END = 0x49454E44;
    private static final int MAX_PROFILE_NAME = 79;

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
    private static final int TYPE_SHORT = 3;
    private static final int TYPE_RATIONAL = 5;
    private static final int COLOUR_SPACE_SRGB = 1;
    private static final int COLOUR_SPACE_ADOBE = 2;
    private static final double ADOBE_GAMMA = 2.2;

    private final ImageInputStream in;

    private StatedToneCurve(ImageInputStream in) {
        this.in = in;
    }

    /**
     * The curve that a file states.
     *
     * @param in the file from its beginning, where it stands again afterwards
     * @return the curve; sRGB for JPEG, BMP and GIF files that say nothing, since nothing else is stored so by custom;
     *     null where nothing is said, or nothing that can be read
     * @throws IOException if the stream cannot be brought back to its beginning
     */
    static ToneCurve of(ImageInputStream in) throws IOException {
        ByteOrder order = in.getByteOrder();
        try {
            in.setByteOrder(ByteOrder.BIG_ENDIAN);
            int first = in.readInt();
            StatedToneCurve file = new StatedToneCurve(in);
            if (first == PNG) {
                return file.ofPng();
            }
            if (first >>> 16 == JPEG) {
                ToneCurve stated = file.ofJpeg();
                return stated == null ? ToneCurve.SRGB : stated;
            }
            if (first == TIFF_LITTLE || first == TIFF_BIG) {
                return file.ofTiff();
            }
            return first >>> 16 == BMP || first == GIF ? ToneCurve.SRGB : null;
        } catch (IOException | RuntimeException e) {
            return null;
        } finally {
            in.setByteOrder(order);
            in.seek(0);
        }
    }

    // ---- PNG

    private ToneCurve ofPng() throws IOException {
        ToneCurve ofProfile = null;
        ToneCurve ofGamma = null;
        boolean srgb = false;
        long at = 8;
        for (int i = 0; i < MAX_PARTS; i++) {
            in.seek(at);
            long length = in.readUnsignedInt();
            int type = in.readInt();
            if (type == CHUNK_PIXELS || type == CHUNK_END) {
                break;
            }
            if (type == CHUNK_SRGB) {
                srgb = true;
            } else if (type == CHUNK_GAMMA) {
                ofGamma = IccToneCurve.gamma(100_000.0 / in.readUnsignedInt());
            } else if (type == CHUNK_PROFILE && length <= MAX_PROFILE_BYTES) {
                ofProfile = profileOfPng(bytes((int) length));
            }
            at += 12 + length;
        }
        return ofProfile != null ? ofProfile : srgb ? ToneCurve.SRGB : ofGamma;
    }

    /** Name, end of the name, method 0, compressed profile. */
    private static ToneCurve profileOfPng(byte[] chunk) {
        int end = 0;
        while (chunk[end] != 0 && end <= MAX_PROFILE_NAME) {
            end++;
        }
        ToneCurve curve = null;
        try (InflaterInputStream profile = new InflaterInputStream(new ByteArrayInputStream(chunk, end + 2,
                chunk.length - end - 2))) {
            curve = IccToneCurve.of(profile.readNBytes(MAX_PROFILE_BYTES));
        } catch (IOException | RuntimeException e) {
            // its name may still say it
        }
        // the curve before the name: there are profiles named "linear sRGB"
        return curve == null && new String(chunk, 0, end, StandardCharsets.ISO_8859_1).startsWith("sRGB")
                ? ToneCurve.SRGB : curve;
    }

    // ---- JPEG

    private ToneCurve ofJpeg() throws IOException {
        ToneCurve ofExif = null;
        SortedMap<Integer, byte[]> profile = new TreeMap<>();
        try {
            long at = 2;
            for (int i = 0; i < MAX_PARTS; i++) {
                in.seek(at);
                if (in.readUnsignedByte() != 0xFF) {
                    break;
                }
                int marker = in.readUnsignedByte();
                if (marker == 0xFF) {
                    at++;       // fill bytes
                    continue;
                }
                if (marker == START_OF_SCAN || marker == END_OF_IMAGE) {
                    break;
                }
                int length = in.readUnsignedShort();
                if (marker == APP1 || marker == APP2) {
                    byte[] data = bytes(length - 2);
                    if (marker == APP1 && startsWith(data, EXIF) && ofExif == null) {
                        ofExif = ofExif(Arrays.copyOfRange(data, EXIF.length, data.length));
                    } else if (marker == APP2 && startsWith(data, ICC)) {
                        // its number, from 1, and how many there are
                        profile.put(data[ICC.length] & 0xFF, Arrays.copyOfRange(data, ICC.length + 2, data.length));
                    }
                }
                at += 2 + length;
            }
        } catch (IOException | RuntimeException e) {
            // what came before it still holds
        }
        ToneCurve ofProfile = null;
        if (!profile.isEmpty()) {
            ByteArrayOutputStream whole = new ByteArrayOutputStream();
            profile.values().forEach(whole::writeBytes);
            ofProfile = profile(whole.toByteArray());
        }
        return ofProfile != null ? ofProfile : ofExif;
    }

    private static boolean startsWith(byte[] data, byte[] begin) {
        return data.length > begin.length + 2 && Arrays.equals(data, 0, begin.length, begin, 0, begin.length);
    }

    private static ToneCurve ofExif(byte[] tiff) {
        try (ImageInputStream data = new MemoryCacheImageInputStream(new ByteArrayInputStream(tiff))) {
            return new StatedToneCurve(data).ofTiff();
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
        in.seek(0);
        in.setByteOrder(in.readUnsignedShort() == 0x4949 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        in.seek(4);
        Tags tags = new Tags();
        directory(in.readUnsignedInt(), tags);
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
        private int colourSpace;
        private ToneCurve gamma;
        private ToneCurve profile;
    }

    private void directory(long offset, Tags tags) throws IOException {
        in.seek(offset);
        int count = Math.min(in.readUnsignedShort(), MAX_PARTS);
        for (int i = 0; i < count; i++) {
            in.seek(offset + 2 + 12L * i);
            int tag = in.readUnsignedShort();
            int type = in.readUnsignedShort();
            long length = in.readUnsignedInt();
            switch (tag) {
                case TAG_EXIF -> tags.exif = in.readUnsignedInt();
                case TAG_COLOUR_SPACE -> {
                    if (type == TYPE_SHORT) {
                        tags.colourSpace = in.readUnsignedShort();
                    }
                }
                case TAG_GAMMA -> {
                    if (type == TYPE_RATIONAL) {
                        in.seek(in.readUnsignedInt());
                        tags.gamma = IccToneCurve.gamma(in.readUnsignedInt() / (double) in.readUnsignedInt());
                    }
                }
                case TAG_PROFILE -> {
                    if (length <= MAX_PROFILE_BYTES) {
                        in.seek(in.readUnsignedInt());
                        tags.profile = profile(bytes((int) length));
                    }
                }
                default -> {
                    // nothing about tones
                }
            }
        }
    }

    private byte[] bytes(int length) throws IOException {
        byte[] bytes = new byte[length];
        in.readFully(bytes);
        return bytes;
    }
}
