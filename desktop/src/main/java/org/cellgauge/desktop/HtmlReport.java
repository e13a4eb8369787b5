package org.cellgauge.desktop;

import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Verdict;
import org.cellgauge.output.BudgetShare;
import org.cellgauge.output.ModeView;
import org.cellgauge.output.ResultRow;
import org.cellgauge.output.ResultView;
import org.cellgauge.placement.ReferenceCheck;
import org.cellgauge.placement.ReferenceFit;
import org.cellgauge.placement.WithoutMisplaced;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.sampling.Quantity;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingTable;
import org.cellgauge.statistics.ChainDiagnostics;
import org.cellgauge.warning.Message;

/**
 * The report of a run, {@code report.html}: one page that holds all it shows, pictures and styles included. Verdicts
 * are told apart by word and shape, never by colour alone.
 */
public final class HtmlReport {
    private static final String STYLE = "body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:76rem;"
            + "padding:0 1rem;color:#1b1f24;background:#fff}h1{font-size:1.5rem}h2{font-size:1.2rem;margin-top:2.5rem;"
            + "border-top:1px solid #ccd3da;padding-top:1rem}h3{font-size:1rem;margin-bottom:.3rem}"
            + "table{border-collapse:collapse;margin:.4rem 0 1rem}th,td{padding:.15rem .7rem;text-align:right;"
            + "border-bottom:1px solid #e4e8ec;font-variant-numeric:tabular-nums}th:first-child,td:first-child,.text"
            + "{text-align:left}td:first-child{white-space:nowrap}th{font-weight:600}"
            + "img{max-width:100%;height:auto;border:1px solid #ccd3da}"
            + ".verdict{font-weight:700;white-space:nowrap}.verdict svg{width:1em;height:1em;vertical-align:-.12em}"
            + ".pass{color:#1a6b36}.fail,.refused{color:#b3261e}.not-converged,.ambiguous,.contradicted{color:#8a4b00}"
            + ".no-target{color:#3b4754}.caution{font-weight:700;color:#8a4b00}details{margin:.5rem 0}"
            + "summary{cursor:pointer}pre{white-space:pre-wrap}.scroll{overflow-x:auto}"
            + "@media (prefers-color-scheme:dark){body{color:#e4e8ec;background:#15191e}.pass{color:#6fd08c}"
            + ".fail,.refused{color:#ff8a80}.not-converged,.ambiguous,.contradicted,.caution{color:#ffb74d}.no-target{color:#aab4be}"
            + "h2,img{border-color:#3b4754}th,td{border-color:#2a323a}}";

    /** What it means that a setting is open. */
    private static final Map<Setting<?>, String> OPEN = Map.of(
            SettingTable.ITERATIONS, "as many as the precision takes",
            SettingTable.TARGET_STD_MM, "as the cell file has it");

    private final String cellName;
    private final String version;
    private final Function<Message, String> words;
    private final StringBuilder overview = new StringBuilder();
    private final StringBuilder sections = new StringBuilder();
    private int photos;

    /**
     * An empty report.
     *
     * @param cellName the cell file as named by the user
     * @param version version of this program
     * @param words what a warning says, in the words of the program around this
     */
    public HtmlReport(String cellName, String version, Function<Message, String> words) {
        this.cellName = cellName;
        this.version = version;
        this.words = words;
    }

    /**
     * Adds a result.
     *
     * @param input what was checked
     * @param result what was found
     * @param jpeg picture of the result
     * @param command what makes the same figures again
     */
    public void add(CheckInput input, CheckResult result, byte[] jpeg, String command) {
        String id = "photo-" + ++photos;
        ResultView view = ResultView.of(result);
        String key = result.verdict().key();
        double worst = view.objects().stream().filter(ResultRow::seen).mapToDouble(view::worstStdMm).max()
                .orElse(Double.NaN);
        overviewRow(id, input, key, CheckText.word(result.verdict()), view.showsFigures()
                ? CheckText.fixed(worst, 2) + caution(view) : "", CheckText.fixed(result.diagnostics().rHatMax(), 4),
                result.reason(), result.action() == null ? "" : words.apply(result.action()));
        section(id, input, key, CheckText.word(result.verdict()), result.reason());
        sections.append("<p><img alt=\"").append(escape(input.name() + ": markers, frames and 95 % ellipses"))
                .append("\" src=\"data:image/jpeg;base64,").append(Base64.getEncoder().encodeToString(jpeg))
                .append("\"></p>\n");
        if (!result.warnings().isEmpty()) {
            sections.append("<h3>Warnings</h3>\n<ul>");
            result.warnings().forEach(w -> sections.append("<li>").append(escape(words.apply(w))).append("</li>"));
            sections.append("</ul>\n");
        }
        if (view.showsFigures()) {
            objects(view);
            camera(view);
            modes(view);
            budgets(view);
        }
        references(result);
        without(result);
        diagnostics(result);
        settings(result, command);
        sections.append("</section>\n");
    }

    /**
     * Adds an input that gave no result.
     *
     * @param input what was to be checked
     * @param word what became of it
     * @param message why
     */
    public void add(CheckInput input, String word, String message) {
        String id = "photo-" + ++photos;
        overviewRow(id, input, "refused", word, "", "", message, "");
        section(id, input, "refused", word, message);
        sections.append("</section>\n");
    }

    private void overviewRow(String id, CheckInput input, String key, String word, String worst, String rHat,
            String reason, String action) {
        String toDo = action.isEmpty() || reason.contains(action) ? ""
                : "<br><strong>First:</strong> " + escape(action) + ".";
        overview.append("<tr><td><a href=\"#").append(id).append("\">").append(escape(input.name()))
                .append("</a></td><td class=\"text\">").append(verdict(key, word)).append("</td><td>").append(worst)
                .append("</td><td>").append(rHat).append("</td><td class=\"text\">").append(escape(reason)).append(toDo)
                .append("</td></tr>\n");
    }

    private void section(String id, CheckInput input, String key, String word, String reason) {
        sections.append("<section id=\"").append(id).append("\">\n<h2>").append(escape(input.name())).append(" &nbsp; ")
                .append(verdict(key, word)).append("</h2>\n<p>").append(escape(reason)).append("</p>\n");
    }

    private static String verdict(String key, String word) {
        String shape;
        switch (key) {
            case "pass":
                shape = "<circle cx=\"8\" cy=\"8\" r=\"7\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"2\"/>"
                        + "<path d=\"M4.5 8.5l2.5 2.5 4.5-5.5\" fill=\"none\" "
                        + "stroke=\"currentColor\" stroke-width=\"2\"/>";
                break;
            case "not-converged":
            case "ambiguous":
            case "contradicted":
                shape = "<path d=\"M8 1.5l7 13H1z\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"2\"/>"
                        + "<path d=\"M8 6v4M8 11.5v1.5\" stroke=\"currentColor\" stroke-width=\"2\"/>";
                break;
            case "no-target":
                shape = "<path d=\"M2 8h12\" stroke=\"currentColor\" stroke-width=\"3\"/>";
                break;
            default:
                shape = "<path d=\"M5 1h6l4 4v6l-4 4H5l-4-4V5z\" fill=\"currentColor\"/>"
                        + "<path d=\"M5 5l6 6M11 5l-6 6\" stroke=\"#fff\" stroke-width=\"2\"/>";
        }
        return "<span class=\"verdict " + key + "\"><svg viewBox=\"0 0 16 16\" aria-hidden=\"true\">" + shape
                + "</svg> " + escape(word) + "</span>";
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
        OptionalDouble target = view.targetStdMm();
        sections.append("<h3>Objects in world, mm").append(target.isPresent()
                ? ", against a target std of " + CheckText.plain(target.getAsDouble()) + " mm" : "")
                .append(caution(view)).append("</h3>\n");
        header("", "x", "y", "z", "std x", "std y", "std z", "target");
        for (ResultRow row : view.points()) {
            String name = escape(CheckText.name(row));
            if (!row.seen()) {
                row(name, "-", "-", "-", "-", "-", "-", "not seen");
                continue;
            }
            double[] mean = row.mean();
            double[] std = row.std();
            String mark = CheckText.mark(row);
            String key = row.verdict() == Verdict.PASS || row.verdict() == Verdict.FAIL ? row.verdict().key()
                    : Verdict.NOT_CONVERGED.key();
            row(name, CheckText.fixed(mean[0], 3), CheckText.fixed(mean[1], 3), CheckText.fixed(mean[2], 3),
                    CheckText.fixed(std[0], 3), CheckText.fixed(std[1], 3), CheckText.fixed(std[2], 3),
                    mark.isEmpty() ? "" : verdict(key, mark));
        }
        end();
    }

    private void camera(ResultView view) {
        sections.append("<h3>Camera in world").append(caution(view)).append("</h3>\n");
        header("", "x mm", "y mm", "z mm", "psi deg", "theta deg", "phi deg");
        poseRow("mean", view.camera().mean());
        poseRow("std", view.camera().std());
        end();
        if (!view.intrinsics().isEmpty()) {
            sections.append("<h3>Intrinsics").append(caution(view)).append("</h3>\n");
            header("", "mean", "std");
            for (ResultView.Intrinsic intrinsic : view.intrinsics()) {
                row(escape(intrinsic.name()), CheckText.fixed(intrinsic.mean(), 3),
                        CheckText.fixed(intrinsic.std(), 3));
            }
            end();
        }
    }

    private void poseRow(String name, double[] pose) {
        row(escape(name), CheckText.fixed(pose[0], 3), CheckText.fixed(pose[1], 3), CheckText.fixed(pose[2], 3),
                CheckText.fixed(Math.toDegrees(pose[3]), 4), CheckText.fixed(Math.toDegrees(pose[4]), 4),
                CheckText.fixed(Math.toDegrees(pose[5]), 4));
    }

    private void modes(ResultView view) {
        if (view.verdict() != Verdict.AMBIGUOUS) {
            return;
        }
        sections.append("<h3>Poses that explain the photo</h3>\n");
        header("", "x mm", "y mm", "z mm", "psi deg", "theta deg", "phi deg");
        for (ResultRow row : view.rows()) {
            for (ModeView mode : row.modes()) {
                poseRow((row.kind() == ResultRow.Kind.CAMERA ? "camera" : CheckText.name(row)) + ", "
                        + CheckText.fixed(100 * mode.weight(), 1) + " %", mode.pose().mean());
            }
        }
        end();
    }

    private void budgets(ResultView view) {
        if (view.objects().stream().noneMatch(ResultRow::seen)) {
            return;
        }
        sections.append("<h3>Where the variance comes from</h3>\n");
        header("", "source", "share of the variance", "x", "y", "z", "taken away: off the deviation");
        for (ResultRow row : view.points()) {
            budget(row);
        }
        end();
    }

    private void budget(ResultRow row) {
        String shown = escape(CheckText.name(row));
        for (BudgetShare part : row.budget()) {
            sections.append("<tr><td>").append(shown).append("</td><td class=\"text\">")
                    .append(escape(part.source().key())).append("</td>");
            cell(percent(part.share()));
            for (int axis = 0; axis < 3; axis++) {
                cell(percent(part.share(axis)));
            }
            cell(percent(part.gain()));
            sections.append("</tr>\n");
            shown = "";
        }
    }

    private static String percent(double share) {
        return Double.isFinite(share) ? CheckText.fixed(100 * share, 1) + " %" : "-";
    }

    private void references(CheckResult result) {
        ReferenceCheck check = result.referenceCheck();
        sections.append("<h3>References against each other</h3>\n");
        header("", "normalised residual", "p", "seems off in x, mm", "y", "z", "noticed from x, mm", "y", "z", "");
        for (ReferenceFit fit : check.fits()) {
            double[] off = fit.offset();
            double[] from = fit.detectable();
            row(escape("reference " + fit.id()), CheckText.fixed(fit.normalisedResidual(), 2),
                    CheckText.fixed(fit.pValue(), 3), CheckText.fixed(off[0], 1), CheckText.fixed(off[1], 1),
                    CheckText.fixed(off[2], 1), CheckText.fixed(from[0], 1), CheckText.fixed(from[1], 1),
                    CheckText.fixed(from[2], 1), fit.misplaced() ? verdict("fail", "seems off") : "");
        }
        end();
        sections.append("<p>").append(escape(check.noticeable())).append("</p>\n");
    }

    /** Objects without the references that seem off. */
    private void without(CheckResult result) {
        WithoutMisplaced without = result.referenceCheck().without();
        if (without == null || without.objects().isEmpty()) {
            return;
        }
        sections.append("<h3>").append(escape("Without reference " + CheckText.leftOut(without)
                + ", by Laplace's approximation, mm")).append("</h3>\n");
        header("", "x", "y", "z", "moves x", "y", "z", "std x", "y", "z");
        for (WithoutMisplaced.ObjectWithout object : without.objects()) {
            withoutRow("object " + object.id(), object.pose().mean(), object.moveMm(), object.pose().std());
            if (object.grip() != null) {
                withoutRow("its gripping point", object.grip().meanMm(), object.gripMoveMm(), object.grip().stdMm());
            }
        }
        end();
    }

    private void withoutRow(String name, double[] mean, double[] move, double[] std) {
        row(escape(name), CheckText.fixed(mean[0], 3), CheckText.fixed(mean[1], 3), CheckText.fixed(mean[2], 3),
                CheckText.signed(move[0]), CheckText.signed(move[1]), CheckText.signed(move[2]),
                CheckText.fixed(std[0], 3), CheckText.fixed(std[1], 3), CheckText.fixed(std[2], 3));
    }

    private void diagnostics(CheckResult result) {
        sections.append("<h3>Chains</h3>\n<p>").append(escape(CheckText.diagnosticsLine(result))).append("<br>")
                .append(escape(CheckText.laplaceLine(result))).append("<br>")
                .append(escape(CheckText.noiseLines(result).trim()).replace("\n", "<br>")).append("</p>\n");
        sections.append("<details><summary>Every quantity</summary><div class=\"scroll\">\n");
        header("", "mean", "std", "R-hat", "bulk draws", "tail draws", "MC error of mean", "MC error of std");
        for (Map.Entry<Quantity, ChainDiagnostics> e : result.diagnostics().parameters().entrySet()) {
            ChainDiagnostics d = e.getValue();
            row(escape(e.getKey().name()), CheckText.fixed(d.mean(), 5), CheckText.fixed(d.std(), 5),
                    d.status() == ChainDiagnostics.Status.OK ? CheckText.fixed(d.rHat(), 4)
                            : escape(d.status().name().toLowerCase(Locale.ROOT).replace('_', ' ')),
                    CheckText.fixed(d.essBulk(), 0), CheckText.fixed(d.essTail(), 0), CheckText.fixed(d.mcseMean(), 6),
                    CheckText.fixed(d.mcseSd(), 6));
        }
        end();
        header("proposal", "accepted", "rejected", "share accepted");
        for (AcceptanceCount count : result.acceptance()) {
            row(escape(count.proposal()), String.valueOf(count.accepted()), String.valueOf(count.rejected()),
                    percent(count.rate()));
        }
        end();
        sections.append("</div></details>\n");
    }

    private void settings(CheckResult result, String command) {
        CheckSettings s = result.settings();
        Map<String, String> values = new LinkedHashMap<>();
        for (Setting<?> setting : SettingTable.all()) {
            if (setting.determinesFigures() && setting.appliesTo(s)) {
                String text = setting == SettingTable.WARMUP ? String.valueOf(result.warmup()) : setting.text(s);
                values.put(setting.name().replace('-', ' '), text.isEmpty() ? OPEN.get(setting)
                        : setting.unit().isEmpty() ? text : text + " " + setting.unit());
            }
        }
        values.put("prior on the camera pose", result.posePrior() == null ? "none" : result.posePrior());
        values.put("pixel std", CheckText.fixed(result.pixelStdPx(), 4) + " px"
                + (result.cell().pixelStdPx().isPresent() ? "" : " (learned from the photo)"));
        values.put("tone curve", CheckText.toneCurve(result.cell().toneCurve()));
        if (result.detections().light() != null) {
            values.put("light of the photo", CheckText.light(result));
        }
        values.put("references used", result.referencesUsed().toString().replaceAll("[\\[\\]]", ""));
        sections.append("<details><summary>Settings</summary>\n<table>\n");
        values.forEach((name, value) -> sections.append("<tr><td>").append(escape(name))
                .append("</td><td class=\"text\">").append(escape(value)).append("</td></tr>\n"));
        sections.append("</table>\n<p>The same figures again:</p>\n<pre>").append(escape(command))
                .append("</pre></details>\n");
    }

    private void header(String... cells) {
        sections.append("<table>\n<tr>");
        for (String cell : cells) {
            sections.append("<th>").append(escape(cell)).append("</th>");
        }
        sections.append("</tr>\n");
    }

    private void row(String... html) {
        sections.append("<tr>");
        for (String cell : html) {
            cell(cell);
        }
        sections.append("</tr>\n");
    }

    private void cell(String html) {
        sections.append("<td>").append(html).append("</td>");
    }

    private void end() {
        sections.append("</table>\n");
    }

    /**
     * The page.
     *
     * @param total one line about the whole run
     * @return HTML
     */
    public String html(String total) {
        return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                + "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
                + "style-src 'unsafe-inline'\">\n<meta name=\"viewport\" content=\"width=device-width\">\n"
                + "<title>CellGauge: " + escape(cellName) + "</title>\n<style>" + STYLE + "</style>\n</head>\n<body>\n"
                + "<h1>CellGauge: " + escape(cellName) + "</h1>\n<p>" + escape(total) + "</p>\n<div class=\"scroll\">"
                + "<table>\n<tr><th>photo</th><th class=\"text\">verdict</th><th>worst std, mm</th><th>R-hat</th>"
                + "<th class=\"text\">why</th></tr>\n"
                + overview + "</table></div>\n" + sections + "<p><small>CellGauge " + escape(version)
                + ". Lengths in mm, std: standard deviation. Angles psi, theta, phi turn about x, y, z.</small></p>\n"
                + "</body>\n</html>\n";
    }

    private static String escape(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;")
                .replace("'", "&#39;");
    }
}
