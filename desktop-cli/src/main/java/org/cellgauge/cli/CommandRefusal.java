package org.cellgauge.cli;

import org.cellgauge.warning.RefusalKind;

/** What the commands themselves refuse. */
enum CommandRefusal implements RefusalKind {
    /** A file that was read cannot be read again: what the system says. */
    NOT_READABLE("it cannot be read (%s); check the disk"),
    /** Too little memory: MB that there are. */
    MEMORY("this takes more memory than Java may use (%s MB); use smaller images, fewer chains or fewer iterations"),
    /** A cell that does not say how noisy corners are. */
    NO_CORNER_NOISE("pixel_std_px is 'auto', which says nothing of the noise to simulate; give it with --pixel-std, "
            + "for instance 0.3"),
    /** A size of markers in the image that no distance makes: px. */
    NO_DISTANCE("no distance of the camera makes markers %s px wide; give another --marker-px or --camera-pose"),

    // ---- places for results

    /** A file in place of a folder. */
    OUT_IS_FILE("this is a file, not a folder; name a folder with --out"),
    /** It may not be written to. */
    OUT_NOT_PERMITTED("no permission to write here; name another folder with --out"),
    /** It cannot be made. */
    OUT_NOT_MADE("this folder cannot be made or is gone; name another with --out"),
    /** Writing failed: what the system says. */
    OUT_NOT_WRITTEN("results cannot be written (%s); free space or name another folder with --out");

    private final String english;

    CommandRefusal(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
