package org.cellgauge.android.screen;

import org.cellgauge.android.R;
import org.cellgauge.internal.warning.CheckPhrase;
import org.cellgauge.vision.DetectionWarning;
import org.cellgauge.warning.CheckWarning;
import org.cellgauge.warning.MessageKind;

/** The strings that say in the user's language what core warns of. Their arguments are those of the kind, as texts. */
final class WarningStrings {
    /** Stands for a kind that the app does not know. */
    static final int NONE = 0;

    private WarningStrings() {
    }

    /** The string of a kind, or {@link #NONE}. */
    static int of(MessageKind kind) {
        if (kind instanceof DetectionWarning) {
            return of((DetectionWarning) kind);
        }
        if (kind instanceof CheckWarning) {
            return of((CheckWarning) kind);
        }
        return kind instanceof CheckPhrase ? of((CheckPhrase) kind) : NONE;
    }

    private static int of(DetectionWarning kind) {
        switch (kind) {
            case CELLS_DO_NOT_MATCH:
                return R.string.warning_cells_do_not_match;
            case EDGES_NOT_MEASURED:
                return R.string.warning_edges_not_measured;
            case NOT_SQUARE:
                return R.string.warning_not_square;
            case SEEN_TWICE:
                return R.string.warning_seen_twice;
            case COARSE_CORNERS:
                return R.string.warning_coarse_corners;
            case WHITES_CLIPPED:
                return R.string.warning_whites_clipped;
            case BLACKS_CRUSHED:
                return R.string.warning_blacks_crushed;
            case SHARPENED:
                return R.string.warning_sharpened;
            case TOO_BLURRED:
                return R.string.warning_too_blurred;
            case TOO_DARK:
                return R.string.warning_too_dark;
            case LIGHT_UNEVEN:
                return R.string.warning_light_uneven;
            default:
                return NONE;
        }
    }

    private static int of(CheckWarning kind) {
        switch (kind) {
            case FAR_FROM_GAUSSIAN:
                return R.string.warning_far_from_gaussian;
            case OBJECTS_NOT_SEEN:
                return R.string.warning_objects_not_seen;
            case PRINCIPAL_POINT_OFF:
                return R.string.warning_principal_point_off;
            case REFERENCES_NOT_SEEN:
                return R.string.warning_references_not_seen;
            case SMALL_MARKERS:
                return R.string.warning_small_markers;
            case CORNER_NOISE_ESTIMATED:
                return R.string.warning_corner_noise_estimated;
            case MARKER_SET_ASIDE:
                return R.string.warning_marker_set_aside;
            case HEAVY_TAILS:
                return R.string.warning_heavy_tails;
            case NOISIER_THAN_STATED:
                return R.string.warning_noisier_than_stated;
            case MARKER_NOISIER_THAN_STATED:
                return R.string.warning_marker_noisier_than_stated;
            case REFERENCES_DO_NOT_FIT:
                return R.string.warning_references_do_not_fit;
            case TURNS_TOO_LOOSE:
                return R.string.warning_turns_too_loose;
            case REFERENCE_LEFT_OUT:
                return R.string.warning_reference_left_out;
            case INITIAL_ESTIMATE_FAILED:
                return R.string.warning_initial_estimate_failed;
            case DIRECTION_OPEN:
                return R.string.warning_direction_open;
            case CAP_REACHED:
                return R.string.warning_cap_reached;
            case REFERENCE_OFF:
                return R.string.warning_reference_off;
            case REFERENCE_TURNED:
                return R.string.warning_reference_turned;
            case FIGURES_REST_ON_IT:
                return R.string.warning_figures_rest_on_it;
            case FIGURES_REST_ON_THEM:
                return R.string.warning_figures_rest_on_them;
            case NO_POSE_WITHOUT_IT:
                return R.string.warning_no_pose_without_it;
            case NO_POSE_WITHOUT_THEM:
                return R.string.warning_no_pose_without_them;
            default:
                return NONE;
        }
    }

    private static int of(CheckPhrase kind) {
        switch (kind) {
            case MISFIT:
                return R.string.warning_part_misfit;
            case SMALL_MARKER:
                return R.string.warning_part_small_marker;
            case WEAK_PRIOR:
                return R.string.warning_part_weak_prior;
            case SHIFT:
                return R.string.warning_part_shift;
            case TURN:
                return R.string.warning_part_turn;
            case STD_MM:
                return R.string.warning_part_std_mm;
            case STD_DEGREES:
                return R.string.warning_part_std_degrees;
            case OR_INSTEAD:
                return R.string.warning_part_or_instead;
            case CAMERA:
                return R.string.warning_part_camera;
            case OBJECT:
                return R.string.warning_part_object;
            case GRIP:
                return R.string.warning_part_grip;
            case MORE_THAN_ANY_OTHER:
                return R.string.warning_part_more_than_any_other;
            case LARGEST_DEVIATION:
                return R.string.warning_part_largest_deviation;
            case MORE_ITERATIONS:
                return R.string.warning_part_more_iterations;
            case INITIAL_PNP:
                return R.string.warning_part_initial_pnp;
            case DENSITY_AT_START:
                return R.string.warning_part_density_at_start;
            default:
                return NONE;
        }
    }
}
