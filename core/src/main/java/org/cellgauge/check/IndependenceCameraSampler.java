package org.cellgauge.check;

import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.posterior.CameraPosterior;
import org.cellgauge.sampling.ImportanceTuning;
import org.cellgauge.sampling.MetropolisChain;
import org.cellgauge.sampling.StudentTMixture;

/** Independence Metropolis in the centred chart with a t mixture that importance sampling has fitted. */
final class IndependenceCameraSampler implements CameraSampler {
    @Override
    public Tuned tune(CameraTarget target, RandomGenerator random) {
        ImportanceTuning tuning = TunedMixture.tune(target.centred(), target.modes, random);
        return new Tuned() {
            @Override
            public CameraChain chain(RandomGenerator chainRandom) {
                CameraPosterior posterior = target.centred();
                StudentTMixture proposal = tuning.proposal().copy();
                double[] start = TunedMixture.start(proposal, posterior, chainRandom);
                return new CameraChain(new MetropolisChain(posterior, List.of(proposal), start, chainRandom),
                        posterior.chart(), () -> { });
            }

            @Override
            public double efficiency() {
                return tuning.efficiency();
            }
        };
    }
}
