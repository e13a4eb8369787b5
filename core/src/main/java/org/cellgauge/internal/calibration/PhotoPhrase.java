package org.cellgauge.internal.calibration;

import org.cellgauge.warning.WarningKind;

/** Parts of the sentence that says which photo to take next. */
public enum PhotoPhrase implements WarningKind {
    /** A place: row and column. */
    AT_PLACE("in the %s %s of the image"),
    /** The place. */
    IN_MIDDLE("in the middle of the image"),
    /** A row. */
    TOP("upper"),
    /** A row. */
    MIDDLE_ROW("middle"),
    /** A row. */
    BOTTOM("lower"),
    /** A column. */
    LEFT("left"),
    /** A column. */
    CENTRE("centre"),
    /** A column. */
    RIGHT("right"),
    /** The distance: mm. */
    AT_DISTANCE("at about %s mm"),
    /** A tilt. */
    FACING("facing the camera"),
    /** A tilt: degrees, {@link #LEFT_EDGE} and the like. */
    TILTED("tilted by %s degrees with %s nearer"),
    /** An edge. */
    LEFT_EDGE("its left edge"),
    /** An edge. */
    RIGHT_EDGE("its right edge"),
    /** An edge. */
    UPPER_EDGE("its upper edge"),
    /** An edge. */
    LOWER_EDGE("its lower edge");

    private final String english;

    PhotoPhrase(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
