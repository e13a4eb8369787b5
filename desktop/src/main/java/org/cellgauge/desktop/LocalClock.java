package org.cellgauge.desktop;

import java.time.Clock;
import java.time.ZoneOffset;
import java.util.TimeZone;
import java.util.concurrent.TimeUnit;

/**
 * The time of the machine's zone, for the present: by the zone's offset of now, for which Java need not load the rules
 * of all zones, as it does for a {@link java.time.ZoneId}.
 */
public final class LocalClock {
    private LocalClock() {
    }

    /**
     * A clock that is right until the zone's offset changes.
     *
     * @return a new clock
     */
    public static Clock now() {
        long offsetMs = TimeZone.getDefault().getOffset(System.currentTimeMillis());
        return Clock.system(ZoneOffset.ofTotalSeconds((int) TimeUnit.MILLISECONDS.toSeconds(offsetMs)));
    }
}
