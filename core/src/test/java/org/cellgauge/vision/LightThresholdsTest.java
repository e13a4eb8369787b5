package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.warning.Warning;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** From how much on light that is cut off, or too little of it, is said: shares of pixels that a test cuts off. */
class LightThresholdsTest {
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(700, 240, 600, 600, 350, 120);
    private static final List<Integer> IDS = List.of(5, 22, 911, 944);
    private static final double SIDE = 90;
    private static final double WHITE = 240;

    private static double left(int k) {
        return 40.3 + 160 * k;
    }

    private static DrawnMarkers drawn(double black, double white) {
        DrawnMarkers picture = new DrawnMarkers(CAMERA.widthPx(), CAMERA.heightPx(), 0.5 * (black + white));
        for (int k = 0; k < IDS.size(); k++) {
            double x = left(k);
            double y = 70.6;
            picture.draw(MarkerFamily.SQUARE_BINARY, IDS.get(k), new double[] {x, y, x + SIDE, y + 1.4, x + SIDE - 1.4,
                y + SIDE + 1.4, x - 1.4, y + SIDE}, black, white);
        }
        return picture;
    }

    /** The picture with a share of the white pixels from one column to another at the brightest value. */
    private static GreyImage cutOff(double share, int from, int to) {
        GreyImage image = drawn(20, WHITE).image();
        RandomGenerator random = new Well19937c(7);
        for (int y = 0; y < image.heightPx(); y++) {
            for (int x = from; x < to; x++) {
                if (image.get(x, y) > WHITE - 10 && random.nextDouble() < share) {
                    image.luminance()[y * image.widthPx() + x] = (byte) 255;
                }
            }
        }
        return image;
    }

    private static Detections seen(GreyImage image) {
        return new BoofMarkerDetector(CAMERA, MarkerFamily.SQUARE_BINARY, IDS).detect(image, "frame");
    }

    private static List<Warning> of(Detections seen, DetectionWarning kind) {
        List<Warning> found = new ArrayList<>();
        for (Warning warning : seen.warnings()) {
            if (warning.kind() == kind) {
                found.add(warning);
            }
        }
        return found;
    }

    @ParameterizedTest
    @CsvSource({"0.08, false", "0.13, true"})
    void whitesAreClippedFromATenthOn(double share, boolean said) {
        Detections seen = seen(cutOff(share, 0, CAMERA.widthPx()));
        List<Warning> clipped = of(seen, DetectionWarning.WHITES_CLIPPED);
        assertEquals(said ? 1 : 0, clipped.size(), seen.warnings().toString());
        if (said) {
            assertEquals(100 * share, ((Number) clipped.get(0).arguments().get(0)).doubleValue(), 3);
        }
        assertTrue(of(seen, DetectionWarning.GLARE).isEmpty());
    }

    /** Two fifths of the pixels beside the worst of a marker's sides. */
    @ParameterizedTest
    @CsvSource({"0.33, false", "0.44, true"})
    void aMarkerGlaresFromTwoFifthsOn(double share, boolean said) {
        // the margin to the right of one marker
        Detections seen = seen(cutOff(share, (int) (left(1) + SIDE) - 2, (int) (left(1) + SIDE) + 25));
        List<Warning> glare = of(seen, DetectionWarning.GLARE);
        assertEquals(said ? 1 : 0, glare.size(), seen.warnings().toString());
        if (said) {
            assertEquals(IDS.get(1), glare.get(0).arguments().get(0));
            assertEquals(100 * share, ((Number) glare.get(0).arguments().get(1)).doubleValue(), 5);
        }
        assertTrue(of(seen, DetectionWarning.WHITES_CLIPPED).isEmpty());
    }

    /** Where all of the picture is cut off, no marker is said to glare. */
    @Test
    void aPictureThatIsTooBrightDoesNotGlare() {
        Detections seen = seen(cutOff(0.6, 0, CAMERA.widthPx()));
        assertEquals(1, of(seen, DetectionWarning.WHITES_CLIPPED).size());
        assertTrue(of(seen, DetectionWarning.GLARE).isEmpty());
    }

    @ParameterizedTest
    @CsvSource({"44, false", "36, true"})
    void darknessIsAContrastOfLessThanForty(double contrast, boolean said) {
        Detections seen = seen(drawn(8, 8 + contrast).image());
        assertEquals(IDS.size(), seen.markers().size());
        assertEquals(said ? 1 : 0, of(seen, DetectionWarning.TOO_DARK).size(), seen.warnings().toString());
        assertTrue(of(seen, DetectionWarning.FAINT).isEmpty());
    }

    /** The same contrast in bright light is a pale print's. */
    @ParameterizedTest
    @CsvSource({"120, true", "136, false"})
    void aPalePrintIsToldFromDarknessByItsWhite(double white, boolean dark) {
        Detections seen = seen(drawn(white - 30, white).image());
        assertEquals(dark ? 1 : 0, of(seen, DetectionWarning.TOO_DARK).size(), seen.warnings().toString());
        assertEquals(dark ? 0 : 1, of(seen, DetectionWarning.FAINT).size(), seen.warnings().toString());
    }
}
