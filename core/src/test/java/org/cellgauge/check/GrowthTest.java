package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.cellgauge.Allocated;
import org.cellgauge.output.ResultView;
import org.cellgauge.settings.CheckSettings;
import org.junit.jupiter.api.Test;

/** What a check allocates grows no faster than the markers of the cell; times are for {@code GrowthBenchmark}. */
class GrowthTest {
    private static final int ROUNDS = 3;

    /** One table of four times as many references by as many takes sixteen times the memory. */
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

    /** Each budget names every reference, so that budgets are left to a cell of few. */
    @Test
    void estimatesAndViewsOfObjectsAllocateInProportionToThem() {
        CheckSettings settings = CheckSettings.builder().threads(1).iterations(300).warmup(100).build();
        double few = bytesOfResults(GridScene.of(4, 10), settings);
        double many = bytesOfResults(GridScene.of(4, 80), settings);
        assertTrue(many < 8.8 * few, "10 objects: " + few + " bytes, 80: " + many);
    }

    private static double bytesOfResults(GridScene scene, CheckSettings settings) {
        // the thread that asks steps no chains: what it allocates are fits, estimates, tests and views
        return Allocated.leastBytes(ROUNDS,
                () -> ResultView.of(CellCheck.run(scene.cell, scene.detections, settings)));
    }
}
