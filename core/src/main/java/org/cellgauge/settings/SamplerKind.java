package org.cellgauge.settings;

/** The samplers to choose from. */
public enum SamplerKind implements Word {
    /** Independence Metropolis with a t mixture fitted to the posterior: the default. */
    INDEPENDENCE("independence"),
    /** Adaptive Metropolis in the centred chart, for posteriors far from Gaussian. */
    ADAPTIVE("adaptive"),
    /** The thesis' mixture of steps in position or Euler angles alone. */
    THESIS_MIXTURE("thesis-mixture");

    private final String word;

    SamplerKind(String word) {
        this.word = word;
    }

    @Override
    public String word() {
        return word;
    }
}
