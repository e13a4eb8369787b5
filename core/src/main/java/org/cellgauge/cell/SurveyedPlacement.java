package org.cellgauge.cell;

import java.util.Arrays;
import java.util.List;

/**
 * How well a survey knows its references: the joint covariance of their errors about the places that the surveyed cell
 * file states; immutable. It takes the place of the references' own placements.
 */
public final class SurveyedPlacement {
    /** Errors of one reference: shift along world x, y, z in mm, turn about its centre in world axes in rad. */
    public static final int ERRORS = 6;

    private final List<Integer> ids;
    private final double[] covariance;

    /**
     * A covariance.
     *
     * @param ids the references, in the order of rows and columns
     * @param covariance {@value #ERRORS} rows and columns for each, row by row, mm and rad; positive semidefinite;
     *     copied
     * @throws IllegalArgumentException if it is not symmetric or of another size, or a variance is not positive
     */
    public SurveyedPlacement(List<Integer> ids, double[] covariance) {
        int n = ERRORS * ids.size();
        if (covariance.length != n * n) {
            throw new IllegalArgumentException("needs " + n + " rows and columns");
        }
        for (int i = 0; i < n; i++) {
            if (!(covariance[i * n + i] > 0)) {
                throw new IllegalArgumentException("a variance is not positive");
            }
            for (int j = 0; j < i; j++) {
                double largest = Math.sqrt(covariance[i * n + i] * covariance[j * n + j]);
                if (!(Math.abs(covariance[i * n + j] - covariance[j * n + i]) <= 1e-6 * largest)
                        || !(Math.abs(covariance[i * n + j]) <= 1.000001 * largest)) {
                    throw new IllegalArgumentException("this is no covariance");
                }
            }
        }
        this.ids = List.copyOf(ids);
        this.covariance = covariance.clone();
    }

    /**
     * The references.
     *
     * @return their ids in the order of rows, unmodifiable
     */
    public List<Integer> ids() {
        return ids;
    }

    /**
     * The joint covariance.
     *
     * @return a copy, {@value #ERRORS} rows and columns for each reference, row by row, mm and rad
     */
    public double[] covariance() {
        return covariance.clone();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof SurveyedPlacement that && ids.equals(that.ids)
                && Arrays.equals(covariance, that.covariance);
    }

    @Override
    public int hashCode() {
        return 31 * ids.hashCode() + Arrays.hashCode(covariance);
    }
}
