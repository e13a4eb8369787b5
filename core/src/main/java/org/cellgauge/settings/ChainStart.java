package org.cellgauge.settings;

/** Where the chains of a random walk start. */
public enum ChainStart implements Word {
    /** At draws around the mode, wider than the posterior: the default. */
    DISPERSED("dispersed"),
    /** At the initial estimate, as in the thesis. */
    INITIAL_ESTIMATE("initial-estimate");

    private final String word;

    ChainStart(String word) {
        this.word = word;
    }

    @Override
    public String word() {
        return word;
    }
}
