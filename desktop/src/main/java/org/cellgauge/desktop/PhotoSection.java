package org.cellgauge.desktop;

import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.Map;
import org.cellgauge.check.Conformity;
import org.cellgauge.check.Verdict;
import org.cellgauge.internal.warning.Printable;
import org.cellgauge.output.BudgetShare;
import org.cellgauge.output.ModeView;
import org.cellgauge.output.MovedObject;
import org.cellgauge.output.QuantityView;
import org.cellgauge.output.ReferenceFitView;
import org.cellgauge.output.ResultRecord;
import org.cellgauge.output.ResultRow;
import org.cellgauge.output.ResultView;
import org.cellgauge.output.StoredResult;
import org.cellgauge.output.WithoutView;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingTable;

/** What the report says of one input: its row of the overview, and a section of its own. */
final class PhotoSection {
    /** What it means that a setting is open. */
    private static final Map<Setting<?>, String> OPEN = Map.of(
            SettingTable.ITERATIONS, "as many as the precision takes",
            SettingTable.TARGET_STD_MM, "as the cell file has it");

    private final String id;
    private final String name;
    private final String key;
    private final String word;
    private final String reason;
    /** The cells of the overview between verdict and reason. */
    private String worst = "";
    private String rHat = "";
    private String toDo = "";
    private final String heading;
    private String picture = "";
    private final Html out = new Html();

    private PhotoSection(int number, CheckInput input, String key, String word, String reason) {
        id = "photo-" + number;
        name = Html.escape(Printable.of(input.name()));
        this.key = key;
        this.word = word;
        this.reason = reason;
        heading = "<section id=\"" + id + "\">\n<h2>" + name + " &nbsp; " + Html.verdict(key, word) + "</h2>\n<p>"
                + Html.escape(reason) + "</p>\n";
    }

    /**
     * A result, without its picture.
     *
     * @param number of the input in its batch, from 1
     * @param input what was checked
     * @param result what was found
     */
    static PhotoSection of(int number, CheckInput input, StoredResult result) {
        ResultView view = result.view();
        PhotoSection section = new PhotoSection(number, input, view.verdict().key(), CheckText.word(view.verdict()),
                view.reason());
        section.fill(result);
        return section;
    }

    /**
     * An input that gave no result.
     *
     * @param number of the input in its batch, from 1
     * @param input what was to be checked
     * @param word what became of it
     * @param message why
     */
    static PhotoSection of(int number, CheckInput input, String word, String message) {
        PhotoSection section = new PhotoSection(number, input, "refused", word, message);
        section.out.append("</section>\n");
        return section;
    }

    private void fill(StoredResult result) {
        ResultView view = result.view();
        double worstMm = view.objects().stream().filter(ResultRow::seen).mapToDouble(view::worstStdMm).max()
                .orElse(Double.NaN);
        worst = view.showsFigures() ? CheckText.fixed(worstMm, 2) + caution(view) : "";
        rHat = CheckText.fixed(view.chains().rHatMax(), 4);
        toDo = view.action() == null || reason.contains(view.action()) ? ""
                : "<br><strong>First:</strong> " + Html.escape(view.action()) + ".";
        if (!view.warnings().isEmpty()) {
            out.append("<h3>Warnings</h3>\n<ul>");
            view.warnings().forEach(w -> out.append("<li>").append(Html.escape(w.text())).append("</li>"));
            out.append("</ul>\n");
        }
        if (!view.advice().isEmpty()) {
            out.append("<h3>What would meet the target, cheapest first (forecast)</h3>\n<ol>");
            view.advice().forEach(a -> out.append("<li>").append(Html.escape(a.line())).append("</li>"));
            out.append("</ol>\n");
        }
        if (view.showsFigures()) {
            objects(view);
            orientations(view);
            camera(view);
            modes(view);
            budgets(view);
        }
        references(view);
        without(view.references().without());
        diagnostics(view);
        settings(view);
        record(result.record());
        out.append("</section>\n");
    }

    /**
     * Puts in the picture of the result.
     *
     * @param jpeg the file
     * @return this
     */
    PhotoSection withPicture(byte[] jpeg) {
        picture = "<p><img alt=\"" + name + ": markers, frames and 95 % ellipses\" src=\"data:image/jpeg;base64,"
                + Base64.getEncoder().encodeToString(jpeg) + "\"></p>\n";
        return this;
    }

    /** Whether someone should look at it: there is no figure that meets its target, or needs none. */
    boolean isNotable() {
        return !key.equals(Verdict.PASS.key()) && !key.equals(Verdict.NO_TARGET.key());
    }

    /** The verdict in a word. */
    String word() {
        return word;
    }

    /** The row of the overview, on a page from which a file, empty for the same page, has the section. */
    String row(String file) {
        return "<tr><td><a href=\"" + file + "#" + id + "\">" + name + "</a></td><td class=\"text\">"
                + Html.verdict(key, word) + "</td><td data-of=\"worst std, mm\">" + worst
                + "</td><td data-of=\"R-hat\">" + rHat + "</td><td class=\"text\">" + Html.escape(reason) + toDo
                + "</td></tr>\n";
    }

    /** The section. */
    String html() {
        return heading + picture + out;
    }

    private static String caution(ResultView view) {
        String caution = CheckText.caution(view.verdict());
        return caution.isEmpty() ? "" : " <span class=\"caution\">" + caution + "</span>";
    }

    // ---- tables of one photo

    private void objects(ResultView view) {
        if (view.objects().isEmpty()) {
            return;
        }
        out.append("<h3>Objects in world, mm").append(Html.escape(CheckText.against(view.target())))
                .append(caution(view)).append("</h3>\n");
        out.header("", "x", "y", "z", "std x", "std y", "std z", "target");
        for (ResultRow row : view.points()) {
            String name = Html.escape(CheckText.name(row));
            if (!row.seen()) {
                out.row(name, "-", "-", "-", "-", "-", "-", "not seen");
                continue;
            }
            double[] mean = row.mean();
            double[] std = row.std();
            String mark = CheckText.mark(row);
            String key = row.verdict() == Verdict.PASS || row.verdict() == Verdict.FAIL ? row.verdict().key()
                    : Verdict.NOT_CONVERGED.key();
            out.row(name, CheckText.fixed(mean[0], 3), CheckText.fixed(mean[1], 3), CheckText.fixed(mean[2], 3),
                    CheckText.fixed(std[0], 3), CheckText.fixed(std[1], 3), CheckText.fixed(std[2], 3),
                    mark.isEmpty() ? "" : Html.verdict(key, mark));
        }
        out.end();
        tolerances(view);
    }

    private void tolerances(ResultView view) {
        if (!view.target().asksForProbability()) {
            return;
        }
        out.append("<h3>Probability of being within tolerance").append(caution(view)).append("</h3>\n");
        out.header("", "tolerance", "probability", "Monte Carlo error", "asked", "target");
        for (ResultRow row : view.points()) {
            for (Conformity c : row.conformities()) {
                String standing = CheckText.standing(row, c);
                String key = standing.equals("pass") ? Verdict.PASS.key()
                        : standing.equals("FAIL") ? Verdict.FAIL.key() : Verdict.NOT_CONVERGED.key();
                out.row(Html.escape(CheckText.name(row)), CheckText.tolerance(c), CheckText.fixed(c.probability(), 4),
                        CheckText.fixed(c.mcse(), 4), CheckText.plain(c.asked()), Html.verdict(key, standing));
            }
        }
        out.end();
    }

    /** Angles with their deviations; turns about world axes say how far off where angles cannot. */
    private void orientations(ResultView view) {
        if (view.objects().stream().noneMatch(ResultRow::seen)) {
            return;
        }
        out.append("<h3>Orientations of objects in world, deg").append(caution(view)).append("</h3>\n");
        out.header("", "psi", "theta", "phi", "std psi", "std theta", "std phi", "std about x", "std about y",
                "std about z");
        for (ResultRow row : view.objects()) {
            if (row.seen()) {
                orientation(CheckText.name(row), row);
            }
        }
        out.end();
    }

    private void orientation(String name, ResultRow row) {
        double[] mean = row.mean();
        double[] std = row.std();
        double[][] tangent = row.pose().tangentCovariance();
        String[] cells = new String[10];
        cells[0] = Html.escape(name);
        for (int i = 0; i < 3; i++) {
            cells[1 + i] = Html.degrees(mean[3 + i]);
            cells[4 + i] = Html.degrees(std[3 + i]);
            cells[7 + i] = Html.degrees(Math.sqrt(tangent[3 + i][3 + i]));
        }
        out.row(cells);
    }

    private void camera(ResultView view) {
        out.append("<h3>Camera in world").append(caution(view)).append("</h3>\n");
        out.header("", "x mm", "y mm", "z mm", "psi deg", "theta deg", "phi deg");
        poseRow("mean", view.camera().mean());
        poseRow("std", view.camera().std());
        out.end();
        if (!view.intrinsics().isEmpty()) {
            out.append("<h3>Intrinsics").append(caution(view)).append("</h3>\n");
            out.header("", "mean", "std", "mean before", "std before", "");
            for (ResultView.Intrinsic intrinsic : view.intrinsics()) {
                out.row(Html.escape(intrinsic.name()), CheckText.significant(intrinsic.mean(), 6),
                        CheckText.significant(intrinsic.std(), 3), CheckText.significant(intrinsic.priorMean(), 6),
                        CheckText.priorStd(intrinsic), intrinsic.restsOn());
            }
            out.end();
        }
    }

    private void poseRow(String name, double[] pose) {
        out.row(Html.escape(name), CheckText.fixed(pose[0], 3), CheckText.fixed(pose[1], 3),
                CheckText.fixed(pose[2], 3), Html.degrees(pose[3]), Html.degrees(pose[4]), Html.degrees(pose[5]));
    }

    private void modes(ResultView view) {
        if (view.verdict() != Verdict.AMBIGUOUS) {
            return;
        }
        out.append("<h3>Poses that explain the photo</h3>\n");
        out.header("", "x mm", "y mm", "z mm", "psi deg", "theta deg", "phi deg");
        for (ResultRow row : view.rows()) {
            for (ModeView mode : row.modes()) {
                poseRow((row.kind() == ResultRow.Kind.CAMERA ? "camera" : CheckText.name(row)) + ", "
                        + CheckText.fixed(100 * mode.weight(), 1) + " %", mode.pose().mean());
            }
        }
        out.end();
    }

    private void budgets(ResultView view) {
        if (view.objects().stream().noneMatch(ResultRow::seen)) {
            return;
        }
        out.append("<h3>Where the variance comes from</h3>\n");
        out.header("", Html.SOURCE, "share of the variance", "share in x", "share in y", "share in z",
                "taken away: off the deviation");
        for (ResultRow row : view.points()) {
            for (BudgetShare part : row.budget()) {
                out.row(Html.escape(CheckText.name(row)), Html.escape(part.source().key()), percent(part.share()),
                        percent(part.share(0)), percent(part.share(1)), percent(part.share(2)),
                        percent(part.gain()));
            }
        }
        out.end();
    }

    private static String percent(double share) {
        return Double.isFinite(share) ? CheckText.fixed(100 * share, 1) + " %" : "-";
    }

    private void references(ResultView view) {
        out.append("<h3>References against each other</h3>\n");
        out.header("", "normalised residual", "p", "seems off in x, mm", "off in y", "off in z", "noticed from x, mm",
                "noticed from y", "noticed from z", "");
        for (ReferenceFitView fit : view.references().fits()) {
            if (!fit.used()) {
                continue;
            }
            double[] off = fit.offset();
            double[] from = fit.detectable();
            out.row(Html.escape("reference " + fit.id()), CheckText.fixed(fit.normalisedResidual(), 2),
                    CheckText.fixed(fit.pValue(), 3), CheckText.fixed(off[0], 1), CheckText.fixed(off[1], 1),
                    CheckText.fixed(off[2], 1), CheckText.fixed(from[0], 1), CheckText.fixed(from[1], 1),
                    CheckText.fixed(from[2], 1), fit.misplaced() ? Html.verdict("fail", "seems off") : "");
        }
        out.end();
        out.append("<p>").append(Html.escape(view.references().noticeable())).append("</p>\n");
    }

    /** Objects without the references that seem off. */
    private void without(WithoutView without) {
        if (without == null || without.objects().isEmpty()) {
            return;
        }
        out.append("<h3>").append(Html.escape("Without reference " + CheckText.leftOut(without)
                + ", by Laplace's approximation, mm")).append("</h3>\n");
        out.header("", "x", "y", "z", "moves x", "moves y", "moves z", "std x", "std y", "std z");
        for (MovedObject object : without.objects()) {
            withoutRow("object " + object.id(), object.pose().mean(), object.moveMm(), object.pose().std());
            if (object.grip() != null) {
                withoutRow("its gripping point", object.grip().meanMm(), object.grip().moveMm(),
                        object.grip().stdMm());
            }
        }
        out.end();
    }

    private void withoutRow(String name, double[] mean, double[] move, double[] std) {
        out.row(Html.escape(name), CheckText.fixed(mean[0], 3), CheckText.fixed(mean[1], 3),
                CheckText.fixed(mean[2], 3), CheckText.signed(move[0]), CheckText.signed(move[1]),
                CheckText.signed(move[2]),
                CheckText.fixed(std[0], 3), CheckText.fixed(std[1], 3), CheckText.fixed(std[2], 3));
    }

    private void diagnostics(ResultView view) {
        out.append("<h3>Chains</h3>\n<p>").append(Html.escape(CheckText.diagnosticsLine(view))).append("<br>")
                .append(Html.escape(CheckText.laplaceLine(view))).append("<br>")
                .append(Html.escape(CheckText.noiseLines(view).trim()).replace("\n", "<br>")).append("</p>\n");
        out.append("<details><summary>Every quantity</summary>\n");
        out.header("", "mean", "std", "R-hat", "bulk draws", "tail draws", "MC error of mean", "MC error of std");
        for (QuantityView q : view.chains().quantities()) {
            out.row(Html.escape(q.name()), CheckText.fixed(q.mean(), 5), CheckText.fixed(q.std(), 5),
                    q.status().equals("ok") ? CheckText.fixed(q.rHat(), 4) : Html.escape(q.status().replace('-', ' ')),
                    CheckText.fixed(q.essBulk(), 0), CheckText.fixed(q.essTail(), 0), CheckText.fixed(q.mcseMean(), 6),
                    CheckText.fixed(q.mcseStd(), 6));
        }
        out.end();
        out.header("proposal", "accepted", "rejected", "share accepted");
        for (AcceptanceCount count : view.chains().acceptance()) {
            out.row(Html.escape(count.proposal()), String.valueOf(count.accepted()), String.valueOf(count.rejected()),
                    percent(count.rate()));
        }
        out.end();
        out.append("</details>\n");
    }

    private void settings(ResultView view) {
        CheckSettings s = view.run().settings();
        Map<String, String> values = new LinkedHashMap<>();
        for (Setting<?> setting : SettingTable.all()) {
            if (setting.determinesFigures()) {
                values.put(setting.name().replace('-', ' '), setting.appliesTo(s) ? value(setting, s)
                        : "of no effect here");
            }
        }
        values.put("sampler used", view.run().samplerUsed());
        values.put("iterations run", String.valueOf(view.run().iterationsPerChain()));
        values.put("prior on the camera pose", view.run().posePrior() == null ? "none" : view.run().posePrior());
        values.put("pixel std", CheckText.fixed(view.noise().usualStdPx(), 4) + " px"
                + (view.noise().stated() ? "" : " (learned from the photo)"));
        values.put("tone curve", CheckText.toneCurve(view.cell().toneCurve()));
        if (view.light() != null) {
            values.put("light of the photo", CheckText.light(view));
        }
        values.put("references used", view.references().used().toString().replaceAll("[\\[\\]]", ""));
        out.append("<h3>Settings</h3>\n");
        out.pairs(values);
    }

    private static String value(Setting<?> setting, CheckSettings settings) {
        String text = setting.text(settings);
        return text.isEmpty() ? OPEN.get(setting) : setting.unit().isEmpty() ? text : text + " " + setting.unit();
    }

    /** What the result is of, and how to have it again. */
    private void record(ResultRecord record) {
        Map<String, String> values = new LinkedHashMap<>();
        values.put("input", Printable.of(record.inputName()));
        values.put("SHA-256 of the input", record.inputSha256());
        values.put("checked on", record.date());
        values.put("held against this target on", record.judgedOn());
        values.put("checked by", "CellGauge " + record.version());
        out.append("<h3>Record</h3>\n");
        out.pairs(values);
        if (record.command() != null) {
            out.append("<p>The same figures again:</p>\n<pre>").append(Html.escape(record.command()))
                    .append("</pre>\n");
        }
    }
}
