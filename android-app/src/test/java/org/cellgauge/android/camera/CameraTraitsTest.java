package org.cellgauge.android.camera;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import android.graphics.ImageFormat;
import android.graphics.Rect;
import android.hardware.camera2.CameraCharacteristics;
import android.hardware.camera2.CameraMetadata;
import android.os.Build;
import android.util.Range;
import android.util.Size;
import android.util.SizeF;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.annotation.Config;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowCameraCharacteristics;
import org.robolectric.shadows.StreamConfigurationMapBuilder;

/** What is read from a camera's characteristics, and what from those of a device that states nothing or nonsense. */
@RunWith(RobolectricTestRunner.class)
public class CameraTraitsTest {
    private CameraCharacteristics characteristics = ShadowCameraCharacteristics.newCameraCharacteristics();

    private <T> void state(CameraCharacteristics.Key<T> key, T value) {
        ((ShadowCameraCharacteristics) Shadow.extract(characteristics)).set(key, value);
    }

    @Test
    @Config(minSdk = Build.VERSION_CODES.S)
    public void whatADeviceStatesIsRead() {
        state(CameraCharacteristics.LENS_FACING, CameraMetadata.LENS_FACING_BACK);
        state(CameraCharacteristics.SENSOR_ORIENTATION, 90);
        state(CameraCharacteristics.REQUEST_AVAILABLE_CAPABILITIES, new int[] {0, 1});
        state(CameraCharacteristics.LENS_INFO_FOCUS_DISTANCE_CALIBRATION, 1);
        state(CameraCharacteristics.CONTROL_AE_AVAILABLE_MODES, new int[] {0, 1});
        state(CameraCharacteristics.SENSOR_INFO_EXPOSURE_TIME_RANGE, new Range<>(9_000L, 700_000_000L));
        state(CameraCharacteristics.SENSOR_INFO_SENSITIVITY_RANGE, new Range<>(60, 3100));
        state(CameraCharacteristics.SCALER_STREAM_CONFIGURATION_MAP, StreamConfigurationMapBuilder.newBuilder()
                .addOutputSize(ImageFormat.YUV_420_888, new Size(1920, 1080))
                .addOutputSize(ImageFormat.YUV_420_888, new Size(640, 480)).addOutputSize(new Size(1280, 720)).build());
        state(CameraCharacteristics.SENSOR_INFO_ACTIVE_ARRAY_SIZE, new Rect(8, 6, 3992, 2994));
        state(CameraCharacteristics.SENSOR_INFO_PRE_CORRECTION_ACTIVE_ARRAY_SIZE, new Rect(0, 0, 4000, 3000));
        state(CameraCharacteristics.SENSOR_INFO_PIXEL_ARRAY_SIZE, new Size(4008, 3008));
        state(CameraCharacteristics.SENSOR_INFO_PHYSICAL_SIZE, new SizeF(5.6f, 4.2f));
        state(CameraCharacteristics.LENS_INFO_AVAILABLE_FOCAL_LENGTHS, new float[] {4.2f});
        state(CameraCharacteristics.LENS_INTRINSIC_CALIBRATION, new float[] {3100, 3110, 2020, 1490, 0});
        state(CameraCharacteristics.LENS_DISTORTION, new float[] {0.1f, 0, 0, 0, 0});
        state(CameraCharacteristics.LENS_INFO_MINIMUM_FOCUS_DISTANCE, 10f);
        state(CameraCharacteristics.CONTROL_AE_AVAILABLE_TARGET_FPS_RANGES, RequestSettingsTest.ranges(15, 30));
        state(CameraCharacteristics.CONTROL_MAX_REGIONS_AE, 9);
        state(CameraCharacteristics.CONTROL_MAX_REGIONS_AF, 1);
        state(CameraCharacteristics.FLASH_INFO_AVAILABLE, true);
        state(CameraCharacteristics.CONTROL_AF_AVAILABLE_MODES, new int[] {0, 1, 4});
        state(CameraCharacteristics.LENS_INFO_AVAILABLE_OPTICAL_STABILIZATION, new int[] {0, 1});
        state(CameraCharacteristics.CONTROL_AVAILABLE_VIDEO_STABILIZATION_MODES, new int[] {0});
        state(CameraCharacteristics.EDGE_AVAILABLE_EDGE_MODES, new int[] {1, 2});
        state(CameraCharacteristics.NOISE_REDUCTION_AVAILABLE_NOISE_REDUCTION_MODES, new int[] {0, 1});
        state(CameraCharacteristics.DISTORTION_CORRECTION_AVAILABLE_MODES, new int[] {0, 1});
        state(CameraCharacteristics.SCALER_AVAILABLE_ROTATE_AND_CROP_MODES, new int[] {0, 3});

        CameraTraits traits = CameraTraits.of("0", characteristics);
        assertEquals("0", traits.id());
        assertEquals(CameraTraits.Facing.BACK, traits.facing());
        assertEquals(90, traits.sensorOrientationDeg());
        assertTrue(traits.takesPhotos());
        assertEquals(new HashSet<>(Arrays.asList(new PixelSize(1920, 1080), new PixelSize(640, 480))),
                traits.frameSizes().keySet());
        assertEquals(Collections.singletonList(new PixelSize(1280, 720)), traits.previewSizes());
        assertEquals("3984.0 x 2988.0 px at (8.0, 6.0)", traits.activeArray().toString());
        assertEquals("4000.0 x 3000.0 px at (0.0, 0.0)", traits.preCorrectionActiveArray().toString());
        assertEquals(new PixelSize(4008, 3008), traits.pixelArray());
        assertEquals(5.6f, traits.sensorWidthMm(), 0);
        assertEquals(4.2f, traits.sensorHeightMm(), 0);
        assertArrayEquals(new float[] {4.2f}, traits.focalLengthsMm(), 0);
        assertArrayEquals(new float[] {3100, 3110, 2020, 1490, 0}, traits.intrinsicCalibration(), 0);
        assertArrayEquals(new float[] {0.1f, 0, 0, 0, 0}, traits.distortion(), 0);
        assertEquals(10, traits.minFocusDistanceDpt(), 0);
        assertTrue(traits.statesFocusDistance());
        assertEquals(new ExposureCap.Limits(9_000, 700_000_000, 60, 3100, 100), traits.exposureLimits());
        assertEquals("[[15, 30]]", traits.frameRates().toString());
        assertEquals(9, traits.maxExposureAreas());
        assertEquals(1, traits.maxFocusAreas());
        assertTrue(traits.hasTorch());
        assertArrayEquals(new int[] {0, 1, 4}, traits.focusModes());
        assertArrayEquals(new int[] {0, 1}, traits.opticalStabilisationModes());
        assertArrayEquals(new int[] {0}, traits.videoStabilisationModes());
        assertArrayEquals(new int[] {1, 2}, traits.edgeModes());
        assertArrayEquals(new int[] {0, 1}, traits.noiseReductionModes());
        assertArrayEquals(new int[] {0, 3}, traits.rotateAndCropModes());
        assertFalse(traits.alwaysCorrectsLens());
    }

    /** Of API 26 and 27 the lens' distortion is not known: what they state of it has no fixed meaning. */
    @Test
    @Config(maxSdk = Build.VERSION_CODES.O_MR1)
    public void olderAndroidsStateNoDistortion() {
        state(CameraCharacteristics.SENSOR_INFO_ACTIVE_ARRAY_SIZE, new Rect(8, 6, 3992, 2994));
        state(CameraCharacteristics.SENSOR_INFO_PRE_CORRECTION_ACTIVE_ARRAY_SIZE, new Rect(0, 0, 4000, 3000));
        state(CameraCharacteristics.LENS_INTRINSIC_CALIBRATION, new float[] {3100, 3110, 2020, 1490, 0});
        CameraTraits traits = CameraTraits.of("0", characteristics);
        assertNull(traits.distortion());
        assertTrue(traits.alwaysCorrectsLens());
        assertEquals(3100, traits.intrinsicCalibration()[0], 0);
    }

    @Test
    public void aDeviceThatStatesNothingIsReadToo() {
        CameraTraits traits = CameraTraits.of("7", characteristics);
        assertEquals(CameraTraits.Facing.EXTERNAL, traits.facing());
        assertEquals(0, traits.sensorOrientationDeg());
        assertTrue(traits.frameSizes().isEmpty());
        assertTrue(traits.previewSizes().isEmpty());
        assertNull(traits.activeArray());
        assertNull(traits.preCorrectionActiveArray());
        assertNull(traits.pixelArray());
        assertNull(traits.intrinsicCalibration());
        assertNull(traits.distortion());
        assertEquals(0, traits.focalLengthsMm().length);
        assertEquals(-1, traits.minFocusDistanceDpt(), 0);
        assertTrue(traits.frameRates().isEmpty());
        assertEquals(0, traits.maxExposureAreas() + traits.maxFocusAreas());
        assertFalse(traits.hasTorch());
        assertFalse(traits.statesFocusDistance());
        assertNull(traits.exposureLimits());
        assertFalse(traits.alwaysCorrectsLens());
    }

    private ExposureCap.Limits limits(int[] capabilities, int[] modes, long shortestNs, Range<Integer> boosts) {
        characteristics = ShadowCameraCharacteristics.newCameraCharacteristics();
        state(CameraCharacteristics.REQUEST_AVAILABLE_CAPABILITIES, capabilities);
        state(CameraCharacteristics.CONTROL_AE_AVAILABLE_MODES, modes);
        state(CameraCharacteristics.SENSOR_INFO_EXPOSURE_TIME_RANGE, new Range<>(shortestNs, 700_000_000L));
        state(CameraCharacteristics.SENSOR_INFO_SENSITIVITY_RANGE, new Range<>(60, 3100));
        state(CameraCharacteristics.CONTROL_POST_RAW_SENSITIVITY_BOOST_RANGE, boosts);
        return CameraTraits.of("0", characteristics).exposureLimits();
    }

    /** Ranges may be there where the sensor cannot be told; only the capability says that it can. */
    @Test
    public void aSensorThatOnlyTheDeviceExposesHasNoLimits() {
        int[] able = {0, 1};
        assertEquals(new ExposureCap.Limits(9_000, 700_000_000, 60, 3100, 100), limits(able, able, 9_000, null));
        assertEquals(350, limits(able, able, 9_000, new Range<>(100, 350)).mostBoost());
        assertNull(limits(new int[] {0}, able, 9_000, null));
        assertNull(limits(able, new int[] {1}, 9_000, null));
        assertNull(limits(able, able, 0, null));
    }

    @Test
    public void distancesOfFocusInUnitsOfTheDevicesOwnMeanNothing() {
        int[] kinds = {CameraMetadata.LENS_INFO_FOCUS_DISTANCE_CALIBRATION_UNCALIBRATED,
            CameraMetadata.LENS_INFO_FOCUS_DISTANCE_CALIBRATION_APPROXIMATE,
            CameraMetadata.LENS_INFO_FOCUS_DISTANCE_CALIBRATION_CALIBRATED};
        for (int kind : kinds) {
            characteristics = ShadowCameraCharacteristics.newCameraCharacteristics();
            state(CameraCharacteristics.LENS_INFO_FOCUS_DISTANCE_CALIBRATION, kind);
            assertEquals(kind != kinds[0], CameraTraits.of("0", characteristics).statesFocusDistance());
        }
    }

    @Test
    public void emptyAreasAndOddAnglesAreNone() {
        state(CameraCharacteristics.SENSOR_INFO_ACTIVE_ARRAY_SIZE, new Rect(0, 0, 0, 0));
        state(CameraCharacteristics.SENSOR_INFO_PIXEL_ARRAY_SIZE, new Size(0, 0));
        state(CameraCharacteristics.SENSOR_ORIENTATION, 45);
        CameraTraits traits = CameraTraits.of("0", characteristics);
        assertNull(traits.activeArray());
        assertNull(traits.pixelArray());
        assertEquals(0, traits.sensorOrientationDeg());
        characteristics = ShadowCameraCharacteristics.newCameraCharacteristics();
        state(CameraCharacteristics.SENSOR_ORIENTATION, -90);
        assertEquals(270, CameraTraits.of("0", characteristics).sensorOrientationDeg());
    }

    @Test
    public void depthSensorsTakeNoPhotos() {
        state(CameraCharacteristics.REQUEST_AVAILABLE_CAPABILITIES,
                new int[] {CameraMetadata.REQUEST_AVAILABLE_CAPABILITIES_DEPTH_OUTPUT});
        assertFalse(CameraTraits.of("0", characteristics).takesPhotos());
    }
}
