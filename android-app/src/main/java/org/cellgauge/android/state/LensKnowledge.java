package org.cellgauge.android.state;

import java.util.HashMap;
import java.util.Map;
import java.util.OptionalDouble;
import org.cellgauge.android.camera.CameraModelSource;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Verdict;
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
public final class LensKnowledge {
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

    /**
     * Whether the lens that a check went through was measured: else all of it is estimated along.
     *
     * @param result of a check by this app
     * @return whether it was
     */
    public static boolean isMeasured(CheckResult result) {
        return result.settings().model().estimate() != Estimate.INTRINSICS;
    }

    /** Whether somebody measured the lens: a maker's values are of a type of device, and none say how sure they are. */
    static boolean isMeasured(CameraModelSource source) {
        return source == CameraModelSource.CALIBRATION_FILE;
    }

    /**
     * A result as it is drawn: of a lens that nobody measured, what meets its target is as if nothing were asked of it.
     *
     * @param result judged by the target in force; null for none
     * @param measured whether the lens was
     * @return the same where it was
     */
    public static CheckResult drawn(CheckResult result, boolean measured) {
        if (result == null || measured) {
            return result;
        }
        Map<Integer, Requirement> missed = new HashMap<>();
        for (ObjectMarker object : result.cell().objects()) {
            if (result.verdict(object.id()) == Verdict.FAIL) {
                missed.put(object.id(), result.cell().target().of(object.id()));
            }
        }
        return result.withTarget(new Target(Requirement.NONE, missed));
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
