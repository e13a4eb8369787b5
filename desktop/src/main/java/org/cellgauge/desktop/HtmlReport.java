package org.cellgauge.desktop;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.cell.Target;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.warning.Printable;
import org.cellgauge.output.CellView;
import org.cellgauge.output.StatedObject;
import org.cellgauge.output.StatedReference;

/**
 * The pages of a report, {@code report.html} and, of many photos, {@code report-001.html} and so on: each holds all it
 * shows, pictures and styles included, so that it can be kept and signed. Verdicts are told apart by word and shape,
 * never by colour alone. On a narrow screen each row of a table becomes a block of its own, so that no column lies
 * outside the page.
 */
final class HtmlReport {
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

    private final CellFile cellFile;
    private final CellView cell;
    private final Target target;
    private final String version;
    private final String day;
    private final List<String> remarks;

    /**
     * The report of a run.
     *
     * @param cellFile the cell and its files
     * @param cell what the results rest on of it
     * @param target what is asked of the objects
     * @param version version of this program
     * @param day of the run, as in {@code 2026-11-28}; null: it is not told
     * @param remarks what was found besides the inputs and not checked
     */
    HtmlReport(CellFile cellFile, CellView cell, Target target, String version, String day,
            List<String> remarks) {
        this.cellFile = cellFile;
        this.cell = cell;
        this.target = target;
        this.version = version;
        this.day = day;
        this.remarks = List.copyOf(remarks);
    }

    /**
     * The page that a run is signed on: what it was, an overview, how positions go over the photos, and the cell.
     *
     * @param total one line about the whole run
     * @param overview HTML of the table or tables of photos
     * @param trend over the photos
     * @param sections of the photos, in HTML in UTF-8; empty where they are on pages of their own
     * @return writes the page
     */
    WholeFiles.Content main(String total, String overview, PhotoTrend trend, byte[] sections) {
        Html head = head("CellGauge: " + Printable.of(cellFile.file().toString()), total);
        run(head);
        if (!remarks.isEmpty()) {
            head.append("<ul>");
            remarks.forEach(r -> head.append("<li>" + Html.escape(Printable.of(r)) + "</li>"));
            head.append("</ul>\n");
        }
        head.append(overview).append(trend.html());
        Html tail = new Html();
        cell(tail);
        tail.append("<p class=\"sign\"><span>Date</span><span>Name</span><span>Signature</span></p>\n");
        return page(head, sections, tail);
    }

    /**
     * A page of some of many photos.
     *
     * @param title what it shows
     * @param links to the pages beside it, in HTML
     * @param overview HTML of the table of its photos
     * @param sections of its photos, in HTML in UTF-8
     * @return writes the page
     */
    WholeFiles.Content part(String title, String links, String overview, byte[] sections) {
        Html head = head("CellGauge: " + Printable.of(cellFile.file().toString()) + ", " + title, "");
        head.append(links).append(overview);
        return page(head, sections, new Html().append(links));
    }

    /** The table of photos around its rows. */
    static String overview(String rows) {
        return "<table>\n<tr class=\"head\"><th>photo</th><th class=\"text\">verdict</th>"
                + "<th>worst std, mm</th><th>R-hat</th><th class=\"text\">why</th></tr>\n" + rows + "</table>\n";
    }

    private static Html head(String title, String total) {
        return new Html().append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                + "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
                + "style-src 'unsafe-inline'\">\n"
                + "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>"
                + Html.escape(title) + "</title>\n<style>" + STYLE + "</style>\n</head>\n<body>\n<h1>"
                + Html.escape(title) + "</h1>\n" + (total.isEmpty() ? "" : "<p>" + Html.escape(total) + "</p>\n"));
    }

    private WholeFiles.Content page(Html head, byte[] sections, Html tail) {
        tail.append("<p><small>CellGauge " + Html.escape(version) + ". Lengths in mm, std: standard deviation. Angles "
                + "psi, theta, phi turn about x, y, z.</small></p>\n</body>\n</html>\n");
        return out -> {
            write(head, out);
            out.write(sections);
            write(tail, out);
        };
    }

    private static void write(Html html, OutputStream out) throws IOException {
        out.write(html.toString().getBytes(StandardCharsets.UTF_8));
    }

    /** The cell as it was read. */
    private void cell(Html out) {
        out.append("<section id=\"cell\">\n<h2>Cell</h2>\n");
        Map<String, String> values = new LinkedHashMap<>();
        PinholeCamera camera = cell.camera();
        values.put("target", target.oneStdMm().isPresent()
                ? CheckText.plain(target.oneStdMm().getAsDouble()) + " mm"
                : target.isAny() ? target.toString() : "none");
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
        out.pairs(values);
        out.append("<h3>References as stated</h3>\n");
        out.header("", "size mm", "x mm", "y mm", "z mm", "psi deg", "theta deg", "phi deg", "std x mm", "std y mm",
                "std z mm", "std of turn, deg");
        for (StatedReference r : cell.references()) {
            List<String> cells = new ArrayList<>(List.of(Html.escape("reference " + r.id()),
                    CheckText.plain(r.sizeMm())));
            for (double mm : r.positionMm()) {
                cells.add(CheckText.fixed(mm, 3));
            }
            for (double rad : r.rotationRad()) {
                cells.add(Html.degrees(rad));
            }
            for (double mm : r.stdMm()) {
                cells.add(CheckText.fixed(mm, 3));
            }
            cells.add(Html.degrees(r.stdRad()));
            out.row(cells.toArray(new String[0]));
        }
        out.end();
        if (!cell.objects().isEmpty()) {
            out.append("<h3>Objects as stated</h3>\n");
            out.header("", "size mm", "gripping point x mm", "gripping point y mm", "gripping point z mm");
            for (StatedObject o : cell.objects()) {
                double[] grip = o.gripMm();
                out.row(Html.escape("object " + o.id()), CheckText.plain(o.sizeMm()),
                        grip == null ? "-" : CheckText.fixed(grip[0], 3),
                        grip == null ? "-" : CheckText.fixed(grip[1], 3),
                        grip == null ? "-" : CheckText.fixed(grip[2], 3));
            }
            out.end();
        }
        out.append("</section>\n");
    }

    private void run(Html out) {
        Map<String, String> values = new LinkedHashMap<>();
        values.put("date", day);
        values.put("program", "CellGauge " + version);
        values.put("cell file", Printable.of(cellFile.file().toString()));
        values.put("SHA-256 of the cell file", cellFile.sha256());
        values.put("camera file", cellFile.cameraName() == null ? "none: the cell file holds the camera"
                : Printable.of(cellFile.cameraName()));
        values.put("SHA-256 of the camera file", cellFile.cameraSha256());
        out.pairs(values);
    }
}
