package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PicturesTest {
    @ParameterizedTest
    @ValueSource(ints = {BufferedImage.TYPE_INT_RGB, BufferedImage.TYPE_3BYTE_BGR})
    void aPngKeepsEveryPixel(int type) throws IOException {
        BufferedImage picture = new BufferedImage(211, 97, type);
        Random random = new Random(1);
        for (int y = 0; y < picture.getHeight(); y++) {
            for (int x = 0; x < picture.getWidth(); x++) {
                picture.setRGB(x, y, 0xFF000000 | random.nextInt());
            }
        }

        BufferedImage read = ImageIO.read(new ByteArrayInputStream(Pictures.png(picture, Runnable::run)));

        assertEquals(picture.getWidth(), read.getWidth());
        assertEquals(picture.getHeight(), read.getHeight());
        assertArrayEquals(pixels(picture), pixels(read));
    }

    /** As far as the format allows: middles of large fields of a colour. */
    @ParameterizedTest
    @ValueSource(ints = {BufferedImage.TYPE_INT_RGB, BufferedImage.TYPE_3BYTE_BGR})
    void aJpegKeepsColours(int type) throws IOException {
        int[] colours = {0xE69F00, 0x14B98A, 0x2E93D8, 0xCC79A7};
        BufferedImage picture = new BufferedImage(128, 64, type);
        for (int y = 0; y < picture.getHeight(); y++) {
            for (int x = 0; x < picture.getWidth(); x++) {
                picture.setRGB(x, y, colours[x / 32]);
            }
        }

        BufferedImage read = ImageIO.read(new ByteArrayInputStream(Pictures.jpeg(picture, 128)));

        assertEquals(picture.getWidth(), read.getWidth());
        assertEquals(picture.getHeight(), read.getHeight());
        for (int i = 0; i < colours.length; i++) {
            for (int shift = 0; shift < 24; shift += 8) {
                assertEquals(colours[i] >> shift & 0xFF, read.getRGB(32 * i + 16, 32) >> shift & 0xFF, 4,
                        "field " + i + ", bits from " + shift);
            }
        }
    }

    private static int[] pixels(BufferedImage picture) {
        return picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, picture.getWidth());
    }
}
