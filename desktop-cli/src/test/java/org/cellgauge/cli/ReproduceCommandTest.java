package org.cellgauge.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ReproduceCommandTest {
    @TempDir
    Path folder;

    @Test
    void partsAreListed() {
        CommandCall call = CommandCall.of("reproduce", "--list");
        assertEquals(0, call.code(), call.err());
        assertTrue(call.out().contains("8.8             Table 8.8"), call.out());
        assertTrue(call.out().contains("figure-8.8"), call.out());
    }

    @Test
    void whatIsNoTableIsAFaultOfUsage() {
        CommandCall call = CommandCall.of("reproduce", "8.99", "--out", folder.resolve("new").toString());
        assertEquals(2, call.code());
        assertTrue(call.err().contains("'8.99' is no table"), call.err());
        assertTrue(Files.notExists(folder.resolve("new")));
    }

    @Test
    void tableGoesToStandardOutputAndProgressToStandardError() {
        CommandCall call = CommandCall.of("reproduce", "7.3", "--quick", "--threads", "1", "--out", folder.toString());
        assertEquals(0, call.code(), call.err());
        assertTrue(call.out().startsWith("### Table 7.3"), call.out());
        assertTrue(call.err().startsWith("[1/1] camera-3-focal ("), call.err());
        assertTrue(Files.notExists(folder.resolve("thesis.md")));
    }
}
