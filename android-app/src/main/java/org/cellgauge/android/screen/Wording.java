package org.cellgauge.android.screen;

import android.content.res.Resources;
import java.text.NumberFormat;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.cellgauge.android.R;
import org.cellgauge.android.camera.CameraFault;
import org.cellgauge.android.camera.CameraModelSource;
import org.cellgauge.android.camera.CameraNote;
import org.cellgauge.android.state.Problem;
import org.cellgauge.android.state.TargetUse;
import org.cellgauge.cell.Requirement;
import org.cellgauge.cell.Target;
import org.cellgauge.check.Conformity;
import org.cellgauge.check.Reason;
import org.cellgauge.estimate.VarianceSource;
import org.cellgauge.internal.overlay.LabelWords;
import org.cellgauge.internal.overlay.LegendWords;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.output.BudgetShare;
import org.cellgauge.output.ResultRow;
import org.cellgauge.placement.Misfit;
import org.cellgauge.placement.Misplacement;
import org.cellgauge.statistics.ChainDiagnostics;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.Message;
import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.Warning;

/** Sentences in the user's language, with numbers as written there, from what core and camera say in parts. */
final class Wording {
    /** What causes less of a variance is not worth a line. */
    private static final double LEAST_SHARE = 0.005;

    private final Resources resources;
    private final Locale locale;

    Wording(Resources resources) {
        this.resources = resources;
        this.locale = resources.getConfiguration().getLocales().get(0);
    }

    /** The language, with its country. */
    Locale locale() {
        return locale;
    }

    String get(int id, Object... arguments) {
        // a string without arguments is no pattern: a per cent sign in it stands for itself
        return arguments.length == 0 ? resources.getString(id) : resources.getString(id, arguments);
    }

    String plural(int id, int count, Object... arguments) {
        return resources.getQuantityString(id, count, arguments);
    }

    // ---- numbers

    /** A deviation in mm, to a hundredth, as core's reasons have it. */
    String mm(double value) {
        return number(value, 2);
    }

    String number(double value, int decimals) {
        if (Double.isNaN(value)) {
            return get(R.string.undefined);
        }
        NumberFormat format = NumberFormat.getNumberInstance(locale);
        format.setMinimumFractionDigits(decimals);
        format.setMaximumFractionDigits(decimals);
        return format.format(value);
    }

    /** A number as it was chosen, without digits that say nothing. */
    String plain(double value) {
        NumberFormat format = NumberFormat.getNumberInstance(locale);
        format.setMaximumFractionDigits(6);
        return format.format(value);
    }

    /** A share of one to the percent, as in the picture's labels. */
    String percent(double share) {
        return NumberFormat.getPercentInstance(locale).format(share);
    }

    /** Ids as in "5, 20 and 30". */
    String ids(List<Integer> ids) {
        return listing(Listing.and(ids));
    }

    private String listing(Listing listing) {
        int more = listing.join() == Listing.Join.SEMICOLON ? R.string.list_sentences : R.string.list_more;
        int last = listing.join() == Listing.Join.AND ? R.string.list_two
                : listing.join() == Listing.Join.OR ? R.string.list_or : more;
        String text = "";
        int count = listing.items().size();
        for (int i = 0; i < count; i++) {
            String item = argument(listing.items().get(i));
            text = i == 0 ? item : get(i == count - 1 ? last : more, text, item);
        }
        return text;
    }

    // ---- core

    /** Why a file, a photo or a frame cannot be used, with the place of the fault. */
    String refusal(Refusal refusal) {
        String sentence = message(refusal);
        return refusal.place() == null ? sentence : get(R.string.refusal_at, place(refusal.place()), sentence);
    }

    private String place(Place place) {
        String text = place.file();
        text = place.line() > 0 ? get(R.string.place_line, text, place.line()) : text;
        text = place.column() > 0 ? get(R.string.place_column, text, place.column()) : text;
        return place.key().isEmpty() ? text : get(R.string.place_key, text, place.key());
    }

    /** Why something was not done; what the system says of it in its own words. */
    String problem(Problem problem) {
        if (problem.kind() == Problem.Kind.MEMORY) {
            return get(R.string.reason_memory);
        }
        return problem.refusal() == null ? problem.message() : refusal(problem.refusal());
    }

    /** A sentence of core, or a part of one; in English where it is of a kind that only others know. */
    String message(Message message) {
        int warning = WarningStrings.of(message.kind());
        int id = warning == WarningStrings.NONE ? RefusalStrings.of(message.kind()) : warning;
        id = id == WarningStrings.NONE ? ChangeStrings.of(message.kind()) : id;
        if (id == WarningStrings.NONE) {
            return message.toString();
        }
        Object[] arguments = new Object[message.arguments().size()];
        for (int i = 0; i < arguments.length; i++) {
            arguments[i] = argument(message.arguments().get(i));
        }
        return get(id, arguments);
    }

    private String argument(Object argument) {
        if (argument instanceof Decimal) {
            return decimal((Decimal) argument);
        }
        if (argument instanceof Listing) {
            return listing((Listing) argument);
        }
        if (argument instanceof Refusal) {
            return refusal((Refusal) argument);
        }
        return argument instanceof Message ? message((Message) argument) : argument.toString();
    }

    /** Grouped where it is whole: those with decimals stand in rows, where a comma between thousands would mislead. */
    private String decimal(Decimal value) {
        if (Double.isNaN(value.value())) {
            return get(R.string.undefined);
        }
        NumberFormat format = NumberFormat.getNumberInstance(locale);
        format.setGroupingUsed(value.decimals() == 0);
        format.setMinimumFractionDigits(value.decimals());
        format.setMaximumFractionDigits(value.decimals());
        return format.format(value.value());
    }

    /** Why a check ended as it did. */
    String reason(Reason reason) {
        switch (reason.kind()) {
            case NOT_CONVERGED:
                return get(R.string.not_converged, reason.worstParameter().name(), number(reason.rHat(), 3),
                        number(reason.effectiveDraws(), 0));
            case NEVER_MOVED:
                return get(R.string.never_moved, reason.worstParameter().name());
            case NON_FINITE:
                return get(R.string.non_finite, reason.worstParameter().name());
            case TOO_SHORT:
                return get(R.string.chains_too_short, ChainDiagnostics.MIN_DRAWS);
            case CONTRADICTED:
                return get(R.string.no_figure) + misfit(reason, " ");
            case TWO_CAMERA_POSES:
                return get(R.string.two_camera_poses, percent(reason.share().getAsDouble()));
            case TWO_OBJECT_POSES:
                return get(R.string.two_object_poses, reason.objectId().getAsInt(),
                        percent(reason.share().getAsDouble()));
            case OBJECT_NOT_SEEN:
                return plural(R.plurals.not_seen, reason.missingObjects().size(), ids(reason.missingObjects())) + " "
                        + deviation(reason) + tolerance(reason, " ") + undecided(reason) + misfit(reason, " ")
                        + misplacement(reason, " ");
            default:
                return (reason.hasTarget() ? "" : get(R.string.no_target) + " ") + deviation(reason)
                        + tolerance(reason, " ") + undecided(reason) + misfit(reason, " ") + misplacement(reason, " ");
        }
    }

    private String deviation(Reason reason) {
        if (!reason.stdMm().isPresent()) {
            return get(R.string.no_object);
        }
        String std = mm(reason.stdMm().getAsDouble());
        String of = get(reason.grip() ? R.string.of_grip : R.string.of_object, reason.objectId().getAsInt());
        String share = percent(reason.share().getAsDouble());
        OptionalDouble target = reason.targetMm();
        return target.isPresent()
                ? get(R.string.largest_target, std, axis(reason), of, plain(target.getAsDouble()), share,
                        source(reason))
                : get(R.string.largest, std, axis(reason), of, share, source(reason));
    }

    /** The tolerance that is kept least surely, after what stands before it; empty where there is none. */
    String tolerance(Reason reason, String before) {
        Conformity c = reason == null ? null : reason.conformity();
        if (c == null) {
            return "";
        }
        String of = get(reason.conformityOfGrip() ? R.string.of_grip : R.string.of_object,
                reason.conformityObjectId());
        return before + get(c.isDecided() ? R.string.tolerance : R.string.tolerance_undecided, tolerance(c), of,
                number(c.probability(), 4), plain(c.asked()), number(c.mcse(), 4));
    }

    /** Whether one tolerance along every axis is asked for, and nothing else. */
    static boolean isTolerance(Target target) {
        Requirement asked = target.general();
        return target.own().isEmpty() && asked.toleranceMm().isUniform() && !asked.stdMm().isAny()
                && asked.distanceMm() == Double.POSITIVE_INFINITY && asked.toleranceDeg() == Double.POSITIVE_INFINITY;
    }

    /** A target in a sentence. */
    String target(Target target) {
        if (!target.isAny()) {
            return get(R.string.target_none);
        }
        if (target.oneStdMm().isPresent()) {
            return get(R.string.target_in_use, plain(target.oneStdMm().getAsDouble()));
        }
        Requirement asked = target.general();
        return isTolerance(target) ? get(R.string.target_tolerance_all, plain(asked.toleranceMm().x()),
                tenthOfPercent(asked.probability())) : get(R.string.target_of_cell);
    }

    /** How much of what is asked an object takes, as its bar shows it; null where nothing is asked. */
    String use(TargetUse use) {
        if (use == null) {
            return null;
        }
        Conformity c = use.conformity();
        if (c == null) {
            return get(use.grip() ? R.string.use_std_grip : R.string.use_std,
                    number(use.stdMm(), use.limitMm() < 1 ? 2 : 1),
                    plain(use.limitMm()), axis(use.axis()));
        }
        return get(use.grip() ? R.string.use_tolerance_grip : R.string.use_tolerance, tenthOfPercent(c.probability()),
                tolerance(c), tenthOfPercent(c.asked()));
    }

    /** Not rounded up to a certainty that is not there. */
    String tenthOfPercent(double share) {
        return plain(Math.floor(share * 1000 + 1e-9) / 10) + "\u00A0%";
    }

    private String tolerance(Conformity c) {
        switch (c.of()) {
            case DISTANCE:
                return get(R.string.tolerance_distance, plain(c.tolerance()));
            case TURN:
                return get(R.string.tolerance_turn, plain(c.tolerance()));
            default:
                return get(R.string.tolerance_axis, plain(c.tolerance()), c.of().key());
        }
    }

    private String undecided(Reason reason) {
        return reason.undecidedMm().isPresent()
                ? " " + get(R.string.undecided, number(reason.undecidedMm().getAsDouble(), 3)) : "";
    }

    /** What causes most of one object's largest deviation; null where core does not say. */
    String cause(Reason reason) {
        if (reason == null || reason.source() == null) {
            return null;
        }
        return get(reason.grip() ? R.string.cause_grip : R.string.cause, percent(reason.share().getAsDouble()),
                axis(reason), source(reason));
    }

    /** What causes how much of the variance of a point, the largest first; empty where that is not known. */
    String budget(int heading, ResultRow row) {
        List<BudgetShare> shares = new ArrayList<>(row.budget());
        shares.sort((a, b) -> Double.compare(b.share(), a.share()));
        StringBuilder text = new StringBuilder();
        for (BudgetShare share : shares) {
            if (share.share() >= LEAST_SHARE) {
                text.append('\n').append(get(R.string.budget_line, percent(share.share()), source(share.source())));
            }
        }
        return text.length() == 0 ? "" : get(heading) + text;
    }

    /** What the photo contradicts, after what stands before it; empty where it contradicts nothing. */
    String misfit(Reason reason, String before) {
        Misfit m = reason == null ? null : reason.misfit();
        if (m == null) {
            return "";
        }
        switch (m.kind()) {
            case NOISE:
                return before + get(R.string.misfit_noise, number(m.times(), 1), number(m.statedStdPx(), 3),
                        number(m.shownStdPx(), 3));
            case MARKER:
                return before + get(R.string.misfit_marker, m.markerId().getAsInt(), number(m.times(), 1),
                        number(m.statedStdPx(), 3));
            case CAUSE:
                return before + get(R.string.misfit_cause, message(m.cause().warning()));
            case CONTRADICTION:
                return before + get(R.string.misfit_cause, message(Warning.of(CheckWarning.REFERENCES_CONTRADICT)));
            case NO_SQUARE:
                return before + get(R.string.misfit_no_square, m.markerId().getAsInt(), number(m.times(), 1));
            case ONE_PLACE_IN_PHOTO:
                return before + get(R.string.misfit_one_place_in_photo, m.markerId().getAsInt(),
                        m.otherId().getAsInt());
            case ONE_PLACE_IN_CELL:
                return before + get(R.string.misfit_one_place_in_cell, m.markerId().getAsInt(),
                        m.otherId().getAsInt());
            case CHAINS_APART:
                return before + get(R.string.misfit_chains_apart);
            default:
                return before + get(R.string.misfit_references, number(m.times(), 1));
        }
    }

    /** What misplaced references add, after what stands before it; empty where none seems misplaced. */
    String misplacement(Reason reason, String before) {
        Misplacement m = reason == null ? null : reason.misplacement();
        if (m == null) {
            return "";
        }
        String text = before + plural(R.plurals.misplaced, m.references().size(), ids(m.references()));
        if (m.objectId().isPresent()) {
            text += " " + get(R.string.misplaced_error, mm(m.errorMm()), axis(m.axis()),
                    get(m.grip() ? R.string.of_grip : R.string.of_object, m.objectId().getAsInt()));
        } else if (m.errorMm() > 0) {
            text += " " + get(R.string.misplaced_no_pose);
        }
        return m.targetMet() ? text + " " + get(R.string.misplaced_met) : text;
    }

    private static String axis(Reason reason) {
        return axis(reason.axis().getAsInt());
    }

    private static String axis(int axis) {
        return "xyz".substring(axis, axis + 1);
    }

    private String source(Reason reason) {
        return source(reason.source());
    }

    private String source(VarianceSource source) {
        switch (source.kind()) {
            case PLACEMENT_OF_REFERENCE:
                return get(R.string.source_placement, source.referenceId().getAsInt());
            case CORNER_NOISE_OF_REFERENCES:
                return get(R.string.source_reference_corners);
            case CORNER_NOISE_OF_OBJECT:
                return get(R.string.source_object_corners);
            case FLATNESS_OF_PRINTS:
                return get(R.string.source_flatness);
            case INTRINSICS:
                return get(R.string.source_intrinsics);
            case CALIBRATION:
                return get(R.string.source_calibration);
            case EDGES:
                return get(R.string.source_edges);
            case SIZE_OF_PRINTS:
                return get(R.string.source_sizes);
            case COMMON_PLACEMENT:
                return get(R.string.source_common_placement);
            default:
                return get(R.string.source_pose_prior);
        }
    }

    /** What labels in the picture say. */
    LabelWords labels() {
        return new LabelWords(locale, get(R.string.label_left_out), get(R.string.label_misplaced),
                get(R.string.label_not_seen), get(R.string.label_not_in_cell), get(R.string.label_not_converged),
                get(R.string.label_not_converged_yet), get(R.string.label_ambiguous), get(R.string.label_grip));
    }

    /** What the legend of a kept picture says. */
    LegendWords legend() {
        // patterns go as they are: core puts the numbers in
        return new LegendWords(locale, get(R.string.legend_reference), get(R.string.legend_expected),
                get(R.string.legend_true_size), get(R.string.legend_magnified), get(R.string.legend_not_converged),
                get(R.string.legend_grip), get(R.string.legend_second_pose), get(R.string.legend_deviations),
                get(R.string.legend_grid), get(R.string.legend_grid_axes), get(R.string.legend_nothing));
    }

    // ---- camera

    String fault(CameraFault fault) {
        switch (fault) {
            case NO_CAMERA:
                return get(R.string.fault_no_camera);
            case NOT_PERMITTED:
                return get(R.string.fault_not_permitted);
            case IN_USE:
                return get(R.string.fault_in_use);
            case DISABLED:
                return get(R.string.fault_disabled);
            case DISCONNECTED:
                return get(R.string.fault_disconnected);
            case NO_SUITABLE_SIZE:
                return get(R.string.fault_no_size);
            case NO_CAMERA_MODEL:
                return get(R.string.fault_no_model);
            default:
                return get(R.string.fault_failed);
        }
    }

    String remedy(CameraFault fault) {
        switch (fault) {
            case NO_CAMERA:
                return get(R.string.fault_no_camera_text);
            case NOT_PERMITTED:
                return get(R.string.fault_not_permitted_text);
            case IN_USE:
                return get(R.string.fault_in_use_text);
            case DISABLED:
                return get(R.string.fault_disabled_text);
            case DISCONNECTED:
                return get(R.string.fault_disconnected_text);
            case NO_SUITABLE_SIZE:
                return get(R.string.fault_no_size_text);
            case NO_CAMERA_MODEL:
                return get(R.string.fault_no_model_text);
            default:
                return get(R.string.fault_failed_text);
        }
    }

    String note(CameraNote note) {
        switch (note) {
            case FOCUS_NOT_LOCKED:
                return get(R.string.note_focus);
            case FOCUS_NOT_FOUND:
                return get(R.string.note_focus_not_found);
            case FOCUS_AS_CALIBRATED:
                return get(R.string.note_focus_as_calibrated);
            case FOCUS_NOT_AS_CALIBRATED:
                return get(R.string.note_focus_not_as_calibrated);
            case LIGHT_SHORT:
                return get(R.string.note_light_short);
            case STABILISATION_ON:
                return get(R.string.note_stabilisation);
            case DISTORTION_UNKNOWN:
                return get(R.string.note_distortion);
            case CALIBRATION_SCALED:
                return get(R.string.note_scaled);
            case CALIBRATION_OF_ANOTHER_CAMERA:
                return get(R.string.note_other_camera);
            default:
                return get(R.string.note_focal);
        }
    }

    String model(CameraModelSource source) {
        switch (source) {
            case CALIBRATION_FILE:
                return get(R.string.camera_model_calibration);
            case DEVICE_CALIBRATION:
                return get(R.string.camera_model_device);
            default:
                return get(R.string.camera_model_view);
        }
    }
}
