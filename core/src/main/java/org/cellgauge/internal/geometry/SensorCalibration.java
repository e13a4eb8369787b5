package org.cellgauge.internal.geometry;

import static org.cellgauge.geometry.BrownLens.K1;
import static org.cellgauge.geometry.BrownLens.P1;
import static org.cellgauge.geometry.BrownLens.P2;
import static org.cellgauge.geometry.BrownLens.PARAMETERS;
import static org.cellgauge.geometry.PinholeCamera.CX;
import static org.cellgauge.geometry.PinholeCamera.CY;
import static org.cellgauge.geometry.PinholeCamera.FX;
import static org.cellgauge.geometry.PinholeCamera.FY;
import static org.cellgauge.geometry.PinholeCamera.SKEW;

import java.util.Arrays;
import org.cellgauge.geometry.PinholeCamera;

/**
 * What a handheld device says of its camera in pixels of the sensor, from which the camera of any image stream follows;
 * immutable.
 *
 * <p>The conventions are those of Android's Camera2 (reference of {@code CameraCharacteristics}):
 * {@code LENS_INTRINSIC_CALIBRATION} is (fx, fy, cx, cy, s) relative to the upper left corner of the active array
 * before correction, the centre of pixel (x, y) being at (x + 0.5, y + 0.5), as here. {@code LENS_DISTORTION} is
 * (kappa1, …, kappa5) of
 * {@code x_c = x_i (1 + kappa1 r² + kappa2 r⁴ + kappa3 r⁶) + kappa4 2 x_i y_i + kappa5 (r² + 2 x_i²)}, y alike with
 * kappa4 and kappa5 exchanged, {@code x_c} being where in the image as taken the light from the undistorted direction
 * {@code x_i} falls: the model and the order k1, k2, k3, p1, p2 of {@link PinholeCamera}. Both active arrays are
 * relative to the full pixel array. A stream of another shape than the active array shows the largest part of its own
 * shape in the middle ({@code SCALER_CROP_REGION}), provided that the device does not zoom.
 */
public final class SensorCalibration {
    private static final int CALIBRATION = 5;

    /** Relative to the full pixel array, the lens included. */
    private final double[] intrinsics;
    private final PixelArea before;
    private final PixelArea after;

    private SensorCalibration(double[] intrinsics, PixelArea before, PixelArea after) {
        this.intrinsics = intrinsics;
        this.before = before;
        this.after = after;
    }

    /**
     * A calibration as the device states it.
     *
     * @param intrinsicCalibration fx, fy, cx, cy, skew in px, relative to the upper left corner of {@code before}
     * @param distortion k1, k2, k3, p1, p2; null where the device states none
     * @param before active area before the lens is corrected, in px of the full pixel array
     * @param after active area after the lens is corrected, in px of the full pixel array
     * @return the calibration
     * @throws IllegalArgumentException if there are not 5 values each, or they are of no camera (some devices state
     *     zeros)
     */
    public static SensorCalibration of(float[] intrinsicCalibration, float[] distortion, PixelArea before,
            PixelArea after) {
        if (intrinsicCalibration.length != CALIBRATION || distortion != null && distortion.length != CALIBRATION) {
            throw new IllegalArgumentException("a calibration takes 5 values and 5 of distortion, not "
                    + Arrays.toString(intrinsicCalibration) + " and " + Arrays.toString(distortion));
        }
        double[] values = new double[PARAMETERS];
        values[FX] = intrinsicCalibration[0];
        values[FY] = intrinsicCalibration[1];
        values[CX] = intrinsicCalibration[2] + before.leftPx();
        values[CY] = intrinsicCalibration[3] + before.topPx();
        values[SKEW] = intrinsicCalibration[4];
        if (distortion != null) {
            for (int i = 0; i < 3; i++) {
                values[K1 + i] = distortion[i];
            }
            values[P1] = distortion[3];
            values[P2] = distortion[4];
        }
        // judges the values
        PinholeCamera.of(1, 1, values);
        return new SensorCalibration(values, before, after);
    }

    /**
     * What follows from the data sheet where the device states no calibration: square to the lens, the optical axis
     * through the middle of the active area, no distortion. Good to a few per cent at best; estimate the focal length
     * with a prior such as {@link PinholeCamera#focalStdPx}.
     *
     * @param focalLengthMm focal length of the lens, positive
     * @param sensorWidthMm width of the full pixel array, positive
     * @param sensorHeightMm height of the full pixel array, positive
     * @param sensorWidthPx pixels in a row of the full pixel array, positive
     * @param sensorHeightPx pixels in a column of the full pixel array, positive
     * @param active active area, in px of the full pixel array
     * @return the calibration
     * @throws IllegalArgumentException if a value is not positive
     */
    public static SensorCalibration ofDataSheet(double focalLengthMm, double sensorWidthMm, double sensorHeightMm,
            int sensorWidthPx, int sensorHeightPx, PixelArea active) {
        double[] values = new double[PARAMETERS];
        values[FX] = focalLengthMm / sensorWidthMm * sensorWidthPx;
        values[FY] = focalLengthMm / sensorHeightMm * sensorHeightPx;
        values[CX] = active.leftPx() + active.widthPx() / 2;
        values[CY] = active.topPx() + active.heightPx() / 2;
        PinholeCamera.of(sensorWidthPx, sensorHeightPx, values);
        return new SensorCalibration(values, active, active);
    }

    /**
     * The camera of an image stream that shows the sensor without zoom.
     *
     * @param streamWidthPx width of the stream's images
     * @param streamHeightPx height of the stream's images
     * @param lensCorrected whether the device takes the distortion out of the stream (on Android where
     *     {@code DISTORTION_CORRECTION_MODE} is another than off)
     * @return the camera, in px of the stream; without distortion where the lens is corrected
     * @throws IllegalArgumentException if a size is not positive
     */
    public PinholeCamera toCamera(int streamWidthPx, int streamHeightPx, boolean lensCorrected) {
        if (streamWidthPx < 1 || streamHeightPx < 1) {
            throw new IllegalArgumentException("image size must be positive: " + streamWidthPx + " x "
                    + streamHeightPx);
        }
        PixelArea seen = (lensCorrected ? after : before).centreCrop(streamWidthPx, streamHeightPx);
        double scale = streamWidthPx / seen.widthPx();
        double[] values = intrinsics.clone();
        values[FX] *= scale;
        values[FY] *= scale;
        values[SKEW] *= scale;
        values[CX] = scale * (values[CX] - seen.leftPx());
        values[CY] = scale * (values[CY] - seen.topPx());
        if (lensCorrected) {
            Arrays.fill(values, K1, PARAMETERS, 0);
        }
        return PinholeCamera.of(streamWidthPx, streamHeightPx, values);
    }
}
