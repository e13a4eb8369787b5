package org.cellgauge.android.files;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.Map;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Targets that outlive a process. */
class TargetTextTest {
    @Test
    void aTargetComesBackToTheLastBit() {
        Target target = new Target(new Requirement(new Requirement.Axes(0.1, 1 / 3.0, Double.POSITIVE_INFINITY),
                new Requirement.Axes(1, 2, 3), 4.7, 1e-3, 0.99),
                Map.of(5, Requirement.NONE, 20, Requirement.ofStdMm(2)));
        assertEquals(target, TargetText.read(TargetText.of(target)));
        assertEquals(Target.NONE, TargetText.read(TargetText.of(Target.NONE)));
        assertNull(TargetText.read(null));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "1", "1 1 1 1 1 1 1 1 x", "1 1 1 1 1 1 1 1 0.9;", "1 1 1 1 1 1 1 1 0.9;5 1",
        "-1 1 1 1 1 1 1 1 0.9", "1 1 1 1 1 1 1 1 0.9;five 1 1 1 1 1 1 1 1 0.9"})
    void whatAnotherVersionLeftIsNoTarget(String text) {
        assertNull(TargetText.read(text));
    }
}
