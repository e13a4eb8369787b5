package org.cellgauge.internal.validation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.CellCheck;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.statistics.BinomialBand;
import org.cellgauge.internal.statistics.RunningMoments;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Estimate;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.vision.Detections;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Whether claimed uncertainties are those that simulated cells have, with the scene of the thesis. */
class CoverageTest {
    private static final double PIXEL_STD_PX = 0.05;

    private static CheckSettings settings(LikelihoodModel model, double kappa) {
        return CheckSettings.builder().likelihood(model).kappa(kappa).seed(11).targetMcseStdRel(0.1).build();
    }

    private static ValidationResult validate(ThesisScene scene, double spreadMm, double spreadDeg, double simulatedPx,
            int simulations, int threads, CheckSettings settings) {
        CellTruth nominal = new CellTruth(scene.worldFromCamera(), scene.objects());
        TruthPrior prior = new TruthPrior(scene.cell(), nominal, spreadMm, Math.toRadians(spreadDeg));
        return Validation.run(prior, new ValidationSettings(simulations, settings, simulatedPx, threads), done -> { });
    }

    private static ThesisScene scene(int references, double stdMm) {
        return ThesisScene.inPlane(references).placement(stdMm, 0.002 * stdMm).pixelStd(PIXEL_STD_PX);
    }

    private static ThesisScene withOneObject(ThesisScene scene) {
        return scene.noObjects().object(20, RigidTransform.ofEuler(240, -44, 0, 0, 0, 2.29)).grip(20, 0, 0, 100);
    }

    /** False alarm of the bands: 1 % for each level, of the ranks 1 in 1000, if all is right. */
    @ParameterizedTest
    @CsvSource({"3, 5", "4, 1"})
    void rigidMarkerRegionsHoldTheTruthAsOftenAsTheyClaim(int references, double stdMm) {
        int simulations = 120;
        ValidationResult result = validate(withOneObject(scene(references, stdMm)), 50, 10, PIXEL_STD_PX, simulations,
                2, settings(LikelihoodModel.RIGID_MARKER, 0.5));
        assertTrue(result.withoutFigure() <= 0.02, "not converged: " + result.notConverged());
        for (double level : new double[] {0.5, 0.8, 0.95}) {
            for (RegionCoverage region : result.regions()) {
                BinomialBand band = region.band(level);
                assertTrue(region.covers(level), region.name() + " of " + level + ": " + region.hits(level)
                        + " outside " + band.lower() + " to " + band.upper());
            }
        }
        assertTrue(result.rankPValue() > 0.001, "p of the ranks: " + result.rankPValue());
        // at a rate of 1 % more come once in a thousand
        assertTrue(result.falseAlarms() <= BinomialBand.of(simulations, 0.01, 0.998).upper(),
                result.falseAlarms() + " alarms");
    }

    /**
     * References turned by 3 degrees and corners of 0.05 px: linearised at their nominal places they look farther away
     * by two deviations. Means as well as deviations must be right.
     */
    @Test
    void turnedReferencesMoveNoMeanAndAreNotAccused() {
        int simulations = 80;
        ThesisScene scene = withOneObject(ThesisScene.inPlane(4).placement(1, Math.toRadians(3))
                .pixelStd(PIXEL_STD_PX));
        ValidationResult result = validate(scene, 50, 10, PIXEL_STD_PX, simulations, 2,
                settings(LikelihoodModel.RIGID_MARKER, 0.5));
        assertTrue(result.withoutFigure() <= 0.02, "not converged: " + result.notConverged());
        for (RankedQuantity q : result.quantities()) {
            if (!Double.isNaN(q.meanError())) {
                // a mean of 80 is good to 0.11 deviations; 0.1 are left of second order
                assertEquals(0, q.meanError(), 0.1 + 3.5 / Math.sqrt(simulations), q.part() + " " + q.name());
                assertEquals(1, q.rmsError(), 0.1 + 3.5 / Math.sqrt(2 * simulations), q.part() + " " + q.name());
            }
        }
        for (RegionCoverage region : result.regions()) {
            assertTrue(region.covers(0.95), region.name() + ": " + region.hits(0.95));
        }
        assertTrue(result.falseAlarms() <= BinomialBand.of(simulations, 0.01, 0.998).upper(),
                result.falseAlarms() + " alarms");
    }

    /**
     * A camera with square pixels, nearly in front of its references, whose focal length nobody knows to better than
     * 100 px. With two independent priors, whose pixels have any shape, regions of the camera hold the truth in 67 of
     * 80.
     */
    @Test
    void unknownFocalLengthIsCoveredWherePixelsAreSquare() {
        int simulations = 80;
        ThesisScene scene = scene(4, 20).noObjects();
        TruthPrior prior = new TruthPrior(scene.cell(), new CellTruth(scene.worldFromCamera(), scene.objects()), 300,
                Math.toRadians(3), IntrinsicsPrior.focalAndAspect(scene.cell().camera(), 100, 1e-9));
        CheckSettings check = settings(LikelihoodModel.RIGID_MARKER, 0.5).toBuilder()
                .seed(12).estimate(Estimate.FOCAL).focalPriorStdPx(100).build();
        ValidationResult result = Validation.run(prior, new ValidationSettings(simulations, check, PIXEL_STD_PX, 2),
                done -> { });
        assertTrue(result.withoutFigure() <= 0.03, "not converged: " + result.notConverged());
        assertEquals(2, result.regions().size());
        for (RegionCoverage region : result.regions()) {
            BinomialBand band = region.band(0.95);
            // the aspect ratio is known better than stated, so that more may be held
            assertTrue(region.hits(0.95) >= band.lower(), region.name() + ": " + region.hits(0.95));
        }
        for (RankedQuantity q : result.quantities()) {
            if (q.name().equals("fx_px")) {
                // a flat prior of the distance pulls means up where cameras do not stand anywhere; ranks allow for it
                assertTrue(q.ranks().pValue() > 0.001, "p of the ranks: " + q.ranks().pValue());
                assertEquals(1, q.rmsError(), 3.5 / Math.sqrt(2 * simulations));
            }
        }
        assertTrue(result.weightShareMin() > 0.02, "effective share " + result.weightShareMin());
    }

    /** At a fixed truth, where coverage is frequentist and exact only to first order. */
    @Test
    void rigidMarkerCoversAtAFixedCameraPose() {
        ValidationResult result = validate(scene(4, 5).noObjects(), 0, 0, PIXEL_STD_PX, 200, 2,
                settings(LikelihoodModel.RIGID_MARKER, 0.5));
        RegionCoverage camera = result.regions().get(0);
        assertTrue(camera.covers(0.95), "hits " + camera.hits(0.95));
        assertEquals(1, result.weightShareMin());
    }

    /**
     * The likelihood of the thesis takes the corners of one marker for independent. With the box of half extent kappa =
     * 0.5 a claimed 95 % is right less than half of the time: the bound is below what 99.9 % confidence allows.
     */
    @ParameterizedTest
    @ValueSource(ints = {3, 4})
    void cornerCubeClaimsFarTooMuch(int references) {
        ValidationResult result = validate(scene(references, 5).noObjects(), 50, 10, PIXEL_STD_PX, 80, 2,
                settings(LikelihoodModel.CORNER_CUBE, 0.5));
        RegionCoverage camera = result.regions().get(0);
        double most = BinomialBand.clopperPearson(camera.hits(0.95), camera.trials(), 0.998)[1];
        assertTrue(most < 0.5, camera.hits(0.95) + " of " + camera.trials());
        assertFalse(result.covers(0.95));
    }

    /** Corners three times as noisy as stated, where corner noise is what matters. */
    @Test
    void noiseThatTheCellFileDoesNotStateIsNoticed() {
        ThesisScene scene = scene(4, 0.01).noObjects();
        ValidationResult result = validate(scene, 50, 10, 3 * PIXEL_STD_PX, 60, 2,
                settings(LikelihoodModel.RIGID_MARKER, 0.5));
        assertFalse(result.covers(0.95));
        assertTrue(result.rankPValue() < 0.001);
        for (RankedQuantity q : result.quantities()) {
            if (!Double.isNaN(q.rmsError())) {
                // a third of the right deviation, and less where corners are seen to be of no square and their marker
                // is set aside; the root mean square of 60 is good to 9 %
                assertTrue(q.rmsError() > 1.5 && q.rmsError() < 3 * 1.28, q.name() + " " + q.rmsError());
            }
        }
    }

    @Test
    void figuresDoNotDependOnTheNumberOfThreads() {
        ThesisScene scene = withOneObject(scene(3, 5));
        CheckSettings settings = settings(LikelihoodModel.RIGID_MARKER, 0.5).toBuilder().iterations(400).build();
        ValidationResult one = validate(scene, 50, 10, PIXEL_STD_PX, 6, 1, settings);
        ValidationResult three = validate(scene, 50, 10, PIXEL_STD_PX, 6, 3, settings);
        assertEquals(figures(one), figures(three));
    }

    private static List<String> figures(ValidationResult result) {
        List<String> figures = new ArrayList<>();
        figures.add(result.notConverged() + " " + result.weightShareMin());
        for (RegionCoverage r : result.regions()) {
            figures.add(r.name() + " " + r.trials() + " " + r.hits(0.5) + " " + r.gaussianHits(0.5));
        }
        for (RankedQuantity q : result.quantities()) {
            figures.add(q.name() + " " + q.rmsError() + " " + Arrays.toString(q.ranks().counts()));
        }
        return figures;
    }

    /**
     * Predicted covariance against the errors of 2000 simulated cells. The mode and Laplace's covariance alone, without
     * chains, so that the Monte Carlo error is small against the bounds: of a deviation 1/sqrt(2 n) = 1.6 %, of an
     * eigenvalue sqrt(2/n) = 3.2 %; bounds of 10 % and 15 % leave room for what is not linear.
     */
    @ParameterizedTest
    @CsvSource({"3, 5", "4, 1"})
    void predictedCovarianceIsThatOfSampledErrors(int references, double stdMm) {
        ThesisScene scene = withOneObject(scene(references, stdMm));
        Cell cell = scene.cell();
        CellTruth truth = new CellTruth(scene.worldFromCamera(), scene.objects());
        CheckSettings settings = settings(LikelihoodModel.RIGID_MARKER, 0.5);
        CellEstimate predicted = quickLook(cell, scene.exactDetections(), settings);
        RunningMoments camera = new RunningMoments(6);
        RunningMoments object = new RunningMoments(3);
        for (int i = 0; i < 2000; i++) {
            CellEstimate estimate = quickLook(cell, SimulatedPhoto.of(cell, truth, PIXEL_STD_PX,
                    RandomStreams.of(5, 1, i), RandomStreams.of(5, 2, i)), settings);
            camera.add(error(estimate.camera(), truth.worldFromCamera()));
            object.add(Arrays.copyOf(error(estimate.object(20).pose(), truth.worldFromObjects().get(20)), 3));
        }
        requireAlike("camera", predicted.camera().tangentCovariance(), camera);
        requireAlike("object", predicted.object(20).pose().positionCovarianceMm2(), object);
    }

    private static CellEstimate quickLook(Cell cell, Detections detections, CheckSettings settings) {
        return CellCheck.stream(cell, detections, settings).blockingFirst().estimate();
    }

    private static double[] error(PoseEstimate estimate, RigidTransform truth) {
        double[] error = new double[6];
        RigidTransform turn = RigidTransform.of(estimate.meanTransform().rotation(), new double[3])
                .compose(RigidTransform.of(truth.rotation(), new double[3]).inverse());
        for (int i = 0; i < 3; i++) {
            error[i] = estimate.meanTransform().translationMm()[i] - truth.translationMm()[i];
            error[3 + i] = turn.rotationVectorRad()[i];
        }
        return error;
    }

    private static void requireAlike(String what, double[][] predicted, RunningMoments sampled) {
        int d = predicted.length;
        double[][] scaledPrediction = new double[d][d];
        double[][] scaledSample = new double[d][d];
        for (int i = 0; i < d; i++) {
            double std = Math.sqrt(predicted[i][i]);
            assertEquals(1, sampled.std(i) / std, 0.10, what + " coordinate " + i);
            for (int j = 0; j < d; j++) {
                // mm and rad in one matrix: eigenvalues mean something in units of the predicted deviations
                double unit = std * Math.sqrt(predicted[j][j]);
                scaledPrediction[i][j] = predicted[i][j] / unit;
                scaledSample[i][j] = sampled.covariance(i, j) / unit;
            }
        }
        assertEquals(1, largestEigenvalue(scaledSample) / largestEigenvalue(scaledPrediction), 0.15, what);
    }

    private static double largestEigenvalue(double[][] matrix) {
        EigenDecomposition_F64<DMatrixRMaj> eigen = DecompositionFactory_DDRM.eig(matrix.length, false, true);
        assertTrue(eigen.decompose(new DMatrixRMaj(matrix)));
        double largest = 0;
        for (int i = 0; i < matrix.length; i++) {
            largest = Math.max(largest, eigen.getEigenvalue(i).getReal());
        }
        return largest;
    }
}
