package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.IOException;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * A detector of frames starts at the tone curve of the frame before: it ends where one does that knows nothing, for a
 * frame in the same light and for one in another.
 */
class FramesOfACameraTest {
    private static final Path SCENE = Path.of(System.getProperty("cellgauge.root")).resolve("fixtures/plane-3");
    private static final double GAMMA = 2.2;
    /** A fit of the curve stops where a step moves edges by less than 0.002 px; the wrong curve moves them by 0.3. */
    private static final double SAME_PX = 0.005;

    private Cell cell;
    private GreyImage linear;
    private GreyImage curved;

    @BeforeEach
    void readPhoto() throws IOException {
        cell = CellReader.read(SCENE.resolve("cell.yaml"));
        BufferedImage picture = ImageIO.read(SCENE.resolve("photo.png").toFile());
        byte[] grey = ((DataBufferByte) picture.getRaster().getDataBuffer()).getData();
        byte[] otherwise = new byte[grey.length];
        for (int i = 0; i < grey.length; i++) {
            otherwise[i] = (byte) Math.round(255 * Math.pow((grey[i] & 0xFF) / 255.0, 1 / GAMMA));
        }
        linear = GreyImage.packed(grey, picture.getWidth(), picture.getHeight());
        curved = GreyImage.packed(otherwise, picture.getWidth(), picture.getHeight());
    }

    private static void assertSame(Detections expected, Detections found) {
        assertEquals(expected.markers().size(), found.markers().size());
        for (MarkerObservation marker : expected.markers()) {
            assertArrayEquals(marker.cornersPx(), found.find(marker.id()).cornersPx(), SAME_PX, "" + marker.id());
        }
    }

    @Test
    void aFrameInTheSameLightIsSeenAsByItself() {
        BoofMarkerDetector frames = BoofMarkerDetector.forFrames(cell);
        Detections first = frames.detect(curved, "first");
        assertEquals(6, first.markers().size());
        assertSame(first, frames.detect(curved, "second"));
    }

    @Test
    void aFrameWithAnotherCurveIsSeenAsByItself() {
        BoofMarkerDetector frames = BoofMarkerDetector.forFrames(cell);
        frames.detect(linear, "first");
        Detections second = frames.detect(curved, "second");
        assertSame(BoofMarkerDetector.forFrames(cell).detect(curved, "alone"), second);
        assertEquals(GAMMA, second.light().toneCurve().power(), 0.1);
        assertSame(BoofMarkerDetector.forFrames(cell).detect(linear, "alone"), frames.detect(linear, "third"));
    }
}
