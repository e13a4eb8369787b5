package org.cellgauge.placement;

import java.util.ArrayList;
import java.util.List;

/**
 * Which of many boxes touch each other: along the axis on which they are spread widest, each is compared with those
 * alone that begin before it ends (sweep and prune: Cohen, Lin, Manocha, Ponamgi, "I-COLLIDE", Symposium on Interactive
 * 3D Graphics 1995, section 3).
 */
final class BoxSweep {
    private BoxSweep() {
    }

    /**
     * Pairs that touch.
     *
     * @param least by box and axis
     * @param most by box and axis, not less
     * @return pairs of indices, the smaller one first; in the order of the larger one, then of the smaller one
     */
    static List<int[]> touching(List<double[]> least, List<double[]> most) {
        List<int[]> pairs = new ArrayList<>();
        if (least.isEmpty()) {
            return pairs;
        }
        int along = widest(least);
        List<Integer> order = new ArrayList<>();
        for (int i = 0; i < least.size(); i++) {
            order.add(i);
        }
        order.sort((i, j) -> Double.compare(least.get(i)[along], least.get(j)[along]));
        for (int i = 0; i < order.size(); i++) {
            int box = order.get(i);
            double end = most.get(box)[along];
            for (int j = i + 1; j < order.size() && least.get(order.get(j))[along] <= end; j++) {
                int other = order.get(j);
                if (touch(least, most, box, other)) {
                    pairs.add(new int[] {Math.min(box, other), Math.max(box, other)});
                }
            }
        }
        pairs.sort((a, b) -> a[1] != b[1] ? Integer.compare(a[1], b[1]) : Integer.compare(a[0], b[0]));
        return pairs;
    }

    private static int widest(List<double[]> of) {
        int widest = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int axis = 0; axis < of.get(0).length; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (double[] box : of) {
                low = Math.min(low, box[axis]);
                high = Math.max(high, box[axis]);
            }
            if (high - low > most) {
                most = high - low;
                widest = axis;
            }
        }
        return widest;
    }

    private static boolean touch(List<double[]> least, List<double[]> most, int a, int b) {
        for (int axis = 0; axis < least.get(a).length; axis++) {
            if (least.get(a)[axis] > most.get(b)[axis] || least.get(b)[axis] > most.get(a)[axis]) {
                return false;
            }
        }
        return true;
    }
}
