package org.cellgauge.estimate;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;
import org.cellgauge.internal.estimate.Once;

/**
 * Where the variance of a point in the world comes from, by source, to first order; immutable.
 * Sources are independent, so their covariances add up (GUM, JCGM 100, 5.1.2).
 *
 * <p>Of a quick look it is worked out when a share or gain is first asked for, once, on the thread that asks.
 */
public final class VarianceBudget {
    private final Supplier<Terms> terms;

    /** Variances along world x, y, z by source, and those that are left without it, mm². */
    private static final class Terms {
        final Map<VarianceSource, double[]> variancesMm2;
        final Map<VarianceSource, double[]> leftMm2;

        Terms(Map<VarianceSource, double[]> variancesMm2, Map<VarianceSource, double[]> leftMm2) {
            this.variancesMm2 = variancesMm2;
            this.leftMm2 = leftMm2;
        }
    }

    /**
     * A budget.
     *
     * @param variancesMm2 by source: variance along world x, y, z, mm²; copied, order kept
     * @param leftMm2 by source: variance along world x, y, z that a fit leaves which knows that this source is exactly
     *     zero, mm²; copied; sources that cannot be taken away are left out
     */
    public VarianceBudget(Map<VarianceSource, double[]> variancesMm2, Map<VarianceSource, double[]> leftMm2) {
        this(new Terms(copy(variancesMm2), copy(leftMm2)));
    }

    private VarianceBudget(Terms known) {
        terms = () -> known;
    }

    private VarianceBudget(Supplier<VarianceBudget> source) {
        terms = new Once<>(() -> source.get().terms.get());
    }

    /**
     * A budget that is worked out when it is first asked for.
     *
     * @param source asked once, on the thread that asks for a share or gain; given up afterwards
     * @return the budget
     */
    public static VarianceBudget whenAsked(Supplier<VarianceBudget> source) {
        return new VarianceBudget(source);
    }

    /**
     * The same, worked out at once: what is kept for long is not to hold what it is worked out from.
     *
     * @return a budget of the same shares and gains
     */
    public VarianceBudget workedOut() {
        return new VarianceBudget(terms.get());
    }

    private static Map<VarianceSource, double[]> copy(Map<VarianceSource, double[]> map) {
        Map<VarianceSource, double[]> copy = new LinkedHashMap<>();
        map.forEach((source, v) -> copy.put(source, v.clone()));
        return copy;
    }

    /**
     * What taking a source away would take off the standard deviation, x, y and z together (root of the sum of
     * variances): what placing one reference exactly would gain, for instance.
     *
     * <p>Not the share: a reference known exactly gets more weight in the fit, which lessens what all other sources
     * contribute as well, so that gains add to more than 1 or less.
     *
     * @return by source, share of the deviation, 0 to 1; sources that cannot be taken away (a prior of the pose) are
     *     left out
     */
    public Map<VarianceSource, Double> gains() {
        return gains(new int[] {0, 1, 2});
    }

    /**
     * What taking a source away would take off the standard deviation along one axis.
     *
     * @param axis 0, 1, 2 for world x, y, z
     * @return by source, share of the deviation, 0 to 1
     */
    public Map<VarianceSource, Double> gains(int axis) {
        return gains(new int[] {axis});
    }

    private Map<VarianceSource, Double> gains(int[] axes) {
        Terms of = terms.get();
        double total = 0;
        for (double[] v : of.variancesMm2.values()) {
            for (int axis : axes) {
                total += v[axis];
            }
        }
        Map<VarianceSource, Double> gains = new LinkedHashMap<>();
        for (Map.Entry<VarianceSource, double[]> e : of.leftMm2.entrySet()) {
            double left = 0;
            for (int axis : axes) {
                left += e.getValue()[axis];
            }
            // rounding must not make a source that does nothing a loss
            gains.put(e.getKey(), Math.max(0, 1 - Math.sqrt(left / total)));
        }
        return Collections.unmodifiableMap(gains);
    }

    /**
     * Shares of the total variance, x, y and z together.
     *
     * @return by source, adding to 1
     */
    public Map<VarianceSource, Double> shares() {
        return shares(new int[] {0, 1, 2});
    }

    /**
     * Shares of the variance along one axis.
     *
     * @param axis 0, 1, 2 for world x, y, z
     * @return by source, adding to 1
     */
    public Map<VarianceSource, Double> shares(int axis) {
        return shares(new int[] {axis});
    }

    private Map<VarianceSource, Double> shares(int[] axes) {
        Terms of = terms.get();
        double total = 0;
        for (double[] v : of.variancesMm2.values()) {
            for (int axis : axes) {
                total += v[axis];
            }
        }
        Map<VarianceSource, Double> shares = new LinkedHashMap<>();
        for (Map.Entry<VarianceSource, double[]> e : of.variancesMm2.entrySet()) {
            double sum = 0;
            for (int axis : axes) {
                sum += e.getValue()[axis];
            }
            shares.put(e.getKey(), sum / total);
        }
        return Collections.unmodifiableMap(shares);
    }
}
