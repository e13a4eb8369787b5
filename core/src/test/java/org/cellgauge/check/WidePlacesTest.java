package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.placement.Misfit;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.warning.CheckRefusal;
import org.cellgauge.warning.CheckWarning;
import org.junit.jupiter.api.Test;

/** References whose height is stated very loosely. */
class WidePlacesTest {
    private static final ThesisScene SCENE = ThesisScene.inPlane(4).noObjects().placement(1, 0.0035).pixelStd(0.05);

    private static CheckResult check(double heightStdMm) {
        Cell cell = SCENE.cell();
        List<Reference> references = new ArrayList<>();
        for (Reference r : cell.references()) {
            references.add(new Reference(r.id(), r.sizeMm(), r.worldFromMarker(),
                    new Placement(1, 1, heightStdMm, 0.0035)));
        }
        return CellCheck.run(new Cell(cell.camera(), cell.family(), references, cell.objects(), cell.pixelStdPx(),
                cell.targetStdMm()), SCENE.exactDetections(), CheckSettings.builder().targetMcseStdRel(0.05).build());
    }

    private static boolean warns(CheckResult result, CheckWarning kind) {
        return result.warnings().stream().anyMatch(w -> w.kind() == kind);
    }

    /** Four references of 100 mm each that stand as stated leave the camera's height unknown by 100 / sqrt(4) mm. */
    @Test
    void whatAllReferencesMayShareIsInTheHeightOfTheCamera() {
        CheckResult result = check(100);
        double[] std = result.estimate().camera().std();
        assertEquals(50, std[2], 5);
        assertEquals(SCENE.worldFromCamera().translationMm()[2], result.estimate().camera().mean()[2], 8);
        assertTrue(warns(result, CheckWarning.PLACES_WIDE));
        assertFalse(warns(result, CheckWarning.CHAINS_APART));
        assertFalse(warns(check(5), CheckWarning.PLACES_WIDE));
    }

    @Test
    void aHeightThatIsNotKnownIsRefused() {
        InputRefusedException refused = assertThrows(InputRefusedException.class, () -> check(1000));
        assertEquals(CheckRefusal.PLACE_UNKNOWN, refused.refusal().kind());
        assertTrue(refused.getMessage().contains("may stand 1000 mm off its place"), refused.getMessage());
    }

    /** Two references that may be turned by 34 degrees: chains and Laplace's approximation are two different things. */
    @Test
    void noTargetIsMetWhereChainsAreFarFromLaplace() {
        ThesisScene scene = ThesisScene.inPlane(2).placement(10, 0.6).pixelStd(0.05);
        CheckResult result = CellCheck.run(scene.cell().withTarget(OptionalDouble.of(10_000)), scene.exactDetections(),
                CheckSettings.builder().targetMcseStdRel(0.05).build());
        double ratio = result.quickLook().camera().std()[1] / result.estimate().camera().std()[1];
        assertTrue(ratio > 2.2, "by the figures themselves they are apart: " + ratio);
        assertTrue(warns(result, CheckWarning.CHAINS_APART), result.warnings().toString());
        assertEquals(Verdict.FAIL, result.verdict());
        assertEquals(Misfit.Kind.CHAINS_APART, result.targetTest().misfit().kind());
    }
}
