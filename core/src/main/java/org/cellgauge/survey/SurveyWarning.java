package org.cellgauge.survey;

import org.cellgauge.warning.WarningKind;

/** What users of a survey should know. */
public enum SurveyWarning implements WarningKind {
    /** A photo of another size than the camera is calibrated for: its name, its width and height, those calibrated. */
    OTHER_SIZE("%s is left out: it is %s x %s px, but the camera is calibrated for %s x %s px"),
    /** A photo that shows nothing that others show: its name. */
    NOT_LINKED("%s is left out: it shows no reference, and no object that another photo shows with references"),
    /** A photo twice: its name, the other's. */
    SAME_PHOTO("%s is left out: it shows the same as %s to the last digit"),
    /** A photo of whose light nothing is known: its name. */
    TONE_CURVE_OPEN("%s is left out: nothing tells how the camera made its grey values, so its edges may lie anywhere; "
            + "state the tone curve"),
    /** A photo whose corners no pose explains: its name. */
    NO_POSE("%s is left out: no pose of the camera explains what it shows"),
    /** A photo that the others do not explain: its name, chance in per cent, the marker that is off most. */
    PHOTO_DOES_NOT_FIT("%s does not fit the other photos (chance %s %%), marker %s least of all: something was moved, "
            + "or a marker is covered or bent there; leave the photo out or take it again"),
    /** Only one photo is used. */
    ONE_PHOTO("one photo is used: placement cannot be told from noise, and the result is no better than that of a "
            + "check; take at least three from different sides"),
    /** References stand off by more than stated: id, mm, chance in per cent. */
    REFERENCE_OFF("reference %s does not stand as stated: it is off by %s mm (chance %s %%); its place is taken from "
            + "the photos alone"),
    /** A measurement that does not fit: its number, its words, how many deviations, chance in per cent. */
    MEASUREMENT_OFF("measurement %s (%s) contradicts the others: it is off by %s standard deviations (chance %s %%)"),
    /** Objects that no photo shows: ids. */
    OBJECTS_NOT_SEEN("objects %s are in no photo"),
    /** References that no photo shows: ids. */
    REFERENCES_NOT_SEEN("references %s are in no photo"),
    /** An object that has two poses still: its id. */
    AMBIGUOUS("object %s has two poses that explain all photos: take one from another side"),
    /** Something that has moved between two surveys: what, by how many mm and degrees, chance in per cent. */
    MOVED("%s has moved since the earlier survey by %s mm and %s degrees (chance %s %% if it had not): measure it "
            + "again, or put it back"),
    /** Something that one photo has elsewhere than the earlier survey: what, the photo, mm and degrees. */
    MOVED_IN_PHOTO("%s stands elsewhere in %s: off by %s mm and %s degrees from the earlier survey"),
    /** Advice where a target is missed: how many photos. */
    MORE_PHOTOS("take %s more photos like these while nothing moves"),
    /** Sampled and predicted deviations differ: by how many per cent at most. */
    FAR_FROM_GAUSSIAN("deviations of draws differ from those of the approximation by up to %s %%: figures are those of "
            + "the draws, those of the curve and the shares are rough");

    private final String english;

    SurveyWarning(String english) {
        this.english = english;
    }

    @Override
    public String code() {
        return "survey-" + WarningKind.super.code();
    }

    @Override
    public String english() {
        return english;
    }
}
