package org.cellgauge.android.screen;

import org.cellgauge.android.R;
import org.cellgauge.android.state.CheckScreenState;
import org.cellgauge.android.state.ImageSource;
import org.cellgauge.android.state.Problem;
import org.cellgauge.check.Verdict;
import org.cellgauge.live.LiveState;
import org.cellgauge.output.ResultView;

/** The verdict in a word, a sign and a colour, or what stands in its place. */
enum Banner {
    NO_CELL(R.string.head_no_cell, R.drawable.ic_cell, R.color.banner_idle),
    READING_CELL(R.string.head_reading_cell, R.drawable.mark_preliminary, R.color.banner_idle),
    READING_PHOTO(R.string.head_reading_photo, R.drawable.mark_preliminary, R.color.banner_idle),
    PHOTO_REFUSED(R.string.head_photo_refused, R.drawable.mark_not_judged, R.color.banner_idle),
    CAMERA_OFF(R.string.head_camera_off, R.drawable.ic_camera_off, R.color.banner_idle),
    CAMERA_STARTING(R.string.head_camera_starting, R.drawable.mark_preliminary, R.color.banner_idle),
    FOCUSING(R.string.head_focusing, R.drawable.mark_preliminary, R.color.banner_idle),
    SEARCHING(R.string.head_searching, R.drawable.mark_not_seen, R.color.banner_idle),
    REFUSED(R.string.head_refused, R.drawable.mark_not_judged, R.color.banner_idle),
    INTERNAL(R.string.head_internal, R.drawable.mark_not_converged, R.color.banner_idle),
    MEMORY(R.string.head_memory, R.drawable.mark_not_converged, R.color.banner_idle),
    QUICK_LOOK(R.string.head_quick_look, R.drawable.mark_preliminary, R.color.banner_neutral),
    SAMPLING(R.string.head_sampling, R.drawable.mark_preliminary, R.color.banner_neutral),
    PASS(R.string.head_pass, R.drawable.mark_pass, R.color.banner_pass),
    /** Met with all that an unmeasured lens may do in the figures: no green, because nobody measured it. */
    PASS_UNMEASURED(R.string.head_pass_unmeasured, R.drawable.mark_pass, R.color.banner_neutral),
    FAIL(R.string.head_fail, R.drawable.mark_fail, R.color.banner_fail),
    NOT_CONVERGED(R.string.head_not_converged, R.drawable.mark_not_converged, R.color.banner_not_converged),
    AMBIGUOUS(R.string.head_ambiguous, R.drawable.mark_ambiguous, R.color.banner_ambiguous),
    CONTRADICTED(R.string.head_contradicted, R.drawable.mark_not_converged, R.color.banner_not_converged),
    NO_TARGET(R.string.head_no_target, R.drawable.mark_not_judged, R.color.banner_neutral);

    private final int headline;
    private final int mark;
    private final int colour;

    Banner(int headline, int mark, int colour) {
        this.headline = headline;
        this.mark = mark;
        this.colour = colour;
    }

    /** The headline's string. */
    int headline() {
        return headline;
    }

    /** The sign's drawable. */
    int mark() {
        return mark;
    }

    /** The background's colour. */
    int colour() {
        return colour;
    }

    /** The banner of a state. */
    static Banner of(CheckScreenState s) {
        if (s.readingCell()) {
            return READING_CELL;
        }
        if (s.cell() == null) {
            return NO_CELL;
        }
        if (s.readingPhoto()) {
            return READING_PHOTO;
        }
        Problem photo = s.photoProblem();
        if (photo != null) {
            return PHOTO_REFUSED;
        }
        if (s.checkProblem() != null) {
            return s.checkProblem().kind() == Problem.Kind.MEMORY ? MEMORY : INTERNAL;
        }
        if (s.source() == ImageSource.LIVE && !cameraMayRun(s)) {
            return CAMERA_OFF;
        }
        if (s.awaitsFrame()) {
            return FOCUSING;
        }
        return s.phase() == null ? CAMERA_STARTING : of(s, s.phase());
    }

    /** Whether nothing keeps the camera from running. */
    static boolean cameraMayRun(CheckScreenState s) {
        switch (s.permission()) {
            case ASK:
            case REFUSED:
                return false;
            default:
                return s.fault() == null && s.allowsCamera();
        }
    }

    private static Banner of(CheckScreenState s, LiveState.Phase phase) {
        if (s.held() != null) {
            return of(s.held().result().verdict(), s);
        }
        switch (phase) {
            case SEARCHING:
                return SEARCHING;
            case QUICK_LOOK:
                return QUICK_LOOK;
            case SAMPLING:
                return SAMPLING;
            case REFUSED:
                return REFUSED;
            default:
                break;
        }
        return of(s.verdict(), s);
    }

    private static Banner of(Verdict verdict, CheckScreenState s) {
        return of(verdict, s.lensMeasured());
    }

    /** The banner of a finished check through a lens that was measured, or was not. */
    static Banner of(Verdict verdict, boolean lensMeasured) {
        Banner judged = of(verdict);
        return judged == PASS && !lensMeasured ? PASS_UNMEASURED : judged;
    }

    /** The banner of a stored result. */
    static Banner of(ResultView view) {
        Banner judged = of(view.verdict());
        return judged == PASS && !isLensMeasured(view) ? PASS_UNMEASURED : judged;
    }

    /** Whether the lens of a stored result was calibrated, and not estimated along. */
    static boolean isLensMeasured(ResultView view) {
        return view.intrinsics().stream().allMatch(ResultView.Intrinsic::calibrated);
    }

    /** The banner of a finished check. */
    static Banner of(Verdict verdict) {
        switch (verdict) {
            case PASS:
                return PASS;
            case FAIL:
                return FAIL;
            case NOT_CONVERGED:
                return NOT_CONVERGED;
            case AMBIGUOUS:
                return AMBIGUOUS;
            case CONTRADICTED:
                return CONTRADICTED;
            default:
                return NO_TARGET;
        }
    }
}
