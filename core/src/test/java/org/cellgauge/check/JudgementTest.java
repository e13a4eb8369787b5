package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.junit.jupiter.api.Test;

/** Another target judges the figures there are as a check with that target from the start would have. */
class JudgementTest {
    private static final ThesisScene SCENE = ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.05)
            .grip(20, 0, 0, 100).target(3);
    private static final Detections PHOTO = SCENE.detections(0.05, RandomStreams.of(2), 1, 0.003);
    private static final CheckSettings SETTINGS = CheckSettings.builder().iterations(1500).build();

    private static CheckResult run(Cell cell, Detections detections) {
        return CellCheck.run(cell, detections, SETTINGS);
    }

    @Test
    void anotherTargetGivesTheVerdictAndReasonOfACheckWithIt() {
        CheckResult once = run(SCENE.cell(), PHOTO);
        for (OptionalDouble target : new OptionalDouble[] {OptionalDouble.of(0.1), OptionalDouble.of(2),
            OptionalDouble.of(50), OptionalDouble.empty()}) {
            CheckResult judged = once.withTarget(target);
            CheckResult fromTheStart = run(SCENE.cell().withTarget(target), PHOTO);
            assertEquals(fromTheStart.verdict(), judged.verdict());
            assertEquals(fromTheStart.reason(), judged.reason());
            assertEquals(target, judged.cell().targetStdMm());
            assertSame(once.draws(), judged.draws(), "nothing is sampled again");
            assertArrayEquals(fromTheStart.draws().get(0).series(0), judged.draws().get(0).series(0));
            for (int id : SCENE.objects().keySet()) {
                assertEquals(fromTheStart.verdict(id), judged.verdict(id));
                assertEquals(fromTheStart.finding(id).english(), judged.finding(id).english());
            }
        }
        assertEquals(Verdict.FAIL, once.withTarget(OptionalDouble.of(0.1)).verdict());
        assertEquals(Verdict.PASS, once.withTarget(OptionalDouble.of(50)).verdict());
        assertEquals(Verdict.NO_TARGET, once.withTarget(OptionalDouble.empty()).verdict());
    }

    @Test
    void sameTargetIsTheSameResult() {
        CheckResult once = run(SCENE.cell(), PHOTO);
        assertSame(once, once.withTarget(OptionalDouble.of(3)));
        assertThrows(IllegalArgumentException.class, () -> once.withTarget(OptionalDouble.of(0)));
    }

    @Test
    void wholePassesWhereEveryObjectDoesAndReasonsNameTheirOwnObject() {
        CheckResult once = run(SCENE.cell(), PHOTO);
        List<Double> worst = new ArrayList<>();
        once.estimate().objects().forEach(o -> worst.add(o.worstStdMm()));
        for (ObjectEstimate object : once.estimate().objects()) {
            double own = object.worstStdMm();
            CheckResult nearby = once.withTarget(OptionalDouble.of(own));
            assertEquals(Verdict.FAIL, nearby.verdict(object.id()));
            assertFalse(nearby.decided(object.id()), "the target is the deviation itself");
            CheckResult above = once.withTarget(OptionalDouble.of(1.2 * own));
            assertEquals(Verdict.PASS, above.verdict(object.id()));
            assertTrue(above.decided(object.id()));
            CheckResult below = once.withTarget(OptionalDouble.of(0.8 * own));
            assertEquals(Verdict.FAIL, below.verdict(object.id()));
            assertTrue(below.decided(object.id()));
            Reason reason = once.finding(object.id());
            assertEquals(object.id(), reason.objectId().getAsInt());
            assertEquals(own, reason.stdMm().getAsDouble());
            Reason untargeted = once.estimate().largestDeviation(object.id());
            assertEquals(own, untargeted.stdMm().getAsDouble());
            assertFalse(untargeted.targetMm().isPresent());
        }
        double largest = worst.stream().mapToDouble(Double::doubleValue).max().getAsDouble();
        assertEquals(Verdict.PASS, once.withTarget(OptionalDouble.of(1.2 * largest)).verdict());
        assertEquals(Verdict.FAIL, once.withTarget(OptionalDouble.of(largest * (1 - 1e-9))).verdict());
    }

    /** JCGM 106:2012, 8.3: a guard band of two errors on either side of the target. */
    @Test
    void targetIsMetOrMissedByTwoMonteCarloErrors() {
        CheckResult once = run(SCENE.cell(), PHOTO);
        double reach = 0;
        double beyond = 0;
        for (ObjectEstimate object : once.estimate().objects()) {
            for (var e : once.diagnostics().parameters().entrySet()) {
                Quantity q = e.getKey();
                var d = e.getValue();
                if (q.id().equals(OptionalInt.of(object.id())) && q.unit() == Quantity.Unit.MM) {
                    reach = Math.max(reach, d.std() + 2 * d.mcseSd());
                    beyond = Math.max(beyond, d.std() - 2 * d.mcseSd());
                }
            }
        }
        assertTrue(beyond < reach);
        assertEquals(Verdict.PASS, once.withTarget(OptionalDouble.of(reach * (1 + 1e-9))).verdict());
        for (double target : new double[] {reach * (1 - 1e-9), beyond * (1 + 1e-9)}) {
            CheckResult undecided = once.withTarget(OptionalDouble.of(target));
            assertEquals(Verdict.FAIL, undecided.verdict());
            assertFalse(undecided.decided());
            assertTrue(undecided.reason().contains("Undecided: the target lies within twice the Monte Carlo error"),
                    undecided.reason());
        }
        CheckResult missed = once.withTarget(OptionalDouble.of(beyond * (1 - 1e-9)));
        assertEquals(Verdict.FAIL, missed.verdict());
        assertTrue(missed.decided());
        assertFalse(missed.reason().contains("Undecided"), missed.reason());
    }

    @Test
    void chainsGoOnWhileTheTargetIsTooNearToDecide() {
        CheckSettings settings = CheckSettings.builder().maxIterations(16_000).build();
        CheckResult free = CellCheck.run(SCENE.cell().withTarget(OptionalDouble.of(50)), PHOTO, settings);
        double largest = free.estimate().objects().stream().mapToDouble(ObjectEstimate::worstStdMm).max().getAsDouble();
        assertTrue(free.decided());
        assertTrue(free.iterationsPerChain() < 16_000);
        CheckResult atTheTarget = CellCheck.run(SCENE.cell().withTarget(OptionalDouble.of(largest)), PHOTO, settings);
        assertTrue(atTheTarget.iterationsPerChain() > free.iterationsPerChain());
        assertTrue(atTheTarget.decided() || atTheTarget.iterationsPerChain() == 16_000);
    }

    @Test
    void objectThatIsNotSeenMissesItsTargetAndTheOthersDoNot() {
        List<MarkerObservation> without = new ArrayList<>(PHOTO.markers());
        without.removeIf(m -> m.id() == 20);
        CheckResult result = run(SCENE.cell(), new Detections("photo", 1280, 720, without)).withTarget(
                OptionalDouble.of(50));
        assertEquals(Verdict.FAIL, result.verdict());
        assertEquals(Verdict.FAIL, result.verdict(20));
        assertEquals(Reason.Kind.OBJECT_NOT_SEEN, result.finding(20).kind());
        assertEquals(List.of(20), result.finding(20).missingObjects());
        assertEquals(Verdict.PASS, result.verdict(5));
        assertNull(result.estimate().largestDeviation(20));
        assertFalse(result.estimate().isAmbiguous(20));
    }

    /** Of what does not count nothing is asked, and nothing is missed where it is not seen. */
    @Test
    void objectThatDoesNotCountMayBeOutOfView() {
        List<MarkerObservation> markers = new ArrayList<>(PHOTO.markers());
        markers.removeIf(m -> m.id() == 20);
        Cell cell = SCENE.cell();
        Target generous = Target.ofStdMm(OptionalDouble.of(100));
        CheckResult result = run(cell.withTarget(generous),
                new Detections(PHOTO.imageName(), PHOTO.widthPx(), PHOTO.heightPx(), markers));
        assertEquals(Verdict.FAIL, result.verdict());
        CheckResult without = result.withTarget(new Target(generous.general(), Map.of(20, Requirement.NONE)));
        assertEquals(Verdict.PASS, without.verdict());
        assertEquals(Verdict.NO_TARGET, without.verdict(20));
        assertEquals(Reason.Kind.LARGEST_DEVIATION, without.finding().kind());
        // another one that does count is missed all the same
        assertEquals(Verdict.FAIL,
                result.withTarget(new Target(generous.general(), Map.of(5, Requirement.NONE))).verdict());
    }

    @Test
    void chainsThatDidNotConvergeJudgeNothing() {
        CheckResult result = CellCheck.run(SCENE.cell(), PHOTO, CheckSettings.builder().iterations(260).build());
        assertEquals(Verdict.NOT_CONVERGED, result.verdict());
        assertEquals(Verdict.NOT_CONVERGED, result.withTarget(OptionalDouble.of(50)).verdict());
        assertEquals(Verdict.NOT_CONVERGED, result.verdict(5));
        assertEquals(Reason.Kind.NOT_CONVERGED, result.finding(5).kind());
    }

    @Test
    void ambiguousObjectIsSoFromTheQuickLookOn() {
        CheckResult result = run(ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(1).target(3).cell(),
                SCENE.exactDetections());
        assertEquals(Verdict.AMBIGUOUS, result.verdict());
        int ambiguous = 0;
        for (ObjectEstimate object : result.estimate().objects()) {
            assertEquals(result.estimate().isAmbiguous(object.id()),
                    result.verdict(object.id()) == Verdict.AMBIGUOUS);
            ambiguous += result.quickLook().isAmbiguous(object.id()) ? 1 : 0;
        }
        assertTrue(ambiguous > 0);
    }
}
