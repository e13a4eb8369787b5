package org.cellgauge.internal.overlay;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.check.Verdict;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.output.ModeView;
import org.cellgauge.output.PoseView;
import org.cellgauge.output.ReferenceFitView;
import org.cellgauge.output.ReferencesView;
import org.cellgauge.output.ResultRow;
import org.cellgauge.output.ResultView;
import org.cellgauge.statistics.Ellipse;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.jspecify.annotations.Nullable;

/**
 * Draws one overlay: lines first, then the texts where the lines leave room. Lengths named {@code …U} are in units of
 * {@link Overlay#unitPx(int, int)}. All positions are those of the upright image: markers and ellipses are turned on
 * entry, points of the world where they are projected.
 */
final class CellDrawing {
    /** How far the figures have come. */
    enum Stage {
        /** Not confirmed by chains, or these still run. */
        PRELIMINARY,
        /** The chains ended without converging. */
        NOT_CONVERGED,
        /** References contradict each other: there is no figure. */
        CONTRADICTED,
        /** The chains have converged. */
        FINAL
    }

    private static final double HEADLINE_CAP_U = 13;
    private static final double REASON_CAP_U = 8.5;
    private static final double LABEL_CAP_U = 8.5;
    private static final double SMALL_CAP_U = 7.2;
    private static final double REGULAR = 0.135;
    private static final double BOLD = 0.17;
    private static final double OUTLINE_U = 1.6;
    /** Wider, for the expected outline to lie upon. */
    private static final double REFERENCE_U = 2.4;
    private static final double THIN_U = 0.8;
    private static final double GRID_U = 0.7;
    private static final double AXIS_U = 2;
    /** Semi-major axis from which on an ellipse is seen well at its true size. */
    private static final double VISIBLE_U = 6;
    /** Largest ellipse, as drawn where magnified: semi-major axis in sides of the marker. */
    private static final double ELLIPSE_SIDES = 1;
    private static final double LARGEST_MAGNIFICATION = 1000;
    private static final double GRID_LINES = 8;
    private static final int OUTLINE_PIECES = 8;

    private final Cell cell;
    private final Detections detections;
    private final @Nullable ResultView results;
    /** Rows of the objects that have figures. */
    private final List<ResultRow> seen;
    private final @Nullable ReferencesView references;
    private final Stage stage;
    private final ImageOrientation orientation;
    private final boolean panels;
    private final LabelWords words;
    private final LegendWords legend;
    private final int photoWidth;
    private final int photoHeight;
    private final double width;
    private final double height;
    private final double unit;
    /** The unit of letters beside the markers, and of what goes with them: larger where the image is shown small. */
    private final double letter;
    private final List<Shape> shapes = new ArrayList<>();
    private final LabelPlacer placer;
    private @Nullable WorldView view;
    private double gridMm = Double.NaN;
    private boolean axesVisible;
    private double magnification = 1;
    /** Where leaders go among the shapes: below the panels, so that they cross no text. */
    private int belowPanels;

    /**
     * A drawing.
     *
     * @param cell the cell
     * @param photo the markers of the photo
     * @param results poses with what is stated of them, judged where a check is finished; null where there are none
     * @param stage how far the figures have come
     * @param style how it is shown
     */
    CellDrawing(Cell cell, Detections photo, @Nullable ResultView results, Stage stage, OverlayStyle style) {
        this.cell = cell;
        this.words = style.labels();
        this.legend = style.legend();
        this.orientation = style.orientation();
        this.panels = style.panels();
        this.photoWidth = photo.widthPx();
        this.photoHeight = photo.heightPx();
        this.detections = upright(photo, orientation);
        this.seen = new ArrayList<>();
        this.results = results;
        if (results != null) {
            results.objects().stream().filter(ResultRow::seen).forEach(seen::add);
        }
        this.references = results == null ? null : results.references();
        this.stage = stage;
        this.width = detections.widthPx();
        this.height = detections.heightPx();
        this.unit = Overlay.unitPx(detections.widthPx(), detections.heightPx());
        this.letter = unit * style.letterScale();
        this.placer = new LabelPlacer(width, height, unit);
    }

    /** How high capital letters of labels are in an image, px, where nothing else is wanted. */
    static double labelCapPx(int widthPx, int heightPx) {
        return LABEL_CAP_U * Overlay.unitPx(widthPx, heightPx);
    }

    private static Detections upright(Detections photo, ImageOrientation orientation) {
        if (orientation.isIdentity()) {
            return photo;
        }
        int w = photo.widthPx();
        int h = photo.heightPx();
        List<MarkerObservation> markers = new ArrayList<>();
        for (MarkerObservation m : photo.markers()) {
            markers.add(new MarkerObservation(m.id(), orientation.map(m.cornersPx(), w, h)));
        }
        return new Detections(photo.imageName(), orientation.uprightWidthPx(w, h), orientation.uprightHeightPx(w, h),
                markers);
    }

    private @Nullable Ellipse upright(@Nullable Ellipse ellipse) {
        return orientation.map(ellipse, photoWidth, photoHeight);
    }

    Overlay draw(Status status, String headline, String reason) {
        PoseView pose = results == null ? null : results.camera().pose();
        if (pose != null && finite(pose.mean())) {
            view = new WorldView(camera(), pose.transform(), orientation);
            grid();
            axes();
        }
        outlines();
        if (view != null) {
            expectedReferences();
            magnification = magnification();
            for (ResultRow object : seen) {
                object(object);
            }
        }
        belowPanels = shapes.size();
        if (panels) {
            panels(status, headline, reason);
        }
        labels();
        return new Overlay(detections.widthPx(), detections.heightPx(), status, magnification, gridMm, shapes);
    }

    /** The world as the camera sees it; asked for only where it is known where the camera stands. */
    private WorldView view() {
        return Objects.requireNonNull(view, "nothing of the world is drawn without a camera pose");
    }

    private ResultView results() {
        return Objects.requireNonNull(results, "nothing is drawn of figures where there are none");
    }

    /** What an object that was seen has. */
    private static <T> T figure(@Nullable T ofSeen) {
        return Objects.requireNonNull(ofSeen, "an object that was seen has figures");
    }

    private PinholeCamera camera() {
        PinholeCamera camera = cell.camera();
        if (results().intrinsics().isEmpty()) {
            return camera;
        }
        double[] intrinsics = camera.intrinsics();
        for (ResultView.Intrinsic unknown : results().intrinsics()) {
            int index = camera.lens().parameterNames().indexOf(unknown.name());
            double value = unknown.mean();
            // a wrong estimate is to be drawn as well, as long as it is one of a camera
            if (Double.isFinite(value) && (value > 0 || index != PinholeCamera.FX && index != PinholeCamera.FY)) {
                intrinsics[index] = value;
            }
        }
        return camera.withIntrinsics(intrinsics);
    }

    // ---- world

    private void grid() {
        double[] box = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY,
            Double.NEGATIVE_INFINITY};
        double size = 0;
        for (Reference r : cell.references()) {
            include(box, r.worldFromMarker().translationMm());
            size = Math.max(size, r.sizeMm());
        }
        double reach = Math.max(Math.max(box[2] - box[0], box[3] - box[1]), 4 * size);
        double[] limits = {box[0] - 2 * reach, box[1] - 2 * reach, box[2] + 2 * reach, box[3] + 2 * reach};
        for (ResultRow o : seen) {
            double[] p = figure(o.mean());
            // a pose far off is a wrong one: the grid is not to follow it
            if (p[0] > limits[0] && p[1] > limits[1] && p[0] < limits[2] && p[1] < limits[3]) {
                include(box, p);
            }
        }
        gridMm = RoundNumbers.atLeast(Math.max(Math.max(box[2] - box[0], box[3] - box[1]), 4 * size) / GRID_LINES);
        double left = gridMm * Math.floor((box[0] - size) / gridMm);
        double right = gridMm * Math.ceil((box[2] + size) / gridMm);
        double low = gridMm * Math.floor((box[1] - size) / gridMm);
        double high = gridMm * Math.ceil((box[3] + size) / gridMm);
        for (int i = 0; i <= Math.round((right - left) / gridMm); i++) {
            double x = left + i * gridMm;
            worldLine(Role.WORLD_GRID, GRID_U, new double[] {x, low, 0}, new double[] {x, high, 0});
        }
        for (int i = 0; i <= Math.round((high - low) / gridMm); i++) {
            double y = low + i * gridMm;
            worldLine(Role.WORLD_GRID, GRID_U, new double[] {left, y, 0}, new double[] {right, y, 0});
        }
    }

    private static void include(double[] box, double[] p) {
        box[0] = Math.min(box[0], p[0]);
        box[1] = Math.min(box[1], p[1]);
        box[2] = Math.max(box[2], p[0]);
        box[3] = Math.max(box[3], p[1]);
    }

    private void worldLine(Role role, double strokeU, double[] fromMm, double[] toMm) {
        for (double[] part : view().line(fromMm, toMm)) {
            shapes.add(Polyline.ofOwn(role, Status.NEUTRAL, strokeU * unit, false, part));
        }
    }

    private void axes() {
        Role[] roles = {Role.WORLD_AXIS_X, Role.WORLD_AXIS_Y, Role.WORLD_AXIS_Z};
        double[] origin = view().project(new double[3]);
        if (origin == null || !view().inImage(origin)) {
            return;
        }
        axesVisible = true;
        // z last: where it points at the camera it lies over the other two
        for (int axis = 0; axis < 3; axis++) {
            double[] tip = new double[3];
            tip[axis] = gridMm;
            worldLine(roles[axis], AXIS_U, new double[3], tip);
            for (double[] part : view().line(new double[3], tip)) {
                placer.avoid(Box.around(Collections.singletonList(part)).grown(2 * unit));
            }
            double[] end = view().project(tip);
            if (end == null || !view().inImage(end)) {
                continue;
            }
            double length = Math.hypot(end[0] - origin[0], end[1] - origin[1]);
            if (!(length > 4 * unit)) {
                continue;
            }
            double du = (end[0] - origin[0]) / length;
            double dv = (end[1] - origin[1]) / length;
            double head = Math.min(7 * unit, length / 2);
            line(roles[axis], Status.NEUTRAL, AXIS_U, false, end[0] - head * (du + 0.5 * dv),
                    end[1] - head * (dv - 0.5 * du), end[0], end[1], end[0] - head * (du - 0.5 * dv),
                    end[1] - head * (dv + 0.5 * du));
            String name = "xyz".substring(axis, axis + 1);
            double cap = LABEL_CAP_U * letter;
            double half = StrokeFont.widthInCapHeights(name) * cap / 2;
            TextShape axisName = new TextShape(roles[axis], Status.NEUTRAL, BOLD, end[0] + 1.1 * cap * du - half,
                    end[1] + 1.1 * cap * dv + cap / 3, cap, name);
            if (placer.area().contains(axisName.bounds())) {
                shapes.add(axisName);
                placer.keepOff(axisName.bounds());
            }
        }
    }

    // ---- markers

    private void expectedReferences() {
        for (Reference r : cell.references()) {
            boolean seen = detections.find(r.id()) != null;
            outline(Role.REFERENCE_EXPECTED, seen ? Status.NEUTRAL : Status.FAIL, THIN_U, !seen, r.worldFromMarker(),
                    r.sizeMm());
        }
        List<ModeView> modes = results().camera().modes();
        for (int k = 1; results().camera().ambiguous() && k < modes.size(); k++) {
            WorldView mean = view();
            view = new WorldView(camera(), modes.get(k).pose().transform(), orientation);
            for (Reference r : cell.references()) {
                outline(Role.REFERENCE_EXPECTED, Status.AMBIGUOUS, THIN_U, true, r.worldFromMarker(), r.sizeMm());
            }
            view = mean;
        }
    }

    private void outline(Role role, Status status, double strokeU, boolean dashed, RigidTransform worldFromMarker,
            double sizeMm) {
        double[] c = MarkerGeometry.cornersMm(worldFromMarker, sizeMm);
        double[][] corners = new double[MarkerGeometry.CORNERS + 1][];
        for (int k = 0; k < corners.length; k++) {
            int from = 3 * (k % MarkerGeometry.CORNERS);
            corners[k] = Arrays.copyOfRange(c, from, from + 3);
        }
        for (double[] part : view().path(OUTLINE_PIECES, corners)) {
            shapes.add(Polyline.ofOwn(role, status, strokeU * unit, dashed, part));
        }
    }

    private void outlines() {
        for (MarkerObservation m : detections.markers()) {
            double[] p = m.cornersPx();
            Role role = Role.FOREIGN_OUTLINE;
            Status status = Status.NEUTRAL;
            if (isReference(m.id())) {
                role = Role.REFERENCE_OUTLINE;
                status = leftOut(m.id()) || misplaced(m.id()) ? Status.FAIL : Status.NEUTRAL;
            } else if (objectMarker(m.id()) != null) {
                role = Role.OBJECT_OUTLINE;
                status = status(m.id());
            }
            boolean foreign = role == Role.FOREIGN_OUTLINE;
            double strokeU = foreign ? THIN_U : role == Role.REFERENCE_OUTLINE ? REFERENCE_U : OUTLINE_U;
            line(role, status, strokeU, foreign, p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[0], p[1]);
            placer.keepOff(boxOf(m).grown(4 * unit));
        }
    }

    private boolean inImage(Box box) {
        return box.right() >= 0 && box.bottom() >= 0 && box.left() <= width && box.top() <= height;
    }

    private static Box boxOf(MarkerObservation m) {
        return Box.around(Collections.singletonList(m.cornersPx()));
    }

    private boolean isReference(int id) {
        for (Reference r : cell.references()) {
            if (r.id() == id) {
                return true;
            }
        }
        return false;
    }

    private boolean leftOut(int id) {
        ReferenceFitView fit = references == null ? null : references.fit(id);
        return fit != null && !fit.used();
    }

    private boolean misplaced(int id) {
        ReferenceFitView fit = references == null ? null : references.fit(id);
        return fit != null && fit.misplaced();
    }

    private @Nullable ObjectMarker objectMarker(int id) {
        for (ObjectMarker o : cell.objects()) {
            if (o.id() == id) {
                return o;
            }
        }
        return null;
    }

    /** How an object was judged; a preliminary figure is not, but two poses are two poses from the start. */
    private Status status(int id) {
        ResultRow object = row(id);
        if (object == null) {
            return Status.NEUTRAL;
        }
        if (stage == Stage.NOT_CONVERGED || stage == Stage.CONTRADICTED) {
            return Status.NOT_CONVERGED;
        }
        if (object.ambiguous() || results().camera().ambiguous()) {
            return Status.AMBIGUOUS;
        }
        if (stage == Stage.PRELIMINARY || !cell.targetStdMm().isPresent()) {
            return Status.NEUTRAL;
        }
        ResultRow grip = results().grip(id);
        boolean met = object.verdict() == Verdict.PASS && (grip == null || grip.verdict() == Verdict.PASS);
        return met ? Status.PASS : Status.FAIL;
    }

    /** The row of an object that has figures; null of any other. */
    private @Nullable ResultRow row(int id) {
        ResultRow row = results == null ? null : results.object(id);
        return row == null || !row.seen() ? null : row;
    }

    private double magnification() {
        double largest = 0;
        double side = Double.POSITIVE_INFINITY;
        for (ResultRow o : seen) {
            int id = o.id().getAsInt();
            ResultRow grip = results().grip(id);
            for (Ellipse e : new Ellipse[] {o.ellipse95Px(), grip == null ? null : grip.ellipse95Px()}) {
                largest = e == null ? largest : Math.max(largest, e.semiMajor());
            }
            Box box = boxOf(figure(detections.find(id)));
            side = Math.min(side, Math.max(box.width(), box.height()));
        }
        if (!(largest > 0) || largest > VISIBLE_U * unit) {
            return 1;
        }
        return Math.min(LARGEST_MAGNIFICATION, Math.max(1, RoundNumbers.atMost(ELLIPSE_SIDES * side / largest)));
    }

    private void object(ResultRow object) {
        int id = object.id().getAsInt();
        RigidTransform pose = figure(object.pose()).transform();
        Status status = status(id);
        boolean unsure = stage != Stage.FINAL || status == Status.AMBIGUOUS;
        double size = figure(objectMarker(id)).sizeMm();
        if (stage == Stage.CONTRADICTED) {
            return;
        }
        if (object.ambiguous()) {
            for (int k = object.modes().size() - 1; k >= 0; k--) {
                mode(object.modes().get(k), k > 0, size);
            }
        } else if (stage != Stage.NOT_CONVERGED) {
            Role[] roles = {Role.OBJECT_AXIS_X, Role.OBJECT_AXIS_Y, Role.OBJECT_AXIS_Z};
            for (int axis = 0; axis < 3; axis++) {
                double[] tip = new double[3];
                tip[axis] = 0.75 * size;
                worldLine(roles[axis], THIN_U + 0.4, pose.translationMm(), pose.apply(tip));
            }
        }
        ellipse(Role.OBJECT_ELLIPSE, status, unsure, upright(object.ellipse95Px()));
        ResultRow gripRow = results().grip(id);
        if (gripRow != null) {
            double[] gripMm = figure(gripRow.mean());
            double[] grip = view().project(gripMm);
            for (double[] part : view().line(pose.translationMm(), gripMm)) {
                shapes.add(Polyline.ofOwn(Role.GRIP_LINE, status, 1.2 * unit, unsure, part));
                placer.avoid(Box.around(Collections.singletonList(part)).grown(2 * unit));
            }
            ellipse(Role.GRIP_ELLIPSE, status, unsure, upright(gripRow.ellipse95Px()));
            if (grip != null && view().inImage(grip)) {
                MarkShape cross = new MarkShape(Role.GRIP_POINT, status, 1.6 * unit, Mark.PLUS, grip[0], grip[1],
                        6 * unit);
                shapes.add(cross);
                placer.keepOff(cross.bounds());
            }
        }
    }

    /** Outline and normal of one of two poses: the outlines nearly agree, the normals show how the two differ. */
    private void mode(ModeView mode, boolean second, double sizeMm) {
        RigidTransform pose = mode.pose().transform();
        outline(Role.OBJECT_MODE, Status.AMBIGUOUS, THIN_U + 0.3, second, pose, sizeMm);
        double[] tip = pose.apply(0, 0, 3 * sizeMm);
        for (double[] part : view().line(pose.translationMm(), tip)) {
            shapes.add(Polyline.ofOwn(Role.OBJECT_MODE, Status.AMBIGUOUS, (THIN_U + 0.6) * unit, second, part));
            placer.avoid(Box.around(Collections.singletonList(part)).grown(2 * unit));
        }
    }

    private void ellipse(Role role, Status status, boolean dashed, @Nullable Ellipse e) {
        if (e == null || e.semiMajor() * magnification > 2 * (width + height)) {
            return;
        }
        EllipseShape drawn = new EllipseShape(role, status, 1.4 * unit, dashed, new Ellipse(e.centreX(), e.centreY(),
                e.semiMajor() * magnification, e.semiMinor() * magnification, e.angleRad()));
        if (!inImage(drawn.bounds())) {
            return;
        }
        shapes.add(drawn);
        placer.avoid(drawn.bounds());
    }

    private void line(Role role, Status status, double strokeU, boolean dashed, double... pointsPx) {
        for (double[] part : WorldView.clip(pointsPx, width, height)) {
            shapes.add(Polyline.ofOwn(role, status, strokeU * unit, dashed, part));
        }
    }

    private static boolean finite(double[] values) {
        for (double v : values) {
            if (!Double.isFinite(v)) {
                return false;
            }
        }
        return true;
    }

    // ---- panels

    /** The banner at one edge, the legend at the other: whichever way hides less of the markers. */
    private void panels(Status status, String headline, String reason) {
        Panel banner = banner(status, headline, reason);
        Panel legend = legend();
        double margin = 4 * unit;
        Box ofBanner = banner.box();
        Box ofLegend = legend.box();
        Box top = ofBanner.moved(margin, margin);
        Box bottom = ofBanner.moved(margin, height - margin - ofBanner.height());
        Box legendTop = ofLegend.moved(margin, margin);
        Box legendBottom = ofLegend.moved(margin, height - margin - ofLegend.height());
        boolean swap = hidden(top) + hidden(legendBottom) > hidden(bottom) + hidden(legendTop);
        banner.add(swap ? bottom : top);
        legend.add(swap ? legendTop : legendBottom);
    }

    private double hidden(Box panel) {
        double area = 0;
        for (MarkerObservation m : detections.markers()) {
            area += panel.overlap(boxOf(m).grown(4 * unit));
        }
        return area;
    }

    /** A panel with its content, laid out from (0, 0) and moved to its place at the end. */
    private final class Panel {
        private final Role role;
        private final Status status;
        private final List<Content> contents = new ArrayList<>();
        private @Nullable Box box;

        Panel(Role role, Status status) {
            this.role = role;
            this.status = status;
        }

        Box box() {
            return Objects.requireNonNull(box, "a panel is laid out before it has a place");
        }

        void add(Box place) {
            shapes.add(new PanelShape(role, status, 1.2 * unit, place));
            for (Content c : contents) {
                shapes.add(c.at(place.left(), place.top()));
            }
            placer.keepOff(place);
        }
    }

    /** A shape that knows no place yet. */
    private interface Content {
        Shape at(double left, double top);
    }

    private Content text(Role role, Status status, double weight, double left, double baseline, double cap,
            String text) {
        return (u, v) -> new TextShape(role, status, weight, u + left, v + baseline, cap, text);
    }

    private Content mark(Role role, Status status, Mark mark, double centreU, double centreV, double radius) {
        return (u, v) -> new MarkShape(role, status, Math.max(1.2 * unit, radius / 4), mark, u + centreU, v + centreV,
                radius);
    }

    private Panel banner(Status status, String headline, String reason) {
        Panel panel = new Panel(Role.BANNER, status);
        double pad = 6 * unit;
        double inner = Math.max(0, width - 8 * unit - 2 * pad);
        double cap = HEADLINE_CAP_U * unit;
        double indent = 0;
        double y = pad + StrokeFont.ASCENT * cap;
        Mark mark = Mark.of(status);
        if (mark != null) {
            double radius = 0.6 * cap;
            panel.contents.add(mark(Role.BANNER, status, mark, pad + radius, y - cap / 2, radius));
            indent = 2 * radius + 0.6 * cap;
        }
        double widest = 0;
        for (String line : StrokeFont.wrap(headline, Math.max(1, (inner - indent) / cap))) {
            panel.contents.add(text(Role.BANNER, status, BOLD, pad + indent, y, cap, line));
            widest = Math.max(widest, indent + StrokeFont.widthInCapHeights(line) * cap);
            y += StrokeFont.LINE_SPACING * cap;
        }
        y += (StrokeFont.ASCENT - StrokeFont.LINE_SPACING) * cap - cap / 2 + StrokeFont.DESCENT * cap;
        cap = REASON_CAP_U * unit;
        y += cap;
        for (String line : StrokeFont.wrap(reason, Math.max(1, inner / cap))) {
            panel.contents.add(text(Role.BANNER, Status.NEUTRAL, REGULAR, pad, y, cap, line));
            widest = Math.max(widest, StrokeFont.widthInCapHeights(line) * cap);
            y += StrokeFont.LINE_SPACING * cap;
        }
        double bottom = y - StrokeFont.LINE_SPACING * cap + StrokeFont.DESCENT * cap + pad;
        panel.box = new Box(0, 0, Math.min(widest, inner) + 2 * pad, bottom);
        return panel;
    }

    private Panel legend() {
        Panel panel = new Panel(Role.LEGEND, Status.NEUTRAL);
        double pad = 5 * unit;
        double cap = SMALL_CAP_U * unit;
        double inner = Math.max(0, width - 8 * unit - 2 * pad);
        double sample = 1.8 * cap;
        double u = pad;
        double baseline = pad + StrokeFont.ASCENT * cap;
        double widest = 0;
        for (Entry entry : entries()) {
            double textWidth = StrokeFont.widthInCapHeights(entry.text) * cap;
            double needed = (entry.role == null ? 0 : sample + 0.6 * cap) + textWidth;
            if (u > pad && u + needed > pad + inner) {
                u = pad;
                baseline += StrokeFont.LINE_SPACING * cap;
            }
            if (entry.role != null) {
                panel.contents.add(sample(entry.role, entry, u, baseline - cap / 2, sample));
                u += sample + 0.6 * cap;
            }
            panel.contents.add(text(Role.LEGEND, Status.NEUTRAL, REGULAR, u, baseline, cap, entry.text));
            u += textWidth;
            widest = Math.max(widest, u - pad);
            u += 1.8 * cap;
        }
        panel.box = new Box(0, 0, Math.min(widest, inner) + 2 * pad, baseline + StrokeFont.DESCENT * cap + pad);
        return panel;
    }

    /** One explanation: what a shape means. */
    private static final class Entry {
        private final @Nullable Role role;
        private final Status status;
        private final boolean dashed;
        private final String text;

        Entry(@Nullable Role role, Status status, boolean dashed, String text) {
            this.role = role;
            this.status = status;
            this.dashed = dashed;
            this.text = text;
        }
    }

    private List<Entry> entries() {
        List<Entry> entries = new ArrayList<>();
        if (drawn(Role.REFERENCE_OUTLINE)) {
            entries.add(new Entry(Role.REFERENCE_OUTLINE, Status.NEUTRAL, false, legend.reference()));
        }
        if (drawn(Role.REFERENCE_EXPECTED)) {
            entries.add(new Entry(Role.REFERENCE_EXPECTED, Status.NEUTRAL, false, legend.expected()));
        }
        Shape ellipse = first(Role.OBJECT_ELLIPSE);
        if (ellipse != null) {
            entries.add(new Entry(Role.OBJECT_ELLIPSE, ellipse.status(), ellipse.dashed(),
                    legend.ellipse(magnification, stage != Stage.NOT_CONVERGED)));
        }
        Shape grip = first(Role.GRIP_POINT);
        if (grip != null) {
            entries.add(new Entry(Role.GRIP_POINT, grip.status(), false, legend.grip()));
        }
        if (drawn(Role.OBJECT_MODE)) {
            entries.add(new Entry(Role.OBJECT_MODE, Status.AMBIGUOUS, true, legend.secondPose()));
        }
        if (showsFigures()) {
            entries.add(new Entry(null, Status.NEUTRAL, false, legend.deviations()));
        }
        if (drawn(Role.WORLD_GRID)) {
            entries.add(new Entry(Role.WORLD_GRID, Status.NEUTRAL, false, legend.grid(gridMm, axesVisible)));
        }
        if (entries.isEmpty()) {
            entries.add(new Entry(null, Status.NEUTRAL, false, legend.nothing()));
        }
        return entries;
    }

    /** Whether any label gives standard deviations. */
    private boolean showsFigures() {
        return stage != Stage.NOT_CONVERGED && stage != Stage.CONTRADICTED
                && seen.stream().anyMatch(object -> status(object.id().getAsInt()) != Status.AMBIGUOUS);
    }

    private boolean drawn(Role role) {
        return first(role) != null;
    }

    private @Nullable Shape first(Role role) {
        for (Shape s : shapes) {
            if (s.role() == role) {
                return s;
            }
        }
        return null;
    }

    private Content sample(Role role, Entry e, double left, double middle, double size) {
        double half = size / 2;
        switch (role) {
            case OBJECT_ELLIPSE:
                return (u, v) -> new EllipseShape(role, e.status, 1.4 * unit, e.dashed,
                        new Ellipse(u + left + half, v + middle, half, half / 2, 0));
            case GRIP_POINT:
                return (u, v) -> new MarkShape(role, e.status, 1.6 * unit, Mark.PLUS, u + left + half, v + middle,
                        half * 0.7);
            case WORLD_GRID:
            case OBJECT_MODE:
                double lineU = role == Role.WORLD_GRID ? GRID_U : THIN_U + 0.6;
                return (u, v) -> new Polyline(role, e.status, lineU * unit, e.dashed, u + left, v + middle,
                        u + left + size, v + middle);
            default:
                double h = half * 0.7;
                double edgeU = role == Role.REFERENCE_EXPECTED ? THIN_U : OUTLINE_U;
                return (u, v) -> {
                    double cu = u + left + half;
                    double cv = v + middle;
                    return new Polyline(role, e.status, edgeU * unit, e.dashed, cu - h, cv - h, cu + h, cv - h,
                            cu + h, cv + h, cu - h, cv + h, cu - h, cv - h);
                };
        }
    }

    // ---- labels

    private void labels() {
        for (ObjectMarker o : cell.objects()) {
            MarkerObservation m = detections.find(o.id());
            if (m != null && inImage(boxOf(m))) {
                label(boxOf(m), status(o.id()), objectLines(o.id()));
            }
        }
        for (Reference r : cell.references()) {
            MarkerObservation m = detections.find(r.id());
            if (m != null) {
                boolean out = leftOut(r.id());
                boolean off = misplaced(r.id());
                name(boxOf(m), out || off ? Status.FAIL : Status.NEUTRAL,
                        out ? words.leftOut(r.id()) : off ? words.misplaced(r.id()) : Integer.toString(r.id()));
            } else if (view != null) {
                double[] centre = view.project(r.worldFromMarker().translationMm());
                if (centre != null && view.inImage(centre)) {
                    name(new Box(centre[0], centre[1], centre[0], centre[1]), Status.FAIL, words.notSeen(r.id()));
                }
            }
        }
        for (MarkerObservation m : detections.markers()) {
            if (!isReference(m.id()) && objectMarker(m.id()) == null) {
                name(boxOf(m), Status.NEUTRAL, words.notInCell(m.id()));
            }
        }
    }

    private List<String> objectLines(int id) {
        ResultRow object = row(id);
        List<String> lines = new ArrayList<>();
        if (object == null || stage == Stage.CONTRADICTED) {
            lines.add(Integer.toString(id));
        } else if (stage == Stage.NOT_CONVERGED) {
            lines.add(words.notConverged(id));
        } else if (status(id) == Status.AMBIGUOUS) {
            lines.add(words.ambiguous(id,
                    object.ambiguous() ? shares(object.modes()) : Collections.emptyList()));
        } else {
            lines.add(words.deviations(id, figure(object.std())));
            ResultRow grip = results().grip(id);
            if (grip != null) {
                lines.add(words.gripDeviations(figure(grip.std())));
            }
            if (stage == Stage.PRELIMINARY) {
                lines.add(words.notConvergedYet());
            }
        }
        return lines;
    }

    private static List<Double> shares(List<ModeView> modes) {
        List<Double> shares = new ArrayList<>();
        modes.forEach(mode -> shares.add(mode.weight()));
        return shares;
    }

    /** A label on a panel of its own, with the mark of its status. */
    private void label(Box target, Status status, List<String> lines) {
        double pad = 3.5 * letter;
        double inCaps = 0;
        for (String line : lines) {
            inCaps = Math.max(inCaps, StrokeFont.widthInCapHeights(line));
        }
        Mark mark = Mark.of(status);
        double markCaps = mark == null ? 0 : 1.7;
        double cap = fitting(inCaps + markCaps, 2 * pad);
        double w = (inCaps + markCaps) * cap + 2 * pad;
        double h = (StrokeFont.ASCENT + StrokeFont.DESCENT / 2 + (lines.size() - 1) * StrokeFont.LINE_SPACING) * cap
                + 2 * pad;
        if (!placer.hasRoom(w, h)) {
            return;
        }
        Box box = placer.place(w, h, target);
        leader(box, target, status);
        shapes.add(new PanelShape(Role.LABEL, status, unit, box));
        double baseline = box.top() + pad + StrokeFont.ASCENT * cap;
        if (mark != null) {
            shapes.add(mark(Role.LABEL, status, mark, pad + 0.6 * cap,
                    pad + (StrokeFont.ASCENT - 0.5) * cap, 0.6 * cap).at(box.left(), box.top()));
        }
        for (int i = 0; i < lines.size(); i++) {
            shapes.add(new TextShape(Role.LABEL, Status.NEUTRAL, REGULAR, box.left() + pad + markCaps * cap,
                    baseline + i * StrokeFont.LINE_SPACING * cap, cap, lines.get(i)));
        }
    }

    /** A label without a panel. */
    private void name(Box target, Status status, String text) {
        if (!inImage(target)) {
            return;
        }
        double inCaps = StrokeFont.widthInCapHeights(text);
        double cap = Math.min(fitting(inCaps, 0), SMALL_CAP_U * letter);
        double h = (StrokeFont.ASCENT + StrokeFont.DESCENT) * cap;
        if (!placer.hasRoom(inCaps * cap, h)) {
            return;
        }
        Box box = placer.place(inCaps * cap, h, target);
        leader(box, target, status);
        shapes.add(new TextShape(Role.LABEL, status, BOLD, box.left(), box.top() + StrokeFont.ASCENT * cap, cap, text));
    }

    /** The height of letters in which a line fits into the image. */
    private double fitting(double widthInCaps, double padding) {
        return Math.min(LABEL_CAP_U * letter, Math.max(1, placer.area().width() - padding) / widthInCaps);
    }

    private void leader(Box label, Box target, Status status) {
        if (label.distance(target) > 10 * unit) {
            double u = (target.left() + target.right()) / 2;
            double v = (target.top() + target.bottom()) / 2;
            double lu = Math.min(Math.max(u, label.left()), label.right());
            double lv = Math.min(Math.max(v, label.top()), label.bottom());
            double[] points = {lu, lv, Math.min(Math.max(lu, target.left()), target.right()),
                Math.min(Math.max(lv, target.top()), target.bottom())};
            for (double[] part : WorldView.clip(points, width, height)) {
                shapes.add(belowPanels, Polyline.ofOwn(Role.LEADER, status, THIN_U * unit, false, part));
            }
        }
    }
}
