package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.Random;
import java.util.zip.CRC32;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.vision.GreyImage;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ImageFilesTest {
    @TempDir
    Path folder;

    private Path write(BufferedImage image, String format) throws IOException {
        Path file = folder.resolve("photo." + format);
        assertTrue(ImageIO.write(image, format, file.toFile()), "the JDK writes " + format);
        return file;
    }

    /** A texture that no format can compress to nothing, so that a cut file lacks pixels. */
    private static BufferedImage texture(int type) {
        BufferedImage image = new BufferedImage(120, 90, type);
        Random random = new Random(3);
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                image.setRGB(x, y, 0xFF000000 | random.nextInt(1 << 24));
            }
        }
        return image;
    }

    private String refusal(Path file) {
        String message = assertThrows(InputRefusedException.class, () -> ImageFiles.read(file)).getMessage();
        assertTrue(message.startsWith(file.toString()), message);
        return message;
    }

    /** Luma of ITU-R BT.601 of (204, 102, 51): 61.0 + 59.9 + 5.8. */
    @ParameterizedTest
    @CsvSource({"png, 1", "png, 5", "bmp, 1", "tiff, 1", "gif, 13"})
    void coloursBecomeLuma(String format, int type) throws IOException {
        // colours that the JDK's palette of steps of 51 holds exactly
        int[] colours = {new Color(204, 102, 51).getRGB(), Color.WHITE.getRGB(), Color.BLACK.getRGB()};
        BufferedImage image = new BufferedImage(30, 20, type);
        for (int i = 0; i < 600; i++) {
            image.setRGB(i % 30, i / 30, colours[i % 30 / 10]);
        }
        GreyImage grey = ImageFiles.read(write(image, format));
        assertEquals(30, grey.widthPx());
        assertEquals(20, grey.heightPx());
        assertEquals(127, grey.get(9, 19));
        assertEquals(255, grey.get(10, 0));
        assertEquals(0, grey.get(29, 11));
    }

    /** The JDK's own conversion of grey images bends the tones: stored values must come through as they are. */
    @ParameterizedTest
    @ValueSource(strings = {"png", "tiff", "bmp"})
    void greyValuesComeThroughUntouched(String format) throws IOException {
        BufferedImage image = new BufferedImage(256, 1, BufferedImage.TYPE_BYTE_GRAY);
        for (int x = 0; x < 256; x++) {
            image.getRaster().setSample(x, 0, 0, x);
        }
        GreyImage grey = ImageFiles.read(write(image, format));
        for (int x = 0; x < 256; x++) {
            assertEquals(x, grey.get(x, 0));
        }
    }

    @Test
    void sixteenBitsAreScaledToEight() throws IOException {
        BufferedImage image = new BufferedImage(3, 1, BufferedImage.TYPE_USHORT_GRAY);
        image.getRaster().setSample(0, 0, 0, 65535);
        image.getRaster().setSample(1, 0, 0, 32768);
        image.getRaster().setSample(2, 0, 0, 257);
        GreyImage grey = ImageFiles.read(write(image, "png"));
        assertEquals(255, grey.get(0, 0));
        assertEquals(128, grey.get(1, 0));
        assertEquals(1, grey.get(2, 0));
    }

    /** Cameras of 10 and 12 bits fill the lower bits of 16: 1023 and 4095 are white then. */
    @ParameterizedTest
    @CsvSource({"10", "12"})
    void fewerBitsInSixteenAreTheWholeRange(int bits) throws IOException {
        BufferedImage image = new BufferedImage(3, 1, BufferedImage.TYPE_USHORT_GRAY);
        int white = (1 << bits) - 1;
        image.getRaster().setSample(0, 0, 0, white);
        image.getRaster().setSample(1, 0, 0, white / 3);
        GreyImage grey = ImageFiles.read(write(image, "png"));
        assertEquals(255, grey.get(0, 0));
        assertEquals(85, grey.get(1, 0));
        assertEquals(0, grey.get(2, 0));
    }

    /** Netpbm's own layout, written by hand: the stated largest value is white. */
    @ParameterizedTest
    @CsvSource({"255", "200", "1023", "4095", "65535"})
    void pgmIsReadByItsLargestValue(int largest) throws IOException {
        ByteArrayOutputStream pgm = new ByteArrayOutputStream();
        pgm.write(("P5\n# by hand\n3 2\n" + largest + "\n").getBytes(StandardCharsets.US_ASCII));
        for (int value : new int[] {0, largest, largest / 5, largest, 0, 0}) {
            if (largest > 255) {
                pgm.write(value >> 8);
            }
            pgm.write(value);
        }
        GreyImage grey = ImageFiles.decode(pgm.toByteArray(), "a.pgm", (w, h) -> { });
        assertEquals(3, grey.widthPx());
        assertEquals(255, grey.get(1, 0));
        assertEquals(51, grey.get(2, 0), 1);
        assertEquals(255, grey.get(0, 1));
        assertEquals(0, grey.get(2, 1));
    }

    @Test
    void ppmAsTextIsRead() {
        byte[] ppm = "P3 2 1 # colours\n 10\n10 0 0  0 5 10".getBytes(StandardCharsets.US_ASCII);
        GreyImage grey = ImageFiles.decode(ppm, "a.ppm", (w, h) -> { });
        assertEquals(Math.round(0.299 * 255), grey.get(0, 0));
        assertEquals(Math.round(0.587 * 127.5 + 0.114 * 255), grey.get(1, 0));
        for (String damaged : new String[] {"P5 3 1 255\nab", "P2 2 1 10\n1 11", "P2 2 1 0\n0 0", "P2 2 1 10\n1 x",
            "P5 99999 99999 255\n", "P5 0 1 255\n"}) {
            assertThrows(InputRefusedException.class,
                    () -> ImageFiles.decode(damaged.getBytes(StandardCharsets.US_ASCII), "a.pgm", (w, h) -> { }));
        }
    }

    /** Lossless WebP of grey values 20 x + 10 y, written by Pillow 13 (libwebp). */
    @Test
    void webpIsRead() {
        byte[] webp = Base64.getDecoder().decode("UklGRigAAABXRUJQVlA4TBsAAAAvC8AAAM1lRP8Dato2YHr3Ln+4E0FETADk8gIA");
        GreyImage grey = ImageFiles.decode(webp, "a.webp", (w, h) -> { });
        assertEquals(12, grey.widthPx());
        assertEquals(4, grey.heightPx());
        for (int i = 0; i < 48; i++) {
            assertEquals(20 * (i % 12) + 10 * (i / 12), grey.get(i % 12, i / 12));
        }
    }

    /** Damaged so that its tables do not end with it, and the decoder takes all that follows for zeros. */
    @Test
    @Timeout(value = 20, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void whatDoesNotEndWithTheFileIsCutShort() {
        byte[] webp = Base64.getDecoder().decode("UklGRigAAABXRUJQVlA4TBsAAAAvC8AAAM1lZUT/"
                + "A2o5XFSEvhMYkdsk5Jxg4g9V9g==");
        InputRefusedException refused = assertThrows(InputRefusedException.class,
                () -> ImageFiles.decode(webp, "a.webp", (w, h) -> { }));
        assertEquals(ImageRefusal.CUT_SHORT, refused.refusal().kind());
    }

    @Test
    void heicIsNamedWithTheWayOut() throws IOException {
        Path file = Files.write(folder.resolve("IMG_1.HEIC"),
                "\0\0\0\u0018ftypheic\0\0\0\0mif1heic".getBytes(StandardCharsets.ISO_8859_1));
        String message = refusal(file);
        assertTrue(message.contains("HEIC") && message.contains("JPEG"), message);
    }

    /** No pixel of these is decoded: there is none. */
    @Test
    void sizeIsJudgedBeforePixelsAreDecoded() throws IOException {
        Path file = Files.write(folder.resolve("a.png"), pngHeader(1200, 800));
        InputRefusedException unwanted = new InputRefusedException("a.png", ImageRefusal.EMPTY);
        byte[] bytes = Files.readAllBytes(file);
        assertSame(unwanted, assertThrows(InputRefusedException.class,
                () -> ImageFiles.decode(bytes, "a.png", (w, h) -> {
                    assertEquals(1200, w);
                    assertEquals(800, h);
                    throw unwanted;
                })));
        assertTrue(refusal(Files.write(file, pngHeader(1, 100_000_000))).contains("1 x 100000000 px"));
    }

    /** A TIFF of one pixel, by hand: 32 bits of unsigned grey. */
    @Test
    void valuesOf32BitsAreNamed() throws IOException {
        int[][] tags = {{256, 1}, {257, 1}, {258, 32}, {259, 1}, {262, 1}, {273, 8}, {277, 1}, {278, 1}, {279, 4}};
        ByteBuffer tiff = ByteBuffer.allocate(12 + 2 + tags.length * 12 + 4).order(ByteOrder.LITTLE_ENDIAN);
        tiff.put(new byte[] {'I', 'I', 42, 0}).putInt(12).putInt(1 << 30).putShort((short) tags.length);
        for (int[] tag : tags) {
            tiff.putShort((short) tag[0]).putShort((short) 3).putInt(1).putInt(tag[1]);
        }
        String message = refusal(Files.write(folder.resolve("a.tif"), tiff.array()));
        assertTrue(message.contains("32 bits"), message);
    }

    @Test
    void transparentPartsLieOnWhite() throws IOException {
        BufferedImage image = new BufferedImage(3, 1, BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, 0x00000000);
        image.setRGB(1, 0, 0xFF000000);
        image.setRGB(2, 0, 0x33000000);
        GreyImage grey = ImageFiles.read(write(image, "png"));
        assertEquals(255, grey.get(0, 0));
        assertEquals(0, grey.get(1, 0));
        assertEquals(204, grey.get(2, 0));
    }

    @Test
    void jpegIsRead() throws IOException {
        BufferedImage image = new BufferedImage(64, 48, BufferedImage.TYPE_3BYTE_BGR);
        for (int i = 0; i < 64 * 48; i++) {
            image.setRGB(i % 64, i / 64, 0xFF808080);
        }
        GreyImage grey = ImageFiles.read(write(image, "jpg"));
        assertEquals(64, grey.widthPx());
        assertEquals(128, grey.get(30, 20), 2);
    }

    @ParameterizedTest
    @CsvSource({"png, 0.5", "png, 0.95", "png, 0.02", "jpg, 0.5", "jpg, 0.95", "jpg, 0.02", "bmp, 0.5", "bmp, 0.95",
        "tiff, 0.5", "gif, 0.5", "gif, 0.95"})
    void fileCutShortIsRefused(String format, double share) throws IOException {
        int type = format.equals("gif") ? BufferedImage.TYPE_BYTE_INDEXED : BufferedImage.TYPE_3BYTE_BGR;
        Path file = write(texture(type), format);
        byte[] whole = Files.readAllBytes(file);
        ImageFiles.read(file);
        Files.write(file, Arrays.copyOf(whole, (int) (whole.length * share)));
        refusal(file);
    }

    @Test
    void headerThatAnnouncesAHugeImageIsRefusedBeforeItIsDecoded() throws IOException {
        Path file = folder.resolve("bomb.png");
        Files.write(file, pngHeader(60_000, 60_000));
        assertTrue(Files.size(file) < 200);
        String message = refusal(file);
        assertTrue(message.contains("60000 x 60000"), message);
    }

    private static byte[] pngHeader(int width, int height) throws IOException {
        ByteArrayOutputStream header = new ByteArrayOutputStream();
        DataOutputStream data = new DataOutputStream(header);
        data.write("IHDR".getBytes(StandardCharsets.US_ASCII));
        data.writeInt(width);
        data.writeInt(height);
        data.write(new byte[] {8, 2, 0, 0, 0});
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(png);
        out.write(new byte[] {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10});
        writeChunk(out, header.toByteArray());
        writeChunk(out, "IDAT".getBytes(StandardCharsets.US_ASCII));
        writeChunk(out, "IEND".getBytes(StandardCharsets.US_ASCII));
        return png.toByteArray();
    }

    private static void writeChunk(DataOutputStream out, byte[] typeAndData) throws IOException {
        CRC32 checksum = new CRC32();
        checksum.update(typeAndData);
        out.writeInt(typeAndData.length - 4);
        out.write(typeAndData);
        out.writeInt((int) checksum.getValue());
    }

    @Test
    void cmykIsRefusedByItsName() throws IOException {
        WritableRaster raster = Raster.createInterleavedRaster(0, 16, 16, 4, null);
        ImageWriter writer = ImageIO.getImageWritersByFormatName("jpg").next();
        Path file = folder.resolve("print.jpg");
        try (ImageOutputStream out = ImageIO.createImageOutputStream(file.toFile())) {
            writer.setOutput(out);
            writer.write(null, new IIOImage(raster, null, null), null);
        }
        assertTrue(refusal(file).contains("CMYK"));
    }

    @Test
    void whatIsNoImageIsRefusedWithItsReason() throws IOException {
        assertTrue(refusal(folder).contains("folder"));
        assertTrue(refusal(folder.resolve("missing.png")).contains("no such file"));
        Path empty = Files.createFile(folder.resolve("empty.png"));
        assertTrue(refusal(empty).contains("empty"));
        Path text = Files.writeString(folder.resolve("notes.png"), "cellgauge: 1\ncamera: camera.yaml\n");
        assertTrue(refusal(text).contains("known format"));
    }

    @Test
    void fileThatMayNotBeReadIsRefused() throws IOException {
        Path file = write(texture(BufferedImage.TYPE_3BYTE_BGR), "png");
        Assumptions.assumeTrue(file.toFile().setReadable(false) && !Files.isReadable(file),
                "whoever runs this may read everything");
        assertTrue(refusal(file).contains("permi"));
    }
}
