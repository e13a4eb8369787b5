package org.cellgauge.android.camera;

import org.cellgauge.vision.MarkerObservation;

/** The upright rectangle around a marker in a frame. */
final class MarkerBox {

    private MarkerBox() {
    }

    /**
     * The rectangle around a marker.
     *
     * @param marker as it was seen
     * @return left, top, right, bottom, px
     */
    static double[] of(MarkerObservation marker) {
        double[] corners = marker.cornersPx();
        double[] box = {corners[0], corners[1], corners[0], corners[1]};
        for (int i = 2; i < corners.length; i += 2) {
            box[0] = Math.min(box[0], corners[i]);
            box[1] = Math.min(box[1], corners[i + 1]);
            box[2] = Math.max(box[2], corners[i]);
            box[3] = Math.max(box[3], corners[i + 1]);
        }
        return box;
    }
}
