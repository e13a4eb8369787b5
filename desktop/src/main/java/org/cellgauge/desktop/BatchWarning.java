package org.cellgauge.desktop;

import org.cellgauge.warning.WarningKind;

/** What a batch warns of besides the check. */
public enum BatchWarning implements WarningKind {
    /** Markers of a detections file that the cell does not know: ids. */
    FOREIGN_MARKERS("the detections file names markers that are not in the cell file: %s; they are ignored");

    private final String english;

    BatchWarning(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
