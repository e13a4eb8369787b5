package org.cellgauge.fuzz;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A short run over every reader and whole checks; the long one is a command (docs/robustness.md). */
class FuzzTest {
    private static final Path ROOT = Path.of(System.getProperty("cellgauge.root", "."));

    @ParameterizedTest
    @CsvSource({"CELL, 300", "CAMERA, 300", "TARGET, 300", "DETECTIONS, 300", "IMAGE, 200", "RESULT, 15",
        "SURVEY, 300", "CHECK, 2"})
    void nothingButRefusals(Target target, int count) throws IOException {
        Fuzz fuzz = new Fuzz(target, 1, ROOT);
        assertArrayEquals(fuzz.input(3), fuzz.input(3), "not reproducible");
        for (int i = 0; i < count; i++) {
            fuzz.tryOne(i);
        }
        assertEquals(List.of(), fuzz.faults());
    }
}
