package org.cellgauge.internal.plan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
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
    private static final int MOST_PROPOSALS = 5;
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
        OptionalDouble target = layout.cell().targetStdMm();
        double unit = target.orElse(1);
        Levers levers = new Levers(layout, options);
        double worstNow = levers.worst(layout, false);
        List<Tried> singles = new ArrayList<>();
        for (Levers.Step step : levers.steps()) {
            Tried tried = tried(levers, List.of(step));
            if (tried != null) {
                singles.add(tried);
            }
        }
        List<Tried> useful = new ArrayList<>(singles);
        useful.removeIf(t -> !(t.worst() < worstNow * USEFUL));
        List<Tried> all = new ArrayList<>(useful);
        useful.sort(Comparator.comparingDouble(t -> Math.log(t.worst()) - 1e-3 * t.cost()));
        List<Tried> combined = useful.subList(0, Math.min(COMBINED, useful.size()));
        combine(levers, combined, 2, all);
        if (target.isPresent() && all.stream().noneMatch(t -> t.worst() <= 1)) {
            combine(levers, combined, 3, all);
        }
        List<Tried> front = front(all);
        List<Tried> best = new ArrayList<>(all);
        if (target.isPresent() && all.stream().anyMatch(t -> t.worst() <= 1)) {
            best.removeIf(t -> !(t.worst() <= 1));
            best.sort(Comparator.comparingDouble(Tried::cost).thenComparingDouble(Tried::worst));
            best = withoutNeedless(best);
        } else {
            best.sort(Comparator.comparingDouble(Tried::worst));
            best = best.subList(0, Math.min(1, best.size()));
        }
        List<Plan.Certificate> certificates = new ArrayList<>();
        for (Tried single : singles) {
            if (single.steps().get(0).group().equals("added")) {
                int count = certificates.size() + 1;
                certificates.add(new Plan.Certificate(count, Math.sqrt(single.worst()) * unit,
                        Math.sqrt(levers.bound(count)) * unit));
            }
        }
        return new Plan(layout, now, target, proposals(levers, best), proposals(levers, front),
                proposals(levers, largest(singles)), now.boundStdMm(), certificates);
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
        return tried.steps().stream().map(Levers.Step::group).toList();
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
            List<Change> changes = t.steps().stream().map(Levers.Step::change).toList();
            out.add(new Proposal(changes, t.layout(), levers.model(t.layout(), t.calibrated()).forecast()));
        }
        return out;
    }
}
