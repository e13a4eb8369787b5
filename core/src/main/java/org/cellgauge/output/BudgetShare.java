package org.cellgauge.output;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.cellgauge.estimate.VarianceBudget;
import org.cellgauge.estimate.VarianceSource;
import org.jspecify.annotations.Nullable;

/** What one source contributes to the variance of a point, and what taking it away would gain; immutable. */
public final class BudgetShare extends Value {
    private final VarianceSource source;
    private final double[] shares;
    private final double[] gains;

    /** Of both: all axes together, then x, y, z. */
    BudgetShare(VarianceSource source, double[] shares, double[] gains) {
        this.source = source;
        this.shares = Figures.finite(shares);
        this.gains = Figures.finite(gains);
    }

    /** All sources of a budget, in its order. */
    static List<BudgetShare> of(VarianceBudget budget) {
        List<Map<VarianceSource, Double>> shares = new ArrayList<>();
        List<Map<VarianceSource, Double>> gains = new ArrayList<>();
        shares.add(budget.shares());
        gains.add(budget.gains());
        for (int axis = 0; axis < 3; axis++) {
            shares.add(budget.shares(axis));
            gains.add(budget.gains(axis));
        }
        List<BudgetShare> all = new ArrayList<>();
        for (VarianceSource source : budget.shares().keySet()) {
            all.add(new BudgetShare(source, column(shares, source), column(gains, source)));
        }
        return Collections.unmodifiableList(all);
    }

    static double[] column(List<Map<VarianceSource, Double>> of, VarianceSource source) {
        return of.stream().mapToDouble(part -> part.getOrDefault(source, Double.NaN)).toArray();
    }

    /**
     * The source.
     *
     * @return never null
     */
    public VarianceSource source() {
        return source;
    }

    /**
     * Its share of the variance, all axes together.
     *
     * @return 0 to 1
     */
    public double share() {
        return shares[0];
    }

    /**
     * Its share of the variance along one axis.
     *
     * @param axis 0, 1, 2 for world x, y, z
     * @return 0 to 1
     */
    public double share(int axis) {
        return shares[1 + axis];
    }

    /**
     * What taking it away would take off the standard deviation, all axes together.
     *
     * @return 0 to 1; NaN for what cannot be taken away
     */
    public double gain() {
        return gains[0];
    }

    /**
     * The same along one axis.
     *
     * @param axis 0, 1, 2 for world x, y, z
     * @return 0 to 1; NaN for what cannot be taken away
     */
    public double gain(int axis) {
        return gains[1 + axis];
    }


    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {source, shares, gains};
    }

    @Override
    public String toString() {
        return source + " " + shares[0];
    }
}
