package org.cellgauge.android.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.ByteBuffer;
import org.cellgauge.vision.GreyImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Planes as cameras make them: padded rows, short last rows, positions that are not 0. */
class LuminancePlaneTest {

    private static byte pixel(int x, int y) {
        return (byte) (7 * x + 31 * y + 1);
    }

    /** A plane as long as it must be, with 99 in the padding. */
    private static ByteBuffer plane(int width, int height, int rowStride, int pixelStride, int before, int after) {
        int length = rowStride * (height - 1) + (width - 1) * pixelStride + 1;
        ByteBuffer plane = ByteBuffer.allocateDirect(before + length + after);
        for (int i = 0; i < plane.capacity(); i++) {
            plane.put(i, (byte) 99);
        }
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                plane.put(before + y * rowStride + x * pixelStride, pixel(x, y));
            }
        }
        plane.position(before);
        plane.limit(before + length + after);
        return plane;
    }

    @ParameterizedTest
    @CsvSource({"6,4,6,1,0,0", "6,4,16,1,0,0", "6,4,16,1,0,10", "6,4,16,1,5,0", "1,1,1,1,0,0", "6,4,12,2,0,0",
        "6,4,11,2,0,0", "6,4,40,3,2,7", "640,480,704,1,0,64"})
    void everyPixelComesWhereItIs(int width, int height, int rowStride, int pixelStride, int before, int after) {
        ByteBuffer plane = plane(width, height, rowStride, pixelStride, before, after);
        GreyImage image = new LuminancePlane().read(plane, rowStride, pixelStride, width, height);
        assertEquals(width, image.widthPx());
        assertEquals(height, image.heightPx());
        assertEquals("srgb", image.toneCurve().words());
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                assertEquals(pixel(x, y) & 0xFF, image.get(x, y), x + ", " + y);
            }
        }
        assertEquals(before, plane.position());
    }

    @Test
    void oneArrayServesAllFrames() {
        LuminancePlane luminance = new LuminancePlane();
        GreyImage first = luminance.read(plane(6, 4, 16, 1, 0, 0), 16, 1, 6, 4);
        GreyImage second = luminance.read(plane(6, 4, 16, 1, 0, 0), 16, 1, 6, 4);
        GreyImage smaller = luminance.read(plane(5, 4, 8, 1, 0, 0), 8, 1, 5, 4);
        assertSame(first.luminance(), second.luminance());
        assertSame(first.luminance(), smaller.luminance());
    }

    @Test
    void aPlaneThatIsTooShortIsRefused() {
        ByteBuffer plane = plane(6, 4, 16, 1, 0, 0);
        plane.limit(plane.limit() - 1);
        assertThrows(IllegalArgumentException.class, () -> new LuminancePlane().read(plane, 16, 1, 6, 4));
    }

    @ParameterizedTest
    @CsvSource({"5,1", "0,1", "-16,1", "16,0", "10,2", "2147483647,1"})
    void stridesThatCannotBeAreRefused(int rowStride, int pixelStride) {
        ByteBuffer plane = plane(6, 4, 16, 1, 0, 0);
        assertThrows(IllegalArgumentException.class,
                () -> new LuminancePlane().read(plane, rowStride, pixelStride, 6, 4));
    }
}
