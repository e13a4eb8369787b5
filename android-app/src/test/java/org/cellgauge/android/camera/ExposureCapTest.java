package org.cellgauge.android.camera;

import static android.hardware.camera2.CameraMetadata.CONTROL_AE_STATE_CONVERGED;
import static android.hardware.camera2.CameraMetadata.CONTROL_AE_STATE_FLASH_REQUIRED;
import static android.hardware.camera2.CameraMetadata.CONTROL_AE_STATE_INACTIVE;
import static android.hardware.camera2.CameraMetadata.CONTROL_AE_STATE_SEARCHING;
import static android.hardware.camera2.CameraMetadata.STATISTICS_SCENE_FLICKER_60HZ;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** How long frames are exposed, and when the light is measured anew. */
class ExposureCapTest {
    private static final ExposureCap.Limits LIMITS = new ExposureCap.Limits(100_000, 500_000_000, 50, 3200, 100);
    private static final long MS = 1_000_000;
    private static final long FRAME_NS = 33 * MS;

    private ExposureCap cap = new ExposureCap(LIMITS);
    private long timeNs = 7_000 * MS;

    private boolean measured(double ms, int sensitivity) {
        boolean changed = false;
        for (int i = 0; i < ExposureCap.SETTLED_FRAMES; i++) {
            assertFalse(changed);
            changed = cap.report(CONTROL_AE_STATE_CONVERGED, Math.round(ms * MS), sensitivity, null, null);
        }
        return changed;
    }

    /** How many of the next frames, all alike, have something else asked for. */
    private int changesIn(double seconds, double white) {
        int changes = 0;
        for (long end = timeNs + Math.round(seconds * 1000) * MS; timeNs < end; timeNs += FRAME_NS) {
            changes += cap.look(white, timeNs) ? 1 : 0;
        }
        return changes;
    }

    @Test
    void longExposureIsCutAndMadeUpForBySensitivity() {
        assertTrue(measured(33, 400));
        assertEquals(new ExposureCap.Exposure(10 * MS, 1320, 100), cap.held());
        assertFalse(cap.isLightShort());
        assertFalse(measured(33, 400), "one of before comes late");
        assertEquals(1320, cap.held().sensitivity());
    }

    @ParameterizedTest
    @CsvSource({"10", "10.4", "2"})
    void shortExposureIsTheDevices(double ms) {
        assertFalse(measured(ms, 3200));
        assertNull(cap.held());
        assertFalse(cap.isLightShort());
    }

    @Test
    void lightIsMeasuredToItsEndFirst() {
        for (int i = 0; i < 20; i++) {
            assertFalse(cap.report(CONTROL_AE_STATE_SEARCHING, 33 * MS, 400, null, null));
            assertFalse(cap.report(CONTROL_AE_STATE_CONVERGED, 33 * MS, 400, null, null));
            assertFalse(cap.report(CONTROL_AE_STATE_INACTIVE, 33 * MS, 400, null, null));
            assertFalse(cap.report(CONTROL_AE_STATE_CONVERGED, null, 400, null, null));
            assertFalse(cap.report(CONTROL_AE_STATE_CONVERGED, 33 * MS, null, null, null));
            assertFalse(cap.report(null, 33 * MS, 400, null, null));
        }
        for (int i = 1; i < ExposureCap.SETTLED_FRAMES; i++) {
            assertFalse(cap.report(CONTROL_AE_STATE_FLASH_REQUIRED, 33 * MS, 400, null, null));
        }
        assertTrue(cap.report(CONTROL_AE_STATE_FLASH_REQUIRED, 33 * MS, 400, null, null), "dark is measured too");
    }

    @Test
    void lampsOfSixtyHertzHaveAShorterPeriod() {
        for (int i = 0; i < ExposureCap.SETTLED_FRAMES; i++) {
            cap.report(CONTROL_AE_STATE_CONVERGED, 25 * MS, 400, null, STATISTICS_SCENE_FLICKER_60HZ);
        }
        assertEquals(new ExposureCap.Exposure(8_333_333, 1200, 100), cap.held());
    }

    @Test
    void greyValuesAreRaisedWhereTheSensorCannot() {
        cap = new ExposureCap(new ExposureCap.Limits(100_000, 500_000_000, 50, 1000, 400));
        for (int i = 0; i < ExposureCap.SETTLED_FRAMES; i++) {
            cap.report(CONTROL_AE_STATE_CONVERGED, 30 * MS, 400, 150, null);
        }
        assertEquals(new ExposureCap.Exposure(10 * MS, 1000, 180), cap.held());
        assertFalse(cap.isLightShort());
    }

    /** What is lacking may make the picture darker, by half at most; then exposures get longer again. */
    @Test
    void tooLittleLightIsSaidAndNeverMakesThePictureBlack() {
        assertTrue(measured(18, 2200));
        assertEquals(new ExposureCap.Exposure(10 * MS, 3200, 100), cap.held());
        assertFalse(cap.isLightShort(), "0.81 of the light");
        cap = new ExposureCap(LIMITS);
        assertTrue(measured(18, 3200));
        assertEquals(new ExposureCap.Exposure(10 * MS, 3200, 100), cap.held());
        assertTrue(cap.isLightShort());
        cap = new ExposureCap(LIMITS);
        assertTrue(measured(33, 3200));
        assertEquals(3200, cap.held().sensitivity());
        assertEquals(16.5 * MS, cap.held().timeNs(), 10);
        assertTrue(cap.isLightShort());
        cap.measureAgain();
        assertTrue(cap.isLightShort(), "until more is known");
        assertFalse(measured(9, 800));
        assertFalse(cap.isLightShort());
    }

    @Test
    void aSensorThatCannotBeToldIsLeftAlone() {
        cap = new ExposureCap(null);
        assertFalse(measured(33, 400));
        assertNull(cap.held());
        cap = new ExposureCap(new ExposureCap.Limits(1, 5 * MS, 50, 3200, 100));
        assertFalse(measured(33, 400));
        assertNull(cap.held());
        cap = new ExposureCap(new ExposureCap.Limits(20 * MS, 500 * MS, 50, 3200, 100));
        assertTrue(measured(33, 400));
        assertEquals(20 * MS, cap.held().timeNs());
    }

    @ParameterizedTest
    @CsvSource({"160, 121, 119", "160, 191, 193", "230, 249, 250"})
    void otherLightOnTheMarkersIsMeasuredAnew(double white, double same, double other) {
        measured(33, 400);
        // frames exposed as before may still come
        assertEquals(0, changesIn(0.4, 30));
        assertEquals(0, changesIn(2, white));
        assertEquals(0, changesIn(5, same));
        assertNotNull(cap.held());
        for (int i = 1; i < 5; i++) {
            assertEquals(0, changesIn(0.033, other));
        }
        assertEquals(0, changesIn(0.033, white), "one frame as before");
        assertEquals(1, changesIn(5 * 0.033, other));
        assertNull(cap.held());
        assertEquals(0, changesIn(5, other), "the device exposes");
    }

    @Test
    void lightIsNotMeasuredAllTheTime() {
        measured(33, 400);
        assertEquals(0, changesIn(0.6, 160));
        assertEquals(0, changesIn(1.3, 80));
        assertEquals(1, changesIn(0.4, 80));
    }

    @Test
    void whereNoMarkerIsSeenLightIsMeasuredAnewNowAndThen() {
        measured(33, 400);
        assertEquals(0, changesIn(10, 160));
        assertEquals(0, changesIn(2.9, Double.NaN));
        assertEquals(0, changesIn(0.1, 160));
        assertEquals(0, changesIn(2.9, Double.NaN));
        assertEquals(1, changesIn(0.3, Double.NaN));
        assertTrue(measured(33, 400), "and held again");
        assertEquals(0, changesIn(2.9, Double.NaN));
    }

    @Test
    void aLampThatIsSwitchedHasLightMeasuredAnew() {
        assertFalse(cap.measureAgain());
        measured(33, 400);
        assertTrue(cap.measureAgain());
        assertNull(cap.held());
        assertFalse(measured(5, 100));
    }
}
