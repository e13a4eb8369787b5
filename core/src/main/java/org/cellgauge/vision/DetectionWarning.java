package org.cellgauge.vision;

import org.cellgauge.warning.WarningKind;

/** What a detector has to say of the markers of an image. Places are the centres of markers, px. */
public enum DetectionWarning implements WarningKind {
    /** Cells are of no marker of the cell: id as it was read at first, u, v. */
    CELLS_DO_NOT_MATCH("what looks like marker %s at (%s, %s) px is left out: its cells do not match; if it is that "
            + "marker, use a larger one, a closer camera, a sharper image or more light"),
    /** A marker without a checksum whose edges cannot be fitted: id, u, v. */
    EDGES_NOT_MEASURED("what looks like marker %s at (%s, %s) px is left out: its edges cannot be measured; if it is "
            + "that marker, use a larger one, a closer camera, a sharper image or more light"),
    /** No pose of a square explains the corners: id, u, v, what they miss it by, px, the limit, px. */
    NOT_SQUARE("marker %s at (%s, %s) px is left out: its corners miss those of a square by %s px (limit %s); look for "
            + "something that covers or bends it, or for another pattern taken for it"),
    /** One id at two places: id, u, v of one, u, v of the other. */
    SEEN_TWICE("marker %s is seen at (%s, %s) px and at (%s, %s) px and is left out at both; an id may stand only once "
            + "in view: remove or cover the other"),
    /** The edges cannot be fitted, and the corners are those of the first look: id. */
    COARSE_CORNERS("marker %s: its edges are too blurred, short or covered to be measured finely; its corners are "
            + "coarse");

    private final String english;

    DetectionWarning(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
