package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.cellgauge.light.ToneCurve;
import org.junit.jupiter.api.Test;

class GreyImageTest {
    @Test
    void pixelsAreReadUnsignedAtTheirStride() {
        byte[] data = {9, 9, (byte) 200, 1, 9, 2, (byte) 255};
        GreyImage image = GreyImage.wrap(data, 2, 3, 2, 2);
        assertEquals(200, image.get(0, 0));
        assertEquals(1, image.get(1, 0));
        assertEquals(2, image.get(0, 1));
        assertEquals(255, image.get(1, 1));
        data[2] = 7;
        assertEquals(7, image.get(0, 0), "a view, not a copy");
    }

    @Test
    void valuesBetweenPixelCentresAreBilinear() {
        GreyImage image = GreyImage.packed(new byte[] {0, 100, 40, (byte) 140}, 2, 2);
        assertEquals(0, image.interpolate(0.5, 0.5), 1e-12);
        assertEquals(140, image.interpolate(1.5, 1.5), 1e-12);
        assertEquals(50, image.interpolate(1, 0.5), 1e-12);
        assertEquals(70, image.interpolate(1, 1), 1e-12);
        assertEquals(0, image.interpolate(-3, 0), 1e-12, "goes on as at its edge");
    }

    @Test
    void arraysThatAreTooShortAreRefused() {
        GreyImage.wrap(new byte[8], 0, 5, 3, 2);
        assertThrows(IllegalArgumentException.class, () -> GreyImage.wrap(new byte[7], 0, 5, 3, 2));
        assertThrows(IllegalArgumentException.class, () -> GreyImage.wrap(new byte[100], 0, 2, 3, 2));
        assertThrows(IllegalArgumentException.class, () -> GreyImage.wrap(new byte[100], -1, 3, 3, 2));
        assertThrows(IllegalArgumentException.class, () -> GreyImage.packed(new byte[0], 0, 0));
        assertThrows(IllegalArgumentException.class, () -> GreyImage.packed(new byte[16], 65536, 65536));
    }

    @Test
    void toneCurveIsANoteOnTheSamePixels() {
        byte[] data = {9, 9, 1, 2, 9, 3, (byte) 200};
        GreyImage image = GreyImage.wrap(data, 2, 3, 2, 2);
        assertNull(image.toneCurve());
        GreyImage noted = image.withToneCurve(ToneCurve.SRGB);
        assertSame(ToneCurve.SRGB, noted.toneCurve());
        assertSame(data, noted.luminance());
        assertEquals(200, noted.get(1, 1));
        assertNull(image.toneCurve());
        assertNull(noted.withToneCurve(null).toneCurve());
    }

    @Test
    void insideTheOutermostCentresItIsTheSameWithoutAskingForTheEnds() {
        byte[] grey = new byte[5 + 9 * 12];
        new Random(1).nextBytes(grey);
        GreyImage image = GreyImage.wrap(grey, 5, 12, 10, 8);
        int inside = 0;
        for (double v = -0.5; v < 8.5; v += 0.19) {
            for (double u = -0.5; u < 10.5; u += 0.23) {
                if (image.hasNeighbours(u, v)) {
                    assertEquals(image.interpolate(u, v), image.interpolateInside(u, v));
                    inside++;
                }
            }
        }
        assertTrue(inside > 1000, inside + " places");
        assertTrue(!image.hasNeighbours(9.5, 4) && !image.hasNeighbours(4, 7.5) && !image.hasNeighbours(0.4, 4));
    }
}
