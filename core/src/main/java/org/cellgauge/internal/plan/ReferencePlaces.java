package org.cellgauge.internal.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Placement;
import org.cellgauge.cell.Reference;
import org.cellgauge.cell.Wall;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.plan.Layout;
import org.cellgauge.plan.PlanOptions;
import org.jspecify.annotations.Nullable;

/**
 * Where one more reference could stand: on a grid over the visible part of the plane of the references, at some heights
 * over it, flat and tilted; seen whole, large and not too aslant from wherever the camera may be, and in nobody's way.
 */
final class ReferencePlaces {
    /** Places along the length and the height of a wall. */
    private static final int ALONG_WALL = 12;
    private static final int UP_WALL = 4;
    /** Rotations whose entries differ by less than this are one. */
    private static final double FLAT = 1e-9;
    private static final double TILT_RAD = Math.toRadians(30);
    /** Paper reaches beyond the black square by this share of its size on every side. */
    private static final double PAPER = 0.2;
    /** The cosine of how far from its normal a marker may be looked at: 65 degrees. */
    private static final double LEAST_COSINE = 0.42;

    final double sizeMm;
    final Placement placement;
    final List<RigidTransform> worldFromMarkers = new ArrayList<>();
    /** Centres and radii in the images, three values for every place of the camera. */
    private final List<double[]> circles = new ArrayList<>();
    private final Layout layout;
    private final PlanOptions options;

    /**
     * How finely places are tried: across and down the image, and heights between the plane and the highest allowed.
     */
    record Grid(int columns, int rows, int heights) {
        static final Grid FINE = new Grid(20, 12, 4);
        static final Grid COARSE = new Grid(10, 6, 2);
        static final Grid QUICK = new Grid(8, 5, 1);
    }

    ReferencePlaces(Layout layout, PlanOptions options, Grid grid) {
        this.layout = layout;
        this.options = options;
        Cell cell = layout.cell();
        Reference usual = usual(cell);
        sizeMm = usual.sizeMm();
        placement = usual.placement();
        double[] plane = usual.worldFromMarker().rotation();
        double[] normal = {plane[2], plane[5], plane[8]};
        double level = level(cell, normal);
        List<double[]> taken = taken();
        List<RigidTransform> turns = new ArrayList<>();
        turns.add(RigidTransform.IDENTITY);
        for (int sign = -1; sign <= 1; sign += 2) {
            turns.add(RigidTransform.ofRotationVector(new double[] {sign * TILT_RAD, 0, 0}, new double[3]));
            turns.add(RigidTransform.ofRotationVector(new double[] {0, sign * TILT_RAD, 0}, new double[3]));
        }
        int heights = options.maxHeightMm() > 0 ? grid.heights() : 0;
        for (int h = 0; h <= heights; h++) {
            double height = heights == 0 ? 0 : options.maxHeightMm() * h / heights;
            for (int i = 0; i < grid.rows() * grid.columns(); i++) {
                int row = i / grid.columns();
                double[] at = onPlane((i % grid.columns() + 0.5) / grid.columns(), (row + 0.5) / grid.rows(), normal,
                        level + height);
                if (at == null || !options.isFree(at[0], at[1])) {
                    continue;
                }
                for (RigidTransform turn : turns) {
                    offer(RigidTransform.of(plane, rounded(at)).compose(turn), taken);
                }
            }
        }
        options.walls().forEach(wall -> offer(wall, taken));
    }

    private void offer(RigidTransform pose, List<double[]> taken) {
        double[] circle = circles(pose, sizeMm);
        if (circle != null && isClear(circle, taken)) {
            worldFromMarkers.add(pose);
            circles.add(circle);
        }
    }

    /** Upright on a wall, on the side of the camera, as high as the marker's paper allows. */
    private void offer(Wall wall, List<double[]> taken) {
        double length = Math.hypot(wall.xToMm() - wall.xFromMm(), wall.yToMm() - wall.yFromMm());
        double[] along = {(wall.xToMm() - wall.xFromMm()) / length, (wall.yToMm() - wall.yFromMm()) / length};
        double[] camera = layout.worldFromCameras().get(0).translationMm();
        boolean left = along[0] * (camera[1] - wall.yFromMm()) - along[1] * (camera[0] - wall.xFromMm()) > 0;
        // x along the wall so that x, up and out of the wall are right-handed
        double sign = left ? -1 : 1;
        double[] out = {along[1] * sign, -along[0] * sign};
        double[] rotation = {sign * along[0], 0, out[0], sign * along[1], 0, out[1], 0, 1, 0};
        double margin = sizeMm * (0.5 + PAPER);
        for (int i = 0; i < ALONG_WALL; i++) {
            for (int k = 0; k < UP_WALL; k++) {
                double at = (i + 0.5) / ALONG_WALL * length;
                double up = (k + 0.5) / UP_WALL * wall.heightMm();
                if (at > margin && at < length - margin && up > margin && up < wall.heightMm() - margin) {
                    offer(RigidTransform.of(rotation, rounded(new double[] {wall.xFromMm() + at * along[0],
                        wall.yFromMm() + at * along[1], up})), taken);
                }
            }
        }
    }

    /** The reference that is usual: with the median of the largest deviations. */
    static Reference usual(Cell cell) {
        List<Reference> sorted = new ArrayList<>(cell.references());
        sorted.sort((a, b) -> Double.compare(worst(a.placement()), worst(b.placement())));
        return sorted.get(sorted.size() / 2);
    }

    static double worst(Placement placement) {
        return Math.max(placement.stdMm(0), Math.max(placement.stdMm(1), placement.stdMm(2)));
    }

    /** The level along a direction that most references are at: their median. */
    private static double level(Cell cell, double[] normal) {
        double[] levels = cell.references().stream().mapToDouble(r -> {
            double[] at = r.worldFromMarker().translationMm();
            return at[0] * normal[0] + at[1] * normal[1] + at[2] * normal[2];
        }).sorted().toArray();
        return levels[(levels.length - 1) / 2];
    }

    private double @Nullable [] onPlane(double acrossImage, double downImage, double[] normal, double level) {
        PinholeCamera camera = layout.cell().camera();
        RigidTransform worldFromCamera = layout.worldFromCameras().get(0);
        double[] ray = new double[3];
        if (!camera.toRay(acrossImage * camera.widthPx(), downImage * camera.heightPx(), ray)) {
            return null;
        }
        double[] from = worldFromCamera.translationMm();
        double[] to = worldFromCamera.apply(ray);
        double start = 0;
        double slope = 0;
        for (int i = 0; i < 3; i++) {
            start += from[i] * normal[i];
            slope += (to[i] - from[i]) * normal[i];
        }
        double along = (level - start) / slope;
        if (!(along > 0) || Double.isInfinite(along)) {
            return null;
        }
        double[] at = new double[3];
        for (int i = 0; i < 3; i++) {
            at[i] = from[i] + along * (to[i] - from[i]);
        }
        return at;
    }

    /** To whole mm: nobody drills finer. */
    private static double[] rounded(double[] at) {
        return new double[] {Math.rint(at[0]), Math.rint(at[1]), Math.rint(at[2])};
    }

    /** Where a marker with its paper is in every image; null where it is not to be counted on in one of them. */
    private double @Nullable [] circles(RigidTransform worldFromMarker, double ofSizeMm) {
        double[] out = new double[3 * layout.worldFromCameras().size()];
        PinholeCamera camera = layout.cell().camera();
        for (int v = 0; v < layout.worldFromCameras().size(); v++) {
            RigidTransform cameraFromMarker = layout.worldFromCameras().get(v).inverse().compose(worldFromMarker);
            double[] paper = MarkerGeometry.seenPx(camera, cameraFromMarker, ofSizeMm * (1 + 2 * PAPER));
            double[] r = cameraFromMarker.rotation();
            double[] t = cameraFromMarker.translationMm();
            double cosine = -(r[2] * t[0] + r[5] * t[1] + r[8] * t[2])
                    / Math.sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
            if (paper == null || cosine < LEAST_COSINE || isHidden(worldFromMarker, ofSizeMm, v)) {
                return null;
            }
            double shortest = Double.POSITIVE_INFINITY;
            for (int i = 0; i < 4; i++) {
                int j = (i + 1) % 4;
                shortest = Math.min(shortest, Math.hypot(paper[2 * j] - paper[2 * i],
                        paper[2 * j + 1] - paper[2 * i + 1]));
                out[3 * v] += paper[2 * i] / 4;
                out[3 * v + 1] += paper[2 * i + 1] / 4;
            }
            if (shortest / (1 + 2 * PAPER) < options.leastSidePx()) {
                return null;
            }
            for (int i = 0; i < 4; i++) {
                out[3 * v + 2] = Math.max(out[3 * v + 2], Math.hypot(paper[2 * i] - out[3 * v],
                        paper[2 * i + 1] - out[3 * v + 1]));
            }
        }
        return out;
    }

    private boolean isHidden(RigidTransform worldFromMarker, double ofSizeMm, int view) {
        if (options.walls().isEmpty()) {
            return false;
        }
        double[] camera = layout.worldFromCameras().get(view).translationMm();
        // a little before its own plane, so that no marker is hidden by the wall that it hangs on
        double half = 0.5 * ofSizeMm;
        for (int corner = 0; corner < 4; corner++) {
            double[] at = worldFromMarker.apply(new double[] {corner % 2 == 0 ? half : -half,
                corner / 2 == 0 ? half : -half, 1});
            if (options.walls().stream().anyMatch(wall -> wall.hides(at, camera))) {
                return true;
            }
        }
        return false;
    }

    private List<double[]> taken() {
        List<double[]> taken = new ArrayList<>();
        for (Reference r : layout.cell().references()) {
            addTo(taken, circles(r.worldFromMarker(), r.sizeMm()));
        }
        for (ObjectMarker object : layout.cell().objects()) {
            for (Map.Entry<Integer, List<RigidTransform>> e : layout.worldFromObjects().entrySet()) {
                // an object that may be anywhere is not in the way anywhere
                if (e.getKey() == object.id() && e.getValue().size() == 1) {
                    addTo(taken, circles(e.getValue().get(0), object.sizeMm()));
                }
            }
        }
        return taken;
    }

    private static void addTo(List<double[]> circles, double @Nullable [] circle) {
        if (circle != null) {
            circles.add(circle);
        }
    }

    private static boolean isClear(double[] circle, List<double[]> taken) {
        return taken.stream().allMatch(other -> apart(circle, other));
    }

    private static boolean apart(double[] a, double[] b) {
        for (int v = 0; v < a.length; v += 3) {
            if (Math.hypot(a[v] - b[v], a[v + 1] - b[v + 1]) < a[v + 2] + b[v + 2]) {
                return false;
            }
        }
        return true;
    }

    /** Where the middle of a flat plate with four references could be, each so far from it either way. */
    List<RigidTransform> clearPlates(double half) {
        List<double[]> taken = taken();
        List<RigidTransform> clear = new ArrayList<>();
        double[] plane = usual(layout.cell()).worldFromMarker().rotation();
        for (RigidTransform middle : worldFromMarkers) {
            boolean all = isFlat(middle.rotation(), plane);
            for (int i = 0; i < 4 && all; i++) {
                RigidTransform marker = middle.compose(onPlate(i, half));
                double[] at = marker.translationMm();
                double[] circle = options.isFree(at[0], at[1]) ? circles(marker, sizeMm) : null;
                all = circle != null && isClear(circle, taken);
            }
            if (all) {
                clear.add(middle);
            }
        }
        return clear;
    }

    private static boolean isFlat(double[] rotation, double[] plane) {
        double apart = 0;
        for (int i = 0; i < rotation.length; i++) {
            apart = Math.max(apart, Math.abs(rotation[i] - plane[i]));
        }
        return apart < FLAT;
    }

    /** A corner of a plate in the frame of its middle. */
    static RigidTransform onPlate(int corner, double half) {
        return RigidTransform.ofEuler(corner % 2 == 0 ? -half : half, corner / 2 == 0 ? -half : half, 0, 0, 0, 0);
    }

    /** Whether two of the places can be taken at the same time. */
    boolean both(int a, int b) {
        return apart(circles.get(a), circles.get(b));
    }

    /** Whether a reference may stand somewhere else in place of where it is. */
    boolean allows(Reference moved) {
        double[] circle = circles(moved.worldFromMarker(), moved.sizeMm());
        if (circle == null) {
            return false;
        }
        for (Reference other : layout.cell().references()) {
            double[] taken = other.id() == moved.id() ? null : circles(other.worldFromMarker(), other.sizeMm());
            if (taken != null && !apart(circle, taken)) {
                return false;
            }
        }
        for (ObjectMarker object : layout.cell().objects()) {
            List<RigidTransform> places = layout.worldFromObjects().get(object.id());
            double[] taken = places == null || places.size() > 1 ? null : circles(places.get(0), object.sizeMm());
            if (taken != null && !apart(circle, taken)) {
                return false;
            }
        }
        return true;
    }
}
