package org.cellgauge.android.screen;

import org.cellgauge.android.R;
import org.cellgauge.android.files.FileRefusal;
import org.cellgauge.cell.CellRefusal;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.settings.SettingRefusal;
import org.cellgauge.warning.CheckRefusal;
import org.cellgauge.warning.MessageKind;

/** The strings that say in the user's language why a file or photo is refused. Arguments are the kind's, as texts. */
final class RefusalStrings {
    private RefusalStrings() {
    }

    /** The string of a kind, or {@link WarningStrings#NONE}. */
    static int of(MessageKind kind) {
        if (kind instanceof CellRefusal) {
            return of((CellRefusal) kind);
        }
        if (kind instanceof CellPhrase) {
            return of((CellPhrase) kind);
        }
        if (kind instanceof CheckRefusal) {
            return of((CheckRefusal) kind);
        }
        if (kind instanceof SettingRefusal) {
            return of((SettingRefusal) kind);
        }
        return kind instanceof FileRefusal ? of((FileRefusal) kind) : WarningStrings.NONE;
    }

    private static int of(CellRefusal kind) {
        switch (kind) {
            case IS_FOLDER:
                return R.string.refusal_cell_is_folder;
            case TOO_LARGE:
                return R.string.refusal_cell_too_large;
            case NO_SUCH_FILE:
                return R.string.refusal_cell_no_such_file;
            case NOT_PERMITTED:
                return R.string.refusal_cell_not_permitted;
            case NOT_READABLE:
                return R.string.refusal_cell_not_readable;
            case UTF_16:
                return R.string.refusal_cell_utf_16;
            case NO_UTF_8:
                return R.string.refusal_cell_no_utf_8;
            case BINARY:
                return R.string.refusal_cell_binary;
            case EMPTY:
                return R.string.refusal_cell_empty;
            case NOT_YAML:
                return R.string.refusal_cell_not_yaml;
            case YAML_SYNTAX:
                return R.string.refusal_cell_yaml_syntax;
            case TAB:
                return R.string.refusal_cell_tab;
            case SECOND_DOCUMENT:
                return R.string.refusal_cell_second_document;
            case EXPECTED:
                return R.string.refusal_cell_expected;
            case NEGATIVE:
                return R.string.refusal_cell_negative;
            case NO_WALL:
                return R.string.refusal_cell_no_wall;
            case NO_SUCH_OBJECT:
                return R.string.refusal_cell_no_such_object;
            case NOT_BELOW_ONE:
                return R.string.refusal_cell_not_below_one;
            case NOT_POSITIVE:
                return R.string.refusal_cell_not_positive;
            case OUT_OF_RANGE:
                return R.string.refusal_cell_out_of_range;
            case TAG:
                return R.string.refusal_cell_tag;
            case KEY_NO_WORD:
                return R.string.refusal_cell_key_no_word;
            case MERGE_KEY:
                return R.string.refusal_cell_merge_key;
            case TWICE:
                return R.string.refusal_cell_twice;
            case UNKNOWN_KEY:
                return R.string.refusal_cell_unknown_key;
            case MISSING:
                return R.string.refusal_cell_missing;
            case IS_CAMERA_FILE:
                return R.string.refusal_cell_is_camera_file;
            case IS_DETECTIONS_FILE:
                return R.string.refusal_cell_is_detections_file;
            case NO_FILE_NAME:
                return R.string.refusal_cell_no_file_name;
            case NO_CAMERA_FILE:
                return R.string.refusal_cell_no_camera_file;
            case CAMERA_FILE_NOT_OPENED:
                return R.string.refusal_cell_camera_file_not_opened;
            case CAMERA_FILE:
                return R.string.refusal_cell_camera_file;
            case NO_FAMILY:
                return R.string.refusal_cell_no_family;
            case NO_ORIENTATION:
                return R.string.refusal_cell_no_orientation;
            case MARKER_TOO_SMALL:
                return R.string.refusal_cell_marker_too_small;
            case TOO_LONG:
                return R.string.refusal_cell_too_long;
            case NEGATIVE_DEVIATION:
                return R.string.refusal_cell_negative_deviation;
            case DIRECTION_UNKNOWN:
                return R.string.refusal_cell_direction_unknown;
            case MORE_THAN_A_TURN:
                return R.string.refusal_cell_more_than_a_turn;
            case NO_REFERENCE:
                return R.string.refusal_cell_no_reference;
            case MISSING_AND_NO_OWN:
                return R.string.refusal_cell_missing_and_no_own;
            case NO_ID:
                return R.string.refusal_cell_no_id;
            case ID_NOT_IN_FAMILY:
                return R.string.refusal_cell_id_not_in_family;
            case ID_AMBIGUOUS:
                return R.string.refusal_cell_id_ambiguous;
            case MARKER_TWICE:
                return R.string.refusal_cell_marker_twice;
            case SAME_PLACE:
                return R.string.refusal_cell_same_place;
            case NO_YES_OR_NO:
                return R.string.refusal_cell_no_yes_or_no;
            case NO_LIST:
                return R.string.refusal_cell_no_list;
            case NO_SUCH_REFERENCE:
                return R.string.refusal_cell_no_such_reference;
            case NAMED_TWICE:
                return R.string.refusal_cell_named_twice;
            case IN_TWO_GROUPS:
                return R.string.refusal_cell_in_two_groups;
            case TOO_FEW_MEMBERS:
                return R.string.refusal_cell_too_few_members;
            case TWO_ENDS:
                return R.string.refusal_cell_two_ends;
            case NO_SURVEY:
                return R.string.refusal_cell_no_survey;
            case IS_CELL_FILE:
                return R.string.refusal_cell_is_cell_file;
            case CAMERA_MODEL:
                return R.string.refusal_cell_camera_model;
            case NO_TONE_CURVE:
                return R.string.refusal_cell_no_tone_curve;
            case NO_CAMERA:
                return R.string.refusal_cell_no_camera;
            case SEVERAL_CAMERAS:
                return R.string.refusal_cell_several_cameras;
            case NO_SUCH_CAMERA:
                return R.string.refusal_cell_no_such_camera;
            case NO_OPENCV_XML:
                return R.string.refusal_cell_no_opencv_xml;
            case NO_CAMERA_MATRIX:
                return R.string.refusal_cell_no_camera_matrix;
            case LENS_OF_ANOTHER:
                return R.string.refusal_cell_lens_of_another;
            case LENS_OTHER_WAY_ROUND:
                return R.string.refusal_cell_lens_other_way_round;
            case COEFFICIENTS:
                return R.string.refusal_cell_coefficients;
            case TILTED_SENSOR:
                return R.string.refusal_cell_tilted_sensor;
            case NO_SKEW_THERE:
                return R.string.refusal_cell_no_skew_there;
            case NO_PRISM_THERE:
                return R.string.refusal_cell_no_prism_there;
            case DISTORTION_CONTRADICTS_MODEL:
                return R.string.refusal_cell_distortion_contradicts_model;
            case TOO_MANY_COEFFICIENTS:
                return R.string.refusal_cell_too_many_coefficients;
            case CALIBRATED_PARAMETER:
                return R.string.refusal_cell_calibrated_parameter;
            case NO_COVARIANCE:
                return R.string.refusal_cell_no_covariance;
            case ASYMMETRIC_LENS:
                return R.string.refusal_cell_asymmetric_lens;
            case SYMMETRIC_COEFFICIENTS:
                return R.string.refusal_cell_symmetric_coefficients;
            case FISHEYE_TURNS_BACK:
                return R.string.refusal_cell_fisheye_turns_back;
            case FOCAL_LENGTH:
                return R.string.refusal_cell_focal_length;
            case FOCAL_LENGTHS_DIFFER:
                return R.string.refusal_cell_focal_lengths_differ;
            case PRINCIPAL_POINT_OUTSIDE:
                return R.string.refusal_cell_principal_point_outside;
            case PRINCIPAL_POINT_TURNED:
                return R.string.refusal_cell_principal_point_turned;
            case PRINCIPAL_POINT_ZERO:
                return R.string.refusal_cell_principal_point_zero;
            case SKEW:
                return R.string.refusal_cell_skew;
            case DISTORTION_FOLDS:
                return R.string.refusal_cell_distortion_folds;
            case IMAGE_SIZE:
                return R.string.refusal_cell_image_size;
            default:
                return WarningStrings.NONE;
        }
    }

    private static int of(SettingRefusal kind) {
        switch (kind) {
            case NOT_KNOWN:
                return R.string.refusal_setting_not_known;
            case NOT_WHOLE:
                return R.string.refusal_setting_not_whole;
            case NOT_A_NUMBER:
                return R.string.refusal_setting_not_a_number;
            case NOT_ONE_VALUE:
                return R.string.refusal_setting_not_one_value;
            case NOT_POSITIVE:
                return R.string.refusal_setting_not_positive;
            case NOT_POSITIVE_IN:
                return R.string.refusal_setting_not_positive_in;
            case NOT_BETWEEN:
                return R.string.refusal_setting_not_between;
            case TOO_SMALL:
                return R.string.refusal_setting_too_small;
            case NOT_BELOW_ALL:
                return R.string.refusal_setting_not_below_all;
            case NOT_ABOVE_NOTHING:
                return R.string.refusal_setting_not_above_nothing;
            case TOO_FEW_LEFT:
                return R.string.refusal_setting_too_few_left;
            default:
                return WarningStrings.NONE;
        }
    }

    private static int of(CellPhrase kind) {
        switch (kind) {
            case CELL_FILE:
                return R.string.refusal_part_cell_file;
            case CAMERA_FILE:
                return R.string.refusal_part_camera_file;
            case MAPPING:
                return R.string.refusal_part_mapping;
            case TEXT:
                return R.string.refusal_part_text;
            case NUMBER:
                return R.string.refusal_part_number;
            case FINITE_NUMBER:
                return R.string.refusal_part_finite_number;
            case WHOLE_NUMBER:
                return R.string.refusal_part_whole_number;
            case NUMBERS:
                return R.string.refusal_part_numbers;
            case LIST:
                return R.string.refusal_part_list;
            case NOTHING:
                return R.string.refusal_part_nothing;
            case WORD:
                return R.string.refusal_part_word;
            case QUOTED:
                return R.string.refusal_part_quoted;
            case WITH_POINT:
                return R.string.refusal_part_with_point;
            case WITHOUT_UNIT:
                return R.string.refusal_part_without_unit;
            case WITHOUT_QUOTES:
                return R.string.refusal_part_without_quotes;
            case POINT_NOT_COMMA:
                return R.string.refusal_part_point_not_comma;
            case DID_YOU_MEAN:
                return R.string.refusal_part_did_you_mean;
            case KNOWN_HERE:
                return R.string.refusal_part_known_here;
            case GAMMA_HINT:
                return R.string.refusal_part_gamma_hint;
            case A_CELL_FILE:
                return R.string.refusal_part_a_cell_file;
            case VERSION_LINE:
                return R.string.refusal_part_version_line;
            case VERSION:
                return R.string.refusal_part_version;
            case CAMERA:
                return R.string.refusal_part_camera;
            case REFERENCES:
                return R.string.refusal_part_references;
            case OBJECTS:
                return R.string.refusal_part_objects;
            case ROTATION:
                return R.string.refusal_part_rotation;
            case OR_DELETE:
                return R.string.refusal_part_or_delete;
            case OBJECT:
                return R.string.refusal_part_object;
            case REFERENCE_ID:
                return R.string.refusal_part_reference_id;
            case LENGTH:
                return R.string.refusal_part_length;
            case CAMERA_POSE:
                return R.string.refusal_part_camera_pose;
            case RANGE:
                return R.string.refusal_part_range;
            case AREA:
                return R.string.refusal_part_area;
            case WALL:
                return R.string.refusal_part_wall;
            case MAX_HEIGHT:
                return R.string.refusal_part_max_height;
            case COST:
                return R.string.refusal_part_cost;
            case TARGET_STD:
                return R.string.refusal_part_target_std;
            case TARGET_TOLERANCE:
                return R.string.refusal_part_target_tolerance;
            case TARGET_DISTANCE:
                return R.string.refusal_part_target_distance;
            case TARGET_TURN:
                return R.string.refusal_part_target_turn;
            case TARGET_PROBABILITY:
                return R.string.refusal_part_target_probability;
            case SIZE_STD:
                return R.string.refusal_part_size_std;
            case FLATNESS_STD:
                return R.string.refusal_part_flatness_std;
            case PRINT_GAIN_STD:
                return R.string.refusal_part_print_gain_std;
            case MARKER_SIZE:
                return R.string.refusal_part_marker_size;
            case MARKER_SIZE_KEY:
                return R.string.refusal_part_marker_size_key;
            case PLACEMENT_STDS:
                return R.string.refusal_part_placement_stds;
            case PLACEMENT_STD:
                return R.string.refusal_part_placement_std;
            case TURN_STD:
                return R.string.refusal_part_turn_std;
            case PIXEL_STD:
                return R.string.refusal_part_pixel_std;
            case CAMERA_KEYS:
                return R.string.refusal_part_camera_keys;
            case VARIANCE:
                return R.string.refusal_part_variance;
            case FOCUS_DISTANCE:
                return R.string.refusal_part_focus_distance;
            case PHOTOS_OF_CALIBRATION:
                return R.string.refusal_part_photos_of_calibration;
            case ITS_CAMERAS:
                return R.string.refusal_part_its_cameras;
            case ONE_CAMERA:
                return R.string.refusal_part_one_camera;
            case COEFFICIENT_OF_ANGLE:
                return R.string.refusal_part_coefficient_of_angle;
            case SYMMETRIC:
                return R.string.refusal_part_symmetric;
            case COEFFICIENT:
                return R.string.refusal_part_coefficient;
            case BOOFCV_VERSION:
                return R.string.refusal_part_boofcv_version;
            case TONE_CURVE:
                return R.string.refusal_part_tone_curve;
            case FOCAL_LENGTH:
                return R.string.refusal_part_focal_length;
            case PRINCIPAL_POINT:
                return R.string.refusal_part_principal_point;
            case SKEW:
                return R.string.refusal_part_skew;
            case IMAGE_WIDTH:
                return R.string.refusal_part_image_width;
            case IMAGE_HEIGHT:
                return R.string.refusal_part_image_height;
            case CALIBRATED_WIDTH:
                return R.string.refusal_part_calibrated_width;
            case CALIBRATED_HEIGHT:
                return R.string.refusal_part_calibrated_height;
            case RADIAL:
                return R.string.refusal_part_radial;
            case TANGENTIAL:
                return R.string.refusal_part_tangential;
            case WIDTH:
                return R.string.refusal_part_width;
            case HEIGHT:
                return R.string.refusal_part_height;
            case IMAGE_TURNED:
                return R.string.refusal_part_image_turned;
            case IMAGE_SCALED:
                return R.string.refusal_part_image_scaled;
            case PHOTO_SIZE:
                return R.string.refusal_part_photo_size;
            case CAMERA_OF_THIS_SIZE:
                return R.string.refusal_part_camera_of_this_size;
            case OTHER_SIZE:
                return R.string.refusal_part_other_size;
            default:
                return WarningStrings.NONE;
        }
    }

    private static int of(CheckRefusal kind) {
        switch (kind) {
            case TONE_CURVE_OPEN:
                return R.string.refusal_check_tone_curve_open;
            case NO_REFERENCE_SEEN:
                return R.string.refusal_check_no_reference_seen;
            case NO_REFERENCE_LEFT:
                return R.string.refusal_check_no_reference_left;
            case NO_CAMERA_POSE:
                return R.string.refusal_check_no_camera_pose;
            case NO_OBJECT_POSE:
                return R.string.refusal_check_no_object_pose;
            case PLACE_UNKNOWN:
                return R.string.refusal_check_place_unknown;
            case FLAT_FOCAL_IN_PLANE:
                return R.string.refusal_check_flat_focal_in_plane;
            case FLAT_FOCAL_OPEN:
                return R.string.refusal_check_flat_focal_open;
            case NO_TANGENTIAL_COEFFICIENTS:
                return R.string.refusal_check_no_tangential_coefficients;
            case CHAINS_CANNOT_START:
                return R.string.refusal_check_chains_cannot_start;
            default:
                return WarningStrings.NONE;
        }
    }

    private static int of(FileRefusal kind) {
        switch (kind) {
            case NO_DOCUMENT:
                return R.string.refusal_file_no_document;
            case GONE:
                return R.string.refusal_file_gone;
            case PERMISSION_ENDED:
                return R.string.refusal_file_permission_ended;
            case NOT_READABLE:
                return R.string.refusal_file_not_readable;
            case APP_FAILS:
                return R.string.refusal_file_app_fails;
            case EMPTY:
                return R.string.refusal_file_empty;
            case OTHER_FORMAT:
                return R.string.refusal_file_other_format;
            case HEIC:
                return R.string.refusal_file_heic;
            case UNKNOWN_FORMAT:
                return R.string.refusal_file_unknown_format;
            case CUT_SHORT:
                return R.string.refusal_file_cut_short;
            case DAMAGED:
                return R.string.refusal_file_damaged;
            case DAMAGED_JPEG:
                return R.string.refusal_file_damaged_jpeg;
            case UNUSUAL:
                return R.string.refusal_file_unusual;
            case CMYK:
                return R.string.refusal_file_cmyk;
            case TOO_LARGE:
                return R.string.refusal_file_too_large;
            case MEMORY:
                return R.string.refusal_file_memory;
            case PIXELS:
                return R.string.refusal_file_pixels;
            case MEMORY_FOR_CHECK:
                return R.string.refusal_file_memory_for_check;
            case STORAGE_FULL:
                return R.string.refusal_file_storage_full;
            case RESULT_MEMORY:
                return R.string.refusal_file_result_memory;
            case PICTURE_NOT_WRITTEN:
                return R.string.refusal_file_picture_not_written;
            case NO_FOLDER_FOR_RESULTS:
                return R.string.refusal_file_no_folder_for_results;
            case NO_FOLDER_FOR_RESULT:
                return R.string.refusal_file_no_folder_for_result;
            case RESULT_NOT_NAMED:
                return R.string.refusal_file_result_not_named;
            case RESULT_NOT_READ:
                return R.string.refusal_file_result_not_read;
            case PHOTO:
                return R.string.refusal_file_photo;
            case LICENCES:
                return R.string.refusal_file_licences;
            default:
                return WarningStrings.NONE;
        }
    }
}
