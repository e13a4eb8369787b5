package org.cellgauge.desktop;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.cellgauge.internal.warning.Decimal;
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
    /** Beyond this many, plots show every second, fourth, … photo; tables count all. */
    private static final int MOST_MARKS = 400;
    private static final int WIDTH = 360;
    private static final int HEIGHT = 130;
    private static final int LEFT = 56;
    private static final int RIGHT = 8;
    private static final int TOP = 18;
    private static final int BOTTOM = 18;

    private final Map<String, Series> positions = new LinkedHashMap<>();

    /** Adds a photo by its number in the batch; numbers rise. */
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
                positions.computeIfAbsent(name, n -> new Series()).add(new double[] {number, mean[0], mean[1],
                    mean[2], std[0], std[1], std[2]});
            }
        }
    }

    /** Positions of one thing: sums of all, and some to plot, so that no batch is too long for the memory. */
    private static final class Series {
        private final Line[] lines = {new Line(), new Line(), new Line()};
        private final double[] squares = new double[AXES.length];
        private final double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        private final double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        private final List<double[]> marks = new ArrayList<>();
        private int every = 1;

        /** Adds number of the photo, position and its standard deviations. */
        void add(double[] p) {
            for (int axis = 0; axis < AXES.length; axis++) {
                double std = p[4 + axis];
                squares[axis] += std * std;
                low[axis] = Math.min(low[axis], p[1 + axis] - std);
                high[axis] = Math.max(high[axis], p[1 + axis] + std);
                lines[axis].add(p[0], p[1 + axis]);
            }
            if ((lines[0].count() - 1) % every == 0) {
                mark(p);
            }
        }

        private void mark(double[] p) {
            marks.add(p);
            if (marks.size() > MOST_MARKS) {
                for (int i = 0; 2 * i < marks.size(); i++) {
                    marks.set(i, marks.get(2 * i));
                }
                marks.subList((marks.size() + 1) / 2, marks.size()).clear();
                every *= 2;
            }
        }
    }

    /** A line through positions over the numbers of photos, by least squares; sums alone are kept (Welford's). */
    static final class Line {
        private int count;
        private double first;
        private double last;
        private double meanX;
        private double meanY;
        private double xx;
        private double xy;
        private double yy;

        /** Adds a photo by its number, and a position. */
        void add(double x, double y) {
            count++;
            first = count == 1 ? x : first;
            last = x;
            double dx = x - meanX;
            double dy = y - meanY;
            meanX += dx / count;
            meanY += dy / count;
            xx += dx * (x - meanX);
            xy += dx * (y - meanY);
            yy += dy * (y - meanY);
        }

        int count() {
            return count;
        }

        double mean() {
            return meanY;
        }

        /** Standard deviation of the positions. */
        double scatter() {
            return Math.sqrt(yy / (count - 1));
        }

        /** From the first photo to the last; NaN of fewer than three. */
        double drift() {
            return count < FEWEST_FOR_SLOPE ? Double.NaN : xy / xx * (last - first);
        }

        /** Standard error of the drift; NaN of fewer than three photos. */
        double driftStd() {
            return count < FEWEST_FOR_SLOPE ? Double.NaN
                    : (last - first) * Math.sqrt(Math.max(0, yy - xy / xx * xy) / (count - 2) / xx);
        }
    }

    /** The part of the report; empty where there are not two photos to compare. */
    String html() {
        StringBuilder rows = new StringBuilder();
        StringBuilder plots = new StringBuilder();
        positions.forEach((name, series) -> {
            if (series.lines[0].count() >= FEWEST) {
                add(name, series, rows, plots);
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

    private static void add(String name, Series series, StringBuilder rows, StringBuilder plots) {
        plots.append("<p>");
        for (int axis = 0; axis < AXES.length; axis++) {
            Line line = series.lines[axis];
            rows.append("<tr><td>").append(Html.escape(name)).append("</td>");
            cell(rows, "axis", AXES[axis]);
            cell(rows, "photos", String.valueOf(line.count()));
            cell(rows, "mean, mm", CheckText.fixed(line.mean(), 3));
            cell(rows, "scatter (std over photos), mm", CheckText.fixed(line.scatter(), 3));
            cell(rows, "stated std, mm", CheckText.fixed(Math.sqrt(series.squares[axis] / line.count()), 3));
            cell(rows, "drift from first to last, mm", CheckText.fixed(line.drift(), 3));
            cell(rows, "std of the drift, mm", CheckText.fixed(line.driftStd(), 3));
            rows.append("</tr>\n");
            plots.append(plot(name + ", " + AXES[axis] + ", mm", series, axis));
        }
        plots.append("</p>\n");
    }

    private static void cell(StringBuilder rows, String of, String value) {
        rows.append("<td data-of=\"").append(of).append("\">").append(value).append("</td>");
    }

    /** Means with one standard deviation to either side. */
    private static String plot(String title, Series series, int axis) {
        Line line = series.lines[axis];
        double mean = line.mean();
        double low = series.low[axis];
        double high = series.high[axis] > low ? series.high[axis] : low + 1;
        double first = line.first;
        double last = line.last;
        StringBuilder svg = new StringBuilder();
        svg.append(String.format(Decimal.POINT, "<svg class=\"plot\" role=\"img\" width=\"%d\" height=\"%d\" "
                + "viewBox=\"0 0 %d %d\"><title>%s</title>", WIDTH, HEIGHT, WIDTH, HEIGHT, Html.escape(title)));
        text(svg, LEFT, TOP - 6, "start", title);
        text(svg, LEFT - 4, TOP + 8, "end", CheckText.fixed(high, 1));
        text(svg, LEFT - 4, HEIGHT - BOTTOM, "end", CheckText.fixed(low, 1));
        text(svg, LEFT, HEIGHT - 4, "start", "photo " + Math.round(first));
        text(svg, WIDTH - RIGHT, HEIGHT - 4, "end", String.valueOf(Math.round(last)));
        line(svg, "axis", LEFT, TOP, LEFT, HEIGHT - BOTTOM);
        line(svg, "axis", LEFT, HEIGHT - BOTTOM, WIDTH - RIGHT, HEIGHT - BOTTOM);
        line(svg, "mean", LEFT, y(mean, low, high), WIDTH - RIGHT, y(mean, low, high));
        for (double[] p : series.marks) {
            double x = LEFT + 6 + (p[0] - first) / (last - first) * (WIDTH - LEFT - RIGHT - 12);
            double y = p[1 + axis];
            double std = p[4 + axis];
            line(svg, "mark", x, y(y - std, low, high), x, y(y + std, low, high));
            svg.append(String.format(Decimal.POINT, "<circle class=\"mark\" cx=\"%.1f\" cy=\"%.1f\" r=\"2.5\"/>", x,
                    y(y, low, high)));
        }
        return svg.append("</svg>\n").toString();
    }

    private static double y(double value, double low, double high) {
        return HEIGHT - BOTTOM - (value - low) / (high - low) * (HEIGHT - TOP - BOTTOM);
    }

    private static void line(StringBuilder svg, String kind, double x1, double y1, double x2, double y2) {
        svg.append(String.format(Decimal.POINT, "<line class=\"%s\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>",
                kind, x1, y1, x2, y2));
    }

    private static void text(StringBuilder svg, double x, double y, String anchor, String text) {
        svg.append(String.format(Decimal.POINT, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">", x, y, anchor))
                .append(Html.escape(text)).append("</text>");
    }
}
