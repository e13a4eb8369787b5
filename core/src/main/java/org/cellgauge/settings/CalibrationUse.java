package org.cellgauge.settings;

/** What is made of the covariance that a camera file may state of its intrinsics. */
public enum CalibrationUse implements Word {
    /** It is the joint prior of the intrinsics, which are unknown then: the default. */
    UNCERTAIN("uncertain"),
    /** The intrinsics count as exact whatever it says. */
    EXACT("exact");

    private final String word;

    CalibrationUse(String word) {
        this.word = word;
    }

    @Override
    public String word() {
        return word;
    }
}
