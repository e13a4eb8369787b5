package org.cellgauge.internal.chains;

import org.cellgauge.internal.laplace.ObjectFit;
import org.cellgauge.internal.pose.CameraState;
import org.cellgauge.internal.pose.IntrinsicsPrior;
import org.cellgauge.internal.posterior.ObjectPosterior;
import org.cellgauge.internal.sampling.StudentTMixture;

/** The posterior of one object's pose before the camera, and the proposal fitted to it; immutable. */
public final class ObjectTarget {
    /** The object at its modes. */
    public final ObjectFit fit;
    final StudentTMixture proposal;

    /**
     * An object.
     *
     * @param fit its modes
     * @param proposal of its chains
     */
    ObjectTarget(ObjectFit fit, StudentTMixture proposal) {
        this.fit = fit;
        this.proposal = proposal;
    }

    /** An object with Laplace's approximation at its modes as proposal. */
    public static ObjectTarget ofModes(ObjectFit fit) {
        return new ObjectTarget(fit, TunedMixture.ofModes(fit.modes));
    }

    /**
     * The same object with another proposal.
     *
     * @param fitted a mixture in the chart of the object's posterior; kept
     * @return a new target
     */
    public ObjectTarget withProposal(StudentTMixture fitted) {
        return new ObjectTarget(fit, fitted);
    }

    /** The density, a new instance for one thread. */
    public ObjectPosterior posterior() {
        CameraState base = fit.modes.get(0).state();
        if (fit.errors.isPlain()) {
            return new ObjectPosterior(fit.cornersPx, fit.marker.sizeMm(), fit.errors.statedStdPx(), base);
        }
        base.unknowns = fit.camera.unknowns.clone();
        base.noise = fit.camera.noise;
        double[] answers = fit.answers(0, new ObjectFit.AnswerSpace(fit.errors, IntrinsicsPrior.KNOWN));
        return new ObjectPosterior(fit.errors, fit.marker.id(), fit.marker.sizeMm(), answers, base,
                fit.modes.size() == 1);
    }
}
