package org.cellgauge.android.state;

import java.util.OptionalDouble;
import org.cellgauge.android.camera.CameraModelSource;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.settings.SettingTable;

/**
 * What is taken of a lens that nobody measured. A model without a calibration says where a lens looks, and neither how
 * it bends rays nor where its axis meets the sensor: taken at its word, it gives figures that leave out what is most
 * wrong with them. So everything that a calibration would measure is estimated along, from what is known of handheld
 * devices' lenses beforehand, and stands in every deviation and in the kept result's settings.
 */
final class LensKnowledge {
    /**
     * A field of view by focal length and sensor size: the focal length is rounded, moves with the focus (at half a
     * metre by 1 %), and the stream may be cut for stabilisation. Three deviations are what a stream may be cut by.
     */
    static final double FOCAL_STD_SHARE = 0.05;
    /** The axis of a small lens is off the middle by some per cent of the picture at most. */
    static final double PRINCIPAL_STD_SHARE = 0.02;
    /** Coefficients k1 and k2 of tablets' lenses, corrected in the device or not, are within two of these. */
    static final double RADIAL_STD = 0.1;

    private LensKnowledge() {
    }

    /** Whether somebody measured the lens: a maker's values are of a type of device, and none say how sure they are. */
    static boolean isMeasured(CameraModelSource source) {
        return source == CameraModelSource.CALIBRATION_FILE;
    }

    /**
     * How a check goes about its camera.
     *
     * @param general how checks go about everything else
     * @param camera the camera as it is stated
     * @param measured whether it was calibrated
     * @return settings of the check
     */
    static CheckSettings settings(CheckSettings general, PinholeCamera camera, boolean measured) {
        if (measured) {
            return general.toBuilder().estimate(Estimate.NONE).build();
        }
        return general.toBuilder().estimate(Estimate.INTRINSICS)
                .set(SettingTable.FOCAL_PRIOR_SHARE, OptionalDouble.of(FOCAL_STD_SHARE))
                .set(SettingTable.PRINCIPAL_PRIOR_STD_PX,
                        PRINCIPAL_STD_SHARE * Math.max(camera.widthPx(), camera.heightPx()))
                .set(SettingTable.RADIAL_PRIOR_STD, RADIAL_STD).build();
    }
}
