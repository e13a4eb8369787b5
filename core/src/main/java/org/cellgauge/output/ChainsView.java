package org.cellgauge.output;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Diagnostics;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.QuantityLayout;
import org.cellgauge.settings.SamplingSettings;
import org.cellgauge.statistics.ChainDiagnostics;
import org.jspecify.annotations.Nullable;

/** How the chains went, as a result file has it: NaN for what does not exist; immutable. */
public final class ChainsView extends Value {
    /** Keys of the numbers in a result file, in the order in which they are kept. */
    static final String[] KEYS = {"r_hat_max", "ess_bulk_min", "ess_tail_min", "mcse_std_rel_max", "pareto_k_max"};

    private final boolean converged;
    private final String convergence;
    private final double[] numbers;
    private final @Nullable Boolean precisionReached;
    private final long tuningEvaluations;
    private final long chainEvaluations;
    private final @Nullable String worstParameter;
    private final List<AcceptanceCount> acceptance;
    private final Supplier<List<QuantityView>> make;
    /** Made when first asked for: errors of quantiles take time, and most who look at a result do not look here. */
    private @Nullable List<QuantityView> quantities;

    /**
     * How chains went.
     *
     * @param numbers in the order of {@link #KEYS}
     * @param evaluations of the camera's posterior: before the chains, and by them
     */
    ChainsView(boolean converged, String convergence, double[] numbers, @Nullable Boolean precisionReached,
            long[] evaluations, @Nullable String worstParameter, List<AcceptanceCount> acceptance,
            Supplier<List<QuantityView>> quantities) {
        this.converged = converged;
        this.convergence = convergence;
        this.numbers = Figures.finite(numbers);
        this.precisionReached = precisionReached;
        tuningEvaluations = evaluations[0];
        chainEvaluations = evaluations[1];
        this.worstParameter = worstParameter;
        this.acceptance = Collections.unmodifiableList(new ArrayList<>(acceptance));
        make = quantities;
    }

    static ChainsView of(CheckResult result) {
        Diagnostics d = result.diagnostics();
        QuantityLayout layout = result.layout();
        SamplingSettings sampling = result.settings().sampling();
        Boolean reached = sampling.iterations().isPresent() ? null
                : Boolean.valueOf(d.mcseStdRelMax() < sampling.targetMcseStdRel() && !d.heavyTails());
        return new ChainsView(d.converged(), QuantityView.word(d.convergence()), new double[] {d.rHatMax(),
            d.essBulkMin(), d.essTailMin(), d.mcseStdRelMax(), d.paretoKMax()}, reached,
                new long[] {result.tuningEvaluations(), (long) sampling.chains() * result.iterationsPerChain()},
                d.worstParameter() == null ? null : d.worstParameter().name(), result.acceptance(),
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
     * The judgement on convergence.
     *
     * @return a word of the result file, such as {@code converged}
     */
    public String convergence() {
        return convergence;
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

    /** All of these numbers, in the order of {@link #KEYS}. */
    double[] numbers() {
        return numbers.clone();
    }

    /**
     * Whether Monte Carlo errors are as small as was asked for.
     *
     * @return null where the length of the chains was fixed
     */
    public @Nullable Boolean precisionReached() {
        return precisionReached;
    }

    /**
     * How often the camera's posterior was evaluated before the chains, to fit their proposal.
     *
     * @return a count
     */
    public long tuningEvaluations() {
        return tuningEvaluations;
    }

    /**
     * How often the chains evaluated it.
     *
     * @return a count
     */
    public long chainEvaluations() {
        return chainEvaluations;
    }

    /**
     * The quantity that is worst off.
     *
     * @return its name, or null where none is judged
     */
    public @Nullable String worstParameter() {
        return worstParameter;
    }

    /**
     * Accepted and rejected suggestions per named proposal, all chains together.
     *
     * @return unmodifiable
     */
    public List<AcceptanceCount> acceptance() {
        return acceptance;
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

    /**
     * One quantity.
     *
     * @param name such as {@code object_5_x_mm}
     * @return its figures, or null where draws have no such quantity
     */
    public @Nullable QuantityView quantity(String name) {
        for (QuantityView quantity : quantities()) {
            if (quantity.name().equals(name)) {
                return quantity;
            }
        }
        return null;
    }

    @Override
    @Nullable Object[] figures() {
        List<Object> counts = new ArrayList<>();
        for (AcceptanceCount count : acceptance) {
            counts.add(count.proposal());
            counts.add(count.accepted());
            counts.add(count.rejected());
        }
        return new @Nullable Object[] {converged, convergence, numbers, precisionReached, tuningEvaluations,
            chainEvaluations, worstParameter, counts, quantities()};
    }
}
