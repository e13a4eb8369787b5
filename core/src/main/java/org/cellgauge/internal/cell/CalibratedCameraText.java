package org.cellgauge.internal.cell;

import java.util.List;
import java.util.Locale;
import org.cellgauge.geometry.PinholeCamera;

/**
 * Camera files of calibrated cameras: BoofCV's keys, and a key of this project's beside them that BoofCV passes over.
 */
public final class CalibratedCameraText {
    /** The key. */
    public static final String KEY = "cellgauge_calibration";

    private CalibratedCameraText() {
    }

    /**
     * The text of a camera file.
     *
     * @param camera the camera
     * @param parameters names of the unknowns, without units: {@code fx}, {@code k1}
     * @param covariance their joint covariance, row by row
     * @param photos how many it rests on
     * @param rmsPx root mean square reprojection error, px
     * @param widenedBy factor of the deviations, at least 1
     * @return YAML, ended by a line feed
     */
    public static String text(PinholeCamera camera, List<String> parameters, List<List<Double>> covariance, int photos,
            double rmsPx, double widenedBy) {
        return CameraWriter.text(camera) + calibration(parameters, covariance, "") + "  photos: " + photos
                + "\n  rms_px: " + String.format(Locale.ROOT, "%.4f", rmsPx)
                + "\n  widened_by: " + String.format(Locale.ROOT, "%.3f", widenedBy) + '\n';
    }

    /**
     * The key with the joint covariance; what the calibration rests on follows, two blanks further in.
     *
     * @param indent what every line begins with
     */
    static String calibration(List<String> parameters, List<List<Double>> covariance, String indent) {
        StringBuilder out = new StringBuilder(indent);
        out.append(KEY).append(":\n").append(indent).append("  parameters: [").append(String.join(", ", parameters))
                .append("]\n").append(indent).append("  std: [");
        for (int i = 0; i < parameters.size(); i++) {
            out.append(i == 0 ? "" : ", ").append(CameraWriter.number(Math.sqrt(covariance.get(i).get(i))));
        }
        out.append("]\n").append(indent).append("  covariance:\n");
        for (List<Double> row : covariance) {
            out.append(indent).append("  - [");
            for (int j = 0; j < row.size(); j++) {
                out.append(j == 0 ? "" : ", ").append(CameraWriter.number(row.get(j)));
            }
            out.append("]\n");
        }
        return out.toString();
    }
}
