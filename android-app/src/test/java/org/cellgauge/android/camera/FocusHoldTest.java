package org.cellgauge.android.camera;

import static android.hardware.camera2.CameraMetadata.CONTROL_AF_STATE_ACTIVE_SCAN;
import static android.hardware.camera2.CameraMetadata.CONTROL_AF_STATE_FOCUSED_LOCKED;
import static android.hardware.camera2.CameraMetadata.CONTROL_AF_STATE_INACTIVE;
import static android.hardware.camera2.CameraMetadata.CONTROL_AF_STATE_NOT_FOCUSED_LOCKED;
import static android.hardware.camera2.CameraMetadata.LENS_STATE_MOVING;
import static android.hardware.camera2.CameraMetadata.LENS_STATE_STATIONARY;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** When the lens stands still. */
class FocusHoldTest {
    private final FocusHold focus = new FocusHold(RequestSettings.Focus.HELD, Float.NaN);

    @ParameterizedTest
    @EnumSource(value = RequestSettings.Focus.class, names = {"FIXED", "FREE"})
    void aLensThatCannotBeHeldIsNeverWaitedFor(RequestSettings.Focus kind) {
        FocusHold other = new FocusHold(kind, Float.NaN);
        assertFalse(other.canScan());
        other.scanAsked();
        assertTrue(other.isStill());
        assertFalse(other.giveUp());
    }

    @ParameterizedTest
    @ValueSource(ints = {CONTROL_AF_STATE_FOCUSED_LOCKED, CONTROL_AF_STATE_NOT_FOCUSED_LOCKED})
    void framesWaitForTheEndOfTheScan(int end) {
        focus.scanAsked();
        assertFalse(focus.isStill());
        focus.scanBegun(7);
        assertFalse(focus.report(7, CONTROL_AF_STATE_INACTIVE));
        assertFalse(focus.report(8, CONTROL_AF_STATE_ACTIVE_SCAN));
        assertFalse(focus.isStill());
        assertTrue(focus.report(9, end));
        assertTrue(focus.isStill());
        assertFalse(focus.report(10, end));
    }

    @Test
    void reportsOnFramesBeforeTheScanAreOfThePast() {
        focus.scanAsked();
        assertFalse(focus.report(5, CONTROL_AF_STATE_FOCUSED_LOCKED));
        focus.scanBegun(7);
        assertFalse(focus.report(6, CONTROL_AF_STATE_FOCUSED_LOCKED));
        assertFalse(focus.isStill());
        focus.report(8, CONTROL_AF_STATE_FOCUSED_LOCKED);
        assertTrue(focus.isStill());
        focus.scanAsked();
        assertFalse(focus.report(9, CONTROL_AF_STATE_FOCUSED_LOCKED));
        assertFalse(focus.isStill());
    }

    @Test
    void aScanMayEndWithTheFrameThatItWasAskedFor() {
        focus.scanAsked();
        focus.scanBegun(7);
        assertTrue(focus.report(7, CONTROL_AF_STATE_FOCUSED_LOCKED));
    }

    @Test
    void aScanThatFoundNothingIsToldFromOneThatDid() {
        focus.scanAsked();
        focus.scanBegun(1);
        focus.report(2, CONTROL_AF_STATE_NOT_FOCUSED_LOCKED);
        assertFalse(focus.found());
        focus.scanAsked();
        focus.scanBegun(3);
        focus.report(4, CONTROL_AF_STATE_FOCUSED_LOCKED);
        assertTrue(focus.found());
    }

    @Test
    void aLensThatIsSetToADistanceIsWaitedForUntilItStandsThere() {
        FocusHold set = new FocusHold(RequestSettings.Focus.AT_DISTANCE, 2);
        assertFalse(set.canScan());
        assertFalse(set.isStill());
        assertFalse(set.report(1, CONTROL_AF_STATE_FOCUSED_LOCKED));
        assertFalse(set.lensReport(LENS_STATE_STATIONARY, 1.8f), "has not begun to move");
        assertFalse(set.lensReport(LENS_STATE_STATIONARY, 2.2f));
        assertFalse(set.lensReport(LENS_STATE_MOVING, 2f));
        assertFalse(set.lensReport(LENS_STATE_STATIONARY, null));
        assertFalse(set.lensReport(null, null));
        assertFalse(set.isStill());
        assertTrue(set.lensReport(LENS_STATE_STATIONARY, 1.9f));
        assertTrue(set.isStill());
        assertTrue(set.found());
        assertFalse(set.lensReport(LENS_STATE_STATIONARY, 2f), "is there already");
        set.scanAsked();
        assertTrue(set.isStill());
        FocusHold silent = new FocusHold(RequestSettings.Focus.AT_DISTANCE, 2);
        assertTrue(silent.lensReport(null, 2f), "a device that states no state");
        assertTrue(new FocusHold(RequestSettings.Focus.AT_DISTANCE, 0.001f).lensReport(null, 0.04f), "far off");
        assertFalse(focus.lensReport(LENS_STATE_STATIONARY, 2f));
        FocusHold lost = new FocusHold(RequestSettings.Focus.AT_DISTANCE, 2);
        assertTrue(lost.giveUp());
        assertTrue(lost.isStill());
    }

    @Test
    void aDeviceThatReportsNothingIsGivenUp() {
        focus.scanAsked();
        focus.scanBegun(1);
        assertFalse(focus.report(2, null));
        assertTrue(focus.giveUp());
        assertTrue(focus.isStill());
        assertFalse(focus.giveUp());
    }
}
