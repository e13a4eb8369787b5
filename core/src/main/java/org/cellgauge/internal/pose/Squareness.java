package org.cellgauge.internal.pose;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What four corners say of their own noise: 8 coordinates less the 6 of a pose leave 2 that no pose explains;
 * immutable.
 *
 * <p>The likelihood of the noise integrated over the pose by Laplace's method about each mode (restricted likelihood:
 * Harville, "Maximum likelihood approaches to variance component estimation", JASA 1977). With N an orthonormal basis
 * of what the pose's derivative J leaves and z = N^T r it is, for any covariance S of the corners,
 * {@code |J^T J|^-1/2 |N^T S N|^-1/2 exp(-z^T (N^T S N)^-1 z / 2)}: two numbers per mode instead of a fit per S.
 */
final class Squareness {
    private final double[] logVolume;
    private final double[] z;
    private final double[] left;
    /** Asked for again and again; of the noise that was asked for last. */
    private volatile @Nullable Table table;

    /** Logarithms of the likelihood by the node of a noise. */
    private static final class Table {
        private final AddedNoise noise;
        private final double[] logLikelihoods = new double[AddedNoise.NODES];

        Table(AddedNoise noise, Squareness of) {
            this.noise = noise;
            for (int node = 0; node < logLikelihoods.length; node++) {
                logLikelihoods[node] = of.logLikelihood(noise.variancePx2AtNode(node), 1);
            }
        }
    }

    /**
     * Reads squareness off the modes of a marker.
     *
     * @param modes fitted with unit weights, not empty
     * @param covariancePx2 8x8, px², what is known of the corners' errors
     */
    Squareness(List<PoseMode> modes, double[] covariancePx2) {
        logVolume = new double[modes.size()];
        z = new double[2 * modes.size()];
        left = new double[3 * modes.size()];
        Space space = new Space();
        for (int k = 0; k < logVolume.length; k++) {
            PoseMode mode = modes.get(k);
            logVolume[k] = mode.logWeight() + mode.halfChiSquare();
            space.read(mode.jacobian(0), mode.whitenedResiduals(0), covariancePx2);
            System.arraycopy(space.z, 0, z, 2 * k, 2);
            System.arraycopy(space.left, 0, left, 3 * k, 3);
        }
    }

    /** Work space of what is read off one mode after another; for one thread. */
    static final class Space {
        private final double[] z = new double[2];
        private final double[] left = new double[3];
        private final double[][] basis = new double[8][8];

        /** Of a mode with its derivative, 8x6, and its residuals, both of unit weights. */
        private void read(double[] jacobian, double[] r, double[] covariancePx2) {
            complement(jacobian, basis);
            for (int a = 0; a < 2; a++) {
                double[] n = basis[6 + a];
                z[a] = 0;
                for (int i = 0; i < 8; i++) {
                    z[a] += n[i] * r[i];
                }
                for (int b = 0; b <= a; b++) {
                    double s = 0;
                    for (int i = 0; i < 8; i++) {
                        for (int j = 0; j < 8; j++) {
                            s += n[i] * covariancePx2[8 * i + j] * basis[6 + b][j];
                        }
                    }
                    left[a + b] = s;
                }
            }
        }

        /** The chi-square of this mode alone without added noise; see {@link Squareness#chiSquare}. */
        double chiSquare(double[] jacobian, double[] r, double[] covariancePx2) {
            read(jacobian, r, covariancePx2);
            return squares(z, left, 0, 0);
        }
    }

    /** Two orthonormal vectors orthogonal to the 6 columns of an 8x6 matrix (modified Gram-Schmidt, done twice). */
    static double[][] complement(double[] jacobian) {
        double[][] basis = new double[8][8];
        complement(jacobian, basis);
        return new double[][] {basis[6], basis[7]};
    }

    /** The same into the last two of eight rows. */
    private static void complement(double[] jacobian, double[][] basis) {
        int count = 0;
        for (int c = 0; c < 14 && count < 8; c++) {
            // what does not count is written over by the next
            double[] v = basis[count];
            double before = 0;
            for (int i = 0; i < 8; i++) {
                v[i] = c < 6 ? jacobian[6 * i + c] : i == c - 6 ? 1 : 0;
                before += v[i] * v[i];
            }
            double after = 0;
            for (int pass = 0; pass < 2; pass++) {
                for (int b = 0; b < count; b++) {
                    double s = 0;
                    for (int i = 0; i < 8; i++) {
                        s += basis[b][i] * v[i];
                    }
                    for (int i = 0; i < 8; i++) {
                        v[i] -= s * basis[b][i];
                    }
                }
                after = 0;
                for (int i = 0; i < 8; i++) {
                    after += v[i] * v[i];
                }
            }
            // a derivative always counts; a unit vector only if enough of it is new
            if (c < 6 || after > 0.05 * before) {
                for (int i = 0; i < 8; i++) {
                    v[i] /= Math.sqrt(after);
                }
                count++;
            }
        }
    }

    /**
     * Logarithm of the integrated likelihood, up to a constant.
     *
     * @param addedPx2 variance added to every coordinate, px²
     * @param inflation factor on all of the covariance
     * @return finite if the covariance is positive definite
     */
    double logLikelihood(double addedPx2, double inflation) {
        return logLikelihood(prepared(addedPx2, new double[2 * logVolume.length]), inflation, Math.log(inflation));
    }

    /**
     * The same without inflation at a node of a noise.
     *
     * @param noise added to every coordinate
     * @param node of its grid
     * @return finite if the covariance is positive definite
     */
    double logLikelihood(AddedNoise noise, int node) {
        Table known = table;
        if (known == null || known.noise != noise) {
            known = new Table(noise, this);
            table = known;
        }
        return known.logLikelihoods[node];
    }

    /**
     * Logarithm of the mean of the integrated likelihood over inflations that are equally likely.
     *
     * @param addedPx2 variance added to every coordinate, px²
     * @param inflations factors on all of the covariance
     * @param logInflations their logarithms
     * @return finite if the covariance is positive definite
     */
    double logMeanLikelihood(double addedPx2, double[] inflations, double[] logInflations) {
        double[] prepared = prepared(addedPx2, new double[2 * logVolume.length]);
        double most = Double.NEGATIVE_INFINITY;
        double sum = 0;
        for (int k = 0; k < inflations.length; k++) {
            double log = logLikelihood(prepared, inflations[k], logInflations[k]);
            if (log > most) {
                sum = sum * Math.exp(most - log) + 1;
                most = log;
            } else {
                sum += Math.exp(log - most);
            }
        }
        return most + Math.log(sum / inflations.length);
    }

    /**
     * A bound of the ratio of that mean to the likelihood without inflation, for this added variance and all larger
     * ones: squares shrink as variance is added, and the larger they are the more an inflation explains.
     *
     * @param addedPx2 variance added to every coordinate, px²
     * @param inflations factors on all of the covariance
     * @return NaN where the covariance is not positive definite
     */
    double largestRatio(double addedPx2, double[] inflations) {
        double most = 0;
        for (int k = 0; k < logVolume.length; k++) {
            boolean definite = left[3 * k] + addedPx2 > 0 && determinant(k, addedPx2) > 0;
            most = Math.max(most, definite ? squares(k, addedPx2) : Double.NaN);
        }
        double sum = 0;
        for (double inflation : inflations) {
            sum += Math.exp(0.5 * most * (1 - 1 / inflation)) / inflation;
        }
        return sum / inflations.length;
    }

    /** What of each mode's likelihood does not depend on the inflation, and half of its squares. */
    private double[] prepared(double addedPx2, double[] out) {
        for (int k = 0; k < logVolume.length; k++) {
            out[2 * k] = logVolume[k] - 0.5 * Math.log(determinant(k, addedPx2));
            out[2 * k + 1] = 0.5 * squares(k, addedPx2);
        }
        return out;
    }

    private static double logLikelihood(double[] prepared, double inflation, double logInflation) {
        double most = prepared[0] - logInflation - prepared[1] / inflation;
        if (prepared.length == 2) {
            return most;
        }
        double sum = 1;
        for (int k = 2; k < prepared.length; k += 2) {
            double log = prepared[k] - logInflation - prepared[k + 1] / inflation;
            if (log > most) {
                sum = sum * Math.exp(most - log) + 1;
                most = log;
            } else {
                sum += Math.exp(log - most);
            }
        }
        return most + Math.log(sum);
    }

    /**
     * Squared length of what no pose explains, in deviations: chi-square of 2 degrees of freedom, of the mode that fits
     * best.
     *
     * @param addedPx2 variance added to every coordinate, px²
     * @return not negative
     */
    double chiSquare(double addedPx2) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < logVolume.length; k++) {
            least = Math.min(least, squares(k, addedPx2));
        }
        return least;
    }

    private double determinant(int k, double addedPx2) {
        return determinant(left, k, addedPx2);
    }

    private double squares(int k, double addedPx2) {
        return squares(z, left, k, addedPx2);
    }

    private static double determinant(double[] left, int k, double addedPx2) {
        return (left[3 * k] + addedPx2) * (left[3 * k + 2] + addedPx2) - left[3 * k + 1] * left[3 * k + 1];
    }

    private static double squares(double[] z, double[] left, int k, double addedPx2) {
        double a = z[2 * k];
        double b = z[2 * k + 1];
        return (a * a * (left[3 * k + 2] + addedPx2) - 2 * a * b * left[3 * k + 1] + b * b * (left[3 * k] + addedPx2))
                / determinant(left, k, addedPx2);
    }
}
