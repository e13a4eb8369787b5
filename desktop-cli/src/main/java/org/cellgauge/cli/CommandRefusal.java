package org.cellgauge.cli;

import org.cellgauge.warning.RefusalKind;

/** What the commands themselves refuse. */
enum CommandRefusal implements RefusalKind {
    /** A cell that does not say how noisy corners are. */
    NO_CORNER_NOISE("pixel_std_px is 'auto', which says nothing of the noise to simulate; give it with --pixel-std, "
            + "for instance 0.3"),
    /** A size of markers in the image that no distance makes: px. */
    NO_DISTANCE("no distance of the camera makes markers %s px wide; give another --marker-px or --camera-pose"),
    /** A camera file that cannot be written: what the system says. */
    CAMERA_NOT_WRITTEN("the camera file cannot be written (%s); name another with --out"),
    /** A surveyed cell file that cannot be written: what the system says. */
    SURVEY_NOT_WRITTEN("the surveyed cell file cannot be written (%s); name another with --out"),
    /** Standard output takes no more. */
    OUTPUT_LOST("not all of it could be written; the disk is full, or the program that reads it has ended");

    private final String english;

    CommandRefusal(String english) {
        this.english = english;
    }

    @Override
    public String english() {
        return english;
    }
}
