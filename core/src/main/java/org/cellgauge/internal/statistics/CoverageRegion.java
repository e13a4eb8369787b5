package org.cellgauge.internal.statistics;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.DecompositionFactory_DDRM;
import org.ejml.interfaces.decomposition.EigenDecomposition_F64;
import org.jspecify.annotations.Nullable;

/**
 * The ellipsoid that holds a normally distributed vector with a stated probability: all x with
 * (x - mean)' covariance^-1 (x - mean) at most the chi-square quantile of as many degrees of freedom as components
 * (JCGM 102:2011, section 6.5).
 *
 * <p>Components may have different units, say mm and rad: every decision is made on the correlation matrix. Covariances
 * without full rank are allowed; the region is then flat, and a point off it is outside at any probability.
 *
 * <p>Immutable.
 */
public final class CoverageRegion {
    /** Eigenvalues of a correlation matrix up to this size are rounding of zero. */
    private static final double ZERO_EIGENVALUE = 1e-12;

    /** How far off a flat region, in standard deviations, still passes for rounding. */
    private static final double OFF_SUPPORT = 1e-6;

    /** The same where there is no standard deviation to compare with: relative to the numbers themselves. */
    private static final double ROUNDING = 1e-12;

    private final double[] mean;
    private final double[][] covariance;
    private final double[] std;
    private final double probability;
    private final double factor;
    /** Eigenvalues and eigenvectors (rows) of the correlation matrix of the components that vary. */
    private final double[] eigenvalues;
    private final double[][] eigenvectors;
    private final int[] varying;

    private CoverageRegion(double[] mean, double[][] covariance, double probability) {
        int d = mean.length;
        if (d == 0) {
            throw new IllegalArgumentException("the mean must have at least one component");
        }
        CovarianceChecks.requireFinite(mean, "mean");
        this.std = CovarianceChecks.standardDeviations(covariance, d);
        this.mean = mean.clone();
        this.covariance = new double[d][];
        for (int i = 0; i < d; i++) {
            this.covariance[i] = covariance[i].clone();
        }
        this.probability = probability;
        this.factor = Math.sqrt(chiSquareQuantile(probability, d));
        int count = 0;
        int[] which = new int[d];
        for (int i = 0; i < d; i++) {
            if (std[i] > 0) {
                which[count++] = i;
            }
        }
        this.varying = Arrays.copyOf(which, count);
        double[][] correlation = new double[count][count];
        for (int i = 0; i < count; i++) {
            for (int j = 0; j < count; j++) {
                correlation[i][j] = i == j
                        ? 1
                        : (covariance[varying[i]][varying[j]] + covariance[varying[j]][varying[i]])
                                / (2 * std[varying[i]] * std[varying[j]]);
            }
        }
        this.eigenvectors = new double[count][];
        this.eigenvalues = eigen(correlation, eigenvectors);
        for (double value : eigenvalues) {
            if (value < -CovarianceChecks.NEGATIVE) {
                throw CovarianceChecks.notPositive("its correlation matrix has the eigenvalue " + value);
            }
        }
    }

    /**
     * The region of a normal distribution.
     *
     * @param mean d components
     * @param covariance d by d, symmetric and positive semi-definite, to within rounding
     * @param probability that the region holds, in (0, 1)
     * @return the region
     * @throws IllegalArgumentException if shapes differ, a number is not finite, the covariance is not symmetric and
     *     positive semi-definite, or the probability is outside (0, 1)
     */
    public static CoverageRegion of(double[] mean, double[][] covariance, double probability) {
        return new CoverageRegion(mean, covariance, probability);
    }

    /**
     * The quantile of a chi-square distribution: the squared radius, in standard deviations, of the ball that holds a
     * standard normal vector with the given probability.
     *
     * @param probability in (0, 1)
     * @param degreesOfFreedom at least 1; for 2 the closed form -2 ln(1 - p) is used
     * @return the quantile, positive
     * @throws IllegalArgumentException if an argument is out of range
     */
    public static double chiSquareQuantile(double probability, int degreesOfFreedom) {
        requireProbability(probability);
        if (degreesOfFreedom < 1) {
            throw new IllegalArgumentException("degrees of freedom must be at least 1, were " + degreesOfFreedom);
        }
        if (degreesOfFreedom == 2) {
            return -2 * Math.log1p(-probability);
        }
        return ChiSquare.distribution(degreesOfFreedom, 1e-12).inverseCumulativeProbability(probability);
    }

    /**
     * The squared Mahalanobis distance of a point from the mean.
     *
     * @param x d components
     * @return (x - mean)' covariance^-1 (x - mean), not negative. Where the covariance lacks full rank: the same within
     *     the directions that vary (by the pseudo-inverse of the correlation matrix), and infinite for a point that
     *     differs from the mean in a direction that does not
     * @throws IllegalArgumentException if the length differs or a component is not finite
     */
    public double mahalanobisSquared(double[] x) {
        int d = mean.length;
        if (x.length != d) {
            throw new IllegalArgumentException("expected a point of " + d + " components, got " + x.length);
        }
        CovarianceChecks.requireFinite(x, "point");
        for (int i = 0; i < d; i++) {
            if (std[i] == 0 && Math.abs(x[i] - mean[i]) > ROUNDING * Math.max(Math.abs(x[i]), Math.abs(mean[i]))) {
                return Double.POSITIVE_INFINITY;
            }
        }
        double sum = 0;
        for (int k = 0; k < varying.length; k++) {
            double along = 0;
            double rounding = OFF_SUPPORT;
            for (int j = 0; j < varying.length; j++) {
                int i = varying[j];
                along += eigenvectors[k][j] * ((x[i] - mean[i]) / std[i]);
                rounding = Math.max(rounding, ROUNDING * Math.abs(mean[i]) / std[i]);
            }
            if (eigenvalues[k] > ZERO_EIGENVALUE) {
                sum += along * along / eigenvalues[k];
            } else if (Math.abs(along) > rounding) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return sum;
    }

    /**
     * Whether a point lies in the region, its boundary included.
     *
     * @param x d components
     * @return true if it does
     * @throws IllegalArgumentException if the length differs or a component is not finite
     */
    public boolean contains(double[] x) {
        return mahalanobisSquared(x) <= factor * factor;
    }

    /**
     * Coverage factor k: the semi-axes are k standard deviations long.
     *
     * @return the square root of the chi-square quantile
     */
    public double factor() {
        return factor;
    }

    /**
     * Probability that the region holds.
     *
     * @return the probability, in (0, 1)
     */
    public double probability() {
        return probability;
    }

    /**
     * The centre.
     *
     * @return a new array of d components
     */
    public double[] mean() {
        return mean.clone();
    }

    /**
     * Lengths of the semi-axes, longest first. Meaningful only if all components have the same unit.
     *
     * @return d lengths, in that unit, not negative
     */
    public double[] semiAxes() {
        return axes(null);
    }

    /**
     * Directions of the semi-axes, in the order of {@link #semiAxes()}. Meaningful only if all components have the same
     * unit.
     *
     * @return d orthonormal vectors of d components, {@code [axis][component]}; the sign of each is arbitrary
     */
    public double[][] axisDirections() {
        double[][] directions = new double[mean.length][];
        axes(directions);
        return directions;
    }

    /**
     * How far the region reaches from the mean along one component: half the side of the smallest box around it.
     *
     * @param i index of the component
     * @return k times the standard deviation of the component, in its unit
     * @throws IllegalArgumentException if there is no such component
     */
    public double halfWidth(int i) {
        if (i < 0 || i >= std.length) {
            throw new IllegalArgumentException("no component " + i + " in a vector of length " + std.length);
        }
        return factor * std[i];
    }

    private double[] axes(double @Nullable [][] directions) {
        int d = mean.length;
        double[][] symmetric = new double[d][d];
        for (int i = 0; i < d; i++) {
            for (int j = 0; j < d; j++) {
                symmetric[i][j] = (covariance[i][j] + covariance[j][i]) / 2;
            }
        }
        double[] lengths = eigen(symmetric, directions == null ? new double[d][] : directions);
        for (int k = 0; k < d; k++) {
            lengths[k] = factor * Math.sqrt(Math.max(0, lengths[k]));
        }
        return lengths;
    }

    /** Eigenvalues in descending order, with their vectors as rows. */
    private static double[] eigen(double[][] symmetric, double[][] vectors) {
        int d = symmetric.length;
        double[] values = new double[d];
        if (d == 0) {
            return values;
        }
        EigenDecomposition_F64<DMatrixRMaj> decomposition = DecompositionFactory_DDRM.eig(d, true, true);
        if (!decomposition.decompose(new DMatrixRMaj(symmetric))) {
            throw new IllegalArgumentException("the eigenvalues of the covariance could not be found");
        }
        for (int k = 0; k < d; k++) {
            double value = decomposition.getEigenvalue(k).getReal();
            double[] vector = decomposition.getEigenVector(k).getData().clone();
            int slot = k;
            while (slot > 0 && values[slot - 1] < value) {
                values[slot] = values[slot - 1];
                vectors[slot] = vectors[slot - 1];
                slot--;
            }
            values[slot] = value;
            vectors[slot] = vector;
        }
        return values;
    }

    private static void requireProbability(double probability) {
        if (!(probability > 0 && probability < 1)) {
            throw new IllegalArgumentException("probability must lie in (0, 1), was " + probability);
        }
    }
}
