package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.overlay.ImageOrientation;
import org.junit.jupiter.api.Test;

/**
 * Corners found in a turned picture are the turned corners of the picture: the convention of pixels holds throughout.
 */
class TurnedImageTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;
    private static final List<Integer> IDS = Arrays.asList(5, 944);
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(WIDTH, HEIGHT, 581, 581, 320, 240);

    /** Row r and column c of the picture go to row c and column (height - 1 - r). */
    private static byte[] turnedClockwise(byte[] grey, int width, int height) {
        byte[] out = new byte[grey.length];
        for (int r = 0; r < height; r++) {
            for (int c = 0; c < width; c++) {
                out[c * height + height - 1 - r] = grey[r * width + c];
            }
        }
        return out;
    }

    private static Detections detect(byte[] grey, int width, int height) {
        PinholeCamera camera = PinholeCamera.ideal(width, height, 581, 581, width / 2.0, height / 2.0);
        return new BoofMarkerDetector(camera, MarkerFamily.SQUARE_BINARY, IDS)
                .detect(GreyImage.packed(grey, width, height), "turned");
    }

    @Test
    void cornersTurnWithThePicture() {
        DrawnMarkers picture = new DrawnMarkers(WIDTH, HEIGHT, 130);
        picture.draw(MarkerFamily.SQUARE_BINARY, 944, DrawnMarkers.corners(CAMERA,
                RigidTransform.ofEuler(-90, -30, 500, Math.PI + 0.2, -0.3, 0.4), 47));
        picture.draw(MarkerFamily.SQUARE_BINARY, 5, DrawnMarkers.corners(CAMERA,
                RigidTransform.ofEuler(120, 60, 600, Math.PI - 0.3, 0.1, 2), 60));
        byte[] grey = picture.bytes(1, 1);
        int width = WIDTH;
        int height = HEIGHT;
        Detections plain = detect(grey, width, height);
        for (int q = 1; q < 4; q++) {
            grey = turnedClockwise(grey, width, height);
            int swap = width;
            width = height;
            height = swap;
            Detections turned = detect(grey, width, height);
            ImageOrientation orientation = ImageOrientation.of(q, false);
            assertEquals(width, orientation.uprightWidthPx(WIDTH, HEIGHT));
            for (int id : IDS) {
                // the same pixels, so all but the order in which the detector walks through them is the same
                assertArrayEquals(orientation.map(plain.find(id).cornersPx(), WIDTH, HEIGHT),
                        turned.find(id).cornersPx(), 0.02, "marker " + id + ", " + q + " turns");
            }
        }
    }
}
