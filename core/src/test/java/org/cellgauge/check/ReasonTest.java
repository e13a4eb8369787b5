package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.cellgauge.cell.CameraCalibration;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.JointPlacement;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.PlacementGroup;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.light.ToneCurve;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.vision.PhotoLight;
import org.junit.jupiter.api.Test;

/** Each part of a reason is what the estimate says, and the sentence says each part. */
class ReasonTest {
    private static final CheckSettings SETTINGS = CheckSettings.builder().threads(1).build();

    private static ThesisScene fine() {
        return ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.05);
    }

    private static CheckResult run(ThesisScene scene) {
        return CellCheck.run(scene.cell(), scene.exactDetections(), SETTINGS);
    }

    private static Detections without(Detections seen, Integer... ids) {
        List<MarkerObservation> markers = new ArrayList<>(seen.markers());
        markers.removeIf(m -> List.of(ids).contains(m.id()));
        return new Detections(seen.imageName(), seen.widthPx(), seen.heightPx(), markers);
    }

    @Test
    void theLargestDeviationIsNamedWithItsPlaceItsTargetAndItsCause() {
        CheckResult result = run(fine().target(3));
        Reason reason = result.finding();
        assertEquals(Reason.Kind.LARGEST_DEVIATION, reason.kind());
        double largest = 0;
        for (ObjectEstimate object : result.estimate().objects()) {
            largest = Math.max(largest, object.worstStdMm());
        }
        assertEquals(largest, reason.stdMm().getAsDouble());
        ObjectEstimate object = result.estimate().object(reason.objectId().getAsInt());
        assertFalse(reason.grip());
        assertEquals(object.pose().std()[reason.axis().getAsInt()], largest);
        assertEquals(OptionalDouble.of(3), reason.targetMm());
        double share = object.budget().shares(reason.axis().getAsInt()).values().stream().mapToDouble(v -> v).max()
                .getAsDouble();
        assertEquals(share, reason.share().getAsDouble());
        assertEquals(String.format("Largest deviation: %.2f mm in %s of object %d against a target of 3 mm; %.0f %% of "
                + "this variance comes from noise in the object's own corners.", largest,
                "xyz".charAt(reason.axis().getAsInt()), object.id(), 100 * share), reason.english());
        assertEquals(VarianceSource.CORNER_NOISE_OF_OBJECT, reason.source());
        assertEquals(reason.english(), result.reason());
    }

    @Test
    void aGrippingPointAndAReferenceAreNamedWhereTheyAreTheCause() {
        // far from the references' precision: one of them is placed so badly that it decides
        CheckResult result = run(ThesisScene.oneRaised(3).placement(0.5, 0.001).placementOf(22, 20, 0.05)
                .pixelStd(0.003).grip(30, 0, 0, 400).target(0.25));
        Reason reason = result.finding();
        assertEquals(Reason.Kind.LARGEST_DEVIATION, reason.kind());
        assertTrue(reason.grip());
        assertEquals(OptionalInt.of(30), reason.objectId());
        assertEquals(result.estimate().object(30).grip().stdMm()[reason.axis().getAsInt()],
                reason.stdMm().getAsDouble());
        assertEquals(VarianceSource.Kind.PLACEMENT_OF_REFERENCE, reason.source().kind(), reason.english());
        assertTrue(reason.english().contains(" of the gripping point of object 30 against a target of 0.25 mm; "));
        assertTrue(reason.english().endsWith(
                "comes from the placement of reference " + reason.source().referenceId().getAsInt() + "."));
    }

    @Test
    void withoutATargetTheReasonSaysSo() {
        Reason reason = run(fine()).finding();
        assertEquals(Reason.Kind.LARGEST_DEVIATION, reason.kind());
        assertEquals(OptionalDouble.empty(), reason.targetMm());
        assertTrue(reason.english().startsWith("No target is set. Largest deviation: "), reason.english());
        assertFalse(reason.english().contains("against"));
    }

    @Test
    void anObjectThatIsNotSeenIsNamedBesideTheLargestDeviationOfTheOthers() {
        ThesisScene scene = fine().target(3);
        CheckResult result = CellCheck.run(scene.cell(), without(scene.exactDetections(), 5, 30), SETTINGS);
        Reason reason = result.finding();
        assertEquals(Reason.Kind.OBJECT_NOT_SEEN, reason.kind());
        assertEquals(List.of(5, 30), reason.missingObjects());
        assertEquals(OptionalInt.of(20), reason.objectId());
        assertTrue(reason.english().startsWith("Object 5 and 30 was not seen in the photo. Largest deviation: "),
                reason.english());
        CheckResult none = CellCheck.run(scene.cell(), without(scene.exactDetections(), 5, 20, 30), SETTINGS);
        assertEquals(Reason.Kind.OBJECT_NOT_SEEN, none.finding().kind());
        assertFalse(none.finding().stdMm().isPresent());
        assertNull(none.finding().source());
        assertEquals("Object 5, 20 and 30 was not seen in the photo. There is nothing to judge: no object is in the "
                + "photo.", none.reason());
    }

    @Test
    void aCellWithoutObjectsHasNoDeviation() {
        CheckResult result = run(fine().noObjects());
        assertEquals(Reason.Kind.NO_OBJECT, result.finding().kind());
        assertEquals("No target is set. There is nothing to judge: no object is in the photo.", result.reason());
        assertEquals("There is nothing to judge: no object is in the photo.",
                run(fine().noObjects().target(1)).reason());
    }

    @Test
    void chainsThatHaveNotConvergedAreDescribedByTheWorst() {
        // four chains of 100 draws, of which the tails hold far fewer than 400 effective ones
        Reason reason = reasonOfChains(CheckSettings.builder().iterations(200).warmup(100));
        assertEquals(Reason.Kind.NOT_CONVERGED, reason.kind());
        assertTrue(reason.rHat() > 0.9 && reason.effectiveDraws() < 400, reason.english());
        assertEquals(String.format(Locale.ROOT, "The chains have not converged (worst: %s, R-hat %.3f, effective draws "
                + "%.0f): no accuracy can be read off them.", reason.worstParameter(), reason.rHat(),
                reason.effectiveDraws()), reason.english());
        assertFalse(reason.stdMm().isPresent(), "no figure");
    }

    @Test
    void aChainThatNeverMovedIsCalledThat() {
        // of 20 draws, where the thesis' steps are accepted once in hundreds: whatever the seed
        Reason reason = reasonOfChains(CheckSettings.thesis().iterations(1020).warmup(1000));
        assertEquals(Reason.Kind.NEVER_MOVED, reason.kind());
        assertEquals("The chains have not converged (" + reason.worstParameter() + " never moved in at least one of "
                + "them): no accuracy can be read off them.", reason.english());
    }

    private static Reason reasonOfChains(CheckSettings.Builder settings) {
        ThesisScene scene = fine().target(3);
        CheckResult result = CellCheck.run(scene.cell(), scene.exactDetections(), settings.threads(1).build());
        assertEquals(Verdict.NOT_CONVERGED, result.verdict());
        assertEquals(result.diagnostics().worstParameter(), result.finding().worstParameter());
        assertEquals(result.reason(), result.finding().english());
        return result.finding();
    }

    @Test
    void twoPosesOfAnObjectAreNamedWithTheSecondsShare() {
        ThesisScene scene = ThesisScene.inPlane(4).noObjects().placement(1, 0.003)
                .cameraAt(RigidTransform.ofEuler(300, 180, 2200, 3.12, 0.03, 0.02))
                .object(5, RigidTransform.ofEuler(370, 295, 0, 0.05, 0.02, 0.9));
        Detections seen = scene.detections(0.3, RandomStreams.of(4), 1, 0.003);
        CheckResult result = CellCheck.run(scene.cell(), seen, SETTINGS);
        assertEquals(Verdict.AMBIGUOUS, result.verdict());
        Reason reason = result.finding();
        assertEquals(Reason.Kind.TWO_OBJECT_POSES, reason.kind());
        assertEquals(OptionalInt.of(5), reason.objectId());
        double share = result.estimate().object(5).modes().get(1).weight();
        assertEquals(share, reason.share().getAsDouble());
        assertEquals(String.format("Two poses explain the corners of object 5 (the second holds %.0f %%): use a larger "
                + "marker, come closer or look at it from the side.", 100 * share), result.reason());
        assertEquals("Two camera poses explain the references (the second holds 12 %): add a reference out of their "
                + "plane.", Reason.twoCameraPoses(0.12).english());
    }

    /** Budgets name every kind of source, and each is found again by its key. */
    @Test
    void everyKindOfSourceIsNamedAndFoundByItsKey() {
        ThesisScene scene = ThesisScene.inPlane(2);
        Cell all = scene.cell();
        Cell cell = new Cell(all.camera(), all.family(), all.references(), all.objects(), all.pixelStdPx(),
                all.targetStdMm(), new PrintPrecision(0.1, 0.1, 0.05))
                .withCalibration(new CameraCalibration(List.of("cx", "cy"), new double[] {1, 0.2, 0.2, 1}, 20))
                .withJointPlacement(new JointPlacement(List.of(new PlacementGroup("plate",
                        all.references().stream().map(r -> r.id()).toList(), new Placement(2, 2, 2, 0.01))),
                        List.of(), null, null));
        Detections corners = scene.detections(0.3, RandomStreams.of(1), 5, 0.01);
        Detections photo = new Detections("scene", corners.widthPx(), corners.heightPx(), corners.markers(), List.of(),
                new PhotoLight(ToneCurve.SRGB, true, 0.7, 1, 100, 0.1));
        CheckResult result = CellCheck.run(cell, photo, CheckSettings.builder()
                .estimate(Estimate.FOCAL).iterations(400).warmup(100).build());
        List<VarianceSource.Kind> found = new ArrayList<>();
        for (VarianceSource source : result.estimate().objects().get(0).budget().shares().keySet()) {
            found.add(source.kind());
            assertEquals(source, VarianceSource.ofKey(source.key()));
            assertEquals(source.kind() == VarianceSource.Kind.PLACEMENT_OF_REFERENCE,
                    source.referenceId().isPresent());
        }
        assertTrue(found.containsAll(List.of(VarianceSource.Kind.values())), found.toString());
        assertThrows(IllegalArgumentException.class, () -> VarianceSource.ofKey("weather"));
    }
}
