package org.cellgauge.internal.chains;

import org.apache.commons.math3.random.RandomGenerator;
import org.cellgauge.internal.posterior.CameraChart;
import org.cellgauge.internal.sampling.MetropolisChain;
import org.cellgauge.settings.SamplerKind;
import org.cellgauge.warning.Warning;

/** A way to sample the camera posterior: tuned once, then it makes the chains. */
public interface CameraSampler {
    /**
     * The sampler of a kind.
     *
     * @param kind as the settings have it
     * @return a sampler without state
     */
    static CameraSampler of(SamplerKind kind) {
        switch (kind) {
            case INDEPENDENCE:
                return new IndependenceCameraSampler();
            case ADAPTIVE:
                return new AdaptiveCameraSampler();
            default:
                return new ThesisCameraSampler();
        }
    }

    /**
     * Tunes on a target.
     *
     * @param target the posterior
     * @param random source of randomness of the tuning
     * @return what makes the chains
     */
    Tuned tune(CameraTarget target, RandomGenerator random);

    /** Makes the chains of one target. */
    interface Tuned {
        /**
         * One chain with a density of its own.
         *
         * @param random the chain's source of randomness
         * @return the chain and what reads its coordinates
         */
        CameraChain chain(RandomGenerator random);

        /**
         * Whether the chains would hardly move, judged by what the tuning saw.
         *
         * @return why, or null where nothing speaks against this sampler
         */
        default Warning misfit() {
            return null;
        }

        /** How often the tuning has evaluated the posterior. */
        long evaluations();
    }

    /** A chain with the chart of its coordinates and what to do at the end of the warm-up. */
    final class CameraChain {
        final MetropolisChain chain;
        final CameraChart chart;
        final Runnable warmedUp;

        CameraChain(MetropolisChain chain, CameraChart chart, Runnable warmedUp) {
            this.chain = chain;
            this.chart = chart;
            this.warmedUp = warmedUp;
        }
    }
}
