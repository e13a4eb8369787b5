package org.cellgauge.check;

import java.util.List;
import org.cellgauge.pose.CornerCubeNoise;
import org.cellgauge.pose.CornerErrors;
import org.cellgauge.pose.PoseMode;
import org.cellgauge.pose.ReferenceNoise;
import org.cellgauge.pose.ReferenceView;
import org.cellgauge.pose.RigidMarkerNoise;
import org.cellgauge.posterior.CameraLikelihood;
import org.cellgauge.posterior.CornerCubeLikelihood;
import org.cellgauge.posterior.MovingRigidLikelihood;
import org.cellgauge.posterior.NearestModeLikelihood;
import org.cellgauge.posterior.RigidMarkerLikelihood;
import org.cellgauge.settings.LikelihoodModel;

/** What each likelihood model makes of the references seen: covariances for fits, likelihoods for chains. */
enum Likelihoods {
    /** References misplaced rigidly, corners noisy: the default. */
    RIGID_MARKER {
        @Override
        ReferenceNoise noise(ReferenceView view, CornerErrors errors, double noise, double kappa) {
            return new RigidMarkerNoise(view, errors, noise);
        }

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
        ReferenceNoise noise(ReferenceView view, CornerErrors errors, double noise, double kappa) {
            return new CornerCubeNoise(view, kappa);
        }

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
     * @return its covariances and likelihoods
     */
    static Likelihoods of(LikelihoodModel model) {
        return model == LikelihoodModel.RIGID_MARKER ? RIGID_MARKER : CORNER_CUBE;
    }

    /** Residual covariances for fits, at an added noise. */
    abstract ReferenceNoise noise(ReferenceView view, CornerErrors errors, double noise, double kappa);

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
