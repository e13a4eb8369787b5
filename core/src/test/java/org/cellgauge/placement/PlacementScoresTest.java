package org.cellgauge.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.internal.laplace.CameraFit;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.junit.jupiter.api.Test;

class PlacementScoresTest {
    private static final int DRAWS = 20_000;

    /** What is drawn scatters as the covariances say, that of causes too, and after one of them is swept out. */
    @Test
    void drawsHaveTheCovarianceOfTheScores() {
        ThesisScene scene = ThesisScene.oneRaised(4).placement(2, 0.01).pixelStd(0.05);
        Cell cell = scene.cell();
        Detections photo = scene.detections(0.05, RandomStreams.of(3), 2, 0.01);
        CornerErrors errors = CornerErrors.of(cell, photo);
        CameraFit camera = new CameraFit(cell.camera(), CheckSettings.builder().build(),
                ReferenceView.of(cell.references(), errors), IntrinsicsPrior.KNOWN, null, errors, 0);
        camera = camera.at(camera.finder(camera.view).modes(ThesisScene.WORLD_FROM_CAMERA),
                ThesisScene.WORLD_FROM_CAMERA);
        List<CausePattern> causes = CausePattern.of(camera, camera.mode());
        assertTrue(causes.size() > 1);
        PlacementScores scores = new PlacementScores(camera.view, camera.mode(), causes);
        compare(scores);
        PlacementScores without = scores.without(scores.firstOfCauses());
        assertEquals(0, Math.sqrt(without.variance(scores.firstOfCauses(), new double[] {1})), 1e-3);
        compare(without);
    }

    private static void compare(PlacementScores scores) {
        int n = scores.size();
        double[] sums = new double[n * n];
        double[] draw = new double[n];
        RandomGenerator random = RandomStreams.of(8);
        for (int d = 0; d < DRAWS; d++) {
            scores.draw(random, draw);
            for (int a = 0; a < n; a++) {
                for (int b = 0; b <= a; b++) {
                    sums[a * n + b] += draw[a] * draw[b] / DRAWS;
                }
            }
        }
        double[] stated = new double[n];
        double[] variances = new double[n];
        for (int a = 0; a < n; a++) {
            scores.covariances(a, new double[] {1}, new double[n], stated);
            variances[a] = stated[a];
            for (int b = 0; b <= a; b++) {
                assertEquals(scores.covariance(a, new double[] {1}, b, new double[] {1}), stated[b],
                        1e-12 * (1 + Math.abs(stated[b])));
                // five deviations of a mean of products of normal numbers
                double most = 5 * Math.sqrt((variances[a] * variances[b] + stated[b] * stated[b]) / DRAWS);
                assertEquals(stated[b], sums[a * n + b], most + 1e-6 * (1 + Math.sqrt(variances[a] * variances[b])));
            }
        }
    }
}
