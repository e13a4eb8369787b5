package org.cellgauge.internal.posterior;

import java.util.List;
import org.cellgauge.internal.geometry.Cholesky;
import org.cellgauge.internal.pose.AddedNoise;
import org.cellgauge.internal.pose.CornerErrors;

/**
 * Whitening matrices of markers at every added noise: one set per node of the grid of {@link AddedNoise}, made when it
 * is first asked for, so that an evaluation costs what it costs with a stated noise. Not thread-safe.
 */
final class NoiseWhitening {
    /** Values of a lower triangular 8x8 matrix. */
    static final int PACKED = 36;

    private final CornerErrors errors;
    private final List<Integer> ids;
    private final double[] placementPx2;
    private final double[][] packed = new double[AddedNoise.NODES][];
    private final double[] logDeterminants = new double[AddedNoise.NODES];

    /**
     * Matrices of some markers.
     *
     * @param errors errors of the corners
     * @param ids the markers
     * @param placementPx2 64 values per marker: covariances that come on top, px²; null for none
     */
    NoiseWhitening(CornerErrors errors, List<Integer> ids, double[] placementPx2) {
        this.errors = errors;
        this.ids = ids;
        this.placementPx2 = placementPx2;
    }

    /** Packed matrices at a node, 36 values per marker; shared. */
    double[] at(int node) {
        if (packed[node] == null) {
            make(node);
        }
        return packed[node];
    }

    /** Sum of the logarithms of their diagonals; after {@link #at}. */
    double logDeterminant(int node) {
        return logDeterminants[node];
    }

    private void make(int node) {
        double[] made = new double[PACKED * ids.size()];
        double[] covariance = new double[64];
        double[] inverse = new double[64];
        double sum = 0;
        for (int m = 0; m < ids.size(); m++) {
            errors.covariance(ids.get(m), AddedNoise.atNode(node), covariance);
            for (int i = 0; i < 64 && placementPx2 != null; i++) {
                covariance[i] += placementPx2[64 * m + i];
            }
            if (!Cholesky.factor(covariance, 8)) {
                throw new IllegalStateException("covariance of the corners of marker " + ids.get(m)
                        + " is not positive definite");
            }
            Cholesky.invertLower(covariance, 8, inverse);
            sum += pack(inverse, 0, made, PACKED * m);
        }
        logDeterminants[node] = sum;
        packed[node] = made;
    }

    /** Packs the lower triangle of an 8x8 matrix; returns the sum of the logarithms of its diagonal. */
    static double pack(double[] whitening, int from, double[] out, int to) {
        int at = to;
        double sum = 0;
        for (int i = 0; i < 8; i++) {
            for (int j = 0; j <= i; j++) {
                out[at++] = whitening[from + 8 * i + j];
            }
            sum += Math.log(whitening[from + 9 * i]);
        }
        return sum;
    }
}
