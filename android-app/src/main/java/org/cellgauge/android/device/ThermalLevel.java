package org.cellgauge.android.device;

import android.os.PowerManager;

/** How warm the device is, as far as an app should do less for it; the coolest first. */
public enum ThermalLevel {
    /** The device takes any load. */
    NORMAL,
    /** It throttles a little already; less work keeps it from more. */
    WARM,
    /** It throttles so that people notice; only what is needed should be done. */
    HOT,
    /** It is about to switch parts of itself off. */
    CRITICAL;

    /**
     * The level of a status.
     *
     * @param status one of the {@code PowerManager.THERMAL_STATUS} constants; a new and higher one counts as the worst
     * @return its level; light throttling, which by Android's definition nobody notices, counts as normal
     */
    static ThermalLevel of(int status) {
        if (status <= PowerManager.THERMAL_STATUS_LIGHT) {
            return NORMAL;
        }
        switch (status) {
            case PowerManager.THERMAL_STATUS_MODERATE:
                return WARM;
            case PowerManager.THERMAL_STATUS_SEVERE:
                return HOT;
            default:
                return CRITICAL;
        }
    }
}
