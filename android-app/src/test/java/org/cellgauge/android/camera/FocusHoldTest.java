package org.cellgauge.android.camera;

import static android.hardware.camera2.CameraMetadata.CONTROL_AF_STATE_ACTIVE_SCAN;
import static android.hardware.camera2.CameraMetadata.CONTROL_AF_STATE_FOCUSED_LOCKED;
import static android.hardware.camera2.CameraMetadata.CONTROL_AF_STATE_INACTIVE;
import static android.hardware.camera2.CameraMetadata.CONTROL_AF_STATE_NOT_FOCUSED_LOCKED;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** When the lens stands still. */
class FocusHoldTest {
    private final FocusHold focus = new FocusHold(RequestSettings.Focus.HELD);

    @ParameterizedTest
    @EnumSource(value = RequestSettings.Focus.class, names = {"FIXED", "FREE"})
    void aLensThatCannotBeHeldIsNeverWaitedFor(RequestSettings.Focus kind) {
        FocusHold other = new FocusHold(kind);
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
    void aDeviceThatReportsNothingIsGivenUp() {
        focus.scanAsked();
        focus.scanBegun(1);
        assertFalse(focus.report(2, null));
        assertTrue(focus.giveUp());
        assertTrue(focus.isStill());
        assertFalse(focus.giveUp());
    }
}
