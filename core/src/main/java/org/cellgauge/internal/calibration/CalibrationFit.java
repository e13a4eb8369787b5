package org.cellgauge.internal.calibration;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.cellgauge.geometry.PinholeCamera;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.vision.TargetObservation;
import org.cellgauge.vision.TargetPoints;
import org.jspecify.annotations.Nullable;

/** Lens, board and poses fitted to photos, outliers left out; not changed once it is made. */
final class CalibrationFit {
    /** Points beyond so many deviations make the fit look for outliers. */
    static final double TRIGGER = 5;
    /** Points beyond so many deviations are left out then. */
    static final double LEFT_OUT = 4;
    private static final int ROUNDS = 8;
    private static final double FIRST_STD_PX = 0.3;
    /** Median length of a vector of two normal errors of deviation 1. */
    private static final double MEDIAN_LENGTH = Math.sqrt(2 * Math.log(2));
    /** Focal lengths to start from where homographies tell none, in widths of the image. */
    private static final double[] FOCALS = {0.45, 0.8, 1.3, 2.2};

    final LensChoice choice;
    final BoardShape board;
    final TargetPoints points;
    final List<TargetPhoto> photos;
    final double[] values;
    final double stdPx;
    final double[] information;
    /** Of the unknowns of lens and board; null where the photos do not determine them. */
    final double @Nullable [] covariance;
    final int globals;
    private final BundleAdjustment adjustment;

    private CalibrationFit(LensChoice choice, BoardShape board, TargetPoints points, List<TargetPhoto> photos,
            double[] start, double startStdPx) {
        this.choice = choice;
        this.board = board;
        this.points = points;
        this.photos = photos;
        adjustment = new BundleAdjustment(choice, board, photos, start, startStdPx);
        globals = adjustment.globals();
        adjustment.solve();
        for (int round = 0; round < ROUNDS && leaveOut(); round++) {
            adjustment.solve();
        }
        double std = noisePx();
        adjustment.setStdPx(std);
        if (board.unknowns() > 0 || photos.get(0).outwards != null) {
            // priors weigh against the noise, which is known only now
            adjustment.solve();
            adjustment.setStdPx(noisePx());
        }
        stdPx = adjustment.stdPx();
        values = adjustment.values();
        information = adjustment.information();
        covariance = Cholesky.inverse(information, globals);
    }

    /** Fits from nothing. */
    static CalibrationFit of(LensChoice choice, TargetPoints points, List<TargetObservation> seen, int warp,
            boolean aspect) {
        int width = seen.get(0).widthPx();
        int height = seen.get(0).heightPx();
        BoardShape flat = new BoardShape(points, 0, false);
        List<TargetPhoto> photos = new ArrayList<>();
        seen.forEach(s -> photos.add(new TargetPhoto(s, points.areCornersOfMarkers())));
        LensChoice first = choice.first();
        List<Double> focals = new ArrayList<>();
        double told = TargetPoses.focalPx(points, photos, width, height);
        if (told > width * 0.1 && told < width * 50) {
            focals.add(told);
        }
        for (double f : FOCALS) {
            focals.add(f * width);
        }
        double best = Double.POSITIVE_INFINITY;
        double[] start = {};
        List<TargetPhoto> from = photos;
        for (double focal : focals) {
            double[] values = TargetPoses.values(choice.lens(), flat, focal, width, height);
            TargetPoses poses = new TargetPoses(points, flat, first);
            List<TargetPhoto> at = photos.stream().map(TargetPhoto::copy).toList();
            double cost = 0;
            for (TargetPhoto photo : at) {
                cost += poses.find(photo, values);
            }
            if (cost < best) {
                best = cost;
                start = values;
                from = at;
            }
            if (focal == told && cost < Double.POSITIVE_INFINITY) {
                // the others are for where this one fails
                break;
            }
        }
        BundleAdjustment rough = new BundleAdjustment(first, flat, from, start.length == 0
                ? TargetPoses.values(choice.lens(), flat, width, width, height) : start, FIRST_STD_PX);
        rough.solve();
        BoardShape board = new BoardShape(points, warp, aspect);
        return new CalibrationFit(choice, board, points, from,
                Arrays.copyOf(rough.values(), choice.lens().parameterCount() + board.unknowns()), FIRST_STD_PX);
    }

    /** Fits some of this fit's photos, from where it stands and without what it has left out. */
    CalibrationFit ofPhotos(LensChoice other, BoardShape shape, List<Integer> which) {
        List<TargetPhoto> some = which.stream().map(i -> photos.get(i).copy()).toList();
        int parameters = other.lens().parameterCount();
        double[] start = new double[parameters + shape.unknowns()];
        System.arraycopy(values, 0, start, 0, PinholeCamera.SKEW + 1);
        if (other.lens().isWide() == choice.lens().isWide()) {
            // coefficients of one name mean the same in all lenses that are not wide
            for (int u = 0; u < other.unknowns(); u++) {
                int from = choice.lens().parameterNames().indexOf(
                        other.lens().parameterNames().get(other.parameter(u)));
                if (from >= 0) {
                    start[other.parameter(u)] = values[from];
                }
            }
        }
        if (shape == board) {
            System.arraycopy(values, choice.lens().parameterCount(), start, parameters, board.unknowns());
        }
        return new CalibrationFit(other, shape, points, some, start, stdPx);
    }

    /** Sum of squared errors in photos that this fit has not seen, their poses fitted; px². */
    double heldOut(List<TargetPhoto> others) {
        TargetPoses poses = new TargetPoses(points, board, choice);
        double sum = 0;
        for (TargetPhoto photo : others) {
            sum += poses.refine(photo.copy(), values);
        }
        return sum;
    }

    double[] residuals(TargetPhoto photo) {
        return adjustment.residuals(photo);
    }

    /** Information about lens and board that a photo at its pose would add. */
    double[] informationOf(TargetPhoto photo) {
        BundleAdjustment alone = new BundleAdjustment(choice, board, List.of(photo), values, stdPx);
        double cost = alone.linearise(new double[globals * globals], new double[globals]);
        return Double.isFinite(cost) ? photo.reduced.clone() : new double[globals * globals];
    }

    /** Deviation of a coordinate from what is left over, px. */
    private double noisePx() {
        double sum = 0;
        int freedom = -globals;
        for (TargetPhoto photo : photos) {
            double[] errors = adjustment.residuals(photo);
            freedom -= photo.activeCount() >= 4 ? adjustment.locals() : 0;
            for (int i = 0; i < photo.count; i++) {
                if (photo.active[i]) {
                    sum += errors[2 * i] * errors[2 * i] + errors[2 * i + 1] * errors[2 * i + 1];
                    freedom += 2;
                }
            }
        }
        return Math.max(1e-6, Math.sqrt(sum / Math.max(1, freedom)));
    }

    /** Leaves out points that are too far off; whether there were any. */
    private boolean leaveOut() {
        List<Double> lengths = new ArrayList<>();
        List<double[]> errors = new ArrayList<>();
        int freedom = -globals;
        for (TargetPhoto photo : photos) {
            double[] e = adjustment.residuals(photo);
            errors.add(e);
            freedom -= adjustment.locals();
            for (int i = 0; i < photo.count; i++) {
                if (photo.active[i]) {
                    lengths.add(Math.hypot(e[2 * i], e[2 * i + 1]));
                    freedom += 2;
                }
            }
        }
        if (lengths.isEmpty()) {
            return false;
        }
        lengths.sort(null);
        double std = lengths.get(lengths.size() / 2) / MEDIAN_LENGTH
                * Math.sqrt(2.0 * lengths.size() / Math.max(1, freedom));
        adjustment.setStdPx(Math.max(1e-6, std));
        if (!(lengths.get(lengths.size() - 1) > TRIGGER * std)) {
            return false;
        }
        for (int p = 0; p < photos.size(); p++) {
            TargetPhoto photo = photos.get(p);
            double[] e = errors.get(p);
            for (int i = 0; i < photo.count; i++) {
                if (photo.active[i] && !(Math.hypot(e[2 * i], e[2 * i + 1]) <= LEFT_OUT * std)) {
                    leaveOut(photo, i);
                }
            }
        }
        return true;
    }

    /** A marker goes as a whole: its corners share what went wrong. */
    private static void leaveOut(TargetPhoto photo, int point) {
        if (photo.outwards == null) {
            photo.active[point] = false;
            return;
        }
        for (int k = 0; k < 4; k++) {
            photo.active[point / 4 * 4 + k] = false;
        }
    }
}
