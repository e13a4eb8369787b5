package org.cellgauge.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.UnaryOperator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.check.Verdict;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.validation.CauseStudy;
import org.cellgauge.internal.validation.RandomLayouts;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.vision.Detections;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is wrong with a cell file is named: corners are those of the right cell, the file is another. */
class CausesTest {
    private static final double STD_MM = 1;
    private static final double STD_RAD = 0.0035;
    private static final double NOISE_PX = 0.05;

    /** References at several heights, so that the camera's place is well known. */
    private static ThesisScene scene() {
        return ThesisScene.oneRaised(5).placement(STD_MM, STD_RAD).pixelStd(NOISE_PX).target(20);
    }

    private static Detections photo() {
        return scene().detections(NOISE_PX, RandomStreams.of(42), STD_MM, STD_RAD);
    }

    private static Cell with(UnaryOperator<List<Reference>> change) {
        Cell cell = scene().cell();
        return new Cell(cell.camera(), MarkerFamily.SQUARE_BINARY, change.apply(new ArrayList<>(cell.references())),
                cell.objects(), cell.pixelStdPx(), cell.targetStdMm());
    }

    private static Cell withEach(UnaryOperator<Reference> change) {
        return with(references -> {
            references.replaceAll(change);
            return references;
        });
    }

    private static Reference at(Reference r, RigidTransform pose) {
        return new Reference(r.id(), r.sizeMm(), pose, r.placement());
    }

    private static RigidTransform turned(Reference r, double degrees) {
        return r.worldFromMarker().compose(RigidTransform.ofEuler(0, 0, 0, 0, 0, Math.toRadians(degrees)));
    }

    private static ReferenceCheck check(Cell cell) {
        return CellCheck.quickLook(cell, photo(), CheckSettings.builder().build(), null).referenceCheck();
    }

    private static Explanation named(Cell cell, Cause cause) {
        ReferenceCheck check = check(cell);
        assertFalse(check.causes().isEmpty(), cause + ": " + check.warnings());
        Explanation best = check.causes().get(0);
        assertEquals(cause, best.cause(), check.warnings().toString());
        assertEquals(best.warning(), check.warnings().get(0), "it is said first");
        assertTrue(check.contradicted(), "no target is met");
        return best;
    }

    @Test
    void aCellAsStatedIsSilent() {
        assertTrue(check(scene().cell()).warnings().isEmpty());
    }

    /** Printed at 47 mm, stated as 46 or as 40: larger by 1/46 and by 7/40. */
    @ParameterizedTest
    @CsvSource({"46", "40", "49"})
    void markersOfAnotherSizeAreToldByHowMuch(double statedMm) {
        Explanation best = check(withEach(r -> new Reference(r.id(), statedMm, r.worldFromMarker(), r.placement())))
                .causes().get(0);
        double larger = 47 / statedMm - 1;
        if (Math.abs(larger) > 0.15) {
            // no printer errs so: positions in proportion
            assertEquals(Cause.POSITION_SCALE, best.cause());
            assertEquals(statedMm / 47, best.size()[0], 0.01);
            assertEquals(Cause.MARKER_SIZE, best.orInstead().get(0).cause());
        } else {
            assertEquals(Cause.MARKER_SIZE, best.cause());
            assertEquals(larger, best.size()[0], Math.max(3 * best.std(), 0.003));
            assertTrue(best.warning().toString().matches("as if all markers were [0-9.]+ % " + (larger > 0 ? "larger"
                    : "smaller") + " than " + (int) statedMm + " mm .*: measure the black square .*"),
                    best.warning().toString());
        }
    }

    /** One raised reference alone tells a focal length, and its own height looks nearly alike: both are said. */
    @Test
    void aFocalLengthThatIsOffIsAmongWhatIsSaid() {
        String first = check(scene().cell().withCamera(ThesisScene.CAMERA.withFocal(520, 520))).warnings().get(0)
                .toString();
        assertTrue(first.contains("focal length"), first);
    }

    @Test
    void aStretchedDrawingIsToldAlongWhichAxis() {
        Explanation best = named(withEach(r -> {
            double[] t = r.worldFromMarker().translationMm();
            t[0] /= 1.06;
            return at(r, RigidTransform.of(r.worldFromMarker().rotation(), t));
        }), Cause.STRETCH);
        assertEquals(0, best.axis());
        assertEquals(0.06, best.size()[0], Math.max(3 * best.std(), 0.004));
    }

    @Test
    void twoReferencesExchangedAreNamed() {
        Explanation best = named(exchanged(), Cause.EXCHANGED);
        assertEquals(Arrays.asList(911, 944), sorted(best.references()));
        assertTrue(check(exchanged()).contradictory());
    }

    private static Cell exchanged() {
        return withEach(r -> r.id() == 944 || r.id() == 911 ? at(r, scene().cell().references().stream()
                .filter(o -> o.id() == (r.id() == 944 ? 911 : 944)).findFirst().get().worldFromMarker()) : r);
    }

    private static List<Integer> sorted(List<Integer> ids) {
        List<Integer> out = new ArrayList<>(ids);
        out.sort(null);
        return out;
    }

    /** Markers hang upright; the file has them turned the other way. */
    @ParameterizedTest
    @CsvSource({"90", "180", "270"})
    void turnsOfOneAndOfAllAreNamed(int degrees) {
        Explanation all = named(withEach(r -> at(r, turned(r, -degrees))), Cause.ALL_TURNED);
        assertEquals(degrees / 90, all.size()[0]);
        Explanation one = named(withEach(r -> r.id() == 22 ? at(r, turned(r, -degrees)) : r), Cause.TURNED);
        assertEquals(Arrays.asList(22), one.references());
        assertEquals(degrees / 90, one.size()[0]);
    }

    @ParameterizedTest
    @CsvSource({"1", "2"})
    void aMirroredAxisIsNamed(int axis) {
        assertEquals(axis, named(withEach(r -> {
            double[] t = r.worldFromMarker().translationMm();
            t[axis] = -t[axis];
            return at(r, RigidTransform.of(r.worldFromMarker().rotation(), t));
        }), Cause.MIRRORED).axis());
    }

    @ParameterizedTest
    @CsvSource({"10", "25.4", "1000"})
    void positionsInAnotherUnitAreNamed(double mm) {
        assertEquals(mm, named(withEach(r -> {
            double[] t = r.worldFromMarker().translationMm();
            return at(r, RigidTransform.of(r.worldFromMarker().rotation(),
                    new double[] {t[0] / mm, t[1] / mm, t[2] / mm}));
        }), Cause.POSITION_UNIT).size()[0]);
    }

    /** Markers of 47 mm stated as 4.7, 1.85 or 0.047: no camera pose fits the references as stated. */
    @ParameterizedTest
    @CsvSource({"10", "25.4", "1000"})
    void sizesInAnotherUnitAreNamedAlthoughNoPoseFits(double mm) {
        Cell cell = withEach(r -> new Reference(r.id(), r.sizeMm() / mm, r.worldFromMarker(), r.placement()));
        assertEquals(mm, named(cell, Cause.SIZE_UNIT).size()[0]);
        CheckResult result = run(cell);
        assertEquals(Verdict.CONTRADICTED, result.verdict());
        assertTrue(result.reason().contains("state size_mm in millimetres"), result.reason());
    }

    /** Every reference somewhere else: no single cause moves them so. */
    @Test
    void whatNothingExplainsHasNoFigure() {
        Cell cell = with(references -> {
            List<Reference> changed = new ArrayList<>();
            for (int m = 0; m < references.size(); m++) {
                double[] t = references.get(m).worldFromMarker().translationMm();
                t[m % 2] += m % 3 == 0 ? 90 : -60 - 20 * m;
                changed.add(at(references.get(m), RigidTransform.ofEuler(t[0], t[1], t[2], 0, 0, m)));
            }
            return changed;
        });
        ReferenceCheck check = check(cell);
        assertTrue(check.contradictory());
        assertTrue(check.causes().isEmpty(), check.causes().toString());
        CheckResult result = run(cell);
        assertEquals(Verdict.CONTRADICTED, result.verdict());
        assertTrue(result.reason().startsWith("No figure: the references contradict each other"), result.reason());
    }

    @Test
    void exchangedReferencesHaveNoFigureAndOneAction() {
        CheckResult result = run(exchanged());
        assertEquals(Verdict.CONTRADICTED, result.verdict());
        assertTrue(result.action().toString().matches("references (911 and 944|944 and 911) seem exchanged.*"),
                result.action().toString());
        assertTrue(result.reason().contains("seem exchanged"), result.reason());
        assertEquals(result.action(), result.warnings().get(0));
        for (Verdict verdict : Verdict.values()) {
            assertEquals(verdict == Verdict.PASS || verdict == Verdict.FAIL || verdict == Verdict.NO_TARGET,
                    verdict.isTrusted());
        }
    }

    private static CheckResult run(Cell cell) {
        return CellCheck.run(cell, photo(), CheckSettings.builder().set(SettingTable.CHAINS, 2)
                .set(SettingTable.ITERATIONS, java.util.OptionalInt.of(300)).build());
    }

    @Test
    void aCellWithoutObjectsHasNothingToJudge() {
        Cell cell = scene().noObjects().cell();
        CheckResult result = CellCheck.run(cell, photo(), CheckSettings.builder().build());
        assertEquals(Verdict.NO_TARGET, result.verdict());
        assertTrue(result.reason().contains("nothing to judge"), result.reason());
    }

    @Test
    void aPhotoWithoutAnyObjectMissesItsTarget() {
        Detections none = ThesisScene.oneRaised(5).noObjects().exactDetections();
        assertEquals(Verdict.FAIL, CellCheck.run(scene().cell(), none, CheckSettings.builder().build()).verdict());
    }

    /** A few cells of the study whose table is in the docs; its counts of many are there. */
    @ParameterizedTest
    @CsvSource({"EDGE_SHIFT", "EXCHANGED", "RADIANS", "SIZE_UNIT", "SIZE_OF_SOME", "PRINCIPAL_POINT", "DISTORTION"})
    void theStudyNamesWhatIsWrong(Cause cause) {
        CauseStudy.Figures figures = new CauseStudy(RandomLayouts.withDrawnNoise(MarkerFamily.SQUARE_BINARY), cause, 5,
                10, true, CheckSettings.builder().seed(2).build()).run(4, done -> { });
        assertTrue(figures.first() >= 0.75 * figures.cells() && figures.cells() > (cause.isOutright() ? 3 : 1),
                cause + ": " + figures.first() + " of " + figures.cells() + ", instead " + figures.instead());
    }
}
