package org.cellgauge.estimate;

import java.util.Collections;
import java.util.List;
import org.cellgauge.internal.estimate.Matrices;

/** Unknown intrinsics with their uncertainty; immutable. */
public final class IntrinsicsEstimate {
    private final List<String> names;
    private final double[] mean;
    private final double[][] covariance;

    /**
     * An estimate.
     *
     * @param names names with units, for instance {@code fx_px}
     * @param mean values in that order; copied
     * @param covariance in that order; copied
     */
    public IntrinsicsEstimate(List<String> names, double[] mean, double[][] covariance) {
        this.names = Collections.unmodifiableList(names);
        this.mean = mean.clone();
        this.covariance = Matrices.copy(covariance);
    }

    /**
     * Names with units.
     *
     * @return unmodifiable
     */
    public List<String> names() {
        return names;
    }

    /**
     * Means.
     *
     * @return a copy, in the order of the names
     */
    public double[] mean() {
        return mean.clone();
    }

    /**
     * Covariance.
     *
     * @return a copy, in the order of the names
     */
    public double[][] covariance() {
        return Matrices.copy(covariance);
    }
}
