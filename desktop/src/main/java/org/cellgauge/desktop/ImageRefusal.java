package org.cellgauge.desktop;

import org.cellgauge.warning.RefusalKind;

/** Why an image file cannot be used. */
public enum ImageRefusal implements RefusalKind {
    /** A folder. */
    IS_FOLDER("is a folder, not an image; name a file in it"),
    /** It does not exist. */
    NO_SUCH_FILE("there is no such file; check the name"),
    /** Its name has bytes that are no characters of UTF-8, and Java cannot ask for it. */
    NAME_NOT_UTF_8("there is no such file, or its name is not UTF-8; rename it, or name the folder that it is in"),
    /** Nothing is in it. */
    EMPTY("the file is empty; copy it again from the camera"),
    /** It may not be read. */
    NOT_PERMITTED("reading it is not permitted; change its permissions"),
    /** Reading failed: what the system says. */
    NOT_READABLE("it cannot be read (%s); check the disk or copy it again"),
    /** No format that is known: formats to save it in. */
    UNKNOWN_FORMAT("this is no image of a known format; save it as %s"),
    /** A file of phones: none of the formats that Java decodes. */
    HEIF("this is a HEIC, HEIF or AVIF photo, which is not read; set the camera to JPEG (\"most compatible\"), or "
            + "convert it to PNG without scaling or turning it"),
    /** Too long a file: MB that are read. */
    FILE_TOO_LARGE("the file is larger than the %s MB that are read; save it as PNG"),
    /** Too many pixels: width, height, px, how many millions are decoded, the longest side, px. */
    TOO_LARGE("it announces %s x %s px, more than the %s million pixels or %s px a side that are decoded; scale it "
            + "down before calibration and measurement alike"),
    /** Values of too many bits: how many. */
    DEPTH("its values have %s bits each; save it with 8 or 16 bits"),
    /** The end is missing. */
    CUT_SHORT("it is cut short; copy it again or save it as 8-bit PNG"),
    /** It cannot be decoded: what the decoder says. */
    DAMAGED("it is damaged or of an unusual kind (%s); copy it again or save it as 8-bit PNG"),
    /** Parts of it cannot be decoded: what the decoder says. */
    PARTLY_DAMAGED("it is damaged or cut short (%s); copy it again from the camera"),
    /** Colours for print. */
    CMYK("its colours are CMYK, made for print; save it as an RGB or grey image"),
    /** Other colours. */
    OTHER_COLOURS("its colours are neither grey nor RGB; save it as an 8-bit RGB or grey image");

    private final String english;

    ImageRefusal(String english) {
        this.english = english;
    }

    @Override
    public String code() {
        return "image-" + RefusalKind.super.code();
    }

    @Override
    public String english() {
        return english;
    }
}
