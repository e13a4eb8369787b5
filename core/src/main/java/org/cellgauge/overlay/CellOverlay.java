package org.cellgauge.overlay;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.CheckUpdate;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;

/** The overlay of a check at whatever stage. */
public final class CellOverlay {
    private CellOverlay() {
    }

    /**
     * The overlay of a finished check.
     *
     * @param result the result
     * @return what to draw over its photo
     */
    public static Overlay of(CheckResult result) {
        return of(result.cell(), result.detections(), result.estimate());
    }

    /**
     * The overlay of a running check.
     *
     * @param cell the cell
     * @param detections the markers of the photo
     * @param update the newest item of the check's stream; the last one gives the same as {@link #of(CheckResult)}
     * @return what to draw over the photo
     */
    public static Overlay of(Cell cell, Detections detections, CheckUpdate update) {
        return update.result() != null ? of(update.result()) : of(cell, detections, update.estimate());
    }

    /**
     * The overlay of an estimate that no chain has confirmed.
     *
     * @param cell the cell
     * @param detections the markers of the photo
     * @param estimate poses and their uncertainties
     * @return what to draw over the photo; its figures are marked as not converged yet
     */
    public static Overlay of(Cell cell, Detections detections, CellEstimate estimate) {
        List<Shape> shapes = new ArrayList<>();
        double unit = Overlay.unitPx(detections.widthPx(), detections.heightPx());
        for (MarkerObservation m : detections.markers()) {
            double[] p = m.cornersPx();
            shapes.add(new Polyline(Role.OBJECT_OUTLINE, Status.NEUTRAL, 1.5 * unit, false, p[0], p[1], p[2], p[3], p[4],
                    p[5], p[6], p[7], p[0], p[1]));
        }
        return new Overlay(detections.widthPx(), detections.heightPx(), Status.NEUTRAL, 1, 100, shapes);
    }
}
