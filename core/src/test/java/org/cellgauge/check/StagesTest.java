package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.internal.pose.MarkerPoseFinder;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.placement.ReferenceCheck;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.DetectionWarning;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Warning;
import org.junit.jupiter.api.Test;

/** Every stage of a check is whole by itself, and what comes after it changes nothing in it. */
class StagesTest {
    private static final CheckSettings SETTINGS = CheckSettings.builder().iterations(400).threads(1).build();
    private final ThesisScene scene = ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.3).target(3);
    private final Cell cell = scene.cell();

    private Observed observed(Detections photo) {
        return Observed.of(cell, photo, SETTINGS, new MarkerPoseFinder());
    }

    @Test
    void whatIsSeenNeedsNoPose() {
        Detections without = withoutFirstReference();
        Observed observed = observed(without);
        assertEquals(1, observed.warnings.stream().filter(w -> w.kind() == CheckWarning.REFERENCES_NOT_SEEN).count());
        assertFalse(observed.errors.has(cell.references().get(0).id()));
        assertTrue(observed.errors.has(cell.references().get(1).id()));
        // no name of the photo, and not its place in a batch, but its corners make its random numbers
        assertEquals(observed.photoSeed(), observed(without).photoSeed());
        assertNotEquals(observed.photoSeed(), observed(scene.exactDetections()).photoSeed());
        Detections noisy = scene.detections(0.3, RandomStreams.of(1), 0, 0);
        assertNotEquals(observed(noisy).photoSeed(),
                observed(scene.exactDetections()).photoSeed());
    }

    @Test
    void whatTheDetectorSaysIsSaidWhereNoReferenceIsLeft() {
        List<Warning> said = List.of(Warning.of(DetectionWarning.MIRRORED, Listing.and(List.of(22))),
                Warning.of(DetectionWarning.NEARLY_BLACK, 12));
        Detections exact = scene.exactDetections();
        String refusal = assertThrows(InputRefusedException.class, () -> observed(new Detections("a.png",
                exact.widthPx(), exact.heightPx(), List.of(), said))).getMessage();
        assertTrue(refusal.startsWith("a.png: none of the references "), refusal);
        assertTrue(refusal.endsWith(" can be used: " + said.get(0) + "; " + said.get(1)), refusal);
    }

    /** Corners without noise: the mode is the truth, and the references fit, without any chain. */
    @Test
    void modesAndTestsOfReferencesNeedNoChains() {
        CellModes modes = CellModes.of(observed(scene.exactDetections()), null, new MarkerPoseFinder());
        assertArrayEquals(ThesisScene.WORLD_FROM_CAMERA.translationMm(), modes.camera.worldFromCamera().translationMm(),
                1e-6);
        assertEquals(cell.objects().size(), modes.objects.size());
        ReferenceCheck references = modes.references();
        assertTrue(references.fitTogether());
        assertTrue(references.misplaced().isEmpty());
    }

    @Test
    void quickLookIsTheSameAfterItsChainsHaveRunTwice() {
        QuickLook quickLook = new QuickLooks(cell, SETTINGS).of(scene.exactDetections(), null);
        double[] before = quickLook.estimate().camera().std();
        CheckResult first = quickLook.chains(() -> 1).blockingLast().result();
        CheckResult second = quickLook.chains(() -> 1).blockingLast().result();
        assertArrayEquals(before, quickLook.estimate().camera().std(), 0);
        assertArrayEquals(first.estimate().camera().std(), second.estimate().camera().std(), 0);
        assertEquals(first.warnings(), second.warnings());
        assertThrows(UnsupportedOperationException.class, () -> quickLook.modes.warnings.clear());
        assertThrows(UnsupportedOperationException.class, () -> quickLook.modes.objects.clear());
    }

    private Detections withoutFirstReference() {
        Detections all = scene.exactDetections();
        List<MarkerObservation> others = new ArrayList<>();
        for (MarkerObservation marker : all.markers()) {
            if (marker.id() != cell.references().get(0).id()) {
                others.add(marker);
            }
        }
        return new Detections(all.imageName(), all.widthPx(), all.heightPx(), others, List.of());
    }
}
