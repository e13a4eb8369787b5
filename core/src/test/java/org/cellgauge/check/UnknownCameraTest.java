package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalDouble;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.InputRefusedException;
import org.cellgauge.estimate.IntrinsicsEstimate;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.InitialPose;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.output.ResultView;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.settings.InitialEstimate;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.vision.Detections;
import org.cellgauge.warning.CheckRefusal;
import org.cellgauge.warning.CheckWarning;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Cameras without a calibration: what a photo tells of them, and that no start leads elsewhere. */
class UnknownCameraTest {
    private static final double PIXEL_STD_PX = 0.05;
    private static final ThesisScene RAISED = ThesisScene.oneRaised(4).placement(1, 0.005).pixelStd(PIXEL_STD_PX);

    private static CheckSettings.Builder settings(long seed) {
        return CheckSettings.builder().seed(seed).iterations(1500).warmup(200);
    }

    /** Draws that count as independent, at least, of any figure of such a check. */
    private static double leastDraws(CheckResult result) {
        return result.diagnostics().essBulkMin();
    }

    /** Means and deviations agree within five Monte Carlo errors. */
    private static void assertAlike(double[] mean, double[] std, double[] otherMean, double[] otherStd, double draws) {
        for (int i = 0; i < mean.length; i++) {
            double error = Math.sqrt(2 / draws);
            assertEquals(mean[i], otherMean[i], 5 * error * std[i], "mean " + i);
            assertEquals(std[i], otherStd[i], 5 * error / Math.sqrt(2) * std[i], "std " + i);
        }
    }

    private static double[] std(IntrinsicsEstimate estimate) {
        double[] std = new double[estimate.names().size()];
        for (int i = 0; i < std.length; i++) {
            std[i] = Math.sqrt(estimate.covariance()[i][i]);
        }
        return std;
    }

    @ParameterizedTest
    @EnumSource(LikelihoodModel.class)
    void aWrongStartLeadsToTheSamePosterior(LikelihoodModel likelihood) {
        Cell cell = RAISED.cell();
        Detections photo = RAISED.detections(PIXEL_STD_PX, RandomStreams.of(7), 1, 0.005);
        CheckResult usual = run(cell, photo, likelihood, OptionalDouble.empty(), 1);
        IntrinsicsEstimate expected = usual.estimate().intrinsics();
        for (double focal : new double[] {250, 1200}) {
            CheckResult other = run(cell, photo, likelihood, OptionalDouble.of(focal), (long) focal);
            double draws = Math.min(leastDraws(usual), leastDraws(other));
            IntrinsicsEstimate found = other.estimate().intrinsics();
            assertAlike(expected.mean(), std(expected), found.mean(), std(found), draws);
            assertAlike(usual.estimate().camera().mean(), usual.estimate().camera().std(),
                    other.estimate().camera().mean(), other.estimate().camera().std(), draws);
            double[] object = usual.estimate().object(20).pose().std();
            assertAlike(usual.estimate().object(20).pose().mean(), object,
                    other.estimate().object(20).pose().mean(), other.estimate().object(20).pose().std(), draws);
        }
        assertEquals(581, expected.mean()[0], 4 * std(expected)[0], "the true one");
        assertTrue(std(expected)[0] < 20, "the photo tells it");
    }

    private static CheckResult run(Cell cell, Detections photo, LikelihoodModel likelihood, OptionalDouble focal,
            long seed) {
        return CellCheck.run(cell, photo, settings(seed).likelihood(likelihood).estimate(Estimate.FOCAL)
                .set(SettingTable.INITIAL_FOCAL_PX, focal).build());
    }

    @Test
    void aFlatPriorIsThatOfAWideOneWhereThePhotoTellsAndRefusedWhereItDoesNot() {
        Detections photo = RAISED.detections(PIXEL_STD_PX, RandomStreams.of(7), 1, 0.005);
        IntrinsicsEstimate flat = flat(RAISED, photo);
        IntrinsicsEstimate wide = quick(RAISED.cell(), photo, settings(1).estimate(Estimate.FOCAL)
                .focalPriorStdPx(1e5).build());
        assertEquals(wide.mean()[0], flat.mean()[0], 1e-4 * std(wide)[0]);
        assertEquals(std(wide)[0], std(flat)[0], 1e-4 * std(wide)[0]);
        assertTrue(flat.notLearned().isEmpty());
        // raised enough for its placement, and small in the image
        ThesisScene far = ThesisScene.oneRaised(4).placement(1, 0.005).pixelStd(0.5)
                .cameraAt(RigidTransform.ofEuler(246, 190, 5000, Math.PI, 0, 0));
        InputRefusedException refused = assertThrows(InputRefusedException.class,
                () -> flat(far, far.exactDetections()));
        assertEquals(CheckRefusal.FLAT_FOCAL_OPEN, refused.refusal().kind());
    }

    private static IntrinsicsEstimate flat(ThesisScene scene, Detections photo) {
        return quick(scene.cell(), photo, settings(1).estimate(Estimate.FOCAL)
                .focalPriorStdPx(Double.POSITIVE_INFINITY).build());
    }

    private static IntrinsicsEstimate quick(Cell cell, Detections photo, CheckSettings settings) {
        IntrinsicsEstimate found = CellCheck.quickLook(cell, photo, settings, null).estimate().intrinsics();
        assertNotNull(found);
        return found;
    }

    @Test
    void whatThePhotoDoesNotTellIsSaidNotToBeLearned() {
        ThesisScene flat = ThesisScene.inPlane(4).noObjects().pixelStd(PIXEL_STD_PX);
        CheckResult result = CellCheck.run(flat.cell(), flat.exactDetections(), settings(3).iterations(400)
                .estimate(Estimate.INTRINSICS).set(SettingTable.TANGENTIAL_PRIOR_STD, OptionalDouble.of(1e-6)).build());
        List<ResultView.Intrinsic> view = ResultView.of(result).intrinsics();
        assertEquals(8, view.size());
        for (ResultView.Intrinsic intrinsic : view.subList(6, 8)) {
            assertFalse(intrinsic.learned(), intrinsic.name());
            assertEquals("not learned", intrinsic.restsOn());
            assertEquals(1e-6, intrinsic.priorStd(), 0);
            assertEquals(1e-6, intrinsic.std(), 1e-7);
        }
        assertTrue(result.warnings().stream().anyMatch(w -> w.kind() == CheckWarning.INTRINSICS_NOT_LEARNED
                && w.toString().contains("p1") && !w.toString().contains("fx_px")));
    }

    /** The thesis' question (Table 9.7), with six references of which one is raised, and one of them badly placed. */
    @Test
    void everyFirstEstimateOfThePoseLeadsToTheSamePosterior() {
        ThesisScene scene = ThesisScene.oneRaised(6).placement(5, 0.01).pixelStd(PIXEL_STD_PX);
        Detections good = scene.detections(PIXEL_STD_PX, RandomStreams.of(12), 5, 0.01);
        assertOnePosterior(scene.cell(), good);
        Detections bad = scene.shifted(7, 0, 60, 0).detections(PIXEL_STD_PX, RandomStreams.of(12), 0.3, 0.0005);
        assertOnePosterior(scene.cell(), bad);
        // the first estimates themselves are not the same
        double average = offTruth(InitialPose.AVERAGE, scene, bad);
        double ransac = offTruth(InitialPose.RANSAC, scene, bad);
        assertTrue(average > 2 * ransac, "the average is off by " + average + " mm, RANSAC by " + ransac + " mm");
    }

    private static void assertOnePosterior(Cell cell, Detections photo) {
        CheckResult pnp = CellCheck.run(cell, photo, settings(1).initial(InitialEstimate.PNP).build());
        for (InitialEstimate other : new InitialEstimate[] {InitialEstimate.AVERAGE, InitialEstimate.RANSAC}) {
            CheckResult result = CellCheck.run(cell, photo, settings(2).initial(other).build());
            double draws = Math.min(leastDraws(pnp), leastDraws(result));
            assertAlike(pnp.estimate().camera().mean(), pnp.estimate().camera().std(),
                    result.estimate().camera().mean(), result.estimate().camera().std(), draws);
            for (int id : new int[] {5, 20, 30}) {
                assertAlike(pnp.estimate().object(id).pose().mean(), pnp.estimate().object(id).pose().std(),
                        result.estimate().object(id).pose().mean(), result.estimate().object(id).pose().std(), draws);
            }
        }
    }

    private static double offTruth(InitialPose estimate, ThesisScene scene, Detections photo) {
        RigidTransform pose = estimate.estimate(ReferenceView.of(scene.cell().references(),
                CornerErrors.of(scene.cell(), photo)), ThesisScene.CAMERA);
        assertNotNull(pose);
        double[] p = pose.translationMm();
        double[] q = ThesisScene.WORLD_FROM_CAMERA.translationMm();
        return Math.sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]));
    }
}
