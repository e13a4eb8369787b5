package org.cellgauge.android.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.cellgauge.android.device.ThermalLevel;
import org.cellgauge.live.LivePace;
import org.junit.jupiter.api.Test;

class ThermalPaceTest {
    @Test
    void theWarmerTheDeviceTheLessIsDone() {
        assertEquals(LivePace.FULL, ThermalPace.of(ThermalLevel.NORMAL));
        assertEquals(LivePace.REDUCED, ThermalPace.of(ThermalLevel.WARM));
        assertEquals(LivePace.QUICK_LOOK_ONLY, ThermalPace.of(ThermalLevel.HOT));
        assertEquals(LivePace.QUICK_LOOK_ONLY, ThermalPace.of(ThermalLevel.CRITICAL));
        assertTrue(LivePace.REDUCED.minFrameIntervalMs() > LivePace.FULL.minFrameIntervalMs());
        assertTrue(LivePace.REDUCED.chainThreads() < LivePace.FULL.chainThreads());
        assertFalse(LivePace.QUICK_LOOK_ONLY.sampling());
    }

    @Test
    void theCameraRunsUntilTheDeviceIsAboutToSwitchPartsOff() {
        for (ThermalLevel level : ThermalLevel.values()) {
            assertEquals(level != ThermalLevel.CRITICAL, ThermalPace.allowsCamera(level), level.toString());
        }
    }
}
