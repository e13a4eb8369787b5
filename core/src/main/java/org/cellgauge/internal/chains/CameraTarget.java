package org.cellgauge.internal.chains;

import org.cellgauge.internal.laplace.CameraFit;
import org.cellgauge.internal.pose.CornerErrors;
import org.cellgauge.internal.posterior.CameraChart;
import org.cellgauge.internal.posterior.CameraLikelihood;
import org.cellgauge.internal.posterior.CameraPosterior;
import org.cellgauge.internal.posterior.CentredChart;
import org.cellgauge.internal.posterior.EulerChart;
import org.cellgauge.internal.posterior.SharedPrior;
import org.cellgauge.internal.sampling.StudentTMixture;
import org.cellgauge.settings.ModelSettings;

/** The camera posterior of one photo, as the samplers need it; immutable. */
public final class CameraTarget {
    final CameraFit fit;

    /**
     * A target.
     *
     * @param fit the camera at its modes
     */
    public CameraTarget(CameraFit fit) {
        this.fit = fit;
    }

    /** The posterior in the centred chart about the heaviest mode, a new instance for one thread. */
    public CameraPosterior centred() {
        return posterior(new CentredChart(fit.mode().state(), fit.intrinsicsPrior, fit.belief != null));
    }

    /** The posterior in the thesis' coordinates, a new instance for one thread. */
    public CameraPosterior euler() {
        return posterior(new EulerChart(fit.view.centroidMm(), fit.mode().state(), fit.intrinsicsPrior,
                fit.belief != null));
    }

    /** Laplace's approximation at each mode, with what is known of the noise, in the centred chart. */
    StudentTMixture mixture() {
        return TunedMixture.ofModes(fit.modes, fit.belief);
    }

    private CameraPosterior posterior(CameraChart chart) {
        ModelSettings model = fit.settings.model();
        Likelihoods likelihoods = Likelihoods.of(model.likelihood());
        double kappa = model.kappa();
        CornerErrors sampled = fit.belief == null ? null : fit.errors;
        CameraLikelihood likelihood = fit.intrinsicsPrior.count() == 0
                ? likelihoods.likelihood(fit.view, fit.modes, sampled, kappa)
                : likelihoods.farReaching(fit.view, fit.modes, fit.noise(fit.view, fit.noiseLevel), sampled,
                        kappa);
        boolean shared = fit.view.unknowns() > 0 || fit.belief != null;
        return new CameraPosterior(chart, likelihood, model.rotationPrior(), fit.intrinsicsPrior, fit.posePrior,
                shared ? new SharedPrior(fit.logNoise) : null);
    }
}
