package org.cellgauge.desktop;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.cellgauge.check.Conformity;
import org.cellgauge.statistics.Convergence;
import org.cellgauge.survey.Drift;
import org.cellgauge.survey.SurveyResult;
import org.cellgauge.survey.SurveyRun;
import org.cellgauge.survey.SurveyedDistance;
import org.cellgauge.survey.SurveyedMeasurement;
import org.cellgauge.survey.SurveyedObject;
import org.cellgauge.survey.SurveyedPhoto;
import org.cellgauge.survey.SurveyedReference;

/** A survey as tables for a terminal. */
public final class SurveyText {
    private static final int MOST_DISTANCES = 20;

    private SurveyText() {
    }

    /**
     * The tables.
     *
     * @param result a survey
     * @return lines, each ended by a line feed
     */
    public static String of(SurveyResult result) {
        StringBuilder out = new StringBuilder();
        out.append(result.used()).append(" of ").append(result.photos().size()).append(" photos used\n");
        SurveyRun run = result.run();
        if (run != null) {
            out.append(runLine(run)).append('\n');
        }
        out.append("\nObjects, in the world, mm and degrees\n").append(objects(result).text("  "));
        for (SurveyedObject o : result.objects()) {
            out.append("  ").append(o.marker().id()).append(": ").append(limits(o)).append('\n');
            for (Conformity c : o.conformities()) {
                out.append("  ").append(o.marker().id()).append(": ").append(c.of().key()).append(" within ")
                        .append(CheckText.plain(c.tolerance())).append(' ').append(c.of().unit())
                        .append(" with probability ").append(CheckText.fixed(c.probability(), 3)).append(" +- ")
                        .append(CheckText.fixed(c.mcse(), 3)).append(", ").append(CheckText.plain(c.asked()))
                        .append(" is asked for\n");
            }
        }
        if (!result.advice().isEmpty()) {
            out.append("\nWhat would meet the target, with a margin of 15 %\n");
            result.advice().forEach(a -> out.append("  - ").append(a.change()).append(": largest deviation ")
                    .append(CheckText.fixed(a.worstStdMm(), 2)).append(" mm\n"));
        }
        out.append("\nReferences: where they stand\n").append(references(result).text("  "));
        if (result.references().size() > 1) {
            out.append("\nDistances between references, mm\n").append(distances(result).text("  "));
        }
        if (!result.measurements().isEmpty()) {
            out.append("\nMeasurements: how far they are off all else\n").append(measurements(result).text("  "));
        }
        out.append("\nPhotos: where cameras stood, mm\n").append(photos(result).text("  "));
        return out.toString();
    }

    /**
     * What has moved.
     *
     * @param drift since an earlier survey
     * @return a table, its lines ended by line feeds
     */
    public static String of(Drift drift) {
        TextTable table = new TextTable(1).row("since then", "x", "y", "z", "std x", "std y", "std z", "turn deg",
                "chance %");
        for (Drift.Displacement d : drift.bodies()) {
            table.row(d.body().words() + (d.moved() ? " !" : ""), CheckText.fixed(d.shiftMm().get(0), 2),
                    CheckText.fixed(d.shiftMm().get(1), 2), CheckText.fixed(d.shiftMm().get(2), 2),
                    CheckText.fixed(d.stdMm().get(0), 2), CheckText.fixed(d.stdMm().get(1), 2),
                    CheckText.fixed(d.stdMm().get(2), 2), CheckText.fixed(d.turnDeg(), 2), percent(d.chance()));
        }
        return "\nWhat has moved since the earlier survey, mm\n" + table.text("  ");
    }

    /**
     * How draws came about, in one line.
     *
     * @param run how
     * @return without a line feed
     */
    public static String runLine(SurveyRun run) {
        String word = run.convergence() == Convergence.CONVERGED ? "converged"
                : run.convergence() == Convergence.DOUBTFUL ? "doubtful: draws do not suffice"
                        : "not converged: no figure to trust";
        return run.chains() + " chains of " + run.draws() + " draws, " + word + ": R-hat "
                + CheckText.fixed(run.rHatMax(), 4) + ", effective draws " + CheckText.fixed(run.essBulkMin(), 0)
                + " (means), " + CheckText.fixed(run.essTailMin(), 0) + " (tails), "
                + CheckText.fixed(run.essPerThousand(), 0) + " for 1000 evaluations";
    }

    /**
     * What limits an object, and what one more photo would bring.
     *
     * @param o the object
     * @return a sentence without its end
     */
    public static String limits(SurveyedObject o) {
        List<Map.Entry<String, Double>> most = o.shares().entrySet().stream()
                .sorted(Map.Entry.comparingByValue(Comparator.reverseOrder())).limit(3).toList();
        String shares = most.stream().map(e -> e.getKey() + " " + CheckText.fixed(100 * e.getValue(), 0) + " %")
                .collect(Collectors.joining(", "));
        List<Double> curve = o.worstStdMmByPhotos();
        double now = curve.get(curve.size() - 1);
        return shares + "; one more photo: " + CheckText.fixed(now, 3) + " to "
                + CheckText.fixed(o.nextWorstStdMm(), 3) + " mm";
    }

    private static TextTable objects(SurveyResult result) {
        TextTable table = new TextTable(1).row("object", "photos", "x", "y", "z", "std x", "std y", "std z", "worst");
        for (SurveyedObject o : result.objects()) {
            row(table, String.valueOf(o.marker().id()), String.valueOf(o.photos()), o.pose().mean(), o.pose().std(),
                    CheckText.fixed(o.worstStdMm(), 2));
            if (o.grip() != null) {
                row(table, o.marker().id() + " grip", "", o.grip().meanMm(), o.grip().stdMm(), "");
            }
        }
        return table;
    }

    private static void row(TextTable table, String name, String photos, double[] mean, double[] std, String last) {
        table.row(name, photos, CheckText.fixed(mean[0], 2), CheckText.fixed(mean[1], 2), CheckText.fixed(mean[2], 2),
                CheckText.fixed(std[0], 2), CheckText.fixed(std[1], 2), CheckText.fixed(std[2], 2), last);
    }

    private static TextTable references(SurveyResult result) {
        TextTable table = new TextTable(1).row("reference", "photos", "x", "y", "z", "std x", "std y", "std z", "off",
                "chance %");
        for (SurveyedReference r : result.references()) {
            double[] mean = r.pose().mean();
            double[] std = r.pose().std();
            table.row(r.stated().id() + (r.misplaced() ? " !" : ""), String.valueOf(r.photos()),
                    CheckText.fixed(mean[0], 2), CheckText.fixed(mean[1], 2), CheckText.fixed(mean[2], 2),
                    CheckText.fixed(std[0], 2), CheckText.fixed(std[1], 2), CheckText.fixed(std[2], 2),
                    CheckText.fixed(r.offMm(), 2), percent(r.chance()));
        }
        return table;
    }

    static String percent(double chance) {
        return Double.isNaN(chance) ? "-" : CheckText.fixed(100 * chance, chance < 0.001 ? 4 : 1);
    }

    private static TextTable distances(SurveyResult result) {
        TextTable table = new TextTable(1).row("between", "stated", "found", "std");
        int count = 0;
        List<SurveyedReference> references = result.references();
        for (int a = 0; a < references.size(); a++) {
            for (int b = a + 1; b < references.size() && count < MOST_DISTANCES; b++) {
                SurveyedDistance d = result.distance(references.get(a).stated().id(), references.get(b).stated().id());
                table.row(d.from() + " and " + d.to(), CheckText.fixed(d.statedMm(), 2), CheckText.fixed(d.mm(), 2),
                        CheckText.fixed(d.stdMm(), 2));
                count++;
            }
        }
        return table;
    }

    private static TextTable measurements(SurveyResult result) {
        TextTable table = new TextTable(1).row("measurement", "std deviations off", "chance %");
        int k = 1;
        for (SurveyedMeasurement m : result.measurements()) {
            table.row(k++ + " of " + m.measurement().members(), CheckText.fixed(m.deviations(), 2),
                    percent(m.chance()));
        }
        return table;
    }

    private static TextTable photos(SurveyResult result) {
        TextTable table = new TextTable(1).row("photo", "markers", "x", "y", "z", "std x", "std y", "std z",
                "chance %");
        for (SurveyedPhoto p : result.photos()) {
            if (p.camera() == null) {
                table.row(p.name(), String.valueOf(p.markers()), "left out");
            } else {
                row(table, p.name(), String.valueOf(p.markers()), p.camera().mean(), p.camera().std(),
                        percent(p.chance()));
            }
        }
        return table;
    }
}
