package org.cellgauge.android.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.PixelArea;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Sizes of frames and preview, the best first. */
class StreamChoiceTest {
    private static final long FAST_NS = 33_333_333;
    private static final long SLOW_NS = 100_000_000;

    private static CameraTraits.Builder camera(long minFrameDurationNs, int... sizes) {
        CameraTraits.Builder b = new CameraTraits.Builder("0");
        for (int i = 0; i < sizes.length; i += 2) {
            b.frameSize(new PixelSize(sizes[i], sizes[i + 1]), minFrameDurationNs);
            b.previewSize(new PixelSize(sizes[i], sizes[i + 1]));
        }
        return b;
    }

    private static PinholeCamera calibration(int width, int height) {
        return PinholeCamera.ideal(width, height, width, width, width / 2.0, height / 2.0);
    }

    private static List<String> frames(CameraTraits.Builder camera, PinholeCamera calibration) {
        return StreamChoice.of(camera.build(), calibration).stream().map(c -> c.frame().toString())
                .collect(Collectors.toList());
    }

    @Test
    void withoutACalibrationTheLargestUpToFullHdComesFirst() {
        List<String> frames = frames(camera(FAST_NS, 640, 480, 4032, 3024, 1280, 720, 1920, 1080, 1440, 1080), null);
        assertEquals("1920 x 1080", frames.get(0));
        assertEquals(5, frames.size());
    }

    @Test
    void aSlowLargeSizeComesAfterAFastSmallerOne() {
        CameraTraits.Builder camera = camera(FAST_NS, 1280, 720).frameSize(new PixelSize(1920, 1080), SLOW_NS);
        assertEquals(Arrays.asList("1280 x 720", "1920 x 1080"), frames(camera, null));
    }

    @Test
    void fifteenFramesASecondAreEnough() {
        CameraTraits.Builder camera = camera(FAST_NS, 1280, 720).frameSize(new PixelSize(1920, 1080), 66_666_667);
        assertEquals("1920 x 1080", frames(camera, null).get(0));
    }

    @Test
    void aDeviceThatDoesNotStateItsSpeedCountsAsFast() {
        assertEquals("1920 x 1080", frames(camera(0, 1280, 720, 1920, 1080), null).get(0));
    }

    @Test
    void whereNothingFitsTheBoundsTheNearestSizeIsTaken() {
        assertEquals("1024 x 768", frames(camera(FAST_NS, 320, 240, 1024, 768, 640, 480), null).get(0));
        assertEquals("2048 x 1536", frames(camera(FAST_NS, 4032, 3024, 2048, 1536), null).get(0));
    }

    @Test
    void ofEqualAreasTheSensorsShapeIsTaken() {
        // 1600 x 900 and 1200 x 1200 have the same number of pixels
        CameraTraits.Builder camera = camera(FAST_NS, 1600, 900, 1200, 1200);
        assertEquals("1600 x 900", frames(camera.activeArray(new PixelArea(0, 0, 4000, 2250)), null).get(0));
        assertEquals("1200 x 1200", frames(camera.activeArray(new PixelArea(0, 0, 3000, 3000)), null).get(0));
    }

    @Test
    void aCalibrationsOwnSizeComesFirstHoweverLarge() {
        CameraTraits.Builder camera = camera(SLOW_NS, 4032, 3024).frameSize(new PixelSize(1600, 1200), FAST_NS);
        assertEquals(Arrays.asList("4032 x 3024", "1600 x 1200"), frames(camera, calibration(4032, 3024)));
    }

    @Test
    void otherShapesThanTheCalibrationsAreNotOffered() {
        List<String> frames = frames(camera(FAST_NS, 1920, 1080, 640, 480, 1280, 960, 1280, 720),
                calibration(4032, 3024));
        assertEquals(Arrays.asList("1280 x 960", "640 x 480"), frames);
    }

    @Test
    void noSizeOfACalibrationsShapeIsNone() {
        assertTrue(frames(camera(FAST_NS, 1920, 1080, 1280, 720), calibration(640, 480)).isEmpty());
        // a calibration of turned photos is for another camera
        assertTrue(frames(camera(FAST_NS, 1920, 1080, 1280, 720), calibration(1080, 1920)).isEmpty());
    }

    @ParameterizedTest
    @CsvSource({"1920,1080,1280,720,true", "1366,768,1280,720,true", "854,480,1920,1080,true",
        "4032,3024,640,480,true", "1920,1088,1920,1080,false", "864,480,1280,720,false", "640,480,480,640,false",
        "1440,1080,1920,1080,false"})
    void shapesAreTheSameButForRounding(int w1, int h1, int w2, int h2, boolean same) {
        assertEquals(same, new PixelSize(w1, h1).sameShapeAs(new PixelSize(w2, h2)));
        assertEquals(same, new PixelSize(w2, h2).sameShapeAs(new PixelSize(w1, h1)));
    }

    @Test
    void thePreviewHasTheFramesShape() {
        CameraTraits camera = new CameraTraits.Builder("0").frameSize(new PixelSize(1280, 960), FAST_NS)
                .previewSize(new PixelSize(1920, 1080)).previewSize(new PixelSize(640, 480))
                .previewSize(new PixelSize(1440, 1080)).previewSize(new PixelSize(4032, 3024)).build();
        assertEquals(new PixelSize(1440, 1080), StreamChoice.of(camera, null).get(0).preview());
    }

    @Test
    void withoutAPreviewOfTheFramesShapeItHasTheFramesSize() {
        CameraTraits camera = new CameraTraits.Builder("0").frameSize(new PixelSize(1280, 960), FAST_NS)
                .previewSize(new PixelSize(1920, 1080)).build();
        assertEquals(new PixelSize(1280, 960), StreamChoice.of(camera, null).get(0).preview());
    }

    @Test
    void aCameraWithoutFramesHasNoChoice() {
        assertTrue(StreamChoice.of(new CameraTraits.Builder("0").build(), null).isEmpty());
    }

    @Test
    void theCameraThatLooksAwayFromTheUserMeasures() {
        CameraTraits front = camera(FAST_NS, 640, 480).facing(CameraTraits.Facing.FRONT).build();
        CameraTraits external = new CameraTraits.Builder("9").frameSize(new PixelSize(640, 480), 0).build();
        CameraTraits back = camera(FAST_NS, 640, 480).facing(CameraTraits.Facing.BACK).build();
        CameraTraits secondBack = camera(FAST_NS, 640, 480).facing(CameraTraits.Facing.BACK).build();
        assertEquals(back, CameraChoice.of(Arrays.asList(front, external, back, secondBack)));
        assertEquals(external, CameraChoice.of(Arrays.asList(front, external)));
        assertEquals(front, CameraChoice.of(Arrays.asList(front)));
    }

    @Test
    void whatTakesNoPhotosIsNoCamera() {
        CameraTraits depth = camera(FAST_NS, 640, 480).facing(CameraTraits.Facing.BACK).takesPhotos(false).build();
        CameraTraits empty = new CameraTraits.Builder("1").facing(CameraTraits.Facing.BACK).build();
        CameraTraits front = camera(FAST_NS, 640, 480).facing(CameraTraits.Facing.FRONT).build();
        assertEquals(front, CameraChoice.of(Arrays.asList(depth, empty, front)));
        assertEquals(null, CameraChoice.of(Arrays.asList(depth, empty)));
        assertFalse(depth.takesPhotos());
    }
}
