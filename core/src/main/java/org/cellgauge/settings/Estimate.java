package org.cellgauge.settings;

/** Which intrinsics are sampled along with the pose. */
public enum Estimate implements Word {
    /** All intrinsics are taken as the camera file has them: the default. */
    NONE("none"),
    /** Focal lengths fx and fy are unknown. */
    FOCAL("focal");

    private final String word;

    Estimate(String word) {
        this.word = word;
    }

    @Override
    public String word() {
        return word;
    }
}
