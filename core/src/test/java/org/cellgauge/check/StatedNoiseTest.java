package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.cellgauge.sampling.RandomStreams;
import org.junit.jupiter.api.Test;

/**
 * Corners and a corner noise stated as a number: figures are those of the program before corners had covariances of
 * their own (the numbers below were computed with the version of November 2026 that knew one deviation for all
 * corners). A chain that accepts a single step otherwise is off by far more than the bound.
 */
class StatedNoiseTest {
    private static double[] figures(ThesisScene scene, CheckSettings.Builder settings, long seed) {
        CheckResult result = CellCheck.run(scene.cell(), scene.detections(0.3, RandomStreams.of(seed), 1, 0.003),
                settings.iterations(400).seed(seed).build());
        double[] quick = result.quickLook().object(20).pose().std();
        double[] camera = result.estimate().camera().mean();
        double[] object = result.estimate().object(20).pose().std();
        return new double[] {quick[0], quick[2], camera[0], camera[4], object[1], object[2],
            result.quickLook().object(20).budget().shares().get("corner noise of object"),
            result.referenceCheck().fits().get(1).chiSquare(), result.pixelStdPx()};
    }

    @Test
    void figuresAreWhatTheyWere() {
        require(figures(ThesisScene.inPlane(4).placement(1, 0.003), CheckSettings.builder(), 1), new double[] {
            2.3991217567763923, 12.850800565769164, 434.5185917241905, 0.11462494999877446, 1.854894241727194,
            13.655984757189874, 0.9458349745573633, 5.950126906223377, 0.3});
        require(figures(ThesisScene.oneRaised(3).placement(1, 0.003),
                CheckSettings.builder().estimate(CheckSettings.Estimate.FOCAL), 2), new double[] {
            2.07891020511786, 13.340401394340986, 393.2550168380835, 0.08137659835464932, 1.683879153326379,
            13.354307634001742, 0.7887725748032074, 2.836673155055358, 0.3});
        require(figures(ThesisScene.oneRaised(4).placement(1, 0.003).grip(20, 0, 0, 100),
                CheckSettings.builder().sampler(SamplerKind.ADAPTIVE), 3), new double[] {
            2.339875043109452, 12.491982752670662, 431.02437010421113, 0.11206269120436736, 1.5551873113563637,
            10.284312761183003, 0.9576685893979914, 11.72770803039583, 0.3});
    }

    private static void require(double[] found, double[] before) {
        for (int i = 0; i < before.length; i++) {
            assertEquals(before[i], found[i], 1e-9 * Math.abs(before[i]), "figure " + i);
        }
    }
}
