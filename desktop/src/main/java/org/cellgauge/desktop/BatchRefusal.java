package org.cellgauge.desktop;

import org.cellgauge.warning.RefusalKind;

/** Why an input of a batch has no result, but for what reading it refuses. */
public enum BatchRefusal implements RefusalKind {
    /** A file that was read cannot be read again: what the system says. */
    NOT_READABLE("it cannot be read (%s); check the disk"),
    /** A photo of another size than the detections file beside it states. */
    OTHER_SIZE("it is of another size than the detections file states"),

    // ---- judging stored results again

    /** There is no stored result: the folder. */
    NOT_STORED("no result of this input is in %s; check it first"),
    /** The stored result is of other bytes. */
    OTHER_INPUT("the stored result is of another file of this name; check it again"),
    /** The cell has changed, and not only its target. */
    OTHER_CELL("the stored result is of another cell: more than its target has changed; check it again"),
    /** The settings have changed, and not only the target. */
    OTHER_SETTINGS("the stored result was made with other settings; check it again"),
    /** A target with a probability, of which stored figures say nothing. */
    TOLERANCE_NEEDS_DRAWS("the target asks for a probability, which only draws tell; check it again");

    private final String english;

    BatchRefusal(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
