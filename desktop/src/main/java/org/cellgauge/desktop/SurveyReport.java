package org.cellgauge.desktop;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.survey.Drift;
import org.cellgauge.survey.SurveyResult;
import org.cellgauge.survey.SurveyedObject;
import org.cellgauge.warning.Warning;
import org.jspecify.annotations.Nullable;

/** The page of a survey: its tables, and how deviations fell with the number of photos. */
public final class SurveyReport {
    private static final int WIDTH = 720;
    private static final int HEIGHT = 260;
    private static final int LEFT = 60;
    private static final int BOTTOM = 30;

    private SurveyReport() {
    }

    /**
     * The page.
     *
     * @param result a survey
     * @param drift what has moved since an earlier one; null where it is held against none
     * @param version of this program
     * @param command that makes it again
     * @return HTML that holds all it shows
     */
    public static String of(SurveyResult result, @Nullable Drift drift, String version, String command) {
        StringBuilder out = new StringBuilder();
        out.append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                + "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
                + "style-src 'unsafe-inline'\">\n"
                + "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
                + "<title>Survey of a cell</title>\n<style>").append(HtmlReport.STYLE)
                .append("</style>\n</head>\n<body>\n<h1>Survey of a cell</h1>\n");
        List<Warning> said = new ArrayList<>(result.warnings());
        said.addAll(drift == null ? List.of() : drift.warnings());
        for (Warning w : said) {
            out.append("<p class=\"caution\">").append(Html.escape(w.toString())).append("</p>\n");
        }
        out.append("<pre>").append(Html.escape(SurveyText.of(result))).append("</pre>\n");
        if (drift != null) {
            out.append("<pre>").append(Html.escape(SurveyText.of(drift))).append("</pre>\n");
            DriftChart.add(drift, out);
        }
        out.append("<h2>What more photos bring</h2>\n<p>Largest deviation of an object's position along an axis after "
                + "the first photos, in the order of the photos, and last with one more that tells as much as those "
                + "there are. Where it is level, more photos do not help: place references more precisely, or measure "
                + "distances between them.</p>\n");
        for (SurveyedObject o : result.objects()) {
            curve(o, out);
        }
        return out.append("<h2>Made by</h2>\n<pre>").append(Html.escape(command)).append("</pre>\n<p>CellGauge ")
                .append(Html.escape(version)).append("</p>\n</body>\n</html>\n").toString();
    }

    private static void curve(SurveyedObject o, StringBuilder out) {
        List<Double> stds = o.worstStdMmByPhotos();
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        for (double std : stds) {
            least = Double.isNaN(std) ? least : Math.min(least, std);
            most = Double.isNaN(std) ? most : Math.max(most, std);
        }
        if (!(most > 0)) {
            return;
        }
        // deviations fall over orders of size: a logarithmic axis from a power of ten to one
        double from = Math.floor(Math.log10(Math.min(least, o.nextWorstStdMm())));
        double to = Math.max(from + 1, Math.ceil(Math.log10(most)));
        out.append("<h3>Object ").append(o.marker().id()).append("</h3>\n<p>").append(Html.escape(SurveyText.limits(o)))
                .append("</p>\n<svg class=\"plot\" viewBox=\"0 0 ").append(WIDTH).append(' ').append(HEIGHT)
                .append("\" role=\"img\" aria-label=\"deviation by number of photos\">\n");
        for (int power = (int) from; power <= to; power++) {
            String y = CheckText.fixed(y(Math.pow(10, power), from, to), 1);
            out.append("<path d=\"M").append(LEFT).append(' ').append(y).append('H').append(WIDTH)
                    .append("\" stroke=\"currentColor\" stroke-width=\"0.5\" fill=\"none\"/>")
                    .append("<text x=\"2\" y=\"").append(y)
                    .append("\" fill=\"currentColor\" font-size=\"12\">").append(CheckText.plain(Math.pow(10, power)))
                    .append(" mm</text>\n");
        }
        StringBuilder path = new StringBuilder();
        for (int k = 0; k <= stds.size(); k++) {
            double std = k < stds.size() ? stds.get(k) : o.nextWorstStdMm();
            if (!Double.isNaN(std)) {
                path.append(path.length() == 0 ? "M" : "L")
                        .append(CheckText.fixed(LEFT + (WIDTH - LEFT - 20.0) * k / stds.size(), 1)).append(' ')
                        .append(CheckText.fixed(y(std, from, to), 1));
            }
        }
        out.append("<path d=\"").append(path)
                .append("\" stroke=\"currentColor\" stroke-width=\"2\" fill=\"none\"/>\n<text x=\"").append(LEFT)
                .append("\" y=\"").append(HEIGHT - 4).append("\" fill=\"currentColor\" font-size=\"12\">1 to ")
                .append(stds.size()).append(" photos, and one more</text>\n</svg>\n");
    }

    private static double y(double std, double from, double to) {
        return 10 + (HEIGHT - BOTTOM - 10) * (to - Math.log10(std)) / (to - from);
    }
}
