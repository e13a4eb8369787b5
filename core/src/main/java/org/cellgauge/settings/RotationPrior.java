package org.cellgauge.settings;

/** What is taken of the camera's rotation beforehand. */
public enum RotationPrior implements Word {
    /** Every rotation alike (Haar measure), no direction of the world is special: the default. */
    UNIFORM("uniform"),
    /** Flat in the Euler angles, as the thesis has it without saying so; it favours theta near +-90 degrees. */
    FLAT_IN_EULER_ANGLES("flat-in-euler-angles");

    private final String word;

    RotationPrior(String word) {
        this.word = word;
    }

    @Override
    public String word() {
        return word;
    }
}
