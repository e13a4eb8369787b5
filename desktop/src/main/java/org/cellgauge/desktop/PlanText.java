package org.cellgauge.desktop;

import java.util.List;
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
        out.append(String.format(Locale.ROOT, "Predicted, not measured: camera at (%.0f, %.0f, %.0f) mm, %d of %d "
                + "references in view, %s.%n%n", at[0], at[1], at[2], plan.now().references().size(),
                plan.layout().cell().references().size(), plan.layout().cell().pixelStdPx().isPresent()
                        ? "corner noise " + plan.layout().cell().pixelStdPx().getAsDouble() + " px as stated"
                        : "corner noise as the photo's fit would state it"));
        TextTable table = new TextTable(2);
        table.row("object", "point", "std x", "y", "z mm", "its own corners leave",
                plan.targetStdMm().isPresent() ? "target " + plan.targetStdMm().getAsDouble() + " mm" : "");
        for (Forecast.Row row : plan.now().rows()) {
            table.row(String.valueOf(row.object()), row.grip() ? "grip" : "marker", mm(row.xStdMm()),
                    mm(row.yStdMm()), mm(row.zStdMm()), mm(row.ownStdMm()),
                    plan.targetStdMm().isEmpty() ? ""
                            : row.worstStdMm() <= plan.targetStdMm().getAsDouble() ? "met" : "missed");
        }
        for (int id : plan.now().unseen()) {
            table.row(String.valueOf(id), "", "-", "-", "-", "-", "not in view");
        }
        out.append(table.text("")).append('\n');
        verdict(plan, out);
        single(plan, out);
        front(plan, out);
        for (Plan.Certificate c : plan.certificate()) {
            if (c.references() > 1) {
                out.append(String.format(Locale.ROOT, "Places for %d more references: best found %s mm, none of those "
                        + "tried can be below %s mm (%s).%n", c.references(), mm(c.foundStdMm()), mm(c.boundStdMm()),
                        c.proven() ? "proven to " + percent(c.gap()) : "not proven: a gap of " + percent(c.gap())));
            }
        }
        return out.toString();
    }

    private static void verdict(Plan plan, StringBuilder out) {
        if (plan.targetStdMm().isPresent()) {
            double target = plan.targetStdMm().getAsDouble();
            out.append(plan.met() ? "The target is met.\n" : "The target is missed.\n");
            if (!plan.referencesCouldMeetIt()) {
                out.append(String.format(Locale.ROOT, "No reference can mend that: objects' own corners leave %s mm, "
                        + "more than the target of %s mm. Their markers have to be larger in the photo.%n",
                        mm(plan.boundStdMm()), mm(target)));
            }
            if (!plan.met()) {
                boolean meets = !plan.best().isEmpty() && plan.isMetBy(plan.best().get(0).forecast());
                out.append(meets ? "\nWhat meets it, cheapest first:\n"
                        : "\nNothing that was tried meets it. What comes nearest:\n");
                proposals(plan.best(), out);
            }
        } else {
            out.append("No target is set, so nothing is missed.\n");
        }
        out.append('\n');
    }

    private static void proposals(List<Proposal> proposals, StringBuilder out) {
        int number = 1;
        for (Proposal proposal : proposals) {
            out.append(String.format(Locale.ROOT, "  %d. %s%n     -> %s mm (cost %.0f)%n", number++,
                    proposal.sentence(), mm(proposal.forecast().worstStdMm()), proposal.cost()));
        }
    }

    private static void single(Plan plan, StringBuilder out) {
        double now = plan.now().worstStdMm();
        out.append(String.format(Locale.ROOT, "Single changes, of now %s mm:%n", mm(now)));
        StringBuilder needless = new StringBuilder();
        for (Proposal proposal : plan.single()) {
            double then = proposal.forecast().worstStdMm();
            String line = String.format(Locale.ROOT, "  %s mm  %s (cost %.0f)%n", mm(then), proposal.sentence(),
                    proposal.cost());
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
            out.append(String.format(Locale.ROOT, "  cost %.0f: %s mm  %s%n", proposal.cost(),
                    mm(proposal.forecast().worstStdMm()), proposal.sentence()));
        }
        out.append('\n');
    }

    private static String mm(double value) {
        return Double.isInfinite(value) ? "-" : String.format(Locale.ROOT, value < 1 ? "%.3f" : "%.2f", value);
    }

    private static String percent(double share) {
        return String.format(Locale.ROOT, "%.1f %%", 100 * share);
    }
}
