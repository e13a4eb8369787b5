package org.cellgauge.internal.validation;

import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.geometry.RigidTransform;
import org.cellgauge.internal.geometry.MarkerGeometry;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;

/**
 * Corners as a detector would report them of a cell that was built as precisely as its file states: every reference off
 * its place by a draw from its placement, every corner coordinate off by Gaussian noise.
 */
public final class SimulatedPhoto {
    private SimulatedPhoto() {
    }

    /**
     * Corners of all markers of a cell. They may lie outside the image: whether a detector would find them is not the
     * question here.
     *
     * @param cell the cell
     * @param truth where camera and objects stand; of every object
     * @param pixelStdPx standard deviation of each corner coordinate, px
     * @param placement source of placement errors; null: references stand exactly where the cell file has them
     * @param noise source of corner noise
     * @return the corners; null where a placement error puts a corner behind the camera
     */
    public static Detections of(Cell cell, CellTruth truth, double pixelStdPx, RandomGenerator placement,
            RandomGenerator noise) {
        RigidTransform cameraFromWorld = truth.worldFromCamera().inverse();
        List<MarkerObservation> markers = new ArrayList<>();
        for (Reference r : cell.references()) {
            RigidTransform pose = placement == null ? r.worldFromMarker() : r.drawn(placement);
            if (!add(markers, truth.camera(cell), r.id(), r.sizeMm(), cameraFromWorld.compose(pose), pixelStdPx,
                    noise)) {
                return null;
            }
        }
        for (ObjectMarker o : cell.objects()) {
            RigidTransform pose = cameraFromWorld.compose(truth.worldFromObjects().get(o.id()));
            if (!add(markers, truth.camera(cell), o.id(), o.sizeMm(), pose, pixelStdPx, noise)) {
                return null;
            }
        }
        return new Detections("simulated", cell.camera().widthPx(), cell.camera().heightPx(), markers);
    }

    private static boolean add(List<MarkerObservation> markers, PinholeCamera lens, int id, double sizeMm,
            RigidTransform cameraFromMarker, double pixelStdPx, RandomGenerator noise) {
        double[] px = MarkerGeometry.cornersPx(lens, cameraFromMarker, sizeMm);
        if (px == null) {
            return false;
        }
        for (int i = 0; i < 8; i++) {
            px[i] += pixelStdPx * noise.nextGaussian();
        }
        markers.add(new MarkerObservation(id, px));
        return true;
    }
}
