package org.cellgauge.internal.chains;

import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.internal.posterior.CameraPosterior;
import org.cellgauge.internal.sampling.MetropolisChain;
import org.cellgauge.internal.sampling.StudentTMixture;
import org.cellgauge.internal.sampling.ThesisMixture;
import org.cellgauge.settings.ChainStart;

/** The thesis' mixture of steps in position or Euler angles alone. */
final class ThesisCameraSampler implements CameraSampler {
    @Override
    public Tuned tune(CameraTarget target, RandomGenerator random) {
        return new Tuned() {
            @Override
            public CameraChain chain(RandomGenerator chainRandom) {
                CameraPosterior posterior = target.euler();
                double[] start;
                if (target.fit.settings.sampling().start() == ChainStart.INITIAL_ESTIMATE) {
                    start = posterior.chart().encode(target.fit.initialState());
                } else {
                    CameraPosterior centred = target.centred();
                    StudentTMixture around = target.mixture();
                    org.cellgauge.internal.pose.CameraState state = new org.cellgauge.internal.pose.CameraState();
                    centred.chart().decode(TunedMixture.start(around, centred, chainRandom), state);
                    start = posterior.chart().encode(state);
                }
                return new CameraChain(new MetropolisChain(posterior,
                        ThesisMixture.proposals(posterior.chart().layout(), target.fit.intrinsicsPrior), start,
                        chainRandom),
                        posterior.chart(), () -> { });
            }

            @Override
            public long evaluations() {
                return 0;
            }
        };
    }
}
