package org.cellgauge.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.harrel.jsonschema.Validator;
import dev.harrel.jsonschema.ValidatorFactory;
import dev.harrel.jsonschema.providers.GsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.check.Verdict;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.placement.Misfit;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.vision.Detections;
import org.cellgauge.warning.Message;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Results written, held against the schema and read back. */
class ResultReaderTest {
    private static String schema;
    private static final ResultRecord RECORD = ResultRecord.of("scene.json", "0".repeat(64), "1")
            .withCell("cell.yaml", "1".repeat(64)).withCamera("camera.yaml", "2".repeat(64)).withDate("2026-11-28")
            .withJudgedOn("2026-11-29").withCommand("cellgauge check --cell 'a b.yaml'");

    private static CheckResult whole;
    private static String json;

    @BeforeAll
    static void check() throws IOException {
        schema = Files.readString(Path.of(System.getProperty("cellgauge.root"), "docs", "result.schema.json"));
        // object 20 is not in the photo
        ThesisScene scene = ThesisScene.oneRaised(4).placement(5, 0.01).pixelStd(0.3).grip(5, 10, 20, 100).target(6);
        Detections all = scene.detections(0.3, RandomStreams.of(1), 5, 0.01);
        Detections seen = new Detections("scene", all.widthPx(), all.heightPx(),
                all.markers().stream().filter(m -> m.id() != 20).toList(), List.of(), null);
        whole = CellCheck.run(scene.cell(), seen, CheckSettings.builder().build());
        json = ResultJson.of(whole, RECORD);
    }

    private static void assertReadBack(CheckResult result) {
        String text = ResultJson.of(result, RECORD);
        Validator.Result valid = new ValidatorFactory().withJsonNodeFactory(new GsonNode.Factory())
                .validate(schema, text);
        assertTrue(valid.isValid(), () -> valid.getErrors().stream()
                .map(e -> e.getInstanceLocation() + ": " + e.getError()).toList().toString());
        StoredResult read = ResultReader.stored(text, "r.json");
        assertEquals(ResultView.of(result), read.view());
        assertEquals(RECORD, read.record());
        assertEquals(text, ResultJson.of(read));
        assertEquals(read, ResultReader.stored(ResultJson.line(read), "line"));
        assertEquals(1, ResultJson.line(read).lines().count());
        assertJudgedAnewAsByTheCheck(result, read.view());
    }

    /** Another target held against a result read back, and against the draws themselves. */
    private static void assertJudgedAnewAsByTheCheck(CheckResult result, ResultView read) {
        double worst = result.estimate().objects().stream().mapToDouble(ObjectEstimate::worstStdMm).max().orElse(1);
        // far below, within the Monte Carlo error, above, far above, none
        for (double target : new double[] {0.3 * worst, worst, 1.3 * worst, 1000 * worst, Double.NaN}) {
            OptionalDouble other = Double.isNaN(target) ? OptionalDouble.empty() : OptionalDouble.of(target);
            if (!other.equals(result.cell().targetStdMm())) {
                assertEquals(ResultView.of(result.withTarget(other)), read.withTarget(other));
            }
        }
    }

    @Test
    void whatIsWrittenIsReadBack() {
        assertReadBack(whole);
        ResultView view = ResultReader.of(json, "r.json");
        // against the result itself, not its view
        assertEquals(whole.verdict(), view.verdict());
        assertEquals(whole.reason(), view.reason());
        assertEquals(whole.estimate().object(5).pose().std()[2], view.object(5).std()[2]);
        assertEquals(whole.estimate().object(5).grip().meanMm()[0], view.grip(5).mean()[0]);
        assertEquals(whole.estimate().object(5).gripBudget().gains(1).get(VarianceSource.placementOf(22)),
                view.grip(5).budget().stream().filter(b -> b.source().equals(VarianceSource.placementOf(22)))
                        .findFirst().orElseThrow().gain(1));
        assertEquals(whole.estimate().object(30).ellipse95Px().semiMajor(), view.object(30).ellipse95Px().semiMajor());
        assertEquals(whole.estimate().camera().covariance()[0][5], view.camera().covariance()[0][5]);
        assertEquals(whole.diagnostics().rHatMax(), view.chains().rHatMax());
        double most = whole.estimate().object(5).budget().shares().values().stream().mapToDouble(v -> v).max()
                .getAsDouble();
        assertEquals(most, view.object(5).largestShare().share());
        QuantityView x = view.chains().quantities().stream().filter(q -> q.name().equals("object_5_x_mm")).findFirst()
                .orElseThrow();
        assertEquals(whole.diagnostics().of(Quantity.object(5, Quantity.Axis.X)).mcseQuantile(0.95),
                x.number("mcse_q95"));
        assertThrows(IllegalArgumentException.class, () -> x.number("median"));
        assertFalse(view.object(20).seen());
        assertNull(view.grip(30));
        assertEquals(List.of(5, 20, 30), view.objects().stream().map(row -> row.id().getAsInt()).toList());
        double worst = Math.max(whole.estimate().object(5).worstStdMm(), whole.estimate().object(30).worstStdMm());
        assertEquals(worst, view.worstStdMm(view.worstObject()));
        assertEquals(whole.referenceCheck().fit(944).normalisedResidual(),
                view.references().fit(944).normalisedResidual());
        assertEquals(whole.noise().markerStdPx().get(5), view.noise().markers().stream().filter(m -> m.id() == 5)
                .findFirst().orElseThrow().stdPx());
        assertEquals(whole.quickLook().object(5).grip().stdMm()[2], view.grip(5).laplace().std()[2]);
        assertEquals(whole.acceptance().get(0).accepted(), view.chains().acceptance().get(0).accepted());
        assertEquals(whole.cell().references().get(0).placement().stdMm(1), view.cell().references().get(0).stdMm()[1]);
        assertEquals(whole.settings().sampling().seed(), view.run().settings().sampling().seed());
        assertEquals(whole.warnings().get(0).kind().code(), view.warnings().get(0).code());
        for (int k = 0; k < 9; k++) {
            assertEquals(whole.estimate().camera().meanTransform().rotation()[k],
                    view.camera().pose().transform().rotation()[k], 1e-14);
        }
    }

    private static double largest(double[] std) {
        return Math.max(std[0], Math.max(std[1], std[2]));
    }

    /** A target between the deviations of position and gripping point, which swings with the rotation: one misses. */
    @Test
    void verdictsOfPositionAndGrippingPointAreReadBackEach() {
        ThesisScene scene = ThesisScene.oneRaised(4).placement(1, 0.003).pixelStd(0.05).grip(5, 10, 20, 300);
        CheckResult result = CellCheck.run(scene.cell(), scene.exactDetections(),
                CheckSettings.builder().iterations(1200).build());
        double positionMm = largest(result.estimate().object(5).pose().std());
        double gripMm = largest(result.estimate().object(5).grip().stdMm());
        assertTrue(gripMm > 1.2 * positionMm, positionMm + ", " + gripMm);
        CheckResult between = result.withTarget(OptionalDouble.of((positionMm + gripMm) / 2));
        assertReadBack(between);
        ResultView view = ResultReader.of(ResultJson.of(between, RECORD), "r.json");
        assertEquals(Verdict.PASS, view.object(5).verdict());
        assertEquals(Verdict.FAIL, view.grip(5).verdict());
    }

    @Test
    void probabilitiesOfTolerancesAreReadBack() {
        Requirement asked = new Requirement(Requirement.Axes.NONE, new Requirement.Axes(4, 4, 9), 12, 2, 0.9);
        CheckResult judged = whole.withTarget(new Target(asked, Map.of(30, Requirement.ofStdMm(5))));
        assertReadBack(judged);
        ResultView view = ResultReader.of(ResultJson.of(judged, RECORD), "r.json");
        assertEquals(judged.cell().target(), view.target());
        assertEquals(5, view.object(5).conformities().size());
        assertEquals(4, view.grip(5).conformities().size());
        assertEquals(List.of(), view.object(30).conformities());
    }

    @Test
    void whatWouldMeetAMissedTargetIsReadBack() {
        ThesisScene scene = ThesisScene.inPlane(4).placement(2, 0.003).pixelStd(0.05).target(1.5);
        CheckResult missed = CellCheck.run(scene.cell(), scene.exactDetections(), CheckSettings.builder().build());
        ResultView view = ResultView.of(missed);
        List<AdviceView> advice = AdviceView.of(missed.cell(), missed.settings(), view, Message::toString);
        assertEquals(Verdict.FAIL, view.verdict());
        assertTrue(advice.size() >= 1 && advice.size() <= 3, advice.toString());
        for (AdviceView a : advice) {
            assertTrue(a.worstStdMm() <= 1.5, a.line());
            assertTrue(a.nowStdMm() > 1.5 && a.thenStdMm() <= 1.5, a.line());
        }
        StoredResult with = new StoredResult(view.withAdvice(advice), RECORD);
        assertEquals(with, ResultReader.stored(ResultJson.of(with), "r.json"));
        assertEquals(advice, ResultReader.of(ResultJson.of(with), "r.json").advice());
        // of another target it says nothing
        assertEquals(List.of(), with.view().withTarget(OptionalDouble.of(0.1)).advice());
        CheckResult met = missed.withTarget(OptionalDouble.of(100));
        assertEquals(List.of(), AdviceView.of(met.cell(), met.settings(), ResultView.of(met), Message::toString));
    }

    @Test
    void unknownIntrinsicsAndChainsThatDidNotConvergeAreReadBack() {
        ThesisScene scene = ThesisScene.oneRaised(4).placement(5, 0.01).pixelStd(0.3);
        CheckResult few = CellCheck.run(scene.cell(), scene.exactDetections(), CheckSettings.builder()
                .estimate(Estimate.FOCAL).iterations(220).warmup(200).build());
        assertReadBack(few);
        ResultView view = ResultView.of(few);
        assertEquals("fx_px", view.intrinsics().get(0).name());
        assertEquals(few.estimate().intrinsics().covariance()[0][1], view.intrinsicsCovariance()[0][1]);
        assertEquals(Verdict.NOT_CONVERGED, view.object(5).verdict());
        assertNull(view.object(5).withinTarget());
    }

    @Test
    void aPoseWithTwoModesIsReadBack() {
        ThesisScene scene = ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.5)
                .object(5, RigidTransform.ofEuler(418, 106, 0, 0.25, 0.1, 0.4)).target(1000);
        CheckResult result = CellCheck.run(scene.cell(), scene.exactDetections(),
                CheckSettings.builder().iterations(3000).warmup(500).build());
        assertReadBack(result);
        assertTrue(ResultView.of(result).object(5).ambiguous());
        assertTrue(ResultJson.of(result, RECORD).contains("\"modes\""));
    }

    /** A second pose with a share of draws that leaves the first one the only one to tell of. */
    @Test
    void lesserModesAreReadBack() {
        ThesisScene scene = ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.2)
                .object(5, RigidTransform.ofEuler(418, 106, 0, 0.6, 0.1, 0.4)).target(1000);
        CheckResult result = CellCheck.run(scene.cell(), scene.exactDetections(),
                CheckSettings.builder().iterations(1200).warmup(200).build());
        ResultRow object = ResultView.of(result).object(5);
        assertEquals(2, object.modes().size());
        assertFalse(object.ambiguous());
        assertReadBack(result);
        assertTrue(ResultJson.of(result, RECORD).contains("\"lesser_modes\""));
    }

    @Test
    void aMisplacedReferenceAndTheObjectsThatDependOnItAreReadBack() {
        ThesisScene scene = ThesisScene.oneRaised(4).placement(1, 0.003).pixelStd(0.05).grip(5, 10, 20, 100).target(3)
                .shifted(22, 12, 12, 0);
        CheckResult result = CellCheck.run(scene.cell(), scene.detections(0.05, RandomStreams.of(9), 1, 0.003),
                CheckSettings.builder().iterations(600).build());
        assertReadBack(result);
        ResultView view = ResultReader.of(ResultJson.of(result, RECORD), "r.json");
        assertEquals(22, view.references().misplaced().get(0).id());
        assertEquals(result.referenceCheck().without().object(5).gripErrorMm()[1],
                view.references().without().object(5).grip().errorMm()[1]);
        assertEquals(result.referenceCheck().fit(944).detectable()[2], view.references().fit(944).detectable()[2]);
    }

    /** Noise that the photo contradicts: no target is met, not even a large one. */
    @Test
    void whatThePhotoContradictsIsReadBackAndKeepsEveryTargetMissed() {
        ThesisScene scene = ThesisScene.oneRaised(4).placement(1, 0.005).pixelStd(0.1).target(5);
        CheckResult result = CellCheck.run(scene.cell(), scene.detections(0.3, RandomStreams.of(52), 1, 0.005),
                CheckSettings.builder().seed(3).targetMcseStdRel(0.05).build());
        assertReadBack(result);
        ResultView read = ResultReader.of(ResultJson.of(result, RECORD), "r.json");
        assertEquals(Misfit.Kind.NOISE, read.references().misfit().kind());
        assertEquals(Verdict.FAIL, read.withTarget(OptionalDouble.of(1e6)).verdict());
    }

    @Test
    void viewsThatDifferAreNotEqual() {
        ResultView view = ResultReader.of(json, "r.json");
        double std = whole.estimate().object(5).pose().mean()[0];
        assertTrue(json.contains(Double.toString(std)));
        assertNotEquals(view, ResultReader.of(json.replace(Double.toString(std), Double.toString(std + 1)), "r.json"));
        assertNotEquals(view, ResultView.preliminary(whole.cell(), whole.quickLook()));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "\"schema\": 1 | \"schema\": 2 | r.json, schema: version 2 of the format is not known",
        "\"decided\": | \"undecided\": | r.json: the key \"decided\" is missing",
        "\"frame\": \"camera in world\" | \"frame\": 7 | r.json, camera.frame: a text in quotes should stand here",
        "\"verdict\": | \"verdict\": \"fine\", \"was\": | r.json, verdict: \"fine\" means nothing here",
        "\"corner noise of object\": | \"weather\": | r.json, objects.5.budget: \"weather\" means nothing here",
        "\"warnings\": [ | \"warnings\": [[], | r.json, warnings[0]: a text in quotes should stand here",
        "\"converged\": | \"converged\": 1, \"was\": | r.json, diagnostics.converged: true or false should stand here",
        "\"angle_rad\": | \"angle_rad\": null, \"was\": | r.json, objects.5.ellipse95_px: this cannot be (ellipse",
        "\"size_mm\": | \"size\": | r.json, settings.references.944: the key \"size_mm\" is missing",
        "\"fx_px\": | \"fx_px\": -1, \"was\": | r.json, settings.camera_intrinsics: this cannot be (",
        "\"schema\": 1, | \"schema\": 1,, | r.json, line 2, column"})
    void faultsAreNamedWithTheirPlace(String part, String by, String message) {
        assertTrue(json.contains(part), part);
        String text = json.replaceFirst(java.util.regex.Pattern.quote(part),
                java.util.regex.Matcher.quoteReplacement(by));
        InputRefusedException e = assertThrows(InputRefusedException.class, () -> ResultReader.of(text, "r.json"));
        assertTrue(e.getMessage().startsWith(message), e.getMessage());
        String remedy = message.contains("schema") ? "; read it with" : "; name a result file";
        assertTrue(e.getMessage().contains(remedy), e.getMessage());
    }
}
