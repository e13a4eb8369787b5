package org.cellgauge.live;

import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.jspecify.annotations.Nullable;

/** How far two frames are apart, and how far they may be while the camera counts as held still. */
final class Stillness {
    /** What a hand's tremor moves corners by, px per image width of {@value #AT_WIDTH_PX} px. */
    private static final double TREMOR_PX = 3;
    private static final double AT_WIDTH_PX = 1280;
    /** A difference of two noisy coordinates has sqrt(2) times the noise; six of its deviations are never reached. */
    private static final double NOISE_FACTOR = 6 * Math.sqrt(2);

    /** What a hand moves a view by at most, as a share of the picture. */
    private static final double VIEW_SHARE = 0.03;
    /** Objects stand nearer to the camera than references by so much of their distance, or less. */
    private static final double PARALLAX_SHARE = 0.2;

    private Stillness() {
    }

    /**
     * How far a marker may move while the drawn figures still lie on it.
     *
     * @param frame gives the image size; its longer side counts
     * @param pixelStdPx standard deviation of each corner coordinate, px
     * @return px
     */
    static double tolerancePx(Detections frame, double pixelStdPx) {
        return Math.max(TREMOR_PX * Math.max(frame.widthPx(), frame.heightPx()) / AT_WIDTH_PX,
                NOISE_FACTOR * pixelStdPx);
    }

    /**
     * How far the view as a whole may move while it counts as the same one: as long as the outlines of its markers lie
     * over each other, and no farther than a hand moves it that means to hold it still. Figures do not change by that:
     * they are about where the camera stands, to within a per cent or two of its distance.
     *
     * @param frame the key frame
     * @param cell whose markers count
     * @param tolerancePx as {@link #tolerancePx}; never less than that
     * @return px
     */
    static double viewTolerancePx(Detections frame, Cell cell, double tolerancePx) {
        double side = Double.POSITIVE_INFINITY;
        for (Reference reference : cell.references()) {
            MarkerObservation seen = frame.find(reference.id());
            side = seen == null ? side : Math.min(side, seen.shortestSidePx());
        }
        return Math.max(tolerancePx, Math.min(side, VIEW_SHARE * Math.max(frame.widthPx(), frame.heightPx())));
    }

    /**
     * How far a marker may be from where the motion of the whole puts it.
     *
     * @param tolerancePx as {@link #tolerancePx}
     * @param wholePx how far the whole has moved: markers nearer to the camera move farther
     * @return px
     */
    static double besidesPx(double tolerancePx, double wholePx) {
        return tolerancePx + PARALLAX_SHARE * wholePx;
    }

    /**
     * Root mean square distance of corresponding corners of the marker of the cell that moved most. The most, because
     * an object that alone was moved makes its figures wrong, however many others stand still.
     *
     * @return px; NaN where the frames have no marker of the cell in common
     */
    static double displacementPx(Cell cell, Detections a, Detections b) {
        double most = Double.NaN;
        for (Reference reference : cell.references()) {
            most = larger(most, displacementPx(a.find(reference.id()), b.find(reference.id())));
        }
        for (ObjectMarker object : cell.objects()) {
            most = larger(most, displacementPx(a.find(object.id()), b.find(object.id())));
        }
        return most;
    }

    private static double larger(double most, double other) {
        return other > most || Double.isNaN(most) ? other : most;
    }

    private static double displacementPx(@Nullable MarkerObservation a, @Nullable MarkerObservation b) {
        if (a == null || b == null) {
            return Double.NaN;
        }
        double[] p = a.cornersPx();
        double[] q = b.cornersPx();
        double sum = 0;
        for (int i = 0; i < p.length; i++) {
            sum += (p[i] - q[i]) * (p[i] - q[i]);
        }
        int corners = p.length / 2;
        return Math.sqrt(sum / corners);
    }
}
