package org.cellgauge.settings;

/** What is taken of the noise in an object's own corners. */
public enum ObjectNoise implements Word {
    /** The object's pose in the camera frame is sampled from its posterior given its corners: the default. */
    DETECTION("detection"),
    /** The object's pose in the camera frame is its best fit, taken as exact: the camera's part alone. */
    NONE("none");

    private final String word;

    ObjectNoise(String word) {
        this.word = word;
    }

    @Override
    public String word() {
        return word;
    }
}
