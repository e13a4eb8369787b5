package org.cellgauge.internal.chains;

import java.util.List;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.pose.PoseMode;
import org.cellgauge.internal.pose.ReferenceNoise;
import org.cellgauge.internal.pose.ReferenceView;
import org.cellgauge.internal.posterior.CameraLikelihood;
import org.cellgauge.internal.posterior.CornerCubeLikelihood;
import org.cellgauge.internal.posterior.MovingRigidLikelihood;
import org.cellgauge.internal.posterior.NearestModeLikelihood;
import org.cellgauge.internal.posterior.RigidMarkerLikelihood;
import org.cellgauge.settings.LikelihoodModel;

/** The likelihood of the references seen, by model. */
enum Likelihoods {
    /** References misplaced rigidly, corners noisy: the default. */
    RIGID_MARKER {
        @Override
        CameraLikelihood likelihood(ReferenceView view, List<PoseMode> modes, CornerErrors errors,
                double kappa) {
            if (modes.size() > 1) {
                return new NearestModeLikelihood(view, modes, errors);
            }
            return errors == null ? new RigidMarkerLikelihood(view, modes.get(0))
                    : new RigidMarkerLikelihood(view, modes.get(0), errors);
        }

        @Override
        CameraLikelihood farReaching(ReferenceView view, List<PoseMode> modes, ReferenceNoise noise,
                CornerErrors errors, double kappa) {
            return modes.size() > 1
                    ? new NearestModeLikelihood(modes, mode -> new MovingRigidLikelihood(view, mode, noise, errors))
                    : new MovingRigidLikelihood(view, modes.get(0), noise, errors);
        }
    },
    /** The thesis' likelihood: every corner on its own, deviations of a projected box. */
    CORNER_CUBE {
        @Override
        CameraLikelihood likelihood(ReferenceView view, List<PoseMode> modes, CornerErrors errors,
                double kappa) {
            return new CornerCubeLikelihood(view, kappa);
        }
    };

    /**
     * What belongs to a model.
     *
     * @param model as the settings have it
     * @return its likelihoods
     */
    static Likelihoods of(LikelihoodModel model) {
        return model == LikelihoodModel.RIGID_MARKER ? RIGID_MARKER : CORNER_CUBE;
    }

    /**
     * A likelihood of its own for one chain.
     *
     * @param errors errors of the corners where their noise is sampled; null where it is that of the modes
     */
    abstract CameraLikelihood likelihood(ReferenceView view, List<PoseMode> modes, CornerErrors errors,
            double kappa);

    /**
     * The same for posteriors that reach far from their modes, as with unknown intrinsics, where what is frozen at a
     * mode does not hold.
     *
     * @param noise of the view
     */
    CameraLikelihood farReaching(ReferenceView view, List<PoseMode> modes, ReferenceNoise noise, CornerErrors errors,
            double kappa) {
        return likelihood(view, modes, errors, kappa);
    }
}
