package org.cellgauge.android.state;

import java.util.List;
import org.cellgauge.android.files.Photo;
import org.cellgauge.check.CheckResult;
import org.cellgauge.output.ResultView;

/**
 * The last verdict, which stays on the screen while the view has left it and there is no newer one; immutable.
 *
 * @param result what was found
 * @param view all that it says
 * @param objects what was said of each object of the cell
 * @param photo the frame that it belongs to
 * @param atMs when it was true of the view last, ms of any clock
 * @param ageMs how long ago that is
 */
public record HeldVerdict(CheckResult result, ResultView view, List<ObjectRow> objects, Photo photo, long atMs,
        long ageMs) {
    /** After so long nobody remembers what the camera was pointed at. */
    static final long LONGEST_MS = 60_000;

    /** The same at a later time; null where it is too old to be shown. */
    HeldVerdict at(long nowMs) {
        return nowMs - atMs > LONGEST_MS ? null
                : new HeldVerdict(result, view, objects, photo, atMs, Math.max(0, nowMs - atMs));
    }
}
