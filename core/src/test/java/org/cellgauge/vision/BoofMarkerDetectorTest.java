package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.abst.fiducial.SquareBinary_to_FiducialDetector;
import boofcv.factory.distort.LensDistortionFactory;
import boofcv.factory.fiducial.ConfigFiducialBinary;
import boofcv.factory.fiducial.FactoryFiducial;
import boofcv.struct.calib.CameraPinholeBrown;
import boofcv.struct.image.GrayU8;
import georegression.struct.point.Point3D_F64;
import georegression.struct.se.Se3_F64;
import georegression.transform.se.SePointOps_F64;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BoofMarkerDetectorTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(WIDTH, HEIGHT, 581, 575, 322, 238);
    private static final MarkerFamily BINARY = MarkerFamily.SQUARE_BINARY;
    private static final double SIZE_MM = 47;

    /** Facing the camera (y up there is y down here), turned and tilted by the Euler angles. */
    private static RigidTransform facing(double x, double y, double z, double psi, double theta, double phi) {
        return RigidTransform.ofEuler(x, y, z, Math.PI + psi, theta, phi);
    }

    private static double[] square(double centreX, double centreY, double half) {
        return new double[] {centreX - half, centreY - half, centreX + half, centreY - half, centreX + half,
            centreY + half, centreX - half, centreY + half};
    }

    private static DrawnMarkers picture() {
        return new DrawnMarkers(WIDTH, HEIGHT, 130);
    }

    private static BoofMarkerDetector detector(Integer... ids) {
        return new BoofMarkerDetector(CAMERA, BINARY, Arrays.asList(ids));
    }

    private static List<Integer> ids(Detections found) {
        return found.markers().stream().map(MarkerObservation::id).collect(Collectors.toList());
    }

    @Test
    void cornersStandInTheMarkersOwnOrderHoweverItIsTurned() {
        for (int turn = 0; turn < 8; turn++) {
            RigidTransform pose = facing(10, -20, 500, 0.2, -0.3, turn * Math.PI / 4 + 0.1);
            double[] truth = DrawnMarkers.corners(CAMERA, pose, SIZE_MM);
            Detections found = detector(944).detect(picture().draw(BINARY, 944, truth).image(), "turned");
            assertEquals(List.of(944), ids(found), "turn " + turn);
            // 8x8 points per pixel place an edge within 1/16 px
            assertArrayEquals(truth, found.find(944).cornersPx(), 1.0 / 16, "turn " + turn);
            assertEquals(List.of(), found.warnings());
        }
    }

    @Test
    void cornersAgreeWithThePoseThatBoofCvFinds() {
        double[] truth = DrawnMarkers.corners(CAMERA, facing(-30, 15, 400, -0.3, 0.35, 2.0), SIZE_MM);
        DrawnMarkers picture = picture().draw(BINARY, 22, truth);
        double[] found = detector(22).detect(picture.image(), "pose").find(22).cornersPx();

        SquareBinary_to_FiducialDetector<GrayU8> boof =
                FactoryFiducial.squareBinary(new ConfigFiducialBinary(SIZE_MM), null, GrayU8.class);
        boof.setLensDistortion(LensDistortionFactory.narrow(
                new CameraPinholeBrown(581, 575, 0, 322, 238, WIDTH, HEIGHT)), WIDTH, HEIGHT);
        GrayU8 image = new GrayU8(WIDTH, HEIGHT);
        image.data = picture.bytes(1, 1);
        boof.detect(image);
        assertEquals(1, boof.totalFound());
        assertEquals(22, boof.getId(0));
        Se3_F64 cameraFromMarker = new Se3_F64();
        assertTrue(boof.getFiducialToCamera(0, cameraFromMarker));
        double[] corners = MarkerGeometry.cornersMm(SIZE_MM);
        for (int i = 0; i < 4; i++) {
            Point3D_F64 p = new Point3D_F64(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]);
            SePointOps_F64.transform(cameraFromMarker, p, p);
            // BoofCV's default refinement is good to some tenths of a pixel
            assertArrayEquals(CAMERA.project(p.x, p.y, p.z), new double[] {found[2 * i], found[2 * i + 1]}, 0.5);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"apriltag-36h11", "aruco-mip-25h7", "apriltag-16h5", "aruco-original",
        "aruco-ocv-6x6-1000"})
    void dictionariesAreReadByTheirNames(String name) {
        MarkerFamily family = MarkerFamily.of(name);
        double[] truth = DrawnMarkers.corners(CAMERA, facing(10, 20, 450, 0.2, 0.3, 1.0), SIZE_MM);
        GreyImage image = picture().draw(family, 7, truth).image();
        Detections found = new BoofMarkerDetector(CAMERA, family, List.of(3, 7)).detect(image, name);
        assertEquals(List.of(7), ids(found));
        assertArrayEquals(truth, found.find(7).cornersPx(), 1.0 / 16);
    }

    @Test
    void markersThatTheCellDoesNotNameAreNotReported() {
        GreyImage image = picture().draw(BINARY, 5, square(200.3, 200.7, 30)).draw(BINARY, 20, square(400.2, 250.4, 30))
                .image();
        Detections found = detector(20).detect(image, "two");
        assertEquals(List.of(20), ids(found));
        assertEquals(List.of(), found.warnings());
        // where one of the cell's is missing they may be a hint
        found = detector(20, 30).detect(image, "two");
        assertEquals(List.of(20), ids(found));
        assertEquals("[in view, but not in the cell file: marker 5; check the ids of the cell file]",
                found.warnings().toString());
    }

    /** A wedge no square can look like under this camera, with the pattern of a marker drawn into it. */
    @Test
    void quadrilateralThatNoPoseOfASquareExplainsIsLeftOut() {
        double[] wedge = {250, 180, 350, 180, 330, 260, 270, 260};
        Detections found = detector(944).detect(picture().draw(BINARY, 944, wedge).image(), "wedge.png");
        assertEquals(List.of(), ids(found));
        assertEquals(1, found.warnings().size());
        assertTrue(found.warnings().get(0).toString().startsWith("marker 944 at (300, 220) px is left out"),
                found.warnings().get(0).toString());
    }

    /** The same marker under half its camera's focal length, as when the focal length is yet to be found. */
    @Test
    void widerLimitKeepsTrueMarkersOfAnUncertainFocalLength() {
        double[] truth = DrawnMarkers.corners(CAMERA, facing(20, -30, 400, 0.8, 0.3, 0.4), 100);
        GreyImage image = picture().draw(BINARY, 944, truth).image();
        PinholeCamera wrong = CAMERA.withFocal(290, 290);
        assertEquals(List.of(), ids(new BoofMarkerDetector(wrong, BINARY, List.of(944)).detect(image, "strict")));
        assertEquals(List.of(944), ids(new BoofMarkerDetector(wrong, BINARY, List.of(944), 0.2).detect(image, "wide")));
    }

    @Test
    void idSeenAtTwoPlacesIsLeftOutAtBoth() {
        GreyImage image = picture().draw(BINARY, 5, square(150.3, 200.7, 30)).draw(BINARY, 5, square(420.2, 250.4, 35))
                .draw(BINARY, 9, square(300.3, 400.1, 30)).image();
        Detections found = detector(5, 9).detect(image, "twice");
        assertEquals(List.of(9), ids(found));
        assertEquals(1, found.warnings().size());
        String warning = found.warnings().get(0).toString();
        assertTrue(warning.startsWith("marker 5 is seen at 2 places,") && warning.contains("(150, 201)")
                && warning.contains("(420, 250)"), warning);
    }

    @Test
    void markerOfTwentyPixelsIsFoundAndItsSideIsKnown() {
        Detections found = detector(944).detect(picture().draw(BINARY, 944, square(300.3, 200.7, 10)).image(), "small");
        assertEquals(List.of(944), ids(found));
        assertEquals(20, found.find(944).shortestSidePx(), 0.1);
    }

    /** Greys 55 and 100, as under glare: the threshold takes black up to 0.6 of white. */
    @Test
    void faintMarkerIsFound() {
        double[] truth = DrawnMarkers.corners(CAMERA, facing(0, 0, 500, 0.2, 0.2, 0.5), SIZE_MM);
        Detections found = detector(944).detect(new DrawnMarkers(WIDTH, HEIGHT, 85).draw(BINARY, 944, truth, 55, 100)
                .image(), "faint");
        assertEquals(List.of(944), ids(found));
        // noise of 1 grey level in 40 of contrast
        assertArrayEquals(truth, found.find(944).cornersPx(), 0.15);
    }

    @Test
    void markerCutByTheImageEdgeIsNotReported() {
        Detections found = detector(944).detect(picture().draw(BINARY, 944, square(20, 200.7, 40)).image(), "cut");
        assertEquals(List.of(), ids(found));
    }

    @Test
    void rowsFurtherApartThanTheyAreWideGiveTheSame() {
        byte[] packed = picture().draw(BINARY, 944, square(300.3, 200.7, 33)).bytes(2, 3);
        int stride = WIDTH + 37;
        int offset = 1000;
        byte[] strided = new byte[offset + stride * (HEIGHT - 1) + WIDTH];
        new Well19937c(5).nextBytes(strided);
        for (int y = 0; y < HEIGHT; y++) {
            System.arraycopy(packed, y * WIDTH, strided, offset + y * stride, WIDTH);
        }
        byte[] before = strided.clone();
        BoofMarkerDetector detector = detector(944);
        Detections expected = detector.detect(GreyImage.packed(packed, WIDTH, HEIGHT), "packed");
        Detections found = detector.detect(GreyImage.wrap(strided, offset, stride, WIDTH, HEIGHT), "strided");
        assertNotNull(expected.find(944));
        assertArrayEquals(expected.find(944).cornersPx(), found.find(944).cornersPx());
        assertArrayEquals(before, strided, "the image is read only");
    }

    @Test
    void whatWasSeenBeforeDoesNotMatter() {
        GreyImage first = picture().draw(BINARY, 944, square(300.3, 200.7, 33)).image();
        GreyImage other = picture().draw(BINARY, 944, square(200.1, 300.2, 60)).draw(BINARY, 22, square(400, 200, 25))
                .image();
        BoofMarkerDetector detector = detector(22, 944);
        double[] once = detector.detect(first, "a").find(944).cornersPx();
        assertEquals(List.of(22, 944), ids(detector.detect(other, "b")));
        Detections again = detector.detect(first, "a");
        assertArrayEquals(once, again.find(944).cornersPx());
        assertNull(again.find(22));
        assertArrayEquals(once, detector(22, 944).detect(first, "a").find(944).cornersPx());
    }

    @Test
    void imageOfAnotherSizeThanTheCamerasIsRefused() {
        GreyImage image = GreyImage.packed(new byte[320 * 240], 320, 240);
        String message = assertThrows(InputRefusedException.class, () -> detector(5).detect(image, "half.png"))
                .getMessage();
        assertTrue(message.contains("half.png") && message.contains("320 x 240") && message.contains("640 x 480"),
                message);
    }

    /** A marker of another id, one cell away from the other listed one, blurred until thresholds confuse them. */
    @Test
    void blurDoesNotMakeOneMarkerOfAnother() {
        RandomGenerator random = new Well19937c(11);
        int seen = 0;
        for (int i = 0; i < 12; i++) {
            int id = random.nextInt(4096);
            int neighbour = id ^ 1 << random.nextInt(12);
            double angle = random.nextDouble() * Math.PI / 2;
            double[] truth = DrawnMarkers.corners(CAMERA, facing(0, 0, 1000, 0.1, 0.1, angle), SIZE_MM);
            byte[] sharp = new DrawnMarkers(WIDTH, HEIGHT, 130).draw(BINARY, id, truth).bytes(0, 1);
            GreyImage image = GreyImage.packed(blurred(sharp, WIDTH, HEIGHT), WIDTH, HEIGHT);
            Detections found = detector(id, neighbour).detect(image, "blurred");
            assertNull(found.find(neighbour), "marker " + id + " read as " + neighbour);
            seen += found.find(id) == null ? 0 : 1;
        }
        assertTrue(seen >= 10, "found " + seen + " of 12");
    }

    /** Blur of 1.15 px: the binomial kernel (1 4 6 4 1) / 16 has variance 1, and pixel areas add their own. */
    private static byte[] blurred(byte[] in, int width, int height) {
        double[] kernel = {1 / 16.0, 4 / 16.0, 6 / 16.0, 4 / 16.0, 1 / 16.0};
        byte[] out = in.clone();
        for (int y = 2; y < height - 2; y++) {
            for (int x = 2; x < width - 2; x++) {
                double sum = 0;
                for (int k = 0; k < 25; k++) {
                    sum += kernel[k / 5] * kernel[k % 5] * (in[(y + k / 5 - 2) * width + x + k % 5 - 2] & 0xFF);
                }
                out[y * width + x] = (byte) Math.round(sum);
            }
        }
        return out;
    }
}
