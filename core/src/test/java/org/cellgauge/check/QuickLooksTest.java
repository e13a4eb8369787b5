package org.cellgauge.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.cellgauge.cell.Cell;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.sampling.RandomStreams;
import org.cellgauge.output.ResultView;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.LikelihoodModel;
import org.cellgauge.vision.Detections;
import org.junit.jupiter.api.Test;

class QuickLooksTest {
    private static final ThesisScene SCENE = ThesisScene.oneRaised(4).placement(2, 0.004).pixelStd(0.2).target(3)
            .grip(20, 10, 20, 100);

    /** Everything that a look says, to the last bit; budgets are worked out for it. */
    private static ResultView told(Cell cell, QuickLook look) {
        return ResultView.preliminary(cell, look.update().estimate());
    }

    @Test
    void aLookDependsOnItsOwnPhotoAlone() {
        List<Detections> photos = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            photos.add(SCENE.detections(0.2, RandomStreams.of(i), 2, 0.004));
        }
        // a photo of fewer markers: work space of another size
        Detections all = photos.get(1);
        photos.add(2, new Detections("fewer", all.widthPx(), all.heightPx(),
                all.markers().subList(1, all.markers().size())));
        Cell cell = SCENE.cell();
        for (LikelihoodModel likelihood : LikelihoodModel.values()) {
            CheckSettings settings = CheckSettings.builder().likelihood(likelihood).threads(1).build();
            QuickLooks looks = new QuickLooks(cell, settings);
            List<QuickLook> made = new ArrayList<>();
            RigidTransform start = null;
            List<ResultView> alone = new ArrayList<>();
            for (Detections photo : photos) {
                made.add(looks.of(photo, start));
                QuickLook other = CellCheck.quickLook(cell, photo, settings, start);
                alone.add(told(cell, other));
                start = other.update().estimate().camera().meanTransform();
            }
            for (int i = 0; i < photos.size(); i++) {
                // asked when other looks have used the work space, on some thread
                QuickLook look = made.get(i);
                assertEquals(alone.get(i), CompletableFuture.supplyAsync(() -> told(cell, look)).join());
            }
            assertTrue(!alone.get(0).equals(alone.get(1)) && !alone.get(0).object(20).budget().isEmpty());
        }
    }
}
