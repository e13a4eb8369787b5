package org.cellgauge.settings;

/** The likelihoods to choose from. */
public enum LikelihoodModel implements Word {
    /** References misplaced rigidly, corners noisy: the default. */
    RIGID_MARKER("rigid-marker"),
    /** The thesis' likelihood: every corner on its own, deviations of a projected box. */
    CORNER_CUBE("corner-cube");

    private final String word;

    LikelihoodModel(String word) {
        this.word = word;
    }

    @Override
    public String word() {
        return word;
    }
}
