package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Clock;
import java.time.Instant;
import java.time.ZoneId;
import java.time.ZonedDateTime;
import java.util.TimeZone;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The zone is one setting of the whole process, so this test runs by itself. */
@Isolated
class LocalClockTest {
    private final TimeZone before = TimeZone.getDefault();

    @AfterEach
    void restore() {
        TimeZone.setDefault(before);
    }

    /** Of both halves of the globe, so that one of them has summer time whenever this runs. */
    @ParameterizedTest
    @ValueSource(strings = {"Europe/Berlin", "Australia/Adelaide", "America/St_Johns", "Asia/Kathmandu", "UTC"})
    void tellsTheZonesTime(String zone) {
        TimeZone.setDefault(TimeZone.getTimeZone(zone));

        Clock clock = LocalClock.now();

        Instant now = Instant.now();
        assertEquals(ZonedDateTime.ofInstant(now, ZoneId.of(zone)).getOffset(),
                clock.getZone().getRules().getOffset(now));
    }
}
