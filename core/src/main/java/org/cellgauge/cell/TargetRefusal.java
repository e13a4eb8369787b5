package org.cellgauge.cell;

import org.cellgauge.warning.RefusalKind;

/** Why a target file cannot be used, besides what holds of any file ({@link CellRefusal}). */
public enum TargetRefusal implements RefusalKind {
    /** No target or several: keys of which one must stand there. */
    NOT_ONE_TARGET("a target file states one target; keep one of the keys %s"),
    /** A cell file in place of a target file. */
    IS_CELL_FILE("this is a cell file; to calibrate on the references of a surveyed cell, name it in a target file: "
            + "cell: {file: NAME}"),
    /** The cell file of a target does not exist: its name. */
    NO_CELL_FILE("there is no file \"%s\"; write the cell file's path relative to this file"),
    /** Circles that touch: diameter and distance, mm. */
    CIRCLES_TOUCH("circles of %s mm at a distance of %s mm touch; write the distance of neighbouring centres"),
    /** Markers larger than their squares: sizes, mm. */
    MARKER_OVER_SQUARE("a marker of %s mm does not fit into a square of %s mm; write the outer edge of its black "
            + "border"),
    /** An id twice or one the family has not: the id, its largest. */
    NO_SUCH_ID("the family has no marker %s; its ids end at %s"),
    /** References that were not surveyed: id, deviation, mm. */
    NOT_SURVEYED("reference %s is placed to %s mm only, which no calibration can rest on; survey the cell, and state "
            + "placements of at most 1 mm"),
    /** BoofCV's target of another type: its type. */
    OTHER_TYPE("targets of the type %s are not read; use one of CHESSBOARD, ECOCHECK, CIRCLE_GRID and CIRCLE_HEX"),

    // ---- parts

    /** What a target file is. */
    TARGET_FILE("target file"),
    /** How one begins. */
    A_TARGET_FILE("a target file, such as cellgauge_target: 1 and chessboard: {rows: 7, columns: 5, square_mm: 30}"),
    /** Counts of a pattern. */
    COUNT("how many squares or circles there are, counted along the whole board"),
    /** A length. */
    LENGTH("the length in mm, measured over many squares and divided");

    private final String english;

    TargetRefusal(String english) {
        this.english = english;
    }

    @Override
    public String code() {
        return "target-" + RefusalKind.super.code();
    }

    @Override
    public String english() {
        return english;
    }
}
