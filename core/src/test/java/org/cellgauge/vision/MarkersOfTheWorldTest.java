package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.alg.filter.blur.BlurImageOps;
import boofcv.struct.image.GrayF32;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.vision.MarkerPattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Markers that people print, and what is said where they are not those of the cell. */
class MarkersOfTheWorldTest {
    private static final int WIDTH = 480;
    private static final int HEIGHT = 260;
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(WIDTH, HEIGHT, 600, 600, WIDTH / 2.0, HEIGHT / 2.0);
    private static final double GROUND = 150;

    private static double[] square(double u, double v, double side) {
        return new double[] {u, v, u + side, v, u + side, v + side, u, v + side};
    }

    private static DrawnMarkers picture() {
        return new DrawnMarkers(WIDTH, HEIGHT, GROUND);
    }

    private static Detections detect(GreyImage image, String family, Integer... ids) {
        return new BoofMarkerDetector(CAMERA, MarkerFamily.of(family), List.of(ids)).detect(image, "picture");
    }

    private static List<String> warnings(GreyImage image, String family, Integer... ids) {
        Detections found = detect(image, family, ids);
        assertEquals(List.of(), found.markers());
        return found.warnings().stream().map(Object::toString).collect(Collectors.toList());
    }

    private static void says(String start, List<String> warnings) {
        assertEquals(1, warnings.size(), warnings.toString());
        assertTrue(warnings.get(0).startsWith(start), warnings.toString());
    }

    @Test
    void noMarkerOfThreeByThreeCellsIsTakenForOneOfFourByFour() {
        DrawnMarkers picture = picture();
        MarkerFamily three = MarkerFamily.of("square-binary-3x3");
        for (int id = 0; id < 32; id++) {
            picture.draw(three, id, square(8.3 + id % 8 * 59, 12.6 + id / 8 * 62, 36.5));
        }
        GreyImage image = picture.image();
        List<Integer> all = IntStream.range(0, 4096).boxed().collect(Collectors.toList());
        assertEquals(List.of(), new BoofMarkerDetector(CAMERA, MarkerFamily.SQUARE_BINARY, all)
                .detect(image, "grids").markers().stream().map(MarkerObservation::id).collect(Collectors.toList()));
        all.removeIf(id -> id >= 32);
        assertEquals(all, new BoofMarkerDetector(CAMERA, three, all).detect(image, "grids").markers().stream()
                .map(MarkerObservation::id).collect(Collectors.toList()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"square-binary-3x3", "square-binary-5x5", "square-binary-6x6", "square-binary-7x7",
        "square-binary-8x8", "DICT_4X4_50", "DICT_4X4_1000"})
    void markersAreFoundWhereTheyAre(String family) {
        int id = MarkerFamily.of(family).size() / 2 + 3;
        double[] corners = {120.4, 60.3, 170.8, 64.2, 168.1, 115.9, 117.2, 110.5};
        MarkerObservation seen = detect(picture().draw(MarkerFamily.of(family), id, corners).image(), family, id)
                .find(id);
        assertNotNull(seen);
        // the corners that were drawn; what is found is good to some hundredths of a pixel
        assertArrayEquals(corners, seen.cornersPx(), 0.1);
    }

    /** Black is so many hundredths of white. */
    @ParameterizedTest
    @ValueSource(ints = {50, 65, 85})
    void faintMarkersAreFound(int percent) {
        double[] corners = square(200.3, 90.7, 64);
        Detections found = detect(picture().draw(MarkerFamily.of("tag36h11"), 7, corners, 2.1 * percent, 210).image(),
                "tag36h11", 7);
        assertNotNull(found.find(7));
        assertArrayEquals(corners, found.find(7).cornersPx(), 0.2);
        assertEquals(percent == 85 ? "the markers are faint: their black is 179 and their white 210 of 255, so that "
                + "noise and steps of grey weigh heavily; print them darker, or take away what dulls them" : "",
                found.warnings().stream().map(Object::toString).collect(Collectors.joining()));
    }

    /**
     * What OpenCV 4.12 and 5.0 draw of tag 7 and where {@code detectMarkers} sees the corners of it, plus 0.5:
     * <pre>
     * d = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_APRILTAG_36h11)
     * image = numpy.full((300, 300), 255, numpy.uint8)
     * image[60:188, 80:208] = cv2.aruco.generateImageMarker(d, 7, 128)
     * cv2.aruco.ArucoDetector(d).detectMarkers(image)[0][0] + 0.5
     * </pre>
     * The AprilTag library 3 (pupil-apriltags 1.0.4) sees them at (207.9, 59.9), (79.9, 59.9), (79.9, 187.9), (207.9,
     * 187.9): the lower left first, then against the clock.
     */
    @Test
    void aprilTagsAsOpenCvDrawsThemStartWhereOpenCvStarts() {
        String[] drawn = DRAWN_BY_OPENCV;
        byte[] grey = new byte[WIDTH * HEIGHT];
        for (int i = 0; i < grey.length; i++) {
            int x = i % WIDTH - 80;
            int y = i / WIDTH - 60;
            boolean inside = x >= 0 && y >= 0 && x < 128 && y < 128;
            grey[i] = (byte) (inside && drawn[y / 16].charAt(x / 16) == '0' ? 0 : 255);
        }
        GreyImage image = GreyImage.packed(grey, WIDTH, HEIGHT);
        double[] openCv = {80.5, 60.5, 207.5, 60.5, 207.5, 187.5, 80.5, 187.5};
        MarkerFamily family = MarkerFamily.of("tag36h11");
        assertArrayEquals(openCv, new BoofMarkerDetector(CAMERA, family.asOpenCvDraws(), List.of(7))
                .detect(image, "opencv").find(7).cornersPx(), 1);
        double[] aprilTag = {207.9, 187.9, 79.9, 187.9, 79.9, 59.9, 207.9, 59.9};
        assertArrayEquals(aprilTag, new BoofMarkerDetector(CAMERA, family, List.of(7)).detect(image, "april").find(7)
                .cornersPx(), 1);
    }

    private static final String[] DRAWN_BY_OPENCV = {"00000000", "00010100", "01110000", "00111010",
        "00010100", "00110000", "00010000", "00000000"};

    @ParameterizedTest
    @CsvSource({"square-binary, 944", "tag36h11, 94", "DICT_6X6_250, 94"})
    void invertedAndMirroredMarkersAreNamed(String family, int id) {
        MarkerPattern pattern = MarkerPattern.of(MarkerFamily.of(family), id);
        says("printed white on black: marker " + id + ";",
                warnings(picture().draw(pattern.inverted(), square(100.3, 80.2, 60), 20, 220).image(), family, id));
        says("mirrored: marker " + id + ";",
                warnings(picture().draw(pattern.mirrored(), square(100.3, 80.2, 60), 20, 220).image(), family, id));
        // one is missing, another is not
        Detections both = detect(picture().draw(pattern.mirrored(), square(100.3, 80.2, 60), 20, 220)
                .draw(MarkerFamily.of(family), 5, square(300.3, 80.2, 60)).image(), family, id, 5);
        assertEquals(5, both.markers().get(0).id());
        assertTrue(both.warnings().get(0).toString().startsWith("mirrored: marker " + id), both.warnings().toString());
    }

    @ParameterizedTest
    @CsvSource({"square-binary, DICT_4X4_50, aruco-ocv-4x4-1000", "square-binary, square-binary-3x3, square-binary-3x3",
        "tag36h11, square-binary, square-binary", "square-binary, tag25h9, apriltag-25h9"})
    void otherFamiliesAreNamed(String stated, String drawn, String named) {
        MarkerFamily family = MarkerFamily.of(drawn);
        says("in view are 2 markers of the family " + named + " (8 and 21), and the cell file says "
                + MarkerFamily.of(stated) + ";",
                warnings(picture().draw(family, 8, square(100.3, 80.2, 60)).draw(family, 21, square(300.3, 80.2, 60))
                        .image(), stated, 22, 94));
    }

    @Test
    void otherIdsAreNamed() {
        says("in view, but not in the cell file: marker 8 and 21;",
                warnings(picture().draw(MarkerFamily.SQUARE_BINARY, 8, square(100.3, 80.2, 60))
                        .draw(MarkerFamily.SQUARE_BINARY, 21, square(300.3, 80.2, 60)).image(), "square-binary", 22));
    }

    @Test
    void imagesThatShowNothingAreToldApart() {
        byte[] grey = new byte[WIDTH * HEIGHT];
        java.util.Arrays.fill(grey, (byte) 12);
        says("the image is nearly black: 99 % of it is at most 12 of 255;",
                warnings(GreyImage.packed(grey, WIDTH, HEIGHT), "tag36h11", 7));
        java.util.Arrays.fill(grey, (byte) 250);
        says("the image is nearly white: 99 % of it is at least 250 of 255;",
                warnings(GreyImage.packed(grey, WIDTH, HEIGHT), "tag36h11", 7));
        // a step of 160 grey levels, smeared by a Gaussian of 5 px
        for (int i = 0; i < grey.length; i++) {
            grey[i] = (byte) Math.round(50 + 160 * EdgeProfile.cumulative((i % WIDTH + 0.5 - WIDTH / 2.0) / 5));
        }
        says("the image is blurred: even its sharpest edges are smeared by 5.",
                warnings(GreyImage.packed(grey, WIDTH, HEIGHT), "tag36h11", 7));
        assertEquals(List.of(), warnings(picture().image(), "tag36h11", 7));
    }

    /**
     * Of pictures as blurred as photos are: without any blur a single marker tells neither its margin nor the curve,
     * and what is said of it hangs on where it lies to a thousandth of a pixel.
     */
    @ParameterizedTest
    @CsvSource({"0.2, false", "0.1, false", "0.02, true"})
    void marginThatIsTooThinIsNamed(double margin, boolean named) {
        for (int k = 0; k < 8; k++) {
            double[] drawn = square(100.3 + k * 0.125, 80.2 + k * 0.37, 29);
            Detections found = detect(blurred(picture().draw(MarkerPattern.of(MarkerFamily.SQUARE_BINARY, 944), drawn,
                    20, 220, margin).image()), "square-binary", 944);
            assertEquals(named, found.warnings().stream().anyMatch(w -> w.kind() == DetectionWarning.MARGIN_TOO_THIN),
                    k + ": " + found.warnings());
            // how far all sides lie outwards, and what is stated of that: by the marker, and beside that by the curve
            MarkerObservation seen = found.find(944);
            double[] corners = seen.cornersPx();
            double[] covariance = seen.covariancePx2();
            double[] inwards = EdgeShift.ofCorners(corners);
            double shift = 0;
            double variance = 0;
            double length = 0;
            for (int i = 0; i < 8; i++) {
                shift += inwards[i] * (corners[i] - drawn[i]);
                length += inwards[i] * inwards[i];
                for (int j = 0; j < 8; j++) {
                    variance += inwards[i] * covariance[8 * i + j] * inwards[j];
                }
            }
            shift /= length;
            double std = Math.sqrt(variance) / length;
            double stated = Math.hypot(std, found.light().edgeShiftStdPx());
            assertTrue(Math.abs(shift) < 3 * stated, k + ": " + shift + " px, stated " + stated);
            assertEquals(named, std > 0.1, k + ": " + std + " px");
        }
    }

    /** By 0.6 px, with noise of one grey level. */
    private static GreyImage blurred(GreyImage sharp) {
        GrayF32 grey = new GrayF32(WIDTH, HEIGHT);
        for (int i = 0; i < grey.data.length; i++) {
            grey.data[i] = sharp.get(i % WIDTH, i / WIDTH);
        }
        GrayF32 blurred = BlurImageOps.gaussian(grey, null, 0.6, 4, null);
        Random random = new Random(1);
        byte[] out = new byte[grey.data.length];
        for (int i = 0; i < out.length; i++) {
            out[i] = (byte) Math.max(0, Math.min(255, Math.round(blurred.data[i] + random.nextGaussian())));
        }
        return GreyImage.packed(out, WIDTH, HEIGHT);
    }

    @Test
    void everyPlaceOfAnIdIsNamed() {
        DrawnMarkers picture = picture();
        List<String> places = new ArrayList<>();
        for (int k = 0; k < 3; k++) {
            picture.draw(MarkerFamily.SQUARE_BINARY, 5, square(50.3 + 140 * k, 80.2, 40));
            places.add("(" + (70 + 140 * k) + ", 100)");
        }
        says("marker 5 is seen at 3 places, " + places.get(0) + ", " + places.get(1) + " and " + places.get(2)
                + " px, and is left out;", warnings(picture.image(), "square-binary", 5));
    }
}
