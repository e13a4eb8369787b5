package org.cellgauge.internal.posterior;

import org.cellgauge.cell.Placement;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.CornerCubeNoise;
import org.cellgauge.internal.pose.ReferenceView;

/**
 * The thesis' likelihood (section 5.3): each coordinate of each corner Gaussian on its own, with the deviation of the
 * projected box of {@link CornerCubeNoise} at the <em>proposed</em> pose:
 * {@code log L = - sum [ d² / (2 sigma²) + log sigma ]}.
 *
 * <p>Kept for comparison. It understates lateral deviations, because corners of one marker move together, and its
 * {@code log sigma} pulls the pose towards smaller projected boxes when the stated placement is coarser than the real
 * one. Allocates nothing; not thread-safe.
 */
public final class CornerCubeLikelihood implements CameraLikelihood {
    private final double[] points;
    private final double[] observed;
    private final double[] halfMm;
    private final double[] centresPx = new double[8];
    private final double[] stdPx = new double[8];

    /**
     * A likelihood.
     *
     * @param view references and their observed corners
     * @param kappa half extent of the box in placement deviations, positive
     * @throws IllegalArgumentException if kappa is not positive or the placement of a reference is stated as exact in
     *     all axes, which leaves this likelihood without a deviation
     */
    public CornerCubeLikelihood(ReferenceView view, double kappa) {
        if (!(kappa > 0)) {
            throw new IllegalArgumentException("kappa must be positive, not " + kappa);
        }
        points = view.pointsMm();
        observed = view.observedPx();
        halfMm = new double[3 * view.size()];
        for (int m = 0; m < view.size(); m++) {
            Placement placement = view.references().get(m).placement();
            double sum = 0;
            for (int i = 0; i < 3; i++) {
                halfMm[3 * m + i] = kappa * placement.stdMm(i);
                sum += placement.stdMm(i);
            }
            if (!(sum > 0)) {
                throw new IllegalArgumentException("corner-cube needs a placement deviation for reference "
                        + view.references().get(m).id());
            }
        }
    }

    @Override
    public double at(CameraState state) {
        double sum = 0;
        for (int p = 0, o = 0; p < points.length; p += 12, o += 8) {
            if (!CornerCubeNoise.markerStdPx(state, points, p, halfMm, p / 4, centresPx, stdPx)) {
                return Double.NEGATIVE_INFINITY;
            }
            double squares = 0;
            double product = 1;
            for (int i = 0; i < 8; i++) {
                double d = (observed[o + i] - centresPx[i]) / stdPx[i];
                squares += d * d;
                product *= stdPx[i];
            }
            // one logarithm for the eight deviations of a marker: it is the dearest operation here
            sum += 0.5 * squares + Math.log(product);
        }
        // an infinite sum comes of deviations that are 0, or so large or small that their product is none
        return Math.abs(sum) < Double.POSITIVE_INFINITY ? -sum : Double.NEGATIVE_INFINITY;
    }
}
