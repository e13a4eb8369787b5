package org.cellgauge.internal.sampling;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.cellgauge.internal.statistics.Angles;
import org.cellgauge.internal.statistics.CircularMoments;
import org.cellgauge.internal.statistics.RunningMoments;
import org.cellgauge.sampling.QuantityLayout;
import org.jspecify.annotations.Nullable;

/**
 * Running means, covariances per group and mean directions of all draws so far, in memory that does not grow with them.
 * Summaries of several chains merge into one. Not thread-safe.
 */
public final class RunningSummary {
    private final QuantityLayout layout;
    /** Groups that are summarised, and the angles among their quantities, both ascending. */
    private final int[] groups;
    private final int[] angles;
    /** By place among these: a summary of few quantities is small however many there are. */
    private final RunningMoments[] moments;
    private final CircularMoments[] directions;
    private final int[][] ofGroups;
    private final double[] scratch;
    private long count;

    /**
     * An empty summary of all groups.
     *
     * @param layout quantities of a draw
     */
    public RunningSummary(QuantityLayout layout) {
        this(layout, IntStream.range(0, layout.groups().size()).toArray(), true);
    }

    /**
     * An empty summary of some groups: a draw takes as long as these have quantities, however many a cell has.
     *
     * @param layout quantities of a draw
     * @param groups indices in the layout; of others nothing may be asked
     * @return a new summary
     */
    public static RunningSummary ofGroups(QuantityLayout layout, int... groups) {
        return new RunningSummary(layout, groups.clone(), false);
    }

    private RunningSummary(QuantityLayout layout, int[] groups, boolean all) {
        this.layout = layout;
        Arrays.sort(groups);
        this.groups = groups;
        ofGroups = new int[groups.length][];
        moments = new RunningMoments[groups.length];
        int largest = 0;
        IntStream quantities = all ? IntStream.range(0, layout.size())
                : IntStream.of(groups).flatMap(g -> IntStream.of(layout.groups().get(g))).distinct();
        angles = quantities.filter(layout::isAngle).sorted().toArray();
        for (int g = 0; g < groups.length; g++) {
            int size = layout.groups().get(groups[g]).length;
            moments[g] = new RunningMoments(size);
            ofGroups[g] = layout.groups().get(groups[g]);
            largest = Math.max(largest, size);
        }
        scratch = new double[largest];
        directions = new CircularMoments[angles.length];
        for (int a = 0; a < angles.length; a++) {
            directions[a] = new CircularMoments();
        }
    }

    /**
     * Adds a draw.
     *
     * @param quantities one value per quantity of the layout; what no group summarises is not read
     */
    public void add(double[] quantities) {
        count++;
        for (int g = 0; g < groups.length; g++) {
            int[] indices = ofGroups[g];
            for (int i = 0; i < indices.length; i++) {
                int q = indices[i];
                // angles enter as reference plus wrapped deviation, so that +pi and -pi are neighbours
                scratch[i] = layout.isAngle(q)
                        ? layout.referenceRad(q) + Angles.difference(quantities[q], layout.referenceRad(q))
                        : quantities[q];
            }
            moments[g].add(scratch, 0);
        }
        for (int a = 0; a < angles.length; a++) {
            directions[a].add(quantities[angles[a]]);
        }
    }

    /**
     * Takes in all draws of another summary of the same layout and groups.
     *
     * @param other left as it is
     */
    public void merge(RunningSummary other) {
        count += other.count;
        for (int g = 0; g < groups.length; g++) {
            moments[g].merge(other.moments[g]);
        }
        for (int a = 0; a < angles.length; a++) {
            directions[a].merge(other.directions[a]);
        }
    }

    /**
     * Number of draws.
     *
     * @return not negative
     */
    public long count() {
        return count;
    }

    /**
     * The quantities' layout.
     *
     * @return shared, immutable
     */
    public QuantityLayout layout() {
        return layout;
    }

    /**
     * Mean of a group; angles as mean directions in (-pi, pi].
     *
     * @param group its index in the layout
     * @return a new array
     */
    public double[] mean(int group) {
        int[] indices = layout.groups().get(group);
        double[] mean = moments[placeOf(group)].mean();
        for (int i = 0; i < indices.length; i++) {
            if (layout.isAngle(indices[i])) {
                double direction = directions[Arrays.binarySearch(angles, indices[i])].meanDirectionRad();
                mean[i] = Double.isNaN(direction) ? Angles.wrapToPi(mean[i]) : direction;
            }
        }
        return mean;
    }

    /**
     * Covariance of a group; angles by their wrapped deviation from the reference direction.
     *
     * @param group its index in the layout
     * @return a new matrix, unbiased (divided by count - 1)
     */
    public double[][] covariance(int group) {
        return moments[placeOf(group)].covariance();
    }

    private int placeOf(int group) {
        int place = Arrays.binarySearch(groups, group);
        if (place < 0) {
            throw new IllegalArgumentException("group " + group + " is not summarised");
        }
        return place;
    }

    /**
     * Directional moments of an angle.
     *
     * @param index position of the angle
     * @return a copy, or null for what is no angle of a group
     */
    public @Nullable CircularMoments direction(int index) {
        int place = Arrays.binarySearch(angles, index);
        return place < 0 ? null : directions[place].copy();
    }
}
