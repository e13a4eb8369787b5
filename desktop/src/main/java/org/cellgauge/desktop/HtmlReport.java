package org.cellgauge.desktop;

import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.cellgauge.check.Verdict;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.output.BudgetShare;
import org.cellgauge.output.CellView;
import org.cellgauge.output.ModeView;
import org.cellgauge.output.MovedObject;
import org.cellgauge.output.QuantityView;
import org.cellgauge.output.ReferenceFitView;
import org.cellgauge.output.ResultRecord;
import org.cellgauge.output.ResultRow;
import org.cellgauge.output.ResultView;
import org.cellgauge.output.StatedObject;
import org.cellgauge.output.StatedReference;
import org.cellgauge.output.StoredResult;
import org.cellgauge.output.WithoutView;
import org.cellgauge.sampling.AcceptanceCount;
import org.cellgauge.settings.CheckSettings;
import org.cellgauge.settings.Setting;
import org.cellgauge.settings.SettingTable;

/**
 * The report of a run, {@code report.html}: one page that holds all it shows, pictures and styles included, so that it
 * can be kept and signed. Verdicts are told apart by word and shape, never by colour alone. On a narrow screen each row
 * of a table becomes a block of its own, so that no column lies outside the page.
 */
public final class HtmlReport {
    static final String STYLE = ":root{color-scheme:light dark;--ink:#1b1f24;--paper:#fff;--line:#ccd3da;"
            + "--faint:#e4e8ec;--link:#0b57a4;--pass:#1a6b36;--fail:#b3261e;--doubt:#8a4b00;--none:#3b4754}"
            + "@media (prefers-color-scheme:dark){:root{--ink:#e4e8ec;--paper:#15191e;--line:#3b4754;--faint:#2a323a;"
            + "--link:#8ab8f0;--pass:#6fd08c;--fail:#ff8a80;--doubt:#ffb74d;--none:#aab4be}}"
            + "body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:76rem;padding:0 1rem;"
            + "color:var(--ink);background:var(--paper);overflow-wrap:break-word}a{color:var(--link)}"
            + "h1{font-size:1.5rem}h2{font-size:1.2rem;margin-top:2.5rem;border-top:1px solid var(--line);"
            + "padding-top:1rem}h3{font-size:1rem;margin-bottom:.3rem}"
            + "table{border-collapse:collapse;margin:.4rem 0 1rem}th,td{padding:.15rem .7rem;text-align:right;"
            + "border-bottom:1px solid var(--faint);font-variant-numeric:tabular-nums;vertical-align:top}"
            + "th:first-child,td:first-child,.text{text-align:left}th{font-weight:600}"
            + "td:first-child{min-width:6rem}td.text,td:first-child,h1,pre{overflow-wrap:anywhere}"
            + "img,svg.plot{max-width:100%;height:auto;border:1px solid var(--line)}"
            + ".verdict{font-weight:700;white-space:nowrap}.verdict svg{width:1em;height:1em;vertical-align:-.12em}"
            + ".pass{color:var(--pass)}.fail,.refused{color:var(--fail)}"
            + ".not-converged,.ambiguous,.contradicted{color:var(--doubt)}"
            + ".no-target{color:var(--none)}.caution{font-weight:700;color:var(--doubt)}details{margin:.5rem 0}"
            + "summary{cursor:pointer}pre{white-space:pre-wrap}"
            + "svg.plot text{font:11px system-ui,sans-serif;fill:var(--ink)}svg.plot .axis{stroke:var(--line)}"
            + "svg.plot .mark{stroke:var(--link);fill:var(--link)}svg.plot .mean{stroke:var(--none)}"
            + ".sign{display:flex;flex-wrap:wrap;gap:2.5rem 2rem;margin:3rem 0}"
            + ".sign span{flex:1 1 14rem;border-top:1px solid var(--ink)}"
            + "@media (max-width:64rem){table,tbody,tr,td{display:block}tr.head{display:none}"
            + "tr{border-bottom:1px solid var(--line);padding:.3rem 0}"
            + "td,td:first-child{display:flex;justify-content:space-between;gap:1rem;text-align:right;border:0;"
            + "padding:.05rem 0}td:first-child{font-weight:600}td.text{text-align:left}"
            + "td[data-of]::before{content:attr(data-of);flex:none;max-width:50%;text-align:left}"
            + "td:empty{display:none}}"
            + "@media print{:root{--ink:#000;--paper:#fff}section{break-inside:auto}h2,h3{break-after:avoid}"
            + "tr{break-inside:avoid}}";

    /** What it means that a setting is open. */
    private static final Map<Setting<?>, String> OPEN = Map.of(
            SettingTable.ITERATIONS, "as many as the precision takes",
            SettingTable.TARGET_STD_MM, "as the cell file has it");

    /** The header of what is words and no number. */
    private static final String SOURCE = "source";

    private final CellFile cellFile;
    private final CellView cell;
    private final OptionalDouble targetStdMm;
    private final String version;
    private final String day;
    private final StringBuilder overview = new StringBuilder();
    private final StringBuilder sections = new StringBuilder();
    private final PhotoTrend trend = new PhotoTrend();
    /** Headers of the table that is being written. */
    private String[] header = {};
    private StringBuilder out = sections;
    private int photos;

    /**
     * An empty report.
     *
     * @param cellFile the cell and its files
     * @param cell what the results rest on of it
     * @param targetStdMm largest allowed standard deviation of any axis, mm, or empty for none
     * @param version version of this program
     * @param day of the run, as in {@code 2026-11-28}; null: it is not told
     */
    public HtmlReport(CellFile cellFile, CellView cell, OptionalDouble targetStdMm, String version, String day) {
        this.cellFile = cellFile;
        this.cell = cell;
        this.targetStdMm = targetStdMm;
        this.version = version;
        this.day = day;
    }

    /**
     * Adds a result.
     *
     * @param input what was checked
     * @param result what was found
     * @param jpeg picture of the result
     */
    public void add(CheckInput input, StoredResult result, byte[] jpeg) {
        String id = "photo-" + ++photos;
        ResultView view = result.view();
        String key = view.verdict().key();
        double worst = view.objects().stream().filter(ResultRow::seen).mapToDouble(view::worstStdMm).max()
                .orElse(Double.NaN);
        overviewRow(id, input, key, CheckText.word(view.verdict()),
                view.showsFigures() ? CheckText.fixed(worst, 2) + caution(view) : "",
                CheckText.fixed(view.chains().rHatMax(), 4), view.reason(), view.action());
        trend.add(photos, view);
        section(id, input, key, CheckText.word(view.verdict()), view.reason());
        out.append("<p><img alt=\"").append(escape(input.name() + ": markers, frames and 95 % ellipses"))
                .append("\" src=\"data:image/jpeg;base64,").append(Base64.getEncoder().encodeToString(jpeg))
                .append("\"></p>\n");
        if (!view.warnings().isEmpty()) {
            out.append("<h3>Warnings</h3>\n<ul>");
            view.warnings().forEach(w -> out.append("<li>").append(escape(w.text())).append("</li>"));
            out.append("</ul>\n");
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
     * Adds an input that gave no result.
     *
     * @param input what was to be checked
     * @param word what became of it
     * @param message why
     */
    public void add(CheckInput input, String word, String message) {
        String id = "photo-" + ++photos;
        overviewRow(id, input, "refused", word, "", "", message, null);
        section(id, input, "refused", word, message);
        out.append("</section>\n");
    }

    private void overviewRow(String id, CheckInput input, String key, String word, String worst, String rHat,
            String reason, String action) {
        String toDo = action == null || reason.contains(action) ? ""
                : "<br><strong>First:</strong> " + escape(action) + ".";
        overview.append("<tr><td><a href=\"#").append(id).append("\">").append(escape(input.name()))
                .append("</a></td><td class=\"text\">").append(verdict(key, word))
                .append("</td><td data-of=\"worst std, mm\">").append(worst)
                .append("</td><td data-of=\"R-hat\">").append(rHat).append("</td><td class=\"text\">")
                .append(escape(reason)).append(toDo).append("</td></tr>\n");
    }

    private void section(String id, CheckInput input, String key, String word, String reason) {
        out.append("<section id=\"").append(id).append("\">\n<h2>").append(escape(input.name())).append(" &nbsp; ")
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
                        + "<path d=\"M5 5l6 6M11 5l-6 6\" stroke-width=\"2\" style=\"stroke:var(--paper)\"/>";
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
        out.append("<h3>Objects in world, mm").append(target.isPresent()
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

    /** Angles with their deviations; turns about world axes say how far off where angles cannot. */
    private void orientations(ResultView view) {
        if (view.objects().stream().noneMatch(ResultRow::seen)) {
            return;
        }
        out.append("<h3>Orientations of objects in world, deg").append(caution(view)).append("</h3>\n");
        header("", "psi", "theta", "phi", "std psi", "std theta", "std phi", "std about x", "std about y",
                "std about z");
        for (ResultRow row : view.objects()) {
            if (row.seen()) {
                orientation(CheckText.name(row), row);
            }
        }
        end();
    }

    private void orientation(String name, ResultRow row) {
        double[] mean = row.mean();
        double[] std = row.std();
        double[][] tangent = row.pose().tangentCovariance();
        String[] cells = new String[10];
        cells[0] = escape(name);
        for (int i = 0; i < 3; i++) {
            cells[1 + i] = degrees(mean[3 + i]);
            cells[4 + i] = degrees(std[3 + i]);
            cells[7 + i] = degrees(Math.sqrt(tangent[3 + i][3 + i]));
        }
        row(cells);
    }

    private static String degrees(double rad) {
        return CheckText.fixed(Math.toDegrees(rad), 4);
    }

    private void camera(ResultView view) {
        out.append("<h3>Camera in world").append(caution(view)).append("</h3>\n");
        header("", "x mm", "y mm", "z mm", "psi deg", "theta deg", "phi deg");
        poseRow("mean", view.camera().mean());
        poseRow("std", view.camera().std());
        end();
        if (!view.intrinsics().isEmpty()) {
            out.append("<h3>Intrinsics").append(caution(view)).append("</h3>\n");
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
                degrees(pose[3]), degrees(pose[4]), degrees(pose[5]));
    }

    private void modes(ResultView view) {
        if (view.verdict() != Verdict.AMBIGUOUS) {
            return;
        }
        out.append("<h3>Poses that explain the photo</h3>\n");
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
        out.append("<h3>Where the variance comes from</h3>\n");
        header("", SOURCE, "share of the variance", "share in x", "share in y", "share in z",
                "taken away: off the deviation");
        for (ResultRow row : view.points()) {
            for (BudgetShare part : row.budget()) {
                row(escape(CheckText.name(row)), escape(part.source().key()), percent(part.share()),
                        percent(part.share(0)), percent(part.share(1)), percent(part.share(2)),
                        percent(part.gain()));
            }
        }
        end();
    }

    private static String percent(double share) {
        return Double.isFinite(share) ? CheckText.fixed(100 * share, 1) + " %" : "-";
    }

    private void references(ResultView view) {
        out.append("<h3>References against each other</h3>\n");
        header("", "normalised residual", "p", "seems off in x, mm", "off in y", "off in z", "noticed from x, mm",
                "noticed from y", "noticed from z", "");
        for (ReferenceFitView fit : view.references().fits()) {
            if (!fit.used()) {
                continue;
            }
            double[] off = fit.offset();
            double[] from = fit.detectable();
            row(escape("reference " + fit.id()), CheckText.fixed(fit.normalisedResidual(), 2),
                    CheckText.fixed(fit.pValue(), 3), CheckText.fixed(off[0], 1), CheckText.fixed(off[1], 1),
                    CheckText.fixed(off[2], 1), CheckText.fixed(from[0], 1), CheckText.fixed(from[1], 1),
                    CheckText.fixed(from[2], 1), fit.misplaced() ? verdict("fail", "seems off") : "");
        }
        end();
        out.append("<p>").append(escape(view.references().noticeable())).append("</p>\n");
    }

    /** Objects without the references that seem off. */
    private void without(WithoutView without) {
        if (without == null || without.objects().isEmpty()) {
            return;
        }
        out.append("<h3>").append(escape("Without reference " + CheckText.leftOut(without)
                + ", by Laplace's approximation, mm")).append("</h3>\n");
        header("", "x", "y", "z", "moves x", "moves y", "moves z", "std x", "std y", "std z");
        for (MovedObject object : without.objects()) {
            withoutRow("object " + object.id(), object.pose().mean(), object.moveMm(), object.pose().std());
            if (object.grip() != null) {
                withoutRow("its gripping point", object.grip().meanMm(), object.grip().moveMm(),
                        object.grip().stdMm());
            }
        }
        end();
    }

    private void withoutRow(String name, double[] mean, double[] move, double[] std) {
        row(escape(name), CheckText.fixed(mean[0], 3), CheckText.fixed(mean[1], 3), CheckText.fixed(mean[2], 3),
                CheckText.signed(move[0]), CheckText.signed(move[1]), CheckText.signed(move[2]),
                CheckText.fixed(std[0], 3), CheckText.fixed(std[1], 3), CheckText.fixed(std[2], 3));
    }

    private void diagnostics(ResultView view) {
        out.append("<h3>Chains</h3>\n<p>").append(escape(CheckText.diagnosticsLine(view))).append("<br>")
                .append(escape(CheckText.laplaceLine(view))).append("<br>")
                .append(escape(CheckText.noiseLines(view).trim()).replace("\n", "<br>")).append("</p>\n");
        out.append("<details><summary>Every quantity</summary>\n");
        header("", "mean", "std", "R-hat", "bulk draws", "tail draws", "MC error of mean", "MC error of std");
        for (QuantityView q : view.chains().quantities()) {
            row(escape(q.name()), CheckText.fixed(q.mean(), 5), CheckText.fixed(q.std(), 5),
                    q.status().equals("ok") ? CheckText.fixed(q.rHat(), 4) : escape(q.status().replace('-', ' ')),
                    CheckText.fixed(q.essBulk(), 0), CheckText.fixed(q.essTail(), 0), CheckText.fixed(q.mcseMean(), 6),
                    CheckText.fixed(q.mcseStd(), 6));
        }
        end();
        header("proposal", "accepted", "rejected", "share accepted");
        for (AcceptanceCount count : view.chains().acceptance()) {
            row(escape(count.proposal()), String.valueOf(count.accepted()), String.valueOf(count.rejected()),
                    percent(count.rate()));
        }
        end();
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
        pairs(values);
    }

    private static String value(Setting<?> setting, CheckSettings settings) {
        String text = setting.text(settings);
        return text.isEmpty() ? OPEN.get(setting) : setting.unit().isEmpty() ? text : text + " " + setting.unit();
    }

    /** What the result is of, and how to have it again. */
    private void record(ResultRecord record) {
        Map<String, String> values = new LinkedHashMap<>();
        values.put("input", record.inputName());
        values.put("SHA-256 of the input", record.inputSha256());
        values.put("checked on", record.date());
        values.put("held against this target on", record.judgedOn());
        values.put("checked by", "CellGauge " + record.version());
        out.append("<h3>Record</h3>\n");
        pairs(values);
        if (record.command() != null) {
            out.append("<p>The same figures again:</p>\n<pre>").append(escape(record.command())).append("</pre>\n");
        }
    }

    // ---- what all photos rest on

    /** The cell as it was read. */
    private void cell() {
        out.append("<section id=\"cell\">\n<h2>Cell</h2>\n");
        Map<String, String> values = new LinkedHashMap<>();
        PinholeCamera camera = cell.camera();
        values.put("target", targetStdMm.isPresent() ? CheckText.plain(targetStdMm.getAsDouble()) + " mm" : "none");
        values.put("noise of corners", cell.pixelStdPx().isPresent()
                ? CheckText.plain(cell.pixelStdPx().getAsDouble()) + " px" : "learned from each photo");
        values.put("markers", cell.family());
        values.put("std of printed sizes", CheckText.plain(cell.sizeStdMm()) + " mm");
        values.put("flatness of prints", CheckText.plain(cell.flatnessMm()) + " mm");
        values.put("std of print gain", CheckText.plain(cell.printGainStdMm()) + " mm");
        values.put("camera", camera.widthPx() + " x " + camera.heightPx() + " px, " + camera.lens().modelName());
        List<String> names = camera.lens().parameterNames();
        for (int i = 0; i < names.size(); i++) {
            values.put("camera " + names.get(i), CheckText.plain(camera.get(i)));
        }
        pairs(values);
        out.append("<h3>References as stated</h3>\n");
        header("", "size mm", "x mm", "y mm", "z mm", "psi deg", "theta deg", "phi deg", "std x mm", "std y mm",
                "std z mm", "std of turn, deg");
        for (StatedReference r : cell.references()) {
            List<String> cells = new ArrayList<>(List.of(escape("reference " + r.id()), CheckText.plain(r.sizeMm())));
            for (double mm : r.positionMm()) {
                cells.add(CheckText.fixed(mm, 3));
            }
            for (double rad : r.rotationRad()) {
                cells.add(degrees(rad));
            }
            for (double mm : r.stdMm()) {
                cells.add(CheckText.fixed(mm, 3));
            }
            cells.add(degrees(r.stdRad()));
            row(cells.toArray(new String[0]));
        }
        end();
        if (!cell.objects().isEmpty()) {
            out.append("<h3>Objects as stated</h3>\n");
            header("", "size mm", "gripping point x mm", "gripping point y mm", "gripping point z mm");
            for (StatedObject o : cell.objects()) {
                double[] grip = o.gripMm();
                row(escape("object " + o.id()), CheckText.plain(o.sizeMm()),
                        grip == null ? "-" : CheckText.fixed(grip[0], 3),
                        grip == null ? "-" : CheckText.fixed(grip[1], 3),
                        grip == null ? "-" : CheckText.fixed(grip[2], 3));
            }
            end();
        }
        out.append("</section>\n");
    }

    private void run() {
        Map<String, String> values = new LinkedHashMap<>();
        values.put("date", day);
        values.put("program", "CellGauge " + version);
        values.put("cell file", cellFile.file().toString());
        values.put("SHA-256 of the cell file", cellFile.sha256());
        values.put("camera file", cellFile.cameraName() == null ? "none: the cell file holds the camera"
                : cellFile.cameraName());
        values.put("SHA-256 of the camera file", cellFile.cameraSha256());
        pairs(values);
    }

    /** A table of names and texts; what is null is left out. */
    private void pairs(Map<String, String> values) {
        out.append("<table>\n");
        values.forEach((name, value) -> {
            if (value != null) {
                out.append("<tr><td>").append(escape(name)).append("</td><td class=\"text\">").append(escape(value))
                        .append("</td></tr>\n");
            }
        });
        end();
    }

    private void header(String... cells) {
        header = cells;
        out.append("<table>\n<tr class=\"head\">");
        for (String cell : cells) {
            out.append(cell.equals(SOURCE) ? "<th class=\"text\">" : "<th>").append(escape(cell)).append("</th>");
        }
        out.append("</tr>\n");
    }

    private void row(String... html) {
        out.append("<tr>");
        for (int i = 0; i < html.length; i++) {
            String words = header[i].equals(SOURCE) ? " class=\"text\"" : "";
            out.append(header[i].isEmpty() ? "<td>" : "<td data-of=\"" + escape(header[i]) + "\"" + words + ">")
                    .append(html[i]).append("</td>");
        }
        out.append("</tr>\n");
    }

    private void end() {
        out.append("</table>\n");
    }

    /**
     * The page.
     *
     * @param total one line about the whole run
     * @return HTML
     */
    public String html(String total) {
        StringBuilder page = new StringBuilder();
        String name = cellFile.file().toString();
        page.append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                + "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
                + "style-src 'unsafe-inline'\">\n"
                + "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n")
                .append("<title>CellGauge: ").append(escape(name)).append("</title>\n<style>").append(STYLE)
                .append("</style>\n</head>\n<body>\n<h1>CellGauge: ").append(escape(name)).append("</h1>\n<p>")
                .append(escape(total)).append("</p>\n");
        out = page;
        run();
        page.append("<table>\n<tr class=\"head\"><th>photo</th><th class=\"text\">verdict</th>"
                + "<th>worst std, mm</th><th>R-hat</th><th class=\"text\">why</th></tr>\n").append(overview)
                .append("</table>\n").append(trend.html()).append(sections);
        cell();
        out = sections;
        return page.append("<p class=\"sign\"><span>Date</span><span>Name</span><span>Signature</span></p>\n"
                + "<p><small>CellGauge ").append(escape(version))
                .append(". Lengths in mm, std: standard deviation. Angles psi, theta, phi turn about x, y, z.</small>"
                + "</p>\n</body>\n</html>\n").toString();
    }

    static String escape(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;")
                .replace("'", "&#39;");
    }
}
