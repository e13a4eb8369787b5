package org.cellgauge.cell;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.cell.CameraWriter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** BoofCV's calibration files are read as they are, and refused where they cannot be true. */
class CameraReaderTest {
    private static final String FILE = "# Pinhole camera model with radial and tangential distortion\n"
            + "pinhole:\n"
            + "  fx: 529.0\n"
            + "  fy: 528.5\n"
            + "  cx: 316.5\n"
            + "  cy: 226.75\n"
            + "  width: 640\n"
            + "  height: 480\n"
            + "  skew: 0.25\n"
            + "model: pinhole_radial_tangential\n"
            + "radial_tangential:\n"
            + "  radial:\n"
            + "  - 0.05\n"
            + "  - -0.16\n"
            + "  t1: 1.0E-4\n"
            + "  t2: -2.0E-4\n"
            + "version: 0\n";

    @Test
    void everyValueIsReadAsWritten() {
        PinholeCamera camera = CameraReader.read(FILE, "camera.yaml");
        assertArrayEquals(new double[] {529, 528.5, 316.5, 226.75, 0.25, 0.05, -0.16, 0, 1e-4, -2e-4},
                camera.intrinsics());
        assertEquals(640, camera.widthPx());
        assertEquals(480, camera.heightPx());
    }

    @Test
    void modelWithoutDistortionNeedsNoBlock() {
        String text = FILE.substring(0, FILE.indexOf("model:")) + "model: pinhole\nversion: 0\n";
        assertFalse(CameraReader.read(text, "camera.yaml").isDistorting());
    }

    @Test
    void distortionMayBeLeftOutOrHalfStated() {
        assertFalse(CameraReader.read(FILE.substring(0, FILE.indexOf("radial_tangential:\n")), "c").isDistorting());
        PinholeCamera tangential = CameraReader.read(FILE.replace("  radial:\n  - 0.05\n  - -0.16\n", ""), "c");
        assertEquals(0, tangential.get(BrownLens.K1));
        assertEquals(1e-4, tangential.get(BrownLens.P1));
    }

    @Test
    void thirdRadialCoefficientIsRead() {
        PinholeCamera camera = CameraReader.read(FILE.replace("  - -0.16\n", "  - -0.16\n  - 0.01\n"), "c");
        assertEquals(0.01, camera.get(BrownLens.K3));
    }

    /** As BoofCV writes it: lists of the asymmetric part are there and empty, or hold zeros. */
    @Test
    void fisheyeIsReadAndItsFirstCoefficientIsAScale() {
        String text = FILE.substring(0, FILE.indexOf("model:")) + "model: kannala_brandt\nversion: 0\n"
                + "symmetric: [2.0, 0.1, -0.02, 0.004]\nradial: [0.0, 0.0]\nradial_trig: [0.0, 0.0, 0.0, 0.0]\n"
                + "tangent: []\ntangent_trig: []\n";
        PinholeCamera camera = CameraReader.read(text, "c");
        assertEquals(KannalaBrandtLens.MODEL, camera.lens());
        assertArrayEquals(new double[] {1058, 1057, 316.5, 226.75, 0.5, 0.05, -0.01, 0.002, 0}, camera.intrinsics(),
                1e-12);
        assertEquals(640, camera.widthPx());
    }

    @Test
    void fisheyeComesBackAsItWasWritten() {
        PinholeCamera camera = PinholeCamera.of(KannalaBrandtLens.MODEL, 848, 800,
                new double[] {286.1, 287.25, 424, 400.5, 0.125, -0.008, 0.043, -0.0399, 0.0069 + 1e-5 / 3});
        PinholeCamera back = CameraReader.read(CameraWriter.text(camera), "c");
        assertEquals(KannalaBrandtLens.MODEL, back.lens());
        assertArrayEquals(camera.intrinsics(), back.intrinsics(), 0);
        assertEquals(camera.widthPx(), back.widthPx());
        assertEquals(camera.heightPx(), back.heightPx());
    }

    static Stream<Arguments> faults() {
        return Stream.of(
            fault("fisheye without its polynomial", "model: [\\s\\S]*", "model: kannala_brandt\n",
                    "symmetric: is missing", "symmetric: [1, k1"),
            fault("asymmetric fisheye", "model: [\\s\\S]*", "model: kannala_brandt\nsymmetric: [1.0]\n"
                    + "radial: [0.1, 0]\nradial_trig: [0, 0.01, 0, 0]\n", "line 12, radial: ", "asymmetric",
                    "symmetric coefficients alone"),
            fault("fisheye of six coefficients", "model: [\\s\\S]*",
                    "model: kannala_brandt\nsymmetric: [1, 0, 0, 0, 0, 0]\n", "line 11, symmetric: ", "1 to 5",
                    "got 6"),
            fault("fisheye coefficient beyond numbers", "model: [\\s\\S]*",
                    "model: kannala_brandt\nsymmetric: [0.5, 1e308]\n", "line 11, symmetric[1]: ",
                    "must be from -1000000 to 1000000", "Infinity"),
            // t (1 - 0.9 t²) has its top at 0.61 rad, 215 px from the middle, well within the image
            fault("fisheye that turns back", "model: [\\s\\S]*", "model: kannala_brandt\nsymmetric: [1, -0.9]\n",
                    "line 11, symmetric: ", "35 degrees", "calibrate again"),
            fault("fisheye with the other model's block", "pinhole_radial_tangential", "kannala_brandt",
                    "line 11, radial_tangential: "),
            fault("omnidirectional model", "pinhole_radial_tangential", "omnidirectional_universal",
                    "line 10, model: "),
            fault("missing model", "model: pinhole_radial_tangential\n", "", "model: is missing"),
            fault("missing focal length", "  fy: 528.5\n", "", "camera.yaml, line 2, pinhole.fy: is missing"),
            fault("missing width", "  width: 640\n", "", "pinhole.width: is missing", "px"),
            fault("negative focal length", "fx: 529.0", "fx: -529.0", "line 3, pinhole.fx: ", "greater than 0"),
            fault("focal length in mm", "fx: 529.0", "fx: 4.2", "line 3, pinhole.fx: ", "not in mm"),
            fault("focal lengths that contradict", "fy: 528.5", "fy: 52.85", "line 4, pinhole.fy: ", "contradict"),
            fault("focal length not a number", "fx: 529.0", "fx: .NaN", "line 3, pinhole.fx: ", "finite"),
            fault("principal point of a portrait image", "cx: 316.5\n  cy: 226.75",
                    "cx: 240\n  cy: 320", "line 5, pinhole.cx: ", "(240, 320)", "480 x 640"),
            fault("principal point far away", "cx: 316.5", "cx: 3165", "line 5, pinhole.cx: ", "far outside", "640"),
            fault("width of 0", "width: 640", "width: 0", "line 7, pinhole.width: ", "from 16 to 30000"),
            fault("fraction of a pixel", "height: 480", "height: 480.5", "line 8, pinhole.height: ", "whole number"),
            fault("mistyped key", "  skew:", "  skw:", "line 9, pinhole.skw: ", "did you mean \"skew\"?"),
            fault("four radial coefficients", "  - 0.05\n", "  - 0.05\n  - 0\n  - 0\n",
                    "line 12, radial_tangential.radial: ", "at most 3", "got 4"),
            fault("radial coefficient as a number", "  radial:\n  - 0.05\n  - -0.16\n", "  radial: 0.05\n",
                    "line 12, radial_tangential.radial: ", "a list"),
            fault("distortion against the model", "model: pinhole_radial_tangential", "model: pinhole",
                    "line 11, radial_tangential: ", "contradicts", "delete"),
            fault("other version", "version: 0", "version: 3", "line 17, version: "),
            // r (1 - 0.9 r^2) is never above 0.41, but the corner is at 0.75
            fault("distortion that folds over", "  - 0.05\n  - -0.16\n", "  - -0.9\n", "line 11, radial_tangential: ",
                    "folds the image over near pixel (", "calibrate again"),
            fault("cell file in its place", "version: 0", "cellgauge: 1", "line 17, cellgauge: ", "cell file"));
    }

    private static Arguments fault(String name, String from, String to, String... parts) {
        return arguments(name, from, to, parts);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("faults")
    void faultIsRefusedWithItsPlaceAndRemedy(String name, String from, String to, String[] parts) {
        assertTrue(Pattern.compile(from).matcher(FILE).find(), "the faultless file holds what is replaced");
        String message = assertThrows(InputRefusedException.class,
                () -> CameraReader.read(FILE.replaceFirst(from, to), "camera.yaml")).getMessage();
        CellFaultsTest.assertHolds(message, parts);
    }

    @Test
    void foldIsFoundAlsoWhereTheLensModelTurnsTwice() {
        // r (1 - 1.5 r^2 + 0.9 r^4) falls between r = 0.58 and 0.82 and rises beyond: the corner's pixel has a
        // source on the outer branch, but others nearer to the centre have three
        assertThrows(InputRefusedException.class,
                () -> CameraReader.read(FILE.replace("- 0.05", "- -1.5").replace("- -0.16", "- 0.9"), "camera.yaml"));
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({"fiducial_binary, 640, 480", "calibration_sony_chess, 640, 480", "aruco_25h7, 800, 450"})
    void publishedCalibrationIsRead(String folder, int width, int height) {
        PinholeCamera camera = CameraReader.read(SharedData.file("boofcv/" + folder + "/intrinsic.yaml"));
        assertEquals(width, camera.widthPx());
        assertEquals(height, camera.heightPx());
        assertTrue(camera.isDistorting());
    }
}
