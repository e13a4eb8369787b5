package org.cellgauge.android.state;

import org.cellgauge.android.device.ThermalLevel;
import org.cellgauge.live.LivePace;

/** What the check gives up where the device gets warm. No figure depends on it, only when it comes. */
final class ThermalPace {
    private ThermalPace() {
    }

    /** How much work the check may do. */
    static LivePace of(ThermalLevel level) {
        switch (level) {
            case NORMAL:
                return LivePace.FULL;
            case WARM:
                return LivePace.REDUCED;
            default:
                return LivePace.QUICK_LOOK_ONLY;
        }
    }

    /** Whether the camera may run. */
    static boolean allowsCamera(ThermalLevel level) {
        return level != ThermalLevel.CRITICAL;
    }
}
