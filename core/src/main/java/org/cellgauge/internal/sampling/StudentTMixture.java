package org.cellgauge.internal.sampling;

import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.internal.geometry.Cholesky;

/**
 * An independence proposal: a mixture of multivariate t distributions with 5 degrees of freedom, one per mode of the
 * target (Tierney, "Markov chains for exploring posterior distributions", Annals of Statistics 1994, section 2.3.3).
 * The tails of t are heavier than a Gaussian's, so that the chain cannot be stuck where the proposal is too thin.
 *
 * <p>Immutable but for scratch arrays; {@link #copy()} gives another chain its own.
 */
public final class StudentTMixture implements Proposal {
    /** Degrees of freedom. */
    public static final int DEGREES_OF_FREEDOM = 5;

    private final int dimension;
    private final double[][] means;
    private final double[][] factors;
    private final double[] cumulativeWeights;
    private final double[] logScales;
    private final double[] whitened;
    private final double[] logTerms;

    /**
     * A mixture.
     *
     * @param means location of each component; copied
     * @param covariances scale matrix of each component, n x n row by row, positive definite; copied
     * @param weights weight of each component, positive; normalised here
     * @throws IllegalArgumentException if a scale matrix is not positive definite
     */
    public StudentTMixture(double[][] means, double[][] covariances, double[] weights) {
        dimension = means[0].length;
        this.means = new double[means.length][];
        factors = new double[means.length][];
        cumulativeWeights = new double[means.length];
        logScales = new double[means.length];
        logTerms = new double[means.length];
        whitened = new double[dimension];
        double total = 0;
        for (double w : weights) {
            total += w;
        }
        double running = 0;
        for (int k = 0; k < means.length; k++) {
            this.means[k] = means[k].clone();
            factors[k] = covariances[k].clone();
            if (!Cholesky.factor(factors[k], dimension)) {
                throw new IllegalArgumentException("scale matrix of component " + k + " is not positive definite");
            }
            running += weights[k] / total;
            cumulativeWeights[k] = running;
            logScales[k] = Math.log(weights[k] / total) - Cholesky.halfLogDeterminant(factors[k], dimension);
        }
    }

    private StudentTMixture(StudentTMixture other) {
        dimension = other.dimension;
        means = other.means;
        factors = other.factors;
        cumulativeWeights = other.cumulativeWeights;
        logScales = other.logScales;
        whitened = new double[dimension];
        logTerms = new double[means.length];
    }

    /**
     * The same mixture with scratch arrays of its own.
     *
     * @return a mixture for another chain
     */
    public StudentTMixture copy() {
        return new StudentTMixture(this);
    }

    @Override
    public String name() {
        return "independence";
    }

    /**
     * Number of components.
     *
     * @return at least 1
     */
    public int components() {
        return means.length;
    }

    /**
     * Location of a component.
     *
     * @param component 0 to components - 1
     * @return a copy
     */
    public double[] mean(int component) {
        return means[component].clone();
    }

    /**
     * Weight of a component.
     *
     * @param component 0 to components - 1
     * @return 0 to 1; all add to 1
     */
    public double weight(int component) {
        return cumulativeWeights[component] - (component == 0 ? 0 : cumulativeWeights[component - 1]);
    }

    /**
     * The component of the largest weight.
     *
     * @return 0 to components - 1
     */
    public int heaviest() {
        int heaviest = 0;
        for (int k = 1; k < means.length; k++) {
            heaviest = weight(k) > weight(heaviest) ? k : heaviest;
        }
        return heaviest;
    }

    /**
     * Scale matrix of a component.
     *
     * @param component 0 to components - 1
     * @return a new array, n x n row by row
     */
    public double[] scale(int component) {
        double[] l = factors[component];
        double[] out = new double[dimension * dimension];
        for (int i = 0; i < dimension; i++) {
            for (int j = 0; j < dimension; j++) {
                for (int k = 0; k <= Math.min(i, j); k++) {
                    out[i * dimension + j] += l[i * dimension + k] * l[j * dimension + k];
                }
            }
        }
        return out;
    }

    /**
     * Draws a point. Allocates nothing.
     *
     * @param to receives the point
     * @param random source of randomness
     */
    public void draw(double[] to, RandomGenerator random) {
        int component = 0;
        if (means.length > 1) {
            double u = random.nextDouble();
            while (component < means.length - 1 && u >= cumulativeWeights[component]) {
                component++;
            }
        }
        for (int i = 0; i < dimension; i++) {
            whitened[i] = random.nextGaussian();
        }
        // chi-square with 5 degrees of freedom: two exponentials and one squared Gaussian
        double g = random.nextGaussian();
        double chiSquare = g * g - 2 * Math.log((1 - random.nextDouble()) * (1 - random.nextDouble()));
        double stretch = Math.sqrt(DEGREES_OF_FREEDOM / chiSquare);
        double[] l = factors[component];
        for (int i = 0; i < dimension; i++) {
            double s = 0;
            for (int k = 0; k <= i; k++) {
                s += l[i * dimension + k] * whitened[k];
            }
            to[i] = means[component][i] + stretch * s;
        }
    }

    /**
     * Log density, up to a constant that is the same for all points and mixtures of this dimension. Allocates nothing.
     *
     * @param x a point
     * @return finite
     */
    public double logDensity(double[] x) {
        double largest = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < means.length; k++) {
            double[] l = factors[k];
            double squared = 0;
            for (int i = 0; i < dimension; i++) {
                double s = x[i] - means[k][i];
                for (int j = 0; j < i; j++) {
                    s -= l[i * dimension + j] * whitened[j];
                }
                s /= l[i * dimension + i];
                whitened[i] = s;
                squared += s * s;
            }
            logTerms[k] = logScales[k]
                    - 0.5 * (DEGREES_OF_FREEDOM + dimension) * Math.log1p(squared / DEGREES_OF_FREEDOM);
            largest = Math.max(largest, logTerms[k]);
        }
        if (means.length == 1) {
            return largest;
        }
        double sum = 0;
        for (int k = 0; k < means.length; k++) {
            sum += Math.exp(logTerms[k] - largest);
        }
        return largest + Math.log(sum);
    }

    /** Share of each component in the density at the point of the last call of {@link #logDensity}. */
    void responsibilities(double[] out) {
        double largest = Double.NEGATIVE_INFINITY;
        for (double t : logTerms) {
            largest = Math.max(largest, t);
        }
        double sum = 0;
        for (int k = 0; k < logTerms.length; k++) {
            out[k] = Math.exp(logTerms[k] - largest);
            sum += out[k];
        }
        for (int k = 0; k < logTerms.length; k++) {
            out[k] /= sum;
        }
    }

    @Override
    public double propose(double[] from, double[] to, RandomGenerator random) {
        draw(to, random);
        return logDensity(from) - logDensity(to);
    }
}
