package org.cellgauge.internal.statistics;

import org.apache.commons.math3.special.Erf;

/**
 * How much of a normal distribution of three components about 0 lies near 0.
 *
 * <p>A normal vector is {@code r A w}: w a direction, all alike, r from the chi distribution with three degrees of
 * freedom, independent of it, and A a root of the covariance S. So the probability of a distance up to d is the mean
 * over directions of the chance that {@code r <= d / sqrt(w^T S w)} (Johnson, Kotz and Balakrishnan, "Continuous
 * univariate distributions", 2nd ed., section 18.8, for quadratic forms).
 */
public final class NormalBall {
    /** Gauss and Legendre's nodes and weights on [0, 1], 12 of them, by symmetry about 0.5. */
    private static final double[] NODES = {0.562616704255734458, 0.683915749499090094, 0.793658977143308724,
        0.884951337097152333, 0.952058628185237433, 0.990780317123359628};
    private static final double[] WEIGHTS = {0.124573522906701392, 0.116746268269177404, 0.101583713361532961,
        0.0800391642716731131, 0.0534696629976592155, 0.0235876681932559135};
    private static final int AROUND = 24;
    private static final int HALVINGS = 50;

    private NormalBall() {
    }

    /**
     * Probability of a value within some standard deviations of the mean, either side.
     *
     * @param deviations not negative
     * @return from 0 to 1
     */
    public static double within(double deviations) {
        return Erf.erf(deviations / Math.sqrt(2));
    }

    /**
     * How many standard deviations hold a probability, either side of the mean.
     *
     * @param probability in (0, 1)
     * @return deviations
     */
    public static double deviations(double probability) {
        return NormalQuantile.of(0.5 + 0.5 * probability);
    }

    /**
     * Probability of a distance from the mean.
     *
     * @param covariance 3 x 3
     * @param distance not negative, in the unit of deviations
     * @return from 0 to 1, to about 1e-6
     */
    public static double within(double[] covariance, double distance) {
        double total = 0;
        for (int i = 0; i < 2 * NODES.length; i++) {
            int node = i / 2;
            // directions c = cos(angle from z) are alike; those below the plane are those above it again
            double c = i % 2 == 0 ? NODES[node] : 1 - NODES[node];
            double s = Math.sqrt(1 - c * c);
            double around = 0;
            for (int k = 0; k < AROUND; k++) {
                double angle = 2 * Math.PI * k / AROUND;
                double x = s * Math.cos(angle);
                double y = s * Math.sin(angle);
                double square = x * x * covariance[0] + y * y * covariance[4] + c * c * covariance[8]
                        + 2 * (x * y * covariance[1] + x * c * covariance[2] + y * c * covariance[5]);
                around += square > 0 ? ofChi(distance / Math.sqrt(square)) : 1;
            }
            total += WEIGHTS[node] * around / AROUND;
        }
        return Math.min(1, total);
    }

    /**
     * The distance from the mean that holds a probability.
     *
     * @param covariance 3 x 3, finite
     * @param probability in (0, 1)
     * @return in the unit of deviations
     */
    public static double distance(double[] covariance, double probability) {
        double trace = covariance[0] + covariance[4] + covariance[8];
        double low = 0;
        // of one trace, none of these has more outside than one along a line, for probabilities that are large
        double high = 2 * deviations(Math.max(probability, 0.5)) * Math.sqrt(trace);
        for (int i = 0; i < HALVINGS && high > low * (1 + 1e-9); i++) {
            double middle = 0.5 * (low + high);
            if (within(covariance, middle) < probability) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return 0.5 * (low + high);
    }

    /** Distribution of the length of three independent standard normal values. */
    private static double ofChi(double r) {
        return Double.isInfinite(r) ? 1 : Erf.erf(r / Math.sqrt(2))
                - Math.sqrt(2 / Math.PI) * r * Math.exp(-0.5 * r * r);
    }
}
