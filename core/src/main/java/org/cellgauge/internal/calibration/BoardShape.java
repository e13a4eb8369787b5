package org.cellgauge.internal.calibration;

import org.cellgauge.vision.TargetPoints;

/**
 * What a target really looks like: its nominal points, how it is bent, and by how much it is stretched in y.
 *
 * <p>A bent board stands out of its plane by {@code z = w1 (1 - x²) + w2 (1 - y²) + w3 xy + w4 x (1 - x²)
 * + w5 y (1 - y²)}, x and y from -1 to 1 over the points: mrcal's parabolas (D. Kogan, its documentation), a
 * twist and a curvature that changes along the board. Turns and shifts of the whole board are none of these, so that
 * poses take nothing from them.
 */
final class BoardShape {
    /** A board is bent by about a hundredth of its size at most: proper, and far wider than what is found. */
    private static final double WARP_PRIOR_SHARE = 0.01;
    /** How much printers stretch in one direction. */
    private static final double ASPECT_PRIOR = 0.002;

    final double[] xyzMm;
    final double[] basis;
    final int warp;
    final boolean aspect;
    final double warpPriorStdMm;

    /**
     * A shape.
     *
     * @param points nominal points
     * @param warp coefficients of the warp, 0 to 5
     * @param aspect whether the stretch is unknown
     */
    BoardShape(TargetPoints points, int warp, boolean aspect) {
        xyzMm = points.xyzMm();
        this.warp = warp;
        this.aspect = aspect;
        basis = new double[warp * points.count()];
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int i = 0; i < xyzMm.length; i += 3) {
            for (int k = 0; k < 2; k++) {
                low[k] = Math.min(low[k], xyzMm[i + k]);
                high[k] = Math.max(high[k], xyzMm[i + k]);
            }
        }
        warpPriorStdMm = WARP_PRIOR_SHARE * Math.max(high[0] - low[0], high[1] - low[1]);
        for (int i = 0; i < points.count() && warp > 0; i++) {
            double x = (2 * xyzMm[3 * i] - low[0] - high[0]) / (high[0] - low[0]);
            double y = (2 * xyzMm[3 * i + 1] - low[1] - high[1]) / (high[1] - low[1]);
            double[] all = {1 - x * x, 1 - y * y, x * y, x * (1 - x * x), y * (1 - y * y)};
            System.arraycopy(all, 0, basis, i * warp, warp);
        }
    }

    /** Unknowns of the shape. */
    int unknowns() {
        return warp + (aspect ? 1 : 0);
    }

    /** Deviation of an unknown before any photo is seen: mm of warp, a share of stretch. */
    double priorStd(int unknown) {
        return unknown < warp ? warpPriorStdMm : ASPECT_PRIOR;
    }

    /** A point as the board really has it: 3 values. */
    void point(int index, double[] values, int offset, double[] out) {
        out[0] = xyzMm[3 * index];
        out[1] = xyzMm[3 * index + 1] * (aspect ? 1 + values[offset + warp] : 1);
        out[2] = xyzMm[3 * index + 2];
        for (int k = 0; k < warp; k++) {
            out[2] += values[offset + k] * basis[index * warp + k];
        }
    }
}
