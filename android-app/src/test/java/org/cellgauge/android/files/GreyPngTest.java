package org.cellgauge.android.files;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Random;
import javax.imageio.ImageIO;
import org.cellgauge.internal.vision.StatedToneCurve;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.GreyImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is written is what another reader reads. */
class GreyPngTest {

    private static byte[] readByJava(byte[] png, int width, int height) throws IOException {
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(png));
        assertEquals(BufferedImage.TYPE_BYTE_GRAY, image.getType());
        assertEquals(width, image.getWidth());
        assertEquals(height, image.getHeight());
        return ((DataBufferByte) image.getRaster().getDataBuffer()).getData();
    }

    @ParameterizedTest
    @CsvSource({"1,1,1,0", "1,9,1,0", "9,1,9,0", "640,480,640,0", "61,47,64,13", "300,200,512,7"})
    void everyPixelComesBack(int width, int height, int rowStride, int offset) throws IOException {
        byte[] bytes = new byte[offset + rowStride * (height - 1) + width];
        new Random(3).nextBytes(bytes);
        GreyImage image = GreyImage.wrap(bytes, offset, rowStride, width, height);
        assertArrayEquals(Fixtures.pixels(image), readByJava(GreyPng.encode(image), width, height));
    }

    @Test
    void aRenderedPhotoIsNotMuchLargerThanJavasOwnFile() throws IOException {
        byte[] original = Fixtures.bytes("lifted-4/photo.png");
        byte[] pixels = readByJava(original, 1280, 720);
        byte[] again = GreyPng.encode(GreyImage.packed(pixels, 1280, 720));
        assertArrayEquals(pixels, readByJava(again, 1280, 720));
        assertTrue(again.length < 1.3 * original.length, again.length + " bytes in place of " + original.length);
    }

    /** What the tablet starts from is what the command line starts from when it makes the figures again. */
    @ParameterizedTest
    @ValueSource(strings = {"srgb", "linear", "gamma 2.2", "gamma 1.8"})
    void toneCurveComesBack(String words) throws IOException {
        byte[] pixels = {0, 50, 100, (byte) 200};
        byte[] png = GreyPng.encode(GreyImage.packed(pixels, 2, 2).withToneCurve(ToneCurve.of(words)));
        assertEquals(words, StatedToneCurve.of(png).words());
        assertArrayEquals(pixels, readByJava(png, 2, 2));
        assertNull(StatedToneCurve.of(GreyPng.encode(GreyImage.packed(pixels, 2, 2))));
    }
}
