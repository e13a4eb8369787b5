package org.cellgauge.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.GridScene;
import org.cellgauge.check.ThesisScene;
import org.cellgauge.internal.laplace.CameraFit;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.junit.jupiter.api.Test;

class LargestCorrelationTest {
    @Test
    void isWhatComparingAllWithAllFindsAmongManyReferences() {
        GridScene scene = GridScene.of(60, 0);
        assertTrue(compared(scene.cell, scene.detections) > 600);
    }

    @Test
    void isWhatComparingAllWithAllFindsAmongFew() {
        ThesisScene scene = ThesisScene.oneRaised(4).placement(2, 0.01).pixelStd(0.05);
        assertTrue(compared(scene.cell(), scene.detections(0.05, RandomStreams.of(3), 2, 0.01)) > 20);
        scene = ThesisScene.inPlane(2).placement(2, 0.01).pixelStd(0.05);
        compared(scene.cell(), scene.detections(0.05, RandomStreams.of(3), 2, 0.01));
    }

    /** Compares all with all. */
    private static int compared(Cell cell, Detections photo) {
        CornerErrors errors = CornerErrors.of(cell, photo);
        CameraFit camera = new CameraFit(cell.camera(), CheckSettings.builder().build(),
                ReferenceView.of(cell.references(), errors), IntrinsicsPrior.KNOWN, null, errors, 0);
        camera = camera.at(camera.finder(camera.view).modes(ThesisScene.WORLD_FROM_CAMERA),
                ThesisScene.WORLD_FROM_CAMERA);
        List<CausePattern> causes = CausePattern.of(camera, camera.mode());
        PlacementScores scores = new PlacementScores(camera.view, camera.mode(), causes);
        List<DirectionScore> tests = DirectionScore.of(camera.view, causes, scores);
        LargestCorrelation among = new LargestCorrelation(tests, scores);
        for (DirectionScore test : tests) {
            double largest = 0;
            for (DirectionScore other : tests) {
                if (!test.isOfTheSame(other)) {
                    largest = Math.max(largest, test.correlation(other, scores));
                }
            }
            assertEquals(largest, among.of(test));
        }
        return tests.size();
    }
}
