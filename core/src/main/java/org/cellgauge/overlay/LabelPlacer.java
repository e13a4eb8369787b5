package org.cellgauge.overlay;

import java.util.ArrayList;
import java.util.List;

/** Finds places for labels: near what they name, within the image, off each other and off what must stay visible. */
final class LabelPlacer {
    /** Price of covering what must not be covered, in distances per share of the label's area. */
    private static final double HARD = 1e5;
    /** Price of covering what better stays visible. */
    private static final double SOFT = 200;

    private final Box area;
    private final double unitPx;
    private final List<Box> hard = new ArrayList<>();
    private final List<Box> soft = new ArrayList<>();

    LabelPlacer(double widthPx, double heightPx, double unitPx) {
        double margin = 3 * unitPx;
        this.area = new Box(margin, margin, Math.max(margin, widthPx - margin), Math.max(margin, heightPx - margin));
        this.unitPx = unitPx;
    }

    /** The part of the image labels may take. */
    Box area() {
        return area;
    }

    /** Keeps labels off a box: a marker, a panel, another label. */
    void keepOff(Box box) {
        hard.add(box);
    }

    /** Keeps labels off a box where there is room elsewhere: an ellipse. */
    void avoid(Box box) {
        soft.add(box);
    }

    /**
     * The best place of a label; it is kept off from then on.
     *
     * @param width of the label, at most the area's
     * @param height of the label
     * @param target what it names
     * @return its box
     */
    Box place(double width, double height, Box target) {
        double gap = 3 * unitPx;
        Box best = null;
        double bestCost = Double.POSITIVE_INFINITY;
        double centreU = (target.left() + target.right() - width) / 2;
        double centreV = (target.top() + target.bottom() - height) / 2;
        double[][] sides = {{centreU, target.bottom() + gap}, {centreU, target.top() - gap - height},
            {target.right() + gap, centreV}, {target.left() - gap - width, centreV}};
        for (double[] s : sides) {
            Box box = new Box(s[0], s[1], s[0] + width, s[1] + height);
            double cost = area.contains(box) ? cost(box, target, bestCost) : Double.POSITIVE_INFINITY;
            if (cost < bestCost) {
                bestCost = cost;
                best = box;
            }
        }
        double step = 4 * unitPx;
        for (double v = area.top(); v + height <= area.bottom() + 1e-9; v += step) {
            for (double u = area.left(); u + width <= area.right() + 1e-9; u += step) {
                Box box = new Box(u, v, u + width, v + height);
                double cost = cost(box, target, bestCost);
                if (cost < bestCost) {
                    bestCost = cost;
                    best = box;
                }
            }
        }
        if (best == null) {
            // larger than the image: the corner shows as much of it as there is room for
            best = new Box(area.left(), area.top(), area.left() + width, area.top() + height);
        }
        keepOff(best.grown(unitPx));
        return best;
    }

    private double cost(Box box, Box target, double limit) {
        // off-centre costs a little, so that a label goes beside the middle of what it names
        double cost = box.distance(target) / unitPx + 0.03 * Math.hypot(
                (box.left() + box.right() - target.left() - target.right()) / 2,
                (box.top() + box.bottom() - target.top() - target.bottom()) / 2) / unitPx;
        double size = box.width() * box.height();
        for (int i = 0; i < hard.size() && cost < limit; i++) {
            cost += HARD * box.overlap(hard.get(i)) / size;
        }
        for (int i = 0; i < soft.size() && cost < limit; i++) {
            cost += SOFT * box.overlap(soft.get(i)) / size;
        }
        return cost;
    }
}
