package org.cellgauge.android.state;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Target;
import org.cellgauge.check.CellEstimate;
import org.cellgauge.check.CheckResult;
import org.cellgauge.check.Reason;
import org.cellgauge.check.Verdict;
import org.cellgauge.internal.overlay.CellOverlay;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.internal.overlay.OverlayStyle;
import org.cellgauge.internal.overlay.Status;
import org.cellgauge.live.LiveState;
import org.cellgauge.output.ModeView;
import org.cellgauge.output.ResultRow;
import org.cellgauge.output.ResultView;

/** What the screen shows of a check: rows of the list, and the overlay. Every judgement is core's. */
public final class CheckFigures {
    private CheckFigures() {
    }

    /** The rows of all objects of a cell. */
    static List<ObjectRow> rows(Cell cell, Target target, LiveState live, CheckResult result, ResultView judged) {
        List<ObjectRow> rows = new ArrayList<>();
        CellEstimate estimate = live.update() == null ? null : live.update().estimate();
        ResultView view = result != null ? judged
                : estimate != null ? ResultView.preliminary(cell, estimate) : null;
        for (ObjectMarker marker : cell.objects()) {
            ResultRow object = view == null ? null : view.object(marker.id());
            if (object == null || !object.seen()) {
                boolean seen = view == null && !live.missingObjects().contains(marker.id());
                rows.add(none(marker.id(), seen ? ObjectRow.Mark.NO_FIGURE : ObjectRow.Mark.NOT_SEEN));
            } else {
                rows.add(result != null ? judged(marker.id(), target, view, result)
                        : preliminary(marker.id(), target, view, estimate));
            }
        }
        return rows;
    }

    private static ObjectRow preliminary(int id, Target target, ResultView view, CellEstimate estimate) {
        if (view.camera().ambiguous() || view.object(id).ambiguous()) {
            return ambiguous(id, view, null);
        }
        return figures(id, target, view, ObjectRow.Mark.PRELIMINARY, estimate.largestDeviation(id));
    }

    private static ObjectRow judged(int id, Target target, ResultView view, CheckResult result) {
        switch (result.verdict(id)) {
            case PASS:
                return figures(id, target, view, ObjectRow.Mark.OK, result.finding(id));
            case FAIL:
                return figures(id, target, view, ObjectRow.Mark.NOT_OK, result.finding(id));
            case NO_TARGET:
                return figures(id, target, view, ObjectRow.Mark.NOT_JUDGED, result.finding(id));
            case AMBIGUOUS:
                return ambiguous(id, view, result.finding(id));
            case CONTRADICTED:
                return none(id, ObjectRow.Mark.NO_FIGURE);
            default:
                return none(id, ObjectRow.Mark.NOT_CONVERGED);
        }
    }

    /**
     * What a stored result says of each of its objects.
     *
     * @param view of the result file
     * @return in the order of the cell, without reasons, which result files have in English alone
     */
    public static List<ObjectRow> rows(ResultView view) {
        List<ObjectRow> rows = new ArrayList<>();
        for (ResultRow object : view.objects()) {
            int id = object.id().getAsInt();
            if (!object.seen()) {
                rows.add(none(id, ObjectRow.Mark.NOT_SEEN));
            } else if (view.verdict() == Verdict.AMBIGUOUS) {
                rows.add(ambiguous(id, view, null));
            } else if (!view.trusted()) {
                rows.add(none(id, view.showsFigures() ? ObjectRow.Mark.NOT_CONVERGED : ObjectRow.Mark.NO_FIGURE));
            } else {
                Boolean within = object.withinTarget();
                rows.add(figures(id, view.target(), view, within == null ? ObjectRow.Mark.NOT_JUDGED
                        : within ? ObjectRow.Mark.OK : ObjectRow.Mark.NOT_OK, null));
            }
        }
        return rows;
    }

    private static ObjectRow none(int id, ObjectRow.Mark mark) {
        return new ObjectRow(id, mark, null, null, null, null, null, Collections.emptyList());
    }

    private static ObjectRow ambiguous(int id, ResultView view, Reason reason) {
        List<Double> shares = new ArrayList<>();
        for (ModeView mode : view.object(id).modes()) {
            shares.add(mode.weight());
        }
        return new ObjectRow(id, ObjectRow.Mark.AMBIGUOUS, null, null, null, reason, null, shares);
    }

    private static ObjectRow figures(int id, Target target, ResultView view, ObjectRow.Mark mark, Reason reason) {
        ResultRow grip = view.grip(id);
        return new ObjectRow(id, mark, view.object(id).std(), grip == null ? null : grip.std(),
                view.object(id).ellipse95Px(), reason, TargetUse.of(target.of(id), view.object(id), grip),
                Collections.emptyList());
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
