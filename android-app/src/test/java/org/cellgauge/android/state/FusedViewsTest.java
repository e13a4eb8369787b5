package org.cellgauge.android.state;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;

import org.cellgauge.cell.Cell;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.vision.Detections;
import org.junit.Test;

/** Views of one simulated cell. */
public class FusedViewsTest {
    private static final CheckSettings SETTINGS = CheckSettings.builder().threads(1).build();
    private final Cell cell = SimulatedCell.cell();

    private Detections view(int number, double movedMm) {
        return SimulatedCell.photo(cell, SimulatedCell.STRAIGHT, number, movedMm);
    }

    @Test
    public void viewsOfACellThatStandsStillSayMoreTogether() {
        FusedViews none = FusedViews.none(cell, SETTINGS);
        assertNull(none.stdMm(5));
        FusedViews one = none.with(view(0, 0));
        FusedViews three = one.with(view(1, 0)).with(view(2, 0));
        assertEquals(1, one.count());
        assertEquals(3, three.count());
        for (int id : SimulatedCell.IDS) {
            for (int axis = 0; axis < 3; axis++) {
                assertTrue(three.stdMm(id)[axis] < one.stdMm(id)[axis]);
            }
        }
        assertEquals(1, one.count());
    }

    @Test
    public void theSameViewAgainSaysNothingNew() {
        FusedViews one = FusedViews.none(cell, SETTINGS).with(view(0, 0));
        assertSame(one, one.with(view(0, 0)));
    }

    @Test
    public void whatHasMovedBeginsANewSet() {
        FusedViews two = FusedViews.none(cell, SETTINGS).with(view(0, 0)).with(view(1, 0));
        assertEquals(2, two.count());
        FusedViews moved = two.with(view(2, 15));
        assertEquals(1, moved.count());
    }
}
