package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.settings.CheckSettings;
import org.junit.jupiter.api.Test;

/** Chains go on for as long as the precision asked for needs, and no round doubles what is nearly enough. */
class RoundsTest {
    @Test
    void drawsWantedFollowTheSquareOfTheError() {
        assertEquals(2200, ChainRun.wantedFor(1000, Math.sqrt(2) * 0.02, 0.02), 1);
        assertEquals(1250, ChainRun.wantedFor(1000, 0.0201, 0.02));
        assertEquals(4000, ChainRun.wantedFor(1000, 0.1, 0.02));
        assertEquals(2000, ChainRun.wantedFor(1000, Double.NaN, 0.02));
        assertEquals(4000, ChainRun.wantedFor(1000, Double.POSITIVE_INFINITY, 0.02));
    }

    @Test
    void checkStopsWhereThePrecisionAskedForIsThere() {
        ThesisScene scene = ThesisScene.inPlane(4).placement(1, 0.002).pixelStd(0.1).noObjects();
        CheckResult result = CellCheck.run(scene.cell(), scene.detections(0.1, RandomStreams.of(3), 1, 0.002),
                CheckSettings.builder().threads(1).seed(1).targetMcseStdRel(0.01).warmup(200).build());
        assertTrue(result.diagnostics().converged());
        double error = result.diagnostics().mcseStdRelMax();
        // rounds of twice as many, 1000, 2000, 4000, would end at 4200 with 0.8 %
        assertTrue(error < 0.01 && error > 0.009, "error " + error);
        assertTrue(result.iterationsPerChain() < 3200, result.iterationsPerChain() + " iterations");
    }
}
