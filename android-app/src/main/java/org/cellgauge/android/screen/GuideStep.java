package org.cellgauge.android.screen;

import org.cellgauge.android.R;

/** One of the four things to do before the first check: its picture, its words, and what its button opens. */
enum GuideStep {
    PRINT(R.drawable.guide_print, R.string.guide_print_spoken, R.string.guide_print, R.string.guide_print_first,
            R.string.guide_print_second, R.string.guide_print_button, 0),
    MEASURE(R.drawable.guide_measure, R.string.guide_measure_spoken, R.string.guide_measure,
            R.string.guide_measure_first, R.string.guide_measure_second, R.string.guide_measure_button,
            R.string.guide_measure_how),
    WRITE(R.drawable.guide_write, R.string.guide_write_spoken, R.string.guide_write, R.string.guide_write_first,
            R.string.guide_write_second, R.string.guide_write_button, 0),
    CALIBRATE(R.drawable.guide_calibrate, R.string.guide_calibrate_spoken, R.string.guide_calibrate,
            R.string.guide_calibrate_first, R.string.guide_calibrate_second, R.string.guide_calibrate_button,
            R.string.guide_calibrate_how);

    private final int picture;
    private final int spoken;
    private final int title;
    private final int first;
    private final int second;
    private final int button;
    private final int howTo;

    GuideStep(int picture, int spoken, int title, int first, int second, int button, int howTo) {
        this.picture = picture;
        this.spoken = spoken;
        this.title = title;
        this.first = first;
        this.second = second;
        this.button = button;
        this.howTo = howTo;
    }

    int picture() {
        return picture;
    }

    /** What the picture shows, for who does not see it. */
    int spoken() {
        return spoken;
    }

    int title() {
        return title;
    }

    int first() {
        return first;
    }

    int second() {
        return second;
    }

    int button() {
        return button;
    }

    /** The text behind the button; 0 where it saves a file. */
    int howTo() {
        return howTo;
    }
}
