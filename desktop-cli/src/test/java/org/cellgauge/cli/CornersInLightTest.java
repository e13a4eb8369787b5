package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.desktop.render.Backdrop;
import org.cellgauge.desktop.render.GreyJpeg;
import org.cellgauge.desktop.render.Scene;
import org.cellgauge.desktop.render.Sensor;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.vision.DetectionWarning;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Corners found in light against corners that were rendered: whatever the tone curve, the sides lie where they are but
 * for the shift that the inner edges measure, and the stated covariance is that of the errors.
 *
 * <p>The mean of e' S^-1 e / 8 over the 40 markers has 320 degrees of freedom, so a deviation of 0.08 about 1 if S is
 * right; the bounds 0.85 and 1.2 leave room beside it for what the model of the light leaves out, which weighs more the
 * larger markers and the stronger blur are. The noise is 1.5 grey levels.
 */
class CornersInLightTest {
    private static final String BINARY = "square-binary";
    private static final double SMALL_MM = 47;
    private static final double LARGE_MM = 88;

    private static Sensor sensor(double blurPx, ToneCurve curve) {
        return Sensor.IDEAL.withNoiseGrey(1.5).withBlurPx(blurPx).withToneCurve(curve);
    }

    private static boolean warns(MarkerField.Found found, DetectionWarning kind) {
        return found.detections.warnings().stream().anyMatch(w -> w.kind() == kind);
    }

    /** Nothing is said of the curve, and the edges alone have to tell it. */
    @ParameterizedTest
    @CsvSource({
        "linear,    0.3, 47", "linear,    0.7, 47", "linear,    1.2, 47", "linear,    0.7, 88", "linear,    1.2, 88",
        "srgb,      0.3, 47", "srgb,      0.7, 47", "srgb,      1.2, 47", "srgb,      0.7, 88", "srgb,      1.2, 88",
        "gamma 2.2, 0.3, 47", "gamma 2.2, 0.7, 47", "gamma 2.2, 1.2, 47", "gamma 2.2, 0.7, 88", "gamma 2.2, 1.2, 88",
    })
    void edgesTellTheCurveAndTheShiftThatIsLeft(String words, double blurPx, double sizeMm) {
        ToneCurve curve = ToneCurve.of(words);
        MarkerField field = MarkerField.of(BINARY, sizeMm);
        MarkerField.Found found = field.find(field.photo(sensor(blurPx, curve)), null);
        assertTrue(found.detections.light().toneCurveEstimated());
        assertEquals(0, found.leftPx, 0.012, found.toString());
        ToneCurve estimated = found.detections.light().toneCurve();
        if (curve == ToneCurve.SRGB) {
            // no power is sRGB: the nearest ones differ from it by 0.01 of white, and the edges tell it to another 0.01
            for (double grey : new double[] {0.3, 0.5, 0.7}) {
                assertEquals(curve.light(grey), estimated.light(grey), 0.02, found.toString());
            }
        } else {
            assertEquals(curve.power(), estimated.power(), 0.1, found.toString());
        }
    }

    /** The file says sRGB: then a curve of that kind is sought, and found again. */
    @Test
    void curveThatTheFileSaysIsConfirmed() {
        MarkerField field = MarkerField.of(BINARY, SMALL_MM);
        GreyImage photo = field.photo(sensor(0.7, ToneCurve.SRGB)).withToneCurve(ToneCurve.SRGB);
        MarkerField.Found found = field.find(photo, null);
        assertEquals(0, found.leftPx, 0.012, found.toString());
        for (double grey : new double[] {0.3, 0.5, 0.7}) {
            assertEquals(ToneCurve.SRGB.light(grey), found.detections.light().toneCurve().light(grey), 0.01,
                    found.toString());
        }
    }

    /** The curve is stated, so all that is left is noise, and its covariance must be the stated one. */
    @ParameterizedTest
    @CsvSource({
        "square-binary,  linear,    0.3, 47, 0.85, 1.2",
        "square-binary,  srgb,      0.3, 47, 0.85, 1.2",
        "square-binary,  gamma 2.2, 0.3, 88, 0.85, 1.2",
        "square-binary,  linear,    0.7, 47, 0.85, 1.2",
        "square-binary,  srgb,      0.7, 88, 0.85, 1.2",
        "square-binary,  gamma 2.2, 0.7, 47, 0.85, 1.2",
        "square-binary,  linear,    1.2, 88, 0.8,  1.3",
        "square-binary,  srgb,      1.2, 88, 0.8,  1.3",
        "square-binary,  gamma 2.2, 1.2, 47, 0.8,  1.3",
        "apriltag-36h11, linear,    0.7, 88, 0.85, 1.2",
        "apriltag-36h11, srgb,      0.7, 88, 0.85, 1.2",
    })
    void covarianceIsThatOfTheErrors(String family, String words, double blurPx, double sizeMm, double least,
            double most) {
        ToneCurve curve = ToneCurve.of(words);
        MarkerField field = MarkerField.of(family, sizeMm);
        MarkerField.Found found = field.find(field.photo(sensor(blurPx, curve)), curve);
        assertFalse(found.detections.light().toneCurveEstimated());
        assertEquals(0, found.insidePx, 0.005, found.toString());
        assertEquals(0, found.leftPx, 0.008, found.toString());
        assertEquals((least + most) / 2, found.chiSquarePerValue, (most - least) / 2, found.toString());
    }

    /** Lines are fitted in undistorted pixels: their covariance goes through the lens with the corners. */
    @Test
    void covarianceGoesThroughTheLens() {
        MarkerField field = MarkerField.of(BINARY, LARGE_MM, -0.3, 0.08, Backdrop.plain(), Scene.DEFAULT_QUIET_ZONE, 0);
        MarkerField.Found found = field.find(field.photo(sensor(0.7, ToneCurve.LINEAR)), ToneCurve.LINEAR);
        assertEquals(0, found.insidePx, 0.005, found.toString());
        assertEquals(1, found.chiSquarePerValue, 0.3, found.toString());
    }

    /** Ink that spreads moves edges outwards: so much in mm is so much in pixels where the marker stands. */
    @ParameterizedTest
    @CsvSource({"-0.2, linear", "0.2, linear", "0.2, srgb", "0.4, linear"})
    void spreadingInkIsMeasuredAsAShift(double printGainMm, String words) {
        ToneCurve curve = ToneCurve.of(words);
        MarkerField field = MarkerField.of(BINARY, LARGE_MM, 0, 0, Backdrop.plain(), Scene.DEFAULT_QUIET_ZONE,
                printGainMm);
        MarkerField.Found found = field.find(field.photo(sensor(0.7, curve)), curve);
        double expected = -printGainMm * MarkerField.PX_PER_MM;
        // foreshortening makes less of the gain across a tilted marker: by 2 % in the mean
        assertEquals(expected, found.insidePx, 0.05 * Math.abs(expected), found.toString());
        assertEquals(expected, found.shiftPx, 0.05 * Math.abs(expected), found.toString());
    }

    @Test
    void paperThatEndsNearTheBorderMovesNoEdge() {
        MarkerField field = MarkerField.of(BINARY, SMALL_MM, 0, 0, Backdrop.plain(), 0.1, 0);
        MarkerField.Found found = field.find(field.photo(sensor(0.7, ToneCurve.LINEAR)), ToneCurve.LINEAR);
        assertEquals(0, found.insidePx, 0.015, found.toString());
        assertEquals(40, found.markers);
        MarkerField large = MarkerField.of(BINARY, LARGE_MM, 0, 0, Backdrop.plain(), 0.1, 0);
        found = large.find(large.photo(sensor(0.7, ToneCurve.SRGB)), ToneCurve.SRGB);
        assertEquals(0, found.insidePx, 0.005, found.toString());
    }

    @Test
    void clippedWhitesAreNoMeasurementsWhereTheCurveIsStated() {
        MarkerField field = MarkerField.of(BINARY, LARGE_MM);
        GreyImage photo = field.photo(sensor(0.7, ToneCurve.SRGB).withExposure(1.3));
        MarkerField.Found found = field.find(photo, ToneCurve.SRGB);
        assertTrue(warns(found, DetectionWarning.WHITES_CLIPPED), found.toString());
        assertEquals(0, found.rmsPx, 0.02, found.toString());
        assertEquals(0, found.insidePx, 0.005, found.toString());
        assertFalse(found.detections.light().toneCurveOpen());
        // a frame of a camera that is clipped is a frame all the same: markers are found, a check refuses it
        MarkerField.Found unknown = field.find(photo, null);
        assertEquals(40, unknown.markers);
        assertTrue(unknown.detections.light().toneCurveOpen(), unknown.toString());
    }

    @Test
    void aLampThatOneMarkerMirrorsIsSaidOfItAlone() {
        MarkerField field = MarkerField.of(BINARY, LARGE_MM);
        GreyImage photo = field.photo(sensor(0.7, ToneCurve.SRGB));
        MarkerField.Found found = field.find(photo, ToneCurve.SRGB);
        assertFalse(warns(found, DetectionWarning.GLARE), found.toString());
        MarkerObservation mirrors = found.detections.markers().get(0);
        double[] corners = mirrors.cornersPx();
        double right = Math.max(Math.max(corners[0], corners[2]), Math.max(corners[4], corners[6]));
        double left = Math.min(Math.min(corners[0], corners[2]), Math.min(corners[4], corners[6]));
        double top = Math.min(Math.min(corners[1], corners[3]), Math.min(corners[5], corners[7]));
        double margin = 0.15 * (right - left);
        for (int y = (int) (top - margin); y < top + right - left + margin; y++) {
            for (int x = (int) (right - margin); x < right + margin; x++) {
                int at = y * photo.widthPx() + x;
                photo.luminance()[at] = (byte) Math.min(255, 2 * (photo.luminance()[at] & 0xFF));
            }
        }
        found = field.find(photo, ToneCurve.SRGB);
        List<Object> glaring = new ArrayList<>();
        found.detections.warnings().stream().filter(w -> w.kind() == DetectionWarning.GLARE)
                .forEach(w -> glaring.add(w.arguments().get(0)));
        assertEquals(List.of(mirrors.id()), glaring, found.toString());
        assertFalse(warns(found, DetectionWarning.WHITES_CLIPPED), found.toString());
    }

    @Test
    void darkPhotosAreNoted() {
        MarkerField field = MarkerField.of(BINARY, LARGE_MM);
        GreyImage photo = field.photo(sensor(0.7, ToneCurve.LINEAR).withExposure(0.1));
        MarkerField.Found found = field.find(photo, ToneCurve.LINEAR);
        assertTrue(warns(found, DetectionWarning.TOO_DARK), found.toString());
        // a tenth of the contrast is ten times the error of a usual exposure, 0.004 px
        assertEquals(0, found.rmsPx, 0.06, found.toString());
        assertEquals(1, found.chiSquarePerValue, 0.3, found.toString());
        MarkerField.Found usual = field.find(field.photo(sensor(0.7, ToneCurve.LINEAR)), ToneCurve.LINEAR);
        assertFalse(warns(usual, DetectionWarning.TOO_DARK), usual.toString());
    }

    /** The darkest pixel of a dark photo is 0: a fit that starts there must find its way back, as it does in light. */
    @Test
    void curveThatIsAlmostLinearIsFittedLikeALinearOneInTheDark() {
        MarkerField field = MarkerField.of(BINARY, LARGE_MM);
        GreyImage photo = field.photo(sensor(0.7, ToneCurve.LINEAR).withExposure(0.3));
        MarkerField.Found linear = field.find(photo, ToneCurve.LINEAR);
        MarkerField.Found almost = field.find(photo, ToneCurve.gamma(1.001));
        assertEquals(linear.insidePx, almost.insidePx, 0.002, almost.toString());
        assertEquals(linear.shiftPx, almost.shiftPx, 0.002, almost.toString());
    }

    /** Overshoot is seen, and what it does to the edges is seen by the inner ones. */
    @ParameterizedTest
    @CsvSource({"0.3, 0.5, linear", "0.5, 0.5, linear", "0.5, 0.5, srgb", "0.7, 1, linear"})
    void sharpenedPhotosAreNotedAndTheirShiftMeasured(double blurPx, double amount, String words) {
        MarkerField field = MarkerField.of(BINARY, SMALL_MM);
        MarkerField.Found found = field.find(field.photo(sensor(blurPx, ToneCurve.of(words)).withUnsharp(amount, 1)),
                null);
        assertTrue(warns(found, DetectionWarning.SHARPENED), found.toString());
        assertEquals(0, found.leftPx, 0.02, found.toString());
    }

    /**
     * Blocks of a JPEG file leave noise and edges that look like a mask's doing, which must not be undone: corners are
     * then as precise as stated but for what all outlines may be off by.
     */
    @Test
    void blocksOfAStronglyCompressedFileAreNoMask() throws IOException {
        MarkerField field = MarkerField.of(BINARY, SMALL_MM);
        GreyImage photo = field.photo(sensor(0.7, ToneCurve.SRGB));
        MarkerField.Found weak = field.find(GreyJpeg.roundTrip(photo, 97), null);
        assertFalse(warns(weak, DetectionWarning.IN_BLOCKS), weak.toString());
        MarkerField.Found strong = field.find(GreyJpeg.roundTrip(photo, 70), null);
        assertTrue(warns(strong, DetectionWarning.IN_BLOCKS), strong.toString());
        // 0.012 px in the dark if nothing were known of what blocks do
        assertEquals(0, strong.leftPx, 0.008, strong.toString());
        assertFalse(warns(strong, DetectionWarning.SHARPENED), strong.toString());
        assertTrue(strong.chiSquareLessShift < 1.2, strong.toString());
        // moved as in a cropped photo, the grid still shows
        assertTrue(warns(field.find(moved(GreyJpeg.roundTrip(photo, 70), 3, 5), null), DetectionWarning.IN_BLOCKS));
    }

    private static GreyImage moved(GreyImage image, int dx, int dy) {
        int width = image.widthPx();
        int height = image.heightPx();
        byte[] grey = new byte[width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                grey[y * width + x] = (byte) image.get(Math.min(width - 1, x + dx), Math.min(height - 1, y + dy));
            }
        }
        return GreyImage.packed(grey, width, height);
    }

    /**
     * The mask is found and undone: sides lie where they are, and the covariance is that of their errors, also where
     * the overshoot is cut off at white (sharp edges: 40 of 255 beyond a white of 237).
     */
    @ParameterizedTest
    @CsvSource({"0.3, 0.6, 1, 88", "0.7, 0.6, 1, 47", "0.7, 1, 1, 47"})
    void unsharpMaskIsUndone(double blurPx, double amount, double radiusPx, double sizeMm) {
        MarkerField field = MarkerField.of(BINARY, sizeMm);
        GreyImage photo = field.photo(sensor(blurPx, ToneCurve.SRGB).withUnsharp(amount, radiusPx));
        MarkerField.Found found = field.find(photo, ToneCurve.SRGB);
        assertTrue(warns(found, DetectionWarning.SHARPENED), found.toString());
        assertEquals(0, found.leftPx, 0.005, found.toString());
        assertEquals(1.5, found.detections.light().noiseGrey(), 0.15, found.toString());
        assertEquals(1.025, found.chiSquareLessShift, 0.175, found.toString());
    }

    /**
     * A blur of more than a pixel hides the mask from the edges, which pass for sharper ones and then lie 0.005 to 0.01
     * px in the dark; the noise of the ground tells it, the amount to 0.12 and so the noise before it to some 5 %.
     */
    @ParameterizedTest
    @CsvSource({"1.2, 0.6, 1, 47, 1", "1.2, 0.6, 1, 88, 0.1", "1.2, 1, 1, 47, 1", "1, 0.4, 1, 60, 1"})
    void aMaskThatBlurHidesIsToldByTheNoise(double blurPx, double amount, double radiusPx, double sizeMm,
            double exposure) {
        MarkerField field = MarkerField.of(BINARY, sizeMm);
        MarkerField.Found found = field.find(field.photo(sensor(blurPx, ToneCurve.SRGB).withExposure(exposure)
                .withUnsharp(amount, radiusPx)), null);
        assertEquals(1.5, found.detections.light().noiseGrey(), 0.15, found.toString());
        assertEquals(blurPx, found.detections.light().blurPx(), 0.05, found.toString());
        assertEquals(0, found.leftPx, exposure == 1 ? 0.004 : 0.01, found.toString());
    }

    /** White between the edges of a code is brighter after a mask than that of a margin, which is no thinner for it. */
    @Test
    void noMarginIsThinForWhatAMaskDoes() {
        MarkerField field = MarkerField.of(BINARY, 43);
        MarkerField.Found found = field.find(field.photo(sensor(0.7, ToneCurve.SRGB).withUnsharp(0.6, 1)), null);
        assertFalse(warns(found, DetectionWarning.MARGIN_TOO_THIN), found.toString());
        assertEquals(1, found.chiSquareLessShift, 0.2, found.toString());
    }

    /**
     * Pixels along a sharp side tell a sharper edge here or a more blurred one there: without the blur of the others
     * places were off by 0.2 px with a stated 0.003 px.
     */
    @ParameterizedTest
    @CsvSource({"0.3, 0.6", "0.3, 0"})
    void sidesAlongARowOfPixelsAreNoWorseThanStated(double blurPx, double amount) {
        MarkerField field = MarkerField.alongRows(BINARY, 90);
        MarkerField.Found found = field.find(field.photo(amount == 0 ? sensor(blurPx, ToneCurve.SRGB)
                : sensor(blurPx, ToneCurve.SRGB).withUnsharp(amount, 1)), null);
        assertEquals(40, found.markers, found.toString());
        assertEquals(1, found.chiSquareLessShift, 0.3, found.toString());
    }

    /** Blur brings the light of each side into the band of the next: by the fits alone they would be. */
    @Test
    void markersNearTheLimitOfBlurAreNoWorseThanStated() {
        MarkerField field = MarkerField.of(BINARY, 60);
        MarkerField.Found found = field.find(field.photo(sensor(1.83, ToneCurve.LINEAR)), null);
        assertTrue(found.markers >= 20, found.toString());
        assertEquals(1, found.chiSquareLessShift, 0.25, found.toString());
    }

    /** A blur of 0.8 px would be too much for one of these markers, but after the mask no edge is so flat. */
    @Test
    void sharpenedMarkersAreLeftOutByTheBlurThatThePhotoShows() {
        MarkerField field = MarkerField.of("aruco-mip-25h7", 43);
        GreyImage photo = field.photo(sensor(0.8, ToneCurve.SRGB).withNoiseGrey(5.9).withUnsharp(0.6, 1));
        MarkerField.Found found = field.find(photo, null);
        assertTrue(warns(found, DetectionWarning.SHARPENED), found.toString());
        assertEquals(40, found.markers, found.toString());
        assertEquals(1, found.chiSquareLessShift, 0.3, found.toString());
    }

    /**
     * Edges overshoot, but the noise is smooth, as cameras' filters and JPEG leave it: no mask makes such noise, and
     * undoing one would call 6 grey levels of it 3.9, with corners a quarter worse.
     */
    @Test
    void overshootThatNoiseDoesNotBearOutIsNotUndone() {
        MarkerField field = MarkerField.of(BINARY, SMALL_MM);
        GreyImage photo = field.photo(sensor(0.7, ToneCurve.SRGB).withNoiseGrey(0.3).withUnsharp(1, 1));
        MarkerField.Found found = field.find(withSmoothNoise(photo, 6), null);
        assertTrue(warns(found, DetectionWarning.SHARPENED), found.toString());
        assertEquals(6, found.detections.light().noiseGrey(), 0.5, found.toString());
    }

    /** Adds noise that is the mean of three by three pixels' white noise, of the deviation given. */
    private static GreyImage withSmoothNoise(GreyImage photo, double stdGrey) {
        int width = photo.widthPx();
        byte[] grey = photo.luminance().clone();
        double[] white = new double[grey.length];
        RandomGenerator random = new Well19937c(3);
        for (int i = 0; i < white.length; i++) {
            white[i] = random.nextGaussian();
        }
        for (int i = width + 1; i < grey.length - width - 1; i++) {
            double sum = 0;
            for (int k = 0; k < 9; k++) {
                sum += white[i + k % 3 - 1 + (k / 3 - 1) * width];
            }
            grey[i] = (byte) Math.max(0, Math.min(255, Math.round((grey[i] & 0xFF) + stdGrey * sum / 3)));
        }
        return GreyImage.packed(grey, width, photo.heightPx());
    }

    /** No sharpening is seen where there is none, however sharp the edges. */
    @ParameterizedTest
    @CsvSource({"0, linear", "0.3, linear", "0.3, srgb", "0.7, gamma 2.2"})
    void photosThatAreNotSharpenedAreNotCalledSo(double blurPx, String words) {
        MarkerField field = MarkerField.of(BINARY, SMALL_MM);
        MarkerField.Found found = field.find(field.photo(sensor(blurPx, ToneCurve.of(words))), null);
        assertFalse(warns(found, DetectionWarning.SHARPENED), found.toString());
    }
}
