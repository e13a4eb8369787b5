package org.cellgauge.sampling;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.cellgauge.statistics.Angles;
import org.cellgauge.statistics.CircularMoments;
import org.cellgauge.statistics.RunningMoments;
import org.jspecify.annotations.Nullable;

/**
 * Running means, covariances per group and mean directions of all draws so far, in memory that does not grow with them.
 * Summaries of several chains merge into one. Not thread-safe.
 */
public final class RunningSummary {
    private final QuantityLayout layout;
    private final Map<String, RunningMoments> moments = new LinkedHashMap<>();
    private final CircularMoments[] directions;
    private final double[][] scratch;
    private long count;

    /**
     * An empty summary.
     *
     * @param layout quantities of a draw
     */
    public RunningSummary(QuantityLayout layout) {
        this.layout = layout;
        scratch = new double[layout.groups().size()][];
        int g = 0;
        for (Map.Entry<String, int[]> group : layout.groups().entrySet()) {
            moments.put(group.getKey(), new RunningMoments(group.getValue().length));
            scratch[g++] = new double[group.getValue().length];
        }
        directions = new CircularMoments[layout.size()];
        for (int i = 0; i < directions.length; i++) {
            directions[i] = layout.isAngle(i) ? new CircularMoments() : null;
        }
    }

    /**
     * Adds a draw.
     *
     * @param quantities one value per quantity of the layout
     */
    public void add(double[] quantities) {
        count++;
        int g = 0;
        for (Map.Entry<String, int[]> group : layout.groups().entrySet()) {
            int[] indices = group.getValue();
            double[] values = scratch[g++];
            for (int i = 0; i < indices.length; i++) {
                int q = indices[i];
                // angles enter as reference plus wrapped deviation, so that +pi and -pi are neighbours
                values[i] = layout.isAngle(q)
                        ? layout.referenceRad(q) + Angles.difference(quantities[q], layout.referenceRad(q))
                        : quantities[q];
            }
            Objects.requireNonNull(moments.get(group.getKey())).add(values);
        }
        for (int i = 0; i < directions.length; i++) {
            if (directions[i] != null) {
                directions[i].add(quantities[i]);
            }
        }
    }

    /**
     * Takes in all draws of another summary of the same layout.
     *
     * @param other left as it is
     */
    public void merge(RunningSummary other) {
        count += other.count;
        moments.forEach((name, m) -> m.merge(Objects.requireNonNull(other.moments.get(name))));
        for (int i = 0; i < directions.length; i++) {
            if (directions[i] != null) {
                directions[i].merge(other.directions[i]);
            }
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
     * @param group name of the group
     * @return a new array
     */
    public double[] mean(String group) {
        int[] indices = Objects.requireNonNull(layout.groups().get(group), group);
        double[] mean = Objects.requireNonNull(moments.get(group), group).mean();
        for (int i = 0; i < indices.length; i++) {
            if (layout.isAngle(indices[i])) {
                double direction = directions[indices[i]].meanDirectionRad();
                mean[i] = Double.isNaN(direction) ? Angles.wrapToPi(mean[i]) : direction;
            }
        }
        return mean;
    }

    /**
     * Covariance of a group; angles by their wrapped deviation from the reference direction.
     *
     * @param group name of the group
     * @return a new matrix, unbiased (divided by count - 1)
     */
    public double[][] covariance(String group) {
        return Objects.requireNonNull(moments.get(group), group).covariance();
    }

    /**
     * Directional moments of an angle.
     *
     * @param index position of the angle
     * @return a copy, or null for what is no angle
     */
    public @Nullable CircularMoments direction(int index) {
        return directions[index] == null ? null : directions[index].copy();
    }
}
