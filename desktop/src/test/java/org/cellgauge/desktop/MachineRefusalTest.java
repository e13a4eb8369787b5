package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.concurrent.CompletionException;
import org.junit.jupiter.api.Test;

class MachineRefusalTest {
    @Test
    void limitsAreFoundBehindTheErrorsOfLibraries() {
        assertEquals(MachineRefusal.MEMORY,
                MachineRefusal.behind(new CompletionException(new OutOfMemoryError("heap"))).get().kind());
        assertEquals(MachineRefusal.OPEN_FILES, MachineRefusal.behind(new ExceptionInInitializerError(
                new IOException("Too many open files"))).get().kind());
        assertTrue(MachineRefusal.behind(new IllegalStateException("a fault of ours")).isEmpty());
    }
}
