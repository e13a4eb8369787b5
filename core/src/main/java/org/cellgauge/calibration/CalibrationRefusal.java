package org.cellgauge.calibration;

import org.cellgauge.warning.RefusalKind;

/** Why photos give no calibration, with what to photograph next. */
public enum CalibrationRefusal implements RefusalKind {
    /** Too few photos show the target: how many do, how many were given, how many it takes. */
    TOO_FEW_PHOTOS("the target was found in %s of %s photos, and a calibration takes at least %s; take more with the "
            + "target sharp and wholly in the image, tilted by 30 to 45 degrees to all sides, and check that the "
            + "target file describes it"),
    /** Photos of several sizes: name, width, height, name, width, height. */
    SIZES_DIFFER("%s has %s x %s px and %s has %s x %s px; calibrate on photos of one size, the one the camera will be "
            + "used at"),
    /** No focal length follows from the photos: largest tilt, degrees. */
    FOCAL_UNKNOWN("the photos do not tell the focal length: the target is never tilted by more than %s degrees; take "
            + "photos with it tilted by 30 to 45 degrees to the left, to the right, up and down"),
    /** The focal length is known too badly: its deviation in per cent, the next photo. */
    FOCAL_TOO_UNSURE("the photos tell the focal length to %s %% only; %s"),
    /** A lens of which two directions fall together within the image: its name, a pixel there. */
    LENS_FOLDS("with the lens %s the photos lead to coefficients that fold the image over near pixel (%s, %s), so they "
            + "do not tell them; take photos with the target near the image's borders, or name a leaner lens, "
            + "or for a very wide one that of a quotient of polynomials or a fisheye's"),
    /** Nothing explains the photos: rms, px. */
    NOTHING_FITS("no camera explains the photos: corners are off by %s px; check rows, columns and sizes in the target "
            + "file, and that all photos are of one camera, its zoom and focus unchanged");

    private final String english;

    CalibrationRefusal(String english) {
        this.english = english;
    }

    @Override
    public String code() {
        return "calibration-" + RefusalKind.super.code();
    }

    @Override
    public String english() {
        return english;
    }
}
