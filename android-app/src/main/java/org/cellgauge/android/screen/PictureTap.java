package org.cellgauge.android.screen;

import java.util.OptionalInt;
import org.cellgauge.android.state.CheckScreenState;
import org.cellgauge.android.state.ObjectRow;
import org.cellgauge.internal.overlay.ImageOrientation;
import org.cellgauge.internal.overlay.ViewFit;
import org.cellgauge.live.LiveState;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;

/** Which object of the cell a finger means. */
final class PictureTap {
    private PictureTap() {
    }

    /**
     * The object at a point of the picture.
     *
     * @param s what is shown
     * @param x of the point, px of the view that the picture fills
     * @param y of the point
     * @param viewWidth width of that view, px
     * @param viewHeight its height
     * @param reachPx how far a finger may miss a marker's middle, px of the view
     * @return marker id; empty where no object is near
     */
    static OptionalInt objectAt(CheckScreenState s, double x, double y, int viewWidth, int viewHeight,
            double reachPx) {
        LiveState live = s.live();
        if (live == null || viewWidth <= 0 || viewHeight <= 0) {
            return OptionalInt.empty();
        }
        Detections frame = live.keyFrame() != null ? live.keyFrame() : live.detections();
        ImageOrientation turned = s.orientation();
        ViewFit fit = ViewFit.centreCrop(turned.uprightWidthPx(frame.widthPx(), frame.heightPx()),
                turned.uprightHeightPx(frame.widthPx(), frame.heightPx()), viewWidth, viewHeight);
        OptionalInt nearest = OptionalInt.empty();
        double least = Double.POSITIVE_INFINITY;
        for (ObjectRow row : s.objects()) {
            MarkerObservation marker = frame.find(row.id());
            if (marker == null) {
                continue;
            }
            double[] corners = marker.cornersPx();
            double u = 0;
            double v = 0;
            for (int i = 0; i < corners.length; i += 2) {
                u += 2 * corners[i] / corners.length;
                v += 2 * corners[i + 1] / corners.length;
            }
            double[] upright = turned.map(u, v, frame.widthPx(), frame.heightPx());
            double[] at = fit.toView(upright[0], upright[1]);
            double distance = Math.hypot(at[0] - x, at[1] - y);
            if (distance < least && distance <= Math.max(reachPx, fit.scale() * marker.shortestSidePx())) {
                least = distance;
                nearest = OptionalInt.of(row.id());
            }
        }
        return nearest;
    }
}
