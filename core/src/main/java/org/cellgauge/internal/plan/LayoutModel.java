package org.cellgauge.internal.plan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.cell.Target;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.vision.CornerForecast;
import org.cellgauge.plan.Forecast;
import org.cellgauge.plan.Layout;
import org.jspecify.annotations.Nullable;

/**
 * A layout as information: for every place that the camera may have, what each reference tells, and what the target
 * asks for. Not thread-safe.
 */
public final class LayoutModel {
    private static final double[] CENTRE = new double[3];

    private final Layout layout;
    private final List<View> views = new ArrayList<>();
    /** Where markers do not err independently: one for each view. */
    private final List<JointLayout> joints = new ArrayList<>();
    private final Set<Integer> unseen = new LinkedHashSet<>();
    private final Set<Integer> seenEverywhere = new LinkedHashSet<>();

    /** One place of the camera. */
    private static final class View {
        final PlannedView view;
        /** What is known beside references: priors, and what the squares of objects tell of shared unknowns. */
        final double[] ofObjects;
        final Map<Integer, double[]> references = new LinkedHashMap<>();
        final List<Label> labels = new ArrayList<>();
        final List<PlannedView.PointRows> points = new ArrayList<>();
        /** Of the orientation; null at gripping points. */
        final List<PlannedView.@Nullable PointRows> turns = new ArrayList<>();
        Design design;

        View(PlannedView view) {
            this.view = view;
            ofObjects = new double[view.unknowns() * view.unknowns()];
            design = new Design(view.unknowns(), new double[0][], new double[0]);
        }
    }

    /** Whose point it is. */
    private record Label(int object, boolean grip) {
    }

    /**
     * A layout.
     *
     * @param layout what stands where
     * @param forecast how precisely corners would be found, where the cell states no noise
     * @param intrinsics prior of the unknown intrinsics
     */
    public LayoutModel(Layout layout, CornerForecast forecast, IntrinsicsPrior intrinsics) {
        this.layout = layout;
        Cell cell = layout.cell();
        Set<Double> sizes = new LinkedHashSet<>();
        cell.references().forEach(r -> sizes.add(r.sizeMm()));
        cell.objects().forEach(o -> sizes.add(o.sizeMm()));
        cell.references().forEach(r -> seenEverywhere.add(r.id()));
        for (RigidTransform worldFromCamera : layout.worldFromCameras()) {
            View view = new View(view(worldFromCamera, forecast, intrinsics, sizes));
            List<PlannedView> photos = new ArrayList<>(List.of(view.view));
            layout.cameraFromOthers().forEach(other -> photos.add(
                    view(worldFromCamera.compose(other), forecast, intrinsics, sizes)));
            for (Reference r : cell.references()) {
                double[] information = view.view.information(r.worldFromMarker(), r.sizeMm(), r.placement());
                boolean inAll = information != null && photos.subList(1, photos.size()).stream()
                        .allMatch(photo -> photo.withPlace(r.worldFromMarker(), r.sizeMm()) != null);
                if (information == null || !inAll) {
                    seenEverywhere.remove(r.id());
                } else {
                    view.references.put(r.id(), information);
                }
            }
            for (ObjectMarker object : cell.objects()) {
                List<RigidTransform> places = layout.worldFromObjects().get(object.id());
                if (places != null) {
                    look(view, object, places);
                }
            }
            setDesign(view);
            views.add(view);
            if (!layout.isOnePhoto()) {
                joints.add(new JointLayout(layout, photos, List.copyOf(view.references.keySet())));
            }
        }
    }

    private PlannedView view(RigidTransform worldFromCamera, CornerForecast forecast, IntrinsicsPrior intrinsics,
            Set<Double> sizes) {
        Cell cell = layout.cell();
        return new PlannedView(cell, worldFromCamera, forecast, 1, intrinsics, new ArrayList<>(sizes),
                cell.references().size() + layout.worldFromObjects().size());
    }

    private void look(View view, ObjectMarker object, List<RigidTransform> places) {
        double[] ofSquare = null;
        for (RigidTransform worldFromObject : places) {
            PlannedView.SeenObject seen = view.view.object(worldFromObject, object.sizeMm());
            if (seen == null) {
                unseen.add(object.id());
                return;
            }
            // of several places an object has one: what its square tells is taken from the first
            ofSquare = ofSquare == null ? seen.information() : ofSquare;
            view.labels.add(new Label(object.id(), false));
            view.points.add(seen.point(CENTRE));
            view.turns.add(seen.turn());
            double[] grip = object.gripMm();
            if (grip != null) {
                view.labels.add(new Label(object.id(), true));
                view.points.add(seen.point(grip));
                view.turns.add(null);
            }
        }
        if (ofSquare != null) {
            add(ofSquare, view.ofObjects);
        }
    }

    /** What is asked of an object; of each 1 mm along every axis where nothing is asked of any. */
    private Asked asked(int object) {
        Target target = layout.cell().target();
        return new Asked(target.isAny() ? target.of(object) : Asked.ONE_MM);
    }

    private void setDesign(View view) {
        int n = view.view.unknowns();
        List<double[]> rows = new ArrayList<>();
        List<Double> own = new ArrayList<>();
        List<Integer> ends = new ArrayList<>();
        for (int p = 0; p < view.points.size(); p++) {
            Asked asked = asked(view.labels.get(p).object());
            PlannedView.PointRows point = view.points.get(p);
            for (int axis = 0; axis < 3; axis++) {
                addRow(point, axis, asked.limitMm(axis), n, rows, own, ends);
            }
            addRows(point, asked.traceLimitMm(), n, rows, own, ends);
            if (view.turns.get(p) != null) {
                addRows(view.turns.get(p), asked.traceLimitRad(), n, rows, own, ends);
            }
        }
        view.design = new Design(n, rows.toArray(new double[0][]), own.stream().mapToDouble(d -> d).toArray(),
                ends.stream().mapToInt(e -> e).toArray());
    }

    private static void addRow(PlannedView.PointRows point, int axis, double limit, int n, List<double[]> rows,
            List<Double> own, List<Integer> ends) {
        if (limit < Double.POSITIVE_INFINITY) {
            double[] row = new double[n];
            for (int i = 0; i < n; i++) {
                row[i] = point.rows()[axis * n + i] / limit;
            }
            rows.add(row);
            own.add(point.ownMm2()[4 * axis] / (limit * limit));
            ends.add(rows.size());
        }
    }

    /** All three as one function. */
    private static void addRows(PlannedView.PointRows point, double limit, int n, List<double[]> rows,
            List<Double> own, List<Integer> ends) {
        if (limit < Double.POSITIVE_INFINITY) {
            for (int axis = 0; axis < 3; axis++) {
                addRow(point, axis, limit, n, rows, own, ends);
                ends.remove(ends.size() - 1);
            }
            ends.add(rows.size());
        }
    }

    static void add(double[] what, double[] to) {
        for (int i = 0; i < to.length; i++) {
            to[i] += what[i];
        }
    }

    /**
     * The layout.
     *
     * @return as it was given
     */
    public Layout layout() {
        return layout;
    }

    /**
     * Whether every object is seen from everywhere.
     *
     * @return false where nothing that references do could help
     */
    public boolean seesAllObjects() {
        return unseen.isEmpty();
    }

    /**
     * Number of places of the camera.
     *
     * @return at least 1
     */
    public int views() {
        return views.size();
    }

    /**
     * One of the photos.
     *
     * @param v 0 to {@link #views()} - 1
     * @return what markers tell in it
     */
    public PlannedView view(int v) {
        return views.get(v).view;
    }

    /**
     * What is asked for in one of the photos, so that 1 just meets the target (of 1 mm where there is none).
     *
     * @param v 0 to {@link #views()} - 1
     * @return with a function for all that is asked of every point; of its own for one thread
     */
    public Design design(int v) {
        return views.get(v).design;
    }

    /**
     * Information of a photo without some references, so that others can be added.
     *
     * @param v 0 to {@link #views()} - 1
     * @param without ids of references to leave out
     * @param added number of references that will be added
     * @return n x n
     */
    public double[] information(int v, Collection<Integer> without, int added) {
        View view = views.get(v);
        int count = added;
        double[] centroid = new double[3];
        for (Reference r : layout.cell().references()) {
            if (view.references.containsKey(r.id()) && !without.contains(r.id())) {
                count++;
            }
            double[] at = r.worldFromMarker().translationMm();
            for (int i = 0; i < 3; i++) {
                centroid[i] += at[i] / layout.cell().references().size();
            }
        }
        double[] sum = view.view.prior(count, centroid);
        add(view.ofObjects, sum);
        view.references.forEach((id, information) -> {
            if (!without.contains(id)) {
                add(information, sum);
            }
        });
        return sum;
    }

    /**
     * How much of what is asked for is taken by the point that takes most, squared; a distance or a turn counts at
     * most, which may be more than it does.
     *
     * @return at most 1 where the target is met for sure; mm² where there is no target; infinite where an object is not
     *     seen
     */
    public double worst() {
        double worst = unseen.isEmpty() ? 0 : Double.POSITIVE_INFINITY;
        for (int v = 0; v < views.size(); v++) {
            if (joints.isEmpty()) {
                worst = Math.max(worst, views.get(v).design.worst(information(v, List.of(), 0)));
            } else {
                for (Found found : found(v)) {
                    worst = Math.max(worst, asked(found.label().object()).square(found.known().covarianceMm2(),
                            found.known().turnRad2()));
                }
            }
        }
        return worst;
    }

    /** What is known of a point at one of its places. */
    private record Found(Label label, JointLayout.Known known) {
    }

    private List<Found> found(int v) {
        return joints.isEmpty() ? byInformation(v) : joint(joints.get(v));
    }

    private List<Found> byInformation(int v) {
        View view = views.get(v);
        int n = view.view.unknowns();
        double[] factor = information(v, List.of(), 0);
        double[] inverse = Cholesky.inverse(factor, n);
        List<Found> all = new ArrayList<>();
        for (int p = 0; p < view.points.size(); p++) {
            PlannedView.PointRows turn = view.turns.get(p);
            all.add(new Found(view.labels.get(p), new JointLayout.Known(
                    covariance(view.points.get(p), inverse, n), view.points.get(p).ownMm2(),
                    turn == null ? null : covariance(turn, inverse, n), turn == null ? null : turn.ownMm2())));
        }
        return all;
    }

    private static double[] covariance(PlannedView.PointRows point, double @Nullable [] inverse, int n) {
        double[] out = point.ownMm2().clone();
        if (inverse == null) {
            Arrays.fill(out, Double.POSITIVE_INFINITY);
            return out;
        }
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                for (int a = 0; a < n; a++) {
                    double sum = 0;
                    for (int b = 0; b < n; b++) {
                        sum += inverse[a * n + b] * point.rows()[j * n + b];
                    }
                    out[3 * i + j] += point.rows()[i * n + a] * sum;
                }
            }
        }
        return out;
    }

    private List<Found> joint(JointLayout joint) {
        List<Found> all = new ArrayList<>();
        for (ObjectMarker object : layout.cell().objects()) {
            double[] grip = object.gripMm();
            for (RigidTransform place : layout.worldFromObjects().getOrDefault(object.id(), List.of())) {
                List<JointLayout.Known> known = joint.of(object, place, grip == null ? List.of(CENTRE)
                        : List.of(CENTRE, grip));
                if (known == null) {
                    unseen.add(object.id());
                    break;
                }
                all.add(new Found(new Label(object.id(), false), known.get(0)));
                if (grip != null) {
                    JointLayout.Known k = known.get(1);
                    all.add(new Found(new Label(object.id(), true),
                            new JointLayout.Known(k.covarianceMm2(), k.ownMm2(), null, null)));
                }
            }
        }
        return all;
    }

    /**
     * Deviations of every point, where each is worst.
     *
     * @return the forecast
     */
    public Forecast forecast() {
        Map<Label, double[]> worst = new LinkedHashMap<>();
        for (int v = 0; v < views.size(); v++) {
            for (Found found : found(v)) {
                JointLayout.Known known = found.known();
                Asked asked = asked(found.label().object());
                double[] most = worst.computeIfAbsent(found.label(),
                        label -> new double[] {0, 0, 0, 0, 0, -1, 0, Double.NaN, 0});
                for (int axis = 0; axis < 3; axis++) {
                    most[axis] = Math.max(most[axis], Math.sqrt(known.covarianceMm2()[4 * axis]));
                    most[3] = Math.max(most[3], Math.sqrt(known.ownMm2()[4 * axis]));
                    if (known.turnRad2() != null) {
                        most[4] = Math.max(most[4], Math.toDegrees(Math.sqrt(known.turnRad2()[4 * axis])));
                    }
                }
                double ratio = asked.ratio(known.covarianceMm2(), known.turnRad2());
                if (ratio > most[5]) {
                    double[] c = known.covarianceMm2();
                    most[5] = ratio;
                    most[8] = Double.isFinite(c[0]) ? c[1] / Math.sqrt(c[0] * c[4]) : 0;
                }
                most[6] = Math.max(most[6], asked.ratio(known.ownMm2(), known.ownTurnRad2()));
                double probability = asked.probability(known.covarianceMm2(), known.turnRad2());
                most[7] = most[7] < probability ? most[7] : probability;
            }
        }
        List<Forecast.Row> rows = new ArrayList<>();
        worst.forEach((label, most) -> {
            if (!unseen.contains(label.object())) {
                rows.add(new Forecast.Row(label.object(), label.grip(), most[0], most[1], most[2], most[3],
                        label.grip() ? Double.NaN : most[4], most[5], most[6], most[7], most[8]));
            }
        });
        return new Forecast(rows, List.copyOf(seenEverywhere), List.copyOf(unseen));
    }
}
