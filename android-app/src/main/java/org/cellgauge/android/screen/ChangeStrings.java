package org.cellgauge.android.screen;

import org.cellgauge.android.R;
import org.cellgauge.cell.ChangeKind;
import org.cellgauge.warning.MessageKind;

/** The strings that say in the user's language what to change in the cell. Arguments are the kind's, as texts. */
final class ChangeStrings {
    private ChangeStrings() {
    }

    /** The string of a kind, or {@link WarningStrings#NONE}. */
    static int of(MessageKind kind) {
        if (!(kind instanceof ChangeKind)) {
            return WarningStrings.NONE;
        }
        switch ((ChangeKind) kind) {
            case PLACE_PRECISELY:
                return R.string.change_place_precisely;
            case MEASURE_REFERENCE:
                return R.string.change_measure_reference;
            case ADD_REFERENCE:
                return R.string.change_add_reference;
            case ADD_REFERENCES:
                return R.string.change_add_references;
            case RAISE_REFERENCE:
                return R.string.change_raise_reference;
            case TILT_REFERENCE:
                return R.string.change_tilt_reference;
            case LARGER_OBJECT_MARKERS:
                return R.string.change_larger_object_markers;
            case LARGER_REFERENCE_MARKERS:
                return R.string.change_larger_reference_markers;
            case CAMERA_CLOSER:
                return R.string.change_camera_closer;
            case CAMERA_ASLANT:
                return R.string.change_camera_aslant;
            case LONGER_LENS:
                return R.string.change_longer_lens;
            case MORE_PIXELS:
                return R.string.change_more_pixels;
            case ADD_PLATE:
                return R.string.change_add_plate;
            case MEASURE_DISTANCE:
                return R.string.change_measure_distance;
            case MORE_PHOTOS:
                return R.string.change_more_photos;
            case CALIBRATE:
                return R.string.change_calibrate;
            default:
                return WarningStrings.NONE;
        }
    }
}
