package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.estimate.ModeEstimate;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.estimate.PoseEstimate;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.internal.statistics.CoverageRegion;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.Quantity.Axis;
import org.cellgauge.settings.CheckSettings;
import org.junit.jupiter.api.Test;

/** Two poses that explain one small marker: both found, weighted as their chances are, and called ambiguous. */
class AmbiguousPoseTest {
    /** Beyond this tilt the second pose of a marker of 47 mm at 1.07 m holds next to nothing. */
    private static final double LARGEST_TILT_RAD = Math.toRadians(65);

    /** A marker in the middle of the references, turned evenly over all rotations of at most the largest tilt. */
    private static RigidTransform frontal(RandomGenerator random) {
        double cosine = 1 - random.nextDouble() * (1 - Math.cos(LARGEST_TILT_RAD));
        double tilt = Math.acos(cosine);
        double around = 2 * Math.PI * random.nextDouble();
        double[] r = new double[9];
        double[] tilted = new double[9];
        double[] turned = new double[9];
        Rotations.exp(tilt * Math.cos(around), tilt * Math.sin(around), 0, tilted);
        Rotations.fromEuler(0, 0, 2 * Math.PI * random.nextDouble(), turned);
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                for (int k = 0; k < 3; k++) {
                    r[3 * i + j] += tilted[3 * i + k] * turned[3 * k + j];
                }
            }
        }
        return RigidTransform.of(r, new double[] {418, 106, 0});
    }

    /**
     * With truths drawn as the flat prior has them, the true pose is the heavier mode as often as the weights of the
     * heavier modes say (calibration: Dawid, "The well-calibrated Bayesian", JASA 1982).
     */
    @Test
    void weightsAreTheChancesOfTheTwoPoses() {
        RandomGenerator random = RandomStreams.of(42);
        double expected = 0;
        double variance = 0;
        int heavier = 0;
        int ambiguous = 0;
        int cells = 160;
        for (int c = 0; c < cells; c++) {
            RigidTransform truth = frontal(random);
            ThesisScene scene = ThesisScene.inPlane(4).noObjects().placement(0.1, 0.0005).pixelStd(0.2).object(5, truth)
                    .target(1000);
            CheckResult result = CellCheck.run(scene.cell(), scene.detections(0.2, random, 0.1, 0.0005),
                    CheckSettings.builder().seed(c).targetMcseStdRel(0.1).build());
            assertTrue(result.verdict() != Verdict.NOT_CONVERGED, "cell " + c);
            List<ModeEstimate> modes = result.estimate().object(5).modes();
            boolean two = modes.size() > 1 && 1 - modes.get(0).weight() > 0.01;
            assertEquals(two ? Verdict.AMBIGUOUS : Verdict.PASS, result.verdict());
            if (modes.size() < 2) {
                continue;
            }
            double weight = modes.get(0).weight();
            assertEquals(1, weight + modes.get(1).weight(), 1e-12);
            expected += weight;
            variance += weight * (1 - weight);
            heavier += truth.angleRadTo(modes.get(0).pose().meanTransform())
                    < truth.angleRadTo(modes.get(1).pose().meanTransform()) ? 1 : 0;
            if (two) {
                ambiguous++;
                assertTrue(result.reason().startsWith(String.format(Locale.ROOT, "Two poses explain the corners of "
                        + "object 5 (the second holds %.0f %%)", 100 * modes.get(1).weight())), result.reason());
            }
        }
        assertTrue(ambiguous > 30, ambiguous + " of " + cells + " were ambiguous: too few to judge");
        assertEquals(expected, heavier, 3 * Math.sqrt(variance), "truth in the heavier mode");
    }

    @Test
    void theOverallPoseOfAnAmbiguousObjectIsTheMixtureOfItsModes() {
        ThesisScene scene = ThesisScene.inPlane(4).noObjects().placement(1, 0.003).pixelStd(0.3)
                .object(5, RigidTransform.ofEuler(418, 106, 0, 0.15, 0.1, 0.4)).target(1000);
        CheckResult result = CellCheck.run(scene.cell(), scene.exactDetections(),
                CheckSettings.builder().build());
        assertEquals(Verdict.AMBIGUOUS, result.verdict());
        ObjectEstimate object = result.estimate().object(5);
        assertEquals(2, object.modes().size());
        for (int i = 0; i < 3; i++) {
            double mean = 0;
            double square = 0;
            for (ModeEstimate mode : object.modes()) {
                double m = mode.pose().mean()[i];
                mean += mode.weight() * m;
                square += mode.weight() * (m * m + Math.pow(mode.pose().std()[i], 2));
            }
            assertEquals(mean, object.pose().mean()[i], 1e-6);
            // covariances of n draws over n - 1, in parts and as a whole
            assertEquals(1, Math.sqrt(square - mean * mean) / object.pose().std()[i], 2e-3);
        }
        // both see the marker from the front, and turn it to opposite sides of the line of sight
        double apart = object.modes().get(0).pose().meanTransform()
                .angleRadTo(object.modes().get(1).pose().meanTransform());
        assertTrue(apart > 0.1, "apart by " + apart);
    }

    /** Over the draws that it is of, the squared distance by a covariance of six coordinates is 6 on average. */
    private static double meanSquaredDistance(CheckResult result, Quantity xMm, Quantity label, PoseEstimate pose,
            int mode) {
        CoverageRegion region = CoverageRegion.of(new double[6], pose.tangentCovariance(), 0.95);
        int first = result.layout().indexOf(xMm);
        int modes = label == null ? -1 : result.layout().indexOf(label);
        double[] rotation = new double[9];
        double[] turned = new double[9];
        double[] d = new double[6];
        double sum = 0;
        int n = 0;
        for (Draws chain : result.draws()) {
            for (int i = 0; i < chain.count(); i++) {
                if (modes >= 0 && chain.get(modes, i) != mode) {
                    continue;
                }
                for (int k = 0; k < 3; k++) {
                    d[k] = chain.get(first + k, i) - pose.mean()[k];
                }
                Rotations.fromEuler(chain.get(first + 3, i), chain.get(first + 4, i),
                        chain.get(first + 5, i), rotation);
                Rotations.multiplyTransposed(rotation, pose.meanTransform().rotation(), turned);
                Rotations.log(turned, d, 3);
                sum += region.mahalanobisSquared(d);
                n++;
            }
        }
        return sum / n;
    }

    @Test
    void tangentCovariancesAreAboutTheRotationThatTheyName() {
        ThesisScene scene = ThesisScene.inPlane(4).placement(1, 0.003).pixelStd(0.1)
                .object(5, RigidTransform.ofEuler(418, 106, 0, 0.25, 0.1, 0.4)).target(1000);
        CheckResult result = CellCheck.run(scene.cell(), scene.exactDetections(), CheckSettings.builder().build());
        ObjectEstimate object = result.estimate().object(5);
        assertEquals(2, object.modes().size());
        double apart = object.modes().get(0).pose().meanTransform()
                .angleRadTo(object.modes().get(1).pose().meanTransform());
        assertTrue(apart > 0.3, "apart by " + apart);
        assertEquals(6, meanSquaredDistance(result, Quantity.camera(Axis.X), null, result.estimate().camera(), -1),
                0.05);
        for (ModeEstimate mode : object.modes()) {
            // the heavier mode has the label 0
            int label = mode == object.modes().get(0) ? 0 : 1;
            assertEquals(6, meanSquaredDistance(result, Quantity.object(5, Axis.X), Quantity.objectMode(5),
                    mode.pose(), label), 0.3, "mode " + label);
        }
    }
}
