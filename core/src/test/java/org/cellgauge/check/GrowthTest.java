package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.cellgauge.Allocated;
import org.cellgauge.settings.CheckSettings;
import org.junit.jupiter.api.Test;

/** What a check allocates grows no faster than the markers of the cell; times are for {@code GrowthBenchmark}. */
class GrowthTest {
    private static final int ROUNDS = 3;

    /** A table of all tests by all would take sixteen times the memory for four times as many references. */
    @Test
    void testsOfReferencesAllocateInProportionToThem() {
        double few = bytesOfTests(GridScene.of(20, 0));
        double many = bytesOfTests(GridScene.of(80, 0));
        assertTrue(many < 4.4 * few, "20 references: " + few + " bytes, 80: " + many);
    }

    private static double bytesOfTests(GridScene scene) {
        QuickLook look = CellCheck.quickLook(scene.cell, scene.detections, CheckSettings.builder().build(), null);
        return Allocated.leastBytes(ROUNDS, look::referenceCheck);
    }

    /**
     * A budget names every reference: two variances of each, in a table of its own. Carrying a reference's errors to
     * every object took four times as much.
     */
    @Test
    void budgetsAllocateLittleMoreThanTheirNumbers() {
        int references = 60;
        int objects = 30;
        double none = bytesOfLook(GridScene.of(references, 0));
        double perPair = (bytesOfLook(GridScene.of(references, objects)) - none) / references / objects;
        assertTrue(perPair < 2500, perPair + " bytes for a reference of an object");
    }

    private static double bytesOfLook(GridScene scene) {
        CheckSettings settings = CheckSettings.builder().build();
        return Allocated.leastBytes(ROUNDS,
                () -> CellCheck.quickLook(scene.cell, scene.detections, settings, null));
    }
}
