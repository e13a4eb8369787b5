package org.cellgauge.android.files;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.awt.image.DataBufferUShort;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.Random;
import javax.imageio.ImageIO;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.desktop.ImageFiles;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.GreyImage;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;

/** Photos read with Android's own decoder, against the command line's reading of the same files. */
@RunWith(RobolectricTestRunner.class)
public class PhotoReaderTest {
    private static final long PLENTY = 1L << 32;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private static GreyImage read(byte[] file) throws IOException {
        return PhotoReader.read(new ByteArrayInputStream(file), "photo.png", PLENTY);
    }

    private GreyImage onTheDesktop(byte[] file) throws IOException {
        File copy = folder.newFile();
        Files.write(copy.toPath(), file);
        return ImageFiles.read(copy.toPath());
    }

    private static byte[] encoded(BufferedImage image, String format) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        assertTrue(ImageIO.write(image, format, out));
        return out.toByteArray();
    }

    /** Colours and, where the kind has it, transparency, all at random. */
    private static BufferedImage noise(int width, int height, int type) {
        Random random = new Random(5);
        BufferedImage image = new BufferedImage(width, height, type);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                image.setRGB(x, y, random.nextInt());
            }
        }
        return image;
    }

    /** A scene with gentle slopes and edges, as photos have them. */
    private static BufferedImage scene(int width, int height, int type) {
        BufferedImage image = new BufferedImage(width, height, type);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int level = (x / 23 + y / 17) % 2 == 0 ? 40 + x % 90 : 200 - y % 60;
                image.setRGB(x, y, 0xFF000000 | level << 16 | (level * 9 / 10) << 8 | level * 7 / 10);
            }
        }
        return image;
    }

    private void assertSamePixels(byte[] file) throws IOException {
        GreyImage expected = onTheDesktop(file);
        GreyImage actual = read(file);
        assertEquals(expected.widthPx(), actual.widthPx());
        assertEquals(expected.heightPx(), actual.heightPx());
        assertArrayEquals(Fixtures.pixels(expected), Fixtures.pixels(actual));
        assertEquals(String.valueOf(expected.toneCurve()), String.valueOf(actual.toneCurve()));
    }

    @Test
    public void whatTheFileSaysOfItsTonesGoesWithThePhoto() throws IOException {
        BufferedImage image = scene(61, 47, BufferedImage.TYPE_3BYTE_BGR);
        assertEquals("srgb", read(encoded(image, "jpg")).toneCurve().words());
        assertNull(read(encoded(image, "png")).toneCurve());
        GreyImage linear = GreyImage.packed(new byte[61 * 47], 61, 47).withToneCurve(ToneCurve.LINEAR);
        assertEquals("linear", read(GreyPng.encode(linear)).toneCurve().words());
    }

    @Test
    public void theFixturesPhotoHasTheBytesThatJavaReads() throws IOException {
        byte[] file = Fixtures.bytes("lifted-4/photo.png");
        BufferedImage java = ImageIO.read(new ByteArrayInputStream(file));
        assertEquals(BufferedImage.TYPE_BYTE_GRAY, java.getType());
        byte[] expected = ((DataBufferByte) java.getRaster().getDataBuffer()).getData();
        assertArrayEquals(expected, Fixtures.pixels(read(file)));
        assertSamePixels(file);
    }

    @Test
    public void coloursBecomeTheGreyOfTheCommandLine() throws IOException {
        assertSamePixels(encoded(noise(61, 47, BufferedImage.TYPE_INT_RGB), "png"));
        assertSamePixels(encoded(noise(61, 47, BufferedImage.TYPE_BYTE_INDEXED), "png"));
        assertSamePixels(encoded(noise(61, 47, BufferedImage.TYPE_BYTE_BINARY), "png"));
    }

    @Test
    public void transparentPartsLieOnWhite() throws IOException {
        assertSamePixels(encoded(noise(61, 47, BufferedImage.TYPE_INT_ARGB), "png"));
    }

    @Test
    public void sixteenBitsAreReadToALevel() throws IOException {
        BufferedImage image = new BufferedImage(256, 16, BufferedImage.TYPE_USHORT_GRAY);
        short[] values = ((DataBufferUShort) image.getRaster().getDataBuffer()).getData();
        for (int i = 0; i < values.length; i++) {
            values[i] = (short) (i * 16);
        }
        byte[] file = encoded(image, "png");
        assertWithin(1, Fixtures.pixels(onTheDesktop(file)), Fixtures.pixels(read(file)));
    }

    @Test
    public void jpegIsReadToALevelOrTwo() throws IOException {
        // two decoders may round and fill up colours differently; luminance is coded in full
        byte[] grey = encoded(scene(640, 480, BufferedImage.TYPE_BYTE_GRAY), "jpg");
        assertWithin(1, Fixtures.pixels(onTheDesktop(grey)), Fixtures.pixels(read(grey)));
        byte[] colour = encoded(scene(640, 480, BufferedImage.TYPE_INT_RGB), "jpg");
        assertWithin(3, Fixtures.pixels(onTheDesktop(colour)), Fixtures.pixels(read(colour)));
    }

    private static void assertWithin(int levels, byte[] expected, byte[] actual) {
        assertEquals(expected.length, actual.length);
        int worst = 0;
        for (int i = 0; i < expected.length; i++) {
            worst = Math.max(worst, Math.abs((expected[i] & 0xFF) - (actual[i] & 0xFF)));
        }
        assertTrue("differs by " + worst + " levels", worst <= levels);
    }

    @Test
    public void aNoteToTurnThePhotoIsNotFollowed() throws IOException {
        byte[] plain = encoded(scene(64, 32, BufferedImage.TYPE_BYTE_GRAY), "jpg");
        // an Exif segment with the one entry "orientation: turn by 90 degrees"
        byte[] exif = {(byte) 0xFF, (byte) 0xE1, 0, 34, 'E', 'x', 'i', 'f', 0, 0, 'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1,
            0x01, 0x12, 0, 3, 0, 0, 0, 1, 0, 6, 0, 0, 0, 0, 0, 0};
        ByteArrayOutputStream turned = new ByteArrayOutputStream();
        turned.write(plain, 0, 2);
        turned.write(exif);
        turned.write(plain, 2, plain.length - 2);
        GreyImage image = read(turned.toByteArray());
        assertEquals(64, image.widthPx());
        assertEquals(32, image.heightPx());
        assertArrayEquals(Fixtures.pixels(read(plain)), Fixtures.pixels(image));
    }

    // ---- refused

    private static String refusal(byte[] file) {
        return assertThrows(InputRefusedException.class, () -> read(file)).getMessage();
    }

    @Test
    public void aPngThatIsCutShortAnywhereIsRefused() throws IOException {
        byte[] file = encoded(noise(61, 47, BufferedImage.TYPE_INT_RGB), "png");
        for (int length = 8; length < file.length; length += 1 + length / 9) {
            String message = refusal(Arrays.copyOf(file, length));
            assertTrue(length + ": " + message, message.startsWith("photo.png: it is cut short"));
        }
        assertTrue(refusal(Arrays.copyOf(file, file.length - 1)).contains("cut short"));
    }

    @Test
    public void aJpegThatIsCutShortAnywhereIsRefused() throws IOException {
        byte[] file = encoded(scene(64, 64, BufferedImage.TYPE_INT_RGB), "jpg");
        for (int length = 3; length < file.length; length += 1 + length / 9) {
            String message = refusal(Arrays.copyOf(file, length));
            assertTrue(length + ": " + message, message.startsWith("photo.png: it is cut short"));
        }
        assertTrue(refusal(Arrays.copyOf(file, file.length - 1)).contains("cut short"));
    }

    @Test
    public void aDamagedPngIsRefused() throws IOException {
        byte[] file = encoded(noise(61, 47, BufferedImage.TYPE_INT_RGB), "png");
        for (int at : new int[] {17, 20, file.length / 2, file.length - 20}) {
            byte[] damaged = file.clone();
            damaged[at] ^= 0x10;
            String message = refusal(damaged);
            assertTrue(at + ": " + message, message.startsWith("photo.png: it is damaged"));
        }
    }

    @Test
    public void aDamagedJpegHeaderIsRefused() throws IOException {
        byte[] file = encoded(scene(64, 64, BufferedImage.TYPE_INT_RGB), "jpg");
        file[2] = 0;
        assertTrue(refusal(file).contains("damaged"));
    }

    @Test
    public void whatIsNoImageIsRefusedWithWhatToDo() throws IOException {
        assertTrue(refusal(new byte[0]).contains("empty"));
        assertTrue(refusal("cellgauge: 1\n".getBytes(StandardCharsets.UTF_8)).contains("no image of a known format"));
        assertTrue(refusal(new byte[] {(byte) 0x89}).contains("no image of a known format"));
        assertTrue(refusal(encoded(noise(4, 4, BufferedImage.TYPE_INT_RGB), "gif")).contains("save it as PNG or JPEG"));
        assertTrue(refusal(encoded(noise(4, 4, BufferedImage.TYPE_INT_RGB), "bmp")).contains("save it as PNG or JPEG"));
        byte[] heic = "\0\0\0\30ftypheic\0\0\0\0".getBytes(StandardCharsets.ISO_8859_1);
        assertTrue(refusal(heic).contains("HEIC"));
    }

    @Test
    public void aHeaderWithoutPixelsIsRefused() throws IOException {
        byte[] file = encoded(noise(61, 47, BufferedImage.TYPE_INT_RGB), "png");
        byte[] end = Arrays.copyOfRange(file, file.length - 12, file.length);
        byte[] headerAndEnd = Arrays.copyOf(file, 33 + 12);
        System.arraycopy(end, 0, headerAndEnd, 33, 12);
        assertTrue(refusal(headerAndEnd).contains("damaged"));
        byte[] endOnly = Arrays.copyOf(file, 8 + 12);
        System.arraycopy(end, 0, endOnly, 8, 12);
        assertTrue(refusal(endOnly).contains("damaged"));
    }

    @Test
    public void coloursForPrintAreRefused() throws IOException {
        byte[] file = encoded(scene(64, 64, BufferedImage.TYPE_INT_RGB), "jpg");
        for (int i = 0; i < file.length - 9; i++) {
            if ((file[i] & 0xFF) == 0xFF && (file[i + 1] & 0xFF) == 0xC0) {
                file[i + 9] = 4;
            }
        }
        assertTrue(refusal(file).contains("CMYK"));
    }

    /** A header may announce any size, a few hundred bytes behind it. */
    @Test
    public void hugeSizesAreRefusedBeforeTheyAreDecoded() throws IOException {
        byte[] small = GreyPng.encode(GreyImage.packed(new byte[100 * 100], 100, 100));
        byte[] huge = small.clone();
        huge[16] = 0;
        huge[17] = 1;
        huge[20] = 0;
        huge[21] = 1;
        java.util.zip.CRC32 crc = new java.util.zip.CRC32();
        crc.update(huge, 12, 17);
        for (int i = 0; i < 4; i++) {
            huge[29 + i] = (byte) (crc.getValue() >>> (24 - 8 * i));
        }
        String message = refusal(huge);
        assertTrue(message, message.contains("65636 x 65636 px are too many"));
    }

    @Test
    public void whatDoesNotFitTheMemoryIsRefusedWithTheMemoryThereIs() {
        byte[] file = GreyPng.encode(GreyImage.packed(new byte[1000 * 1000], 1000, 1000));
        String message = assertThrows(InputRefusedException.class,
                () -> PhotoReader.read(new ByteArrayInputStream(file), "large.png", 5 << 20)).getMessage();
        assertTrue(message, message.startsWith("large.png: 1000 x 1000 px are too many for the memory of this device "
                + "(5 MB free); scale it down"));
    }
}
