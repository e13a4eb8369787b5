package org.cellgauge.cell;

import java.util.OptionalDouble;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.light.ToneCurve;
import org.jspecify.annotations.Nullable;

/**
 * What a camera file holds.
 *
 * @param camera the camera; pixel centres at +0.5 whatever the file's form
 * @param format whose form it is
 * @param calibration how well the intrinsics are known; null where the file does not say, so that they count as exact
 * @param toneCurve how the camera makes grey values of light; null where the file does not say, or says {@code auto}
 * @param focusDistanceM distance that the lens was focused at when the camera was calibrated, m; empty where the file
 *     does not say
 * @param deviationsAlone whether it states deviations of its intrinsics without their covariances, which are not used:
 *     focal lengths and distortion err together, and what that makes of an object cannot be told without
 */
public record CameraFile(PinholeCamera camera, CameraFormat format, @Nullable CameraCalibration calibration,
        @Nullable ToneCurve toneCurve, OptionalDouble focusDistanceM, boolean deviationsAlone) {
}
