package org.cellgauge.android.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Collections;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.api.Test;

/** How bright markers are. */
class MarkerWhiteTest {
    private final byte[] grey = new byte[100 * 80];
    private final GreyImage frame = GreyImage.packed(grey, 100, 80);

    private void fill(int left, int top, int right, int bottom, int value) {
        for (int y = top; y < bottom; y++) {
            Arrays.fill(grey, 100 * y + left, 100 * y + right, (byte) value);
        }
    }

    private static MarkerObservation marker(int id, double left, double top, double side) {
        return new MarkerObservation(id, new double[] {left, top, left + side, top, left + side, top + side, left,
            top + side});
    }

    @Test
    void whiteIsThatOfTheMarkersAndOfNothingBesides() {
        Arrays.fill(grey, (byte) 255);
        fill(10, 10, 42, 42, 20);
        fill(20, 20, 32, 32, 200);
        fill(60, 10, 92, 42, 10);
        fill(70, 20, 90, 40, 100);
        Detections two = new Detections("frame", 100, 80, Arrays.asList(marker(1, 10, 10, 32), marker(2, 60, 10, 32)));
        assertEquals(150, MarkerWhite.of(frame, two), 1e-12);
        fill(22, 22, 28, 28, 255);
        assertEquals(150, MarkerWhite.of(frame, two), 1e-12, "a glint");
    }

    @Test
    void markersAtTheBorderAndNoneAtAllAreNoFault() {
        Arrays.fill(grey, (byte) 90);
        assertEquals(90, MarkerWhite.of(frame, new Detections("frame", 100, 80, Arrays.asList(marker(1, -20, -5, 30),
                marker(2, 90, 70, 30)))), 0);
        assertTrue(Double.isNaN(MarkerWhite.of(frame, new Detections("frame", 100, 80, Collections.emptyList()))));
    }
}
