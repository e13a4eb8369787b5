package org.cellgauge.internal.validation;

import org.cellgauge.internal.geometry.Cholesky;

/**
 * The region of highest density of draws that gather about one or several modes.
 *
 * <p>The density is that of a mixture of Gaussians, one for each mode, with the share, the mean and the covariance of
 * the draws near it. The region of probability p holds all places with a density above that which the share p of the
 * draws exceeds (R. J. Hyndman, "Computing and graphing highest density regions", The American Statistician 50(2),
 * 1996): with one mode the ellipsoid about the mean, with several the union of one about each. If the truth is a draw
 * of the posterior like the others, its density has a uniform rank among theirs, whatever function the density is: the
 * region then holds the truth with probability p, to 1/n for n effective draws.
 */
final class MixtureRegion {
    /** A mode with fewer draws than this for each coordinate has the covariance of the largest one. */
    private static final int DRAWS_PER_COORDINATE = 10;

    private final int dimension;
    private final double[] centre;
    private final double[] scale;
    private final double[][] means;
    private final double[][] factors;
    private final double[] logWeights;
    private final double[] drawDensities;
    private final double[] work;

    /**
     * The region of draws.
     *
     * @param columns draws, [coordinate][draw]
     * @param first first coordinate that counts
     * @param dimension number of coordinates that count
     * @param labels which mode each draw is near, or null for one mode
     */
    MixtureRegion(double[][] columns, int first, int dimension, int[] labels) {
        this.dimension = dimension;
        int n = columns[first].length;
        centre = new double[dimension];
        scale = new double[dimension];
        for (int c = 0; c < dimension; c++) {
            for (double v : columns[first + c]) {
                centre[c] += v / n;
            }
            for (double v : columns[first + c]) {
                scale[c] += (v - centre[c]) * (v - centre[c]) / (n - 1);
            }
            scale[c] = Math.sqrt(scale[c]);
        }
        int modes = 1;
        for (int i = 0; labels != null && i < n; i++) {
            modes = Math.max(modes, labels[i] + 1);
        }
        means = new double[modes][dimension];
        factors = new double[modes][dimension * dimension];
        logWeights = new double[modes];
        work = new double[dimension];
        int[] counts = moments(columns, first, labels);
        int largest = 0;
        for (int k = 1; k < modes; k++) {
            largest = counts[k] > counts[largest] ? k : largest;
        }
        if (!Cholesky.factor(factors[largest], dimension)) {
            throw new IllegalArgumentException("the draws of a mode have no covariance of full rank");
        }
        for (int k = 0; k < modes; k++) {
            if (k != largest && (counts[k] < DRAWS_PER_COORDINATE * dimension
                    || !Cholesky.factor(factors[k], dimension))) {
                factors[k] = factors[largest];
            }
            logWeights[k] = Math.log((double) counts[k] / n) - Cholesky.halfLogDeterminant(factors[k], dimension);
        }
        drawDensities = new double[n];
        double[] x = new double[dimension];
        for (int i = 0; i < n; i++) {
            for (int c = 0; c < dimension; c++) {
                x[c] = columns[first + c][i];
            }
            drawDensities[i] = logDensity(x);
        }
    }

    /**
     * Means and covariances (in place of their factors) of the draws of each mode, in units of the deviations of all.
     */
    private int[] moments(double[][] columns, int first, int[] labels) {
        int n = columns[first].length;
        int[] counts = new int[means.length];
        for (int i = 0; i < n; i++) {
            int k = labels == null ? 0 : labels[i];
            counts[k]++;
            for (int c = 0; c < dimension; c++) {
                means[k][c] += (columns[first + c][i] - centre[c]) / scale[c];
            }
        }
        for (int k = 0; k < means.length; k++) {
            for (int c = 0; c < dimension; c++) {
                means[k][c] /= Math.max(1, counts[k]);
            }
        }
        for (int i = 0; i < n; i++) {
            int k = labels == null ? 0 : labels[i];
            for (int c = 0; c < dimension; c++) {
                work[c] = (columns[first + c][i] - centre[c]) / scale[c] - means[k][c];
            }
            for (int c = 0; c < dimension; c++) {
                for (int d = 0; d < dimension; d++) {
                    factors[k][c * dimension + d] += work[c] * work[d] / Math.max(1, counts[k] - 1);
                }
            }
        }
        return counts;
    }

    /** Logarithm of the density up to a constant. */
    private double logDensity(double[] x) {
        double largest = Double.NEGATIVE_INFINITY;
        double sum = 0;
        for (int k = 0; k < means.length; k++) {
            for (int c = 0; c < dimension; c++) {
                work[c] = (x[c] - centre[c]) / scale[c] - means[k][c];
            }
            Cholesky.solveLower(factors[k], dimension, work);
            double log = logWeights[k];
            for (int c = 0; c < dimension; c++) {
                log -= work[c] * work[c] / 2;
            }
            if (log > largest) {
                sum = sum * Math.exp(largest - log) + 1;
                largest = log;
            } else if (log > Double.NEGATIVE_INFINITY) {
                sum += Math.exp(log - largest);
            }
        }
        return largest + Math.log(sum);
    }

    /**
     * The smallest probability whose region holds a place.
     *
     * @param x the place
     * @return share of the draws with a density above that of the place, 0 to 1
     */
    double shareOf(double[] x) {
        double own = logDensity(x);
        int denser = 0;
        for (double density : drawDensities) {
            denser += density > own ? 1 : 0;
        }
        return (double) denser / drawDensities.length;
    }
}
