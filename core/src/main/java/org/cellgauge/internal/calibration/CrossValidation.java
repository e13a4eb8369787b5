package org.cellgauge.internal.calibration;

import java.util.List;

/**
 * Odd photos against even ones: two calibrations that share no corner, their difference over the image held against
 * what their own covariances say of it. Chance alone gives a ratio of about 1; a lens or a board that is none of the
 * model's does not err alike in both.
 */
final class CrossValidation {
    private final double ratio;
    private final double[] differencePx;
    private final double[] stdPx;

    private CrossValidation(double ratio, double[] differencePx, double[] stdPx) {
        this.ratio = ratio;
        this.differencePx = differencePx;
        this.stdPx = stdPx;
    }

    /** Calibrates two parts of a fit's photos; a ratio of NaN where they are too few. */
    static CrossValidation of(CalibrationFit fit, ProjectionMap map, List<Integer> odd, List<Integer> even) {
        CrossValidation none = new CrossValidation(Double.NaN, new double[0], new double[0]);
        if (fit.photos.size() < CameraCalibrator.FEWEST_FOR_HALVES) {
            return none;
        }
        CalibrationFit a = fit.ofPhotos(fit.choice, fit.board, odd);
        CalibrationFit b = fit.ofPhotos(fit.choice, fit.board, even);
        double[] of = a.covariance;
        double[] and = b.covariance;
        if (of == null || and == null) {
            return none;
        }
        double[] covariance = new double[of.length];
        for (int i = 0; i < covariance.length; i++) {
            covariance[i] = of[i] + and[i];
        }
        double[] shifts = map.difference(a.values, b.values);
        double[] lengths = new double[map.u.length];
        double[] stds = new double[map.u.length];
        double top = 0;
        double bottom = 0;
        for (int k = 0; k < lengths.length; k++) {
            lengths[k] = Math.hypot(shifts[2 * k], shifts[2 * k + 1]);
            double[] c = map.covariance(k, covariance, fit.globals);
            stds[k] = Math.sqrt(c[0] + c[2]);
            if (map.seen[k] && !Double.isNaN(lengths[k])) {
                top += map.weight[k] * lengths[k] * lengths[k];
                bottom += map.weight[k] * stds[k] * stds[k];
            }
        }
        return new CrossValidation(Math.sqrt(top / bottom), lengths, stds);
    }

    /** Root mean square difference over the covered image in units of its stated deviation. */
    double ratio() {
        return ratio;
    }

    double differencePx(int place) {
        return Double.isNaN(ratio) ? Double.NaN : differencePx[place];
    }

    double ratio(int place) {
        return Double.isNaN(ratio) ? Double.NaN : differencePx[place] / stdPx[place];
    }
}
