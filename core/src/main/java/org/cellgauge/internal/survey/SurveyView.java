package org.cellgauge.internal.survey;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.MarkerPoseFinder;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.vision.Detections;

/**
 * One photo of a survey: the markers of the cell that it shows, with how far their corners may be off; immutable.
 *
 * <p>Unknowns of its own: the camera's pose (shift and turn in the camera frame of the world about a fixed centre),
 * where its edges lie, in units of their deviations, and the pose in the camera frame of each object that moves.
 */
final class SurveyView {
    private static final int CORNER_VALUES = 8;

    final Detections detections;
    private final PinholeCamera camera;
    final CornerErrors errors;
    /** The added noise that its markers' squareness tells of. */
    final double noiseLevel;
    final int edges;
    final int[] ids;
    final double[][] cornersPx;
    final double[][] whitening;
    /** Changes of the corners by the unknowns of edges, 8 x edges each. */
    final double[][] byEdges;
    /** Changes of the corners by the size of the marker's print in its deviation. */
    final double[][] bySize;
    /** Corners in the marker's frame, 12 values each, mm. */
    final double[][] pointsMm;
    final double[] sizesMm;
    /** Objects that move, in the order of the cell. */
    final List<Integer> moving = new ArrayList<>();

    SurveyView(Cell cell, Detections detections) {
        this.detections = detections;
        camera = cell.camera();
        errors = CornerErrors.of(cell, detections).withOutliersSetAside();
        noiseLevel = errors.added() == null ? 0 : errors.squarenessBelief().ofMeanVariance();
        List<Integer> seen = errors.ids();
        int n = seen.size();
        ids = new int[n];
        cornersPx = new double[n][];
        whitening = new double[n][];
        byEdges = new double[n][];
        bySize = new double[n][];
        pointsMm = new double[n][];
        sizesMm = new double[n];
        int unknowns = errors.unknowns();
        edges = unknowns - errors.sizesMm().size();
        for (int m = 0; m < n; m++) {
            int id = seen.get(m);
            ids[m] = id;
            cornersPx[m] = errors.cornersPx(id);
            whitening[m] = errors.whitening(id, noiseLevel);
            sizesMm[m] = sizeMm(cell, id);
            pointsMm[m] = MarkerGeometry.cornersMm(sizesMm[m]);
            double[] columns = errors.columns(id);
            byEdges[m] = new double[CORNER_VALUES * edges];
            bySize[m] = new double[CORNER_VALUES];
            int size = errors.sizesMm().indexOf(sizesMm[m]);
            for (int i = 0; i < CORNER_VALUES; i++) {
                System.arraycopy(columns, i * unknowns, byEdges[m], i * edges, edges);
                bySize[m][i] = size < 0 ? 0 : columns[i * unknowns + edges + size];
            }
        }
        for (ObjectMarker o : cell.objects()) {
            if (o.moves() && errors.has(o.id())) {
                moving.add(o.id());
            }
        }
    }

    private static double sizeMm(Cell cell, int id) {
        for (Reference r : cell.references()) {
            if (r.id() == id) {
                return r.sizeMm();
            }
        }
        for (ObjectMarker o : cell.objects()) {
            if (o.id() == id) {
                return o.sizeMm();
            }
        }
        throw new IllegalArgumentException("marker " + id + " is not of the cell");
    }

    /** Number of markers of the cell. */
    int size() {
        return ids.length;
    }

    /** Number of unknowns of its own. */
    int locals() {
        return SurveyLayout.POSE * (1 + moving.size()) + edges;
    }

    /** The poses in the camera frame that explain a marker alone, the likelier first. */
    List<RigidTransform> posesAlone(int marker) {
        List<RigidTransform> poses = new ArrayList<>();
        for (PoseMode mode : new MarkerPoseFinder().modes(cornersPx[marker], sizesMm[marker], camera,
                whitening[marker])) {
            poses.add(mode.state().cameraFromSet());
        }
        return poses;
    }
}
