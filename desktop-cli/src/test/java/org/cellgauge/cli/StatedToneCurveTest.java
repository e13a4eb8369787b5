package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.color.ColorSpace;
import java.awt.color.ICC_Profile;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;
import javax.imageio.ImageIO;
import org.cellgauge.desktop.ImageFiles;
import org.cellgauge.vision.GreyImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Files as the JDK writes them, with the notes that cameras and programs put into them. */
class StatedToneCurveTest {
    private static final byte[] SRGB_PROFILE = ICC_Profile.getInstance(ColorSpace.CS_sRGB).getData();
    private static final byte[] LINEAR_PROFILE = ICC_Profile.getInstance(ColorSpace.CS_LINEAR_RGB).getData();
    private static final byte[] LINEAR_GREY_PROFILE = ICC_Profile.getInstance(ColorSpace.CS_GRAY).getData();

    @TempDir
    Path folder;

    // ---- the files

    private static byte[] written(String format) throws IOException {
        BufferedImage image = new BufferedImage(24, 16, BufferedImage.TYPE_BYTE_GRAY);
        for (int i = 0; i < 24 * 16; i++) {
            image.getRaster().setSample(i % 24, i / 24, 0, i / 24 * 16);
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        assertTrue(ImageIO.write(image, format, out), "the JDK writes " + format);
        return out.toByteArray();
    }

    /** The words of the file's curve, or "-"; and the pixels must be there whatever the notes are. */
    private String words(String name, byte[] file) throws IOException {
        GreyImage image = ImageFiles.read(Files.write(folder.resolve(name), file));
        assertEquals(24, image.widthPx());
        assertEquals(160, image.get(12, 10), name.endsWith("jpg") ? 4 : 0);
        return image.toneCurve() == null ? "-" : image.toneCurve().words();
    }

    private static byte[] inserted(byte[] file, int at, byte[]... parts) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(file, 0, at);
        for (byte[] part : parts) {
            out.write(part);
        }
        out.write(file, at, file.length - at);
        return out.toByteArray();
    }

    /** A PNG with chunks after its header, which is 8 + 25 bytes. */
    private static byte[] png(byte[]... chunks) throws IOException {
        return inserted(written("png"), 33, chunks);
    }

    private static byte[] chunk(String type, byte... data) throws IOException {
        CRC32 checksum = new CRC32();
        checksum.update(type.getBytes(StandardCharsets.US_ASCII));
        checksum.update(data);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeInt(data.length);
        out.writeBytes(type);
        out.write(data);
        out.writeInt((int) checksum.getValue());
        return bytes.toByteArray();
    }

    private static byte[] gamma(int value) throws IOException {
        return chunk("gAMA", ByteBuffer.allocate(4).putInt(value).array());
    }

    private static byte[] profileChunk(String name, byte[] profile) throws IOException {
        ByteArrayOutputStream data = new ByteArrayOutputStream();
        data.writeBytes((name + "\0\0").getBytes(StandardCharsets.ISO_8859_1));
        try (DeflaterOutputStream compressed = new DeflaterOutputStream(data)) {
            compressed.write(profile);
        }
        return chunk("iCCP", data.toByteArray());
    }

    /** A JPEG with segments after its first marker. */
    private static byte[] jpeg(byte[]... segments) throws IOException {
        return inserted(written("jpg"), 2, segments);
    }

    private static byte[] segment(int marker, String name, byte[] data) {
        ByteBuffer out = ByteBuffer.allocate(4 + name.length() + data.length);
        out.put((byte) 0xFF).put((byte) marker).putShort((short) (2 + name.length() + data.length));
        return out.put(name.getBytes(StandardCharsets.ISO_8859_1)).put(data).array();
    }

    private static byte[] exif(byte[] tiff) {
        return segment(0xE1, "Exif\0\0", tiff);
    }

    private static byte[] profileSegment(int number, int count, byte[] part) {
        return segment(0xE2, "ICC_PROFILE\0" + (char) number + (char) count, part);
    }

    /** What Exif is: a TIFF with a directory that names another one, which has ColorSpace and Gamma; negative: not. */
    private static byte[] exifTiff(ByteOrder order, int colourSpace, int gammaTenths) {
        ByteBuffer out = ByteBuffer.allocate(80).order(order);
        out.put((order == ByteOrder.LITTLE_ENDIAN ? "II" : "MM").getBytes(StandardCharsets.US_ASCII));
        out.putShort((short) 42).putInt(8);
        // directory at 8: orientation, pointer to the Exif directory at 38
        out.putShort((short) 2);
        entry(out, 0x0112, 3, 1).putShort((short) 1).putShort((short) 0);
        entry(out, 0x8769, 4, 1).putInt(38);
        out.putInt(0);
        out.putShort((short) ((colourSpace >= 0 ? 1 : 0) + (gammaTenths >= 0 ? 1 : 0)));
        if (colourSpace >= 0) {
            entry(out, 0xA001, 3, 1).putShort((short) colourSpace).putShort((short) 0);
        }
        if (gammaTenths >= 0) {
            entry(out, 0xA500, 5, 1).putInt(72);
        }
        out.putInt(0);
        out.putInt(72, gammaTenths).putInt(76, 10);
        return out.array();
    }

    private static ByteBuffer entry(ByteBuffer out, int tag, int type, int count) {
        return out.putShort((short) tag).putShort((short) type).putInt(count);
    }

    /** A profile with one curve; the header says nothing that matters here. */
    private static byte[] profile(String tag, byte[] curve, String description) {
        byte[] desc = ("desc\0\0\0\0\0\0\0" + (char) description.length() + description)
                .getBytes(StandardCharsets.ISO_8859_1);
        ByteBuffer out = ByteBuffer.allocate(156 + curve.length + desc.length);
        out.putInt(0, out.capacity()).position(128);
        out.putInt(2).put(tag.getBytes(StandardCharsets.US_ASCII)).putInt(156).putInt(curve.length);
        out.put("desc".getBytes(StandardCharsets.US_ASCII)).putInt(156 + curve.length).putInt(desc.length);
        return out.put(curve).put(desc).array();
    }

    private static byte[] table(int count, DoubleUnaryOperator light) {
        ByteBuffer out = ByteBuffer.allocate(12 + 2 * count).put("curv\0\0\0\0".getBytes(StandardCharsets.US_ASCII));
        out.putInt(count);
        for (int i = 0; i < count; i++) {
            out.putShort((short) Math.round(65535 * light.applyAsDouble(i / (count - 1.0))));
        }
        return out.array();
    }

    // ---- what they say

    @ParameterizedTest
    @CsvSource({"png, -", "jpg, srgb", "bmp, srgb", "gif, srgb", "tiff, -"})
    void filesThatSayNothingAreTakenByTheirFormat(String format, String expected) throws IOException {
        assertEquals(expected, words("photo." + format, written(format)));
    }

    @ParameterizedTest
    @CsvSource({"45455, gamma 2.2", "100000, linear", "55556, gamma 1.8", "0, -", "1000, -"})
    void gammaChunkOfPng(int value, String expected) throws IOException {
        assertEquals(expected, words("photo.png", png(gamma(value))));
    }

    @Test
    void chunksOfPngInTheirOrderOfRank() throws IOException {
        byte[] srgb = chunk("sRGB", (byte) 0);
        assertEquals("srgb", words("photo.png", png(srgb)));
        assertEquals("srgb", words("photo.png", png(gamma(45455), srgb)));
        byte[] linear = profileChunk("of the camera", LINEAR_PROFILE);
        assertEquals("linear", words("photo.png", png(gamma(45455), linear)));
        assertEquals("linear", words("photo.png", png(linear, gamma(45455))));
    }

    @Test
    void profilesOfPng() throws IOException {
        assertEquals("srgb", words("photo.png", png(profileChunk("ICC profile", SRGB_PROFILE))));
        assertEquals("linear", words("photo.png", png(profileChunk("grey", LINEAR_GREY_PROFILE))));
        // the curve counts more than the name, and the name where there is no curve
        assertEquals("linear", words("photo.png", png(profileChunk("sRGB linear", LINEAR_PROFILE))));
        assertEquals("srgb", words("photo.png", png(profileChunk("sRGB IEC61966-2.1", new byte[200]))));
        assertEquals("-", words("photo.png", png(profileChunk("unknown", new byte[200]))));
    }

    @Test
    void exifOfJpeg() throws IOException {
        for (ByteOrder order : new ByteOrder[] {ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN}) {
            assertEquals("srgb", words("photo.jpg", jpeg(exif(exifTiff(order, 1, -1)))));
            assertEquals("gamma 1.8", words("photo.jpg", jpeg(exif(exifTiff(order, 0xFFFF, 18)))));
            assertEquals("linear", words("photo.jpg", jpeg(exif(exifTiff(order, -1, 10)))));
            assertEquals("srgb", words("photo.jpg", jpeg(exif(exifTiff(order, 1, 22)))), "sRGB is more exact");
            assertEquals("gamma 2.2", words("photo.jpg", jpeg(exif(exifTiff(order, 2, -1)))), "Adobe RGB");
            assertEquals("srgb", words("photo.jpg", jpeg(exif(exifTiff(order, 0xFFFF, -1)))), "nothing is said");
        }
    }

    @Test
    void profileOfJpegInPartsCountsMoreThanExif() throws IOException {
        byte[] exif = exif(exifTiff(ByteOrder.BIG_ENDIAN, 1, -1));
        assertEquals("linear", words("photo.jpg", jpeg(exif, profileSegment(1, 1, LINEAR_GREY_PROFILE))));
        byte[] profile = profile("kTRC", table(3000, x -> Math.pow(x, 1.8)), "camera");
        byte[] first = Arrays.copyOf(profile, 2000);
        byte[] second = Arrays.copyOfRange(profile, 2000, profile.length);
        assertEquals("gamma 1.8", words("photo.jpg", jpeg(exif, profileSegment(1, 2, first),
                profileSegment(2, 2, second))));
        assertEquals("gamma 1.8", words("photo.jpg", jpeg(profileSegment(2, 2, second), profileSegment(1, 2, first))));
    }

    @Test
    void profileAndExifOfTiff() throws IOException {
        assertEquals("srgb", words("photo.tiff", tiffWith(0x8773, 7, SRGB_PROFILE)));
        assertEquals("linear", words("photo.tiff", tiffWith(0x8773, 7, LINEAR_GREY_PROFILE)));
        assertEquals("-", words("photo.tiff", tiffWith(0x8773, 7, new byte[] {1, 2, 3, 4, 5})));
    }

    private static byte[] tiffWith(int tag, int type, byte[] value) throws IOException {
        byte[] file = written("tiff");
        ByteOrder order = file[0] == 'I' ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
        ByteBuffer old = ByteBuffer.wrap(file).order(order);
        int directory = old.getInt(4);
        int count = old.getShort(directory);
        int valueAt = file.length + file.length % 2;
        int movedAt = valueAt + value.length + value.length % 2;
        ByteBuffer out = ByteBuffer.allocate(movedAt + 2 + 12 * (count + 1) + 4).order(order);
        out.put(file).putInt(4, movedAt).position(valueAt);
        out.put(value).position(movedAt);
        out.putShort((short) (count + 1));
        boolean done = false;
        for (int i = 0; i < count; i++) {
            int at = directory + 2 + 12 * i;
            if (!done && (old.getShort(at) & 0xFFFF) > tag) {
                entry(out, tag, type, value.length).putInt(valueAt);
                done = true;
            }
            out.put(file, at, 12);
        }
        if (!done) {
            entry(out, tag, type, value.length).putInt(valueAt);
        }
        return out.array();
    }

    // ---- damage

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void damagedNotesNeverStopThePixels(int seed) throws IOException {
        Random random = new Random(seed);
        byte[] exif = exifTiff(ByteOrder.LITTLE_ENDIAN, 1, 22);
        byte[] profile = profile("kTRC", table(64, x -> x * x), "sRGB");
        for (int i = 0; i < 300; i++) {
            byte[] badExif = exif.clone();
            byte[] badProfile = profile.clone();
            for (int k = 0; k < 3; k++) {
                badExif[random.nextInt(badExif.length)] = (byte) random.nextInt(256);
                badProfile[128 + random.nextInt(badProfile.length - 128)] = (byte) random.nextInt(256);
            }
            words("photo.jpg", jpeg(exif(Arrays.copyOf(badExif, random.nextInt(badExif.length) + 1))));
            words("photo.jpg", jpeg(exif(badExif)));
            words("photo.jpg", jpeg(profileSegment(random.nextInt(3), 1, badProfile)));
            words("photo.png", png(profileChunk("p", badProfile)));
            words("photo.tiff", tiffWith(0x8773, 7, badProfile));
        }
    }

    @Test
    void damagedNotesCountAsNotSaid() throws IOException {
        assertEquals("srgb", words("photo.jpg", jpeg(exif(new byte[] {'I', 'I', 42, 0, -1, -1, -1, 127}))));
        assertEquals("srgb", words("photo.jpg", jpeg(exif(new byte[0]))));
        assertEquals("-", words("photo.png", png(profileChunk("p", new byte[0]))));
        assertEquals("-", words("photo.tiff", tiffWith(0x8769, 4, new byte[] {1})));
    }
}
