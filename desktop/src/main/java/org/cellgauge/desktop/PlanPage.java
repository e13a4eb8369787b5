package org.cellgauge.desktop;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.cellgauge.cell.Area;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.plan.CellPlanner;
import org.cellgauge.plan.Forecast;
import org.cellgauge.plan.Layout;
import org.cellgauge.plan.ObjectPlaces;
import org.cellgauge.plan.Plan;
import org.cellgauge.plan.PlanOptions;
import org.cellgauge.plan.Proposal;
import org.cellgauge.statistics.Ellipse;

/**
 * A plan as a page of pictures: the layout from above and as the camera sees it, as it is and with each proposal, and
 * how large deviations are over the table.
 */
public final class PlanPage {
    private static final int WIDTH = 620;
    private static final int MAP_COLUMNS = 16;
    private static final int MAP_ROWS = 12;
    /** Room about what stands in the cell, as a share of its extent. */
    private static final double MARGIN = 0.15;
    /** Ellipses are drawn so large that the largest is this share of the picture. */
    private static final double LARGEST_ELLIPSE = 0.08;
    private static final double[] NICE = {1, 2, 5};

    private final Plan plan;
    private final PlanOptions options;
    private final StringBuilder out = new StringBuilder();
    private double xLow = Double.POSITIVE_INFINITY;
    private double xHigh = Double.NEGATIVE_INFINITY;
    private double yLow = Double.POSITIVE_INFINITY;
    private double yHigh = Double.NEGATIVE_INFINITY;
    private final double scale;
    /** How many times as large as they are ellipses are drawn. */
    private final double magnified;

    private PlanPage(Plan plan, PlanOptions options) {
        this.plan = plan;
        this.options = options;
        extend(plan.layout());
        plan.best().forEach(p -> extend(p.layout()));
        double room = MARGIN * Math.max(xHigh - xLow, yHigh - yLow) + 1;
        xLow -= room;
        yLow -= room;
        xHigh += room;
        yHigh += room;
        scale = WIDTH / Math.max(xHigh - xLow, yHigh - yLow);
        magnified = nice(LARGEST_ELLIPSE * WIDTH / scale / Math.max(1e-6, finiteWorst()));
    }

    /**
     * The page.
     *
     * @param plan what was found
     * @param options what it was reckoned with
     * @param text the plan in words
     * @param command that makes it again
     * @return HTML
     */
    public static String of(Plan plan, PlanOptions options, String text, String command) {
        return new PlanPage(plan, options).page(text, command);
    }

    private double finiteWorst() {
        double worst = plan.now().rows().stream().mapToDouble(Forecast.Row::worstStdMm).filter(Double::isFinite).max()
                .orElse(1);
        return worst * Math.sqrt(6);
    }

    private static double nice(double value) {
        double power = Math.pow(10, Math.floor(Math.log10(value)));
        double best = power;
        for (double n : NICE) {
            best = n * power <= value ? n * power : best;
        }
        return Math.max(1, best);
    }

    private void extend(Layout layout) {
        List<double[]> points = new ArrayList<>();
        layout.cell().references().forEach(r -> points.add(r.worldFromMarker().translationMm()));
        layout.worldFromObjects().values().forEach(all -> all.forEach(pose -> points.add(pose.translationMm())));
        points.add(layout.worldFromCameras().get(0).translationMm());
        for (double[] p : points) {
            xLow = Math.min(xLow, p[0]);
            xHigh = Math.max(xHigh, p[0]);
            yLow = Math.min(yLow, p[1]);
            yHigh = Math.max(yHigh, p[1]);
        }
    }

    private String page(String text, String command) {
        out.append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                + "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
                + "style-src 'unsafe-inline'\">\n"
                + "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
                + "<title>Plan</title>\n<style>").append(HtmlReport.STYLE)
                .append("svg.plan{max-width:100%;height:auto;border:1px solid var(--line)}"
                        + "svg.plan text{font:12px system-ui,sans-serif;fill:var(--ink)}"
                        + "svg.plan .reference{fill:none;stroke:var(--ink)}svg.plan .new{stroke:var(--pass);"
                        + "stroke-width:2}svg.plan .object{fill:none;stroke:var(--link)}"
                        + "svg.plan .now{fill:var(--fail);fill-opacity:.2;stroke:var(--fail)}"
                        + "svg.plan .then{fill:var(--pass);fill-opacity:.25;stroke:var(--pass)}"
                        + "svg.plan .camera{fill:none;stroke:var(--none);stroke-dasharray:4 3}"
                        + "figure{display:inline-block;margin:.5rem 1rem .5rem 0;vertical-align:top;max-width:100%}")
                .append("</style>\n</head>\n<body>\n<h1>Plan of ")
                .append(plan.layout().cell().objects().size()).append(" objects</h1>\n<pre>").append(Html.escape(text))
                .append("</pre>\n<p>Ellipses hold 95 % and are drawn ")
                .append(String.format(Locale.ROOT, "%.0f", magnified))
                .append(" times as large as they are: red as it is, green with the changes. Dashed: what the camera "
                        + "sees of the plane of the references.</p>\n<h2>As it is</h2>\n");
        pictures(plan.layout(), plan.now(), null);
        int number = 1;
        for (Proposal proposal : plan.best()) {
            out.append("<h2>").append(number++).append(". ").append(Html.escape(proposal.sentence())).append("</h2>\n");
            pictures(proposal.layout(), plan.now(), proposal.forecast());
        }
        map();
        out.append("<p>Made again by <code>").append(Html.escape(command)).append("</code></p>\n</body>\n</html>\n");
        return out.toString();
    }

    private void pictures(Layout layout, Forecast now, Forecast then) {
        out.append("<figure>\n<svg class=\"plan\" role=\"img\" aria-label=\"the cell from above\" width=\"")
                .append(px(scale * (xHigh - xLow))).append("\" height=\"").append(px(scale * (yHigh - yLow)))
                .append("\">\n");
        footprint(layout);
        for (Reference r : layout.cell().references()) {
            outline(r.worldFromMarker(), r.sizeMm(), isNew(r) ? "reference new" : "reference",
                    r.id() + height(r.worldFromMarker()));
        }
        for (ObjectMarker object : layout.cell().objects()) {
            List<RigidTransform> places = layout.worldFromObjects().get(object.id());
            if (places == null) {
                continue;
            }
            for (RigidTransform place : places.size() > 1 ? List.<RigidTransform>of() : places) {
                outline(place, object.sizeMm(), "object", object.id() + height(place));
            }
            ellipses(object, places, now, "now");
            if (then != null) {
                ellipses(object, places, then, "then");
            }
        }
        double[] camera = layout.worldFromCameras().get(0).translationMm();
        out.append("<circle class=\"reference\" cx=\"").append(px(x(camera[0]))).append("\" cy=\"")
                .append(px(y(camera[1]))).append("\" r=\"5\"/><text x=\"").append(px(x(camera[0]) + 8))
                .append("\" y=\"").append(px(y(camera[1]) + 4)).append("\">camera</text>\n</svg>\n"
                        + "<figcaption>from above</figcaption></figure>\n");
        fromCamera(layout);
    }

    private boolean isNew(Reference r) {
        return plan.layout().cell().references().stream().noneMatch(o -> o.id() == r.id()
                && Arrays.equals(o.worldFromMarker().translationMm(), r.worldFromMarker().translationMm())
                && o.sizeMm() == r.sizeMm()
                && Arrays.equals(o.worldFromMarker().rotation(), r.worldFromMarker().rotation()));
    }

    private static String height(RigidTransform pose) {
        double z = pose.translationMm()[2];
        return Math.abs(z) < 1 ? "" : String.format(Locale.ROOT, " (z %.0f)", z);
    }

    private double x(double worldX) {
        return scale * (worldX - xLow);
    }

    private double y(double worldY) {
        return scale * (yHigh - worldY);
    }

    private static String px(double value) {
        return String.format(Locale.ROOT, "%.1f", value);
    }

    private void outline(RigidTransform pose, double sizeMm, String style, String name) {
        double[] corners = MarkerGeometry.cornersMm(pose, sizeMm);
        StringBuilder points = new StringBuilder();
        for (int k = 0; k < 4; k++) {
            points.append(px(x(corners[3 * k]))).append(',').append(px(y(corners[3 * k + 1]))).append(' ');
        }
        polygon(style, points.toString());
        double[] at = pose.translationMm();
        out.append("<text x=\"").append(px(x(at[0]) + scale * sizeMm / 2 + 3)).append("\" y=\"")
                .append(px(y(at[1]) - 4)).append("\">").append(name).append("</text>\n");
    }

    private void polygon(String style, String points) {
        out.append("<polygon class=\"").append(style).append("\" points=\"").append(points.trim()).append("\"/>\n");
    }

    /** The part of the plane z = 0 that the camera sees. */
    private void footprint(Layout layout) {
        PinholeCamera camera = layout.cell().camera();
        RigidTransform pose = layout.worldFromCameras().get(0);
        double[] from = pose.translationMm();
        double[][] corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        StringBuilder points = new StringBuilder();
        for (double[] corner : corners) {
            double[] ray = new double[3];
            if (!camera.toRay(corner[0] * camera.widthPx(), corner[1] * camera.heightPx(), ray)) {
                return;
            }
            double[] to = pose.apply(ray);
            double along = -from[2] / (to[2] - from[2]);
            if (!(along > 0)) {
                return;
            }
            points.append(px(x(from[0] + along * (to[0] - from[0])))).append(',')
                    .append(px(y(from[1] + along * (to[1] - from[1])))).append(' ');
        }
        polygon("camera", points.toString());
    }

    private void ellipses(ObjectMarker object, List<RigidTransform> places, Forecast forecast, String style) {
        for (Forecast.Row row : forecast.rows()) {
            if (row.object() == object.id() && !row.grip() && Double.isFinite(row.worstStdMm())) {
                double[] at = places.size() == 1 ? places.get(0).translationMm() : middle(places);
                double both = row.xyCorrelation() * row.xStdMm() * row.yStdMm();
                Ellipse ellipse = Ellipse.ofNormal(new double[] {0, 0}, new double[][] {
                    {row.xStdMm() * row.xStdMm(), both}, {both, row.yStdMm() * row.yStdMm()}}, 0.95);
                out.append("<ellipse class=\"").append(style).append("\" rx=\"")
                        .append(px(scale * magnified * ellipse.semiMajor())).append("\" ry=\"")
                        .append(px(scale * magnified * ellipse.semiMinor())).append("\" transform=\"translate(")
                        .append(px(x(at[0]))).append(' ').append(px(y(at[1]))).append(") rotate(")
                        .append(px(-Math.toDegrees(ellipse.angleRad()))).append(")\"><title>object ")
                        .append(object.id()).append(String.format(Locale.ROOT, ": std %.3f, %.3f, %.3f mm",
                                row.xStdMm(), row.yStdMm(), row.zStdMm())).append("</title></ellipse>\n");
            }
        }
    }

    private static double[] middle(List<RigidTransform> places) {
        double[] middle = new double[3];
        for (RigidTransform place : places) {
            for (int i = 0; i < 3; i++) {
                middle[i] += place.translationMm()[i] / places.size();
            }
        }
        return middle;
    }

    private void fromCamera(Layout layout) {
        PinholeCamera camera = layout.cell().camera();
        RigidTransform cameraFromWorld = layout.worldFromCameras().get(0).inverse();
        double shrunk = (double) WIDTH / camera.widthPx();
        out.append("<figure>\n<svg class=\"plan\" role=\"img\" aria-label=\"the cell as the camera sees it\" width=\"")
                .append(WIDTH).append("\" height=\"").append(px(shrunk * camera.heightPx())).append("\">\n");
        for (Reference r : layout.cell().references()) {
            inImage(camera, cameraFromWorld.compose(r.worldFromMarker()), r.sizeMm(),
                    isNew(r) ? "reference new" : "reference", r.id(), shrunk);
        }
        for (ObjectMarker object : layout.cell().objects()) {
            List<RigidTransform> places = layout.worldFromObjects().getOrDefault(object.id(), List.of());
            if (places.size() == 1) {
                inImage(camera, cameraFromWorld.compose(places.get(0)), object.sizeMm(), "object", object.id(), shrunk);
            }
        }
        out.append("</svg>\n<figcaption>from the camera</figcaption></figure>\n");
    }

    private void inImage(PinholeCamera camera, RigidTransform cameraFromMarker, double sizeMm, String style, int id,
            double shrunk) {
        double[] px = MarkerGeometry.seenPx(camera, cameraFromMarker, sizeMm);
        if (px == null) {
            return;
        }
        StringBuilder points = new StringBuilder();
        for (int k = 0; k < 4; k++) {
            points.append(px(shrunk * px[2 * k])).append(',').append(px(shrunk * px[2 * k + 1])).append(' ');
        }
        polygon(style, points.toString());
        out.append("<text x=\"").append(px(shrunk * px[2] + 3)).append("\" y=\"").append(px(shrunk * px[3] - 3))
                .append("\">").append(id).append("</text>\n");
    }

    // ---- deviations over the table

    /** The largest deviation of the first object that may lie in more places than one, or else of the first. */
    private void map() {
        Layout layout = plan.layout();
        ObjectMarker object = layout.cell().objects().stream()
                .filter(o -> layout.worldFromObjects().getOrDefault(o.id(), List.of()).size() > 1).findFirst()
                .orElse(layout.cell().objects().get(0));
        Area area = new Area(Math.max(xLow, low(0)), Math.max(yLow, low(1)), Math.min(xHigh, high(0)),
                Math.min(yHigh, high(1)));
        List<RigidTransform> places = ObjectPlaces.in(layout.cell(), area, MAP_COLUMNS, MAP_ROWS);
        double[] worst = new double[places.size()];
        for (int i = 0; i < worst.length; i++) {
            Map<Integer, List<RigidTransform>> only = new LinkedHashMap<>();
            only.put(object.id(), List.of(places.get(i)));
            worst[i] = CellPlanner.forecast(new Layout(layout.cell(), layout.worldFromCameras(), only), options)
                    .worstStdMm();
        }
        double least = Arrays.stream(worst).filter(Double::isFinite).min().orElse(0);
        double most = Arrays.stream(worst).filter(Double::isFinite).max().orElse(1);
        double w = (double) WIDTH / MAP_COLUMNS;
        double h = WIDTH * (area.yHighMm() - area.yLowMm()) / (area.xHighMm() - area.xLowMm()) / MAP_ROWS;
        out.append("<h2>Deviation of object ").append(object.id()).append(" over the table, mm</h2>\n<p>Largest "
                + "standard deviation along any axis, the object lying flat there, as it is; the worst pose of the camera "
                + "counts. Empty where the camera does not see it. From (")
                .append(String.format(Locale.ROOT, "%.0f, %.0f) to (%.0f, %.0f", area.xLowMm(), area.yLowMm(),
                        area.xHighMm(), area.yHighMm()))
                .append(") mm.</p>\n<figure><svg class=\"plan\" role=\"img\" aria-label=\"deviations over the table\" "
                        + "width=\"").append(WIDTH).append("\" height=\"").append(px(h * MAP_ROWS)).append("\">\n");
        for (int i = 0; i < worst.length; i++) {
            if (Double.isFinite(worst[i])) {
                double share = most > least ? (worst[i] - least) / (most - least) : 0;
                double left = w * (i / MAP_ROWS);
                double top = h * (MAP_ROWS - 1 - i % MAP_ROWS);
                out.append("<rect x=\"").append(px(left)).append("\" y=\"").append(px(top)).append("\" width=\"")
                        .append(px(w)).append("\" height=\"").append(px(h)).append("\" style=\"fill:")
                        .append(String.format(Locale.ROOT, "hsl(%.0f 70%% 75%%)", 130 * (1 - share)))
                        .append("\"/><text style=\"fill:#111\" x=\"").append(px(left + 3)).append("\" y=\"")
                        .append(px(top + h / 2 + 4)).append("\">")
                        .append(String.format(Locale.ROOT, worst[i] < 10 ? "%.2f" : "%.1f", worst[i]))
                        .append("</text>\n");
            }
        }
        out.append("</svg></figure>\n");
    }

    private double low(int axis) {
        return extreme(axis, false);
    }

    private double high(int axis) {
        return extreme(axis, true);
    }

    /** Of what objects may lie in, and of the references. */
    private double extreme(int axis, boolean largest) {
        List<double[]> points = new ArrayList<>();
        plan.layout().cell().references().forEach(r -> points.add(r.worldFromMarker().translationMm()));
        plan.layout().worldFromObjects().values().forEach(all -> all.forEach(p -> points.add(p.translationMm())));
        double extreme = points.get(0)[axis];
        for (double[] p : points) {
            extreme = largest ? Math.max(extreme, p[axis]) : Math.min(extreme, p[axis]);
        }
        return extreme;
    }
}
