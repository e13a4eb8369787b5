package org.cellgauge.desktop;

import java.util.Locale;
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
     * @return lines, each ended by a line feed
     */
    public static String of(Plan plan) {
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
        verdict(plan, out);
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

    private static void verdict(Plan plan, StringBuilder out) {
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
                proposals(plan, out);
            }
        } else {
            out.append("No target is set, so nothing is missed.\n");
        }
        out.append('\n');
    }

    private static void proposals(Plan plan, StringBuilder out) {
        int number = 1;
        for (Proposal proposal : plan.best()) {
            out.append(String.format(Locale.ROOT, "  %d. %s%n     -> %s (cost %.0f)%n", number++,
                    proposal.sentence(), figure(plan, proposal.forecast()), proposal.cost()));
        }
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
