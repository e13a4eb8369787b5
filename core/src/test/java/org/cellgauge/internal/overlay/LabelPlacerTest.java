package org.cellgauge.internal.overlay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
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

    /** A fifth of 600 x 500 px within the margins is 100 labels of 20 x 30 px. */
    @Test
    void whatDoesNotFitIsNotPlaced() {
        LabelPlacer placer = new LabelPlacer(606, 506, 1);
        int placed = 0;
        while (placer.hasRoom(20, 30) && placed < 1000) {
            placer.place(20, 30, new Box(300, 200, 340, 240));
            placed++;
        }
        assertEquals(100, placed);
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

    /** A label would hide a marker of a thousandth of its area whole: a farther place is better, however far. */
    @Test
    void aSmallMarkerIsNotCovered() {
        LabelPlacer placer = new LabelPlacer(1006, 206, 1);
        Box target = new Box(3, 95, 30, 110);
        // everything but a place on the small marker and one at the other end is taken
        placer.keepOff(new Box(0, 0, 1006, 88));
        placer.keepOff(new Box(0, 118, 1006, 206));
        placer.keepOff(target);
        placer.keepOff(new Box(240, 88, 790, 118));
        Box small = new Box(130, 100, 132, 102);
        placer.keepOff(small);
        Box label = placer.place(200, 20, target);
        assertEquals(0, label.overlap(small), label.toString());
    }

    /** The search passes over most places; it must not pass over the best one. */
    @Test
    void noPlaceOfTheGridIsBetterThanTheOneTaken() {
        Random random = new Random(5);
        for (int round = 0; round < 60; round++) {
            double w = 300 + random.nextInt(900);
            double h = 300 + random.nextInt(900);
            LabelPlacer placer = new LabelPlacer(w, h, 1.3);
            List<Box> hard = boxes(random, 12, w, h);
            List<Box> soft = boxes(random, 6, w, h);
            hard.forEach(placer::keepOff);
            soft.forEach(placer::avoid);
            Box target = hard.get(0);
            double width = 40 + random.nextInt(150);
            double height = 10 + random.nextInt(40);
            Box area = placer.area();
            double least = Double.POSITIVE_INFINITY;
            for (double v = area.top(); v + height <= area.bottom(); v += 4 * 1.3) {
                for (double u = area.left(); u + width <= area.right(); u += 4 * 1.3) {
                    least = Math.min(least, price(new Box(u, v, u + width, v + height), target, hard, soft));
                }
            }
            double paid = price(placer.place(width, height, target), target, hard, soft);
            assertTrue(paid <= least * (1 + 1e-9), round + ": " + paid + " where " + least + " was to be had");
        }
    }

    private static List<Box> boxes(Random random, int count, double w, double h) {
        List<Box> boxes = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double u = random.nextDouble() * w;
            double v = random.nextDouble() * h;
            boxes.add(new Box(u, v, u + 10 + random.nextInt(120), v + 10 + random.nextInt(120)));
        }
        return boxes;
    }

    /** Distances in units, a little for being off-centre, much for covering. */
    private static double price(Box box, Box target, List<Box> hard, List<Box> soft) {
        double price = box.distance(target) / 1.3 + 0.03 / 1.3 * Math.hypot(
                (box.left() + box.right() - target.left() - target.right()) / 2,
                (box.top() + box.bottom() - target.top() - target.bottom()) / 2);
        for (Box b : hard) {
            price += 1e5 * box.overlap(b) / Math.min(box.width() * box.height(), b.width() * b.height());
        }
        for (Box b : soft) {
            price += 200 * box.overlap(b) / (box.width() * box.height());
        }
        return price;
    }
}
