package org.cellgauge.internal.survey;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.Placement;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.pose.InitialPose;
import org.cellgauge.internal.pose.ReferenceView;
import org.jspecify.annotations.Nullable;

/**
 * Where the search for the mode of a survey starts: cameras from the references that their photos show, objects from
 * the poses that explain them in most photos, cameras that see no reference from those objects.
 *
 * <p>A small marker seen nearly frontally has two poses that explain its corners. Which of them is right is settled by
 * all photos: every pose that any marker alone gives is held against all markers whose places are known, and the best
 * is kept.
 */
final class SurveyStart {
    private static final double[] IDENTITY = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    /** A corner farther off than this, in deviations, counts as this far off. */
    private static final double FARTHEST = 30;
    /** What a corner is off by in a first estimate, however precisely its marker stands, px. */
    private static final double FIRST_PX = 1;
    /** References from which on their joint pose is not mirrored. */
    private static final int ENOUGH = 3;
    /** Photos whose views of an object alone are followed. */
    private static final int MOST_FOLLOWED = 8;

    private final Cell cell;
    private final PinholeCamera camera;
    private final List<SurveyView> views;
    private final @Nullable RigidTransform[] worldFromCameras;
    private final @Nullable RigidTransform[] worldFromReferences;
    private final @Nullable RigidTransform[] worldFromObjects;

    /**
     * A start.
     *
     * @param known poses of cameras that are known from before, null for the others
     * @param references where references stand
     * @param objects likewise, in the order of the cell; null for the others
     */
    SurveyStart(Cell cell, List<SurveyView> views, @Nullable RigidTransform[] known, RigidTransform[] references,
            @Nullable RigidTransform[] objects) {
        this.cell = cell;
        this.views = views;
        camera = cell.camera();
        worldFromCameras = known.clone();
        worldFromReferences = references.clone();
        worldFromObjects = objects.clone();
        for (int v = 0; v < views.size(); v++) {
            if (worldFromCameras[v] == null) {
                worldFromCameras[v] = pose(views.get(v));
            }
        }
        boolean found = true;
        while (found) {
            found = placeObjects();
            for (int v = 0; v < views.size(); v++) {
                if (worldFromCameras[v] == null) {
                    worldFromCameras[v] = best(views.get(v), new ArrayList<>());
                    found |= worldFromCameras[v] != null;
                }
            }
        }
    }

    /** Pose of a camera; null where nothing links its photo to the others. */
    @Nullable RigidTransform worldFromCamera(int view) {
        return worldFromCameras[view];
    }

    /** Pose of an object; null where no photo with a known camera shows it. */
    @Nullable RigidTransform worldFromObject(int object) {
        return worldFromObjects[object];
    }

    private @Nullable RigidTransform pose(SurveyView view) {
        List<RigidTransform> candidates = new ArrayList<>();
        int seen = 0;
        for (int id : view.ids) {
            seen += reference(id) >= 0 ? 1 : 0;
        }
        if (seen == 0) {
            return null;
        }
        RigidTransform pnp = InitialPose.PNP.estimate(ReferenceView.of(cell.references(), view.errors), camera);
        if (pnp != null && seen >= ENOUGH) {
            return pnp;
        }
        if (pnp != null) {
            candidates.add(pnp);
        }
        return best(view, candidates);
    }

    /** Index of a marker among references, -1 for none. */
    private int reference(int id) {
        for (int r = 0; r < cell.references().size(); r++) {
            if (cell.references().get(r).id() == id) {
                return r;
            }
        }
        return -1;
    }

    private int object(int id) {
        for (int o = 0; o < cell.objects().size(); o++) {
            if (cell.objects().get(o).id() == id && !cell.objects().get(o).moves()) {
                return o;
            }
        }
        return -1;
    }

    private @Nullable RigidTransform known(int id) {
        int reference = reference(id);
        int object = object(id);
        return reference >= 0 ? worldFromReferences[reference] : object >= 0 ? worldFromObjects[object] : null;
    }

    private @Nullable RigidTransform best(SurveyView view, List<RigidTransform> candidates) {
        for (int m = 0; m < view.size(); m++) {
            RigidTransform world = known(view.ids[m]);
            if (world != null) {
                for (RigidTransform alone : view.posesAlone(m)) {
                    candidates.add(world.compose(alone.inverse()));
                }
            }
        }
        RigidTransform best = null;
        double least = Double.POSITIVE_INFINITY;
        for (RigidTransform candidate : candidates) {
            double cost = 0;
            for (int m = 0; m < view.size(); m++) {
                RigidTransform world = known(view.ids[m]);
                cost += world == null ? 0 : cost(view, m, candidate.inverse().compose(world));
            }
            if (cost < least) {
                least = cost;
                best = candidate;
            }
        }
        return best;
    }

    /** How far a pose leaves the corners of a marker off, in what its placement and a first estimate allow. */
    private double cost(SurveyView view, int m, RigidTransform cameraFromMarker) {
        double[] px = MarkerGeometry.cornersPx(camera, cameraFromMarker, view.sizesMm[m]);
        if (px == null) {
            return 4 * FARTHEST * FARTHEST;
        }
        int reference = reference(view.ids[m]);
        double allowed = FIRST_PX;
        if (reference >= 0) {
            Placement placement = cell.references().get(reference).placement();
            double stdMm = Math.max(Math.max(placement.stdMm(0), placement.stdMm(1)), placement.stdMm(2));
            double side = Math.hypot(px[2] - px[0], px[3] - px[1]);
            allowed = Math.hypot(FIRST_PX, stdMm * side / view.sizesMm[m]);
        }
        double sum = 0;
        for (int k = 0; k < 4; k++) {
            double off = Math.hypot(px[2 * k] - view.cornersPx[m][2 * k],
                    px[2 * k + 1] - view.cornersPx[m][2 * k + 1]) / allowed;
            sum += Math.min(off * off, FARTHEST * FARTHEST);
        }
        return sum;
    }

    /** Places objects that are not placed yet; whether any was. */
    private boolean placeObjects() {
        boolean any = false;
        for (int o = 0; o < cell.objects().size(); o++) {
            if (worldFromObjects[o] == null && !cell.objects().get(o).moves()) {
                List<RigidTransform> candidates = candidates(o);
                worldFromObjects[o] = candidates.isEmpty() ? null : candidates.get(0);
                any |= worldFromObjects[o] != null;
            }
        }
        return any;
    }

    /** Poses of an object that any photo alone gives, the one first that all photos agree with best. */
    List<RigidTransform> candidates(int object) {
        int id = cell.objects().get(object).id();
        List<RigidTransform> candidates = new ArrayList<>();
        int followed = 0;
        for (int v = 0; v < views.size() && followed < MOST_FOLLOWED; v++) {
            SurveyView view = views.get(v);
            RigidTransform worldFromCamera = worldFromCameras[v];
            for (int m = 0; m < view.size() && worldFromCamera != null; m++) {
                if (view.ids[m] == id) {
                    followed++;
                    for (RigidTransform alone : view.posesAlone(m)) {
                        candidates.add(worldFromCamera.compose(alone));
                    }
                }
            }
        }
        double[] costs = new double[candidates.size()];
        List<Integer> order = new ArrayList<>();
        for (int c = 0; c < costs.length; c++) {
            order.add(c);
            for (int v = 0; v < views.size(); v++) {
                SurveyView view = views.get(v);
                RigidTransform worldFromCamera = worldFromCameras[v];
                for (int m = 0; m < view.size() && worldFromCamera != null; m++) {
                    if (view.ids[m] == id) {
                        costs[c] += cost(view, m, worldFromCamera.inverse().compose(candidates.get(c)));
                    }
                }
            }
        }
        order.sort((a, b) -> Double.compare(costs[a], costs[b]));
        List<RigidTransform> sorted = new ArrayList<>();
        order.forEach(c -> sorted.add(candidates.get(c)));
        return sorted;
    }

    /** A state that stands here; every view must have a camera pose. */
    SurveyState state(SurveyLayout layout, double[] centreMm) {
        SurveyState state = new SurveyState(layout, views);
        for (int o = 0; o < cell.objects().size(); o++) {
            int at = layout.object(cell.objects().get(o).id());
            RigidTransform pose = worldFromObjects[o];
            if (at >= 0 && pose != null) {
                SurveyState.set(state.objects, SurveyState.TRANSFORM * at, pose);
            }
        }
        for (int v = 0; v < views.size(); v++) {
            RigidTransform worldFromCamera = worldFromCameras[v];
            if (worldFromCamera == null) {
                throw new IllegalStateException("photo " + v + " has no pose");
            }
            SurveyState.set(state.cameras[v], 0,
                    worldFromCamera.inverse().compose(RigidTransform.of(IDENTITY, centreMm)));
            SurveyView view = views.get(v);
            for (int k = 0; k < view.moving.size(); k++) {
                for (int m = 0; m < view.size(); m++) {
                    List<RigidTransform> alone = view.ids[m] == view.moving.get(k) ? view.posesAlone(m) : List.of();
                    if (!alone.isEmpty()) {
                        SurveyState.set(state.moving[v], SurveyState.TRANSFORM * k, alone.get(0));
                    }
                }
            }
        }
        return state;
    }

}
