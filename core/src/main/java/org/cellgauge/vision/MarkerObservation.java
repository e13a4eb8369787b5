package org.cellgauge.vision;

import org.jspecify.annotations.Nullable;

/**
 * One marker as seen in an image: its id, where its four corners are and, where the detector can tell, how precisely
 * they are known; immutable.
 */
public final class MarkerObservation {
    private final int id;
    private final double[] cornersPx;
    private final double @Nullable [] covariancePx2;
    private final @Nullable EdgeShift edgeShift;

    /**
     * An observation of which nothing is known but the corners.
     *
     * @param id marker id
     * @param cornersPx 8 values: u, v of top-left, top-right, bottom-right, bottom-left corner of the marker in its own
     *     frame, px with pixel centres at +0.5, distorted as in the image; copied
     * @throws IllegalArgumentException if there are not 8 finite values
     */
    public MarkerObservation(int id, double[] cornersPx) {
        this(id, cornersPx, null, null);
    }

    /**
     * An observation.
     *
     * @param id marker id
     * @param cornersPx 8 values: u, v of top-left, top-right, bottom-right, bottom-left corner of the marker in its own
     *     frame, px with pixel centres at +0.5, distorted as in the image; copied
     * @param covariancePx2 covariance of the errors of these 8 values, 8x8 row by row, px², symmetric and positive
     *     definite (checked where files are read, not here); null: not known; copied
     * @param edgeShift what the marker's inner edges say of a shift common to all its edges, by which the corners are
     *     not corrected; null: not measured
     * @throws IllegalArgumentException if there are not 8 finite corner values, or 64 finite ones of a covariance
     */
    public MarkerObservation(int id, double[] cornersPx, double @Nullable [] covariancePx2,
            @Nullable EdgeShift edgeShift) {
        if (cornersPx.length != 8) {
            throw new IllegalArgumentException("marker " + id + ": 4 corners take 8 values, not " + cornersPx.length);
        }
        for (double v : cornersPx) {
            if (!Double.isFinite(v)) {
                throw new IllegalArgumentException("marker " + id + ": a corner is not finite");
            }
        }
        if (covariancePx2 != null) {
            if (covariancePx2.length != 64) {
                throw new IllegalArgumentException("marker " + id + ": a covariance of 4 corners takes 64 values, not "
                        + covariancePx2.length);
            }
            for (double v : covariancePx2) {
                if (!Double.isFinite(v)) {
                    throw new IllegalArgumentException("marker " + id + ": a covariance is not finite");
                }
            }
        }
        this.id = id;
        this.cornersPx = cornersPx.clone();
        this.covariancePx2 = covariancePx2 == null ? null : covariancePx2.clone();
        this.edgeShift = edgeShift;
    }

    /**
     * Marker id.
     *
     * @return the id within the family
     */
    public int id() {
        return id;
    }

    /**
     * The corners.
     *
     * @return a copy of the 8 values u, v of top-left, top-right, bottom-right, bottom-left, px
     */
    public double[] cornersPx() {
        return cornersPx.clone();
    }

    /**
     * Covariance of the errors of the corners.
     *
     * @return a copy, 8x8 row by row in the order of {@link #cornersPx()}, px²; null where it is not known
     */
    public double @Nullable [] covariancePx2() {
        return covariancePx2 == null ? null : covariancePx2.clone();
    }

    /**
     * What the marker's inner edges say of a shift common to all its edges.
     *
     * @return the measured shift, by which {@link #cornersPx()} are not corrected; null where none was measured
     */
    public @Nullable EdgeShift edgeShift() {
        return edgeShift;
    }

    /**
     * Length of the shortest side in the image: what decides whether the marker is large enough.
     *
     * @return px
     */
    public double shortestSidePx() {
        double shortest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < 4; i++) {
            int j = (i + 1) % 4;
            shortest = Math.min(shortest, Math.hypot(cornersPx[2 * j] - cornersPx[2 * i],
                    cornersPx[2 * j + 1] - cornersPx[2 * i + 1]));
        }
        return shortest;
    }
}
