package org.cellgauge.android.files;

import org.cellgauge.warning.RefusalKind;

/** Why the app cannot use a document or a photo or keep a result, or a part of the sentence that says it. */
public enum FileRefusal implements RefusalKind {
    // ---- any document; what it should be is a part

    /** An address of something else: what it should be. */
    NO_DOCUMENT("this is no document of this device; choose the %s in the app"),
    /** It cannot be opened: what it should be. */
    GONE("this %s is not there any more, or its app does not give it; choose it again"),
    /** It may not be opened any more: what it should be. */
    PERMISSION_ENDED("the permission to read this %s has ended; choose it again"),
    /** Reading failed: what it should be, what the system says. */
    NOT_READABLE("the %s cannot be read (%s); check the connection or copy it to this device"),
    /** The app behind it failed: what it should be, with what. */
    APP_FAILS("the app that holds this %s does not give it (%s); copy it to this device and choose it there"),

    // ---- photos

    /** Nothing is in it. */
    EMPTY("the file is empty; copy it again from the camera"),
    /** A format that is known but not read. */
    OTHER_FORMAT("images of this format are not read by the app; save it as PNG or JPEG"),
    /** A format of phones. */
    HEIC("images in HEIC or AVIF, and films, are not read by the app; choose JPEG in the settings of the camera app "
            + "(where it is called HEIF or high efficiency, switch that off), or save this one as PNG or JPEG"),
    /** Anything else. */
    UNKNOWN_FORMAT("this is no image of a known format; save it as PNG or JPEG"),
    /** The end is missing. */
    CUT_SHORT("it is cut short; copy it again"),
    /** A checksum is wrong. */
    DAMAGED("it is damaged; copy it again"),
    /** A JPEG without its order. */
    DAMAGED_JPEG("it is damaged; copy it again or save it as PNG"),
    /** The decoder does not take it. */
    UNUSUAL("it is damaged or of an unusual kind; copy it again or save it as 8-bit PNG"),
    /** Colours for print. */
    CMYK("its colours are CMYK, made for print; save it as an RGB or grey image"),
    /** Larger than any photo: largest size, MiB. */
    TOO_LARGE("larger than %s MiB, which no photo is; check the name of the file"),
    /** The memory does not suffice to read it. */
    MEMORY("it is too large for the memory of this device; scale it down before calibration and measurement alike, or "
            + "check it with the command line"),
    /** Too many pixels: width, height, px, free memory, MB. */
    PIXELS("%s x %s px are too many for the memory of this device (%s MB free); scale it down before calibration and "
            + "measurement alike, or check it with the command line"),
    /** The memory does not suffice to check it. */
    MEMORY_FOR_CHECK("the memory of this device does not suffice to check a photo of this size; take a smaller one"),

    // ---- results

    /** No room: what the result takes, what there is, MB. */
    STORAGE_FULL("the result takes %s MB and %s MB are free; remove what is not needed any more, such as earlier "
            + "results"),
    /** The memory does not suffice to write it. */
    RESULT_MEMORY("the memory of this device does not suffice to write the result"),
    /** The picture is not encoded. */
    PICTURE_NOT_WRITTEN("the overlay's picture cannot be written"),
    /** There is no folder for results. */
    NO_FOLDER_FOR_RESULTS("the folder for results cannot be made"),
    /** There is no folder for this one. */
    NO_FOLDER_FOR_RESULT("the folder for the result cannot be made"),
    /** It does not get its name. */
    RESULT_NOT_NAMED("the result cannot be given its name"),

    /** A kept result whose result file cannot be read. */
    RESULT_NOT_READ("the result file is missing, damaged or of another version of the app; the other files can be "
            + "shared all the same"),

    // ---- parts

    /** What a document should be. */
    PHOTO("photo"),
    /** What the app brings along. */
    LICENCES("licences");

    private final String english;

    FileRefusal(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
