package org.cellgauge.android.state;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.CellReader;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.BrownLens;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;

/** A cell with objects at the border of the view, and what a camera with a known lens sees of it. */
final class SimulatedCell {
    static final PinholeCamera STRAIGHT = PinholeCamera.ideal(1280, 720, 950, 950, 640, 360);
    private static final double NOISE_PX = 0.1;
    /** Objects at the border of the view, where a lens bends most. */
    static final double[][] PLACES_MM = {{-420, -210, 40}, {430, 220, 20}, {0, 240, 60}};
    static final int[] IDS = {5, 6, 7};
    private static final String CELL = "cellgauge: 1\nmarkers: {family: square-binary, size_mm: 60}\n"
            + "placement: {std_mm: [0.5, 0.5, 0.5], std_deg: 0.1}\npixel_std_px: 0.1\n"
            + "target: {std_mm: 3}\nreferences:\n"
            + "  10: {position_mm: [-150, -120, 0]}\n  20: {position_mm: [150, -120, 0]}\n"
            + "  30: {position_mm: [150, 120, 0]}\n  40: {position_mm: [-150, 120, 100]}\n"
            + "objects: {5: {}, 6: {}, 7: {}}\n";

    /** The same camera with a lens that bends rays. */
    static PinholeCamera bent(double k1) {
        double[] intrinsics = new double[BrownLens.MODEL.parameterCount()];
        System.arraycopy(STRAIGHT.intrinsics(), 0, intrinsics, 0, PinholeCamera.SKEW);
        intrinsics[BrownLens.MODEL.parameterNames().indexOf("k1")] = k1;
        return PinholeCamera.of(BrownLens.MODEL, STRAIGHT.widthPx(), STRAIGHT.heightPx(), intrinsics);
    }

    static Cell cell() {
        return CellReader.read(CELL, "cell.yaml", STRAIGHT);
    }

    /** Corners with noise, as a lens shows them from one of several places. */
    static Detections photo(Cell cell, PinholeCamera lens, int view) {
        return photo(cell, lens, view, 0);
    }

    /** The same with the first object moved along x. */
    static Detections photo(Cell cell, PinholeCamera lens, int view, double movedMm) {
        Random noise = new Random(100 + view);
        RigidTransform cameraFromWorld = RigidTransform.ofEuler(20 * view - 20, 30 - 30 * view, 900,
                Math.PI - 0.15 + 0.15 * view, 0.1 * view - 0.1, 0.05).inverse();
        List<MarkerObservation> markers = new ArrayList<>();
        for (Reference reference : cell.references()) {
            markers.add(seen(reference.id(), cameraFromWorld.compose(reference.worldFromMarker()), lens, noise));
        }
        for (int i = 0; i < IDS.length; i++) {
            RigidTransform worldFromObject = RigidTransform.ofEuler(PLACES_MM[i][0] + (i == 0 ? movedMm : 0),
                    PLACES_MM[i][1], PLACES_MM[i][2], 0.2, -0.2, 0.3);
            markers.add(seen(IDS[i], cameraFromWorld.compose(worldFromObject), lens, noise));
        }
        return new Detections("view " + view, STRAIGHT.widthPx(), STRAIGHT.heightPx(), markers);
    }

    private static MarkerObservation seen(int id, RigidTransform cameraFromMarker, PinholeCamera lens, Random noise) {
        double[] px = MarkerGeometry.cornersPx(lens, cameraFromMarker, 60);
        for (int i = 0; i < px.length; i++) {
            px[i] += NOISE_PX * noise.nextGaussian();
        }
        return new MarkerObservation(id, px);
    }

    private SimulatedCell() {
    }
}
