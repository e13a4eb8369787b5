package org.cellgauge.settings;

/** The first estimates of the camera pose to choose from. */
public enum InitialEstimate implements Word {
    /** Mean of the camera poses that each reference gives alone (thesis, section 5.4). */
    AVERAGE("average"),
    /** Random sample consensus over all corners (thesis, Table 9.7). */
    RANSAC("ransac"),
    /** Perspective-n-point over all references at once, refined by least squares: the default. */
    PNP("pnp");

    private final String word;

    InitialEstimate(String word) {
        this.word = word;
    }

    @Override
    public String word() {
        return word;
    }
}
