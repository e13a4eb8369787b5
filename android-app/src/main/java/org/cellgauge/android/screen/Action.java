package org.cellgauge.android.screen;

import org.cellgauge.android.R;

/** What a button of a message or a row does. */
enum Action {
    CHOOSE_CELL(R.string.choose_cell),
    CHOOSE_ANOTHER_CELL(R.string.choose_another_cell),
    TRY_EXAMPLE(R.string.try_example),
    KEEP_CELL(R.string.keep_cell),
    GO_ON_WITHOUT(R.string.go_on_without),
    CHOOSE_CALIBRATION(R.string.choose_calibration),
    OPEN_PHOTO(R.string.open_photo),
    OPEN_ANOTHER_PHOTO(R.string.open_another_photo),
    BACK_TO_CAMERA(R.string.back_to_camera),
    ALLOW_CAMERA(R.string.allow_camera),
    OPEN_SETTINGS(R.string.open_settings),
    TRY_AGAIN(R.string.try_again),
    SAVE_AGAIN(R.string.save_again),
    GUIDE(R.string.guide_open),
    LICENCES(R.string.licences);

    private final int label;

    Action(int label) {
        this.label = label;
    }

    /** The button's word. */
    int label() {
        return label;
    }
}
