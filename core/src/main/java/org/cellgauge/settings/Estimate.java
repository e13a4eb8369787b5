package org.cellgauge.settings;

/** Which intrinsics are estimated along with the pose, with priors that are wider than any calibration. */
public enum Estimate implements Word {
    /** None: they are as well known as the camera file says, exactly where it says nothing of that: the default. */
    NONE("none"),
    /** Focal lengths fx and fy are unknown. */
    FOCAL("focal"),
    /** Focal lengths, principal point and the first two coefficients of the lens's radial polynomial are unknown. */
    INTRINSICS("intrinsics");

    private final String word;

    Estimate(String word) {
        this.word = word;
    }

    @Override
    public String word() {
        return word;
    }
}
