package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.IntStream;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Requirement.Axes;
import org.cellgauge.cell.Target;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.output.ResultView;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.Quantity.Axis;
import org.cellgauge.sampling.QuantityLayout;
import org.cellgauge.settings.CheckSettings;
import org.junit.jupiter.api.Test;

/** Targets that ask for a probability. */
class ConformityTest {
    private static final double INFINITE = Double.POSITIVE_INFINITY;
    private static final ThesisScene SCENE = ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.05)
            .grip(20, 0, 0, 100);
    private static final CheckSettings SETTINGS = CheckSettings.builder().targetMcseStdRel(0.05).build();

    /** Standard normal draws, each the last one's share of this and else new. */
    private static List<Draws> normal(QuantityLayout layout, int count, double share) {
        Random random = new Random(5);
        return IntStream.range(0, 4).mapToObj(c -> {
            Draws chain = new Draws(layout);
            double[] values = new double[layout.size()];
            for (int d = 0; d < count; d++) {
                for (int q = 0; q < values.length; q++) {
                    values[q] = share * values[q] + Math.sqrt(1 - share * share) * random.nextGaussian();
                }
                chain.add(values);
            }
            return chain;
        }).toList();
    }

    private static QuantityLayout layout() {
        QuantityLayout.Builder builder = new QuantityLayout.Builder();
        for (Axis axis : List.of(Axis.X, Axis.Y, Axis.Z, Axis.WX, Axis.WY, Axis.WZ)) {
            builder.add(Quantity.object(5, axis));
        }
        return builder.build();
    }

    /** The normal and the chi distribution with three degrees of freedom have 95 % within these. */
    @Test
    void probabilitiesAreThoseOfTheDistribution() {
        double ofOne = 1.959964;
        double ofThree = 2.795483;
        Requirement asked = new Requirement(Axes.NONE, new Axes(ofOne, 2 * ofOne, INFINITE), ofThree,
                Math.toDegrees(ofThree), 0.9);
        QuantityLayout layout = layout();
        List<Conformity> found = new Conformities(normal(layout, 5000, 0), layout, asked).ofPosition(5, null);
        assertEquals(List.of(Conformity.Of.X, Conformity.Of.Y, Conformity.Of.DISTANCE, Conformity.Of.TURN),
                found.stream().map(Conformity::of).toList());
        double error = Math.sqrt(0.95 * 0.05 / 20_000);
        for (int i : new int[] {0, 2, 3}) {
            assertEquals(0.95, found.get(i).probability(), 4 * error, found.toString());
            assertEquals(error, found.get(i).mcse(), 0.15 * error, found.toString());
            assertTrue(found.get(i).isKept() && found.get(i).isDecided());
        }
        assertEquals(0.99991, found.get(1).probability(), 3e-4);
    }

    @Test
    void drawsThatFollowEachOtherSayLess() {
        Requirement asked = new Requirement(Axes.NONE, Axes.all(1), INFINITE, INFINITE, 0.7);
        QuantityLayout layout = layout();
        double apart = new Conformities(normal(layout, 5000, 0), layout, asked).ofPosition(5, null).get(0).mcse();
        double slow = new Conformities(normal(layout, 5000, 0.9), layout, asked).ofPosition(5, null).get(0).mcse();
        assertTrue(slow > 2 * apart, slow + " and " + apart);
    }

    /** Whether references are right or not: with them wrong, the truth lies an error away. */
    @Test
    void errorsOfMisplacedReferencesCount() {
        Requirement asked = new Requirement(Axes.NONE, Axes.all(2), 2, INFINITE, 0.7);
        QuantityLayout layout = layout();
        Conformities count = new Conformities(normal(layout, 1000, 0), layout, asked);
        for (int i = 0; i < 4; i++) {
            double without = count.ofPosition(5, null).get(i).probability();
            assertEquals(without, count.ofPosition(5, new double[3]).get(i).probability());
            assertTrue(count.ofPosition(5, new double[] {1, 1, 1}).get(i).probability() < without - 0.2);
        }
    }

    private static CheckResult judged(CheckResult result, Requirement general, Map<Integer, Requirement> own) {
        return result.withTarget(new Target(general, own));
    }

    private static Requirement tolerance(Axes mm, double probability) {
        return new Requirement(Axes.NONE, mm, INFINITE, INFINITE, probability);
    }

    /** Draws near a normal distribution: 1.96 deviations hold 95 %; axes and objects are each asked for their own. */
    @Test
    void verdictsFollowTolerances() {
        CheckResult result = CellCheck.run(SCENE.cell(), SCENE.detections(0.05, RandomStreams.of(2), 1, 0.003),
                SETTINGS);
        double[] largest = new double[3];
        for (int id : SCENE.objects().keySet()) {
            for (int axis = 0; axis < 3; axis++) {
                largest[axis] = Math.max(largest[axis], result.estimate().object(id).pose().std()[axis]);
            }
        }
        double gripMm = result.estimate().object(20).grip().stdMm()[0];
        assertTrue(gripMm > 1.1 * largest[0], "its gripping point swings");
        Axes wide = new Axes(3 * gripMm, 3 * gripMm, 3 * Math.max(gripMm, largest[2]));
        CheckResult met = judged(result, tolerance(wide, 0.95), Map.of());
        assertEquals(Verdict.PASS, met.verdict(), met.reason());
        assertTrue(met.decided() && met.reason().contains("Least sure tolerance: "), met.reason());
        // a tolerance that the gripping point alone misses
        Axes narrow = new Axes(2.05 * largest[0], wide.y(), wide.z());
        CheckResult missed = judged(result, tolerance(narrow, 0.95), Map.of());
        assertEquals(Verdict.FAIL, missed.verdict(), missed.reason());
        assertTrue(missed.reason().contains("the gripping point of object 20 is within"), missed.reason());
        assertEquals(Verdict.PASS, missed.verdict(5));
        ResultView view = ResultView.of(missed);
        assertEquals(Verdict.PASS, view.object(20).verdict());
        assertEquals(Verdict.FAIL, view.grip(20).verdict());
        assertEquals(normalWithin(narrow.x() / gripMm), view.grip(20).conformities().get(0).probability(), 0.02);
        // the same, looser for this object
        CheckResult own = judged(result, tolerance(narrow, 0.95), Map.of(20, tolerance(wide, 0.95)));
        assertEquals(Verdict.PASS, own.verdict(), own.reason());
        // draws alone tell
        assertFalse(ResultView.of(result).canBeHeldAgainst(own.cell().target()));
        assertThrows(IllegalArgumentException.class,
                () -> ResultView.of(result).withTarget(own.cell().target()));
        assertEquals(ResultView.of(result.withTarget(OptionalDouble.of(2))),
                ResultView.of(own).withTarget(OptionalDouble.of(2)));
        // deviations asked for beside
        CheckResult both = judged(result, new Requirement(Axes.all(0.5 * largest[0]), wide, INFINITE, INFINITE, 0.95),
                Map.of());
        assertEquals(Verdict.FAIL, both.verdict());
        // a turn by no more than any draw has
        CheckResult turn = judged(result, new Requirement(Axes.NONE, Axes.NONE, INFINITE, 1e-6, 0.95), Map.of());
        assertEquals(Verdict.FAIL, turn.verdict());
        assertTrue(turn.reason().contains("turned by at most"), turn.reason());
    }

    /** Abramowitz and Stegun, equation 26.2.17 (error below 1e-7), of both sides. */
    private static double normalWithin(double z) {
        double t = 1 / (1 + 0.2316419 * z);
        double tail = Math.exp(-z * z / 2) / Math.sqrt(2 * Math.PI) * t * (0.319381530 + t * (-0.356563782
                + t * (1.781477937 + t * (-1.821255978 + t * 1.330274429))));
        return 1 - 2 * tail;
    }

    /** Where the probability asked for is that of the draws, chains go on, to the cap if need be. */
    @Test
    void chainsGoOnWhereATargetIsUndecided() {
        ThesisScene scene = ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.05).noObjects()
                .object(5, SCENE.objects().get(5));
        CheckSettings capped = SETTINGS.toBuilder().maxIterations(6000).build();
        CheckResult first = CellCheck.run(scene.cell(), scene.exactDetections(), capped);
        double std = first.estimate().object(5).pose().std()[2];
        CheckResult close = CellCheck.run(scene.cell().withTarget(new Target(tolerance(
                new Axes(INFINITE, INFINITE, 1.959964 * std), 0.95), Map.of())), scene.exactDetections(), capped);
        assertTrue(close.iterationsPerChain() > first.iterationsPerChain(), close.reason());
        CheckResult far = CellCheck.run(scene.cell().withTarget(new Target(tolerance(
                new Axes(INFINITE, INFINITE, 4 * std), 0.95), Map.of())), scene.exactDetections(), capped);
        assertEquals(first.iterationsPerChain(), far.iterationsPerChain());
        assertEquals(Verdict.PASS, far.verdict());
    }
}
