package org.cellgauge.internal.calibration;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.cellgauge.calibration.Calibration;
import org.cellgauge.calibration.CalibrationOptions;
import org.cellgauge.calibration.CalibrationRefusal;
import org.cellgauge.calibration.CalibrationResult;
import org.cellgauge.calibration.CalibrationWarning;
import org.cellgauge.cell.CameraCalibration;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.cell.MarkerFamily;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.KannalaBrandtLens;
import org.cellgauge.geometry.Lens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RationalLens;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.vision.TargetObservation;
import org.cellgauge.vision.TargetPoints;
import org.junit.jupiter.api.Test;

/** Calibrations of a camera that is known, from corners drawn with noise that is known. */
class CameraCalibratorTest {
    private static final double NOISE_PX = 0.2;
    private static final CalibrationStudy STUDY = new CalibrationStudy(NOISE_PX, 5);

    private static boolean warns(CalibrationResult result, CalibrationWarning kind) {
        return result.warnings().stream().anyMatch(w -> w.kind() == kind);
    }

    private static CalibrationResult calibrate(List<TargetObservation> photos) {
        return Calibration.of(STUDY.points(), photos, CalibrationOptions.USUAL.withLens("brown-4").withWarp(0)
                .withAspect(CalibrationOptions.Aspect.STATED));
    }

    private static TargetObservation changed(TargetObservation photo, double[] uv) {
        return new TargetObservation(photo.name(), photo.widthPx(), photo.heightPx(), photo.points(), uv);
    }

    /** 16 calibrations: rms errors vary by a sixth; deviations wrong by the half would be seen. */
    @Test
    void errorsAreAsLargeAsStated() {
        CalibrationStudy.Outcome outcome = STUDY.run(CalibrationStudy.Scene.GOOD, 16, done -> { });
        outcome.ratios().forEach(r -> assertEquals(1, r, 0.5));
        outcome.places().forEach(r -> assertEquals(1, r, 0.5));
        CalibrationStudy.Outcome bent = STUDY.run(CalibrationStudy.Scene.BENT_TAKEN_FOR_FLAT, 4, done -> { });
        assertTrue(bent.ratios().get(0) > 3, "a bent board that is taken for flat: " + bent.ratios());
    }

    @Test
    void findsCameraNoiseAndLens() {
        CalibrationResult result = calibrate(STUDY.photos(CalibrationStudy.Scene.GOOD, 0));
        double[] truth = STUDY.truth();
        assertEquals("brown-4", result.lens());
        assertEquals(List.of("fx_px", "fy_px", "cx_px", "cy_px", "k1", "k2", "p1", "p2"),
                result.parameters().stream().map(CalibrationResult.Parameter::name).toList());
        int[] index = {0, 1, 2, 3, 5, 6, 8, 9};
        for (int k = 0; k < index.length; k++) {
            CalibrationResult.Parameter p = result.parameters().get(k);
            assertEquals(truth[index[k]], p.value(), 4 * p.std(), p.name());
            assertEquals(p.std() * p.std(), result.covariance().get(k).get(k), 1e-9 * p.std() * p.std());
        }
        assertEquals(NOISE_PX, result.figures().noisePx(), 0.02);
        assertEquals(NOISE_PX * Math.sqrt(2), result.figures().rmsPx(), 0.03);
        assertEquals(0, result.figures().outliers());
        assertTrue(result.figures().crossRatio() < 2);
        assertFalse(result.inQuestion());
        // 2 atan(640 / 900) and the pull of the lens' barrel distortion, by hand: r (1 - 0.2 r² + 0.08 r⁴) = 0.711
        assertEquals(76.5, result.figures().horizontalDeg(), 0.5);
    }

    /** Bent by 0.5 mm over 300 mm across its columns: photos held out tell. */
    @Test
    void findsThatTheBoardIsBent() {
        CalibrationResult result = calibrated(STUDY.points(), STUDY.photos(CalibrationStudy.Scene.BENT, 0));
        CalibrationResult.Parameter warp = result.board().get(0);
        assertEquals("warp_1_mm", warp.name());
        assertEquals(0.5, Math.abs(warp.value()), 5 * warp.std());
        assertTrue(warp.std() < 0.05, "std " + warp.std());
        CalibrationResult.Parameter focal = result.parameters().get(0);
        assertEquals(STUDY.truth()[0], focal.value(), 4 * focal.std());
    }

    /** Odd and even photos show the same board and err alike: they do not tell. */
    @Test
    void aBentBoardThatIsTakenForFlatIsTold() {
        for (int s = 0; s < 2; s++) {
            CalibrationResult bent = calibrate(STUDY.photos(CalibrationStudy.Scene.BENT, s));
            assertTrue(warns(bent, CalibrationWarning.BENT), "bent, " + s);
            assertFalse(warns(calibrate(STUDY.photos(CalibrationStudy.Scene.GOOD, s)), CalibrationWarning.BENT));
            assertFalse(warns(calibrated(STUDY.points(), STUDY.photos(CalibrationStudy.Scene.BENT, s)),
                    CalibrationWarning.BENT), "its warp is unknown, " + s);
        }
    }

    /** Two lenses between which photos do not decide: the moments of both, about the values of the one. */
    @Test
    void whatAChoiceLeavesOpenIsInTheCovariance() {
        List<LensChoice> ladder = LensChoice.ladder();
        List<TargetObservation> photos = STUDY.photos(CalibrationStudy.Scene.GOOD, 0);
        CalibrationFit lean = CalibrationFit.of(ladder.get(1), STUDY.points(), photos, 0, false);
        CalibrationFit rich = lean.ofPhotos(ladder.get(2), lean.board, IntStream.range(0, photos.size()).boxed()
                .toList());
        // by the squared ratio of odd and even photos, the difference counts for a quarter
        List<ModelAverage.Trial> trials = List.of(new ModelAverage.Trial(ladder.get(1), lean.board, 100),
                new ModelAverage.Trial(ladder.get(2), lean.board, 100 + 8 * Math.log(3)));
        ModelAverage average = new ModelAverage(lean, lean.covariance, trials, 2);
        assertEquals(0.75, average.weight(ladder.get(1)), 1e-12);
        assertEquals(8, average.choice.unknowns());
        double shift = rich.values[0] - lean.values[0];
        double fx = 0.75 * lean.covariance[0] + 0.25 * (rich.covariance[0] + shift * shift);
        assertEquals(fx, average.covariance[0], 1e-6 * fx);
        double p1 = 0.25 * (rich.covariance[6 * 9] + rich.values[8] * rich.values[8]);
        assertEquals(p1, average.covariance[6 * 9], 1e-6 * p1);
        assertEquals(0, average.weight(ladder.get(0)), 0, "was not tried");
        LensChoice other = ladder.get(4);
        assertNotEquals(lean.choice.lens(), other.lens());
        assertEquals(1, new ModelAverage(lean, lean.covariance, List.of(trials.get(0),
                new ModelAverage.Trial(other, lean.board, 90)), 1).weight(lean.choice), 0, "another model");
        ModelAverage alone = new ModelAverage(lean, lean.covariance, List.of(), Double.NaN);
        assertEquals(lean.covariance[7], alone.covariance[7], 0);
    }

    @Test
    void aSimulatedCellGetsACameraThatIsFoundAndHowWell() {
        PinholeCamera truth = PinholeCamera.ideal(1280, 720, 581, 581, 640, 360);
        Cell cell = new Cell(truth, MarkerFamily.SQUARE_BINARY, List.of(new Reference(1, 47,
                RigidTransform.ofEuler(0, 0, 0, 0, 0, 0), new Placement(1, 1, 1, 0.01))), List.of(),
                OptionalDouble.of(0.1), OptionalDouble.empty());
        Cell known = CalibrationStudy.calibrated(cell, 20, NOISE_PX, 7);
        CameraCalibration calibration = known.calibration();
        assertNotNull(calibration);
        assertEquals(20, calibration.photos());
        for (int k = 0; k < 4; k++) {
            double error = known.camera().get(k) - truth.get(k);
            assertTrue(error != 0);
            assertEquals(0, error, 4 * calibration.std(k), calibration.parameters().get(k));
            assertTrue(calibration.std(k) < 1, "20 photos tell it");
        }
    }

    @Test
    void leavesOutCornersThatAreFarOff() {
        List<TargetObservation> photos = new ArrayList<>(STUDY.photos(CalibrationStudy.Scene.GOOD, 1));
        double[] uv = photos.get(3).uvPx();
        uv[10] += 4;
        uv[21] -= 3;
        photos.set(3, changed(photos.get(3), uv));
        CalibrationResult result = calibrate(photos);
        assertEquals(2, result.residuals().stream()
                .filter(r -> r.photo() == 3 && r.outlier() && Math.hypot(r.du(), r.dv()) > 2).count());
        assertTrue(result.figures().outliers() <= 6, result.figures().outliers() + " left out");
        assertTrue(warns(result, CalibrationWarning.OUTLIERS));
        assertFalse(result.inQuestion());
    }

    /** A third of one photo in ten moved: more than 3 in 100 corners. */
    @Test
    void isInQuestionWhereTooMuchIsLeftOut() {
        List<TargetObservation> photos = new ArrayList<>(STUDY.photos(CalibrationStudy.Scene.GOOD, 2));
        for (int p = 0; p < 3; p++) {
            double[] uv = photos.get(p).uvPx();
            for (int i = 0; i < uv.length / 3; i++) {
                uv[i] += 6 + i % 5;
            }
            photos.set(p, changed(photos.get(p), uv));
        }
        CalibrationResult result = calibrate(photos);
        assertTrue(result.inQuestion());
        assertTrue(warns(result, CalibrationWarning.IN_QUESTION));
        assertEquals(List.of("photo 0", "photo 1", "photo 2"), result.photos().stream()
                .filter(CalibrationResult.Photo::contradicts).map(CalibrationResult.Photo::name).toList());
    }

    /** Every other photo at another zoom: two cameras in one. */
    @Test
    void oddAndEvenPhotosTellAModelError() {
        List<TargetObservation> photos = new ArrayList<>(STUDY.photos(CalibrationStudy.Scene.GOOD, 3));
        for (int p = 1; p < photos.size(); p += 2) {
            double[] uv = photos.get(p).uvPx();
            for (int i = 0; i < uv.length; i += 2) {
                double x = (uv[i] - 640) / 640;
                uv[i] += 0.8 * x * x * x;
            }
            photos.set(p, changed(photos.get(p), uv));
        }
        CalibrationResult result = calibrate(photos);
        assertTrue(warns(result, CalibrationWarning.MODEL_ERROR));
        assertEquals(result.figures().crossRatio(), result.widenedBy());
        assertTrue(result.widenedBy() > 2);
    }

    /** Photos of points through a lens that is known, from all around. */
    private static List<TargetObservation> seen(TargetPoints points, Lens lens, double[] values, int photos,
            double distanceMm) {
        SplittableRandom random = new SplittableRandom(11);
        double[] xyz = points.xyzMm();
        List<TargetObservation> out = new ArrayList<>();
        while (out.size() < photos) {
            RigidTransform pose = RigidTransform.ofEuler(distanceMm * (random.nextDouble() - 0.5),
                    distanceMm * (random.nextDouble() - 0.5) / 2, distanceMm * (0.8 + 0.5 * random.nextDouble()),
                    Math.PI + 1.4 * (random.nextDouble() - 0.5), 1.4 * (random.nextDouble() - 0.5),
                    2 * (random.nextDouble() - 0.5));
            double[] uv = new double[2 * points.count()];
            boolean whole = true;
            for (int i = 0; i < points.count(); i++) {
                double[] p = pose.apply(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
                whole &= lens.project(values, p[0], p[1], p[2], uv, 2 * i) && uv[2 * i] > 0 && uv[2 * i] < 1280
                        && uv[2 * i + 1] > 0 && uv[2 * i + 1] < 720;
                uv[2 * i] += NOISE_PX * random.nextGaussian();
                uv[2 * i + 1] += NOISE_PX * random.nextGaussian();
            }
            if (whole) {
                out.add(new TargetObservation("photo " + out.size(), 1280, 720,
                        IntStream.range(0, points.count()).toArray(), uv));
            }
        }
        return out;
    }

    private static void assertFound(double[] truth, CalibrationResult result, double mostStdPx) {
        for (int k = 0; k < 4; k++) {
            CalibrationResult.Parameter p = result.parameters().get(k);
            assertEquals(truth[k], p.value(), 4.5 * p.std(), p.name());
            assertTrue(p.std() < mostStdPx, p.name() + " +- " + p.std());
        }
    }

    @Test
    void findsAFisheye() {
        double[] truth = new double[KannalaBrandtLens.MODEL.parameterCount()];
        System.arraycopy(new double[] {420, 421, 648, 355, 0, 0.03, -0.01}, 0, truth, 0, 7);
        List<TargetObservation> photos = seen(STUDY.points(), KannalaBrandtLens.MODEL, truth, 12, 260);
        assertFound(truth, Calibration.of(STUDY.points(), photos, CalibrationOptions.USUAL.withLens("fisheye")
                .withWarp(0).withAspect(CalibrationOptions.Aspect.STATED)), 2);
    }

    /** A lens as of a depth camera. */
    @Test
    void findsARationalLens() {
        double[] truth = new double[RationalLens.PARAMETERS];
        System.arraycopy(new double[] {605, 606, 648, 355, 0, 0.52, -2.4, 1.5, 0.4, -2.3, 1.42, 9e-4, -3e-4}, 0, truth,
                0, 13);
        List<TargetObservation> photos = seen(STUDY.points(), RationalLens.MODEL, truth, 24, 300);
        CalibrationOptions plain = CalibrationOptions.USUAL.withWarp(0).withAspect(CalibrationOptions.Aspect.STATED);
        CalibrationResult result = Calibration.of(STUDY.points(), photos, plain.withLens("rational-8"));
        assertFound(truth, result, 2);
        assertEquals(RationalLens.MODEL, result.camera().lens());
        // coefficients trade with each other: what counts is where the lens sees things
        double[] uv = new double[2];
        for (int i = -4; i <= 4; i++) {
            assertTrue(RationalLens.MODEL.project(truth, 220 * i, 100 * i, 1000, uv, 0));
            assertArrayEquals(uv, result.camera().project(220 * i, 100 * i, 1000), 1.5, "at " + i);
        }
        CalibrationResult prism = Calibration.of(STUDY.points(), photos, plain.withLens("prism-12"));
        assertEquals(16, prism.parameters().size());
        assertTrue(prism.figures().rmsPx() <= result.figures().rmsPx() + 1e-9, "a richer lens fits no worse");
    }

    /**
     * Few photos of the middle of the image: with a quotient of polynomials, numerator and denominator cancel over all
     * that they show, and photos held out are explained no worse.
     */
    @Test
    void aQuotientThatPhotosDoNotTellIsNotChosen() {
        CalibrationStudy study = new CalibrationStudy(0.2, 1);
        CalibrationResult result = Calibration.of(study.points(), study.photos(CalibrationStudy.Scene.POOR_CHOSEN, 9),
                CalibrationOptions.USUAL);
        assertEquals(BrownLens.MODEL, result.camera().lens());
        CalibrationResult.Parameter k1 = result.parameters().stream().filter(p -> p.name().equals("k1")).findFirst()
                .orElseThrow();
        assertEquals(study.truth()[BrownLens.MODEL.parameterNames().indexOf("k1")], k1.value(), 4 * k1.std());
    }

    /** Six markers about a cell, two of them raised and turned: no plane holds them. */
    @Test
    void findsTheCameraFromReferencesOfACell() {
        List<TargetPoints.Patch> patches = new ArrayList<>();
        double[] xyz = new double[72];
        for (int m = 0; m < 6; m++) {
            RigidTransform place = RigidTransform.ofEuler(250 * (m % 3 - 1), 150 * (m / 3 * 2 - 1), m % 2 * 120, 0,
                    m % 2 * 0.4, 0.3 * m);
            patches.add(new TargetPoints.Patch(place, 4 * m, 4));
            System.arraycopy(MarkerGeometry.cornersMm(place, 80), 0, xyz, 12 * m, 12);
        }
        double[] truth = STUDY.truth();
        TargetPoints points = new TargetPoints(xyz, patches, true);
        List<TargetObservation> photos = seen(points, BrownLens.MODEL, truth, 10, 900);
        assertFound(truth, calibrated(points, photos), 5);
    }

    private static CalibrationResult calibrated(TargetPoints points, List<TargetObservation> photos) {
        return Calibration.of(points, photos, CalibrationOptions.USUAL.withLens("brown-4"));
    }

    @Test
    void saysWhatToPhotographWhereThereIsTooLittle() {
        List<TargetObservation> photos = STUDY.photos(CalibrationStudy.Scene.GOOD, 4);
        InputRefusedException few = assertThrows(InputRefusedException.class, () -> calibrate(photos.subList(0, 2)));
        assertEquals(CalibrationRefusal.TOO_FEW_PHOTOS, few.refusal().kind());
        // one photo eight times over tells no focal length
        TargetObservation one = STUDY.photos(CalibrationStudy.Scene.POOR, 0).get(0);
        double[] facing = one.uvPx();
        double[] xyz = STUDY.points().xyzMm();
        for (int i = 0; i < one.count(); i++) {
            facing[2 * i] = 640 + xyz[3 * i];
            facing[2 * i + 1] = 360 + xyz[3 * i + 1];
        }
        List<TargetObservation> same = new ArrayList<>();
        for (int p = 0; p < 8; p++) {
            double[] uv = facing.clone();
            for (int i = 0; i < uv.length; i++) {
                uv[i] += 0.05 * Math.sin(17 * i + p);
            }
            same.add(changed(one, uv));
        }
        InputRefusedException flat = assertThrows(InputRefusedException.class, () -> calibrate(same));
        assertTrue(List.of(CalibrationRefusal.FOCAL_UNKNOWN, CalibrationRefusal.FOCAL_TOO_UNSURE)
                .contains(flat.refusal().kind()), flat.getMessage());
        TargetObservation small = new TargetObservation("small.png", 640, 360, photos.get(0).points(),
                Arrays.stream(photos.get(0).uvPx()).map(v -> v / 2).toArray());
        List<TargetObservation> mixed = new ArrayList<>(photos);
        mixed.add(small);
        InputRefusedException sizes = assertThrows(InputRefusedException.class, () -> calibrate(mixed));
        assertEquals(CalibrationRefusal.SIZES_DIFFER, sizes.refusal().kind());
        assertTrue(sizes.getMessage().contains("small.png"), sizes.getMessage());
    }
}
