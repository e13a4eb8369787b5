package org.cellgauge.internal.cell;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.cellgauge.cell.CameraCalibration;
import org.cellgauge.cell.CameraFormat;
import org.cellgauge.cell.CameraReader;
import org.cellgauge.cell.CellRefusal;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RationalLens;
import org.cellgauge.warning.Refusal;

/**
 * Writes cameras in the forms of other programs, which {@link CameraReader} reads back: every number
 * with all its digits, principal points as those programs count pixels.
 */
public final class CameraExport {
    /** The forms that can be written, by the words that users have for them. */
    public static final Map<String, CameraFormat> FORMS = Map.of("boofcv", CameraFormat.BOOFCV, "opencv",
            CameraFormat.OPENCV, "ros", CameraFormat.ROS);

    private CameraExport() {
    }

    /**
     * The text of a camera file.
     *
     * @param camera the camera
     * @param format BoofCV, OpenCV or ROS
     * @return YAML, ended by a line feed; in BoofCV's form also of a {@link RationalLens}, which BoofCV has not
     * @throws InputRefusedException if that program has no such camera
     * @throws IllegalArgumentException if the form is none that is written
     */
    public static String text(PinholeCamera camera, CameraFormat format) {
        return switch (format) {
            case BOOFCV -> CameraWriter.text(camera);
            case OPENCV -> openCv(camera);
            case ROS -> ros(camera);
            default -> throw new IllegalArgumentException("not written: " + format);
        };
    }

    /**
     * What stands below a camera's own keys where its calibration says how well it is known; other programs pass over
     * it.
     *
     * @param calibration what is known
     * @return YAML, ended by a line feed
     */
    public static String calibration(CameraCalibration calibration) {
        int n = calibration.parameters().size();
        double[] covariance = calibration.covariance();
        List<List<Double>> rows = IntStream.range(0, n).mapToObj(i -> IntStream.range(0, n)
                .mapToObj(j -> covariance[n * i + j]).collect(Collectors.toList())).collect(Collectors.toList());
        return CalibratedCameraText.block(calibration.parameters(), rows, calibration.photos());
    }

    private static String openCv(PinholeCamera camera) {
        requireNoSkew(camera, CameraFormat.OPENCV);
        boolean fisheye = camera.lens() == KannalaBrandtLens.MODEL;
        double[] coefficients = coefficients(camera);
        return "%YAML:1.0\n---\n" + size(camera) + (fisheye ? "fisheye_model: 1\n" : "")
                + "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: ["
                + numbers(matrix(camera)) + "]\ndistortion_coefficients: !!opencv-matrix\n   rows: "
                + coefficients.length + "\n   cols: 1\n   dt: d\n   data: [" + numbers(coefficients) + "]\n";
    }

    private static String ros(PinholeCamera camera) {
        requireNoSkew(camera, CameraFormat.ROS);
        double[] coefficients = coefficients(camera);
        if (coefficients.length > 8) {
            throw refused(CellRefusal.NO_PRISM_THERE, CameraFormat.ROS.words());
        }
        String model = camera.lens() == KannalaBrandtLens.MODEL ? "equidistant"
                : coefficients.length == 8 ? "rational_polynomial" : "plumb_bob";
        double[] m = matrix(camera);
        double[] projection = {m[0], m[1], m[2], 0, m[3], m[4], m[5], 0, m[6], m[7], m[8], 0};
        return size(camera) + "camera_name: camera\ncamera_matrix:\n  rows: 3\n  cols: 3\n  data: [" + numbers(m)
                + "]\ndistortion_model: " + model + "\ndistortion_coefficients:\n  rows: 1\n  cols: "
                + coefficients.length + "\n  data: [" + numbers(coefficients)
                + "]\nrectification_matrix:\n  rows: 3\n  cols: 3\n  data: [" + numbers(1, 0, 0, 0, 1, 0, 0, 0, 1)
                + "]\nprojection_matrix:\n  rows: 3\n  cols: 4\n  data: [" + numbers(projection) + "]\n";
    }

    private static InputRefusedException refused(CellRefusal kind, Object... arguments) {
        return new InputRefusedException(Refusal.of(kind, arguments));
    }

    /** Programs take focal lengths and principal point out of the matrix and nothing else. */
    private static void requireNoSkew(PinholeCamera camera, CameraFormat format) {
        double skew = camera.get(PinholeCamera.SKEW);
        if (skew != 0) {
            throw refused(CellRefusal.NO_SKEW_THERE, format.words(), CameraReader.plain(skew));
        }
    }

    private static String size(PinholeCamera camera) {
        return "image_width: " + camera.widthPx() + "\nimage_height: " + camera.heightPx() + "\n";
    }

    private static double[] matrix(PinholeCamera camera) {
        double shift = CameraFormat.OPENCV.principalPointShiftPx();
        return new double[] {camera.get(PinholeCamera.FX), 0, camera.get(PinholeCamera.CX) - shift, 0,
            camera.get(PinholeCamera.FY), camera.get(PinholeCamera.CY) - shift, 0, 0, 1};
    }

    /** As many as the lens needs, in OpenCV's order: k1, k2, p1, p2, k3 to k6, s1 to s4; of a fisheye k1 to k4. */
    private static double[] coefficients(PinholeCamera camera) {
        if (camera.lens() == KannalaBrandtLens.MODEL) {
            return of(camera, KannalaBrandtLens.K1, KannalaBrandtLens.K2, KannalaBrandtLens.K3, KannalaBrandtLens.K4);
        }
        if (camera.lens() == BrownLens.MODEL) {
            return of(camera, BrownLens.K1, BrownLens.K2, BrownLens.P1, BrownLens.P2, BrownLens.K3);
        }
        int k = RationalLens.K1;
        int p = RationalLens.P1;
        int s = RationalLens.S1;
        boolean prism = IntStream.range(s, RationalLens.PARAMETERS).anyMatch(i -> camera.get(i) != 0);
        return prism ? of(camera, k, k + 1, p, p + 1, k + 2, k + 3, k + 4, k + 5, s, s + 1, s + 2, s + 3)
                : of(camera, k, k + 1, p, p + 1, k + 2, k + 3, k + 4, k + 5);
    }

    private static double[] of(PinholeCamera camera, int... indices) {
        return IntStream.of(indices).mapToDouble(camera::get).toArray();
    }

    private static String numbers(double... values) {
        return IntStream.range(0, values.length).mapToObj(i -> CameraWriter.decimal(values[i]))
                .collect(Collectors.joining(", "));
    }
}
