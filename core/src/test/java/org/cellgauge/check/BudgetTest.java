package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.VarianceBudget;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.settings.ObjectNoise;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where the variance is said to come from. */
class BudgetTest {
    private static CellEstimate quickLook(ThesisScene scene) {
        return CellCheck.stream(scene.cell(), scene.exactDetections(), CheckSettings.builder().build()).blockingFirst()
                .estimate();
    }

    private static double variance(VarianceBudget budget, VarianceSource source, double std, int axis) {
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
            double expected = variance(predicted.budget(), VarianceSource.ofKey(source),
                    predicted.pose().std()[axis], axis);
            // a variance of 1500 is good to 3.7 %; what is not linear adds little at such sizes
            assertEquals(1, squares[axis] / expected, 4 * 0.037 + 0.02, source + " axis " + axis);
        }
    }

    /** Deviations along x, y, z of object 20 and of its gripping point with some sources next to zero. */
    private static double[][] deviations(int exactReference, double pixelStd, boolean objectNoise) {
        ThesisScene scene = ThesisScene.oneRaised(4).placement(5, 0.01).pixelStd(pixelStd).grip(20, 10, 20, 100);
        if (exactReference > 0) {
            scene.placementOf(exactReference, 1e-5, 1e-8);
        }
        ObjectEstimate object = CellCheck.stream(scene.cell(), scene.exactDetections(), CheckSettings.builder()
                .objectNoise(objectNoise ? ObjectNoise.DETECTION : ObjectNoise.NONE).build())
                .blockingFirst().estimate().object(20);
        return new double[][] {java.util.Arrays.copyOf(object.pose().std(), 3), object.grip().stdMm()};
    }

    /** What is gained is what another fit has, of a cell file that states the source as next to zero. */
    @Test
    void gainIsWhatARefitWithoutTheSourceTakesOff() {
        ThesisScene scene = ThesisScene.oneRaised(4).placement(5, 0.01).pixelStd(0.3).grip(20, 10, 20, 100);
        ObjectEstimate object = CellCheck.stream(scene.cell(), scene.exactDetections(),
                CheckSettings.builder().build()).blockingFirst().estimate().object(20);
        double[][] with = deviations(0, 0.3, true);
        double largest = 0;
        for (int reference : new int[] {944, 1234, 911, 22}) {
            double[][] left = deviations(reference, 0.3, true);
            for (int axis = 0; axis < 3; axis++) {
                VarianceSource source = VarianceSource.placementOf(reference);
                assertEquals(1 - left[0][axis] / with[0][axis], object.budget().gains(axis).get(source), 1e-4);
                assertEquals(1 - left[1][axis] / with[1][axis], object.gripBudget().gains(axis).get(source), 1e-4);
                largest = Math.max(largest, object.budget().gains(axis).get(source));
            }
        }
        assertTrue(largest > 0.1, "some reference must be worth placing: " + largest);
        double[][] noObjectNoise = deviations(0, 0.3, false);
        for (int axis = 0; axis < 3; axis++) {
            assertEquals(1 - noObjectNoise[0][axis] / with[0][axis],
                    object.budget().gains(axis).get(VarianceSource.CORNER_NOISE_OF_OBJECT), 1e-9);
        }
        double all = 0;
        double left = 0;
        double[][] exactCorners = deviations(0, 1e-4, true);
        double[][] ownNoise = deviations(0, 1e-4, false);
        for (int axis = 0; axis < 3; axis++) {
            // corners of references without noise, those of the object as before
            double own = Math.pow(with[0][axis], 2) - Math.pow(noObjectNoise[0][axis], 2);
            all += Math.pow(with[0][axis], 2);
            left += Math.pow(ownNoise[0][axis], 2) + own;
            assertTrue(exactCorners[0][axis] >= ownNoise[0][axis]);
        }
        assertEquals(1 - Math.sqrt(left / all), object.budget().gains().get(VarianceSource.CORNER_NOISE_OF_REFERENCES),
                1e-3);
    }

    @Test
    void sharesAddToOneOnEveryAxisAndInAll() {
        ThesisScene scene = ThesisScene.oneRaised(4).placement(5, 0.01).pixelStd(0.3).grip(20, 10, 20, 100);
        for (Estimate estimate : Estimate.values()) {
            CellEstimate found = CellCheck.stream(scene.cell(), scene.exactDetections(),
                    CheckSettings.builder().estimate(estimate).build()).blockingFirst().estimate();
            for (ObjectEstimate object : found.objects()) {
                List<Map<VarianceSource, Double>> budgets = new ArrayList<>();
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
                for (Map<VarianceSource, Double> shares : budgets) {
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
