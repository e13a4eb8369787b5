package org.cellgauge.android.camera;

import android.graphics.ImageFormat;
import android.graphics.Rect;
import android.graphics.SurfaceTexture;
import android.hardware.camera2.CameraCharacteristics;
import android.hardware.camera2.CameraMetadata;
import android.hardware.camera2.params.StreamConfigurationMap;
import android.os.Build;
import android.util.Range;
import android.util.Size;
import android.util.SizeF;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.internal.geometry.PixelArea;

/**
 * What a device says of one of its cameras, as far as measuring depends on it; immutable.
 *
 * <p>Devices leave out what they must state, and state what cannot be (zeros, empty lists). Nothing is judged here:
 * what is left out is null or empty, what is stated stands as it is.
 */
final class CameraTraits {
    /** Where a camera looks. */
    enum Facing {
        /** Away from the user: the camera to measure with. */
        BACK,
        /** It is plugged in. */
        EXTERNAL,
        /** At the user. */
        FRONT
    }

    private final Builder v;

    private CameraTraits(Builder v) {
        this.v = v;
    }

    /** Name of the camera for the camera service. */
    String id() {
        return v.id;
    }

    /** Where it looks; external where it does not say. */
    Facing facing() {
        return v.facing;
    }

    /** Clockwise turn that makes its images upright on the device in its natural orientation: 0, 90, 180 or 270. */
    int sensorOrientationDeg() {
        return v.sensorOrientationDeg;
    }

    /** Whether it takes photos at all: depth sensors are listed as cameras too. */
    boolean takesPhotos() {
        return v.takesPhotos;
    }

    /** Sizes of its frames with the shortest time between two of them in ns, 0 where it does not say; in its order. */
    Map<PixelSize, Long> frameSizes() {
        return v.frameSizes;
    }

    /** Sizes of its preview. */
    List<PixelSize> previewSizes() {
        return v.previewSizes;
    }

    /** Part of the pixel array that images come from, once the lens is corrected; null if unknown. */
    PixelArea activeArray() {
        return v.activeArray;
    }

    /**
     * The same before the lens is corrected: {@link #activeArray()} on devices that correct nothing; null if unknown.
     */
    PixelArea preCorrectionActiveArray() {
        return v.preCorrectionActiveArray != null ? v.preCorrectionActiveArray : v.activeArray;
    }

    /** The whole pixel array; null if unknown. */
    PixelSize pixelArray() {
        return v.pixelArray;
    }

    /** Width of the whole pixel array, mm; 0 if unknown. */
    float sensorWidthMm() {
        return v.sensorWidthMm;
    }

    /** Height of the whole pixel array, mm; 0 if unknown. */
    float sensorHeightMm() {
        return v.sensorHeightMm;
    }

    /** Focal lengths to choose from, mm; may be empty. */
    float[] focalLengthsMm() {
        return v.focalLengthsMm.clone();
    }

    /** fx, fy, cx, cy, skew in px of {@link #preCorrectionActiveArray()}, or null. */
    float[] intrinsicCalibration() {
        return v.intrinsicCalibration == null ? null : v.intrinsicCalibration.clone();
    }

    /** k1, k2, k3, p1, p2, or null where the device states none. */
    float[] distortion() {
        return v.distortion == null ? null : v.distortion.clone();
    }

    /** Shortest distance that it focuses on, in 1/m; 0 for a lens that does not move; negative if unknown. */
    float minFocusDistanceDpt() {
        return v.minFocusDistanceDpt;
    }

    /** Whether its distances of focus are in 1/m, if only roughly, and not in units of its own. */
    boolean statesFocusDistance() {
        return v.statesFocusDistance;
    }

    /** What its sensor can be told of the exposure; null where only the device exposes. */
    ExposureCap.Limits exposureLimits() {
        return v.exposureLimits;
    }

    /** Whether a mode is among those of one of the {@code AVAILABLE_MODES} keys. */
    static boolean has(int[] modes, int mode) {
        for (int m : modes) {
            if (m == mode) {
                return true;
            }
        }
        return false;
    }

    /**
     * Ranges of frames per second that its automatic exposure keeps to, each lowest and highest, as it lists them; some
     * old devices list them per thousand seconds.
     */
    List<Range<Integer>> frameRates() {
        return v.frameRates;
    }

    /** How many areas it meters light in; 0 for none. */
    int maxExposureAreas() {
        return v.maxExposureAreas;
    }

    /** How many areas it focuses on; 0 for none. */
    int maxFocusAreas() {
        return v.maxFocusAreas;
    }

    /** Whether there is a lamp beside it. */
    boolean hasTorch() {
        return v.torch;
    }

    int[] focusModes() {
        return v.focusModes.clone();
    }

    int[] opticalStabilisationModes() {
        return v.opticalStabilisationModes.clone();
    }

    int[] videoStabilisationModes() {
        return v.videoStabilisationModes.clone();
    }

    int[] edgeModes() {
        return v.edgeModes.clone();
    }

    int[] noiseReductionModes() {
        return v.noiseReductionModes.clone();
    }

    int[] distortionCorrectionModes() {
        return v.distortionCorrectionModes.clone();
    }

    int[] rotateAndCropModes() {
        return v.rotateAndCropModes.clone();
    }

    /** Whether the device corrects the lens in every image, whatever it is told. */
    boolean alwaysCorrectsLens() {
        if (v.distortionCorrectionModes.length > 0) {
            return !has(v.distortionCorrectionModes, CameraMetadata.DISTORTION_CORRECTION_MODE_OFF);
        }
        // before API 28 there is no key for it, but the two arrays differ only where something is corrected
        return v.preCorrectionActiveArray != null && v.activeArray != null
                && !v.preCorrectionActiveArray.toString().equals(v.activeArray.toString());
    }

    /**
     * Reads what a device says.
     *
     * @param id the camera's name
     * @param characteristics what the camera service has on it
     * @return its traits
     */
    static CameraTraits of(String id, CameraCharacteristics characteristics) {
        Builder b = new Builder(id);
        Integer facing = characteristics.get(CameraCharacteristics.LENS_FACING);
        if (facing != null) {
            b.facing(facing == CameraMetadata.LENS_FACING_BACK ? Facing.BACK
                    : facing == CameraMetadata.LENS_FACING_FRONT ? Facing.FRONT : Facing.EXTERNAL);
        }
        Integer orientation = characteristics.get(CameraCharacteristics.SENSOR_ORIENTATION);
        b.sensorOrientationDeg(orientation == null ? 0 : orientation);
        int[] capabilities = characteristics.get(CameraCharacteristics.REQUEST_AVAILABLE_CAPABILITIES);
        b.takesPhotos(capabilities == null
                || has(capabilities, CameraMetadata.REQUEST_AVAILABLE_CAPABILITIES_BACKWARD_COMPATIBLE));
        StreamConfigurationMap streams = characteristics.get(CameraCharacteristics.SCALER_STREAM_CONFIGURATION_MAP);
        if (streams != null) {
            for (PixelSize size : sizes(streams.getOutputSizes(ImageFormat.YUV_420_888))) {
                b.frameSize(size, minFrameDurationNs(streams, size));
            }
            sizes(streams.getOutputSizes(SurfaceTexture.class)).forEach(b::previewSize);
        }
        b.activeArray(area(characteristics.get(CameraCharacteristics.SENSOR_INFO_ACTIVE_ARRAY_SIZE)));
        b.preCorrectionActiveArray(
                area(characteristics.get(CameraCharacteristics.SENSOR_INFO_PRE_CORRECTION_ACTIVE_ARRAY_SIZE)));
        Size array = characteristics.get(CameraCharacteristics.SENSOR_INFO_PIXEL_ARRAY_SIZE);
        if (array != null && array.getWidth() > 0 && array.getHeight() > 0) {
            b.pixelArray(new PixelSize(array.getWidth(), array.getHeight()));
        }
        SizeF physical = characteristics.get(CameraCharacteristics.SENSOR_INFO_PHYSICAL_SIZE);
        if (physical != null) {
            b.sensorMm(physical.getWidth(), physical.getHeight());
        }
        float[] focalLengths = characteristics.get(CameraCharacteristics.LENS_INFO_AVAILABLE_FOCAL_LENGTHS);
        b.focalLengthsMm(focalLengths == null ? new float[0] : focalLengths);
        b.intrinsicCalibration(characteristics.get(CameraCharacteristics.LENS_INTRINSIC_CALIBRATION));
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.P) {
            b.distortion(characteristics.get(CameraCharacteristics.LENS_DISTORTION));
            b.distortionCorrectionModes(
                    characteristics.get(CameraCharacteristics.DISTORTION_CORRECTION_AVAILABLE_MODES));
        }
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.S) {
            b.rotateAndCropModes(characteristics.get(CameraCharacteristics.SCALER_AVAILABLE_ROTATE_AND_CROP_MODES));
        }
        // LENS_RADIAL_DISTORTION (API 23 to 27) is left alone: Android gave it up because devices normalise it in
        // different ways, so that nobody can tell what its numbers mean
        Float closest = characteristics.get(CameraCharacteristics.LENS_INFO_MINIMUM_FOCUS_DISTANCE);
        b.minFocusDistanceDpt(closest == null ? -1 : closest);
        Integer distances = characteristics.get(CameraCharacteristics.LENS_INFO_FOCUS_DISTANCE_CALIBRATION);
        b.statesFocusDistance(distances != null
                && (distances == CameraMetadata.LENS_INFO_FOCUS_DISTANCE_CALIBRATION_APPROXIMATE
                        || distances == CameraMetadata.LENS_INFO_FOCUS_DISTANCE_CALIBRATION_CALIBRATED));
        b.exposureLimits(exposureLimits(characteristics, capabilities));
        Range<Integer>[] rates = characteristics.get(CameraCharacteristics.CONTROL_AE_AVAILABLE_TARGET_FPS_RANGES);
        b.frameRates(rates == null ? Collections.emptyList() : Arrays.asList(rates));
        b.maxExposureAreas(count(characteristics.get(CameraCharacteristics.CONTROL_MAX_REGIONS_AE)));
        b.maxFocusAreas(count(characteristics.get(CameraCharacteristics.CONTROL_MAX_REGIONS_AF)));
        b.torch(Boolean.TRUE.equals(characteristics.get(CameraCharacteristics.FLASH_INFO_AVAILABLE)));
        b.focusModes(characteristics.get(CameraCharacteristics.CONTROL_AF_AVAILABLE_MODES));
        b.opticalStabilisationModes(
                characteristics.get(CameraCharacteristics.LENS_INFO_AVAILABLE_OPTICAL_STABILIZATION));
        b.videoStabilisationModes(
                characteristics.get(CameraCharacteristics.CONTROL_AVAILABLE_VIDEO_STABILIZATION_MODES));
        b.edgeModes(characteristics.get(CameraCharacteristics.EDGE_AVAILABLE_EDGE_MODES));
        b.noiseReductionModes(
                characteristics.get(CameraCharacteristics.NOISE_REDUCTION_AVAILABLE_NOISE_REDUCTION_MODES));
        return b.build();
    }

    private static ExposureCap.Limits exposureLimits(CameraCharacteristics characteristics, int[] capabilities) {
        int[] modes = characteristics.get(CameraCharacteristics.CONTROL_AE_AVAILABLE_MODES);
        Range<Long> times = characteristics.get(CameraCharacteristics.SENSOR_INFO_EXPOSURE_TIME_RANGE);
        Range<Integer> sensitivities = characteristics.get(CameraCharacteristics.SENSOR_INFO_SENSITIVITY_RANGE);
        if (capabilities == null || modes == null || times == null || sensitivities == null
                || !has(capabilities, CameraMetadata.REQUEST_AVAILABLE_CAPABILITIES_MANUAL_SENSOR)
                || !has(modes, CameraMetadata.CONTROL_AE_MODE_OFF) || times.getLower() <= 0
                || sensitivities.getLower() <= 0) {
            return null;
        }
        Range<Integer> boosts = characteristics.get(CameraCharacteristics.CONTROL_POST_RAW_SENSITIVITY_BOOST_RANGE);
        return new ExposureCap.Limits(times.getLower(), times.getUpper(), sensitivities.getLower(),
                sensitivities.getUpper(), boosts == null ? 100 : Math.max(100, boosts.getUpper()));
    }

    private static List<PixelSize> sizes(Size[] sizes) {
        List<PixelSize> out = new ArrayList<>();
        if (sizes != null) {
            for (Size size : sizes) {
                if (size != null && size.getWidth() > 0 && size.getHeight() > 0) {
                    out.add(new PixelSize(size.getWidth(), size.getHeight()));
                }
            }
        }
        return out;
    }

    private static long minFrameDurationNs(StreamConfigurationMap streams, PixelSize size) {
        try {
            return streams.getOutputMinFrameDuration(ImageFormat.YUV_420_888,
                    new Size(size.widthPx(), size.heightPx()));
        } catch (IllegalArgumentException e) {
            // some devices list a size and do not know it afterwards
            return 0;
        }
    }

    private static int count(Integer stated) {
        return stated == null ? 0 : Math.max(0, stated);
    }

    private static PixelArea area(Rect rect) {
        return rect == null || rect.width() <= 0 || rect.height() <= 0 ? null
                : new PixelArea(rect.left, rect.top, rect.width(), rect.height());
    }

    /** Collects traits; every method returns the builder itself and takes null for what is not stated. */
    static final class Builder {
        private final String id;
        private Facing facing = Facing.EXTERNAL;
        private int sensorOrientationDeg;
        private boolean takesPhotos = true;
        private Map<PixelSize, Long> frameSizes = new LinkedHashMap<>();
        private List<PixelSize> previewSizes = new ArrayList<>();
        private PixelArea activeArray;
        private PixelArea preCorrectionActiveArray;
        private PixelSize pixelArray;
        private float sensorWidthMm;
        private float sensorHeightMm;
        private float[] focalLengthsMm = {};
        private float[] intrinsicCalibration;
        private float[] distortion;
        private float minFocusDistanceDpt = -1;
        private boolean statesFocusDistance;
        private ExposureCap.Limits exposureLimits;
        private List<Range<Integer>> frameRates = Collections.emptyList();
        private int maxExposureAreas;
        private int maxFocusAreas;
        private boolean torch;
        private int[] focusModes = {};
        private int[] opticalStabilisationModes = {};
        private int[] videoStabilisationModes = {};
        private int[] edgeModes = {};
        private int[] noiseReductionModes = {};
        private int[] distortionCorrectionModes = {};
        private int[] rotateAndCropModes = {};

        Builder(String id) {
            this.id = id;
        }

        Builder facing(Facing value) {
            facing = value;
            return this;
        }

        /** Any whole number of degrees; what is no quarter turn counts as none. */
        Builder sensorOrientationDeg(int value) {
            int wrapped = Math.floorMod(value, 360);
            sensorOrientationDeg = wrapped % 90 == 0 ? wrapped : 0;
            return this;
        }

        Builder takesPhotos(boolean value) {
            takesPhotos = value;
            return this;
        }

        Builder frameSize(PixelSize size, long minFrameDurationNs) {
            frameSizes.put(size, minFrameDurationNs);
            return this;
        }

        Builder previewSize(PixelSize size) {
            previewSizes.add(size);
            return this;
        }

        Builder activeArray(PixelArea value) {
            activeArray = value;
            return this;
        }

        Builder preCorrectionActiveArray(PixelArea value) {
            preCorrectionActiveArray = value;
            return this;
        }

        Builder pixelArray(PixelSize value) {
            pixelArray = value;
            return this;
        }

        Builder sensorMm(float width, float height) {
            sensorWidthMm = width;
            sensorHeightMm = height;
            return this;
        }

        Builder focalLengthsMm(float... value) {
            focalLengthsMm = value.clone();
            return this;
        }

        Builder intrinsicCalibration(float... value) {
            intrinsicCalibration = value == null ? null : value.clone();
            return this;
        }

        Builder distortion(float... value) {
            distortion = value == null ? null : value.clone();
            return this;
        }

        Builder minFocusDistanceDpt(float value) {
            minFocusDistanceDpt = value;
            return this;
        }

        Builder statesFocusDistance(boolean value) {
            statesFocusDistance = value;
            return this;
        }

        Builder exposureLimits(ExposureCap.Limits value) {
            exposureLimits = value;
            return this;
        }

        Builder frameRates(List<Range<Integer>> value) {
            frameRates = value;
            return this;
        }

        Builder maxExposureAreas(int value) {
            maxExposureAreas = value;
            return this;
        }

        Builder maxFocusAreas(int value) {
            maxFocusAreas = value;
            return this;
        }

        Builder torch(boolean value) {
            torch = value;
            return this;
        }

        Builder focusModes(int... value) {
            focusModes = copy(value);
            return this;
        }

        Builder opticalStabilisationModes(int... value) {
            opticalStabilisationModes = copy(value);
            return this;
        }

        Builder videoStabilisationModes(int... value) {
            videoStabilisationModes = copy(value);
            return this;
        }

        Builder edgeModes(int... value) {
            edgeModes = copy(value);
            return this;
        }

        Builder noiseReductionModes(int... value) {
            noiseReductionModes = copy(value);
            return this;
        }

        Builder distortionCorrectionModes(int... value) {
            distortionCorrectionModes = copy(value);
            return this;
        }

        Builder rotateAndCropModes(int... value) {
            rotateAndCropModes = copy(value);
            return this;
        }

        private static int[] copy(int[] modes) {
            return modes == null ? new int[0] : modes.clone();
        }

        CameraTraits build() {
            Builder copy = new Builder(id);
            copy.facing = facing;
            copy.sensorOrientationDeg = sensorOrientationDeg;
            copy.takesPhotos = takesPhotos;
            copy.frameSizes = Collections.unmodifiableMap(new LinkedHashMap<>(frameSizes));
            copy.previewSizes = Collections.unmodifiableList(new ArrayList<>(previewSizes));
            copy.activeArray = activeArray;
            copy.preCorrectionActiveArray = preCorrectionActiveArray;
            copy.pixelArray = pixelArray;
            copy.sensorWidthMm = sensorWidthMm;
            copy.sensorHeightMm = sensorHeightMm;
            copy.focalLengthsMm = focalLengthsMm;
            copy.intrinsicCalibration = intrinsicCalibration;
            copy.distortion = distortion;
            copy.minFocusDistanceDpt = minFocusDistanceDpt;
            copy.statesFocusDistance = statesFocusDistance;
            copy.exposureLimits = exposureLimits;
            copy.frameRates = Collections.unmodifiableList(new ArrayList<>(frameRates));
            copy.maxExposureAreas = maxExposureAreas;
            copy.maxFocusAreas = maxFocusAreas;
            copy.torch = torch;
            copy.focusModes = focusModes;
            copy.opticalStabilisationModes = opticalStabilisationModes;
            copy.videoStabilisationModes = videoStabilisationModes;
            copy.edgeModes = edgeModes;
            copy.noiseReductionModes = noiseReductionModes;
            copy.distortionCorrectionModes = distortionCorrectionModes;
            copy.rotateAndCropModes = rotateAndCropModes;
            return new CameraTraits(copy);
        }
    }
}
