package org.cellgauge.internal.vision;

import org.cellgauge.vision.DetectionsRefusal;
import org.cellgauge.warning.RefusalKind;

/** Parts of the sentences of {@link DetectionsRefusal}. */
public enum DetectionsPhrase implements RefusalKind {
    /** What the file should be. */
    DETECTIONS_FILE("detections file"),

    // ---- what was expected, and what stands there

    /** An object of JSON. */
    OBJECT("an object"),
    /** A list. */
    LIST("a list"),
    /** A text. */
    TEXT("a text"),
    /** A text. */
    TEXT_IN_QUOTES("a text in quotes"),
    /** A number. */
    NUMBER("a number"),
    /** A finite number. */
    FINITE_NUMBER("a finite number"),
    /** A number that is not negative. */
    NUMBER_FROM_0("a number from 0 on"),
    /** A positive number. */
    POSITIVE_NUMBER("a number above 0"),
    /** A whole number. */
    WHOLE_NUMBER("a whole number"),
    /** A whole number: smallest, largest. */
    WHOLE_NUMBER_WITHIN("a whole number from %s to %s"),
    /** A truth value. */
    TRUE_OR_FALSE("true or false"),
    /** A null. */
    NULL("null"),
    /** Nothing. */
    NOTHING("nothing"),
    /** All corners. */
    FOUR_CORNERS("4 corners"),
    /** One of them. */
    CORNER("a corner"),
    /** Coordinates of a corner. */
    TWO_NUMBERS("2 numbers"),
    /** A covariance. */
    EIGHT_ROWS_OF_NUMBERS("8 rows of 8 numbers"),
    /** Its rows. */
    EIGHT_ROWS("8 rows"),
    /** One of them. */
    EIGHT_NUMBERS("8 numbers"),
    /** The power of a tone curve. */
    GAMMA("gamma"),
    /** The power of a tone curve with a toe. */
    POWER("power"),

    // ---- what to write

    /** JSON: the text. */
    WRITE("write %s"),
    /** The file. */
    BEGIN("begin with {\"image\": ..., \"markers\": [...]}"),
    /** The width. */
    WIDTH("write the image's width in px"),
    /** The height. */
    HEIGHT("write the image's height in px"),
    /** The name. */
    FILE_NAME("write the image's file name, or leave the key out"),
    /** An id. */
    ID("write the marker's id"),
    /** Corners. */
    CORNERS("write the corners as [[x, y], [x, y], [x, y], [x, y]]: top-left, top-right, bottom-right, bottom-left"),
    /** A corner. */
    WRITE_CORNER("write a corner as [x, y] in px"),
    /** A number in quotes. */
    UNQUOTED_NUMBER("write a number in px, without quotes"),
    /** A number. */
    WRITE_PX("write a number in px"),
    /** A number that may be left out. */
    WRITE_NUMBER("write a number, or leave the key out"),
    /** A truth value. */
    WRITE_TRUE_OR_FALSE("write true or false, or leave the key out"),
    /** A covariance. */
    COVARIANCE("write the covariance of the corners' errors in square px as 8 rows of 8 numbers, in the order u, v of "
            + "each corner, or leave the key out"),
    /** An edge shift. */
    SHIFT("write {\"px\": 0.1, \"variance_px2\": 0.01, \"covariance_with_corners_px2\": [8 numbers]}, or leave the key "
            + "out"),
    /** A variance. */
    SHIFT_VARIANCE("write the variance of the shift's error in square px, or leave edge_shift out"),
    /** Covariances. */
    SHIFT_WITH_CORNERS("\"covariance_with_corners_px2\": [0, 0, 0, 0, 0, 0, 0, 0] where corners and shift share no "
            + "errors"),
    /** The light. */
    LIGHT("write {\"tone_curve\": \"srgb\", \"edge_shift_std_px\": 0.1, \"blur_px\": 0.7, \"noise_grey\": 2}, or leave "
            + "the key out"),
    /** A tone curve. */
    TONE_CURVE("write \"srgb\", \"linear\" or \"gamma G\", for instance \"gamma 2.2\""),
    /** A deviation of edges. */
    EDGE_SHIFT_STD("write a deviation in px, 0 where edges cannot be shifted"),
    /** A blur. */
    BLUR("write a deviation in px, or leave the key out"),
    /** A noise. */
    NOISE("write a deviation in grey levels of 255, or leave the key out");

    private final String english;

    DetectionsPhrase(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
