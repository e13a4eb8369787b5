package org.cellgauge.overlay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class LabelPlacerTest {
    @Test
    void manyLabelsOfOnePlaceLieSideBySideWithinTheImage() {
        LabelPlacer placer = new LabelPlacer(640, 480, 1);
        Box target = new Box(600, 440, 630, 470);
        placer.keepOff(target);
        List<Box> placed = new ArrayList<>();
        for (int i = 0; i < 12; i++) {
            Box box = placer.place(120, 20, target);
            assertTrue(new Box(0, 0, 640, 480).contains(box), box.toString());
            assertEquals(0, box.overlap(target));
            for (Box other : placed) {
                assertEquals(0, box.overlap(other), box + " and " + other);
            }
            placed.add(box);
        }
    }

    @Test
    void aLoneLabelIsBesideWhatItNames() {
        LabelPlacer placer = new LabelPlacer(640, 480, 1);
        Box target = new Box(300, 200, 340, 240);
        placer.keepOff(target);
        Box box = placer.place(100, 20, target);
        assertTrue(box.distance(target) <= 5, "distance " + box.distance(target));
    }

    @Test
    void whatBetterStaysVisibleIsAvoidedWhereThereIsRoom() {
        LabelPlacer placer = new LabelPlacer(640, 480, 1);
        Box target = new Box(300, 200, 340, 240);
        Box ellipse = new Box(280, 180, 360, 270);
        placer.keepOff(target);
        placer.avoid(ellipse);
        assertEquals(0, placer.place(100, 20, target).overlap(ellipse));
    }
}
