package org.cellgauge.internal.plan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.cellgauge.cell.ChangeKind;
import org.cellgauge.cell.Target;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.vision.CornerForecast;
import org.cellgauge.plan.Change;
import org.cellgauge.plan.Forecast;
import org.cellgauge.plan.Layout;
import org.cellgauge.plan.Plan;
import org.cellgauge.plan.PlanOptions;
import org.cellgauge.plan.Proposal;
import org.jspecify.annotations.Nullable;

/** Tries changes alone, then two and three together, and keeps those that no cheaper ones outdo. */
public final class PlanSearch {
    /** Changes that are combined: the most useful for what they cost. */
    private static final int COMBINED = 24;
    private static final int COMBINED_QUICKLY = 8;
    private static final int MOST_PROPOSALS = 5;
    private static final int MOST_ADVICE = 3;
    private static final double USEFUL = 0.999;

    private final Layout layout;
    private final PlanOptions options;

    private record Tried(List<Levers.Step> steps, double cost, double worst, Layout layout, boolean calibrated) {
    }

    /**
     * A search.
     *
     * @param layout the layout as it is
     * @param options what to reckon with
     */
    public PlanSearch(Layout layout, PlanOptions options) {
        this.layout = layout;
        this.options = options;
    }

    /**
     * What the layout reaches.
     *
     * @return deviations
     */
    public Forecast forecast() {
        return new LayoutModel(layout, new CornerForecast(options.toneCurve(), options.blurPx(), options.noiseGrey()),
                IntrinsicsPrior.stated(layout.cell(), options.settings().model())).forecast();
    }

    /**
     * What would reach the target.
     *
     * @return the plan
     */
    public Plan plan() {
        Forecast now = forecast();
        Target target = layout.cell().target();
        Levers levers = new Levers(layout, options, false);
        double worstNow = levers.worst(layout, false);
        List<Tried> singles = singles(levers);
        List<Tried> all = new ArrayList<>(singles);
        all.removeIf(t -> !(t.worst() < worstNow * USEFUL));
        List<Tried> combined = mostUseful(all, COMBINED);
        combine(levers, combined, 2, all);
        if (target.isAny() && all.stream().noneMatch(t -> t.worst() <= Levers.MEETS)) {
            combine(levers, combined, 3, all);
        }
        List<Tried> front = front(all);
        List<Tried> best = best(all, target);
        List<Plan.Certificate> certificates = new ArrayList<>();
        for (Tried single : singles) {
            ChangeKind kind = single.steps().get(0).change().kind();
            if (kind == ChangeKind.ADD_REFERENCE || kind == ChangeKind.ADD_REFERENCES) {
                int count = certificates.size() + 1;
                certificates.add(new Plan.Certificate(count, Math.sqrt(levers.found(count)),
                        Math.sqrt(levers.bound(count))));
            }
        }
        return new Plan(layout, now, target, proposals(levers, best), proposals(levers, front),
                proposals(levers, largest(singles)), now.boundStdMm(), certificates);
    }

    /**
     * The cheapest changes that meet the target, found quickly: fewer sizes, places and combinations than a plan tries.
     *
     * @return at most three, cheapest first; none where the target is met as it is, or where nothing that was tried
     *     meets it
     */
    public List<Proposal> advice() {
        Levers levers = new Levers(layout, options, true);
        if (!(levers.worst(layout, false) > 1)) {
            return List.of();
        }
        List<Tried> all = singles(levers);
        if (all.stream().filter(t -> t.worst() <= Levers.MEETS).map(t -> t.steps().get(0).group()).distinct().count()
                < MOST_ADVICE) {
            combine(levers, mostUseful(all, COMBINED_QUICKLY), 2, all);
        }
        all.removeIf(t -> !(t.worst() <= Levers.MEETS));
        List<Tried> best = best(all, layout.cell().target());
        return proposals(levers, best.subList(0, Math.min(MOST_ADVICE, best.size())));
    }

    private static List<Tried> singles(Levers levers) {
        List<Tried> singles = new ArrayList<>();
        for (Levers.Step step : levers.steps()) {
            Tried tried = tried(levers, List.of(step));
            if (tried != null) {
                singles.add(tried);
            }
        }
        return singles;
    }

    /** Those that bring most; what costs less is worth a little less. */
    private static List<Tried> mostUseful(List<Tried> all, int most) {
        List<Tried> sorted = new ArrayList<>(all);
        sorted.sort(Comparator.comparingDouble(t -> Math.log(t.worst()) - 1e-3 * t.cost()));
        return List.copyOf(sorted.subList(0, Math.min(most, sorted.size())));
    }

    private static List<Tried> best(List<Tried> all, Target target) {
        List<Tried> best = new ArrayList<>(all);
        if (target.isAny() && all.stream().anyMatch(t -> t.worst() <= Levers.MEETS)) {
            best.removeIf(t -> !(t.worst() <= Levers.MEETS));
            best.sort(Comparator.comparingDouble(Tried::cost).thenComparingDouble(Tried::worst));
            return withoutNeedless(best);
        }
        best.sort(Comparator.comparingDouble(Tried::worst));
        return best.subList(0, Math.min(1, best.size()));
    }

    private static @Nullable Tried tried(Levers levers, List<Levers.Step> steps) {
        @Nullable Layout changed = levers.layout();
        boolean calibrated = false;
        double cost = 0;
        for (Levers.Step step : steps) {
            changed = changed == null ? null : step.apply().apply(changed);
            calibrated |= step.calibrated();
            cost += step.change().cost();
        }
        return changed == null ? null : new Tried(steps, cost, levers.worst(changed, calibrated), changed, calibrated);
    }

    private static void combine(Levers levers, List<Tried> of, int size, List<Tried> all) {
        combine(levers, of, size, 0, new ArrayList<>(), all);
    }

    private static void combine(Levers levers, List<Tried> of, int size, int from, List<Levers.Step> steps,
            List<Tried> all) {
        if (steps.size() == size) {
            Tried tried = tried(levers, List.copyOf(steps));
            if (tried != null) {
                all.add(tried);
            }
            return;
        }
        for (int i = from; i < of.size(); i++) {
            Levers.Step step = of.get(i).steps().get(0);
            if (steps.stream().noneMatch(other -> other.group().equals(step.group()))) {
                steps.add(step);
                combine(levers, of, size, i + 1, steps, all);
                steps.remove(steps.size() - 1);
            }
        }
    }

    /** No other costs less and reaches as much. */
    private static List<Tried> front(List<Tried> all) {
        List<Tried> sorted = new ArrayList<>(all);
        sorted.sort(Comparator.comparingDouble(Tried::cost).thenComparingDouble(Tried::worst));
        List<Tried> front = new ArrayList<>();
        double least = Double.POSITIVE_INFINITY;
        for (Tried tried : sorted) {
            if (tried.worst() < least * USEFUL) {
                least = tried.worst();
                front.add(tried);
            }
        }
        return front;
    }

    /** Cheapest first, none of which a cheaper one is a part of. */
    private static List<Tried> withoutNeedless(List<Tried> sorted) {
        List<Tried> kept = new ArrayList<>();
        for (Tried tried : sorted) {
            boolean needless = kept.stream().anyMatch(other -> groups(tried).containsAll(groups(other)));
            if (!needless && kept.size() < MOST_PROPOSALS) {
                kept.add(tried);
            }
        }
        return kept;
    }

    private static List<String> groups(Tried tried) {
        return tried.steps().stream().map(Levers.Step::group).collect(Collectors.toList());
    }

    /** Of each kind of change the one that reaches most. */
    private static List<Tried> largest(List<Tried> singles) {
        Map<String, Tried> largest = new LinkedHashMap<>();
        for (Tried tried : singles) {
            String kind = tried.steps().get(0).change().kind().name();
            largest.merge(kind, tried, (a, b) -> a.worst() <= b.worst() ? a : b);
        }
        List<Tried> sorted = new ArrayList<>(largest.values());
        sorted.sort(Comparator.comparingDouble(Tried::worst));
        return sorted;
    }

    private static List<Proposal> proposals(Levers levers, List<Tried> tried) {
        List<Proposal> out = new ArrayList<>();
        for (Tried t : tried) {
            List<Change> changes = t.steps().stream().map(Levers.Step::change).collect(Collectors.toList());
            out.add(new Proposal(changes, t.layout(), levers.model(t.layout(), t.calibrated()).forecast()));
        }
        return out;
    }
}
