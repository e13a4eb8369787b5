package org.cellgauge.android.camera;

import android.graphics.Rect;
import android.hardware.camera2.params.MeteringRectangle;
import java.util.ArrayList;
import java.util.List;
import org.cellgauge.internal.geometry.PixelArea;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;

/**
 * Where light is metered and the focus searched: at the markers that were seen last, each with its white margin. What
 * is around them, a dark table or a bright window, does not count.
 */
final class MeteringAreas {
    /** The margin around a marker's black, as a share of its size. */
    private static final double MARGIN_SHARE = 0.2;
    /** Areas that have moved by less of the sensor's width are left where they are. */
    private static final double MOVED_SHARE = 0.04;

    private MeteringAreas() {
    }

    /**
     * The areas of a frame's markers on the sensor, in the coordinates that a request has: of the area that frames come
     * from, which counts from its own upper left corner.
     *
     * @param seen the markers of a frame that is cut out of the middle of that area in its own shape
     * @param whole the area, px of the sensor
     * @param most how many areas the camera takes; the largest markers are chosen
     * @return the areas; empty where there are no markers, or none is taken
     */
    static List<MeteringRectangle> of(Detections seen, PixelArea whole, int most) {
        PixelArea shown = new PixelArea(0, 0, whole.widthPx(), whole.heightPx())
                .centreCrop(seen.widthPx(), seen.heightPx());
        double scale = shown.widthPx() / seen.widthPx();
        List<MarkerObservation> markers = new ArrayList<>(seen.markers());
        markers.sort((a, b) -> Double.compare(b.shortestSidePx(), a.shortestSidePx()));
        List<MeteringRectangle> areas = new ArrayList<>();
        for (MarkerObservation marker : markers) {
            double[] box = MarkerBox.of(marker);
            double marginX = MARGIN_SHARE * (box[2] - box[0]);
            double marginY = MARGIN_SHARE * (box[3] - box[1]);
            Rect area = new Rect((int) Math.round(shown.leftPx() + scale * (box[0] - marginX)),
                    (int) Math.round(shown.topPx() + scale * (box[1] - marginY)),
                    (int) Math.round(shown.leftPx() + scale * (box[2] + marginX)),
                    (int) Math.round(shown.topPx() + scale * (box[3] + marginY)));
            boolean inside = area.intersect(0, 0, (int) whole.widthPx() - 1, (int) whole.heightPx() - 1);
            if (inside && areas.size() < most) {
                areas.add(new MeteringRectangle(area, MeteringRectangle.METERING_WEIGHT_MAX));
            }
        }
        return areas;
    }

    /**
     * Whether areas lie elsewhere than others: a request of its own for every tremor would keep the camera busy.
     *
     * @param before those in force
     * @param now those of the newest frame
     * @param whole as in {@link #of}
     * @return whether it is worth telling the camera
     */
    static boolean differ(List<MeteringRectangle> before, List<MeteringRectangle> now, PixelArea whole) {
        if (before.size() != now.size()) {
            return true;
        }
        double far = MOVED_SHARE * whole.widthPx();
        for (MeteringRectangle area : now) {
            boolean kept = before.stream().anyMatch(b -> Math.abs(b.getX() - area.getX()) <= far
                    && Math.abs(b.getY() - area.getY()) <= far && Math.abs(b.getWidth() - area.getWidth()) <= far
                    && Math.abs(b.getHeight() - area.getHeight()) <= far);
            if (!kept) {
                return true;
            }
        }
        return false;
    }
}
