package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;

import org.junit.jupiter.api.Test;

class EarlyStartTest {
    /** In its own thread nobody would see that it came to an end before its time. */
    @Test
    void comesToItsEnd() {
        assertDoesNotThrow(() -> EarlyStart.load(true, true));
    }
}
