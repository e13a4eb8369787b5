package org.cellgauge.internal.validation;

import org.cellgauge.warning.RefusalKind;

/** Why a cell cannot be simulated, or a part of the sentence that says it. */
public enum ValidationRefusal implements RefusalKind {
    /** Markers hide each other: {@link #FARTHER_APART}. */
    MARKERS_HIDDEN("the markers hide each other, or reach out of the image, in nearly all true poses; %s"),
    /** A marker is out of sight: {@link #REFERENCE} or {@link #OBJECT}, {@link #OTHER_POSES}. */
    NOT_SEEN("%s is not seen from the camera pose: some corner is outside the image or it shows its back; %s"),
    /** Poses spread too wide: {@link #THE_REFERENCES} or {@link #OBJECT}, {@link #SMALLER_SPREAD}. */
    SPREAD_TOO_WIDE("true poses spread so wide hardly ever have %s in the image; %s"),
    /** Corner noise is to be simulated, and none is stated. */
    NO_CORNER_NOISE("the cell states no corner noise"),
    /** A marker cannot be seen at all. */
    MARKER_BEHIND_CAMERA("a marker is behind the camera"),
    /** A reference cannot be seen at all. */
    REFERENCE_BEHIND_CAMERA("a reference is behind the camera"),
    /** Nothing can be drawn from a flat prior. */
    FLAT_PRIOR("true focal lengths are drawn from what is known of them beforehand, and nothing can be drawn from a "
            + "flat prior: state how well they are known"),
    /** No layout was found. */
    NO_LAYOUT("no layout fits into the image"),

    // ---- parts

    /** All references. */
    THE_REFERENCES("the references"),
    /** A reference: id. */
    REFERENCE("reference %s"),
    /** An object: id. */
    OBJECT("object %s"),
    /** A remedy. */
    FARTHER_APART("give object poses farther apart, or a smaller spread"),
    /** A remedy. */
    OTHER_POSES("give another pose of the camera or of objects"),
    /** A remedy. */
    SMALLER_SPREAD("give a smaller spread");

    private final String english;

    ValidationRefusal(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
