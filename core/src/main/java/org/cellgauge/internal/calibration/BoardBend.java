package org.cellgauge.internal.calibration;

import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.cellgauge.calibration.CalibrationOptions;
import org.cellgauge.internal.geometry.Cholesky;
import org.jspecify.annotations.Nullable;

/**
 * Whether a board is bent in a way that a fit does not model; immutable. Odd and even photos show the same board and
 * err alike, so that they do not tell; what tells is that errors follow the bend from photo to photo as its view
 * changes.
 *
 * <p>The fit is made again with all coefficients of the warp unknown, and those it lacked are tested against zero
 * together (Wald's test: chi-square with as many degrees of freedom), their covariance widened by what odd and even
 * photos differ beyond chance.
 */
final class BoardBend {
    /** Share of flat boards that are called bent, at most. */
    private static final double FALSE_ALARMS = 1e-3;

    private final double pValue;
    private final double heightMm;
    private final double stdMm;

    private BoardBend(double pValue, double heightMm, double stdMm) {
        this.pValue = pValue;
        this.heightMm = heightMm;
        this.stdMm = stdMm;
    }

    /**
     * Tests a fit's board.
     *
     * @param crossRatio difference of odd and even photos over its stated deviation; NaN where unknown
     * @return null where the fit lacks no coefficient, or photos do not determine them
     */
    static @Nullable BoardBend of(CalibrationFit fit, double crossRatio) {
        int first = fit.board.warp;
        int lacking = CalibrationOptions.MOST_WARP - first;
        if (lacking == 0) {
            return null;
        }
        CalibrationFit full = fit.ofPhotos(fit.choice,
                new BoardShape(fit.points, CalibrationOptions.MOST_WARP, fit.board.aspect),
                IntStream.range(0, fit.photos.size()).boxed().toList());
        double[] all = full.covariance;
        if (all == null) {
            return null;
        }
        double scatter = crossRatio > 1 ? crossRatio * crossRatio : 1;
        double[] covariance = new double[lacking * lacking];
        double[] whitened = new double[lacking];
        int values = full.choice.lens().parameterCount() + first;
        int unknowns = full.choice.unknowns() + first;
        double height = 0;
        double variance = 0;
        for (int a = 0; a < lacking; a++) {
            whitened[a] = full.values[values + a];
            for (int b = 0; b < lacking; b++) {
                covariance[a * lacking + b] = scatter * all[(unknowns + a) * full.globals + unknowns + b];
            }
            if (Math.abs(whitened[a]) > height) {
                height = Math.abs(whitened[a]);
                variance = covariance[a * (lacking + 1)];
            }
        }
        if (!Cholesky.factor(covariance, lacking)) {
            return null;
        }
        Cholesky.solveLower(covariance, lacking, whitened);
        double statistic = 0;
        for (double w : whitened) {
            statistic += w * w;
        }
        return new BoardBend(1 - new ChiSquaredDistribution(null, lacking).cumulativeProbability(statistic), height,
                Math.sqrt(variance));
    }

    boolean isThere() {
        return pValue < FALSE_ALARMS;
    }

    /** The largest coefficient that the fit lacks, mm. */
    double heightMm() {
        return heightMm;
    }

    /** Its standard deviation, mm. */
    double stdMm() {
        return stdMm;
    }
}
