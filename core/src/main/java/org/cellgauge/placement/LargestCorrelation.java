package org.cellgauge.placement;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * How nearly the test of one reference, or of one cause, is the test of another one: the largest correlation, by size.
 * Immutable.
 *
 * <p>Tests of different references have nothing in common but what the pose takes of both: their correlation is a
 * product of two short vectors. Asked for the largest product, a tree of boxes around these vectors answers without
 * looking at every one (branch and bound in a k-d tree: Bentley, "Multidimensional binary search trees used for
 * associative searching", Communications of the ACM 1975; for products: Ram and Gray, "Maximum inner-product search
 * using cone trees", KDD 2012). The few causes are compared with all tests. What is found is what comparing all with
 * all would find, to the last bit, in a time that hardly grows with the number of references.
 */
final class LargestCorrelation {
    private static final int LEAF = 8;
    /** Rounding of a product, as a share of the sum of its terms' sizes. */
    private static final double ROUNDING = 1e-12;

    private final PlacementScores scores;
    private final List<DirectionScore> tests;
    private final List<DirectionScore> causes = new ArrayList<>();
    /** Tests of references in the order of the tree's leaves, and their vectors. */
    private final List<DirectionScore> leaves = new ArrayList<>();
    private final double[][] vectors;
    /** By node, the root being 1 and the children of n 2 n and 2 n + 1: least and most of each coordinate. */
    private final double[][] least;
    private final double[][] most;

    /**
     * The tests of a photo.
     *
     * @param tests all of them
     * @param scores what they are about
     */
    LargestCorrelation(List<DirectionScore> tests, PlacementScores scores) {
        this.tests = tests;
        this.scores = scores;
        List<Leaf> unordered = new ArrayList<>();
        for (DirectionScore test : tests) {
            if (test.reference == null) {
                causes.add(test);
            } else {
                unordered.add(new Leaf(test, test.taken(scores)));
            }
        }
        int nodes = 2;
        for (int size = unordered.size(); size > LEAF; size = (size + 1) / 2) {
            nodes *= 2;
        }
        least = new double[nodes][];
        most = new double[nodes][];
        if (!unordered.isEmpty()) {
            order(unordered, 1);
        }
        vectors = new double[unordered.size()][];
        for (int i = 0; i < vectors.length; i++) {
            leaves.add(unordered.get(i).test);
            vectors[i] = unordered.get(i).vector;
        }
    }

    /** A test and its vector, of either sign: sizes of products alone count. */
    private static final class Leaf {
        final DirectionScore test;
        final double[] vector;

        Leaf(DirectionScore test, double[] taken) {
            this.test = test;
            vector = taken;
            if (vector[0] < 0) {
                for (int k = 0; k < vector.length; k++) {
                    vector[k] = -vector[k];
                }
            }
        }
    }

    /** Puts the tests of a node in the order of the tree: halves along the coordinate of which they cover most. */
    private void order(List<Leaf> of, int node) {
        double[] low = of.get(0).vector.clone();
        double[] high = low.clone();
        for (Leaf leaf : of) {
            for (int k = 0; k < low.length; k++) {
                low[k] = Math.min(low[k], leaf.vector[k]);
                high[k] = Math.max(high[k], leaf.vector[k]);
            }
        }
        least[node] = low;
        most[node] = high;
        if (of.size() > LEAF) {
            int widest = 0;
            for (int k = 1; k < low.length; k++) {
                widest = high[k] - low[k] > high[widest] - low[widest] ? k : widest;
            }
            int along = widest;
            of.sort(Comparator.comparingDouble(leaf -> leaf.vector[along]));
            int middle = middle(0, of.size());
            order(of.subList(0, middle), 2 * node);
            order(of.subList(middle, of.size()), 2 * node + 1);
        }
    }

    private static int middle(int from, int to) {
        return (from + to + 1) / 2;
    }

    /**
     * The largest correlation of a test with one of another reference or another cause.
     *
     * @param test one of the tests
     * @return 0 to 1; 0 where there is no other
     */
    double of(DirectionScore test) {
        if (test.reference == null) {
            return largest(test, tests);
        }
        double found = largest(test, causes);
        return leaves.isEmpty() ? found : new Search(test, found).run();
    }

    private double largest(DirectionScore test, List<DirectionScore> others) {
        double largest = 0;
        for (DirectionScore other : others) {
            if (!test.isOfTheSame(other)) {
                largest = Math.max(largest, test.correlation(other, scores));
            }
        }
        return largest;
    }

    /** The search for what is nearest to one test. */
    private final class Search {
        private final DirectionScore test;
        private final double[] vector;
        private double largest;

        Search(DirectionScore test, double largest) {
            this.test = test;
            this.largest = largest;
            vector = test.taken(scores);
        }

        double run() {
            below(1, 0, vectors.length);
            return largest;
        }

        private void below(int node, int from, int to) {
            if (to - from <= LEAF) {
                for (int i = from; i < to; i++) {
                    if (bound(vectors[i], vectors[i]) > largest && !test.isOfTheSame(leaves.get(i))) {
                        largest = Math.max(largest, test.correlation(leaves.get(i), scores));
                    }
                }
                return;
            }
            int middle = middle(from, to);
            double left = bound(least[2 * node], most[2 * node]);
            double right = bound(least[2 * node + 1], most[2 * node + 1]);
            // the more promising one first, so that the other one need mostly not be searched
            if (left > right && left > largest) {
                below(2 * node, from, middle);
            }
            if (right > largest) {
                below(2 * node + 1, middle, to);
            }
            if (left <= right && left > largest) {
                below(2 * node, from, middle);
            }
        }

        /** What the size of a product with any vector of a box is at most. */
        private double bound(double[] low, double[] high) {
            double up = 0;
            double down = 0;
            double sizes = 0;
            for (int k = 0; k < vector.length; k++) {
                double a = vector[k] * low[k];
                double b = vector[k] * high[k];
                up += Math.max(a, b);
                down += Math.min(a, b);
                sizes += Math.max(Math.abs(a), Math.abs(b));
            }
            return Math.max(up, -down) + ROUNDING * sizes;
        }
    }
}
