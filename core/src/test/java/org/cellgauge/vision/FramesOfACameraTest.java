package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
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

    @Test
    void aSharpenedFrameIsSeenAsByItself() {
        BoofMarkerDetector frames = BoofMarkerDetector.forFrames(cell);
        Detections first = frames.detect(sharpened(curved, 0.8), "first");
        Detections second = frames.detect(sharpened(curved, 0.8), "second");
        assertSame(first, second);
        assertEquals(6, first.markers().size());
        assertTrue(saysSharpened(first) && saysSharpened(second));
        // what a mask's doing leaves unknown is still allowed for
        assertEquals(first.light().edgeShiftStdPx(), second.light().edgeShiftStdPx(), 1e-12);
        assertEquals(first.light().outlineStdPx(), second.light().outlineStdPx(), 1e-4);
    }

    @Test
    void aFrameThatIsNoLongerSharpenedIsSeenAsByItself() {
        BoofMarkerDetector frames = BoofMarkerDetector.forFrames(cell);
        frames.detect(sharpened(curved, 0.8), "first");
        Detections second = frames.detect(curved, "second");
        assertSame(BoofMarkerDetector.forFrames(cell).detect(curved, "alone"), second);
        assertFalse(saysSharpened(second));
    }

    @Test
    void aFrameThatIsSharpenedFromNowOnIsSeenAsByItself() {
        BoofMarkerDetector frames = BoofMarkerDetector.forFrames(cell);
        frames.detect(curved, "first");
        Detections second = frames.detect(sharpened(curved, 0.8), "second");
        assertSame(BoofMarkerDetector.forFrames(cell).detect(sharpened(curved, 0.8), "alone"), second);
        assertTrue(saysSharpened(second));
    }

    /** Each marker is fitted by one thread, whichever that is. */
    @Test
    void markersFittedAtOnceAreSeenAsOneAfterAnother() {
        ExecutorService helpers = Executors.newFixedThreadPool(3);
        try {
            markersFittedAtOnceAreSeenAsOneAfterAnother(helpers);
            helpers.shutdown();
            markersFittedAtOnceAreSeenAsOneAfterAnother(helpers);
        } finally {
            helpers.shutdownNow();
        }
        // helpers that never come
        markersFittedAtOnceAreSeenAsOneAfterAnother(task -> { });
    }

    private void markersFittedAtOnceAreSeenAsOneAfterAnother(Executor helpers) {
        for (GreyImage photo : List.of(curved, sharpened(curved, 0.8))) {
            List<MarkerObservation> expected = BoofMarkerDetector.forCell(cell).detect(photo, "one").markers();
            List<MarkerObservation> found = BoofMarkerDetector.forCell(cell).spread(helpers, 4).detect(photo, "all")
                    .markers();
            assertEquals(6, found.size());
            for (int i = 0; i < found.size(); i++) {
                assertEquals(expected.get(i).id(), found.get(i).id());
                assertArrayEquals(expected.get(i).cornersPx(), found.get(i).cornersPx(), 0);
                assertArrayEquals(expected.get(i).covariancePx2(), found.get(i).covariancePx2(), 0);
            }
        }
    }

    private static boolean saysSharpened(Detections seen) {
        return seen.warnings().stream().anyMatch(w -> w.kind() == DetectionWarning.SHARPENED);
    }

    /** With a mask of a Gaussian of 1 px. */
    private static GreyImage sharpened(GreyImage of, double amount) {
        double[] weights = Unsharpened.weights(1);
        int width = of.widthPx();
        int height = of.heightPx();
        double[] rows = new double[width * height];
        byte[] out = new byte[width * height];
        for (int pass = 0; pass < 2; pass++) {
            for (int y = 0; y < height; y++) {
                for (int x = 0; x < width; x++) {
                    double sum = 0;
                    for (int k = 1 - weights.length; k < weights.length; k++) {
                        double weight = weights[Math.abs(k)];
                        sum += pass == 0 ? weight * of.get(Math.max(0, Math.min(width - 1, x + k)), y)
                                : weight * rows[Math.max(0, Math.min(height - 1, y + k)) * width + x];
                    }
                    if (pass == 0) {
                        rows[y * width + x] = sum;
                    } else {
                        double grey = of.get(x, y) + amount * (of.get(x, y) - sum);
                        out[y * width + x] = (byte) Math.round(Math.max(0, Math.min(255, grey)));
                    }
                }
            }
        }
        return GreyImage.packed(out, width, height);
    }
}
