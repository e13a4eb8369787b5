package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.statistics.BinomialBand;
import org.cellgauge.placement.Misfit;
import org.cellgauge.placement.NoiseFit;
import org.cellgauge.placement.ReferenceCheck;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.Warning;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;

/** Whether a photo contradicts the stated corner noise, or all references together, and what follows. */
class NoiseFitTest {
    private static final CheckSettings QUICK = CheckSettings.builder().seed(3).iterations(60).build();

    private static ThesisScene scene(int references, double statedPx) {
        return ThesisScene.oneRaised(references).placement(1, 0.005).pixelStd(statedPx).target(100);
    }

    private static NoiseFit fit(Cell cell, Detections detections) {
        return NoiseFit.of(cell, CornerErrors.of(cell, detections), cell.camera());
    }

    private static ReferenceCheck references(Cell cell, Detections detections) {
        return CellModes.of(Observed.of(cell, detections, CheckSettings.builder().build()), null).references();
    }

    private static String warnings(CheckResult result) {
        return result.warnings().stream().map(Warning::toString).collect(Collectors.joining("\n"));
    }

    @Test
    void cellsAsStatedFailSeldom(TestReporter reporter) {
        RandomGenerator random = RandomStreams.of(31);
        int cells = 800;
        int failed = 0;
        double sum = 0;
        ThesisScene scene = scene(4, 0.1);
        for (int c = 0; c < cells; c++) {
            NoiseFit fit = fit(scene.cell(), scene.detections(0.1, random, 1, 0.005));
            failed += fit.holds() ? 0 : 1;
            sum += fit.chiSquare();
            assertEquals(14, fit.degreesOfFreedom());
        }
        reporter.publishEntry("squares of 7 markers", failed + " of " + cells + " fail, mean " + sum / cells);
        assertTrue(failed <= BinomialBand.of(cells, NoiseFit.LEVEL, 0.998).upper(), failed + " of " + cells);
        // chi-square of 14 has the mean 14; that a marker can tilt to either side adds nothing, and takes less than one
        // of the two degrees of freedom of each
        assertTrue(sum / cells < 14 + 4 * Math.sqrt(28.0 / cells), "mean " + sum / cells);
        assertTrue(sum / cells > 7, "mean " + sum / cells);
    }

    /** Markers are no squares through the lens of the file, and are through another within what is known of it. */
    @Test
    void anUnknownFocalLengthIsNoNoise() {
        ThesisScene scene = ThesisScene.oneRaised(4).placement(1, 0.005).pixelStd(0.05).camera(ThesisScene.CAMERA)
                .object(20, RigidTransform.ofEuler(240, 100, 60, 0.6, 0.5, 0.2));
        RandomGenerator random = RandomStreams.of(35);
        IntrinsicsPrior prior = IntrinsicsPrior.focalAndAspect(ThesisScene.CAMERA, 200, 0.005);
        int failedAsStated = 0;
        int failed = 0;
        int cells = 60;
        for (int c = 0; c < cells; c++) {
            Detections seen = scene.camera(ThesisScene.CAMERA.withFocal(850, 855)).detections(0.05, random, 1, 0.005);
            Cell cell = scene.camera(ThesisScene.CAMERA).cell();
            CornerErrors errors = CornerErrors.of(cell, seen);
            failedAsStated += NoiseFit.of(cell, errors, cell.camera()).holds() ? 0 : 1;
            failed += NoiseFit.ofUnknownFocal(cell, errors, prior).holds() ? 0 : 1;
        }
        assertTrue(failedAsStated > cells / 2, failedAsStated + " fail through the lens of the file");
        assertTrue(failed <= 1, failed + " of " + cells + " fail");
    }

    /** How far off a reference stands says nothing of noise. */
    @Test
    void misplacedReferencesAreNoNoise() {
        ThesisScene scene = scene(4, 0.1).shifted(22, 60, -40, 30);
        assertTrue(fit(scene.cell(), scene.detections(0, RandomStreams.of(32), 0, 0)).chiSquare() < 1e-6);
    }

    @Test
    void threeTimesTheStatedNoiseFailsAndAccusesNoReference(TestReporter reporter) {
        RandomGenerator random = RandomStreams.of(33);
        int cells = 100;
        int failed = 0;
        int accusing = 0;
        double times = 0;
        ThesisScene scene = scene(4, 0.1);
        for (int c = 0; c < cells; c++) {
            Detections photo = scene.detections(0.3, random, 1, 0.005);
            NoiseFit fit = fit(scene.cell(), photo);
            failed += fit.holds() ? 0 : 1;
            accusing += references(scene.cell(), photo).misplaced().isEmpty() ? 0 : 1;
            times += fit.times() / cells;
        }
        reporter.publishEntry("0.1 px stated, 0.3 px true", failed + " of " + cells + " fail, " + accusing
                + " accuse a reference, " + times + " times");
        assertEquals(cells, failed);
        // one in a hundred is what a cell as stated is allowed
        assertTrue(accusing <= BinomialBand.of(cells, 0.01, 0.998).upper(), accusing + " accuse a reference");
        assertEquals(3, times, 0.3);
    }

    /** A reference that is off by more than the noise which the photo shows is still named. */
    @Test
    void aReferenceThatIsOffIsNamedInNoisyPhotosToo() {
        ThesisScene scene = scene(6, 0.1).shifted(911, 15, 0, Double.NaN);
        CheckResult result = CellCheck.run(scene.cell(), scene.detections(0.3, RandomStreams.of(34), 1, 0.005), QUICK);
        assertFalse(result.noiseFit().holds());
        assertEquals(911, result.referenceCheck().misplaced().get(0).id());
    }

    @Test
    void noTargetIsMetAndTheReasonNamesTheNoise() {
        ThesisScene scene = scene(4, 0.1);
        Detections photo = scene.detections(0.3, RandomStreams.of(35), 1, 0.005);
        CheckSettings settings = CheckSettings.builder().seed(3).targetMcseStdRel(0.05).build();
        CheckResult result = CellCheck.run(scene.cell(), photo, settings);
        assertEquals(Verdict.FAIL, result.verdict());
        assertTrue(result.decided());
        assertEquals(Verdict.FAIL, result.verdict(20));
        TargetTest huge = result.withTarget(OptionalDouble.of(1e9)).targetTest();
        assertEquals(Verdict.FAIL, huge.verdict(huge.object(20).position()));
        assertEquals(Misfit.Kind.NOISE, result.finding().misfit().kind());
        NoiseFit fit = result.noiseFit();
        assertTrue(result.reason().matches("Largest deviation: .* against a target of 100 mm; .* But corners are "
                + "[0-9.]+ times noisier than the stated 0\\.100 px: figures promise too much; state pixel_std_px: "
                + "[0-9.]+, or leave pixel_std_px out\\."), result.reason());
        assertTrue(result.reason().contains(String.format(Locale.ROOT, "%.1f times", fit.times())), result.reason());
        assertTrue(result.reason().contains(String.format(Locale.ROOT, "_px: %.3f,", fit.shownStdPx())),
                result.reason());
        assertTrue(warnings(result).contains(" times noisier than the stated 0.100 px, by how square markers are"),
                warnings(result));
        CheckResult free = result.withTarget(OptionalDouble.empty());
        assertEquals(Verdict.NO_TARGET, free.verdict());
        assertTrue(free.reason().contains("But corners are"), free.reason());

        ThesisScene asItIs = scene(4, 0.3);
        CheckResult holds = CellCheck.run(asItIs.cell(), photo, QUICK);
        assertTrue(holds.noiseFit().holds());
        assertTrue(holds.referenceCheck().fitTogether());
        assertFalse(warnings(holds).contains("noisier"), warnings(holds));
    }

    /** One corner that is far off is told as that of its marker, not as the noise of all. */
    @Test
    void oneBadMarkerIsNamed() {
        ThesisScene scene = scene(4, 0.1);
        List<MarkerObservation> markers = new ArrayList<>();
        for (MarkerObservation m : scene.detections(0.1, RandomStreams.of(37), 1, 0.005).markers()) {
            double[] px = m.cornersPx();
            px[0] += m.id() == 22 ? 2 : 0;
            markers.add(new MarkerObservation(m.id(), px));
        }
        CheckResult result = CellCheck.run(scene.cell(), new Detections("photo", 1280, 720, markers), QUICK);
        assertEquals(OptionalInt.of(22), result.noiseFit().outlier());
        assertTrue(result.noiseFit().times(22) > 4);
        assertTrue(result.noiseFit().times(911) < 3);
        assertTrue(result.referenceCheck().misplaced().isEmpty(), warnings(result));
        assertTrue(warnings(result).contains("the corners of marker 22 fit no square"), warnings(result));
    }

    @Test
    void twoMarkersCannotSayWhichOfThemIsBad() {
        Map<Integer, Double> squares = new LinkedHashMap<>();
        squares.put(1, 200.0);
        squares.put(2, 1.0);
        NoiseFit two = NoiseFit.of(0.1, squares);
        assertFalse(two.holds());
        assertFalse(two.outlier().isPresent());
        squares.put(3, 1.0);
        assertEquals(OptionalInt.of(1), NoiseFit.of(0.1, squares).outlier());
        // chi-square of 6: sqrt(202 / 6) times the stated noise
        assertEquals(Math.sqrt(202.0 / 6), NoiseFit.of(0.1, squares).times(), 1e-12);
        assertEquals(0.1 * Math.sqrt(202.0 / 6), NoiseFit.of(0.1, squares).shownStdPx(), 1e-12);
    }

    @Test
    void aNoiseThatNobodyStatesIsNotHeldAgainstAnything() {
        ThesisScene scene = scene(4, 0.1);
        Cell stated = scene.cell();
        Cell open = new Cell(stated.camera(), stated.family(), stated.references(), stated.objects(),
                OptionalDouble.empty(), stated.targetStdMm(), PrintPrecision.USUAL);
        NoiseFit fit = fit(open, scene.detections(0.3, RandomStreams.of(37), 1, 0.005));
        assertFalse(fit.tested());
        assertTrue(fit.holds());
        assertTrue(Double.isNaN(fit.chiSquare()));
    }

    // ---- references together

    /** Two references off against each other a bit along each coordinate, so that none of these stands out. */
    @Test
    void twoReferencesThatDoNotFitTogetherPassNoTarget(TestReporter reporter) {
        ThesisScene scene = ThesisScene.inPlane(2).placement(1, 0.005).pixelStd(0.05).target(1000);
        RandomGenerator random = RandomStreams.of(38);
        Detections silent = null;
        int found = 0;
        int named = 0;
        int cells = 100;
        for (int c = 0; c < cells; c++) {
            Detections photo = scene.detections(0.05, random, 2.5, 0.0125);
            ReferenceCheck check = references(scene.cell(), photo);
            named += check.misplaced().isEmpty() ? 0 : 1;
            if (check.misplaced().isEmpty() && !check.fitTogether()) {
                found++;
                silent = photo;
            }
        }
        reporter.publishEntry("two references placed 2.5 times worse than stated", named + " named, " + found
                + " more not fitting together, of " + cells);
        assertTrue(found > 0);
        CheckResult result = CellCheck.run(scene.cell(), silent,
                CheckSettings.builder().seed(3).targetMcseStdRel(0.05).build());
        assertEquals(Verdict.FAIL, result.verdict(), result.reason());
        assertEquals(Misfit.Kind.REFERENCES, result.finding().misfit().kind());
        assertTrue(result.noiseFit().holds());
        assertTrue(result.reason().contains("But the references together fit "), result.reason());
        assertTrue(warnings(result).contains(" times worse than their stated precision and corner noise let expect "
                + "(chi-square "), warnings(result));
        assertEquals(6, result.referenceCheck().degreesOfFreedom());
    }

    @Test
    void misfitOfReferencesTogetherIsThatOfTheModel(TestReporter reporter) {
        ThesisScene scene = ThesisScene.inPlane(4).placement(5, 0.01).pixelStd(0.3).noObjects();
        RandomGenerator random = RandomStreams.of(39);
        int cells = 200;
        double sum = 0;
        int failed = 0;
        for (int c = 0; c < cells; c++) {
            ReferenceCheck check = references(scene.cell(), scene.detections(0.3, random, 5, 0.01));
            // without the one that is named in a cell of a hundred
            assertEquals(6 * (4 - check.misplaced().size()) - 6, check.degreesOfFreedom());
            sum += 18 * check.chiSquare() / check.degreesOfFreedom();
            failed += check.fitTogether() ? 0 : 1;
        }
        reporter.publishEntry("references together", "mean " + sum / cells + " of 18, " + failed + " fail");
        // chi-square of 18: deviation 6
        assertEquals(18, sum / cells, 4 * 6 / Math.sqrt(cells));
        assertTrue(failed <= BinomialBand.of(cells, ReferenceCheck.LEVEL_TOGETHER, 0.998).upper(), failed + "");
    }
}
