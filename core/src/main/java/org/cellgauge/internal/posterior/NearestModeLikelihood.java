package org.cellgauge.internal.posterior;

import java.util.List;
import java.util.function.Function;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceView;

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
    private final CameraLikelihood[] likelihoods;
    private final double[] rotations;

    /**
     * A likelihood.
     *
     * @param view references and their observed corners
     * @param modes modes of the camera pose that shows them, at least one
     */
    public NearestModeLikelihood(ReferenceView view, List<PoseMode> modes) {
        this(view, modes, null);
    }

    /**
     * A likelihood with an unknown noise.
     *
     * @param view references and their observed corners
     * @param modes modes of the camera pose that shows them, at least one
     * @param errors errors of these corners, with an added noise; null where it is the modes' own
     */
    public NearestModeLikelihood(ReferenceView view, List<PoseMode> modes, CornerErrors errors) {
        this(modes, mode -> errors == null ? new RigidMarkerLikelihood(view, mode)
                : new RigidMarkerLikelihood(view, mode, errors));
    }

    /**
     * A likelihood of any that are each right about one mode.
     *
     * @param modes modes of the camera pose, at least one
     * @param ofMode makes the likelihood about a mode
     */
    public NearestModeLikelihood(List<PoseMode> modes, Function<PoseMode, CameraLikelihood> ofMode) {
        likelihoods = new CameraLikelihood[modes.size()];
        rotations = new double[9 * likelihoods.length];
        for (int k = 0; k < likelihoods.length; k++) {
            likelihoods[k] = ofMode.apply(modes.get(k));
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
