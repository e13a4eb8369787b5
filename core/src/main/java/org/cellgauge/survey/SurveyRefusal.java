package org.cellgauge.survey;

import org.cellgauge.warning.RefusalKind;

/** Why photos give no survey. */
public enum SurveyRefusal implements RefusalKind {
    /** No photo is left: how many there were, why each was left out. */
    NO_PHOTO("none of %s photos can be used: %s");

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
