package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.MarkerPoseFinder;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.statistics.BinomialBand;
import org.cellgauge.placement.Misfit;
import org.cellgauge.placement.NoiseFit;
import org.cellgauge.placement.Overlap;
import org.cellgauge.placement.ReferenceCheck;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.Warning;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Whether a photo contradicts the stated corner noise, or all references together, and what follows. */
class NoiseFitTest {
    private static final CheckSettings QUICK = CheckSettings.builder().seed(3).iterations(60).build();

    private static ThesisScene scene(int references, double statedPx) {
        return ThesisScene.oneRaised(references).placement(1, 0.005).pixelStd(statedPx).target(100);
    }

    private static NoiseFit fit(Cell cell, Detections detections) {
        return NoiseFit.of(cell, CornerErrors.of(cell, detections), cell.camera(), new MarkerPoseFinder());
    }

    private static ReferenceCheck references(Cell cell, Detections detections) {
        return new QuickLooks(cell, CheckSettings.builder().build()).of(detections, null).referenceCheck();
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
        MarkerPoseFinder finder = new MarkerPoseFinder();
        int failedAsStated = 0;
        int failed = 0;
        int cells = 60;
        for (int c = 0; c < cells; c++) {
            Detections seen = scene.camera(ThesisScene.CAMERA.withFocal(850, 855)).detections(0.05, random, 1, 0.005);
            Cell cell = scene.camera(ThesisScene.CAMERA).cell();
            CornerErrors errors = CornerErrors.of(cell, seen, finder);
            failedAsStated += NoiseFit.of(cell, errors, cell.camera(), finder).holds() ? 0 : 1;
            failed += NoiseFit.ofUnknownIntrinsics(cell, errors, prior, finder).holds() ? 0 : 1;
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
        // chi-square of 14, nine times as large, is beyond its limit of 34.2 with the chance 0.997
        assertTrue(failed >= BinomialBand.of(cells, 0.997, 0.998).lower(), failed + " of " + cells + " fail");
        // one in a hundred is what a cell as stated is allowed
        assertTrue(accusing <= BinomialBand.of(cells, 0.01, 0.998).upper(), accusing + " accuse a reference");
        // three, good to 0.07, but for what tilting to either side takes off
        assertTrue(times > 2.2 && times < 3.3, times + " times");
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
        Detections photo = scene.detections(0.3, RandomStreams.of(52), 1, 0.005);
        CheckSettings settings = CheckSettings.builder().seed(3).targetMcseStdRel(0.05).build();
        CheckResult result = CellCheck.run(scene.cell(), photo, settings);
        assertEquals(Verdict.FAIL, result.verdict());
        assertTrue(result.decided());
        assertEquals(Verdict.FAIL, result.verdict(20));
        TargetTest huge = result.withTarget(OptionalDouble.of(1e9)).targetTest();
        assertEquals(Verdict.FAIL, huge.verdict(huge.object(20), huge.object(20).position()));
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
        assertEquals(Collections.singletonList(22), result.noiseFit().outliers());
        assertEquals(Collections.singleton(22), result.noise().setAside().keySet());
        assertTrue(result.noiseFit().times(22) > 4);
        assertTrue(result.noiseFit().times(911) < 3);
        assertTrue(result.referenceCheck().misplaced().isEmpty(), warnings(result));
        assertTrue(warnings(result).contains("the corners of marker 22 fit no square"), warnings(result));
    }

    @Test
    void twoMarkersCannotSayWhichOfThemIsBad() {
        Map<Integer, Double> squares = new LinkedHashMap<>();
        squares.put(1, 200.0);
        squares.put(2, 2.0);
        NoiseFit two = NoiseFit.of(0.1, squares);
        assertFalse(two.holds());
        // the one may as well be lucky as the other bad: F of (2, 2) is beyond 199 in 1 of 200
        assertEquals(Collections.emptyList(), two.outliers());
        squares.put(3, 1.0);
        assertEquals(Collections.singletonList(1), NoiseFit.of(0.1, squares).outliers());
        // chi-square of 6: sqrt(203 / 6) times the stated noise
        assertEquals(Math.sqrt(203.0 / 6), NoiseFit.of(0.1, squares).times(), 1e-12);
        assertEquals(0.1 * Math.sqrt(203.0 / 6), NoiseFit.of(0.1, squares).shownStdPx(), 1e-12);
    }

    /** Among twenty markers one of 26 is hidden in the sum (64 of 40, p 0.009), and not by itself (p 0.000002). */
    @Test
    void aBadMarkerDoesNotHideAmongMany() {
        Map<Integer, Double> squares = new LinkedHashMap<>();
        for (int id = 0; id < 20; id++) {
            squares.put(id, 2.0);
        }
        assertTrue(NoiseFit.of(0.1, squares).holds());
        squares.put(7, 26.0);
        NoiseFit fit = NoiseFit.of(0.1, squares);
        assertTrue(fit.pValue() > 0.005, "p of all " + fit.pValue());
        assertFalse(fit.holds());
        assertEquals(Collections.singletonList(7), fit.outliers());
        squares.put(3, 400.0);
        assertEquals(Arrays.asList(3, 7), NoiseFit.of(0.1, squares).outliers());
    }

    private static Cell withoutNoise(Cell stated) {
        return new Cell(stated.camera(), stated.family(), stated.references(), stated.objects(),
                OptionalDouble.empty(), stated.targetStdMm(), PrintPrecision.USUAL);
    }

    private static Detections moved(Detections seen, int id, double px) {
        List<MarkerObservation> markers = new ArrayList<>();
        for (MarkerObservation m : seen.markers()) {
            double[] corners = m.cornersPx();
            corners[4] += m.id() == id ? px : 0;
            markers.add(new MarkerObservation(m.id(), corners));
        }
        return new Detections("photo", 1280, 720, markers);
    }

    /** Against a noise that the other markers tell: no target is met, whichever marker it is. */
    @ParameterizedTest
    @CsvSource({"22", "20"})
    void aMarkerThatIsNoSquareMeetsNoTarget(int id) {
        ThesisScene scene = scene(4, 0.1);
        Detections seen = scene.detections(0.1, RandomStreams.of(41), 1, 0.005);
        NoiseFit usual = fit(withoutNoise(scene.cell()), seen);
        assertTrue(usual.holds());
        CheckResult result = CellCheck.run(withoutNoise(scene.cell()), moved(seen, id, 4), QUICK);
        assertEquals(Collections.singletonList(id), result.noiseFit().outliers());
        assertEquals(Misfit.Kind.NO_SQUARE, result.referenceCheck().misfit().kind());
        assertTrue(warnings(result).contains("the corners of marker " + id + " fit no square"), warnings(result));
        assertTrue(result.verdict() != Verdict.PASS, result.reason());
    }

    /** False alarms with a noise that nobody states, seldom whatever it is. */
    @ParameterizedTest
    @CsvSource({"0.02", "0.5"})
    void honestMarkersAreSquares(double px) {
        RandomGenerator random = RandomStreams.of(42);
        ThesisScene scene = scene(4, px);
        int cells = 150;
        int failed = 0;
        for (int c = 0; c < cells; c++) {
            failed += fit(withoutNoise(scene.cell()), scene.detections(px, random, 1, 0.005)).holds() ? 0 : 1;
        }
        assertTrue(failed <= BinomialBand.of(cells, NoiseFit.LEVEL, 0.998).upper(), failed + " of " + cells);
    }

    /** Two markers in one place of a photo, and two references that the cell file has one over the other. */
    @Test
    void twoMarkersInOnePlaceMeetNoTarget() {
        ThesisScene scene = scene(4, 0.1);
        Detections seen = scene.detections(0.1, RandomStreams.of(43), 1, 0.005);
        assertTrue(references(scene.cell(), seen).overlaps().isEmpty());
        List<MarkerObservation> markers = new ArrayList<>();
        for (MarkerObservation m : seen.markers()) {
            markers.add(m.id() == 20 ? new MarkerObservation(20, seen.find(30).cornersPx()) : m);
        }
        CheckResult result = CellCheck.run(scene.cell(), new Detections("photo", 1280, 720, markers), QUICK);
        assertTrue(warnings(result).contains("markers 20 and 30 are seen in one place"), warnings(result));
        assertEquals(Misfit.Kind.ONE_PLACE_IN_PHOTO, result.referenceCheck().misfit().kind());
        assertTrue(result.verdict() != Verdict.PASS, result.reason());
        List<Reference> moved = new ArrayList<>(scene.cell().references());
        Reference other = moved.get(1);
        RigidTransform beside = moved.get(0).worldFromMarker().compose(RigidTransform.ofEuler(30, 20, 5, 0, 0, 0.3));
        moved.set(1, new Reference(other.id(), other.sizeMm(), beside, other.placement()));
        Cell cell = new Cell(scene.cell().camera(), scene.cell().family(), moved, scene.cell().objects(),
                scene.cell().pixelStdPx(), scene.cell().targetStdMm());
        List<Overlap> overlaps = Overlap.among(cell, seen);
        assertEquals(1, overlaps.size());
        assertFalse(overlaps.get(0).inPhoto());
        // 47 mm apart they touch at most
        moved.set(1, new Reference(other.id(), other.sizeMm(), moved.get(0).worldFromMarker().compose(
                RigidTransform.ofEuler(47, 0, 0, 0, 0, 0)), other.placement()));
        assertTrue(Overlap.among(new Cell(cell.camera(), cell.family(), moved, cell.objects(), cell.pixelStdPx(),
                cell.targetStdMm()), seen).isEmpty());
    }

    @Test
    void aNoiseThatNobodyStatesIsNotHeldAgainstAnything() {
        ThesisScene scene = scene(4, 0.1);
        NoiseFit fit = fit(withoutNoise(scene.cell()), scene.detections(0.3, RandomStreams.of(37), 1, 0.005));
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
            if (check.misplaced().isEmpty() && check.causes().isEmpty() && !check.fitTogether()) {
                found++;
                silent = photo;
            }
        }
        reporter.publishEntry("two references placed 2.5 times worse than stated", named + " named, " + found
                + " more not fitting together, of " + cells);
        assertTrue(found > 0);
        CheckResult result = CellCheck.run(scene.cell(), silent,
                CheckSettings.builder().seed(3).targetMcseStdRel(0.05).build());
        assertEquals(Verdict.CONTRADICTED, result.verdict(), result.reason());
        assertEquals(Misfit.Kind.REFERENCES, result.finding().misfit().kind());
        assertTrue(result.noiseFit().holds());
        assertTrue(result.reason().startsWith("No figure: the references together fit "), result.reason());
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
