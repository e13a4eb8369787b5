package org.cellgauge.android.camera;

import java.util.Arrays;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.GreyImage;
import org.cellgauge.vision.MarkerObservation;

/** How bright the markers' white is in a frame, by which a change of the light is noticed. */
final class MarkerWhite {
    /** Points looked at along each side of a marker's rectangle. */
    private static final int POINTS = 16;
    /** Share of them that is brighter than what counts as white: glints, and what lies behind a turned marker. */
    private static final double BRIGHTER_SHARE = 0.1;
    private static final int GREYS = 256;

    private MarkerWhite() {
    }

    /**
     * The mean over the markers of what is white on each.
     *
     * @param frame the frame
     * @param seen its markers
     * @return grey value, 0 to 255; NaN where there is no marker
     */
    static double of(GreyImage frame, Detections seen) {
        double sum = 0;
        int[] counts = new int[GREYS];
        for (MarkerObservation marker : seen.markers()) {
            sum += whiteOf(frame, MarkerBox.of(marker), counts);
        }
        return sum / seen.markers().size();
    }

    private static int whiteOf(GreyImage frame, double[] box, int[] counts) {
        Arrays.fill(counts, 0);
        for (int i = 0; i < POINTS; i++) {
            int y = within(box[1] + (i + 0.5) / POINTS * (box[3] - box[1]), frame.heightPx());
            for (int k = 0; k < POINTS; k++) {
                int x = within(box[0] + (k + 0.5) / POINTS * (box[2] - box[0]), frame.widthPx());
                counts[frame.get(x, y)]++;
            }
        }
        int left = (int) (BRIGHTER_SHARE * POINTS * POINTS);
        int grey = GREYS - 1;
        while (grey > 0 && counts[grey] <= left) {
            left -= counts[grey];
            grey--;
        }
        return grey;
    }

    private static int within(double px, int size) {
        return (int) Math.max(0, Math.min(size - 1, px));
    }
}
