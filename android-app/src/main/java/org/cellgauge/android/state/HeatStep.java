package org.cellgauge.android.state;

import org.cellgauge.live.LivePace;

/** How warm the device is, and what the check gives up for it. */
public enum HeatStep {
    /** Nothing is given up. */
    NORMAL(LivePace.FULL),
    /** Fewer frames and one thread: figures come later. */
    WARM(LivePace.REDUCED),
    /** No chains: every figure stays preliminary. */
    HOT(LivePace.QUICK_LOOK_ONLY),
    /** The camera is off until the device has cooled down. */
    CRITICAL(LivePace.QUICK_LOOK_ONLY);

    private final LivePace pace;

    HeatStep(LivePace pace) {
        this.pace = pace;
    }

    /**
     * How much work the check may do.
     *
     * @return core's pace
     */
    public LivePace pace() {
        return pace;
    }

    /**
     * Whether the camera may run.
     *
     * @return false for {@link #CRITICAL}
     */
    public boolean cameraAllowed() {
        return this != CRITICAL;
    }
}
