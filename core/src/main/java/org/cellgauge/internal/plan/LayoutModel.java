package org.cellgauge.internal.plan;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.vision.CornerForecast;
import org.cellgauge.plan.Forecast;
import org.cellgauge.plan.Layout;

/**
 * A layout as information: for every place that the camera may have, what each reference tells, and what the target
 * asks for. Not thread-safe.
 */
public final class LayoutModel {
    private static final double[] CENTRE = new double[3];

    private final Layout layout;
    private final List<View> views = new ArrayList<>();
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
        double unit = 1 / cell.targetStdMm().orElse(1);
        cell.references().forEach(r -> seenEverywhere.add(r.id()));
        for (RigidTransform worldFromCamera : layout.worldFromCameras()) {
            View view = new View(new PlannedView(cell, worldFromCamera, forecast, 1, intrinsics,
                    new ArrayList<>(sizes), cell.references().size() + layout.worldFromObjects().size()));
            for (Reference r : cell.references()) {
                double[] information = view.view.information(r.worldFromMarker(), r.sizeMm(), r.placement());
                if (information == null) {
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
            setDesign(view, unit);
            views.add(view);
        }
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
            double[] grip = object.gripMm();
            if (grip != null) {
                view.labels.add(new Label(object.id(), true));
                view.points.add(seen.point(grip));
            }
        }
        if (ofSquare != null) {
            add(ofSquare, view.ofObjects);
        }
    }

    private static void setDesign(View view, double unit) {
        int n = view.view.unknowns();
        double[][] rows = new double[3 * view.points.size()][n];
        double[] own = new double[rows.length];
        for (int p = 0; p < view.points.size(); p++) {
            for (int axis = 0; axis < 3; axis++) {
                for (int i = 0; i < n; i++) {
                    rows[3 * p + axis][i] = view.points.get(p).rows()[axis * n + i] * unit;
                }
                own[3 * p + axis] = view.points.get(p).ownMm2()[4 * axis] * unit * unit;
            }
        }
        view.design = new Design(n, rows, own);
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
     * What is asked for in one of the photos, in units of the target (of 1 mm where there is none).
     *
     * @param v 0 to {@link #views()} - 1
     * @return with functions for x, y, z of every point; of its own for one thread
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
     * The largest variance of any point along any axis, in units of the target's square.
     *
     * @return at most 1 where the target is met; infinite where an object is not seen
     */
    public double worst() {
        double worst = unseen.isEmpty() ? 0 : Double.POSITIVE_INFINITY;
        for (int v = 0; v < views.size(); v++) {
            worst = Math.max(worst, views.get(v).design.worst(information(v, List.of(), 0)));
        }
        return worst;
    }

    /**
     * Deviations of every point, where each is worst.
     *
     * @return the forecast
     */
    public Forecast forecast() {
        double target = layout.cell().targetStdMm().orElse(1);
        Map<Label, double[]> worst = new LinkedHashMap<>();
        for (int v = 0; v < views.size(); v++) {
            View view = views.get(v);
            Design design = view.design;
            double[] variances = new double[design.functions()];
            double[][] solutions = new double[variances.length][design.unknowns()];
            boolean told = design.variances(information(v, List.of(), 0), variances, solutions);
            for (int p = 0; p < view.points.size(); p++) {
                double[] most = worst.computeIfAbsent(view.labels.get(p), label -> new double[4]);
                for (int axis = 0; axis < 3; axis++) {
                    double std = told ? Math.sqrt(variances[3 * p + axis]) * target : Double.POSITIVE_INFINITY;
                    most[axis] = Math.max(most[axis], std);
                    most[3] = Math.max(most[3], Math.sqrt(view.points.get(p).ownMm2()[4 * axis]));
                }
            }
        }
        List<Forecast.Row> rows = new ArrayList<>();
        worst.forEach((label, std) -> {
            if (!unseen.contains(label.object())) {
                rows.add(new Forecast.Row(label.object(), label.grip(), std[0], std[1], std[2], std[3]));
            }
        });
        return new Forecast(rows, List.copyOf(seenEverywhere), List.copyOf(unseen));
    }
}
