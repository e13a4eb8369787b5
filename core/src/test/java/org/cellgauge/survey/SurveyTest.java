package org.cellgauge.survey;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import io.reactivex.rxjava3.core.Flowable;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ChangeKind;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.JointPlacement;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.Measurement;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.PlacementGroup;
import org.cellgauge.cell.PrintPrecision;
import org.cellgauge.cell.Reference;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.SurveyedPlacement;
import org.cellgauge.cell.Target;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.Conformity;
import org.cellgauge.estimate.PointEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.validation.SimulatedSurvey;
import org.cellgauge.internal.validation.SurveyStudy;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.statistics.Convergence;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.WarningKind;
import org.junit.jupiter.api.Test;

class SurveyTest {
    private static final PinholeCamera CAMERA = PinholeCamera.ideal(1280, 720, 900, 900, 640, 360);
    private static final CheckSettings SETTINGS = CheckSettings.builder().build();

    private static Cell cell(int references, int objects, double stdMm) {
        List<Reference> placed = new ArrayList<>();
        for (int i = 0; i < references; i++) {
            double angle = 2 * Math.PI * i / references;
            placed.add(new Reference(100 + i, 60, RigidTransform.ofEuler(350 * Math.cos(angle),
                    250 * Math.sin(angle), i % 3 == 0 ? 100 : 0, 0, 0, 0),
                    new Placement(stdMm, stdMm, stdMm, Math.toRadians(0.5))));
        }
        List<ObjectMarker> seen = new ArrayList<>();
        for (int i = 0; i < objects; i++) {
            seen.add(new ObjectMarker(i + 1, 60, i % 2 == 0 ? new double[] {0, 0, 100} : null));
        }
        return new Cell(CAMERA, MarkerFamily.SQUARE_BINARY, placed, seen, OptionalDouble.of(0.3),
                OptionalDouble.of(1), new PrintPrecision(0, 0, 0));
    }

    private static boolean warns(SurveyResult result, WarningKind kind, String... words) {
        return result.warnings().stream().anyMatch(w -> {
            boolean all = w.kind() == kind;
            for (String word : words) {
                all &= w.toString().contains(word);
            }
            return all;
        });
    }

    private static Detections with(Detections photo, String name, MarkerObservation other) {
        List<MarkerObservation> markers = new ArrayList<>();
        photo.markers().forEach(m -> markers.add(m.id() == other.id() ? other : m));
        return new Detections(name, photo.widthPx(), photo.heightPx(), markers);
    }

    private static SimulatedSurvey simulated(Cell cell, int photos) {
        return SimulatedSurvey.of(cell, SETTINGS, photos, 7, 0);
    }

    @Test
    void regionsHoldTheTruth() {
        SurveyStudy.Result result = SurveyStudy.of(cell(4, 2, 5), SETTINGS, 3, 16, 1, 2, false);
        assertEquals(0, result.refused());
        assertTrue(result.falseAlarms() <= 2, "alarms " + result.falseAlarms());
        for (SurveyStudy.Figures f : result.figures()) {
            // 16 cells: one deviation of the mean square is up to a fifth of it
            assertEquals(f.dimension(), f.meanSquare(), 0.6 * f.dimension(), f.part().toString());
            assertTrue(f.held() >= 0.8 * f.regions(), f.part() + " " + f.held() + " of " + f.regions());
        }
    }

    /**
     * Corners to 0.01 px, as of sharp photos: things stand to each other to a hundredth of a millimetre, all together
     * to one. Straight proposals left no chain moving; the cell turned as a whole was stretched by them.
     */
    @Test
    void drawsOfSharpPhotosMove() {
        Cell cell = cell(4, 2, 1).withPixelStdPx(OptionalDouble.of(0.01));
        SurveyResult drawn = Survey.of(cell, SimulatedSurvey.of(cell, SETTINGS, 5, 3, 0).photos(), SETTINGS).sampled();
        SurveyRun run = drawn.run();
        assertNotNull(run);
        assertEquals(Convergence.CONVERGED, run.convergence());
        assertTrue(run.essPerThousand() >= 30, "effective draws " + run.essPerThousand());
        assertTrue(run.draws() <= 2000, "draws " + run.draws());
        assertEquals(1, run.worstRatio(), 0.12, "deviations of draws over those of the approximation");
    }

    /** Each advice is carried out: the cell stated so, or photographed so often, is surveyed anew. */
    @Test
    void whatIsAdvisedMeetsTheTarget() {
        Cell stated = cell(4, 1, 3);
        List<Detections> photos = simulated(stated, 4).photos();
        double now = Survey.of(stated, photos, SETTINGS).estimate().objects().get(0).worstStdMm();
        double target = 0.7 * now;
        Cell cell = stated.withTarget(OptionalDouble.of(target));
        assertEquals(List.of(), Survey.of(stated.withTarget(OptionalDouble.of(2 * now)), photos, SETTINGS).estimate()
                .advice());
        List<SurveyAdvice> advice = Survey.of(cell, photos, SETTINGS).estimate().advice();
        SurveyAdvice placed = advice.stream().filter(a -> a.change().kind() == ChangeKind.PLACE_PRECISELY).findFirst()
                .orElseThrow();
        double std = Double.parseDouble(String.valueOf(placed.change().arguments().get(0)));
        double found = Survey.of(cell(4, 1, std), simulated(cell(4, 1, std), 4).photos(), SETTINGS).estimate().objects()
                .get(0).worstStdMm();
        assertEquals(placed.worstStdMm(), found, 0.1 * found);
        assertTrue(found <= target && found > 0.7 * target, found + " of " + target);
        // what all references have in common, no photo tells
        assertTrue(advice.stream().noneMatch(a -> a.change().kind() == SurveyWarning.MORE_PHOTOS), advice.toString());
    }

    /** Objects that few pixels show: there more photos do. */
    @Test
    void morePhotosAreAdvisedWhereNoiseLimits() {
        Cell stated = cell(4, 1, 0.05).withPixelStdPx(OptionalDouble.of(1.5));
        List<Detections> photos = simulated(stated, 3).photos();
        double now = Survey.of(stated, photos, SETTINGS).estimate().objects().get(0).worstStdMm();
        SurveyAdvice more = Survey.of(stated.withTarget(OptionalDouble.of(0.7 * now)), photos, SETTINGS).estimate()
                .advice().get(0);
        assertEquals(SurveyWarning.MORE_PHOTOS, more.change().kind());
        int count = Integer.parseInt(String.valueOf(more.change().arguments().get(0)));
        double found = Survey.of(stated, simulated(stated, 3 + count).photos(), SETTINGS).estimate().objects().get(0)
                .worstStdMm();
        assertTrue(found <= 0.7 * now, count + " more: " + found + " of " + 0.7 * now);
    }

    /** By the normal distribution, of the deviation that is stated. */
    @Test
    void tolerancesAreCountedInTheDraws() {
        Cell cell = cell(4, 1, 2).withTarget(new Target(new Requirement(Requirement.Axes.NONE, Requirement.Axes.all(2),
                Double.POSITIVE_INFINITY, 0.8, 0.9), Map.of()));
        Survey survey = Survey.of(cell, simulated(cell, 4).photos(), SETTINGS);
        assertEquals(List.of(), survey.estimate().objects().get(0).conformities());
        SurveyedObject found = survey.sampled().objects().get(0);
        PointEstimate grip = found.grip();
        assertNotNull(grip);
        assertEquals(7, found.conformities().size(), "x, y, z, turn, and the gripping point's");
        NormalDistribution normal = new NormalDistribution(null, 0, 1);
        for (int i = 0; i < 7; i++) {
            if (i == 3) {
                continue;
            }
            Conformity c = found.conformities().get(i);
            double std = i < 3 ? found.pose().std()[i] : grip.stdMm()[i - 4];
            assertEquals(0.9, c.asked());
            assertEquals(2 * normal.cumulativeProbability(2 / std) - 1, c.probability(), 4 * c.mcse() + 0.005,
                    c.of() + " of " + std);
        }
        Conformity turn = found.conformities().get(3);
        assertEquals(Conformity.Of.TURN, turn.of());
        // a turn is within the limit if it is about every axis: at most as often as about the worst one
        double worst = Math.toDegrees(Math.sqrt(Math.max(found.pose().tangentCovariance()[3][3],
                Math.max(found.pose().tangentCovariance()[4][4], found.pose().tangentCovariance()[5][5]))));
        assertTrue(turn.probability() < 2 * normal.cumulativeProbability(0.8 / worst) - 1 + 4 * turn.mcse());
        assertTrue(turn.probability() > 0.1);
    }

    /** Draws and Laplace's approximation are two ways to one posterior. */
    @Test
    void drawsConfirmTheApproximation() {
        Cell cell = cell(4, 2, 5);
        Survey survey = Survey.of(cell, simulated(cell, 4).photos(), SETTINGS);
        SurveyResult drawn = survey.sampled();
        SurveyResult predicted = survey.estimate();
        SurveyRun run = drawn.run();
        assertNotNull(run);
        assertTrue(run.essPerThousand() >= 30, "effective draws " + run.essPerThousand());
        for (int o = 0; o < 2; o++) {
            double[] a = drawn.objects().get(o).pose().std();
            double[] b = predicted.objects().get(o).pose().std();
            for (int i = 0; i < 6; i++) {
                assertEquals(1, a[i] / b[i], 0.1, "object " + o + ", " + i);
            }
        }
        assertEquals(1, drawn.objects().get(0).shares().values().stream().mapToDouble(x -> x).sum(), 1e-9);
        CheckSettings one = CheckSettings.builder().threads(1).build();
        double[] again = Survey.of(cell, simulated(cell, 4).photos(), one).sampled().objects().get(0).pose().std();
        assertEquals(drawn.objects().get(0).pose().std()[0], again[0], 0, "threads change no figure");
    }

    /** One photo is a survey too, with errors of placement as unknowns; the check has them integrated out. */
    @Test
    void onePhotoSaysWhatACheckSays() {
        Cell stated = cell(4, 1, 2);
        Cell grouped = stated.withJointPlacement(new JointPlacement(List.of(new PlacementGroup("plate",
                List.of(100, 101, 102), new Placement(10, 5, 3, 0.01))), List.of(), null, null));
        Cell surveyed = Survey.of(stated, simulated(stated, 5).photos(), SETTINGS).estimate().surveyedCell();
        for (Cell cell : List.of(stated, grouped, surveyed)) {
            Detections photo = simulated(cell, 1).photos().get(0);
            SurveyResult survey = Survey.of(cell, SETTINGS).with(photo).estimate();
            assertTrue(warns(survey, SurveyWarning.ONE_PHOTO));
            PoseEstimate check = CellCheck.quickLook(cell, photo, SETTINGS, null).update().estimate().objects().get(0)
                    .pose();
            PoseEstimate same = survey.objects().get(0).pose();
            for (int i = 0; i < 3; i++) {
                assertEquals(1, check.std()[i] / same.std()[i], 0.05, "axis " + i);
                assertEquals(same.mean()[i], check.mean()[i], 0.15 * same.std()[i], "axis " + i);
            }
        }
    }

    @Test
    void photosOneByOneLeadWhereAllAtOnceDo() {
        Cell cell = cell(4, 2, 5);
        List<Detections> photos = simulated(cell, 6).photos();
        SurveyResult all = Survey.of(cell, photos, SETTINGS).estimate();
        SurveyResult last = Survey.stream(cell, Flowable.fromIterable(photos), SETTINGS).blockingLast().estimate();
        double[] a = all.objects().get(0).pose().mean();
        double[] b = last.objects().get(0).pose().mean();
        for (int i = 0; i < 3; i++) {
            assertEquals(a[i], b[i], 0.01 * all.objects().get(0).pose().std()[i]);
        }
        List<Double> curve = all.objects().get(0).worstStdMmByPhotos();
        assertEquals(6, curve.size());
        assertTrue(curve.get(5) < curve.get(0), "more photos tell more");
        assertTrue(all.objects().get(0).nextWorstStdMm() <= curve.get(5));
    }

    @Test
    void whatDoesNotFitIsNamed() {
        Cell cell = cell(6, 2, 3);
        List<Detections> photos = new ArrayList<>(simulated(cell, 8).photos());
        SurveyResult right = Survey.of(cell, photos, SETTINGS).estimate();
        assertTrue(right.warnings().isEmpty(), right.warnings().toString());
        Detections third = photos.get(2);
        double[] corners = third.find(2).cornersPx();
        for (int i = 0; i < 8; i += 2) {
            corners[i] += 4;
        }
        photos.set(2, with(third, "moved", new MarkerObservation(2, corners)));
        Survey moved = Survey.of(cell, photos, SETTINGS);
        assertTrue(warns(moved.estimate(), SurveyWarning.PHOTO_DOES_NOT_FIT, "moved", "marker 2"),
                moved.estimate().warnings().toString());
        SurveyResult left = moved.withoutMisfits().estimate();
        assertEquals(7, left.used());
        assertFalse(left.photos().get(2).used());

        List<Reference> elsewhere = new ArrayList<>(cell.references());
        Reference first = elsewhere.get(1);
        elsewhere.set(1, new Reference(first.id(), 60, first.worldFromMarker().displaced(new double[] {30, 0, 0},
                new double[3]), first.placement()));
        SurveyResult off = Survey.of(cell.withReferences(elsewhere), simulated(cell, 8).photos(), SETTINGS).estimate();
        assertTrue(warns(off, SurveyWarning.REFERENCE_OFF, "reference 101"), off.warnings().toString());
        assertEquals(1, off.references().stream().filter(SurveyedReference::misplaced).count());
    }

    @Test
    void photosThatCannotBeUsedStopNoOther() {
        Cell cell = cell(4, 2, 5);
        SimulatedSurvey simulated = simulated(cell, 3);
        List<Detections> photos = new ArrayList<>(simulated.photos());
        Detections first = photos.get(0);
        photos.add(new Detections("other camera", 640, 480, first.markers()));
        photos.add(new Detections("again", 1280, 720, first.markers()));
        photos.add(new Detections("empty", 1280, 720, List.of()));
        Detections fourth = SimulatedSurvey.of(cell, SETTINGS, 4, 7, 0).photos().get(3);
        photos.add(new Detections("objects only", 1280, 720,
                fourth.markers().stream().filter(m -> m.id() < 100).toList()));
        SurveyResult result = Survey.of(cell, photos, SETTINGS).estimate();
        assertTrue(warns(result, SurveyWarning.OTHER_SIZE, "other camera", "640 x 480"));
        assertTrue(warns(result, SurveyWarning.SAME_PHOTO, "again", "photo-1"));
        assertTrue(warns(result, SurveyWarning.NOT_LINKED, "empty"));
        assertTrue(result.photos().get(6).used(), "objects link it to the others");
        assertEquals(4, result.used());
        assertThrows(InputRefusedException.class, () -> Survey.of(cell, photos.subList(3, 4), SETTINGS).estimate());
    }

    /** What is measured besides: one distance sets the scale of all, and one that is wrong is named. */
    @Test
    void measurementsCount() {
        Cell cell = cell(5, 1, 20);
        SimulatedSurvey simulated = simulated(cell, 10);
        double[] p = simulated.references().get(100).translationMm();
        double[] q = simulated.references().get(102).translationMm();
        double mm = Math.sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])
                + (p[2] - q[2]) * (p[2] - q[2]));
        SurveyResult without = Survey.of(cell, simulated.photos(), SETTINGS).estimate();
        SurveyResult with = Survey.of(cell.withJointPlacement(new JointPlacement(List.of(),
                List.of(new Measurement.Distance(100, 102, mm, 0.1)), null, null)), simulated.photos(), SETTINGS)
                .estimate();
        assertEquals(0.1, with.distance(100, 102).stdMm(), 0.01);
        assertTrue(with.distance(101, 103).stdMm() < 0.5 * without.distance(101, 103).stdMm());
        SurveyResult wrong = Survey.of(cell.withJointPlacement(new JointPlacement(List.of(), List.of(
                new Measurement.Distance(100, 102, mm, 0.1), new Measurement.Distance(101, 103, 100, 0.1)), null,
                null)), simulated.photos(), SETTINGS).estimate();
        assertTrue(warns(wrong, SurveyWarning.MEASUREMENT_OFF), wrong.warnings().toString());
    }

    /** Ten references that were placed by eye, a bar of half a metre over two of them, and a walk round. */
    @Test
    void oneScaleBarAndTwentyPhotosGiveHalfAMillimetre() {
        Cell cell = cell(10, 0, 20);
        int held = 0;
        int pairs = 0;
        for (int index = 0; index < 4; index++) {
            SimulatedSurvey simulated = SimulatedSurvey.of(cell, SETTINGS, 20, 11, index);
            // of all pairs the one that the bar spans best; the bar itself is off by one of its deviations
            int[] bar = {100, 101};
            for (int i = 100; i < 110; i++) {
                for (int j = i + 1; j < 110; j++) {
                    bar = Math.abs(apartMm(simulated, i, j) - 500) < Math.abs(apartMm(simulated, bar[0], bar[1]) - 500)
                            ? new int[] {i, j} : bar;
                }
            }
            SurveyResult result = Survey.of(cell.withJointPlacement(new JointPlacement(List.of(),
                    List.of(new Measurement.Distance(bar[0], bar[1],
                            apartMm(simulated, bar[0], bar[1]) + (index % 2 == 0 ? 0.1 : -0.1), 0.1)),
                    null, null)), simulated.photos(), SETTINGS).estimate();
            for (int i = 100; i < 110; i++) {
                for (int j = i + 1; j < 110; j++) {
                    SurveyedDistance distance = result.distance(i, j);
                    double error = Math.abs(distance.mm() - apartMm(simulated, i, j));
                    assertTrue(distance.stdMm() < 0.25, i + " to " + j + ": std " + distance.stdMm());
                    assertTrue(error < 0.5, i + " to " + j + ": off by " + error);
                    pairs++;
                    held += error < 1.96 * distance.stdMm() ? 1 : 0;
                }
            }
        }
        // 45 distances of a cell share its bar and its cameras, so their number is not that of independent ones
        assertTrue(held > 0.85 * pairs, held + " of " + pairs);
    }

    private static double apartMm(SimulatedSurvey simulated, int from, int to) {
        double[] p = simulated.references().get(from).translationMm();
        double[] q = simulated.references().get(to).translationMm();
        return Math.sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])
                + (p[2] - q[2]) * (p[2] - q[2]));
    }

    @Test
    void surveyedCellKeepsWhatIsKnownOfReferencesTogether() {
        Cell cell = cell(5, 1, 20);
        SurveyResult result = Survey.of(cell, simulated(cell, 6).photos(), SETTINGS).estimate();
        SurveyedPlacement placement = result.surveyedCell().joint().surveyed();
        assertEquals(result.placement(), placement);
        double alone = result.references().get(0).pose().std()[0];
        assertTrue(result.distance(100, 102).stdMm() < 0.3 * alone, "to each other they stand better");
    }
}
