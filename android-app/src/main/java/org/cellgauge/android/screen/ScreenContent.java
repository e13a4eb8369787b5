package org.cellgauge.android.screen;

import java.util.ArrayList;
import java.util.List;
import org.cellgauge.android.R;
import org.cellgauge.android.camera.CameraFault;
import org.cellgauge.android.camera.CameraNote;
import org.cellgauge.android.device.ThermalLevel;
import org.cellgauge.android.state.CameraPermission;
import org.cellgauge.android.state.CheckScreenState;
import org.cellgauge.android.state.ImageSource;
import org.cellgauge.android.state.ObjectRow;
import org.cellgauge.android.state.Problem;
import org.cellgauge.cell.Requirement;
import org.cellgauge.check.Verdict;
import org.cellgauge.internal.overlay.EllipseShape;
import org.cellgauge.internal.overlay.Overlay;
import org.cellgauge.internal.overlay.Role;
import org.cellgauge.internal.overlay.Shape;
import org.cellgauge.output.ResultView;
import org.cellgauge.warning.Warning;

/** What a state says, in the user's language: pure text, so that the activity only has to put it in its places. */
final class ScreenContent {
    private static final String BULLET = "\u2022 ";
    private static final double MS_PER_S = 1000;

    private final Wording words;
    private final String version;

    /**
     * Content in one language.
     *
     * @param words the language
     * @param version the app's
     */
    ScreenContent(Wording words, String version) {
        this.words = words;
        this.version = version;
    }

    // ---- banner

    String headline(CheckScreenState s) {
        String verdict = words.get(Banner.of(s).headline());
        return s.held() == null ? verdict
                : words.get(R.string.head_held, verdict, words.number(Math.ceil(s.held().ageMs() / MS_PER_S), 0));
    }

    /** Why the banner says what it says; empty where the headline or the message over the picture says all. */
    String reason(CheckScreenState s) {
        switch (Banner.of(s)) {
            case NO_CELL:
                return words.get(R.string.reason_no_cell);
            case SEARCHING:
                return words.plural(R.plurals.reason_searching, s.missingReferences().size(),
                        words.ids(s.missingReferences()));
            case QUICK_LOOK:
                if (!s.allowsSampling()) {
                    return words.get(R.string.reason_too_hot);
                }
                return words.get(s.source() == ImageSource.LIVE ? R.string.reason_quick_look
                        : R.string.reason_quick_look_still);
            case SAMPLING:
                return words.plural(R.plurals.reason_sampling, s.iterationsPerChain(),
                        words.number(s.iterationsPerChain(), 0));
            case REFUSED:
                return words.refusal(s.live().refusal());
            case INTERNAL:
                return words.get(R.string.reason_internal, words.problem(s.checkProblem()));
            case MEMORY:
                return words.problem(s.checkProblem());
            case PASS:
            case PASS_UNMEASURED:
            case FAIL:
            case NOT_CONVERGED:
            case AMBIGUOUS:
            case CONTRADICTED:
            case NO_TARGET:
                return (s.lensMeasured() ? "" : words.get(R.string.lens_unmeasured) + " ")
                        + words.reason(s.shownResult().finding());
            default:
                return "";
        }
    }

    /** The one thing to do next, or why there is nothing to do but wait; null where the headline says all. */
    String next(CheckScreenState s) {
        if (s.held() != null) {
            return words.get(R.string.next_held);
        }
        String picture = new NextStep(words).picture(s);
        switch (Banner.of(s)) {
            case SEARCHING:
                return picture == null ? reason(s) : picture;
            case REFUSED:
            case INTERNAL:
            case MEMORY:
                return reason(s);
            case QUICK_LOOK:
                return !s.allowsSampling() ? reason(s) : picture == null ? new NextStep(words).of(s) : picture;
            case SAMPLING:
                return picture;
            case PASS_UNMEASURED:
                return new NextStep(words).of(s);
            default:
                String next = new NextStep(words).of(s);
                boolean judged = s.result() != null && !s.lensMeasured();
                return !judged ? next : next == null ? words.get(R.string.lens_short)
                        : next + " " + words.get(R.string.lens_short);
        }
    }

    // ---- below the picture

    /** What the picture's legend would say, after what became of saving; null where there is neither. */
    String caption(CheckScreenState s) {
        String kept = s.saving() ? words.get(R.string.saving)
                : s.showsSaved() ? words.get(R.string.saved, s.saved().name()) : null;
        String legend = legend(s);
        return kept == null ? legend : legend == null ? kept : words.get(R.string.caption_parts, kept, legend);
    }

    private String legend(CheckScreenState s) {
        Overlay overlay = s.overlay();
        if (overlay == null) {
            return null;
        }
        String text = null;
        for (Shape shape : overlay.shapes()) {
            if (shape instanceof EllipseShape) {
                text = overlay.magnification() == 1 ? words.get(R.string.caption_true_size)
                        : words.get(R.string.caption_magnified, words.plain(overlay.magnification()));
                if (s.result() == null) {
                    text = words.get(R.string.caption_parts, text, words.get(R.string.caption_preliminary));
                } else if (s.verdict() == Verdict.NOT_CONVERGED) {
                    text = words.get(R.string.caption_parts, text, words.get(R.string.caption_not_converged));
                }
                break;
            }
        }
        if (!overlay.shapes(Role.WORLD_GRID).isEmpty()) {
            String grid = words.get(R.string.caption_grid, words.plain(overlay.gridSpacingMm()));
            text = text == null ? grid : words.get(R.string.caption_parts, text, grid);
        }
        return text;
    }

    /** What a screen reader says of the picture. Without counts that run, so that it speaks of what matters alone. */
    String spoken(CheckScreenState s) {
        StringBuilder objects = new StringBuilder();
        for (ObjectRow row : s.objects()) {
            objects.append(objects.length() == 0 ? "" : " ")
                    .append(words.get(R.string.spoken_object, row.id(), objects(s).mark(row)));
        }
        return words.get(R.string.spoken_overlay, headline(s), objects).trim();
    }

    // ---- what is in the way

    /** What stands over the picture, or null. */
    Message message(CheckScreenState s) {
        Problem cell = s.cellProblem();
        if (cell != null && cell.kind() == Problem.Kind.LAST_CALIBRATION) {
            return new Message(words.get(R.string.last_calibration), words.get(R.string.last_calibration_text,
                    words.problem(cell)), Action.CHOOSE_CALIBRATION, Action.GO_ON_WITHOUT);
        }
        if (cell != null && cell.kind() == Problem.Kind.LAST_CELL) {
            return new Message(words.get(R.string.last_cell), words.problem(cell), Action.CHOOSE_CELL,
                    Action.TRY_EXAMPLE);
        }
        if (cell != null) {
            return s.cell() == null
                    ? new Message(words.get(R.string.cell_refused), words.problem(cell), Action.CHOOSE_ANOTHER_CELL,
                            Action.TRY_EXAMPLE)
                    : new Message(words.get(R.string.cell_refused), words.problem(cell), Action.CHOOSE_ANOTHER_CELL,
                            Action.KEEP_CELL);
        }
        if (s.cell() == null) {
            return s.readingCell() ? null
                    : new Message(words.get(R.string.welcome),
                            words.get(s.photoWaits() ? R.string.photo_waits : R.string.welcome_text),
                            Action.CHOOSE_CELL, Action.TRY_EXAMPLE);
        }
        if (s.photoProblem() != null) {
            return photo(s, s.photoProblem());
        }
        return s.source() == ImageSource.LIVE ? camera(s) : null;
    }

    private Message photo(CheckScreenState s, Problem problem) {
        switch (problem.kind()) {
            case PHOTO_WITHOUT_CAMERA:
                String text = words.get(R.string.photo_without_camera_text);
                return canCalibrate(s)
                        ? new Message(words.get(R.string.photo_without_camera), text, Action.BACK_TO_CAMERA,
                                Action.CHOOSE_CALIBRATION)
                        : new Message(words.get(R.string.photo_without_camera), text, Action.BACK_TO_CAMERA);
            case PHOTO_SIZE:
                return new Message(words.get(R.string.photo_size), words.problem(problem), Action.OPEN_ANOTHER_PHOTO,
                        Action.BACK_TO_CAMERA);
            default:
                return new Message(words.get(R.string.photo_refused), words.problem(problem), Action.OPEN_ANOTHER_PHOTO,
                        Action.BACK_TO_CAMERA);
        }
    }

    private Message camera(CheckScreenState s) {
        if (!s.allowsCamera()) {
            return new Message(words.get(R.string.too_hot), words.get(R.string.too_hot_text), Action.OPEN_PHOTO);
        }
        if (s.permission() == CameraPermission.ASK) {
            return new Message(words.get(R.string.permission), words.get(R.string.permission_text), Action.ALLOW_CAMERA,
                    Action.OPEN_PHOTO);
        }
        if (s.permission() == CameraPermission.REFUSED) {
            return new Message(words.get(R.string.permission), words.get(R.string.permission_refused_text),
                    Action.OPEN_SETTINGS, Action.ALLOW_CAMERA, Action.OPEN_PHOTO);
        }
        CameraFault fault = s.fault();
        if (fault == null) {
            return null;
        }
        String title = words.fault(fault);
        String text = words.remedy(fault);
        switch (fault) {
            case NO_CAMERA:
                return new Message(title, text, Action.OPEN_PHOTO);
            case NOT_PERMITTED:
                return new Message(title, text, Action.OPEN_SETTINGS, Action.TRY_AGAIN, Action.OPEN_PHOTO);
            case NO_SUITABLE_SIZE:
            case NO_CAMERA_MODEL:
                return canCalibrate(s) ? new Message(title, text, Action.CHOOSE_CALIBRATION, Action.OPEN_PHOTO)
                        : new Message(title, text, Action.OPEN_PHOTO);
            default:
                return new Message(title, text, Action.TRY_AGAIN, Action.OPEN_PHOTO);
        }
    }

    private static boolean canCalibrate(CheckScreenState s) {
        return s.cell() != null && s.cell().uri() != null;
    }

    // ---- rows

    /** The list: what was kept, the objects, and what else the user should know. */
    List<Row> rows(CheckScreenState s) {
        List<Row> rows = new ArrayList<>();
        if (s.cell() == null) {
            about(rows);
            return rows;
        }
        kept(s, rows);
        cameraFile(s, rows);
        for (ObjectRow object : s.objects()) {
            rows.add(objects(s).row(object));
        }
        if (!s.missingReferences().isEmpty() && s.live().update() != null) {
            rows.add(note(R.drawable.mark_not_seen, words.plural(R.plurals.missing_references,
                    s.missingReferences().size(), words.ids(s.missingReferences())), null, null));
        }
        heat(s, rows);
        source(s, rows);
        rows.add(cameraModel(s));
        rows.add(note(R.drawable.ic_cell, words.get(R.string.cell_in_use, cellName(s)), target(s), null));
        warnings(s, rows);
        about(rows);
        return rows;
    }

    private void about(List<Row> rows) {
        rows.add(note(R.drawable.ic_guide, words.get(R.string.guide_title), words.get(R.string.guide_row_text),
                Action.GUIDE));
        rows.add(note(R.drawable.ic_about, words.get(R.string.about, version), null, Action.LICENCES));
    }

    private void kept(CheckScreenState s, List<Row> rows) {
        if (s.saving()) {
            rows.add(note(R.drawable.mark_preliminary, words.get(R.string.saving), null, null));
        } else if (s.saveProblem() != null) {
            boolean full = s.saveProblem().kind() == Problem.Kind.STORAGE_FULL;
            String message = words.problem(s.saveProblem());
            rows.add(new Row(R.drawable.mark_not_converged, R.color.mark_fail,
                    words.get(full ? R.string.storage_full : R.string.not_saved), null,
                    full ? words.get(R.string.storage_full_text, message).trim() : message,
                    s.canSave() ? Action.SAVE_AGAIN : null));
        } else if (s.saved() != null) {
            rows.add(s.showsSaved()
                    ? new Row(R.drawable.mark_pass, R.color.mark_pass, words.get(R.string.saved, s.saved().name()),
                            null, null, null)
                    : note(R.drawable.ic_save, words.get(R.string.saved_earlier, s.saved().name()),
                            words.get(R.string.saved_earlier_text), null));
        }
    }

    /** Rows of objects as this state has them. */
    private ObjectRows objects(CheckScreenState s) {
        return new ObjectRows(words, s.target(), s.shownResult() == null ? null : s.shownResult().verdict(),
                s.lensMeasured(), s.fused());
    }

    /** The heading of what is said of one object. */
    String objectTitle(CheckScreenState s, int objectId) {
        for (ObjectRow object : s.objects()) {
            if (object.id() == objectId) {
                return words.get(R.string.object_title, objectId, objects(s).mark(object));
            }
        }
        return words.get(R.string.object_title, objectId, words.get(R.string.mark_not_seen));
    }

    /** All that is known of one object: its row, its ellipse, and what causes how much of its variance. */
    String objectDetails(CheckScreenState s, int objectId) {
        StringBuilder text = new StringBuilder();
        for (ObjectRow object : s.objects()) {
            if (object.id() != objectId) {
                continue;
            }
            Row row = objects(s).row(object);
            line(text, row.figures());
            line(text, row.barText());
            if (object.ellipse95Px() != null) {
                line(text, words.get(R.string.ellipse, words.number(object.ellipse95Px().semiMajor(), 1),
                        words.number(object.ellipse95Px().semiMinor(), 1)));
            }
            ResultView view = s.shownView();
            if (object.stdMm() == null || view == null) {
                line(text, row.text());
                continue;
            }
            line(text, words.budget(R.string.budget, view.object(objectId)));
            if (view.grip(objectId) != null) {
                line(text, words.budget(R.string.budget_grip, view.grip(objectId)));
            }
            line(text, (words.tolerance(object.reason(), "\n") + words.misfit(object.reason(), "\n")
                    + words.misplacement(object.reason(), "\n")).trim());
        }
        return text.toString();
    }

    private static void line(StringBuilder text, String more) {
        if (more != null && !more.isEmpty()) {
            text.append(text.length() == 0 ? "" : "\n").append(more);
        }
    }

    private void heat(CheckScreenState s, List<Row> rows) {
        if (s.heat() == ThermalLevel.WARM) {
            rows.add(note(R.drawable.mark_not_converged, words.get(R.string.heat_warm),
                    words.get(R.string.heat_warm_text), null));
        } else if (s.heat() == ThermalLevel.HOT) {
            rows.add(note(R.drawable.mark_not_converged, words.get(R.string.heat_hot),
                    words.get(R.string.heat_hot_text), null));
        } else if (s.heat() == ThermalLevel.CRITICAL && s.source() != ImageSource.LIVE) {
            rows.add(note(R.drawable.mark_not_converged, words.get(R.string.too_hot), words.get(R.string.too_hot_text),
                    null));
        }
    }

    /** Android gives an app the documents that a user chose, not their neighbours. */
    private void cameraFile(CheckScreenState s, List<Row> rows) {
        String name = s.cell().cameraFile();
        if (name != null && s.cell().calibration() == null) {
            rows.add(new Row(R.drawable.mark_not_converged, R.color.mark_ambiguous,
                    words.get(R.string.camera_file, name), null, words.get(R.string.camera_file_text),
                    Action.CHOOSE_CALIBRATION));
        }
    }

    private void source(CheckScreenState s, List<Row> rows) {
        if (s.source() == ImageSource.FROZEN) {
            if (s.fault() != null) {
                rows.add(note(R.drawable.ic_camera_off, words.get(R.string.lost_camera, words.fault(s.fault())),
                        words.remedy(s.fault()), Action.TRY_AGAIN));
            } else {
                rows.add(note(R.drawable.ic_freeze, words.get(R.string.frozen), words.get(R.string.frozen_text), null));
            }
        } else if (s.source() == ImageSource.PHOTO && s.still() != null) {
            rows.add(note(R.drawable.ic_photo, words.get(R.string.photo_shown, s.still().name()), null,
                    Action.BACK_TO_CAMERA));
        }
    }

    private Row cameraModel(CheckScreenState s) {
        List<String> lines = new ArrayList<>();
        boolean photo = s.source() == ImageSource.PHOTO;
        if (photo && s.cell().calibration() != null) {
            lines.add(words.get(R.string.camera_model_calibration));
            lines.add(words.get(R.string.image_size, s.cell().calibration().widthPx(),
                    s.cell().calibration().heightPx()));
            photoScaled(s, lines);
        } else if (s.setup() != null) {
            if (photo) {
                lines.add(words.get(R.string.camera_model_photo_device));
            }
            lines.add(words.model(s.setup().source()));
            lines.add(words.get(R.string.image_size, s.setup().camera().widthPx(), s.setup().camera().heightPx()));
            for (CameraNote note : s.setup().notes()) {
                lines.add(words.note(note));
            }
            photoScaled(s, lines);
        } else if (s.liveCalibration() != null) {
            lines.add(words.get(R.string.camera_model_calibration));
        } else {
            lines.add(words.get(R.string.camera_model_none));
        }
        return note(R.drawable.ic_focus, words.get(R.string.camera_model), String.join("\n", lines),
                canCalibrate(s) && (s.cell().cameraFile() == null || s.cell().calibration() != null)
                        ? Action.CHOOSE_CALIBRATION : null);
    }

    private void photoScaled(CheckScreenState s, List<String> lines) {
        if (s.photoCameraScaled()) {
            lines.add(words.get(R.string.photo_scaled, s.still().luminance().widthPx(),
                    s.still().luminance().heightPx()));
        }
    }

    String cellName(CheckScreenState s) {
        return s.cell().uri() == null ? words.get(R.string.cell_example) : s.cell().name();
    }

    /** The target in a few words. */
    String targetSpoken(CheckScreenState s) {
        if (s.targetStdMm().isPresent()) {
            return words.get(R.string.target_mm, words.plain(s.targetStdMm().getAsDouble()));
        }
        Requirement asked = s.target().general();
        if (Wording.isTolerance(s.target())) {
            return words.get(R.string.target_tolerance_mm, words.plain(asked.toleranceMm().x()),
                    words.tenthOfPercent(asked.probability()));
        }
        return words.get(s.target().isAny() ? R.string.target_stated : R.string.target_not_set);
    }

    private String target(CheckScreenState s) {
        boolean chosen = s.targetStdMm().isPresent() && !s.target().equals(s.cell().cell().target());
        return chosen ? words.get(R.string.target_in_use_chosen, words.plain(s.targetStdMm().getAsDouble()))
                : words.target(s.target());
    }

    private void warnings(CheckScreenState s, List<Row> rows) {
        List<Warning> warnings = s.shownResult() != null ? s.shownResult().warnings()
                : s.live() != null ? s.live().detections().warnings() : new ArrayList<>();
        if (!warnings.isEmpty()) {
            List<String> sentences = new ArrayList<>();
            for (Warning warning : warnings) {
                // several are told apart by more than where a line happens to end
                sentences.add((warnings.size() > 1 ? BULLET : "") + words.message(warning));
            }
            rows.add(new Row(R.drawable.mark_not_converged, R.color.mark_ambiguous, words.get(R.string.warnings), null,
                    String.join("\n", sentences), null));
        }
    }

    private static Row note(int mark, String title, String text, Action action) {
        return new Row(mark, R.color.mark_neutral, title, null, text, action);
    }
}
