package org.cellgauge.check;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.internal.sampling.OwnThreads;
import org.cellgauge.internal.statistics.DrawsWork;
import org.cellgauge.internal.statistics.ParetoTail;
import org.cellgauge.sampling.Draws;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.sampling.QuantityLayout;
import org.cellgauge.statistics.ChainDiagnostics;
import org.cellgauge.statistics.Convergence;
import org.jspecify.annotations.Nullable;

/**
 * Convergence of all chains, quantity by quantity; immutable. What does not count for the judgement is diagnosed when
 * it is asked for: few ask.
 */
public final class Diagnostics {
    private final List<Draws> chains;
    private final QuantityLayout layout;
    /** By place in the layout; null where a quantity is not judged. */
    private final @Nullable ChainDiagnostics[] ofJudged;
    private final Convergence convergence;
    private final double rHatMax;
    private final double essBulkMin;
    private final double essTailMin;
    private final double mcseStdRelMax;
    private final @Nullable Quantity worst;
    private final @Nullable Quantity leastPrecise;
    private final boolean[] measured;
    private final Map<Quantity, Double> paretoK;
    private final @Nullable Quantity heaviest;
    private final double paretoKMax;
    private final DrawsWork.Pool works;

    private Diagnostics(List<Draws> chains, QuantityLayout layout, @Nullable ChainDiagnostics[] ofJudged,
            boolean[] measured, DrawsWork.Pool works) {
        this.chains = chains;
        this.works = works;
        this.layout = layout;
        this.ofJudged = ofJudged;
        Convergence overall = Convergence.CONVERGED;
        double rHat = 0;
        double bulk = Double.POSITIVE_INFINITY;
        double tail = Double.POSITIVE_INFINITY;
        double mcse = 0;
        Quantity worstOff = null;
        Quantity leastKnown = null;
        double worstBulk = Double.POSITIVE_INFINITY;
        for (int i = 0; i < ofJudged.length; i++) {
            ChainDiagnostics d = ofJudged[i];
            if (d == null) {
                continue;
            }
            Quantity quantity = layout.quantities().get(i);
            Convergence own = d.convergence();
            boolean defined = d.status() == ChainDiagnostics.Status.OK;
            double rank = defined ? Math.min(d.essBulk(), d.essTail()) : -1;
            if (own.worse(overall) != overall || (own == overall && rank < worstBulk)) {
                worstOff = quantity;
                worstBulk = rank;
            }
            overall = overall.worse(own);
            // NaN must stay: a maximum over what has no R-hat has none either
            rHat = defined && !Double.isNaN(rHat) ? Math.max(rHat, d.rHat()) : Double.NaN;
            bulk = defined && !Double.isNaN(bulk) ? Math.min(bulk, d.essBulk()) : Double.NaN;
            tail = defined && !Double.isNaN(tail) ? Math.min(tail, d.essTail()) : Double.NaN;
            if (measured[i]) {
                double share = defined ? d.mcseSd() / d.std() : Double.NaN;
                if (!Double.isNaN(mcse) && !(share <= mcse)) {
                    mcse = share;
                    leastKnown = quantity;
                }
            }
        }
        convergence = overall;
        rHatMax = rHat;
        essBulkMin = bulk;
        essTailMin = tail;
        mcseStdRelMax = mcse;
        worst = worstOff;
        leastPrecise = leastKnown;
        this.measured = measured.clone();
        paretoK = Collections.emptyMap();
        heaviest = null;
        paretoKMax = Double.NaN;
    }

    private Diagnostics(Diagnostics d, Map<Quantity, Double> paretoK) {
        chains = d.chains;
        works = d.works;
        layout = d.layout;
        ofJudged = d.ofJudged;
        convergence = d.convergence;
        rHatMax = d.rHatMax;
        essBulkMin = d.essBulkMin;
        essTailMin = d.essTailMin;
        mcseStdRelMax = d.mcseStdRelMax;
        worst = d.worst;
        leastPrecise = d.leastPrecise;
        measured = d.measured;
        this.paretoK = Collections.unmodifiableMap(paretoK);
        Quantity name = null;
        double most = Double.NaN;
        for (Map.Entry<Quantity, Double> e : paretoK.entrySet()) {
            if (name == null || e.getValue() > most) {
                name = e.getKey();
                most = e.getValue();
            }
        }
        heaviest = name;
        paretoKMax = most;
    }

    /**
     * The same with the tails of what {@link #mcseStdRelMax()} is about: once, at the end, for the fits take time.
     *
     * @param threads how many threads work, the calling one among them; no figure depends on it
     * @return the diagnostics
     */
    public Diagnostics withTails(int threads) {
        double[] k = new double[ofJudged.length];
        OwnThreads.forEach(k.length, threads, i -> k[i] = measured[i] ? at(i).paretoK() : Double.NaN);
        Map<Quantity, Double> all = new LinkedHashMap<>();
        for (int i = 0; i < k.length; i++) {
            if (!Double.isNaN(k[i])) {
                all.put(layout.quantities().get(i), k[i]);
            }
        }
        return new Diagnostics(this, all);
    }

    /**
     * Diagnoses draws.
     *
     * @param chains draws of each chain, all equally many; kept
     * @param layout quantities of a draw
     * @param judged whether a quantity counts for the overall judgement; the others are reported alone
     * @param measured whether the Monte Carlo error of its deviation counts too
     * @param threads how many threads work, the calling one among them; no figure depends on it
     * @return the diagnostics
     */
    public static Diagnostics of(List<Draws> chains, QuantityLayout layout, boolean[] judged, boolean[] measured,
            int threads) {
        @Nullable ChainDiagnostics[] ofJudged = new ChainDiagnostics[layout.size()];
        DrawsWork.Pool works = new DrawsWork.Pool();
        // quantities do not depend on each other, so the order in which threads take them changes nothing
        OwnThreads.forEach(ofJudged.length, threads, q -> ofJudged[q] = judged[q] ? diagnosed(chains, q, works) : null);
        return new Diagnostics(chains, layout, ofJudged, measured, works);
    }

    private static ChainDiagnostics diagnosed(List<Draws> chains, int quantity, DrawsWork.Pool works) {
        int count = chains.get(0).count();
        double[] series = new double[count * chains.size()];
        for (int c = 0; c < chains.size(); c++) {
            chains.get(c).series(quantity, series, c * count);
        }
        return ChainDiagnostics.of(series, chains.size(), works);
    }

    private ChainDiagnostics at(int quantity) {
        ChainDiagnostics found = ofJudged[quantity];
        return found == null ? diagnosed(chains, quantity, works) : found;
    }

    /**
     * Diagnostics of every quantity. Those that are not judged are computed at each call.
     *
     * @return unmodifiable, in the order of the draws
     */
    public Map<Quantity, ChainDiagnostics> parameters() {
        Map<Quantity, ChainDiagnostics> parameters = new LinkedHashMap<>();
        for (int q = 0; q < ofJudged.length; q++) {
            parameters.put(layout.quantities().get(q), at(q));
        }
        return Collections.unmodifiableMap(parameters);
    }

    /**
     * Diagnostics of one quantity. Of one that is not judged they are computed at each call.
     *
     * @param quantity which
     * @return its diagnostics
     * @throws IllegalArgumentException if draws have no such quantity
     */
    public ChainDiagnostics of(Quantity quantity) {
        return at(layout.indexOf(quantity));
    }

    /**
     * The overall judgement.
     *
     * @return the worst of all judged quantities
     */
    public Convergence convergence() {
        return convergence;
    }

    /**
     * Whether figures may be shown as such.
     *
     * @return true if converged
     */
    public boolean converged() {
        return convergence == Convergence.CONVERGED;
    }

    /**
     * Largest R-hat.
     *
     * @return NaN if a quantity has none
     */
    public double rHatMax() {
        return rHatMax;
    }

    /**
     * Smallest bulk effective sample size.
     *
     * @return NaN if a quantity has none
     */
    public double essBulkMin() {
        return essBulkMin;
    }

    /**
     * Smallest tail effective sample size.
     *
     * @return NaN if a quantity has none
     */
    public double essTailMin() {
        return essTailMin;
    }

    /**
     * Largest Monte Carlo error of a standard deviation, relative to it. The rotation of an object with a second pose
     * mode is left out: rare visits to that mode make up its deviation, and {@link #parameters()} has its error. Its
     * gripping point is not: a target is held against that.
     *
     * @return share; NaN if a quantity has none
     */
    public double mcseStdRelMax() {
        return mcseStdRelMax;
    }

    /**
     * The quantity whose deviation has the largest Monte Carlo error, of those that {@link #mcseStdRelMax()} is about.
     *
     * @return null where none is judged
     */
    public @Nullable Quantity leastPreciseParameter() {
        return leastPrecise;
    }

    /**
     * Shape k of the heavier tail of each quantity's draws ({@link org.cellgauge.internal.statistics.ParetoTail}).
     *
     * @return unmodifiable; of the quantities that {@link #mcseStdRelMax()} is about, where k exists
     */
    public Map<Quantity, Double> paretoK() {
        return paretoK;
    }

    /**
     * The largest of these.
     *
     * @return NaN where there is none
     */
    public double paretoKMax() {
        return paretoKMax;
    }

    /**
     * The quantity with the heaviest tail.
     *
     * @return null where there is none
     */
    public @Nullable Quantity heaviestParameter() {
        return heaviest;
    }

    /**
     * Whether tails are too heavy for Monte Carlo errors of standard deviations to be what is stated.
     *
     * @return true if the largest k is beyond {@link org.cellgauge.internal.statistics.ParetoTail#LARGEST_FOR_STD}
     */
    public boolean heavyTails() {
        return paretoKMax() > ParetoTail.LARGEST_FOR_STD;
    }

    /**
     * The quantity that is worst off.
     *
     * @return null where none is judged
     */
    public @Nullable Quantity worstParameter() {
        return worst;
    }
}
