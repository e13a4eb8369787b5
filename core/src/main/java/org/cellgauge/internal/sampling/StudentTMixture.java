package org.cellgauge.internal.sampling;

import java.util.Arrays;
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
    /** Densities below, in units of the largest scale, are computed by their logarithms. */
    private static final double SMALLEST_SUM = 1e-280;

    private final int dimension;
    private final double[][] means;
    private final double[][] factors;
    private final double[] cumulativeWeights;
    /** Inverses of the factors, lower triangles row by row: no division per point. */
    private final double[][] whiteners;
    private final double[] logScales;
    private final double largestLogScale;
    /** Scales over the largest. */
    private final double[] scales;
    private final double[] whitened;
    /** Of each component at the point of the last density, in proportion. */
    private final double[] terms;
    private final double[] lastFrom;
    private final double[] lastTo;
    /** Of the point drawn last, from the location of the component that it was drawn from, in its scale. */
    private double drawnSquared;
    private double logDensityOfFrom;
    private double logDensityOfTo;

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
        whiteners = new double[means.length][];
        scales = new double[means.length];
        terms = new double[means.length];
        whitened = new double[dimension];
        lastFrom = unknown();
        lastTo = unknown();
        double total = 0;
        for (double w : weights) {
            total += w;
        }
        double running = 0;
        double largest = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < means.length; k++) {
            this.means[k] = means[k].clone();
            factors[k] = covariances[k].clone();
            if (!Cholesky.factor(factors[k], dimension)) {
                throw new IllegalArgumentException("scale matrix of component " + k + " is not positive definite");
            }
            running += weights[k] / total;
            cumulativeWeights[k] = running;
            logScales[k] = Math.log(weights[k] / total) - Cholesky.halfLogDeterminant(factors[k], dimension);
            largest = Math.max(largest, logScales[k]);
            whiteners[k] = inverse(factors[k]);
        }
        largestLogScale = largest;
        for (int k = 0; k < scales.length; k++) {
            scales[k] = Math.exp(logScales[k] - largest);
        }
    }

    /** Lower triangle of the inverse of a factor, row by row without what is above the diagonal. */
    private double[] inverse(double[] factor) {
        double[] out = new double[dimension * (dimension + 1) / 2];
        double[] column = new double[dimension];
        for (int j = 0; j < dimension; j++) {
            Arrays.fill(column, 0);
            column[j] = 1;
            Cholesky.solveLower(factor, dimension, column);
            for (int i = j; i < dimension; i++) {
                out[i * (i + 1) / 2 + j] = column[i];
            }
        }
        return out;
    }

    /** A point that equals no other. */
    private double[] unknown() {
        double[] point = new double[dimension];
        Arrays.fill(point, Double.NaN);
        return point;
    }

    private StudentTMixture(StudentTMixture other) {
        dimension = other.dimension;
        means = other.means;
        factors = other.factors;
        cumulativeWeights = other.cumulativeWeights;
        whiteners = other.whiteners;
        logScales = other.logScales;
        largestLogScale = other.largestLogScale;
        scales = other.scales;
        whitened = new double[dimension];
        terms = new double[means.length];
        lastFrom = unknown();
        lastTo = unknown();
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
        double squared = 0;
        for (int i = 0; i < dimension; i++) {
            double z = random.nextGaussian();
            whitened[i] = z;
            squared += z * z;
        }
        // chi-square with 5 degrees of freedom: two exponentials and one squared Gaussian
        double g = random.nextGaussian();
        double chiSquare = g * g - 2 * Math.log((1 - random.nextDouble()) * (1 - random.nextDouble()));
        drawnSquared = squared * (DEGREES_OF_FREEDOM / chiSquare);
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
        if (means.length == 1) {
            terms[0] = 1;
            return logTerm(0, squared(0, x));
        }
        double sum = 0;
        for (int k = 0; k < means.length; k++) {
            terms[k] = scales[k] / power(1 + squared(k, x) / DEGREES_OF_FREEDOM);
            sum += terms[k];
        }
        return sum > SMALLEST_SUM ? largestLogScale + Math.log(sum) : logDensityFarOff(x);
    }

    /** Where no component has a density that is a normal number. */
    private double logDensityFarOff(double[] x) {
        double largest = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < means.length; k++) {
            terms[k] = logTerm(k, squared(k, x));
            largest = Math.max(largest, terms[k]);
        }
        double sum = 0;
        for (int k = 0; k < means.length; k++) {
            terms[k] = Math.exp(terms[k] - largest);
            sum += terms[k];
        }
        return largest + Math.log(sum);
    }

    private double logTerm(int component, double squared) {
        return logScales[component]
                - 0.5 * (DEGREES_OF_FREEDOM + dimension) * Math.log(1 + squared / DEGREES_OF_FREEDOM);
    }

    /** Squared distance from the location of a component, in its scale. */
    private double squared(int component, double[] x) {
        double[] mean = means[component];
        double[] whitener = whiteners[component];
        if (dimension == 6) {
            return squaredOfPose(whitener, mean, x);
        }
        for (int i = 0; i < dimension; i++) {
            whitened[i] = x[i] - mean[i];
        }
        double squared = 0;
        int at = 0;
        for (int i = 0; i < dimension; i++) {
            double s = 0;
            for (int j = 0; j <= i; j++) {
                s += whitener[at++] * whitened[j];
            }
            squared += s * s;
        }
        return squared;
    }

    /** The same of a pose alone, which most chains move: the triangle written out takes a third of the time. */
    private static double squaredOfPose(double[] w, double[] mean, double[] x) {
        double a = x[0] - mean[0];
        double b = x[1] - mean[1];
        double c = x[2] - mean[2];
        double d = x[3] - mean[3];
        double e = x[4] - mean[4];
        double f = x[5] - mean[5];
        double s0 = w[0] * a;
        double s1 = w[1] * a + w[2] * b;
        double s2 = w[3] * a + w[4] * b + w[5] * c;
        double s3 = w[6] * a + w[7] * b + w[8] * c + w[9] * d;
        double s4 = w[10] * a + w[11] * b + w[12] * c + w[13] * d + w[14] * e;
        double s5 = w[15] * a + w[16] * b + w[17] * c + w[18] * d + w[19] * e + w[20] * f;
        return s0 * s0 + s1 * s1 + s2 * s2 + s3 * s3 + s4 * s4 + s5 * s5;
    }

    /** Raises to half the sum of degrees of freedom and dimension. */
    private double power(double base) {
        int twice = DEGREES_OF_FREEDOM + dimension;
        if (twice == 11) {
            double square = base * base;
            return Math.sqrt(base) * base * (square * square);
        }
        double power = twice % 2 == 0 ? 1 : Math.sqrt(base);
        double square = base;
        for (int rest = twice / 2; rest > 0; rest >>= 1) {
            if ((rest & 1) != 0) {
                power *= square;
            }
            square *= square;
        }
        return power;
    }

    /** Share of each component in the density at the point of the last call of {@link #logDensity}. */
    void responsibilities(double[] out) {
        double sum = 0;
        for (double t : terms) {
            sum += t;
        }
        for (int k = 0; k < terms.length; k++) {
            out[k] = terms[k] / sum;
        }
    }

    /** The chain is where it was or where it was last proposed to go, so that its density is known. */
    @Override
    public double propose(double[] from, double[] to, RandomGenerator random) {
        if (same(from, lastTo)) {
            logDensityOfFrom = logDensityOfTo;
        } else if (!same(from, lastFrom)) {
            logDensityOfFrom = logDensity(from);
        }
        System.arraycopy(from, 0, lastFrom, 0, dimension);
        draw(to, random);
        logDensityOfTo = means.length == 1 ? logTerm(0, drawnSquared) : logDensity(to);
        System.arraycopy(to, 0, lastTo, 0, dimension);
        return logDensityOfFrom - logDensityOfTo;
    }

    private boolean same(double[] a, double[] b) {
        for (int i = 0; i < dimension; i++) {
            if (a[i] != b[i]) {
                return false;
            }
        }
        return true;
    }
}
