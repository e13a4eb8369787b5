package org.cellgauge.internal.pose;

import org.cellgauge.vision.MarkerObservation;

/** What is known of the errors of one marker's corners, part of {@link CornerErrors}; immutable. */
final class MarkerErrors {
    /** A marker of the cell as the photo shows it. */
    static final class Source {
        final MarkerObservation observation;
        final double sizeMm;

        Source(MarkerObservation observation, double sizeMm) {
            this.observation = observation;
            this.sizeMm = sizeMm;
        }
    }

    /** Corners, px, corrected for the mean shift of edges. */
    final double[] cornersPx;
    /** Covariance of their errors but for added noise, 8x8, px². */
    final double[] covariancePx2;
    /** The part of it that comes from bent prints, 8x8, px²; null where there is none. */
    final double[] flatnessPx2;
    /** Change of the seen corners by each shared unknown, 8 rows. */
    final double[] columns;
    /** What the corners say of their noise; null where it is stated. */
    final Squareness squareness;
    /**
     * Whether its corners fit no square: then the covariance is all there is, and says nothing of the others' noise.
     */
    final boolean setAside;

    MarkerErrors(double[] cornersPx, double[] covariancePx2, double[] flatnessPx2, double[] columns,
            Squareness squareness, boolean setAside) {
        this.cornersPx = cornersPx;
        this.covariancePx2 = covariancePx2;
        this.flatnessPx2 = flatnessPx2;
        this.columns = columns;
        this.squareness = squareness;
        this.setAside = setAside;
    }

    /** The same marker with another covariance, out of line with the others. */
    MarkerErrors setAside(double[] otherPx2) {
        return new MarkerErrors(cornersPx, otherPx2, flatnessPx2, columns, squareness, true);
    }

    /** The same marker with the added noise put in. */
    MarkerErrors withAdded(double addedPx2) {
        double[] sum = covariancePx2.clone();
        for (int i = 0; i < 8; i++) {
            sum[9 * i] += setAside ? 0 : addedPx2;
        }
        return new MarkerErrors(cornersPx, sum, flatnessPx2, new double[0], null, setAside);
    }

    /**
     * Derivative of a marker's image corners by its size and by its corners' heights over its plane, at a pose.
     *
     * @param state pose of the marker in the camera frame
     * @param sizeMm its size
     * @return 16 values: 8 by size (px per mm), 8 by each corner's own height (px per mm); null behind the camera
     */
    static double[] bySizeAndHeight(CameraState state, double sizeMm) {
        double[] points = org.cellgauge.internal.geometry.MarkerGeometry.cornersMm(sizeMm);
        double[] r = state.rotation;
        double[] uv = new double[2];
        double[] byPoint = new double[6];
        double[] out = new double[16];
        for (int k = 0; k < 4; k++) {
            double[] arm = new double[3];
            for (int i = 0; i < 3; i++) {
                arm[i] = r[3 * i] * points[3 * k] + r[3 * i + 1] * points[3 * k + 1];
            }
            if (!state.lens.projectWithDerivatives(state.intrinsics, arm[0] + state.offset[0],
                    arm[1] + state.offset[1], arm[2] + state.offset[2], uv, byPoint, null)) {
                return null;
            }
            for (int c = 0; c < 2; c++) {
                for (int i = 0; i < 3; i++) {
                    out[2 * k + c] += byPoint[3 * c + i] * arm[i] / sizeMm;
                    out[8 + 2 * k + c] += byPoint[3 * c + i] * r[3 * i + 2];
                }
            }
        }
        return out;
    }
}
