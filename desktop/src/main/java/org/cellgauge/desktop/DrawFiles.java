package org.cellgauge.desktop;

import org.cellgauge.check.CheckResult;

/** Which draws of the chains go into files beside a result ({@code NAME.chain-K.csv}). */
public enum DrawFiles {
    /** None. */
    NONE,
    /**
     * {@value #MOST_DRAWS} of each chain, fewer where the files would take more than {@value #MOST_MB} MB together;
     * longer chains are thinned evenly.
     */
    BOUNDED,
    /** All that were kept. */
    ALL;

    static final int MOST_DRAWS = 1000;
    static final int MOST_MB = 20;

    /** The longest that a double becomes in text, -1.7976931348623157E308, and a comma. */
    private static final int BYTES_A_NUMBER = 25;

    /** How many draws of each chain are written at most. */
    int most(CheckResult result) {
        int mostBySize = (int) Math.max(1, MOST_MB * 1_000_000L
                / ((long) BYTES_A_NUMBER * result.draws().size() * result.layout().names().size()));
        return this == ALL ? Integer.MAX_VALUE : Math.min(MOST_DRAWS, mostBySize);
    }
}
