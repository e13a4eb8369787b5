package org.cellgauge.internal.cell;

import java.util.List;
import java.util.Locale;

/**
 * Camera files of calibrated cameras: BoofCV's keys, and a key of this project's beside them that BoofCV passes over.
 */
public final class CalibratedCameraText {
    /** The key. */
    public static final String KEY = "cellgauge_calibration";

    private CalibratedCameraText() {
    }

    /**
     * The key with what a check reads of it.
     *
     * @param parameters names of the unknowns, without units: {@code fx}, {@code k1}
     * @param covariance their joint covariance, row by row
     * @param photos how many it rests on; 0 where that is not known
     * @return YAML, ended by a line feed
     */
    public static String block(List<String> parameters, List<List<Double>> covariance, int photos) {
        StringBuilder out = new StringBuilder(KEY);
        out.append(":\n  parameters: [").append(String.join(", ", parameters)).append("]\n  std: [");
        for (int i = 0; i < parameters.size(); i++) {
            out.append(i == 0 ? "" : ", ").append(CameraWriter.number(Math.sqrt(covariance.get(i).get(i))));
        }
        out.append("]\n  covariance:\n");
        for (List<Double> row : covariance) {
            out.append("    - [");
            for (int j = 0; j < row.size(); j++) {
                out.append(j == 0 ? "" : ", ").append(CameraWriter.number(row.get(j)));
            }
            out.append("]\n");
        }
        return out.append("  photos: ").append(photos).append('\n').toString();
    }

    /**
     * The key with all that a calibration says.
     *
     * @param parameters names of the unknowns, without units: {@code fx}, {@code k1}
     * @param covariance their joint covariance, row by row
     * @param photos how many it rests on
     * @param rmsPx root mean square reprojection error, px
     * @param widenedBy factor of the deviations, at least 1
     * @return YAML, ended by a line feed
     */
    public static String block(List<String> parameters, List<List<Double>> covariance, int photos, double rmsPx,
            double widenedBy) {
        return block(parameters, covariance, photos)
                + String.format(Locale.ROOT, "  rms_px: %.4f\n  widened_by: %.3f\n", rmsPx, widenedBy);
    }
}
