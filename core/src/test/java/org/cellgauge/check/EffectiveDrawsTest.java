package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.settings.ObjectNoise;
import org.cellgauge.settings.SamplerKind;
import org.cellgauge.statistics.ChainDiagnostics;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Effective draws of the samplers per thousand evaluations: the least of all object coordinates, of squared deviations,
 * three references in the plane, exact corners, the camera's part alone. docs/performance.md has the whole table.
 */
class EffectiveDrawsTest {
    private static final int STEPS = 10_000;

    private static CheckResult run(LikelihoodModel model, double stdMm, SamplerKind sampler, int steps, long seed) {
        ThesisScene scene = ThesisScene.inPlane(3).placement(stdMm, 0.01);
        CheckSettings.Builder settings = CheckSettings.builder().likelihood(model).kappa(0.5).sampler(sampler)
                .seed(seed).objectNoise(ObjectNoise.NONE);
        int warmup = settings.iterations(steps).build().sampling().warmup();
        CheckResult result = CellCheck.run(scene.cell(), scene.exactDetections(),
                settings.iterations(steps + warmup).warmup(warmup).build());
        assertEquals(sampler, result.samplerUsed());
        return result;
    }

    private static double least(CheckResult result) {
        double least = Double.POSITIVE_INFINITY;
        for (int id : new int[] {5, 20, 30}) {
            for (Quantity.Axis axis : List.of(Quantity.Axis.X, Quantity.Axis.Y, Quantity.Axis.Z)) {
                ChainDiagnostics d = result.diagnostics().of(Quantity.object(id, axis));
                least = Math.min(least, d.essSquaredDeviation());
            }
        }
        return least;
    }

    private static double perThousandSteps(CheckResult result) {
        return 1000 * least(result) / (result.draws().size() * (double) result.draws().get(0).count());
    }

    /**
     * 576 per thousand are expected for rigid-marker (an independent implementation: 578 to 597). From 40 000 draws
     * with a window of 10 lags the estimate is good to sqrt(2 * 21 / 40 000) = 3 % (Sokal 1997, section 3), so that 500
     * is four such errors below.
     */
    @ParameterizedTest
    @CsvSource({"1", "2", "3"})
    void independenceGivesFiveHundredPerThousandStepsWithRigidMarker(long seed) {
        double found = perThousandSteps(run(LikelihoodModel.RIGID_MARKER, 5, SamplerKind.INDEPENDENCE, STEPS, seed));
        assertTrue(found >= 500, found + " per 1000 steps");
        assertTrue(found <= 700, found + " per 1000 steps: more than a t with 5 degrees of freedom can give");
    }

    /**
     * An independent implementation has 18 to 70. The tails decide here: every seed must hold, no median. Of 56 seeds
     * at 5 mm two have less than 30, since a walk may miss a tail; half have more than 340.
     */
    @ParameterizedTest
    @CsvSource({"5, 1", "5, 2", "5, 3", "5, 7", "20, 1", "20, 2", "20, 3", "20, 4"})
    void independenceGivesThirtyPerThousandStepsWithCornerCube(double stdMm, long seed) {
        CheckResult result = run(LikelihoodModel.CORNER_CUBE, stdMm, SamplerKind.INDEPENDENCE, STEPS, seed);
        double found = perThousandSteps(result);
        assertTrue(found >= 30, found + " per 1000 steps");
        // and with the evaluations that fitted the proposal and warmed up counted
        double evaluations = result.tuningEvaluations() + 4.0 * result.iterationsPerChain();
        assertTrue(1000 * least(result) / evaluations >= 5,
                1000 * least(result) / evaluations + " per 1000 evaluations");
    }

    /**
     * An independent implementation has 26 and 75. The windows of some 100 lags alone make an estimate good to 7 %, but
     * where a chain of corner-cube stays in a tail for long one run may have half of that: the median of five seeds.
     * With corner-cube at 20 mm it has 29 and this one 12 to 23: not claimed here, and told in docs/performance.md.
     */
    @ParameterizedTest
    @CsvSource({"CORNER_CUBE, 5, 26", "RIGID_MARKER, 5, 75"})
    void adaptiveMetropolisGivesAsManyAsTheIndependentImplementation(LikelihoodModel model, double stdMm,
            double expected) {
        double[] found = new double[5];
        for (int seed = 1; seed <= found.length; seed++) {
            found[seed - 1] = perThousandSteps(run(model, stdMm, SamplerKind.ADAPTIVE, STEPS, seed));
        }
        Arrays.sort(found);
        assertTrue(found[2] > expected / 2 && found[2] < 2 * expected, Arrays.toString(found) + " per 1000 steps");
    }

    /**
     * That implementation has 0.01 to 0.9. So few effective draws are hard to count (a chain that has not converged
     * seems to have one or two for every half of it, 0.2 per thousand here, and more where it is short): next to
     * nothing it is.
     */
    @ParameterizedTest
    @CsvSource({"CORNER_CUBE, 5", "CORNER_CUBE, 20", "RIGID_MARKER, 5"})
    void theThesisMixtureGivesNextToNothing(LikelihoodModel model, double stdMm) {
        CheckResult result = run(model, stdMm, SamplerKind.THESIS_MIXTURE, STEPS, 1);
        assertEquals(Verdict.NOT_CONVERGED, result.verdict());
        double found = perThousandSteps(result);
        // NaN: some chain never moved
        assertTrue(!(found > 10), found + " per 1000 steps");
    }
}
