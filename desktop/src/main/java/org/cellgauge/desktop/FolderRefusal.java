package org.cellgauge.desktop;

import org.cellgauge.warning.RefusalKind;

/** Why a folder of photos, or one for results, cannot be used. */
public enum FolderRefusal implements RefusalKind {
    /** It does not open. */
    FOLDER_NOT_READ("the folder cannot be read; check its permissions"),
    /** It holds no photos. */
    NO_IMAGE_IN_FOLDER("no image in this folder; photos end in .png, .jpg, .bmp, .tif, .gif, .webp, .pgm or .ppm "
            + "(folders within it are not searched)"),
    /** A link with the name of a photo. */
    LINK_TO_NOWHERE("it is a link that leads nowhere; mend or delete it"),

    // ---- places for results

    /** A file in place of a folder. */
    OUT_IS_FILE("this is a file, not a folder; name a folder for the results"),
    /** It may not be written to. */
    OUT_NOT_PERMITTED("no permission to write here; name another folder for the results"),
    /** It cannot be made. */
    OUT_NOT_MADE("this folder cannot be made or is gone; name another one for the results"),
    /** Another run has it: which. */
    OUT_IN_USE("another run writes its results here (%s); wait for its end, or name another folder for these"),
    /** The files of one input have no place: what the system says. */
    RESULT_NOT_WRITTEN("its result cannot be written (%s); give the input another name, or the results another folder"),
    /** Writing failed: what the system says. */
    OUT_NOT_WRITTEN("results cannot be written (%s); free space or name another folder for them");

    private final String english;

    FolderRefusal(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
