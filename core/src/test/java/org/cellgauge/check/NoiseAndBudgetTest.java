package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.sampling.RandomStreams;
import org.cellgauge.statistics.RankHistogram;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Corner noise that is estimated, and where the variance is said to come from. */
class NoiseAndBudgetTest {
    private static Cell withEstimatedNoise(Cell cell) {
        return new Cell(cell.camera(), cell.family(), cell.references(), cell.objects(), OptionalDouble.empty(),
                cell.targetStdMm());
    }

    /**
     * Seven markers have 8 coordinates and 6 unknowns each, so 14 degrees of freedom; large placement errors and a mode that
     * may be the mirrored one must not count as noise.
     */
    @Test
    void estimatedCornerNoiseHasTwoDegreesOfFreedomPerMarker() {
        ThesisScene scene = ThesisScene.inPlane(4).placement(20, 0.05).pixelStd(0.3);
        Cell cell = withEstimatedNoise(scene.cell());
        RandomGenerator random = RandomStreams.of(51);
        ChiSquaredDistribution chiSquare = new ChiSquaredDistribution(null, 14);
        RankHistogram ranks = new RankHistogram(99, 10);
        double sum = 0;
        int cells = 400;
        for (int c = 0; c < cells; c++) {
            CheckResult result = CellCheck.run(cell, scene.detections(0.3, random, 20, 0.05),
                    CheckSettings.builder().iterations(20).warmup(10).chains(1).build());
            double squares = 14 * result.pixelStdPx() * result.pixelStdPx() / (0.3 * 0.3);
            sum += squares;
            ranks.add((int) (100 * chiSquare.cumulativeProbability(squares)));
            assertTrue(result.warnings().stream().anyMatch(w -> w.matches("pixel_std_px is estimated as 0\\.\\d+ px from 14 "
                    + "degrees of freedom, good to about 19 %")), result.warnings().toString());
        }
        assertEquals(14, sum / cells, 4 * Math.sqrt(28.0 / cells));
        assertTrue(ranks.pValue() > 0.001, "p " + ranks.pValue());
    }

    private static CellEstimate quickLook(ThesisScene scene) {
        return CellCheck.stream(scene.cell(), scene.exactDetections(), CheckSettings.builder().build()).blockingFirst()
                .estimate();
    }

    private static double variance(VarianceBudget budget, String source, double std, int axis) {
        return budget.shares(axis).get(source) * std * std;
    }

    /**
     * Sources are independent: with one source made ever smaller the variance falls by what the budget gave to it, the
     * weights of the fit kept. Here against errors drawn one source at a time, which no part of the budget's code makes.
     */
    @ParameterizedTest
    @CsvSource({"placement of reference 22", "corner noise of references", "corner noise of object"})
    void shareOfASourceIsTheVarianceThatItAloneMakes(String source) {
        ThesisScene scene = ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.05);
        ObjectEstimate predicted = quickLook(scene).object(20);
        double[] truth = predicted.pose().mean();
        RandomGenerator random = RandomStreams.of(52);
        int cells = 1500;
        double[] squares = new double[3];
        for (int c = 0; c < cells; c++) {
            ThesisScene one = ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.05);
            double[] found = CellCheck.stream(one.cell(), one.detectionsOf(source, 0.05, 1, 0.003, random),
                    CheckSettings.builder().build()).blockingFirst().estimate().object(20).pose().mean();
            for (int i = 0; i < 3; i++) {
                squares[i] += (found[i] - truth[i]) * (found[i] - truth[i]) / cells;
            }
        }
        for (int axis = 0; axis < 3; axis++) {
            double expected = variance(predicted.budget(), source, predicted.pose().std()[axis], axis);
            // a variance of 1500 is good to 3.7 %; what is not linear adds little at such sizes
            assertEquals(1, squares[axis] / expected, 4 * 0.037 + 0.02, source + " axis " + axis);
        }
    }

    @Test
    void sharesAddToOneOnEveryAxisAndInAll() {
        ThesisScene scene = ThesisScene.oneRaised(4).placement(5, 0.01).pixelStd(0.3).grip(20, 10, 20, 100);
        for (CheckSettings.Estimate estimate : CheckSettings.Estimate.values()) {
            CellEstimate found = CellCheck.stream(scene.cell(), scene.exactDetections(),
                    CheckSettings.builder().estimate(estimate).build()).blockingFirst().estimate();
            for (ObjectEstimate object : found.objects()) {
                List<Map<String, Double>> budgets = new ArrayList<>();
                List<VarianceBudget> all = new ArrayList<>();
                all.add(object.budget());
                if (object.gripBudget() != null) {
                    all.add(object.gripBudget());
                }
                for (VarianceBudget budget : all) {
                    budgets.add(budget.shares());
                    for (int axis = 0; axis < 3; axis++) {
                        budgets.add(budget.shares(axis));
                    }
                }
                for (Map<String, Double> shares : budgets) {
                    double sum = 0;
                    for (double share : shares.values()) {
                        assertTrue(share >= 0, shares.toString());
                        sum += share;
                    }
                    assertEquals(1, sum, 1e-12);
                }
            }
        }
    }

    /** What dominates is made to: a coarse reference, coarse corners of references far off, a small object. */
    @ParameterizedTest
    @CsvSource({"placement, the placement of reference 22", "objects, noise in the object's own corners"})
    void reasonNamesTheLargestSourceWithItsShare(String what, String words) {
        ThesisScene scene = what.equals("placement")
                ? ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.01).placementOf(22, 40, 0.003)
                : ThesisScene.inPlane(6).placement(0.01, 0.0001).pixelStd(0.3);
        CheckResult result = CellCheck.run(scene.cell(), scene.exactDetections(), CheckSettings.builder().build());
        ObjectEstimate worst = null;
        int axis = 0;
        for (ObjectEstimate object : result.estimate().objects()) {
            for (int i = 0; i < 3; i++) {
                if (worst == null || object.pose().std()[i] > worst.pose().std()[axis]) {
                    worst = object;
                    axis = i;
                }
            }
        }
        double largest = worst.budget().shares(axis).values().stream().mapToDouble(Double::doubleValue).max().getAsDouble();
        assertTrue(result.reason().contains(String.format(Locale.ROOT, "%.2f mm in %s of object %d",
                worst.pose().std()[axis], "xyz".charAt(axis), worst.id())), result.reason());
        assertTrue(result.reason().contains(String.format(Locale.ROOT, "; %.0f %% of this variance comes from %s.",
                100 * largest, words)), result.reason());
    }
}
