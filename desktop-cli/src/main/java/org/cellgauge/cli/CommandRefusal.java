package org.cellgauge.cli;

import org.cellgauge.warning.RefusalKind;

/** What the commands themselves refuse. */
enum CommandRefusal implements RefusalKind {
    /** A photo of another size than a detections file states. */
    OTHER_PHOTO("it is of another size than the detections file states"),
    /** A cell that does not say how noisy corners are. */
    NO_CORNER_NOISE("pixel_std_px is 'auto', which says nothing of the noise to simulate; give it with --pixel-std, "
            + "for instance 0.3"),
    /** A size of markers in the image that no distance makes: px. */
    NO_DISTANCE("no distance of the camera makes markers %s px wide; give another --marker-px or --camera-pose"),

    // ---- places for results

    /** Standard output takes no more. */
    OUTPUT_LOST("not all of it could be written; the disk is full, or the program that reads it has ended"),

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
