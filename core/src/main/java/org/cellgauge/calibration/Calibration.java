package org.cellgauge.calibration;

import java.util.List;
import org.cellgauge.internal.calibration.CameraCalibrator;
import org.cellgauge.vision.TargetObservation;
import org.cellgauge.vision.TargetPoints;

/**
 * Calibrates a camera from photos of a target (Z. Zhang, "A flexible new technique for camera calibration", 2000), with
 * the covariance of what is found.
 *
 * <p>Lens, poses of the photos and, where photos allow, the board's own shape are fitted at once; corners that are far
 * off are left out. Whether the stated deviations can be believed is told by odd and even photos, calibrated apart.
 */
public final class Calibration {
    private Calibration() {
    }

    /**
     * Names of the lens models that can be chosen: {@code radial-1}, {@code radial-2}, {@code brown-4} (k1, k2,
     * p1, p2), {@code brown-5} (with k3), {@code fisheye} (Kannala-Brandt).
     *
     * @return names
     */
    public static List<String> lenses() {
        return CameraCalibrator.lenses();
    }

    /**
     * Calibrates.
     *
     * @param points the target's points
     * @param photos what each photo shows of it
     * @param options how
     * @return the camera and all about it
     * @throws org.cellgauge.cell.InputRefusedException if the photos determine no camera, with what to photograph
     */
    public static CalibrationResult of(TargetPoints points, List<TargetObservation> photos,
            CalibrationOptions options) {
        return new CameraCalibrator(points, photos, options).run();
    }
}
