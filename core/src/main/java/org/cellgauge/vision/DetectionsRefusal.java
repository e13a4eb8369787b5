package org.cellgauge.vision;

import org.cellgauge.warning.RefusalKind;

/** Why a detections file cannot be used. */
public enum DetectionsRefusal implements RefusalKind {
    /** The end is missing. */
    CUT_SHORT("the file ends in the middle of it; write it again in full"),
    /** A syntax error. */
    JSON_SYNTAX("not valid JSON; check commas, quotes and brackets near this place, and that numbers are finite"),
    /** Another fault of the reader: what it says. */
    NOT_JSON("not readable as JSON (%s); write it again"),
    /** Something after the end. */
    MORE_TEXT("more text follows after the end; delete it"),
    /** Something else stands here: what was expected, what stands there, what to write. */
    EXPECTED("expected %s, got %s; %s"),
    /** A key twice. */
    KEY_TWICE("stands twice; keep one of the two"),
    /** A key that means nothing here: known ones. */
    UNKNOWN_KEY("unknown key; known here: %s"),
    /** A key that must stand here: what to add. */
    MISSING("is missing; add %s"),
    /** A tone curve that is none: the words. */
    NO_TONE_CURVE("'%s' is no tone curve; write srgb, linear or gamma G, for instance gamma 2.2"),
    /** A power that no camera has: its name, smallest, largest, what stands there. */
    TONE_CURVE_OUT_OF_RANGE("%s must be between %s and %s, not %s"),
    /** An id twice: id, key of the first. */
    MARKER_TWICE("marker %s was already given as %s; keep the true one of the two"),
    /** An edge shift alone: id. */
    SHIFT_WITHOUT_COVARIANCE("marker %s states an edge shift without the covariance of its corners; add "
            + "covariance_px2, or leave edge_shift out"),
    /** A covariance that is none: id, a value, its row and column, its mirror value, row and column, what to write. */
    NOT_SYMMETRIC("the covariance of marker %s is not symmetric: %s in row %s, column %s, but %s in row %s, column %s; "
            + "%s"),
    /** A covariance that is none: id, what to write. */
    NOT_POSITIVE_DEFINITE("the covariance of marker %s is not positive definite: some combination of its corners would "
            + "have no variance or a negative one; %s"),
    /** Covariances of corners and shift: id, what to write. */
    COVARIANCES_CONTRADICT("the covariances of marker %s and of its edge shift contradict each other: together they "
            + "are not positive definite; %s"),
    /** A corner far outside: u, v, id, width and height of the image, px. */
    CORNER_OUTSIDE("corner (%s, %s) of marker %s lies far outside of the image of %s x %s px; check the image's size "
            + "and that corners are in px of this image"),
    /** Corners at one point or on a line: id, what to write. */
    NO_AREA("the corners of marker %s enclose no area; %s, in px and not as shares of the image"),
    /** Corners the other way round: id, what to write. */
    MIRRORED("the corners of marker %s run counter-clockwise, as in a mirror; %s"),
    /** Corners out of order: id, what to write. */
    CROSSES_ITSELF("the outline of marker %s crosses itself; %s"),
    /** Corners of no square: id, what to write. */
    NO_SQUARE("the corners of marker %s are no picture of a square; %s");

    private final String english;

    DetectionsRefusal(String english) {
        this.english = english;
    }

    @Override
    public String code() {
        return "detections-" + RefusalKind.super.code();
    }

    @Override
    public String english() {
        return english;
    }
}
