package org.cellgauge.android.screen;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.android.R;
import org.cellgauge.android.camera.CameraNote;
import org.cellgauge.android.state.Advice;
import org.cellgauge.android.state.CheckScreenState;
import org.cellgauge.android.state.ImageSource;
import org.cellgauge.check.Reason;
import org.cellgauge.output.AdviceView;
import org.cellgauge.output.MisplacedView;
import org.cellgauge.output.ReferencesView;
import org.cellgauge.vision.DetectionWarning;
import org.cellgauge.vision.Detections;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Warning;

/** The one thing to do next, in words of action: what a technician reads after the verdict and before any figure. */
final class NextStep {
    /** Blur of markers (standard deviation) that a lens in focus and a steady hand stay far below, px. */
    private static final double BLURRED_PX = 2;
    /** The same where markers could not be read. */
    private static final double BLURRED_UNREAD_PX = 1.2;

    private final Wording words;

    NextStep(Wording words) {
        this.words = words;
    }

    /** What to do next in a state; null where there is nothing to do but wait, or the reason says it all. */
    String of(CheckScreenState s) {
        switch (Banner.of(s)) {
            case QUICK_LOOK:
                return s.allowsSampling() && s.source() == ImageSource.LIVE ? words.get(R.string.next_hold_still)
                        : null;
            case NOT_CONVERGED:
                return words.get(s.source() == ImageSource.LIVE ? R.string.next_not_converged
                        : R.string.next_not_converged_still);
            case AMBIGUOUS:
                return s.reason().kind() == Reason.Kind.TWO_OBJECT_POSES
                        ? words.get(R.string.next_two_object_poses, s.reason().objectId().getAsInt())
                        : words.get(R.string.next_two_camera_poses);
            case CONTRADICTED:
                return contradicted(s);
            case PASS:
            case PASS_UNMEASURED:
            case NO_TARGET:
                return passed(s);
            case FAIL:
                return failed(s);
            default:
                return null;
        }
    }

    /**
     * What to do about light and sharpness of the camera's newest frame, the worst first.
     *
     * @return null where nothing is amiss, or what is shown is no camera's picture
     */
    String picture(CheckScreenState s) {
        if (s.source() != ImageSource.LIVE || s.live() == null || s.awaitsFrame()) {
            return null;
        }
        Detections seen = s.live().detections();
        if (find(seen, DetectionWarning.NEARLY_BLACK, DetectionWarning.TOO_DARK) != null
                || notes(s, CameraNote.LIGHT_SHORT)) {
            return words.get(s.setup() != null && s.setup().hasTorch() && !s.torch() ? R.string.next_too_dark_torch
                    : R.string.next_too_dark);
        }
        if (find(seen, DetectionWarning.NEARLY_WHITE, DetectionWarning.WHITES_CLIPPED) != null) {
            return words.get(R.string.next_too_bright);
        }
        Warning glare = find(seen, DetectionWarning.GLARE);
        if (glare != null) {
            return words.get(R.string.next_glare, glare.arguments().get(0));
        }
        if (notes(s, CameraNote.FOCUS_NOT_FOUND)) {
            return words.get(R.string.next_focus);
        }
        return !isBlurred(seen) ? null : words.get(notes(s, CameraNote.FOCUS_AS_CALIBRATED)
                ? R.string.next_steadier_or_at_distance : R.string.next_steadier);
    }

    private static boolean notes(CheckScreenState s, CameraNote note) {
        return s.setup() != null && s.setup().notes().contains(note);
    }

    /** Whether a frame is blurred so much that something must be done. */
    static boolean isBlurred(Detections seen) {
        if (find(seen, DetectionWarning.BLURRED, DetectionWarning.TOO_BLURRED) != null) {
            return true;
        }
        // of small markers less is too much: what is left of their cells no longer matches
        boolean unread = find(seen, DetectionWarning.CELLS_DO_NOT_MATCH, DetectionWarning.EDGES_NOT_MEASURED) != null;
        return seen.light() != null && seen.light().blurPx() > (unread ? BLURRED_UNREAD_PX : BLURRED_PX);
    }

    private static Warning find(Detections seen, DetectionWarning... kinds) {
        for (Warning warning : seen.warnings()) {
            for (DetectionWarning kind : kinds) {
                if (warning.kind() == kind) {
                    return warning;
                }
            }
        }
        return null;
    }

    private String contradicted(CheckScreenState s) {
        Warning action = s.result().action();
        return action == null ? words.get(R.string.next_contradicted) : sentence(action, s);
    }

    private String passed(CheckScreenState s) {
        Warning action = s.result().action();
        if (action != null) {
            return sentence(action, s);
        }
        if (Banner.of(s) == Banner.NO_TARGET) {
            return words.get(R.string.next_set_target);
        }
        return s.lensMeasured() ? null : words.get(R.string.next_calibrate);
    }

    private String failed(CheckScreenState s) {
        Reason reason = s.reason();
        Warning action = s.result().action();
        if (action != null) {
            return sentence(action, s);
        }
        if (!reason.missingObjects().isEmpty()) {
            return words.plural(R.plurals.next_show_objects, reason.missingObjects().size(),
                    words.ids(reason.missingObjects()));
        }
        if (reason.misfit() != null) {
            return words.get(R.string.next_misfit);
        }
        String picture = picture(s);
        if (picture != null) {
            return picture;
        }
        if (s.advice() != null) {
            return advice(s.advice());
        }
        return words.get(s.lensMeasured() ? R.string.next_closer : R.string.next_calibrate);
    }

    /** What a warning asks for; of a shifted reference by how much it is off in all, as one would measure it. */
    private String sentence(Warning action, CheckScreenState s) {
        ReferencesView references = s.view().references();
        if (action.kind() == CheckWarning.REFERENCE_OFF && references != null && !references.misplaced().isEmpty()) {
            MisplacedView off = references.misplaced().get(0);
            double[] shift = off.offset();
            return words.get(R.string.next_measure_reference, off.id(),
                    words.number(Math.hypot(Math.hypot(shift[0], shift[1]), shift[2]), 1));
        }
        String text = words.message(action);
        return text.substring(0, 1).toUpperCase(words.locale()) + text.substring(1) + ".";
    }

    private String advice(Advice advice) {
        List<String> changes = new ArrayList<>();
        advice.changes().forEach(change -> changes.add(words.message(change)));
        AdviceView view = advice.view();
        return words.get(R.string.next_advice, String.join("; ", changes),
                words.get(view.grip() ? R.string.of_grip : R.string.of_object, view.objectId()),
                words.mm(view.nowStdMm()), words.mm(view.thenStdMm()));
    }
}
