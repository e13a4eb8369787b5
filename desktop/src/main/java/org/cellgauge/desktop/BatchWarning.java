package org.cellgauge.desktop;

import org.cellgauge.warning.WarningKind;

/** What a batch warns of besides the check. */
public enum BatchWarning implements WarningKind {
    /** Markers of a detections file that the cell does not know: ids. */
    FOREIGN_MARKERS("the detections file names markers that are not in the cell file: %s; they are ignored"),

    /** The camera was scaled to a photo: the calibrated width and height, those of the photo, px. */
    CAMERA_SCALED("the camera was scaled from the calibrated %s x %s px to this photo's %s x %s px: that holds where "
            + "the photo is the whole image, binned or scaled, and not where the camera's mode shows another part");

    private final String english;

    BatchWarning(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
