package org.cellgauge.internal.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.harrel.jsonschema.Validator;
import dev.harrel.jsonschema.ValidatorFactory;
import dev.harrel.jsonschema.providers.GsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.cell.Area;
import org.cellgauge.cell.ChangeKind;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Requirement.Axes;
import org.cellgauge.cell.Target;
import org.cellgauge.check.SampledForecast;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.plan.CellPlanner;
import org.cellgauge.plan.Layout;
import org.cellgauge.plan.Plan;
import org.cellgauge.plan.PlanOptions;
import org.cellgauge.plan.Proposal;
import org.cellgauge.settings.CheckSettings;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** A whole plan: what it proposes, what chains say of it, and the file that has it. */
class PlanJsonTest {
    private static final double INFINITE = Double.POSITIVE_INFINITY;

    /** A small field of places, so that all is quick. */
    private static PlanOptions options() {
        PlanOptions usual = PlanOptions.USUAL;
        return new PlanOptions(CheckSettings.builder().targetMcseStdRel(0.03).build(), usual.toneCurve(),
                usual.blurPx(), usual.noiseGrey(), List.of(new Area(0, -50, 450, 350)), List.of(), 0, 20, Map.of());
    }

    @Test
    void proposalsMeetTheirTargetAndChainsConfirmThem() throws IOException {
        ThesisScene scene = ThesisScene.inPlane(3).placement(2, 0.003).pixelStd(0.05).planeObjects()
                .grip(20, 0, 0, 100);
        Map<Integer, List<RigidTransform>> places = new LinkedHashMap<>();
        scene.objects().forEach((id, pose) -> places.put(id, List.of(pose)));
        Target target = new Target(new Requirement(Axes.NONE, new Axes(3, 3, 4), INFINITE, INFINITE, 0.95),
                Map.of(5, new Requirement(Axes.all(2), Axes.NONE, 4, 1, 0.9)));
        Layout layout = new Layout(scene.cell().withTarget(target), List.of(scene.worldFromCamera()), places);
        PlanOptions options = options();
        Plan plan = CellPlanner.plan(layout, options);
        assertTrue(!plan.met() && !plan.best().isEmpty(), plan.now().toString());
        List<@Nullable SampledForecast> sampled = new ArrayList<>();
        for (Proposal proposal : plan.best()) {
            assertTrue(proposal.forecast().ratio() <= 0.8501, proposal.sentence());
            // planned anew, its layout meets the target as it is
            assertTrue(CellPlanner.forecast(proposal.layout(), options).ratio() <= 0.8501, proposal.sentence());
            sampled.add(sampled.size() < 2 ? SampledForecast.of(proposal.layout(), options, options.settings()) : null);
        }
        Proposal one = plan.best().stream().filter(p -> p.layout().isOnePhoto()).findFirst().orElseThrow();
        SampledForecast chains = SampledForecast.of(one.layout(), options, options.settings());
        assertNotNull(chains);
        assertTrue(chains.confirms(), chains.toString());
        assertEquals(one.forecast().worstStdMm(), chains.sampledStdMm(), 0.06 * chains.sampledStdMm());
        List<ChangeKind> kinds = plan.single().stream().map(p -> p.changes().get(0).kind()).toList();
        assertTrue(kinds.containsAll(List.of(ChangeKind.ADD_PLATE, ChangeKind.MEASURE_DISTANCE,
                ChangeKind.MORE_PHOTOS, ChangeKind.ADD_REFERENCE)), kinds.toString());
        Validator.Result valid = new ValidatorFactory().withJsonNodeFactory(new GsonNode.Factory()).validate(
                Files.readString(Path.of(System.getProperty("cellgauge.root"), "docs", "plan.schema.json")),
                PlanJson.of(plan, sampled));
        assertTrue(valid.isValid(), () -> valid.getErrors().stream()
                .map(e -> e.getInstanceLocation() + ": " + e.getError()).toList().toString());
    }
}
