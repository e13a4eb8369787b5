package org.cellgauge.desktop;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.survey.Drift;
import org.cellgauge.survey.Epoch;

/**
 * Control charts: how far everything stands from where an earlier survey had it, photo by photo, in units of chance
 * (Hotelling's T, D. C. Montgomery, "Introduction to statistical quality control", 8th ed., section 11.3).
 */
final class DriftChart {
    private static final int WIDTH = 720;
    private static final int HEIGHT = 170;
    private static final int LEFT = 60;
    private static final int RIGHT = 20;
    private static final int TOP = 10;
    private static final int BOTTOM = 30;
    private static final double RADIUS = 3;
    private static final int MOST_LABELS = 12;
    /** Points beyond so many times the limit stand at the top, with their figure. */
    private static final double FARTHEST = 3;

    private DriftChart() {
    }

    static void add(Drift drift, StringBuilder out) {
        double limit = Math.sqrt(drift.limit());
        out.append("<h2>Control charts</h2>\n<p>Distance of each thing from where the earlier survey had it, by every "
                + "photo alone, in units of its deviations there (the root of a chi-square of six degrees of freedom, "
                + "about 2.4 where nothing has moved). Above the line, ").append(CheckText.fixed(limit, 1))
                .append(", in one photo of all charts together once in 400 times by chance.</p>\n");
        List<Epoch.Body> bodies = new ArrayList<>();
        drift.photos().forEach(p -> p.bodies().forEach(d -> {
            if (!bodies.contains(d.body())) {
                bodies.add(d.body());
            }
        }));
        for (Epoch.Body body : bodies) {
            chart(drift, body, limit, out);
        }
    }

    private static void chart(Drift drift, Epoch.Body body, double limit, StringBuilder out) {
        int count = drift.photos().size();
        double[] distance = new double[count];
        double most = limit;
        for (int k = 0; k < count; k++) {
            distance[k] = drift.photos().get(k).bodies().stream().filter(d -> d.body().isSameAs(body))
                    .mapToDouble(d -> Math.sqrt(d.chiSquare())).findFirst().orElse(Double.NaN);
            most = Double.isNaN(distance[k]) ? most : Math.max(most, distance[k]);
        }
        most = Math.min(1.1 * most, FARTHEST * limit);
        String name = Html.escape(body.words());
        out.append("<h3>").append(name).append("</h3>\n<svg class=\"plot\" viewBox=\"0 0 ").append(WIDTH).append(' ')
                .append(HEIGHT).append("\" role=\"img\" aria-label=\"").append(name).append(" by photo\">\n");
        line(out, y(0, most), "0", "0.5");
        line(out, y(limit, most), CheckText.fixed(limit, 1), "1.5");
        for (int k = 0; k < count; k++) {
            double x = LEFT + (WIDTH - LEFT - RIGHT) * (k + 0.5) / count;
            if (!Double.isNaN(distance[k])) {
                boolean above = distance[k] > limit;
                double shown = Math.min(distance[k], most);
                if (distance[k] > most) {
                    out.append("<text x=\"").append(CheckText.fixed(x + 3 * RADIUS, 1)).append("\" y=\"")
                            .append(CheckText.fixed(y(shown, most) + 4, 1))
                            .append("\" fill=\"currentColor\" font-size=\"11\">")
                            .append(CheckText.fixed(distance[k], 0)).append("</text>\n");
                }
                out.append("<circle cx=\"").append(CheckText.fixed(x, 1)).append("\" cy=\"")
                        .append(CheckText.fixed(y(shown, most), 1)).append("\" r=\"")
                        .append(CheckText.plain(above ? 2 * RADIUS : RADIUS)).append("\" fill=\"")
                        .append(above ? "none" : "currentColor").append("\" stroke=\"currentColor\" stroke-width=\"2\">"
                                + "<title>")
                        .append(Html.escape(drift.photos().get(k).photo())).append(": ")
                        .append(CheckText.fixed(distance[k], 1)).append("</title></circle>\n");
            }
            if (count <= MOST_LABELS) {
                out.append("<text x=\"").append(CheckText.fixed(x, 1)).append("\" y=\"").append(HEIGHT - 8)
                        .append("\" fill=\"currentColor\" font-size=\"11\" text-anchor=\"middle\">")
                        .append(Html.escape(drift.photos().get(k).photo())).append("</text>\n");
            }
        }
        if (count > MOST_LABELS) {
            out.append("<text x=\"").append(LEFT).append("\" y=\"").append(HEIGHT - 8)
                    .append("\" fill=\"currentColor\" font-size=\"12\">")
                    .append(Html.escape(drift.photos().get(0).photo()))
                    .append(" to ").append(Html.escape(drift.photos().get(count - 1).photo())).append("</text>\n");
        }
        out.append("</svg>\n");
    }

    private static void line(StringBuilder out, double at, String label, String width) {
        String y = CheckText.fixed(at, 1);
        out.append("<path d=\"M").append(LEFT).append(' ').append(y).append('H').append(WIDTH)
                .append("\" stroke=\"currentColor\" stroke-width=\"").append(width).append("\" fill=\"none\"/>")
                .append("<text x=\"2\" y=\"").append(y).append("\" fill=\"currentColor\" font-size=\"12\">")
                .append(label).append("</text>\n");
    }

    private static double y(double distance, double most) {
        return TOP + (HEIGHT - TOP - BOTTOM) * (1 - distance / most);
    }
}
