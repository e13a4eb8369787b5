package org.cellgauge.internal.chains;

import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.internal.posterior.CameraPosterior;
import org.cellgauge.internal.sampling.AdaptiveStep;
import org.cellgauge.internal.sampling.ImportanceTuning;
import org.cellgauge.internal.sampling.MetropolisChain;

/** Adaptive Metropolis in the centred chart, started from the covariance that importance sampling has found. */
final class AdaptiveCameraSampler implements CameraSampler {
    @Override
    public Tuned tune(CameraTarget target, RandomGenerator random) {
        ImportanceTuning tuning = TunedMixture.tune(target.centred(), target.mixture(), random);
        return new Tuned() {
            @Override
            public CameraChain chain(RandomGenerator chainRandom) {
                CameraPosterior posterior = target.centred();
                AdaptiveStep step = new AdaptiveStep(tuning.proposal().scale(tuning.proposal().heaviest()),
                        posterior.dimension());
                double[] start = TunedMixture.start(tuning.proposal().copy(), posterior, chainRandom);
                return new CameraChain(new MetropolisChain(posterior, List.of(step), start, chainRandom),
                        posterior.chart(), step::freeze);
            }

            @Override
            public long evaluations() {
                return tuning.evaluations();
            }
        };
    }
}
