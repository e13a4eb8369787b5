package org.cellgauge.desktop;

import org.cellgauge.warning.RefusalKind;

/** Why a folder of photos cannot be used. */
public enum FolderRefusal implements RefusalKind {
    /** It does not open. */
    FOLDER_NOT_READ("the folder cannot be read; check its permissions"),
    /** It holds no photos. */
    NO_IMAGE_IN_FOLDER("no image in this folder; photos end in .png, .jpg, .bmp, .tif, .gif, .webp, .pgm or .ppm "
            + "(folders within it are not searched)");

    private final String english;

    FolderRefusal(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
