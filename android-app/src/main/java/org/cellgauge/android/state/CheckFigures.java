package org.cellgauge.android.state;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Reason;
import org.cellgauge.estimate.ObjectEstimate;
import org.cellgauge.live.LiveState;
import org.cellgauge.overlay.CellOverlay;
import org.cellgauge.overlay.Overlay;
import org.cellgauge.overlay.OverlayStyle;
import org.cellgauge.overlay.Status;

/** What the screen shows of a check: rows of the list, and the overlay. Every judgement is core's. */
final class CheckFigures {
    private CheckFigures() {
    }

    /** The rows of all objects of a cell. */
    static List<ObjectRow> rows(Cell cell, LiveState live, CheckResult result) {
        List<ObjectRow> rows = new ArrayList<>();
        CellEstimate estimate = result != null ? result.estimate()
                : live.update() != null ? live.update().estimate() : null;
        for (ObjectMarker marker : cell.objects()) {
            ObjectEstimate object = estimate == null ? null : estimate.object(marker.id());
            if (object == null) {
                boolean seen = estimate == null && !live.missingObjects().contains(marker.id());
                rows.add(new ObjectRow(marker.id(), seen ? ObjectRow.Mark.NO_FIGURE : ObjectRow.Mark.NOT_SEEN, null,
                        null, null, null));
            } else {
                rows.add(result != null ? judged(object, result) : preliminary(object, estimate));
            }
        }
        return rows;
    }

    private static ObjectRow preliminary(ObjectEstimate object, CellEstimate estimate) {
        if (estimate.isAmbiguous(object.id())) {
            return new ObjectRow(object.id(), ObjectRow.Mark.AMBIGUOUS, null, null, null, null);
        }
        return figures(object, ObjectRow.Mark.PRELIMINARY, estimate.largestDeviation(object.id()));
    }

    private static ObjectRow judged(ObjectEstimate object, CheckResult result) {
        switch (result.verdict(object.id())) {
            case PASS:
                return figures(object, ObjectRow.Mark.OK, result.finding(object.id()));
            case FAIL:
                return figures(object, ObjectRow.Mark.NOT_OK, result.finding(object.id()));
            case NO_TARGET:
                return figures(object, ObjectRow.Mark.NOT_JUDGED, result.finding(object.id()));
            case AMBIGUOUS:
                return new ObjectRow(object.id(), ObjectRow.Mark.AMBIGUOUS, null, null, null,
                        result.finding(object.id()));
            default:
                return new ObjectRow(object.id(), ObjectRow.Mark.NOT_CONVERGED, null, null, null, null);
        }
    }

    private static ObjectRow figures(ObjectEstimate object, ObjectRow.Mark mark, Reason reason) {
        return new ObjectRow(object.id(), mark, object.pose().std(),
                object.grip() == null ? null : object.grip().stdMm(), object.ellipse95Px(), reason);
    }

    /** What is drawn over the picture. */
    static Overlay overlay(Cell cell, LiveState live, CheckResult result, OverlayStyle style) {
        if (result != null) {
            return CellOverlay.of(result, style);
        }
        if (live.update() != null) {
            return CellOverlay.of(cell, live.keyFrame(), live.update(), style);
        }
        return CellOverlay.ofDetections(cell, live.detections(), Status.NEUTRAL, "", "", style);
    }
}
