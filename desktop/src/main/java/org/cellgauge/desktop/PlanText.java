package org.cellgauge.desktop;

import java.util.List;
import java.util.Locale;
import org.cellgauge.check.SampledForecast;
import org.cellgauge.plan.DecisionTable;
import org.cellgauge.plan.Forecast;
import org.cellgauge.plan.Plan;
import org.cellgauge.plan.Proposal;

/** A plan as text for a terminal. */
public final class PlanText {
    /** A change that takes less than this off the largest deviation does not help, as a share of it. */
    private static final double HELPS = 0.02;

    private PlanText() {
    }

    /**
     * The plan in words and tables.
     *
     * @param plan what was found
     * @param sampled what chains say of each of {@link Plan#best()}, null where a check knows no such set-up; empty
     *     where they were not asked
     * @return lines, each ended by a line feed
     */
    public static String of(Plan plan, List<SampledForecast> sampled) {
        StringBuilder out = new StringBuilder();
        double[] at = plan.layout().worldFromCameras().get(0).translationMm();
        int cameras = plan.layout().worldFromCameras().size();
        out.append(String.format(Locale.ROOT, "Predicted, not measured: camera at (%.0f, %.0f, %.0f) mm%s, %d of %d "
                + "references in view, %s.%n%n", at[0], at[1], at[2], cameras == 1 ? "" : " and " + (cameras - 1)
                + " more poses of its range, the worst of which counts", plan.now().references().size(),
                plan.layout().cell().references().size(), plan.layout().cell().pixelStdPx().isPresent()
                        ? "corner noise " + plan.layout().cell().pixelStdPx().getAsDouble() + " px as stated"
                        : "corner noise as the photo's fit would state it"));
        TextTable table = new TextTable(2);
        table.row("object", "point", "std x", "y", "z mm", "its own corners leave",
                plan.targetStdMm().isPresent() ? "target " + plan.targetStdMm().getAsDouble() + " mm"
                        : plan.target().isAny() ? "of the target" : "",
                plan.target().asksForProbability() ? "probability" : "");
        for (Forecast.Row row : plan.now().rows()) {
            table.row(String.valueOf(row.object()), row.grip() ? "grip" : "marker", mm(row.xStdMm()),
                    mm(row.yStdMm()), mm(row.zStdMm()), mm(row.ownStdMm()),
                    !plan.target().isAny() ? "" : (plan.targetStdMm().isPresent() ? "" : percent(row.ratio()) + " ")
                            + (row.ratio() <= 1 ? "met" : "missed"),
                    Double.isNaN(row.probability()) ? "" : String.format(Locale.ROOT, "%.3f", row.probability()));
        }
        for (int id : plan.now().unseen()) {
            table.row(String.valueOf(id), "", "-", "-", "-", "-", "not in view", "");
        }
        out.append(table.text("")).append('\n');
        verdict(plan, sampled, out);
        single(plan, out);
        front(plan, out);
        for (Plan.Certificate c : plan.certificate()) {
            if (c.references() > 1) {
                out.append(String.format(Locale.ROOT, "Places for %d more references: best found %s, none of those "
                        + "tried can be below %s (%s).%n", c.references(), certified(plan, c.foundRatio()),
                        certified(plan, c.boundRatio()),
                        c.proven() ? "proven to " + percent(c.gap()) : "not proven: a gap of " + percent(c.gap())));
            }
        }
        return out.toString();
    }

    private static void verdict(Plan plan, List<SampledForecast> sampled, StringBuilder out) {
        if (plan.target().isAny()) {
            out.append(plan.met() ? "The target is met.\n" : "The target is missed.\n");
            if (!plan.referencesCouldMeetIt() && plan.now().unseen().isEmpty()) {
                out.append(String.format(Locale.ROOT, "No reference can mend that: objects' own corners leave %s, "
                        + "more than the target of %s. Their markers have to be larger in the photo.%n",
                        figure(plan, plan.boundStdMm(), plan.now().boundRatio()), plan.targetStdMm().isPresent()
                                ? mm(plan.targetStdMm().getAsDouble()) + " mm" : plan.target().toString()));
            }
            if (!plan.met()) {
                boolean meets = !plan.best().isEmpty() && plan.isMetBy(plan.best().get(0).forecast());
                out.append(meets ? "\nWhat meets it, cheapest first:\n"
                        : "\nNothing that was tried meets it. What comes nearest:\n");
                proposals(plan, sampled, out);
            }
        } else {
            out.append("No target is set, so nothing is missed.\n");
        }
        out.append('\n');
    }

    private static void proposals(Plan plan, List<SampledForecast> sampled, StringBuilder out) {
        int number = 1;
        for (Proposal proposal : plan.best()) {
            String chains = number <= sampled.size() ? "; " + chains(sampled.get(number - 1)) : "";
            out.append(String.format(Locale.ROOT, "  %d. %s%n     -> %s (cost %.0f)%s%n", number++,
                    proposal.sentence(), figure(plan, proposal.forecast()), proposal.cost(), chains));
        }
    }

    private static String chains(SampledForecast chains) {
        if (chains == null) {
            return "not sampled, because a check knows one photo of independent references";
        }
        return !chains.converged() ? "chains find no one pose or do not converge: do not trust this forecast"
                : String.format(Locale.ROOT, "chains: %s mm, %+.1f %%%s", mm(chains.sampledStdMm()),
                        100 * chains.difference(), chains.confirms() ? "" : ", so the forecast does not hold");
    }

    /**
     * A decision table in words.
     *
     * @param table what a cell would reach
     * @return lines, each ended by a line feed
     */
    public static String of(DecisionTable table) {
        StringBuilder out = new StringBuilder("Largest deviation of any object and gripping point, mm, by placement of "
                + "the references, their number and arrangement:\n\n");
        TextTable text = new TextTable(2);
        text.row("placement", "arrangement", "2 references", "3", "4", "5", "6");
        for (DecisionTable.Row row : table.rows()) {
            String[] cells = new String[2 + row.worstStdMm().size()];
            cells[0] = CheckText.plain(row.stdMm()) + " mm";
            cells[1] = arrangement(table, row);
            for (int i = 0; i < row.worstStdMm().size(); i++) {
                cells[2 + i] = mm(row.worstStdMm().get(i));
            }
            text.row(cells);
        }
        out.append(text.text("")).append("\nWhat reaches what:\n");
        double low = 0;
        for (double high : new double[] {0.2, 1, 2, 5, Double.POSITIVE_INFINITY}) {
            goal(table, low, high, out);
            low = high;
        }
        return out.toString();
    }

    private static void goal(DecisionTable table, double low, double high, StringBuilder out) {
        out.append(high == Double.POSITIVE_INFINITY ? "  above " + CheckText.plain(low) + " mm: "
                : "  " + CheckText.plain(low) + " to " + CheckText.plain(high) + " mm: ");
        int before = out.length();
        for (DecisionTable.Row row : table.rows()) {
            StringBuilder numbers = new StringBuilder();
            for (int i = 0; i < row.worstStdMm().size(); i++) {
                double worst = row.worstStdMm().get(i);
                if (worst > low && worst <= high) {
                    numbers.append(numbers.length() == 0 ? "" : ", ").append(DecisionTable.LEAST + i);
                }
            }
            if (numbers.length() > 0) {
                out.append(out.length() == before ? "" : "; ").append(numbers).append(" placed to ")
                        .append(CheckText.plain(row.stdMm())).append(" mm, ").append(arrangement(table, row));
            }
        }
        out.append(out.length() == before ? "nothing in this table\n" : "\n");
    }

    private static String arrangement(DecisionTable table, DecisionTable.Row row) {
        return row.raised() ? "one raised by " + CheckText.plain(table.raisedMm()) + " mm" : "one plane";
    }

    /** The largest deviation; with how much of the target it takes, where that is more than one deviation. */
    private static String figure(Plan plan, Forecast forecast) {
        return figure(plan, forecast.worstStdMm(), forecast.ratio());
    }

    private static String figure(Plan plan, double worstStdMm, double ratio) {
        return mm(worstStdMm) + " mm" + (plan.target().isAny() && plan.targetStdMm().isEmpty()
                ? ", " + percent(ratio) + " of the target" : "");
    }

    private static void single(Plan plan, StringBuilder out) {
        double now = plan.now().ratio();
        out.append("Single changes, of now ").append(figure(plan, plan.now())).append(":\n");
        StringBuilder needless = new StringBuilder();
        for (Proposal proposal : plan.single()) {
            double then = proposal.forecast().ratio();
            String line = String.format(Locale.ROOT, "  %s  %s (cost %.0f)%n", figure(plan, proposal.forecast()),
                    proposal.sentence(), proposal.cost());
            (then < now * (1 - HELPS) ? out : needless).append(line);
        }
        if (needless.length() > 0) {
            out.append("What does not help:\n").append(needless);
        }
        out.append('\n');
    }

    private static void front(Plan plan, StringBuilder out) {
        out.append("The most for every cost:\n");
        for (Proposal proposal : plan.front()) {
            out.append(String.format(Locale.ROOT, "  cost %.0f: %s  %s%n", proposal.cost(),
                    figure(plan, proposal.forecast()), proposal.sentence()));
        }
        out.append('\n');
    }

    private static String certified(Plan plan, double ratio) {
        return plan.target().isAny() && plan.targetStdMm().isEmpty() ? percent(ratio) + " of the target"
                : mm(ratio * plan.targetStdMm().orElse(1)) + " mm";
    }

    private static String mm(double value) {
        return Double.isInfinite(value) ? "-" : String.format(Locale.ROOT, value < 1 ? "%.3f" : "%.2f", value);
    }

    private static String percent(double share) {
        return String.format(Locale.ROOT, "%.1f %%", 100 * share);
    }
}
