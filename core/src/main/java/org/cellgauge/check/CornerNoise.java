package org.cellgauge.check;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.cell.Cell;
import org.cellgauge.cell.ObjectMarker;
import org.cellgauge.cell.Reference;
import org.cellgauge.pose.MarkerPoseFinder;
import org.cellgauge.pose.PoseMode;
import org.cellgauge.vision.Detections;
import org.cellgauge.vision.MarkerObservation;
import org.cellgauge.warning.Decimal;
import org.cellgauge.warning.Warning;

/**
 * Corner noise estimated from how well each marker alone is a square: 8 coordinates, 6 unknowns, so 2 degrees of
 * freedom per marker, whatever the placement errors are. Immutable.
 *
 * <p>Where a marker has two poses, taking the one that fits better would take part of the noise for pose: of small
 * frontal markers a fifth of its squares. The likelihood of the noise is integrated over the pose instead, by Laplace's
 * method about each mode, {@code L(s) = s^-2 sum_k exp(-S_k / (2 s^2)) / sqrt(det J_k^T J_k)} per marker, S_k being the
 * mode's sum of squares; its maximum over all markers is where {@code s^2} is the mean of the S_k by the modes' weights
 * at s, over 2 (the restricted likelihood of Harville, "Maximum likelihood approaches to variance component
 * estimation", JASA 1977, with modes as in a mixture; found by expectation and maximisation in turn, Dempster, Laird
 * and Rubin 1977).
 */
final class CornerNoise {
    private static final int MOST_ROUNDS = 200;
    private static final double AGREEMENT = 1e-6;

    private final double stdPx;
    private final int markers;
    private final double relativeStd;

    private CornerNoise(double stdPx, int markers, double relativeStd) {
        this.stdPx = stdPx;
        this.markers = markers;
        this.relativeStd = relativeStd;
    }

    /** The noise of the markers of a cell that the photo shows; null where none tells anything. */
    static CornerNoise of(Cell cell, Detections detections) {
        List<List<PoseMode>> modes = new ArrayList<>();
        for (Reference r : cell.references()) {
            add(detections.find(r.id()), r.sizeMm(), cell, modes);
        }
        for (ObjectMarker o : cell.objects()) {
            add(detections.find(o.id()), o.sizeMm(), cell, modes);
        }
        double least = 0;
        for (List<PoseMode> ofMarker : modes) {
            double squares = Double.POSITIVE_INFINITY;
            for (PoseMode mode : ofMarker) {
                squares = Math.min(squares, 2 * mode.halfChiSquare());
            }
            least += squares;
        }
        double variance = least / (2.0 * Math.max(1, modes.size()));
        if (!(variance > 0)) {
            return null;
        }
        for (int round = 0; round < MOST_ROUNDS; round++) {
            double before = variance;
            double sum = 0;
            for (List<PoseMode> ofMarker : modes) {
                sum += squares(ofMarker, before)[0];
            }
            variance = sum / (2.0 * modes.size());
            if (Math.abs(variance / before - 1) < AGREEMENT) {
                break;
            }
        }
        // curvature of log L by log s: what weights leave open counts against it (Louis, JRSS B 1982)
        double information = 0;
        for (List<PoseMode> ofMarker : modes) {
            double[] squares = squares(ofMarker, variance);
            information += 2 * squares[0] / variance - squares[1] / (variance * variance);
        }
        return new CornerNoise(Math.sqrt(variance), modes.size(), 1 / Math.sqrt(Math.max(1, information)));
    }

    private static void add(MarkerObservation observation, double sizeMm, Cell cell, List<List<PoseMode>> modes) {
        if (observation != null) {
            List<PoseMode> found = MarkerPoseFinder.modes(observation.cornersPx(), sizeMm, cell.camera(), 1);
            if (!found.isEmpty()) {
                modes.add(found);
            }
        }
    }

    /**
     * Mean and variance of one marker's sum of squares over its modes, fitted at 1 px, by their weights at a variance.
     */
    private static double[] squares(List<PoseMode> modes, double variance) {
        double most = Double.NEGATIVE_INFINITY;
        for (PoseMode mode : modes) {
            most = Math.max(most, logWeight(mode, variance));
        }
        double sum = 0;
        double sumOfSquares = 0;
        double weights = 0;
        for (PoseMode mode : modes) {
            double weight = Math.exp(logWeight(mode, variance) - most);
            double squares = 2 * mode.halfChiSquare();
            weights += weight;
            sum += weight * squares;
            sumOfSquares += weight * squares * squares;
        }
        double mean = sum / weights;
        return new double[] {mean, sumOfSquares / weights - mean * mean};
    }

    private static double logWeight(PoseMode mode, double variance) {
        return mode.logWeight() + mode.halfChiSquare() - mode.halfChiSquare() / variance;
    }

    /** Standard deviation of each corner coordinate, px. */
    double stdPx() {
        return stdPx;
    }

    /** Standard deviation of that estimate, as a share of it. */
    double relativeStd() {
        return relativeStd;
    }

    /** What to tell the user. */
    Warning warning() {
        return Warning.of(CheckWarning.CORNER_NOISE_ESTIMATED, Decimal.of(stdPx, 3), 2 * markers,
                Decimal.of(100 * relativeStd, 0));
    }
}
