package org.cellgauge.cell;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import boofcv.io.calibration.CalibrationIO;
import boofcv.struct.calib.CameraPinholeBrown;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RationalLens;
import org.cellgauge.internal.cell.CameraExport;
import org.cellgauge.internal.cell.CameraWriter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Camera files of other programs: read, refused, written. */
class CameraFormatsTest {
    private static final double[] BENT_5 = {-0.28, 0.09, -0.01, 0.001, -0.0005};
    private static final String ROS = "image_width: 1280\nimage_height: 720\ncamera_name: narrow\ncamera_matrix:\n"
            + "  rows: 3\n  cols: 3\n  data: [581.25, 0, 640.125, 0, 582.5, 359.75, 0, 0, 1]\n"
            + "distortion_model: plumb_bob\ndistortion_coefficients:\n  rows: 1\n  cols: 5\n"
            + "  data: [-0.28, 0.09, 0.001, -0.0005, -0.01]\nprojection_matrix: {rows: 3, cols: 4, data: []}\n";
    private static final String ROS_MESSAGE = "height: 720\nwidth: 1280\ndistortion_model: plumb_bob\n"
            + "d: [-0.28, 0.09, 0.001, -0.0005, -0.01]\nk:\n- 581.25\n- 0.0\n- 640.125\n- 0.0\n- 582.5\n- 359.75\n"
            + "- 0.0\n- 0.0\n- 1.0\nr: [1.0]\n";
    private static final String KALIBR = "cam0:\n  cam_overlaps: [1]\n  camera_model: pinhole\n"
            + "  distortion_coeffs: [-0.28, 0.09, 0.001, -0.0005]\n  distortion_model: radtan\n"
            + "  intrinsics: [581.25, 582.5, 640.125, 359.75]\n  resolution: [1280, 720]\n  rostopic: /cam0/image_raw\n"
            + "cam1:\n  T_cn_cnm1:\n  - [1.0, 0.0, 0.0, 0.1]\n  camera_model: pinhole\n"
            + "  distortion_coeffs: [-0.012, 0.006, -0.004, 0.0005]\n  distortion_model: equidistant\n"
            + "  intrinsics: [581.25, 582.5, 640.125, 359.75]\n  resolution: [1280, 720]\n";
    private static final String PHOTON = "{\n\t\"resolution\": {\"width\": 1280.0, \"height\": 720.0},\n"
            + "\t\"cameraIntrinsics\": {\"rows\": 3, \"cols\": 3, \"type\": 6, \"data\": [581.25, 0.0, 640.125, 0.0, "
            + "582.5, 359.75, 0.0, 0.0, 1.0]},\n"
            + "\t\"observations\": [{\"snapshotData\": \"LONG\", \"c\": [{\"x\": 1}]}],\n"
            + "\t\"distCoeffs\": {\"rows\": 1, \"cols\": 5, \"type\": 6, \"data\": [-0.28, 0.09, 0.001, -0.0005, "
            + "-0.01]},\n\t\"lensmodel\": \"LENSMODEL_OPENCV\"\n}\n";
    private static final String REALSENSE = "{\"width\": 1280, \"height\": 720, \"ppx\": 640.125, \"ppy\": 359.75, "
            + "\"fx\": 581.25, \"fy\": 582.5, \"model\": \"Brown Conrady\",\n"
            + "\"coeffs\": [-0.28, 0.09, 0.001, -0.0005, -0.01]}";
    private static final String MRCAL = "{\n    'lensmodel':  'LENSMODEL_OPENCV5', # as fitted\n"
            + "    'intrinsics': [ 581.25, 582.5, 640.125, 359.75, -0.28, 0.09, 0.001, -0.0005, -0.01,],\n"
            + "    'extrinsics': [ 0, 0, 0, 0, 0, 0,],\n    'imagersize': [ 1280, 720,],\n"
            + "    'optimization_inputs': b'P)h>@6aWAK{,]: LONG'\n}\n";

    private static String resource(String name) throws IOException {
        try (InputStream in = CameraFormatsTest.class.getResourceAsStream("cameras/" + name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    /** Files and figures were made by cameras/make.py. */
    @Test
    void filesOfOpenCvAndMrcalProjectAsTheseDo() throws IOException {
        Set<String> files = new HashSet<>();
        for (String line : resource("projections.txt").split("\n")) {
            String[] words = line.split(" ");
            double[] p = Arrays.stream(words).skip(1).mapToDouble(Double::parseDouble).toArray();
            CameraFile file = CameraReader.file(resource(words[0]), words[0], null);
            assertEquals(words[0].startsWith("mrcal") ? CameraFormat.MRCAL : CameraFormat.OPENCV, file.format());
            assertEquals(words[0].startsWith("opencv") && !words[0].contains("fisheye"), file.deviationsAlone());
            // both count pixels from the middle of the first
            assertArrayEquals(new double[] {p[3] + 0.5, p[4] + 0.5}, file.camera().project(p[0], p[1], p[2]), 1e-9,
                    line);
            files.add(words[0] + " " + file.camera().lens().modelName());
        }
        assertEquals(Set.of("opencv-5.yml pinhole_radial_tangential", "opencv-8.json pinhole_rational",
                "opencv-12.xml pinhole_rational", "opencv-14.yml pinhole_rational",
                "opencv-fisheye.yml kannala_brandt", "mrcal-0.cameramodel pinhole_radial_tangential",
                "mrcal-4.cameramodel pinhole_radial_tangential", "mrcal-5.cameramodel pinhole_radial_tangential",
                "mrcal-8.cameramodel pinhole_rational", "mrcal-12.cameramodel pinhole_rational"), files);
    }

    static Stream<Arguments> sameCamera() {
        return Stream.of(Arguments.of(CameraFormat.ROS, ROS), Arguments.of(CameraFormat.ROS, ROS_MESSAGE),
                Arguments.of(CameraFormat.ROS, ROS.replace("plumb_bob", "rational_polynomial")
                        .replace("-0.01]", "-0.01, 0, 0, 0]")),
                Arguments.of(CameraFormat.PHOTONVISION, PHOTON.replace("LONG", "AbC/+".repeat(400_000))),
                Arguments.of(CameraFormat.REALSENSE, REALSENSE),
                Arguments.of(CameraFormat.REALSENSE, REALSENSE.replace("Brown Conrady", "distortion.brown_conrady")),
                Arguments.of(CameraFormat.MRCAL, MRCAL.replace("LONG", "x".repeat(2_000_000))),
                Arguments.of(CameraFormat.OPENCV, "K: [[581.25, 0, 640.125], [0, 582.5, 359.75], [0, 0, 1]]\n"
                        + "D: [[-0.28, 0.09, 0.001, -0.0005, -0.01]]\nimage_size: [1280, 720]\n"));
    }

    @ParameterizedTest
    @MethodSource
    void sameCamera(CameraFormat format, String text) {
        CameraFile file = CameraReader.file(text, "camera", null);
        assertEquals(format, file.format());
        assertSame(BrownLens.MODEL, file.camera().lens());
        assertEquals(1280, file.camera().widthPx());
        assertEquals(720, file.camera().heightPx());
        double[] values = file.camera().intrinsics();
        assertArrayEquals(new double[] {581.25, 582.5, 640.625, 360.25, 0}, Arrays.copyOf(values, 5), 0);
        assertArrayEquals(BENT_5, Arrays.copyOfRange(values, 5, 10), 0);
        assertNull(file.calibration());
    }

    @Test
    void oneOfSeveralCamerasIsChosenByName() {
        String message = assertThrows(InputRefusedException.class, () -> CameraReader.read(KALIBR, "camchain.yaml"))
                .getMessage();
        assertTrue(message.startsWith("camchain.yaml") && message.contains("(cam0, cam1)"), message);
        CameraFile first = CameraReader.file(KALIBR, "camchain.yaml", "cam0");
        assertEquals(CameraFormat.KALIBR, first.format());
        assertEquals(-0.0005, first.camera().get(BrownLens.P2));
        assertEquals(640.625, first.camera().get(PinholeCamera.CX));
        assertSame(KannalaBrandtLens.MODEL, CameraReader.file(KALIBR, "camchain.yaml", "cam1").camera().lens());
        assertTrue(assertThrows(InputRefusedException.class, () -> CameraReader.file(KALIBR, "c", "cam2")).getMessage()
                .contains("no camera \"cam2\" in this file; it holds cam0, cam1"));
        assertTrue(assertThrows(InputRefusedException.class, () -> CameraReader.file(ROS, "c", "cam0")).getMessage()
                .contains("leave the name out"));
        String alone = KALIBR.substring(0, KALIBR.indexOf("cam1:"));
        assertEquals(first.camera().toString(), CameraReader.read(alone, "camchain.yaml").toString());

        String cell = CellReaderTest.CELL.replaceFirst("camera: .*\n", "camera: {file: camchain.yaml, name: cam1}\n");
        assertEquals("camchain.yaml", CellReader.statedCamera(cell, "cell.yaml").fileName());
        assertSame(KannalaBrandtLens.MODEL, CellReader.read(cell, "cell.yaml", name -> KALIBR).camera().lens());
    }

    static Stream<Arguments> faults() {
        return Stream.of(
                fault(ROS, "1280", "1280.5", "line 1, image_width: ", "whole number"),
                fault(ROS, "image_height: 720\n", "", "image_height: is missing", "px"),
                fault(ROS, ", 0, 0, 1\\]", ", 0, 0, 0]", "line 4, camera_matrix: ", "fx, 0, cx"),
                fault(ROS, ", 0, 1\\]", "]", "line 4, camera_matrix: ", "nine numbers"),
                fault(ROS, "plumb_bob", "double_sphere", "line 8, distortion_model: ", "plumb_bob", "equidistant"),
                fault(ROS, "plumb_bob", "equidistant", "line 9, distortion_coefficients: ", "expected 4", "got 5"),
                fault(ROS, "-0.01\\]", "-0.01, 1]", "line 9, distortion_coefficients: ", "4, 5, 8, 12 or 14", "got 6"),
                fault(ROS, "-0.28", "x", "line 12, distortion_coefficients.data[0]: ", "a number"),
                fault(ROS, "-0.28, 0.09", "-0.9, 0", "line 9, distortion_coefficients: ", "folds the image over"),
                // the pole of 1 / (1 - 2 r²) lies at 0.71, within the image, and the image turns back before
                fault(ROS, "\\[-0.28.*\\]", "[-0.9, 0, 0, 0, 0, -0.6, 0, 0]", "distortion_coefficients: ", "folds"),
                fault(ROS, "-0.01\\]", "-0.01, 0, 0, 0, 0, 0, 0, 0, 0.01, 0]", "distortion_coefficients.data[12]: ",
                        "tilted by 0.01 rad", "CALIB_TILTED_MODEL"),
                fault(ROS, "640.125", "-64012", "line 7, camera_matrix.data[2]: ", "far outside"),
                fault(KALIBR.substring(0, KALIBR.indexOf("cam1:")), "pinhole", "omni", "line 3, cam0.camera_model: ",
                        "pinhole"),
                fault(KALIBR.substring(0, KALIBR.indexOf("cam1:")), "radtan", "fov", "cam0.distortion_model: ",
                        "radtan or equidistant"),
                fault(REALSENSE, "Brown Conrady", "Inverse Brown Conrady", "line 1, model: ", "undistorted image"),
                fault(REALSENSE, "Brown Conrady", "Modified Brown Conrady", "line 1, model: ", "kannala_brandt4"),
                fault(REALSENSE, "\"fx\": 581.25, ", "", "fx: is missing"),
                fault(MRCAL, "LENSMODEL_OPENCV5", "LENSMODEL_CAHVOR", "line 2, lensmodel: ", "LENSMODEL_OPENCV8"),
                fault(MRCAL, "LENSMODEL_OPENCV5", "LENSMODEL_OPENCV8", "line 3, intrinsics: ", "12 numbers", "got 9"),
                fault(PHOTON, "LENSMODEL_OPENCV", "LENSMODEL_SPLINED_STEREOGRAPHIC", "line 6, lensmodel: "),
                fault("{\"tags\": [{\"ID\": 1}], \"field\": {\"length\": 16.4}}", "", "", "no camera stands here",
                        "BoofCV", "mrcal"),
                fault("<opencv_storage>\n<a>1</b>\n</opencv_storage>", "", "", "line 2: ", "FileStorage"),
                fault("<html><body/></html>", "", "", "FileStorage"),
                fault("<!DOCTYPE a [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><opencv_storage>&x;</opencv_storage>",
                        "", "", "FileStorage"),
                fault("<opencv_storage><image_width>1280</image_width></opencv_storage>", "", "",
                        "no camera stands here"));
    }

    private static Arguments fault(String text, String from, String to, String... words) {
        return Arguments.of(from.isEmpty() ? text : text.replaceFirst(from, to), List.of(words));
    }

    @ParameterizedTest
    @MethodSource
    void faults(String text, List<String> words) {
        String message = assertThrows(InputRefusedException.class, () -> CameraReader.read(text, "camera"))
                .getMessage();
        assertTrue(message.startsWith("camera"), message);
        for (String word : words) {
            assertTrue(message.contains(word), word + " in: " + message);
        }
    }

    @Test
    void inverseAndModifiedDistortionOfNothingIsNone() {
        for (String model : new String[] {"Inverse Brown Conrady", "distortion.modified_brown_conrady", "None"}) {
            assertFalse(CameraReader.read(REALSENSE.replace("Brown Conrady", model)
                    .replaceFirst("\\[.*\\]", "[0, 0, 0, 0, 0]"), "c").isDistorting());
        }
        assertTrue(CameraReader.read(REALSENSE.replace("Brown Conrady", "Modified Brown Conrady")
                .replace("0.001, -0.0005", "0, 0"), "c").isDistorting());
    }

    private static Stream<PinholeCamera> cameras() {
        double third = 1.0 / 3;
        return Stream.of(camera(BrownLens.MODEL),
                camera(BrownLens.MODEL, -0.3 + 1e-3 * third, 0.1, -0.01, 1e-5 * third, 2e-4),
                camera(KannalaBrandtLens.MODEL, -0.012, 0.006 * third, -0.004, 5e-4),
                camera(RationalLens.MODEL, 0.52, -2.4, 1.5, 0.4, -2.3, 1.42 + 1e-3 * third, 9e-4, -3e-4, 0, 0, 0, 0),
                camera(RationalLens.MODEL, 0.52, -2.4, 1.5, 0.4, -2.3, 1.42, 9e-4, -3e-4, 0.002, -0.001, 1e-7, 0));
    }

    private static PinholeCamera camera(Lens lens, double... bent) {
        double[] values = new double[lens.parameterCount()];
        System.arraycopy(new double[] {605 + 1.0 / 3, 605.5, 640.1, 366.7, 0}, 0, values, 0, 5);
        System.arraycopy(bent, 0, values, 5, bent.length);
        return PinholeCamera.of(lens, 1280, 720, values);
    }

    @ParameterizedTest
    @MethodSource("cameras")
    void whatIsWrittenComesBack(PinholeCamera camera) {
        CameraCalibration calibration = new CameraCalibration(List.of("fx", "cx"), new double[] {4, 1, 1, 3}, 12);
        for (CameraFormat format : CameraExport.FORMS.values()) {
            boolean prism = camera.lens() == RationalLens.MODEL && camera.get(RationalLens.S1) != 0;
            if (prism && format == CameraFormat.ROS) {
                assertTrue(assertThrows(InputRefusedException.class, () -> CameraExport.text(camera, format))
                        .getMessage().contains("thin prism"));
                continue;
            }
            CameraFile back = CameraReader.file(CameraExport.text(camera, format)
                    + CameraExport.calibration(calibration), "c", null);
            assertEquals(format, back.format());
            assertSame(camera.lens(), back.camera().lens());
            assertArrayEquals(camera.intrinsics(), back.camera().intrinsics(), 1e-12);
            assertEquals(camera.heightPx(), back.camera().heightPx());
            assertEquals(calibration, back.calibration());
        }
    }

    @Test
    void skewIsNotLostInSilence() {
        double[] values = camera(BrownLens.MODEL).intrinsics();
        values[PinholeCamera.SKEW] = 0.5;
        PinholeCamera skewed = PinholeCamera.of(1280, 720, values);
        assertTrue(assertThrows(InputRefusedException.class, () -> CameraExport.text(skewed, CameraFormat.OPENCV))
                .getMessage().contains("0.5 px"));
    }

    /** BoofCV's own reader takes the file of a calibrated camera, the key beside its own passed over. */
    @ParameterizedTest
    @CsvSource({"-0.3, 0.1", "0.05, -0.16"})
    void boofCvReadsCalibratedCameraFiles(double k1, double k2) {
        PinholeCamera camera = camera(BrownLens.MODEL, k1, k2, 0, 1e-3, -2e-3);
        String text = CameraWriter.text(camera) + CameraExport.calibration(
                new CameraCalibration(List.of("fx", "cx"), new double[] {4, 1, 1, 3}, 12));
        CameraPinholeBrown read = CalibrationIO.load(new StringReader(text));
        assertArrayEquals(new double[] {camera.get(0), camera.get(1), camera.get(2), camera.get(3)},
                new double[] {read.fx, read.fy, read.cx, read.cy}, 0);
        assertArrayEquals(new double[] {k1, k2, 0}, read.radial, 0);
        assertArrayEquals(new double[] {1e-3, -2e-3}, new double[] {read.t1, read.t2}, 0);
    }
}
