package org.cellgauge.internal.statistics;

import java.util.Arrays;

/**
 * Mean and covariance of a stream of vectors of fixed length, in memory that does not grow with the number of draws.
 *
 * <p>One pass and numerically stable: every draw updates the mean and the sums of centred products (Welford 1962,
 * "Note on a method for calculating corrected sums of squares and products", Technometrics 4(3)). Two streams, say of
 * two chains, are joined by the pairwise formula of Chan, Golub &amp; LeVeque 1983, "Algorithms for computing the
 * sample variance", The American Statistician 37(3).
 *
 * <p>Adding allocates nothing. A non-finite component makes the moments it takes part in NaN for good; it is not
 * skipped, because a mean over the remaining draws would look trustworthy without being so. Components are
 * treated as numbers on a line: angles that may wrap belong in {@link CircularMoments}, or are first unrolled about
 * a reference angle with {@link ReferenceAngle}.
 *
 * <p>Not safe for use by several threads at once.
 */
public final class RunningMoments {
    private final int dimension;
    private final double[] mean;
    /** Sums of centred products, upper triangle by rows: (0,0), (0,1), ..., (0,d-1), (1,1), ... */
    private final double[] products;
    private final double[] delta;
    private long count;

    /**
     * An empty stream.
     *
     * @param dimension length of the vectors, at least 1
     * @throws IllegalArgumentException if the dimension is below 1
     */
    public RunningMoments(int dimension) {
        if (dimension < 1) {
            throw new IllegalArgumentException("dimension must be at least 1, was " + dimension);
        }
        this.dimension = dimension;
        this.mean = new double[dimension];
        this.products = new double[dimension * (dimension + 1) / 2];
        this.delta = new double[dimension];
    }

    /**
     * Adds one draw.
     *
     * @param x the draw; its length must be the dimension
     * @throws IllegalArgumentException if the length differs
     */
    public void add(double[] x) {
        if (x.length != dimension) {
            throw new IllegalArgumentException("expected a vector of length " + dimension + ", got " + x.length);
        }
        add(x, 0);
    }

    /**
     * Adds the draw that starts at an index of a longer array.
     *
     * @param x array that holds the draw
     * @param offset index of its first component
     * @throws IllegalArgumentException if the array does not hold a whole draw from the offset on
     */
    public void add(double[] x, int offset) {
        if (offset < 0 || offset > x.length - dimension) {
            throw new IllegalArgumentException("no vector of length " + dimension + " at offset " + offset
                    + " of an array of length " + x.length);
        }
        count++;
        double inverse = 1.0 / count;
        double shrink = (count - 1) * inverse;
        for (int i = 0; i < dimension; i++) {
            double d = x[offset + i] - mean[i];
            delta[i] = d;
            mean[i] += d * inverse;
        }
        // (x - old mean)(x - new mean) = (n - 1) / n times the product of deviations from the old mean
        int k = 0;
        for (int i = 0; i < dimension; i++) {
            double di = delta[i] * shrink;
            for (int j = i; j < dimension; j++) {
                products[k++] += di * delta[j];
            }
        }
    }

    /**
     * Takes in every draw of another stream. The other stream is left as it is; merging a stream with itself counts
     * every draw twice.
     *
     * @param other stream of the same dimension
     * @throws IllegalArgumentException if the dimensions differ
     */
    public void merge(RunningMoments other) {
        if (other.dimension != dimension) {
            throw new IllegalArgumentException(
                    "cannot merge moments of dimension " + other.dimension + " into dimension " + dimension);
        }
        if (other.count == 0) {
            return;
        }
        if (count == 0) {
            // Copied rather than combined: 0 * (infinite delta) would turn a non-finite mean into something else
            System.arraycopy(other.mean, 0, mean, 0, dimension);
            System.arraycopy(other.products, 0, products, 0, products.length);
            count = other.count;
            return;
        }
        long otherCount = other.count;
        long total = count + otherCount;
        double weight = (double) otherCount / total;
        double productWeight = count * weight;
        for (int i = 0; i < dimension; i++) {
            delta[i] = other.mean[i] - mean[i];
        }
        int k = 0;
        for (int i = 0; i < dimension; i++) {
            double di = delta[i] * productWeight;
            for (int j = i; j < dimension; j++) {
                products[k] += other.products[k] + di * delta[j];
                k++;
            }
        }
        for (int i = 0; i < dimension; i++) {
            mean[i] += delta[i] * weight;
        }
        count = total;
    }

    /**
     * An independent stream with the same state.
     *
     * @return the copy
     */
    public RunningMoments copy() {
        RunningMoments copy = new RunningMoments(dimension);
        System.arraycopy(mean, 0, copy.mean, 0, dimension);
        System.arraycopy(products, 0, copy.products, 0, products.length);
        copy.count = count;
        return copy;
    }

    /** Forgets every draw, so that the same memory serves a new stream. */
    public void clear() {
        Arrays.fill(mean, 0);
        Arrays.fill(products, 0);
        count = 0;
    }

    /**
     * Length of the vectors.
     *
     * @return the dimension, at least 1
     */
    public int dimension() {
        return dimension;
    }

    /**
     * Number of draws so far.
     *
     * @return the count, 0 for an empty stream
     */
    public long count() {
        return count;
    }

    /**
     * The mean of one component.
     *
     * @param i index of the component
     * @return its mean; NaN for an empty stream
     * @throws IllegalArgumentException if there is no such component
     */
    public double mean(int i) {
        requireComponent(i);
        return count == 0 ? Double.NaN : mean[i];
    }

    /**
     * The mean vector.
     *
     * @return a new array of length {@link #dimension()}; NaN for an empty stream
     */
    public double[] mean() {
        double[] out = new double[dimension];
        mean(out);
        return out;
    }

    /**
     * Writes the mean vector.
     *
     * @param out receives the mean; its length must be the dimension; NaN for an empty stream
     * @throws IllegalArgumentException if the length differs
     */
    public void mean(double[] out) {
        if (out.length != dimension) {
            throw new IllegalArgumentException("expected an array of length " + dimension + ", got " + out.length);
        }
        for (int i = 0; i < dimension; i++) {
            out[i] = count == 0 ? Double.NaN : mean[i];
        }
    }

    /**
     * The unbiased covariance (divisor n - 1) of two components.
     *
     * @param i index of the first component
     * @param j index of the second component
     * @return their covariance, for {@code i == j} the variance; NaN below two draws
     * @throws IllegalArgumentException if there is no such component
     */
    public double covariance(int i, int j) {
        requireComponent(i);
        requireComponent(j);
        if (count < 2) {
            return Double.NaN;
        }
        int row = Math.min(i, j);
        int column = Math.max(i, j);
        return products[row * dimension - row * (row - 1) / 2 + (column - row)] / (count - 1);
    }

    /**
     * The unbiased covariance matrix (divisor n - 1).
     *
     * @return a new symmetric matrix, d by d; NaN below two draws
     */
    public double[][] covariance() {
        double[][] out = new double[dimension][dimension];
        covariance(out);
        return out;
    }

    /**
     * Writes the unbiased covariance matrix (divisor n - 1).
     *
     * @param out receives the matrix, d by d; NaN below two draws
     * @throws IllegalArgumentException if the shape differs
     */
    public void covariance(double[][] out) {
        if (out.length != dimension) {
            throw new IllegalArgumentException("expected " + dimension + " rows, got " + out.length);
        }
        for (double[] row : out) {
            if (row.length != dimension) {
                throw new IllegalArgumentException("expected rows of length " + dimension + ", got " + row.length);
            }
        }
        int k = 0;
        for (int i = 0; i < dimension; i++) {
            for (int j = i; j < dimension; j++) {
                double c = count < 2 ? Double.NaN : products[k] / (count - 1);
                k++;
                out[i][j] = c;
                out[j][i] = c;
            }
        }
    }

    /**
     * The standard deviation of one component: the square root of its unbiased variance.
     *
     * @param i index of the component
     * @return its standard deviation, not negative; NaN below two draws
     * @throws IllegalArgumentException if there is no such component
     */
    public double std(int i) {
        return Math.sqrt(covariance(i, i));
    }

    private void requireComponent(int i) {
        if (i < 0 || i >= dimension) {
            throw new IllegalArgumentException("no component " + i + " in a vector of length " + dimension);
        }
    }
}
