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
            case GLARE:
                return R.string.warning_glare;
            case BLACKS_CRUSHED:
                return R.string.warning_blacks_crushed;
            case IN_BLOCKS:
                return R.string.warning_in_blocks;
            case SHARPENED:
                return R.string.warning_sharpened;
            case TOO_BLURRED:
                return R.string.warning_too_blurred;
            case TOO_DARK:
                return R.string.warning_too_dark;
            case LIGHT_UNEVEN:
                return R.string.warning_light_uneven;
            case MARGIN_TOO_THIN:
                return R.string.warning_margin_too_thin;
            case FAINT:
                return R.string.warning_faint;
            case INVERTED:
                return R.string.warning_inverted;
            case MIRRORED:
                return R.string.warning_mirrored;
            case OTHER_IDS:
                return R.string.warning_other_ids;
            case OTHER_FAMILY:
                return R.string.warning_other_family;
            case NEARLY_BLACK:
                return R.string.warning_nearly_black;
            case NEARLY_WHITE:
                return R.string.warning_nearly_white;
            case BLURRED:
                return R.string.warning_blurred;
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
            case MARKER_NO_SQUARE:
                return R.string.warning_marker_no_square;
            case MARKERS_IN_ONE_PLACE:
                return R.string.warning_markers_in_one_place;
            case REFERENCES_IN_ONE_PLACE:
                return R.string.warning_references_in_one_place;
            case PLACES_WIDE:
                return R.string.warning_places_wide;
            case CHAINS_APART:
                return R.string.warning_chains_apart;
            case REFERENCES_DO_NOT_FIT:
                return R.string.warning_references_do_not_fit;
            case AS_IF_MARKERS:
                return R.string.warning_as_if_markers;
            case AS_IF_SOME_MARKERS:
                return R.string.warning_as_if_some_markers;
            case AS_IF_EDGES:
                return R.string.warning_as_if_edges;
            case AS_IF_FOCAL_LENGTH:
                return R.string.warning_as_if_focal_length;
            case AS_IF_PRINCIPAL_POINT:
                return R.string.warning_as_if_principal_point;
            case AS_IF_DISTORTION:
                return R.string.warning_as_if_distortion;
            case AS_IF_STRETCHED:
                return R.string.warning_as_if_stretched;
            case AS_IF_SCALED:
                return R.string.warning_as_if_scaled;
            case POSITIONS_IN_ANOTHER_UNIT:
                return R.string.warning_positions_in_another_unit;
            case SIZES_IN_ANOTHER_UNIT:
                return R.string.warning_sizes_in_another_unit;
            case REFERENCES_EXCHANGED:
                return R.string.warning_references_exchanged;
            case REFERENCE_TURNED_ABOUT:
                return R.string.warning_reference_turned_about;
            case ALL_TURNED_ABOUT:
                return R.string.warning_all_turned_about;
            case AXIS_MIRRORED:
                return R.string.warning_axis_mirrored;
            case ROTATIONS_IN_RADIANS:
                return R.string.warning_rotations_in_radians;
            case REFERENCE_ELSEWHERE:
                return R.string.warning_reference_elsewhere;
            case REFERENCES_CONTRADICT:
                return R.string.warning_references_contradict;
            case TURNS_TOO_LOOSE:
                return R.string.warning_turns_too_loose;
            case REFERENCE_LEFT_OUT:
                return R.string.warning_reference_left_out;
            case INITIAL_ESTIMATE_FAILED:
                return R.string.warning_initial_estimate_failed;
            case INTRINSICS_NOT_LEARNED:
                return R.string.warning_intrinsics_not_learned;
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
            case PLACE:
                return R.string.phrase_place;
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
            case OR_CAUSE:
                return R.string.warning_part_or_cause;
            case LARGER:
                return R.string.warning_part_larger;
            case SMALLER:
                return R.string.warning_part_smaller;
            case INWARDS:
                return R.string.warning_part_inwards;
            case OUTWARDS:
                return R.string.warning_part_outwards;
            case LONGER:
                return R.string.warning_part_longer;
            case SHORTER:
                return R.string.warning_part_shorter;
            case FARTHER_APART:
                return R.string.warning_part_farther_apart;
            case CLOSER_TOGETHER:
                return R.string.warning_part_closer_together;
            case STATED:
                return R.string.warning_part_stated;
            case CAUSE_MARKER_SIZE:
                return R.string.warning_part_cause_marker_size;
            case CAUSE_SIZE_OF_SOME:
                return R.string.warning_part_cause_size_of_some;
            case CAUSE_EDGE_SHIFT:
                return R.string.warning_part_cause_edge_shift;
            case CAUSE_FOCAL_LENGTH:
                return R.string.warning_part_cause_focal_length;
            case CAUSE_PRINCIPAL_POINT:
                return R.string.warning_part_cause_principal_point;
            case CAUSE_DISTORTION:
                return R.string.warning_part_cause_distortion;
            case CAUSE_STRETCH:
                return R.string.warning_part_cause_stretch;
            case CAUSE_POSITION_SCALE:
                return R.string.warning_part_cause_position_scale;
            case CAUSE_SIZE_UNIT:
                return R.string.warning_part_cause_size_unit;
            case CAUSE_EXCHANGED:
                return R.string.warning_part_cause_exchanged;
            case CAUSE_TURNED:
                return R.string.warning_part_cause_turned;
            case CAUSE_ALL_TURNED:
                return R.string.warning_part_cause_all_turned;
            case CAUSE_MIRRORED:
                return R.string.warning_part_cause_mirrored;
            case CAUSE_RADIANS:
                return R.string.warning_part_cause_radians;
            case CAUSE_REFERENCE:
                return R.string.warning_part_cause_reference;
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
