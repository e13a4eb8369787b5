package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.cellgauge.desktop.render.Backdrop;
import org.cellgauge.desktop.render.Scene;
import org.cellgauge.desktop.render.Sensor;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Corners that are found against corners that were rendered: 40 markers, 320 coordinates, turned and tilted at random.
 */
class CornerAccuracyTest {
    /**
     * Under blur and noise the bounds are what a good sub-pixel refinement of a marker of 26 px leaves: 0.03 px, 0.1 px
     * where blur and noise are strong. The sharp one only shows that nothing systematic is left. The rms of 320 values
     * has a relative deviation of 4 % if errors are independent, so none of them is near by chance. The least number
     * found allows for markers that foreshortening or the lens makes smaller than 20 px.
     */
    @ParameterizedTest
    @CsvSource({
        "square-binary,   47, 0,    0,    0,   0, 0.01, 38",
        "square-binary,   47, 0,    0,    0.7, 2, 0.03, 38",
        "square-binary,   47, 0,    0,    1.2, 5, 0.10, 34",
        "square-binary,   60, -0.3, 0.08, 0.7, 2, 0.03, 38",
        "square-binary,  110, -0.3, 0.08, 0.7, 2, 0.03, 38",
        "apriltag-36h11,  60, 0,    0,    0.7, 2, 0.04, 38",
    })
    void cornersAreFoundToHundredthsOfAPixel(String family, double sizeMm, double k1, double k2, double blurPx,
            double noiseGrey, double rmsPx, int leastFound) {
        MarkerField field = MarkerField.of(family, sizeMm, k1, k2, Backdrop.textured(0.05, 4),
                Scene.DEFAULT_QUIET_ZONE, 0);
        MarkerField.Found found = field.find(field.photo(Sensor.IDEAL.withBlurPx(blurPx).withNoiseGrey(noiseGrey)),
                null);
        assertTrue(found.markers >= leastFound, found.toString());
        assertEquals(0, found.rmsPx, rmsPx, found.toString());
        // a misread or displaced marker would be off by whole pixels
        assertEquals(0, found.worstPx, 8 * rmsPx, found.toString());
    }
}
