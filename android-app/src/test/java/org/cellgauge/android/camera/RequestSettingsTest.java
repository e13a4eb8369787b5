package org.cellgauge.android.camera;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import android.graphics.Rect;
import android.hardware.camera2.CameraMetadata;
import android.hardware.camera2.CaptureRequest;
import android.hardware.camera2.params.MeteringRectangle;
import android.os.Build;
import android.util.Range;
import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.Map;
import java.util.OptionalDouble;
import org.cellgauge.internal.geometry.PixelArea;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.annotation.Config;

/** What a camera is told, by what it offers. */
@RunWith(RobolectricTestRunner.class)
public class RequestSettingsTest {

    /** A camera of a good tablet. */
    private static CameraTraits.Builder able() {
        return new CameraTraits.Builder("0").minFocusDistanceDpt(10)
                .focusModes(CameraMetadata.CONTROL_AF_MODE_OFF, CameraMetadata.CONTROL_AF_MODE_AUTO,
                        CameraMetadata.CONTROL_AF_MODE_CONTINUOUS_PICTURE)
                .opticalStabilisationModes(0, 1).videoStabilisationModes(0, 1).edgeModes(0, 1, 2)
                .noiseReductionModes(0, 1, 2).distortionCorrectionModes(0, 1, 2).focalLengthsMm(4.2f)
                .rotateAndCropModes(CameraMetadata.SCALER_ROTATE_AND_CROP_NONE,
                        CameraMetadata.SCALER_ROTATE_AND_CROP_AUTO)
                .activeArray(new PixelArea(8, 6, 3984, 2988)).preCorrectionActiveArray(new PixelArea(0, 0, 4000, 3000));
    }

    private static Map<CaptureRequest.Key<?>, Object> settings(CameraTraits.Builder camera) {
        Map<CaptureRequest.Key<?>, Object> settings = new HashMap<>();
        of(camera).applyTo(into(settings));
        return settings;
    }

    private static RequestSettings of(CameraTraits.Builder camera) {
        return RequestSettings.of(camera.build(), OptionalDouble.empty());
    }

    private static RequestSettings.Target into(Map<CaptureRequest.Key<?>, Object> settings) {
        return new RequestSettings.Target() {
            @Override
            public <T> void set(CaptureRequest.Key<T> key, T value) {
                settings.put(key, value);
            }
        };
    }

    @Test
    @Config(minSdk = Build.VERSION_CODES.S)
    public void allThatMovesTheImageIsSwitchedOff() {
        Map<CaptureRequest.Key<?>, Object> settings = settings(able());
        assertEquals(CameraMetadata.CONTROL_AF_MODE_AUTO, settings.get(CaptureRequest.CONTROL_AF_MODE));
        assertEquals(CameraMetadata.LENS_OPTICAL_STABILIZATION_MODE_OFF,
                settings.get(CaptureRequest.LENS_OPTICAL_STABILIZATION_MODE));
        assertEquals(CameraMetadata.CONTROL_VIDEO_STABILIZATION_MODE_OFF,
                settings.get(CaptureRequest.CONTROL_VIDEO_STABILIZATION_MODE));
        assertEquals(CameraMetadata.DISTORTION_CORRECTION_MODE_OFF,
                settings.get(CaptureRequest.DISTORTION_CORRECTION_MODE));
        assertEquals(CameraMetadata.EDGE_MODE_OFF, settings.get(CaptureRequest.EDGE_MODE));
        assertEquals(CameraMetadata.NOISE_REDUCTION_MODE_FAST, settings.get(CaptureRequest.NOISE_REDUCTION_MODE));
        assertEquals(CameraMetadata.SCALER_ROTATE_AND_CROP_NONE, settings.get(CaptureRequest.SCALER_ROTATE_AND_CROP));
        assertFalse(settings.containsKey(CaptureRequest.LENS_FOCAL_LENGTH));
        assertEquals(Collections.emptySet(), of(able()).notes());
        assertEquals(RequestSettings.Focus.HELD, of(able()).focus());
    }

    @Test
    @Config(maxSdk = Build.VERSION_CODES.O_MR1)
    public void olderAndroidsAreAskedForAllThatTheyKnowAndNothingElse() {
        Map<CaptureRequest.Key<?>, Object> settings = settings(able());
        assertEquals(CameraMetadata.CONTROL_AF_MODE_AUTO, settings.get(CaptureRequest.CONTROL_AF_MODE));
        assertEquals(CameraMetadata.LENS_OPTICAL_STABILIZATION_MODE_OFF,
                settings.get(CaptureRequest.LENS_OPTICAL_STABILIZATION_MODE));
        assertEquals(CameraMetadata.CONTROL_VIDEO_STABILIZATION_MODE_OFF,
                settings.get(CaptureRequest.CONTROL_VIDEO_STABILIZATION_MODE));
        assertEquals(CameraMetadata.EDGE_MODE_OFF, settings.get(CaptureRequest.EDGE_MODE));
        for (CaptureRequest.Key<?> key : settings.keySet()) {
            assertFalse(key.getName(), key.getName().contains("distortion") || key.getName().contains("rotateAndCrop"));
        }
        // without the key for the correction it cannot be off, and areas are those after it
        assertEquals(new Rect(0, 0, 3984, 2988), settings.get(CaptureRequest.SCALER_CROP_REGION));
    }

    @Test
    @Config(minSdk = Build.VERSION_CODES.P)
    public void theWholeSensorIsShown() {
        assertEquals(new Rect(0, 0, 4000, 3000), settings(able()).get(CaptureRequest.SCALER_CROP_REGION));
        // where the lens is corrected whatever is asked, areas are those after it
        assertEquals(new Rect(0, 0, 3984, 2988),
                settings(able().distortionCorrectionModes(1)).get(CaptureRequest.SCALER_CROP_REGION));
        assertFalse(settings(able().activeArray(null).preCorrectionActiveArray(null))
                .containsKey(CaptureRequest.SCALER_CROP_REGION));
    }

    @Test
    public void aLensThatZoomsIsHeldAtItsShortest() {
        assertEquals(4.2f, settings(able().focalLengthsMm(8.4f, 4.2f)).get(CaptureRequest.LENS_FOCAL_LENGTH));
        assertFalse(settings(able().focalLengthsMm(0, Float.NaN)).containsKey(CaptureRequest.LENS_FOCAL_LENGTH));
    }

    @Test
    public void whatIsNotOfferedIsNotAskedFor() {
        Map<CaptureRequest.Key<?>, Object> settings = settings(new CameraTraits.Builder("0"));
        assertEquals(Collections.singletonMap(CaptureRequest.CONTROL_MODE, CameraMetadata.CONTROL_MODE_AUTO), settings);
    }

    /** Pairs of lowest and highest frame rate. */
    @SuppressWarnings({"unchecked", "rawtypes"}) // Java makes no arrays of types with arguments
    static Range<Integer>[] ranges(int... bounds) {
        Range<Integer>[] ranges = new Range[bounds.length / 2];
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = new Range<>(bounds[2 * i], bounds[2 * i + 1]);
        }
        return ranges;
    }

    private static Object rate(long frameNs, int... bounds) {
        PixelSize frame = new PixelSize(1280, 720);
        Map<CaptureRequest.Key<?>, Object> settings = new HashMap<>();
        of(able().frameSize(frame, frameNs).frameRates(Arrays.asList(ranges(bounds))))
                .keepExposureShort(into(settings), frame);
        return settings.get(CaptureRequest.CONTROL_AE_TARGET_FPS_RANGE);
    }

    @Test
    public void exposureIsKeptShortByTheRateOfFrames() {
        assertEquals(new Range<>(30, 30), rate(33_333_333, 7, 30, 15, 30, 30, 30, 15, 15));
        assertEquals(new Range<>(24, 30), rate(0, 15, 30, 24, 30, 24, 24, 60, 60));
        // large frames come no faster than 15 times a second
        assertEquals(new Range<>(15, 15), rate(66_700_000, 7, 15, 15, 15, 30, 30));
        assertEquals(new Range<>(30_000, 30_000), rate(33_333_333, 15_000, 30_000, 30_000, 30_000));
        assertNull(rate(33_333_333));
        assertNull(rate(33_333_333, 60, 60));
    }

    @Test
    @Config(minSdk = Build.VERSION_CODES.P)
    public void lightAndFocusAreMeteredAtAsManyMarkersAsTheCameraTakes() {
        Detections seen = new Detections("frame", 1600, 900, Arrays.asList(marker(5, 100, 100, 50),
                marker(7, 800, 400, 100), marker(9, 1570, 860, 60)));
        Map<CaptureRequest.Key<?>, Object> settings = new HashMap<>();
        // a frame of 16:9 is 4000 x 2250 px in the middle of 4000 x 3000
        of(able().maxExposureAreas(8).maxFocusAreas(1)).meterAt(into(settings), seen);
        MeteringRectangle[] light = (MeteringRectangle[]) settings.get(CaptureRequest.CONTROL_AE_REGIONS);
        assertEquals(3, light.length);
        assertEquals(new Rect(1950, 1325, 2300, 1675), light[0].getRect());
        assertEquals(MeteringRectangle.METERING_WEIGHT_MAX, light[0].getMeteringWeight());
        assertEquals("within the sensor", 3999, light[1].getRect().right);
        MeteringRectangle[] focus = (MeteringRectangle[]) settings.get(CaptureRequest.CONTROL_AF_REGIONS);
        assertEquals(1, focus.length);
        assertEquals(light[0], focus[0]);

        settings.clear();
        assertEquals(Collections.emptyList(), of(able()).meterAt(into(settings), seen));
        of(able().maxExposureAreas(8)).meterAt(into(settings),
                new Detections("frame", 1600, 900, Collections.emptyList()));
        assertEquals("what is not offered, or not seen", Collections.emptyMap(), settings);
    }

    private static MarkerObservation marker(int id, double left, double top, double side) {
        return new MarkerObservation(id, new double[] {left, top, left + side, top, left + side, top + side, left,
            top + side});
    }

    @Test
    public void stabilisationThatCannotBeOffIsSaid() {
        assertEquals(EnumSet.of(CameraNote.STABILISATION_ON),
                of(able().opticalStabilisationModes(1)).notes());
        assertEquals(EnumSet.of(CameraNote.STABILISATION_ON),
                of(able().videoStabilisationModes(1, 2)).notes());
        assertNull(settings(able().opticalStabilisationModes(1)).get(CaptureRequest.LENS_OPTICAL_STABILIZATION_MODE));
    }

    @Test
    public void aLensThatDoesNotMoveNeedsNoLock() {
        CameraTraits.Builder fixed = able().minFocusDistanceDpt(0);
        assertEquals(RequestSettings.Focus.FIXED, of(fixed).focus());
        assertEquals(CameraMetadata.CONTROL_AF_MODE_OFF, settings(fixed).get(CaptureRequest.CONTROL_AF_MODE));
        CameraTraits.Builder off = able().minFocusDistanceDpt(-1).focusModes(CameraMetadata.CONTROL_AF_MODE_OFF);
        assertEquals(RequestSettings.Focus.FIXED, of(off).focus());
        assertEquals(Collections.emptySet(), of(off).notes());
    }

    @Test
    public void aContinuousFocusIsHeldByItsTrigger() {
        CameraTraits.Builder camera = able().focusModes(CameraMetadata.CONTROL_AF_MODE_OFF,
                CameraMetadata.CONTROL_AF_MODE_CONTINUOUS_VIDEO);
        assertEquals(RequestSettings.Focus.HELD, of(camera).focus());
        assertEquals(CameraMetadata.CONTROL_AF_MODE_CONTINUOUS_VIDEO,
                settings(camera).get(CaptureRequest.CONTROL_AF_MODE));
    }

    private static final OptionalDouble NEAR = OptionalDouble.of(0.4);

    private static void assertNotAsCalibrated(CameraTraits.Builder camera, RequestSettings.Focus focus) {
        RequestSettings settings = RequestSettings.of(camera.build(), NEAR);
        assertEquals(focus, settings.focus());
        assertTrue(settings.notes().contains(CameraNote.FOCUS_NOT_AS_CALIBRATED));
        Map<CaptureRequest.Key<?>, Object> told = new HashMap<>();
        settings.applyTo(into(told));
        assertFalse(told.containsKey(CaptureRequest.LENS_FOCUS_DISTANCE));
    }

    @Test
    public void aLensIsSetToTheDistanceOfItsCalibration() {
        CameraTraits.Builder camera = able().statesFocusDistance(true);
        RequestSettings settings = RequestSettings.of(camera.build(), NEAR);
        assertEquals(RequestSettings.Focus.AT_DISTANCE, settings.focus());
        assertEquals(EnumSet.of(CameraNote.FOCUS_AS_CALIBRATED), settings.notes());
        Map<CaptureRequest.Key<?>, Object> told = new HashMap<>();
        settings.applyTo(into(told));
        assertEquals(CameraMetadata.CONTROL_AF_MODE_OFF, told.get(CaptureRequest.CONTROL_AF_MODE));
        assertEquals(2.5f, told.get(CaptureRequest.LENS_FOCUS_DISTANCE));
        // nearer than the lens goes by a hair
        told.clear();
        RequestSettings.of(camera.minFocusDistanceDpt(2.4f).build(), NEAR).applyTo(into(told));
        assertEquals(2.4f, told.get(CaptureRequest.LENS_FOCUS_DISTANCE));
        // without a distance as before
        assertEquals(RequestSettings.Focus.HELD, of(camera).focus());
        assertFalse(settings(camera).containsKey(CaptureRequest.LENS_FOCUS_DISTANCE));
    }

    @Test
    public void aLensThatCannotBeSetToTheDistanceIsFocusedAsBeforeAndThatIsSaid() {
        assertNotAsCalibrated(able(), RequestSettings.Focus.HELD);
        assertNotAsCalibrated(able().statesFocusDistance(true).minFocusDistanceDpt(2.3f), RequestSettings.Focus.HELD);
        assertNotAsCalibrated(able().statesFocusDistance(true).focusModes(CameraMetadata.CONTROL_AF_MODE_AUTO),
                RequestSettings.Focus.HELD);
        assertNotAsCalibrated(able().focusModes(CameraMetadata.CONTROL_AF_MODE_EDOF), RequestSettings.Focus.FREE);
        // one that does not move is where it was
        assertEquals(Collections.emptySet(),
                RequestSettings.of(able().minFocusDistanceDpt(0).build(), NEAR).notes());
    }

    @Test
    public void anExposureIsStatedWithTheTimeOfItsFrame() {
        PixelSize frame = new PixelSize(1280, 720);
        ExposureCap.Exposure exposure = new ExposureCap.Exposure(10_000_000, 1320, 180);
        Map<CaptureRequest.Key<?>, Object> told = new HashMap<>();
        CameraTraits.Builder camera = able().frameSize(frame, 20_000_000);
        of(camera).expose(into(told), exposure, frame);
        assertEquals(CameraMetadata.CONTROL_AE_MODE_OFF, told.get(CaptureRequest.CONTROL_AE_MODE));
        assertEquals(10_000_000L, told.get(CaptureRequest.SENSOR_EXPOSURE_TIME));
        assertEquals(1320, told.get(CaptureRequest.SENSOR_SENSITIVITY));
        assertEquals(33_333_333L, told.get(CaptureRequest.SENSOR_FRAME_DURATION));
        assertFalse(told.containsKey(CaptureRequest.CONTROL_POST_RAW_SENSITIVITY_BOOST));
        camera.frameSize(frame, 66_000_000).exposureLimits(new ExposureCap.Limits(1, 2, 1, 2, 200));
        of(camera).expose(into(told), exposure, frame);
        assertEquals("as fast as frames of that size come", 66_000_000L,
                told.get(CaptureRequest.SENSOR_FRAME_DURATION));
        assertEquals(180, told.get(CaptureRequest.CONTROL_POST_RAW_SENSITIVITY_BOOST));
        of(camera).expose(into(told), new ExposureCap.Exposure(80_000_000, 1, 100), new PixelSize(9, 9));
        assertEquals("a frame takes its exposure", 80_000_000L, told.get(CaptureRequest.SENSOR_FRAME_DURATION));
        told.clear();
        of(camera).expose(into(told), null, frame);
        assertEquals(Collections.singletonMap(CaptureRequest.CONTROL_AE_MODE, CameraMetadata.CONTROL_AE_MODE_ON), told);
    }

    @Test
    public void aFocusThatNobodyHoldsIsSaid() {
        RequestSettings edof = of(able().focusModes(CameraMetadata.CONTROL_AF_MODE_EDOF));
        assertEquals(RequestSettings.Focus.FREE, edof.focus());
        assertEquals(EnumSet.of(CameraNote.FOCUS_NOT_LOCKED), edof.notes());
        assertEquals(EnumSet.of(CameraNote.FOCUS_NOT_LOCKED),
                of(new CameraTraits.Builder("0")).notes());
    }
}
