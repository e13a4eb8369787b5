package org.cellgauge.output;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.cellgauge.check.Diagnostics;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.QuantityLayout;
import org.cellgauge.statistics.ChainDiagnostics;

/** How the chains went, as a result file has it: NaN for what does not exist; immutable. */
public final class ChainsView {
    private final boolean converged;
    private final double[] numbers;
    private final String worstParameter;
    private final Supplier<List<QuantityView>> make;
    /** Made when first asked for: errors of quantiles take time, and most who look at a result do not look here. */
    private List<QuantityView> quantities;

    /** @param numbers largest R-hat, least bulk and tail draws, largest error of a deviation, largest Pareto k */
    ChainsView(boolean converged, double[] numbers, String worstParameter,
            Supplier<List<QuantityView>> quantities) {
        this.converged = converged;
        this.numbers = Figures.finite(numbers);
        this.worstParameter = worstParameter;
        make = quantities;
    }

    static ChainsView of(Diagnostics d, QuantityLayout layout) {
        return new ChainsView(d.converged(), new double[] {d.rHatMax(), d.essBulkMin(), d.essTailMin(),
            d.mcseStdRelMax(), d.paretoKMax()}, d.worstParameter() == null ? null : d.worstParameter().name(),
                () -> quantities(d, layout));
    }

    private static List<QuantityView> quantities(Diagnostics d, QuantityLayout layout) {
        List<QuantityView> quantities = new ArrayList<>();
        for (Map.Entry<Quantity, ChainDiagnostics> e : d.parameters().entrySet()) {
            quantities.add(QuantityView.of(e.getKey(), layout.isAngle(layout.indexOf(e.getKey())), e.getValue(),
                    d.paretoK().getOrDefault(e.getKey(), Double.NaN)));
        }
        return quantities;
    }

    /**
     * Whether figures may be shown as such.
     *
     * @return true if the chains converged
     */
    public boolean converged() {
        return converged;
    }

    /**
     * Largest R-hat.
     *
     * @return NaN where a quantity has none
     */
    public double rHatMax() {
        return numbers[0];
    }

    /**
     * Least effective number of draws in the bulk.
     *
     * @return NaN where a quantity has none
     */
    public double essBulkMin() {
        return numbers[1];
    }

    /**
     * Least effective number of draws in the tails.
     *
     * @return NaN where a quantity has none
     */
    public double essTailMin() {
        return numbers[2];
    }

    /**
     * Largest Monte Carlo error of a standard deviation, relative to it.
     *
     * @return NaN where a quantity has none
     */
    public double mcseStdRelMax() {
        return numbers[3];
    }

    /**
     * Largest shape k of the tails.
     *
     * @return NaN where there is none
     */
    public double paretoKMax() {
        return numbers[4];
    }

    /**
     * The quantity that is worst off.
     *
     * @return its name, or null where none is judged
     */
    public String worstParameter() {
        return worstParameter;
    }

    /**
     * All quantities.
     *
     * @return unmodifiable, in the order of the draws
     */
    public synchronized List<QuantityView> quantities() {
        if (quantities == null) {
            quantities = Collections.unmodifiableList(make.get());
        }
        return quantities;
    }

    private Object[] figures() {
        return new Object[] {converged, numbers, worstParameter, quantities()};
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ChainsView && Arrays.deepEquals(figures(), ((ChainsView) other).figures());
    }

    @Override
    public int hashCode() {
        return Arrays.deepHashCode(figures());
    }
}
