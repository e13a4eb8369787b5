package org.cellgauge.check;

/** The samplers to choose from. */
public enum SamplerKind {
    /** Independence Metropolis with a t mixture fitted to the posterior: the default. */
    INDEPENDENCE("independence", new IndependenceCameraSampler()),
    /** Adaptive Metropolis in the centred chart, for posteriors far from Gaussian. */
    ADAPTIVE("adaptive", new AdaptiveCameraSampler()),
    /** The thesis' mixture of steps in position or Euler angles alone. */
    THESIS_MIXTURE("thesis-mixture", new ThesisCameraSampler());

    private final String optionName;
    private final CameraSampler sampler;

    SamplerKind(String optionName, CameraSampler sampler) {
        this.optionName = optionName;
        this.sampler = sampler;
    }

    /**
     * Its word in settings and files.
     *
     * @return for instance {@code independence}
     */
    public String optionName() {
        return optionName;
    }

    CameraSampler sampler() {
        return sampler;
    }
}
