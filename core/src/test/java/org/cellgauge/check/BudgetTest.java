package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.sampling.RandomStreams;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where the variance is said to come from. */
class BudgetTest {
    private static CellEstimate quickLook(ThesisScene scene) {
        return CellCheck.stream(scene.cell(), scene.exactDetections(), CheckSettings.builder().build()).blockingFirst()
                .estimate();
    }

    private static double variance(VarianceBudget budget, String source, double std, int axis) {
        return budget.shares(axis).get(source) * std * std;
    }

    /**
     * Sources are independent: with one source made ever smaller the variance falls by what the budget gave to it, the
     * weights of the fit kept. Here against errors drawn one source at a time, which no part of the budget's code
     * makes.
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
}
