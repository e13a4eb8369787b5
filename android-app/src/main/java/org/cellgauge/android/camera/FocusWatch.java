package org.cellgauge.android.camera;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;

/**
 * When the focus is to be searched again: the markers are nearer or farther than when it was, elsewhere, or less sharp.
 * Only a view that holds still counts, since a scan of one that moves finds nothing, and none soon after the last.
 */
final class FocusWatch {
    /** Markers that have grown or shrunk by so much stand at another distance. */
    static final double SCALE_SHARE = 0.15;
    /** Markers that have moved by so much of the picture's longer side leave another part of the cell in view. */
    static final double MOVED_SHARE = 0.25;
    /** Blur that counts, as a multiple of the smallest since the last scan, and besides, px. */
    static final double BLUR_TIMES = 1.5;
    static final double BLUR_PX = 0.3;
    /** From frame to frame a view that is held still moves by so much of the picture's longer side at most. */
    static final double STILL_SHARE = 0.01;
    /** So many frames in a row must show it. */
    static final int FRAMES = 5;
    /** From one scan to the next, ns. */
    static final long PAUSE_NS = 3_000_000_000L;

    private boolean scanned;
    private long scannedNs;
    /** What the first frame after the last scan showed; null before there was one with markers. */
    private Detections reference;
    private double smallestBlurPx;
    private Detections last;
    private int frames;

    /**
     * A scan has ended, or will never.
     *
     * @param timeNs when; of the clock of frames
     */
    void scanned(long timeNs) {
        scanned = true;
        scannedNs = timeNs;
        reference = null;
        smallestBlurPx = Double.POSITIVE_INFINITY;
        last = null;
        frames = 0;
    }

    /**
     * A frame was looked at.
     *
     * @param seen its markers
     * @param timeNs of its exposure
     * @return whether the focus is to be searched again
     */
    boolean isDue(Detections seen, long timeNs) {
        Detections before = last;
        last = seen;
        if (!scanned || seen.markers().isEmpty()) {
            frames = 0;
            return false;
        }
        double blurPx = seen.light() == null ? Double.NaN : seen.light().blurPx();
        smallestBlurPx = blurPx < smallestBlurPx ? blurPx : smallestBlurPx;
        if (reference == null) {
            reference = seen;
            return false;
        }
        boolean blurred = blurPx > BLUR_TIMES * smallestBlurPx + BLUR_PX;
        boolean counts = before != null && isStill(before, seen) && (blurred || isAnotherView(seen));
        frames = counts ? frames + 1 : 0;
        return frames >= FRAMES && timeNs - scannedNs >= PAUSE_NS;
    }

    private boolean isAnotherView(Detections seen) {
        double[] motion = motion(reference, seen);
        return motion == null || motion[0] > MOVED_SHARE || Math.abs(Math.log(motion[1])) > Math.log1p(SCALE_SHARE);
    }

    private static boolean isStill(Detections before, Detections seen) {
        double[] motion = motion(before, seen);
        return motion != null && motion[0] <= STILL_SHARE;
    }

    /**
     * How the markers that two frames have in common have moved.
     *
     * @return by how much of the picture's longer side on average, and how many times as large they are in geometric
     *     mean; null where there are none
     */
    private static double[] motion(Detections from, Detections to) {
        List<MarkerObservation[]> common = new ArrayList<>();
        for (MarkerObservation marker : to.markers()) {
            if (from.find(marker.id()) != null) {
                common.add(new MarkerObservation[] {from.find(marker.id()), marker});
            }
        }
        if (common.isEmpty()) {
            return null;
        }
        double x = 0;
        double y = 0;
        double growth = 0;
        for (MarkerObservation[] pair : common) {
            double[] a = MarkerBox.of(pair[0]);
            double[] b = MarkerBox.of(pair[1]);
            x += (b[0] + b[2] - a[0] - a[2]) / 2 / common.size();
            y += (b[1] + b[3] - a[1] - a[3]) / 2 / common.size();
            growth += Math.log(Math.hypot(b[2] - b[0], b[3] - b[1]) / Math.hypot(a[2] - a[0], a[3] - a[1]))
                    / common.size();
        }
        return new double[] {Math.hypot(x, y) / Math.max(to.widthPx(), to.heightPx()), Math.exp(growth)};
    }
}
