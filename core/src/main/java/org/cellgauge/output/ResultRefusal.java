package org.cellgauge.output;

import org.cellgauge.warning.RefusalKind;

/** Why a result file cannot be read, or a part of the sentence that says it. */
public enum ResultRefusal implements RefusalKind {
    /** A result file. */
    RESULT_FILE("result file"),
    /** A syntax error. */
    NOT_JSON("this is no JSON; name a result file as cellgauge wrote it"),
    /** Something after the end. */
    MORE_TEXT("more text follows after the end; name a result file as cellgauge wrote it"),
    /** Another version of the format: its number, the one that is known. */
    OTHER_SCHEMA("version %s of the format is not known, only %s; read it with the cellgauge that wrote it"),
    /** A key that must stand here: the key. */
    MISSING("the key \"%s\" is missing; name a result file as cellgauge wrote it"),
    /** Something else stands here: what was expected. */
    EXPECTED("%s should stand here; name a result file as cellgauge wrote it"),
    /** Too many or too few in a list: how many are expected, how many there are. */
    OTHER_COUNT("%s elements should stand here, not %s; name a result file as cellgauge wrote it"),
    /** A word that means nothing here: the word. */
    UNKNOWN_WORD("\"%s\" means nothing here; name a result file as cellgauge wrote it"),
    /** Values that are no such thing: why not. */
    NOT_POSSIBLE("this cannot be (%s); name a result file as cellgauge wrote it"),

    // ---- what is expected

    /** Keys and values. */
    OBJECT("an object in braces"),
    /** Values. */
    LIST("a list in brackets"),
    /** A number. */
    NUMBER("a number"),
    /** A number without a fraction. */
    WHOLE_NUMBER("a whole number"),
    /** Yes or no. */
    BOOLEAN("true or false"),
    /** Characters. */
    TEXT("a text in quotes");

    private final String english;

    ResultRefusal(String english) {
        this.english = english;
    }

    @Override
    public String code() {
        return "result-" + RefusalKind.super.code();
    }

    @Override
    public String english() {
        return english;
    }
}
