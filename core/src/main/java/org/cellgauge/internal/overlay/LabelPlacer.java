package org.cellgauge.internal.overlay;

import java.util.ArrayList;
import java.util.List;

/** Finds places for labels: near what they name, within the image, off each other and off what must stay visible. */
final class LabelPlacer {
    /** Price of covering what must not be covered, in distances per share of the smaller of the two areas. */
    private static final double HARD = 1e5;
    /** Price of covering what better stays visible. */
    private static final double SOFT = 200;
    /** Share of the image that labels may take. */
    private static final double MOST_LABELLED = 0.2;
    /** Steps of the fine grid in one of the coarse grid. */
    private static final int COARSE = 8;
    /** What a root may be too large by. */
    private static final double LESS_BY_ROUNDING = 1 - 1e-12;
    /** The two grids meet to within rounding. */
    private static final double ROUNDING = 1 + 1e-6;

    private final Box area;
    private final double unitPx;
    private final List<Box> hard = new ArrayList<>();
    private final List<Box> soft = new ArrayList<>();
    private final Row row = new Row();
    private double labelledPx2;

    LabelPlacer(double widthPx, double heightPx, double unitPx) {
        double margin = 3 * unitPx;
        this.area = new Box(margin, margin, Math.max(margin, widthPx - margin), Math.max(margin, heightPx - margin));
        this.unitPx = unitPx;
    }

    /** The part of the image labels may take. */
    Box area() {
        return area;
    }

    /**
     * Whether one more label of a size can be told from the others: many cover what they name, and each costs a search
     * through the image. What matters most is to be labelled first.
     */
    boolean hasRoom(double width, double height) {
        double share = MOST_LABELLED * (area.right() - area.left()) * (area.bottom() - area.top());
        return labelledPx2 == 0 || labelledPx2 + width * height <= share;
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
        double bestLeft = Double.NaN;
        double bestTop = Double.NaN;
        double bestCost = Double.POSITIVE_INFINITY;
        double centreU = (target.left() + target.right() - width) / 2;
        double centreV = (target.top() + target.bottom() - height) / 2;
        double[][] sides = {{centreU, target.bottom() + gap}, {centreU, target.top() - gap - height},
            {target.right() + gap, centreV}, {target.left() - gap - width, centreV}};
        for (double[] s : sides) {
            row.take(s[1], s[1] + height);
            double cost = area.contains(new Box(s[0], s[1], s[0] + width, s[1] + height))
                    ? cost(s[0], s[1], width, height, target, bestCost) : Double.POSITIVE_INFINITY;
            if (cost < bestCost) {
                bestCost = cost;
                bestLeft = s[0];
                bestTop = s[1];
            }
        }
        // tens of thousands of places: nothing is made for each, and those that a coarse look rules out by their
        // distance alone are passed over
        double step = 4 * unitPx;
        double limit = Math.min(bestCost, leastOf(COARSE * step, width, height, target) * ROUNDING);
        for (double v = area.top(); v + height <= area.bottom() + 1e-9; v += step) {
            if (gap(v, v + height, target.top(), target.bottom()) / unitPx > limit) {
                continue;
            }
            row.take(v, v + height);
            for (double u = area.left(); u + width <= area.right() + 1e-9; u += step) {
                if (gap(u, u + width, target.left(), target.right()) / unitPx > limit) {
                    continue;
                }
                double cost = cost(u, v, width, height, target, bestCost);
                if (cost < bestCost) {
                    bestCost = cost;
                    limit = Math.min(limit, cost);
                    bestLeft = u;
                    bestTop = v;
                }
            }
        }
        // larger than the image: the corner shows as much of it as there is room for
        double left = Double.isNaN(bestLeft) ? area.left() : bestLeft;
        double top = Double.isNaN(bestLeft) ? area.top() : bestTop;
        Box best = new Box(left, top, left + width, top + height);
        keepOff(best.grown(unitPx));
        labelledPx2 += width * height;
        return best;
    }

    /** The least cost among places of a coarse grid. */
    private double leastOf(double step, double width, double height, Box target) {
        double least = Double.POSITIVE_INFINITY;
        for (double v = area.top(); v + height <= area.bottom() + 1e-9; v += step) {
            row.take(v, v + height);
            for (double u = area.left(); u + width <= area.right() + 1e-9; u += step) {
                least = Math.min(least, cost(u, v, width, height, target, least));
            }
        }
        return least;
    }

    /** The price of a place within the row that was taken; of one that costs the limit or more, any such number. */
    private double cost(double left, double top, double width, double height, Box target, double limit) {
        double right = left + width;
        double bottom = top + height;
        double gapU = gap(left, right, target.left(), target.right());
        double gapV = gap(top, bottom, target.top(), target.bottom());
        double offU = (left + right - target.left() - target.right()) / 2;
        double offV = (top + bottom - target.top() - target.bottom()) / 2;
        // a plain root, a little too small, tells most places that are too far: hypot takes far longer
        double least = (Math.sqrt(gapU * gapU + gapV * gapV) + 0.03 * Math.sqrt(offU * offU + offV * offV))
                * LESS_BY_ROUNDING / unitPx;
        if (least > limit) {
            return least;
        }
        // off-centre costs a little, so that a label goes beside the middle of what it names
        double cost = Math.hypot(gapU, gapV) / unitPx + 0.03 * Math.hypot(offU, offV) / unitPx;
        double size = (right - left) * (bottom - top);
        for (int i = 0; i < row.hard.size() && cost < limit; i++) {
            Box box = row.hard.get(i);
            // a small marker is covered whole by a small part of a label
            cost += HARD * overlap(box, left, top, right, bottom)
                    / Math.min(size, (box.right() - box.left()) * (box.bottom() - box.top()));
        }
        for (int i = 0; i < row.soft.size() && cost < limit; i++) {
            cost += SOFT * overlap(row.soft.get(i), left, top, right, bottom) / size;
        }
        return cost;
    }

    /** The boxes that reach into a strip across the image, so that places in it are judged by few of many. */
    private final class Row {
        private final List<Box> hard = new ArrayList<>();
        private final List<Box> soft = new ArrayList<>();

        void take(double top, double bottom) {
            within(LabelPlacer.this.hard, top, bottom, hard);
            within(LabelPlacer.this.soft, top, bottom, soft);
        }

        private void within(List<Box> all, double top, double bottom, List<Box> some) {
            some.clear();
            for (int i = 0; i < all.size(); i++) {
                if (all.get(i).top() < bottom && all.get(i).bottom() > top) {
                    some.add(all.get(i));
                }
            }
        }
    }

    /** The way between two stretches of an axis, 0 where they touch. */
    private static double gap(double from, double to, double otherFrom, double otherTo) {
        return Math.max(0, Math.max(otherFrom - to, from - otherTo));
    }

    private static double overlap(Box box, double left, double top, double right, double bottom) {
        double w = Math.min(right, box.right()) - Math.max(left, box.left());
        double h = Math.min(bottom, box.bottom()) - Math.max(top, box.top());
        return w > 0 && h > 0 ? w * h : 0;
    }
}
