package org.cellgauge.settings;

import org.cellgauge.warning.RefusalKind;

/** Why a value of a setting is refused: a sentence without its subject, which is the setting. */
public enum SettingRefusal implements RefusalKind {
    /** A word that is none of the choices: the word, the choices. */
    NOT_KNOWN("'%s' is not known; write %s"),
    /** A text that is no whole number: the text. */
    NOT_WHOLE("'%s' is no whole number, or too large"),
    /** A text that is no number: the text. */
    NOT_A_NUMBER("'%s' is no number"),
    /** Several values in place of one. */
    NOT_ONE_VALUE("must be a single value"),
    /** A number that is not above 0: the number. */
    NOT_POSITIVE("must be positive, not %s"),
    /** A number that is not above 0: its unit, the number. */
    NOT_POSITIVE_IN("must be a positive number of %s, not %s"),
    /** A number beyond its ends: the least, the largest, the number. */
    NOT_BETWEEN("must be between %s and %s, not %s"),
    /** A number that is too small: the least, the number. */
    TOO_SMALL("must be at least %s, not %s"),
    /** A share that is not between 0 and 1: the share. */
    NOT_BELOW_ALL("must be a share between 0 and 1, such as 0.02 for 2 %%, not %s"),
    /** A share that is not above 0: the share. */
    NOT_ABOVE_NOTHING("must be a share above 0, such as 0.005 for half a per cent, not %s"),
    /** A warm-up that leaves too little: the fewest iterations to keep, those there are, the warm-up. */
    TOO_FEW_LEFT("must be at least 0 and leave at least %s of the %s iterations, not %s");

    private final String english;

    SettingRefusal(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
