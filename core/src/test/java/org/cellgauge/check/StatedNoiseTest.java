package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.estimate.VarianceBudget;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.settings.SamplerKind;
import org.junit.jupiter.api.Test;

/**
 * A corner noise stated as a number goes a way of its own, quicker than that of covariances. Prints bent by a millionth
 * of a millimetre send the same corners the other way: figures have to be the same, chains included. One that accepts a
 * single step otherwise is off by far more than the bound.
 */
class StatedNoiseTest {
    private static final double NEXT_TO_FLAT_MM = 1e-6;

    private static double[] figures(ThesisScene scene, CheckSettings.Builder settings, long seed, double flatnessMm) {
        Cell cell = scene.cell();
        Cell bent = new Cell(cell.camera(), cell.family(), cell.references(), cell.objects(), OptionalDouble.of(0.3),
                cell.targetStdMm(), new PrintPrecision(0, flatnessMm, 0));
        CheckResult result = CellCheck.run(bent, scene.detections(0.3, RandomStreams.of(seed), 1, 0.003),
                settings.iterations(400).seed(seed).build());
        double[] quick = result.quickLook().object(20).pose().std();
        double[] camera = result.estimate().camera().mean();
        double[] object = result.estimate().object(20).pose().std();
        VarianceBudget budget = result.quickLook().object(20).budget();
        return new double[] {quick[0], quick[2], camera[0], camera[4], object[1], object[2],
            budget.shares().get(VarianceSource.CORNER_NOISE_OF_OBJECT),
            budget.gains().get(VarianceSource.CORNER_NOISE_OF_OBJECT),
            budget.gains().get(VarianceSource.CORNER_NOISE_OF_REFERENCES),
            budget.gains().get(VarianceSource.placementOf(22)),
            result.referenceCheck().fits().get(1).chiSquare(), result.pixelStdPx()};
    }

    private static void require(ThesisScene scene, CheckSettings.Builder settings, long seed) {
        double[] stated = figures(scene, settings, seed, 0);
        double[] byCovariances = figures(scene, settings, seed, NEXT_TO_FLAT_MM);
        for (int i = 0; i < stated.length; i++) {
            assertEquals(stated[i], byCovariances[i], 1e-6 * Math.abs(stated[i]), "figure " + i);
        }
    }

    @Test
    void bothWaysLeadToTheSameFigures() {
        require(ThesisScene.inPlane(4).placement(1, 0.003), CheckSettings.builder(), 1);
        require(ThesisScene.oneRaised(3).placement(1, 0.003),
                CheckSettings.builder().estimate(Estimate.FOCAL), 2);
        require(ThesisScene.oneRaised(4).placement(1, 0.003).grip(20, 0, 0, 100),
                CheckSettings.builder().sampler(SamplerKind.ADAPTIVE), 3);
    }
}
