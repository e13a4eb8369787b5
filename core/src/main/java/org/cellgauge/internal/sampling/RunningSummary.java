package org.cellgauge.internal.sampling;

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
    private final RunningMoments[] moments;
    private final @Nullable CircularMoments[] directions;
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
        moments = new RunningMoments[scratch.length];
        for (int g = 0; g < scratch.length; g++) {
            int size = layout.groups().get(g).length;
            moments[g] = new RunningMoments(size);
            scratch[g] = new double[size];
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
        for (int g = 0; g < moments.length; g++) {
            int[] indices = layout.groups().get(g);
            double[] values = scratch[g];
            for (int i = 0; i < indices.length; i++) {
                int q = indices[i];
                // angles enter as reference plus wrapped deviation, so that +pi and -pi are neighbours
                values[i] = layout.isAngle(q)
                        ? layout.referenceRad(q) + Angles.difference(quantities[q], layout.referenceRad(q))
                        : quantities[q];
            }
            moments[g].add(values);
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
        for (int g = 0; g < moments.length; g++) {
            moments[g].merge(other.moments[g]);
        }
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
     * @param group its index in the layout
     * @return a new array
     */
    public double[] mean(int group) {
        int[] indices = layout.groups().get(group);
        double[] mean = moments[group].mean();
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
     * @param group its index in the layout
     * @return a new matrix, unbiased (divided by count - 1)
     */
    public double[][] covariance(int group) {
        return moments[group].covariance();
    }

    /**
     * Directional moments of an angle.
     *
     * @param index position of the angle
     * @return a copy, or null for what is no angle
     */
    public @Nullable CircularMoments direction(int index) {
        CircularMoments own = directions[index];
        return own == null ? null : own.copy();
    }
}
