package org.cellgauge.output;

import java.util.Arrays;
import java.util.Locale;
import org.cellgauge.internal.statistics.Angles;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.statistics.ChainDiagnostics;
import org.jspecify.annotations.Nullable;

/** What the chains say of one quantity, as a result file has it: NaN for what does not exist; immutable. */
public final class QuantityView extends Value {
    static final int[] QUANTILE_PERCENT = {5, 50, 95};
    /** Keys of the numbers in a result file, in the order in which they are kept. */
    static final String[] KEYS = {"mean", "std", "r_hat", "ess_bulk", "ess_tail", "mcse_mean", "mcse_std", "pareto_k",
        "q5", "q50", "q95", "mcse_q5", "mcse_q50", "mcse_q95"};

    private final String name;
    private final String status;
    private final double[] numbers;

    /** @param numbers in the order of {@link #KEYS} */
    QuantityView(String name, String status, double[] numbers) {
        this.name = name;
        this.status = status;
        this.numbers = Figures.finite(numbers);
    }

    static QuantityView of(Quantity quantity, boolean angle, ChainDiagnostics d, double paretoK) {
        double[] numbers = new double[KEYS.length];
        double[] first = {wrapped(angle, d.mean()), d.std(), d.rHat(), d.essBulk(), d.essTail(), d.mcseMean(),
            d.mcseSd(), paretoK};
        System.arraycopy(first, 0, numbers, 0, first.length);
        int at = first.length;
        for (int percent : QUANTILE_PERCENT) {
            numbers[at++] = wrapped(angle, d.quantile(percent / 100.0));
        }
        for (int percent : QUANTILE_PERCENT) {
            numbers[at++] = d.mcseQuantile(percent / 100.0);
        }
        return new QuantityView(quantity.name(), word(d.status()), numbers);
    }

    static String word(Enum<?> value) {
        return value.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    private static double wrapped(boolean angle, double value) {
        return angle && Double.isFinite(value) ? Angles.wrapToPi(value) : value;
    }

    /**
     * The quantity, by the name of its column in files of draws.
     *
     * @return such as {@code object_5_x_mm}
     */
    public String name() {
        return name;
    }

    /**
     * Whether it could be diagnosed.
     *
     * @return {@code ok}, {@code constant}, {@code non-finite} or {@code too-short}
     */
    public String status() {
        return status;
    }

    /**
     * Mean of the draws.
     *
     * @return in the quantity's unit; angles in (-pi, pi]
     */
    public double mean() {
        return numbers[0];
    }

    /**
     * Standard deviation of the draws.
     *
     * @return in the quantity's unit
     */
    public double std() {
        return numbers[1];
    }

    /**
     * R-hat.
     *
     * @return at least about 1
     */
    public double rHat() {
        return numbers[2];
    }

    /**
     * Effective number of draws in the bulk.
     *
     * @return a count
     */
    public double essBulk() {
        return numbers[3];
    }

    /**
     * Effective number of draws in the tails.
     *
     * @return a count
     */
    public double essTail() {
        return numbers[4];
    }

    /**
     * Monte Carlo error of the mean.
     *
     * @return in the quantity's unit
     */
    public double mcseMean() {
        return numbers[5];
    }

    /**
     * Monte Carlo error of the standard deviation.
     *
     * @return in the quantity's unit
     */
    public double mcseStd() {
        return numbers[6];
    }

    /**
     * Any of its numbers.
     *
     * @param key its key in a result file, such as {@code mcse_q95}
     * @return the number, NaN where it does not exist
     * @throws IllegalArgumentException if there is no such key
     */
    public double number(String key) {
        int i = Arrays.asList(KEYS).indexOf(key);
        if (i < 0) {
            throw new IllegalArgumentException("no number of a quantity is called " + key);
        }
        return numbers[i];
    }


    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {name, status, numbers};
    }

    @Override
    public String toString() {
        return name + " " + numbers[0] + " +- " + numbers[1];
    }
}
