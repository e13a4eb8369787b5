package org.cellgauge.desktop;

import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import org.cellgauge.calibration.CalibrationResult;

/**
 * The page of a calibration: figures and pictures in one file that holds all it shows. Pictures are drawn to the
 * image's shape; every one says its figures in words as well, so that colour carries nothing alone.
 */
public final class CalibrationReport {
    private static final int WIDTH = 720;
    private static final int REGION_COLUMNS = 8;
    private static final int REGION_ROWS = 6;
    /** Length of the largest usual error in the picture of residuals, in its units. */
    private static final double ARROW = 30;

    private final CalibrationResult result;
    private final String version;
    private final String command;
    private final StringBuilder out = new StringBuilder();
    private final double scale;
    private final int height;

    private CalibrationReport(CalibrationResult result, String version, String command) {
        this.result = result;
        this.version = version;
        this.command = command;
        scale = (double) WIDTH / result.camera().widthPx();
        height = (int) Math.round(scale * result.camera().heightPx());
    }

    /**
     * The page.
     *
     * @param result a calibration
     * @param version of this program
     * @param command that makes it again
     * @return HTML
     */
    public static String of(CalibrationResult result, String version, String command) {
        return new CalibrationReport(result, version, command).page();
    }

    private String page() {
        out.append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                + "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
                + "style-src 'unsafe-inline'\">\n"
                + "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
                + "<title>Camera calibration</title>\n<style>").append(HtmlReport.STYLE)
                .append("svg.plot .left-out{stroke:var(--fail);fill:none}svg.plot .cell{stroke:var(--line)}")
                .append("</style>\n</head>\n<body>\n<h1>Camera calibration</h1>\n");
        summary();
        warnings();
        parameters();
        photos();
        ladder();
        residuals();
        regions();
        double mm = result.figures().distanceMm() / result.parameters().get(0).value();
        map("How sure the projection is", "Standard deviation of where a direction is seen, in the direction where it "
                + "is largest: above in px, below in mm at " + CheckText.fixed(result.figures().distanceMm(), 0)
                + " mm. What a turn of the camera makes good is left out, since poses are estimated with every photo.",
                CalibrationResult.Place::stdPx, mm);
        if (!Double.isNaN(result.figures().crossRatio())) {
            map("Odd photos against even photos", "Difference of two calibrations that share no photo, over what their "
                    + "covariances say of it. About 1 is chance; beyond 2 lens model or target are wrong.",
                    CalibrationResult.Place::crossRatio, 0);
        }
        out.append("<h2>Made by</h2>\n<pre>").append(Html.escape(command)).append("</pre>\n<p>CellGauge ")
                .append(Html.escape(version)).append("</p>\n</body>\n</html>\n");
        return out.toString();
    }

    private void summary() {
        CalibrationResult.Figures f = result.figures();
        out.append("<p>").append(result.camera().widthPx()).append(" x ").append(result.camera().heightPx())
                .append(" px, lens ").append(Html.escape(result.lens())).append(", ")
                .append(result.photos().size()).append(" photos with ").append(f.points()).append(" corners, ")
                .append(f.outliers()).append(" left out. Reprojection error ").append(CheckText.fixed(f.rmsPx(), 3))
                .append(" px rms, noise of a coordinate ").append(CheckText.fixed(f.noisePx(), 3))
                .append(" px. Field of view ").append(CheckText.fixed(f.horizontalDeg(), 1)).append(" by ")
                .append(CheckText.fixed(f.verticalDeg(), 1)).append(" degrees. ")
                .append(CheckText.fixed(100 * f.coveredShare(), 0)).append(" % of the image covered.</p>\n");
        if (result.inQuestion()) {
            out.append("<p class=\"caution\">This calibration is in question.</p>\n");
        }
    }

    private void warnings() {
        if (!result.warnings().isEmpty()) {
            out.append("<h2>Warnings</h2>\n<ul>");
            result.warnings().forEach(w -> out.append("<li>").append(Html.escape(w.toString())).append("</li>"));
            out.append("</ul>\n");
        }
        if (result.nextPhoto() != null) {
            out.append("<p>What would help most: ").append(Html.escape(result.nextPhoto().toString()))
                    .append(".</p>\n");
        }
    }

    private void parameters() {
        out.append("<h2>Parameters</h2>\n<table><tr class=\"head\"><th></th><th>value</th><th>std</th></tr>\n");
        for (List<CalibrationResult.Parameter> part : List.of(result.parameters(), result.board())) {
            part.forEach(p -> row(p.name(), CalibrationText.value(p.value()), CalibrationText.value(p.std())));
        }
        out.append("</table>\n");
        if (result.widenedBy() > 1) {
            out.append("<p>Deviations are widened by ").append(CheckText.fixed(result.widenedBy(), 2))
                    .append(" because odd and even photos contradict each other.</p>\n");
        }
    }

    private void row(String... cells) {
        out.append("<tr>");
        for (String cell : cells) {
            out.append("<td>").append(Html.escape(cell)).append("</td>");
        }
        out.append("</tr>\n");
    }

    private void photos() {
        out.append("<h2>Photos</h2>\n<table><tr class=\"head\"><th></th><th>corners</th><th>left out</th>"
                + "<th>rms, px</th><th>tilt, deg</th><th>distance, mm</th><th>without it, variance</th><th></th>"
                + "</tr>\n");
        for (CalibrationResult.Photo p : result.photos()) {
            row(p.name(), String.valueOf(p.points()), String.valueOf(p.outliers()), CheckText.fixed(p.rmsPx(), 3),
                    CheckText.fixed(p.tiltDeg(), 0), CheckText.fixed(p.distanceMm(), 0),
                    Double.isFinite(p.gain()) ? "+" + CheckText.fixed(100 * p.gain(), 0) + " %" : "no calibration",
                    p.contradicts() ? "contradicts the others" : p.addsLittle() ? "adds little" : "");
        }
        out.append("</table>\n");
    }

    private void ladder() {
        if (result.ladder().isEmpty()) {
            return;
        }
        out.append("<h2>Lens models</h2>\n<p>Error in photos that the fit has not seen: a lean model always looks "
                + "certain, and this tells whether it is right. The deviations allow for all of them by their "
                + "weights.</p>\n"
                + "<table><tr class=\"head\"><th></th>"
                + "<th>unknowns</th><th>held-out error, px</th><th>weight, %</th></tr>\n");
        result.ladder().forEach(t -> row(t.lens(), String.valueOf(t.unknowns()),
                CheckText.fixed(t.heldOutRmsPx(), 4), CheckText.fixed(100 * t.weight(), 0)));
        out.append("</table>\n");
    }

    // ---- pictures

    private void open(String title, String words) {
        out.append("<h2>").append(title).append("</h2>\n<p>").append(words).append("</p>\n<p><svg class=\"plot\" "
                + "role=\"img\" aria-label=\"").append(title).append("\" viewBox=\"0 0 ").append(WIDTH).append(' ')
                .append(height).append("\" width=\"").append(WIDTH).append("\">\n");
    }

    private void close() {
        out.append("</svg></p>\n");
    }

    private static String n(double value) {
        return String.format(Locale.ROOT, "%.1f", value);
    }

    private void residuals() {
        double[] lengths = result.residuals().stream().filter(r -> !r.outlier())
                .mapToDouble(r -> Math.hypot(r.du(), r.dv())).sorted().toArray();
        if (lengths.length == 0) {
            return;
        }
        double usual = lengths[(int) (0.95 * (lengths.length - 1))];
        double arrow = ARROW / Math.max(usual, 1e-9);
        open("Reprojection errors", "Every corner where it was seen, its error drawn "
                + CheckText.fixed(arrow / scale, 0) + " times as long as it is; corners left out as circles. Arrows of "
                + "one direction side by side tell of a wrong lens model; empty parts were never covered.");
        for (CalibrationResult.Residual r : result.residuals()) {
            double u = scale * r.u();
            double v = scale * r.v();
            if (r.outlier()) {
                out.append("<circle class=\"left-out\" cx=\"").append(n(u)).append("\" cy=\"").append(n(v))
                        .append("\" r=\"5\"/>\n");
            } else {
                out.append("<path class=\"mark\" d=\"M").append(n(u)).append(' ').append(n(v)).append('l')
                        .append(n(arrow * r.du())).append(' ').append(n(arrow * r.dv())).append("\"/>\n");
            }
        }
        close();
    }

    private void regions() {
        double[] sum = new double[REGION_COLUMNS * REGION_ROWS];
        int[] count = new int[sum.length];
        for (CalibrationResult.Residual r : result.residuals()) {
            int column = (int) (r.u() * REGION_COLUMNS / result.camera().widthPx());
            int row = (int) (r.v() * REGION_ROWS / result.camera().heightPx());
            if (!r.outlier() && column >= 0 && column < REGION_COLUMNS && row >= 0 && row < REGION_ROWS) {
                sum[row * REGION_COLUMNS + column] += r.du() * r.du() + r.dv() * r.dv();
                count[row * REGION_COLUMNS + column]++;
            }
        }
        open("Reprojection error by region", "Root mean square in px, and below how many corners it is of.");
        double w = (double) WIDTH / REGION_COLUMNS;
        double h = (double) height / REGION_ROWS;
        double worst = 0;
        for (int k = 0; k < sum.length; k++) {
            worst = Math.max(worst, count[k] == 0 ? 0 : Math.sqrt(sum[k] / count[k]));
        }
        for (int k = 0; k < sum.length; k++) {
            double rms = count[k] == 0 ? Double.NaN : Math.sqrt(sum[k] / count[k]);
            cell(k % REGION_COLUMNS * w, k / REGION_COLUMNS * h, w, h, rms / worst,
                    count[k] == 0 ? "-" : CheckText.fixed(rms, 2), String.valueOf(count[k]));
        }
        close();
    }

    /** A picture of figures over the image. */
    private void map(String title, String words, ToDoubleFunction<CalibrationResult.Place> value, double second) {
        List<CalibrationResult.Place> places = result.places();
        int columns = result.placesPerRow();
        int rows = places.size() / columns;
        double worst = places.stream().mapToDouble(value).filter(Double::isFinite).max().orElse(1);
        double w = (double) WIDTH / columns;
        double h = (double) height / rows;
        open(title, words);
        for (int k = 0; k < places.size(); k++) {
            double v = value.applyAsDouble(places.get(k));
            cell(k % columns * w, k / columns * h, w, h, v / worst, Double.isFinite(v) ? CheckText.fixed(v, 2) : "-",
                    second > 0 && Double.isFinite(v) ? CheckText.fixed(v * second, 2) : "");
        }
        close();
    }

    private void cell(double x, double y, double w, double h, double share, String above, String below) {
        out.append("<rect class=\"cell\" x=\"").append(n(x)).append("\" y=\"").append(n(y)).append("\" width=\"")
                .append(n(w)).append("\" height=\"").append(n(h)).append("\" fill=\"var(--link)\" fill-opacity=\"")
                .append(Double.isFinite(share) ? String.format(Locale.ROOT, "%.2f", 0.05 + 0.45 * share) : "0")
                .append("\"/><text text-anchor=\"middle\" x=\"").append(n(x + w / 2)).append("\" y=\"")
                .append(n(y + h / 2)).append("\">").append(above).append("</text><text text-anchor=\"middle\" x=\"")
                .append(n(x + w / 2)).append("\" y=\"").append(n(y + h / 2 + 13)).append("\">").append(below)
                .append("</text>\n");
    }
}
