package org.cellgauge.live;

import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.jspecify.annotations.Nullable;

/**
 * How a view has moved from one frame to another: as a whole, which a hand's tremor does, and by how much any marker
 * moved besides, which it does not. The whole is the similarity of least squares that takes the references' corners
 * from one frame to the other (Umeyama 1991, in the plane: one complex factor and one complex shift); of fewer than
 * three references, whose turn would be told by noise alone, their mean shift; without any, that of all objects.
 * Immutable.
 */
final class ViewMotion {
    /** References from which a turn and a change of size can be told. */
    private static final int FOR_A_TURN = 3;

    /** How far the whole has moved the marker that it moved most: root mean square over its corners, px; or NaN. */
    final double wholePx;
    /** How far the marker that moved most besides is from where the whole puts it, px; NaN as {@link #wholePx}. */
    final double besidesPx;
    /** Mean shift of all corners of the whole to the right, px. */
    final double shiftXPx;
    /** Mean shift of all corners of the whole downwards, px. */
    final double shiftYPx;

    private ViewMotion(double wholePx, double besidesPx, double shiftXPx, double shiftYPx) {
        this.wholePx = wholePx;
        this.besidesPx = besidesPx;
        this.shiftXPx = shiftXPx;
        this.shiftYPx = shiftYPx;
    }

    /** Means over corners, and what turn and size are fitted by. */
    private static final class Sums {
        private int corners;
        private int markers;
        private double fromX;
        private double fromY;
        private double toX;
        private double toY;
        private double square;
        private double real;
        private double imaginary;

        void add(@Nullable MarkerObservation a, @Nullable MarkerObservation b) {
            if (a == null || b == null) {
                return;
            }
            markers++;
            double[] p = a.cornersPx();
            double[] q = b.cornersPx();
            for (int i = 0; i < p.length; i += 2) {
                corners++;
                fromX += p[i];
                fromY += p[i + 1];
                toX += q[i];
                toY += q[i + 1];
                square += p[i] * p[i] + p[i + 1] * p[i + 1];
                real += p[i] * q[i] + p[i + 1] * q[i + 1];
                imaginary += p[i] * q[i + 1] - p[i + 1] * q[i];
            }
        }
    }

    /**
     * The motion between two frames.
     *
     * @param cell whose markers count
     * @param a one frame
     * @param b the other
     * @return NaN where they have no marker of the cell in common
     */
    static ViewMotion between(Cell cell, Detections a, Detections b) {
        Sums sums = new Sums();
        for (Reference reference : cell.references()) {
            sums.add(a.find(reference.id()), b.find(reference.id()));
        }
        boolean turns = sums.markers >= FOR_A_TURN;
        if (sums.markers == 0) {
            for (ObjectMarker object : cell.objects()) {
                sums.add(a.find(object.id()), b.find(object.id()));
            }
        }
        if (sums.markers == 0) {
            return new ViewMotion(Double.NaN, Double.NaN, 0, 0);
        }
        int n = sums.corners;
        double fromX = sums.fromX / n;
        double fromY = sums.fromY / n;
        double toX = sums.toX / n;
        double toY = sums.toY / n;
        double spread = sums.square - n * (fromX * fromX + fromY * fromY);
        double c = turns ? (sums.real - n * (fromX * toX + fromY * toY)) / spread : 1;
        double s = turns ? (sums.imaginary - n * (fromX * toY - fromY * toX)) / spread : 0;
        double[] most = {0, 0};
        for (Reference reference : cell.references()) {
            hold(a.find(reference.id()), b.find(reference.id()), fromX, fromY, toX, toY, c, s, most);
        }
        for (ObjectMarker object : cell.objects()) {
            hold(a.find(object.id()), b.find(object.id()), fromX, fromY, toX, toY, c, s, most);
        }
        return new ViewMotion(Math.sqrt(most[0]), Math.sqrt(most[1]), toX - fromX, toY - fromY);
    }

    /** Takes a marker into the largest mean squares of what the whole moves it by, and of what is besides. */
    private static void hold(@Nullable MarkerObservation a, @Nullable MarkerObservation b, double fromX, double fromY,
            double toX, double toY, double c, double s, double[] most) {
        if (a == null || b == null) {
            return;
        }
        double[] p = a.cornersPx();
        double[] q = b.cornersPx();
        double whole = 0;
        double besides = 0;
        for (int i = 0; i < p.length; i += 2) {
            double x = toX + c * (p[i] - fromX) - s * (p[i + 1] - fromY);
            double y = toY + s * (p[i] - fromX) + c * (p[i + 1] - fromY);
            whole += (x - p[i]) * (x - p[i]) + (y - p[i + 1]) * (y - p[i + 1]);
            besides += (x - q[i]) * (x - q[i]) + (y - q[i + 1]) * (y - q[i + 1]);
        }
        int corners = p.length / 2;
        most[0] = Math.max(most[0], whole / corners);
        most[1] = Math.max(most[1], besides / corners);
    }
}
