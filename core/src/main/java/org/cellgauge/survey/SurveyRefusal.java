package org.cellgauge.survey;

import org.cellgauge.warning.RefusalKind;

/** Why photos give no survey. */
public enum SurveyRefusal implements RefusalKind {
    /** No photo is left: how many there were, why each was left out. */
    NO_PHOTO("none of %s photos can be used: %s"),
    /** An earlier survey of other markers. */
    NOTHING_IN_COMMON("the photos show no reference and no object that the earlier survey has: name the survey of this "
            + "cell"),
    /** What {@link #NO_SURVEY} is about, without places. */
    SURVEY_FILE("survey"),
    /** A file that holds no survey: what is wrong. */
    NO_SURVEY("%s; name what survey wrote, NAME.survey.json beside the surveyed cell file or its JSON");

    private final String english;

    SurveyRefusal(String english) {
        this.english = english;
    }

    @Override
    public String code() {
        return "survey-" + RefusalKind.super.code();
    }

    @Override
    public String english() {
        return english;
    }
}
