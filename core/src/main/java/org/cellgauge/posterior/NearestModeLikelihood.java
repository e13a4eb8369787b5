package org.cellgauge.posterior;

import java.util.List;
import org.cellgauge.pose.CameraState;
import org.cellgauge.pose.PoseMode;

/**
 * Likelihood of rigidly misplaced references with several modes: at each pose that of the mode whose rotation is the
 * nearest, since what is frozen at one mode (where the references seem to stand, covariances of residuals) does not
 * hold at another.
 *
 * <p>Each keeps its log-determinant, so their masses compare as in Laplace's method with the placement errors as
 * unknowns. Half-way between two modes the density has a step; little mass is there, and Metropolis needs no
 * derivative. Allocates nothing; not thread-safe.
 */
public final class NearestModeLikelihood implements CameraLikelihood {
    private final RigidMarkerLikelihood[] likelihoods;
    private final double[] rotations;

    /**
     * A likelihood.
     *
     * @param modes modes of the camera pose, at least one
     */
    public NearestModeLikelihood(List<PoseMode> modes) {
        likelihoods = new RigidMarkerLikelihood[modes.size()];
        rotations = new double[9 * likelihoods.length];
        for (int k = 0; k < likelihoods.length; k++) {
            likelihoods[k] = new RigidMarkerLikelihood(modes.get(k));
            System.arraycopy(modes.get(k).state().rotation, 0, rotations, 9 * k, 9);
        }
    }

    @Override
    public double at(CameraState state) {
        int nearest = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < likelihoods.length; k++) {
            // trace of R_k^T R = 1 + 2 cos(angle between the two)
            double trace = 0;
            for (int i = 0; i < 9; i++) {
                trace += rotations[9 * k + i] * state.rotation[i];
            }
            if (trace > most) {
                most = trace;
                nearest = k;
            }
        }
        return likelihoods[nearest].at(state);
    }
}
