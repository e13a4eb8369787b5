package org.cellgauge.internal.chains;

import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.internal.posterior.CameraPosterior;
import org.cellgauge.internal.sampling.ImportanceTuning;
import org.cellgauge.internal.sampling.MetropolisChain;
import org.cellgauge.internal.sampling.StudentTMixture;
import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.warning.Warning;

/** Independence Metropolis in the centred chart with a t mixture that importance sampling has fitted. */
final class IndependenceCameraSampler implements CameraSampler {
    /** Effective share of importance draws below which a random walk does better. */
    private static final double POOR_EFFICIENCY = 0.05;
    /** Share of accepted steps of a short chain below which a random walk does better. */
    private static final double POOR_ACCEPTANCE = 0.1;
    private static final int PILOT_STEPS = 1000;

    @Override
    public Tuned tune(CameraTarget target, RandomGenerator random) {
        ImportanceTuning tuning = TunedMixture.tune(target.centred(), target.mixture(), random);
        double acceptance = pilotAcceptance(target.centred(), tuning.proposal().copy(), random);
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
            public Warning misfit() {
                return tuning.efficiency() < POOR_EFFICIENCY || acceptance < POOR_ACCEPTANCE
                        ? Warning.of(CheckPhrase.MISFIT, Decimal.of(100 * tuning.efficiency(), 0),
                                Decimal.of(100 * acceptance, 0)) : null;
            }

            @Override
            public long evaluations() {
                return tuning.evaluations() + PILOT_STEPS;
            }
        };
    }

    /** What share of its steps a short chain accepts: the importance weights alone do not show where a chain sticks. */
    private static double pilotAcceptance(CameraPosterior posterior, StudentTMixture proposal, RandomGenerator random) {
        double[] start = TunedMixture.start(proposal, posterior, random);
        if (!Double.isFinite(posterior.at(start))) {
            return 0;
        }
        MetropolisChain pilot = new MetropolisChain(posterior, List.of(proposal), start, random);
        for (int i = 0; i < PILOT_STEPS; i++) {
            pilot.step();
        }
        return pilot.acceptance().get(0).rate();
    }
}
