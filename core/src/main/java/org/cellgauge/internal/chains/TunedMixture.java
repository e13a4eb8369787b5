package org.cellgauge.internal.chains;

import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.internal.estimate.Matrices;
import org.cellgauge.internal.geometry.Rotations;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.NoiseBelief;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.sampling.ImportanceTuning;
import org.cellgauge.internal.sampling.LogDensity;
import org.cellgauge.internal.sampling.StudentTMixture;
import org.jspecify.annotations.Nullable;

/** Laplace's approximation at each mode as a t mixture in the centred chart about the heaviest, then tuned. */
public final class TunedMixture {
    private static final int DRAWS_PER_ROUND = 1000;
    private static final int START_TRIES = 1000;

    private TunedMixture() {
    }

    /**
     * Fits a mixture to a density by importance sampling.
     *
     * @param density up to a constant, in the chart of the mixture
     * @param start Laplace's approximation
     * @param random source of randomness
     * @return the fitted mixture and how well it fits
     */
    public static ImportanceTuning tune(LogDensity density, StudentTMixture start, RandomGenerator random) {
        return ImportanceTuning.tune(density, start, DRAWS_PER_ROUND, random);
    }

    /**
     * Laplace's approximation at each mode.
     *
     * @param modes heaviest first, not empty
     * @return a mixture in the centred chart about the first: position in mm, rotation vector in rad, unknown
     *     intrinsics, shared unknowns
     */
    public static StudentTMixture ofModes(List<PoseMode> modes) {
        return ofModes(modes, null);
    }

    /** The same with the added noise as the last coordinate, where there is a belief about it. */
    public static StudentTMixture ofModes(List<PoseMode> modes, @Nullable NoiseBelief belief) {
        PoseMode first = modes.get(0);
        int ofMode = first.dimension();
        int n = belief == null ? ofMode : ofMode + 1;
        double[] unknowns = first.state().unknowns;
        double[][] means = new double[modes.size()][];
        double[][] covariances = new double[modes.size()][];
        double[] weights = new double[modes.size()];
        for (int k = 0; k < modes.size(); k++) {
            PoseMode mode = modes.get(k);
            CameraState state = mode.state();
            means[k] = java.util.Arrays.copyOf(state.stepFrom(first.state()), n);
            for (int j = 0; j < unknowns.length; j++) {
                means[k][ofMode - unknowns.length + j] = state.unknowns[j] - unknowns[j];
            }
            double[] covariance = mode.covariance();
            if (k > 0) {
                covariance = moved(covariance, ofMode, means[k]);
            }
            covariances[k] = covariance;
            if (belief != null) {
                means[k][ofMode] = belief.mean() - first.state().noise;
                covariances[k] = new double[n * n];
                for (int i = 0; i < ofMode; i++) {
                    System.arraycopy(covariance, i * ofMode, covariances[k], i * n, ofMode);
                }
                covariances[k][n * n - 1] = belief.std() * belief.std();
            }
            weights[k] = Math.max(0.02, Math.exp(mode.logWeight() - first.logWeight()));
        }
        return new StudentTMixture(means, covariances, weights);
    }

    /** A covariance about a mode, in the coordinates of the chart in which that mode is at a rotation vector. */
    private static double[] moved(double[] covariance, int n, double[] at) {
        double[] j = new double[9];
        Rotations.inverseLeftJacobian(at[3], at[4], at[5], j);
        double[][] a = new double[n][n];
        for (int i = 0; i < n; i++) {
            a[i][i] = 1;
        }
        for (int r = 0; r < 3; r++) {
            System.arraycopy(j, 3 * r, a[3 + r], 3, 3);
        }
        double[][] out = new double[n][n];
        Matrices.addSandwich(a, covariance, n, out);
        double[] flat = new double[n * n];
        for (int i = 0; i < n; i++) {
            System.arraycopy(out[i], 0, flat, i * n, n);
        }
        return flat;
    }

    /** A start drawn from the mixture: wider than the target, and where its density is finite. */
    static double[] start(StudentTMixture mixture, LogDensity density, RandomGenerator random) {
        double[] x = new double[density.dimension()];
        for (int i = 0; i < START_TRIES; i++) {
            mixture.draw(x, random);
            if (density.at(x) > Double.NEGATIVE_INFINITY) {
                return x;
            }
        }
        return mixture.mean(0);
    }
}
