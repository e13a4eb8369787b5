package org.cellgauge.output;

import org.cellgauge.internal.statistics.Angles;
import org.jspecify.annotations.Nullable;

/**
 * Laplace's approximation of a pose or point, and what the chains make of it; immutable. Arrays in the order of the
 * row's mean.
 */
public final class LaplaceView extends Value {
    private final double[] mean;
    private final double[] std;
    private final double[] meanShiftByStd;
    private final double[] sampledByLaplace;

    LaplaceView(double[] mean, double[] std, double[] meanShiftByStd, double[] sampledByLaplace) {
        this.mean = Figures.finite(mean);
        this.std = Figures.finite(std);
        this.meanShiftByStd = Figures.finite(meanShiftByStd);
        this.sampledByLaplace = Figures.finite(sampledByLaplace);
    }

    /** A comparison; places from 3 on are angles. */
    static LaplaceView of(double[] mean, double[] std, double[] sampledMean, double[] sampledStd) {
        double[] ratio = new double[std.length];
        double[] shift = new double[std.length];
        for (int i = 0; i < ratio.length; i++) {
            ratio[i] = sampledStd[i] / std[i];
            double moved = sampledMean[i] - mean[i];
            shift[i] = (i < 3 ? moved : Angles.wrapToPi(moved)) / std[i];
        }
        return new LaplaceView(mean, std, shift, ratio);
    }

    /**
     * Its mean.
     *
     * @return mm, then rad in (-pi, pi]; a new array
     */
    public double[] mean() {
        return mean.clone();
    }

    /**
     * Its standard deviations.
     *
     * @return mm, then rad; a new array
     */
    public double[] std() {
        return std.clone();
    }

    /**
     * How far the chains' means are from it.
     *
     * @return in its standard deviations; a new array
     */
    public double[] meanShiftByStd() {
        return meanShiftByStd.clone();
    }

    /**
     * How many times as large the chains' standard deviations are.
     *
     * @return positive; a new array
     */
    public double[] sampledByLaplace() {
        return sampledByLaplace.clone();
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {mean, std, meanShiftByStd, sampledByLaplace};
    }
}
