package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.light.ToneCurve;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Frames of a camera are searched near the markers of the frame before: what is seen there is what a search of the
 * whole frame sees, and nothing is missing for it. The first frame of a detector is searched as a whole, and where the
 * tone curve is stated a frame's figures are its own: so a new detector is what to compare with.
 */
class FramesInWindowsTest {
    private static final Path FIXTURES = Path.of(System.getProperty("cellgauge.root")).resolve("fixtures");
    private static final int WHOLE_EVERY = SearchWindows.WHOLE_EVERY;

    private static Cell cell(String fixture) {
        return CellReader.read(FIXTURES.resolve(fixture).resolve("cell.yaml"))
                .withToneCurve(fixture.equals("plane-3") ? ToneCurve.LINEAR : ToneCurve.SRGB);
    }

    private static GreyImage photo(String fixture) {
        try {
            BufferedImage picture = ImageIO.read(FIXTURES.resolve(fixture).resolve("photo.png").toFile());
            return GreyImage.packed(((DataBufferByte) picture.getRaster().getDataBuffer()).getData(),
                    picture.getWidth(), picture.getHeight());
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    /** The photo as a camera sees it that looks another way, with some noise. */
    private static GreyImage moved(GreyImage photo, int du, int dv) {
        Random random = new Random(du + 1000L * dv);
        byte[] grey = new byte[photo.widthPx() * photo.heightPx()];
        for (int y = 0; y < photo.heightPx(); y++) {
            for (int x = 0; x < photo.widthPx(); x++) {
                int fromX = Math.max(0, Math.min(photo.widthPx() - 1, x - du));
                int fromY = Math.max(0, Math.min(photo.heightPx() - 1, y - dv));
                grey[y * photo.widthPx() + x] =
                        (byte) Math.max(0, Math.min(255, photo.get(fromX, fromY) + random.nextInt(3) - 1));
            }
        }
        return GreyImage.packed(grey, photo.widthPx(), photo.heightPx());
    }

    /** Dark patches on the ground, some of them up to the markers' margins. */
    private static GreyImage textured(GreyImage photo, Detections markers) {
        Random random = new Random(4);
        byte[] grey = photo.luminance().clone();
        for (int patch = 0; patch < 4000; patch++) {
            int side = 6 + random.nextInt(30);
            int left = random.nextInt(photo.widthPx() - side);
            int top = random.nextInt(photo.heightPx() - side);
            double factor = 0.3 + 0.6 * random.nextDouble();
            boolean free = markers.markers().stream().allMatch(m -> {
                double[] c = m.cornersPx();
                double u = (c[0] + c[4]) / 2;
                double v = (c[1] + c[5]) / 2;
                double away = Math.hypot(c[0] - c[4], c[1] - c[5]);
                return left > u + away || left + side < u - away || top > v + away || top + side < v - away;
            });
            for (int y = top; free && y < top + side; y++) {
                for (int x = left; x < left + side; x++) {
                    int at = y * photo.widthPx() + x;
                    grey[at] = (byte) (factor * (grey[at] & 0xFF));
                }
            }
        }
        return GreyImage.packed(grey, photo.widthPx(), photo.heightPx());
    }

    /** The photo without a marker. */
    private static GreyImage without(GreyImage photo, MarkerObservation marker) {
        byte[] grey = photo.luminance().clone();
        double[] c = marker.cornersPx();
        int u = (int) (c[0] + c[4]) / 2;
        int v = (int) (c[1] + c[5]) / 2;
        int reach = (int) Math.hypot(c[0] - c[4], c[1] - c[5]) * 5 / 8;
        for (int y = v - reach; y < v + reach; y++) {
            Arrays.fill(grey, y * photo.widthPx() + u - reach, y * photo.widthPx() + u + reach, (byte) 200);
        }
        return GreyImage.packed(grey, photo.widthPx(), photo.heightPx());
    }

    /** The photo with a marker of it a second time, elsewhere. */
    private static GreyImage withAnother(GreyImage photo, MarkerObservation marker, int du, int dv) {
        byte[] grey = photo.luminance().clone();
        double[] c = marker.cornersPx();
        int u = (int) (c[0] + c[4]) / 2;
        int v = (int) (c[1] + c[5]) / 2;
        int reach = (int) Math.hypot(c[0] - c[4], c[1] - c[5]) * 5 / 8;
        for (int y = v - reach; y < v + reach; y++) {
            for (int x = u - reach; x < u + reach; x++) {
                grey[(y + dv) * photo.widthPx() + x + du] = (byte) photo.get(x, y);
            }
        }
        return GreyImage.packed(grey, photo.widthPx(), photo.heightPx());
    }

    private static double middle(MarkerObservation marker, int axis) {
        return (marker.cornersPx()[axis] + marker.cornersPx()[4 + axis]) / 2;
    }

    private static Detections whole(Cell cell, GreyImage frame) {
        return BoofMarkerDetector.forFrames(cell).detect(frame, "frame");
    }

    private static void assertSame(Detections expected, Detections found) {
        assertEquals(expected.warnings(), found.warnings());
        assertEquals(ids(expected), ids(found));
        for (MarkerObservation marker : expected.markers()) {
            MarkerObservation other = found.find(marker.id());
            assertArrayEquals(marker.cornersPx(), other.cornersPx(), "" + marker.id());
            assertArrayEquals(marker.covariancePx2(), other.covariancePx2(), "" + marker.id());
        }
        assertEquals(expected.light().blurPx(), found.light().blurPx());
        assertEquals(expected.light().noiseGrey(), found.light().noiseGrey());
    }

    private static List<Integer> ids(Detections found) {
        return found.markers().stream().map(MarkerObservation::id).collect(Collectors.toList());
    }

    private static void assertFramesAreSeenAsByThemselves(Cell cell, GreyImage scene, int markers) {
        BoofMarkerDetector frames = BoofMarkerDetector.forFrames(cell);
        for (int k = 0; k < 6; k++) {
            GreyImage frame = moved(scene, 5 * k * (4 - k), 4 * (k % 3) - 4);
            Detections found = frames.detect(frame, "frame");
            assertEquals(k == 0, frames.windows().areWhole(), "frame " + k);
            assertEquals(markers, found.markers().size());
            assertSame(whole(cell, frame), found);
        }
    }

    @ParameterizedTest
    @CsvSource({"lifted-4, 7", "raised-3, 6", "distorted-4, 7", "apriltag-4, 7", "plane-3, 6"})
    void whatIsInWindowsIsSeenAsInTheWholeFrame(String fixture, int markers) {
        assertFramesAreSeenAsByThemselves(cell(fixture), photo(fixture), markers);
    }

    /** Windows cut through patches: their parts are squares that are none. */
    @ParameterizedTest
    @CsvSource({"lifted-4, 7", "distorted-4, 7", "apriltag-4, 7"})
    void onATextureToo(String fixture, int markers) {
        Cell cell = cell(fixture);
        GreyImage photo = photo(fixture);
        assertFramesAreSeenAsByThemselves(cell, textured(photo, whole(cell, photo)), markers);
    }

    @Test
    void behindAWideLensToo() {
        Cell flat = cell("lifted-4");
        GreyImage photo = photo("lifted-4");
        PinholeCamera narrow = flat.camera();
        PinholeCamera wide = PinholeCamera.of(KannalaBrandtLens.MODEL, narrow.widthPx(), narrow.heightPx(),
                new double[] {narrow.get(PinholeCamera.FX), narrow.get(PinholeCamera.FY),
                    narrow.get(PinholeCamera.CX), narrow.get(PinholeCamera.CY), 0, 0, 0, 0, 0});
        byte[] grey = new byte[narrow.widthPx() * narrow.heightPx()];
        double[] ray = new double[3];
        for (int y = 0; y < narrow.heightPx(); y++) {
            for (int x = 0; x < narrow.widthPx(); x++) {
                assertTrue(wide.toRay(x + 0.5, y + 0.5, ray));
                double[] at = narrow.project(ray[0], ray[1], ray[2]);
                grey[y * narrow.widthPx() + x] = (byte) Math.round(photo.interpolate(at[0], at[1]));
            }
        }
        assertFramesAreSeenAsByThemselves(flat.withCamera(wide),
                GreyImage.packed(grey, narrow.widthPx(), narrow.heightPx()), 7);
    }

    @Test
    void aMarkerOutsideOfItsWindowIsFoundInTheSameFrame() {
        Cell cell = cell("lifted-4");
        GreyImage photo = photo("lifted-4");
        BoofMarkerDetector frames = BoofMarkerDetector.forFrames(cell);
        frames.detect(photo, "frame");
        GreyImage jumped = moved(photo, 150, -60);
        assertSame(whole(cell, jumped), frames.detect(jumped, "frame"));
        // one of them alone, which comes back elsewhere
        Detections found = frames.detect(jumped, "frame");
        assertFalse(frames.windows().areWhole());
        MarkerObservation one = found.markers().get(2);
        GreyImage elsewhere = without(withAnother(jumped, one, -100, -60), one);
        Detections again = frames.detect(elsewhere, "frame");
        assertSame(whole(cell, elsewhere), again);
        assertEquals(ids(found), ids(again));
    }

    /** So there are as many squares in the windows as before. */
    @Test
    void anotherMarkerInItsWindowDoesNotStandForIt() {
        Cell cell = cell("lifted-4");
        GreyImage photo = photo("lifted-4");
        BoofMarkerDetector frames = BoofMarkerDetector.forFrames(cell);
        Detections found = frames.detect(photo, "frame");
        MarkerObservation one = found.markers().get(1);
        MarkerObservation other = found.markers().get(4);
        int du = (int) Math.round(middle(one, 0) - middle(other, 0));
        int dv = (int) Math.round(middle(one, 1) - middle(other, 1));
        GreyImage changed = withAnother(without(withAnother(photo, one, -60, 70), one), other, du, dv);
        Detections again = frames.detect(changed, "frame");
        assertNotNull(again.find(one.id()));
        assertTrue(frames.windows().areWhole());
        assertSame(whole(cell, changed), again);
    }

    @Test
    void aNewMarkerIsSeenSoon() {
        Cell cell = cell("lifted-4");
        GreyImage photo = photo("lifted-4");
        MarkerObservation one = whole(cell, photo).markers().get(1);
        GreyImage before = without(photo, one);
        BoofMarkerDetector frames = BoofMarkerDetector.forFrames(cell);
        assertNull(frames.detect(before, "frame").find(one.id()));
        int seen = 1;
        while (frames.detect(photo, "frame").find(one.id()) == null) {
            assertFalse(frames.windows().areWhole());
            seen++;
        }
        assertEquals(WHOLE_EVERY, seen);
    }

    @Test
    void aMarkerThatLeavesTheViewIsLookedForOnce() {
        Cell cell = cell("lifted-4");
        GreyImage photo = photo("lifted-4");
        BoofMarkerDetector frames = BoofMarkerDetector.forFrames(cell);
        MarkerObservation one = frames.detect(photo, "frame").markers().get(1);
        GreyImage after = without(photo, one);
        Detections expected = whole(cell, after);
        assertNull(expected.find(one.id()));
        for (int k = 0; k < 2 * WHOLE_EVERY; k++) {
            assertSame(expected, frames.detect(after, "frame"));
            assertEquals(k % WHOLE_EVERY == 0, frames.windows().areWhole(), "frame " + k);
        }
    }

    /** One whole search has missed it, and the frames from then on are searched in windows. */
    @Test
    void aMarkerThatFlickersIsSeenAtOnce() {
        Cell cell = cell("lifted-4");
        GreyImage photo = photo("lifted-4");
        BoofMarkerDetector frames = BoofMarkerDetector.forFrames(cell);
        MarkerObservation one = frames.detect(photo, "frame").markers().get(1);
        GreyImage hidden = without(photo, one);
        for (int k = 0; k < 3; k++) {
            assertNull(frames.detect(hidden, "frame").find(one.id()));
        }
        assertNotNull(frames.detect(photo, "frame").find(one.id()));
        assertFalse(frames.windows().areWhole());
    }

    @Test
    void anIdAtTwoPlacesIsRefusedInWindowsUntilOneIsGone() {
        Cell cell = cell("lifted-4");
        GreyImage photo = photo("lifted-4");
        MarkerObservation one = whole(cell, photo).markers().get(1);
        GreyImage twice = withAnother(photo, one, -60, 70);
        BoofMarkerDetector frames = BoofMarkerDetector.forFrames(cell);
        for (int k = 0; k < 4; k++) {
            Detections found = frames.detect(twice, "frame");
            assertEquals(k == 0, frames.windows().areWhole());
            assertNull(found.find(one.id()));
            assertTrue(found.warnings().stream().anyMatch(w -> w.kind() == DetectionWarning.SEEN_TWICE));
            assertSame(whole(cell, twice), found);
        }
        Detections found = frames.detect(photo, "frame");
        assertTrue(frames.windows().areWhole());
        assertSame(whole(cell, photo), found);
    }

    @Test
    void photosAreSearchedAsAWhole() {
        Cell cell = cell("lifted-4");
        BoofMarkerDetector photos = BoofMarkerDetector.forCell(cell);
        for (int k = 0; k < 3; k++) {
            photos.detect(photo("lifted-4"), "photo");
            assertTrue(photos.windows().areWhole());
        }
    }
}
