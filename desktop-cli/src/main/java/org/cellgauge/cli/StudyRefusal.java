package org.cellgauge.cli;

import org.cellgauge.warning.RefusalKind;

/** Why a value of a setting of {@link StudyTable} is refused: a sentence without its subject, which is the setting. */
enum StudyRefusal implements RefusalKind {
    /** Words that name no tone curve: the words, the least exponent, the largest. */
    NO_TONE_CURVE("'%s' is no tone curve; write srgb, linear or gamma G, G from %s to %s"),
    /** A text that is no unsharp mask: the text. */
    NO_UNSHARP_MASK("'%s' is not AMOUNT,RADIUS_PX, as in 0.6,1.2"),
    /** An unsharp mask that is too strong or too wide: the mask. */
    UNSHARP_MASK_TOO_STRONG("must have an amount between 0 and 10 and a radius above 0 and up to 20 px, not %s"),
    /** A text that says nothing of outliers: the text. */
    NO_OUTLIERS("'%s' is not SHARE,DEVIATIONS, as in 0.05,20"),
    /** A share or a size that no outliers have: both. */
    OUTLIERS_OUT_OF_RANGE("must be a share between 0 and 1 and a number of at least 0, not %s"),
    /** A text that is no spread: the text. */
    NO_SPREAD("'%s' is not MM,DEG, as in 50,10"),
    /** A spread with a number below 0: the spread. */
    NEGATIVE_SPREAD("must be two numbers of at least 0, not %s"),
    /** A text that states no corner noise: the text. */
    NO_CORNER_NOISE("write auto or a positive number of px, not '%s'");

    private final String english;

    StudyRefusal(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
