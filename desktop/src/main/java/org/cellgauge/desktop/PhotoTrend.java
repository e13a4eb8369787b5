package org.cellgauge.desktop;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.cellgauge.output.ResultRow;
import org.cellgauge.output.ResultView;

/**
 * Positions over the photos of a batch: how far they scatter, and whether they drift. Photos whose figures are not to
 * be trusted do not count. Errors that all photos share, such as those of placed references, move all of them alike and
 * do not show here; so the scatter of an object that stands still is usually less than its stated deviation.
 */
final class PhotoTrend {
    private static final String[] AXES = {"x", "y", "z"};
    private static final int FEWEST = 2;
    private static final int FEWEST_FOR_SLOPE = 3;
    /** Beyond this many, plots show every second, third, … photo; tables count all. */
    private static final int MOST_MARKS = 400;
    private static final int WIDTH = 360;
    private static final int HEIGHT = 130;
    private static final int LEFT = 56;
    private static final int RIGHT = 8;
    private static final int TOP = 18;
    private static final int BOTTOM = 18;

    private final Map<String, List<double[]>> positions = new LinkedHashMap<>();

    /** Adds a photo by its number in the batch. */
    void add(int number, ResultView view) {
        if (!view.trusted()) {
            return;
        }
        for (ResultRow row : view.rows()) {
            if (row.seen()) {
                String name = row.kind() == ResultRow.Kind.CAMERA ? "camera" : row.kind() == ResultRow.Kind.GRIP
                        ? "gripping point of object " + row.id().getAsInt() : CheckText.name(row);
                double[] mean = row.mean();
                double[] std = row.std();
                positions.computeIfAbsent(name, n -> new ArrayList<>()).add(new double[] {number, mean[0], mean[1],
                    mean[2], std[0], std[1], std[2]});
            }
        }
    }

    /** A line through positions over the numbers of photos, by least squares. */
    record Line(int count, double mean, double scatter, double drift, double driftStd) {
        /**
         * Fits a line.
         *
         * @param points number of the photo, position
         * @return mean and standard deviation of the positions; drift from the first photo to the last and its standard
         *     error, NaN of fewer than three photos
         */
        static Line of(double[][] points) {
            int n = points.length;
            double meanX = 0;
            double meanY = 0;
            for (double[] p : points) {
                meanX += p[0] / n;
                meanY += p[1] / n;
            }
            double xx = 0;
            double xy = 0;
            double yy = 0;
            for (double[] p : points) {
                xx += (p[0] - meanX) * (p[0] - meanX);
                xy += (p[0] - meanX) * (p[1] - meanY);
                yy += (p[1] - meanY) * (p[1] - meanY);
            }
            double span = points[n - 1][0] - points[0][0];
            boolean line = n >= FEWEST_FOR_SLOPE;
            double slope = xy / xx;
            double left = Math.max(0, yy - slope * xy);
            return new Line(n, meanY, Math.sqrt(yy / (n - 1)), line ? slope * span : Double.NaN,
                    line ? span * Math.sqrt(left / (n - 2) / xx) : Double.NaN);
        }
    }

    /** The part of the report; empty where there are not two photos to compare. */
    String html() {
        StringBuilder rows = new StringBuilder();
        StringBuilder plots = new StringBuilder();
        positions.forEach((name, points) -> {
            if (points.size() >= FEWEST) {
                add(name, points, rows, plots);
            }
        });
        if (rows.length() == 0) {
            return "";
        }
        String[] header = {"", "axis", "photos", "mean, mm", "scatter (std over photos), mm", "stated std, mm",
            "drift from first to last, mm", "std of the drift, mm"};
        StringBuilder head = new StringBuilder();
        for (String cell : header) {
            head.append("<th>").append(cell).append("</th>");
        }
        return "<section id=\"photos\">\n<h2>Over the photos</h2>\n<p>Photos with figures to trust, in the order of "
                + "the batch. What they share, such as errors of placed references, moves all alike and does not "
                + "scatter.</p>\n<table>\n<tr class=\"head\">" + head + "</tr>\n" + rows + "</table>\n" + plots
                + "</section>\n";
    }

    private static void add(String name, List<double[]> points, StringBuilder rows, StringBuilder plots) {
        plots.append("<p>");
        for (int axis = 0; axis < AXES.length; axis++) {
            double[][] series = new double[points.size()][];
            double squares = 0;
            for (int i = 0; i < series.length; i++) {
                double[] p = points.get(i);
                series[i] = new double[] {p[0], p[1 + axis], p[4 + axis]};
                squares += p[4 + axis] * p[4 + axis];
            }
            Line line = Line.of(series);
            rows.append("<tr><td>").append(HtmlReport.escape(name)).append("</td>");
            cell(rows, "axis", AXES[axis]);
            cell(rows, "photos", String.valueOf(line.count()));
            cell(rows, "mean, mm", CheckText.fixed(line.mean(), 3));
            cell(rows, "scatter (std over photos), mm", CheckText.fixed(line.scatter(), 3));
            cell(rows, "stated std, mm", CheckText.fixed(Math.sqrt(squares / series.length), 3));
            cell(rows, "drift from first to last, mm", CheckText.fixed(line.drift(), 3));
            cell(rows, "std of the drift, mm", CheckText.fixed(line.driftStd(), 3));
            rows.append("</tr>\n");
            plots.append(plot(name + ", " + AXES[axis] + ", mm", series, line.mean()));
        }
        plots.append("</p>\n");
    }

    private static void cell(StringBuilder rows, String of, String value) {
        rows.append("<td data-of=\"").append(of).append("\">").append(value).append("</td>");
    }

    /** Means with one standard deviation to either side. */
    private static String plot(String title, double[][] series, double mean) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (double[] p : series) {
            low = Math.min(low, p[1] - p[2]);
            high = Math.max(high, p[1] + p[2]);
        }
        if (!(high > low)) {
            high = low + 1;
        }
        double first = series[0][0];
        double last = series[series.length - 1][0];
        StringBuilder svg = new StringBuilder();
        svg.append(String.format(Locale.ROOT, "<svg class=\"plot\" role=\"img\" width=\"%d\" height=\"%d\" "
                + "viewBox=\"0 0 %d %d\"><title>%s</title>", WIDTH, HEIGHT, WIDTH, HEIGHT, HtmlReport.escape(title)));
        text(svg, LEFT, TOP - 6, "start", title);
        text(svg, LEFT - 4, TOP + 8, "end", CheckText.fixed(high, 1));
        text(svg, LEFT - 4, HEIGHT - BOTTOM, "end", CheckText.fixed(low, 1));
        text(svg, LEFT, HEIGHT - 4, "start", "photo " + Math.round(first));
        text(svg, WIDTH - RIGHT, HEIGHT - 4, "end", String.valueOf(Math.round(last)));
        line(svg, "axis", LEFT, TOP, LEFT, HEIGHT - BOTTOM);
        line(svg, "axis", LEFT, HEIGHT - BOTTOM, WIDTH - RIGHT, HEIGHT - BOTTOM);
        line(svg, "mean", LEFT, y(mean, low, high), WIDTH - RIGHT, y(mean, low, high));
        int every = (series.length + MOST_MARKS - 1) / MOST_MARKS;
        for (int i = 0; i < series.length; i += every) {
            double[] p = series[i];
            double x = LEFT + 6 + (p[0] - first) / (last - first) * (WIDTH - LEFT - RIGHT - 12);
            line(svg, "mark", x, y(p[1] - p[2], low, high), x, y(p[1] + p[2], low, high));
            svg.append(String.format(Locale.ROOT, "<circle class=\"mark\" cx=\"%.1f\" cy=\"%.1f\" r=\"2.5\"/>", x,
                    y(p[1], low, high)));
        }
        return svg.append("</svg>\n").toString();
    }

    private static double y(double value, double low, double high) {
        return HEIGHT - BOTTOM - (value - low) / (high - low) * (HEIGHT - TOP - BOTTOM);
    }

    private static void line(StringBuilder svg, String kind, double x1, double y1, double x2, double y2) {
        svg.append(String.format(Locale.ROOT, "<line class=\"%s\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>",
                kind, x1, y1, x2, y2));
    }

    private static void text(StringBuilder svg, double x, double y, String anchor, String text) {
        svg.append(String.format(Locale.ROOT, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">", x, y, anchor))
                .append(HtmlReport.escape(text)).append("</text>");
    }
}
