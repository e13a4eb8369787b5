package org.cellgauge.android.state;

import org.cellgauge.warning.Refusal;

/** Why something that the user asked for was not done; immutable. */
public final class Problem {
    /** What kind of thing went wrong. */
    public enum Kind {
        /** The cell file, or a calibration file chosen with it, was refused: {@link Problem#refusal()}. */
        CELL_REFUSED,
        /** The cell file of the last time cannot be read again: {@link Problem#refusal()}. */
        LAST_CELL,
        /** The calibration file of the last time cannot be read again, but the cell: {@link Problem#refusal()}. */
        LAST_CALIBRATION,
        /** The photo cannot be read or checked: {@link Problem#refusal()}. */
        PHOTO_REFUSED,
        /** The photo is of another size than the camera's calibration: {@link Problem#refusal()}. */
        PHOTO_SIZE,
        /** The cell has no camera of its own and the device's is not known yet, so no photo can be checked. */
        PHOTO_WITHOUT_CAMERA,
        /** There is no room for the result: {@link Problem#refusal()}. */
        STORAGE_FULL,
        /** The result could not be written: {@link Problem#refusal()} or {@link Problem#message()}. */
        NOT_SAVED,
        /** The memory of the device does not suffice for the check. */
        MEMORY,
        /** A fault of the program: {@link Problem#message()}. */
        INTERNAL
    }

    private final Kind kind;
    private final Refusal refusal;
    private final String message;

    /**
     * An input that cannot be used, or a result that is not kept.
     *
     * @param kind what kind of thing
     * @param refusal what, where and what to do
     */
    public Problem(Kind kind, Refusal refusal) {
        this.kind = kind;
        this.refusal = refusal;
        this.message = "";
    }

    /**
     * A problem.
     *
     * @param kind what kind of thing
     * @param message what the system or the program says of it; may be empty
     */
    public Problem(Kind kind, String message) {
        this.kind = kind;
        this.refusal = null;
        this.message = message == null ? "" : message;
    }

    /**
     * What kind of thing went wrong.
     *
     * @return the kind
     */
    public Kind kind() {
        return kind;
    }

    /**
     * What, where and what to do.
     *
     * @return null where only the system or the program knows
     */
    public Refusal refusal() {
        return refusal;
    }

    /**
     * What the system or the program says of it.
     *
     * @return in the words it has, mostly English; empty where the kind or the refusal says all
     */
    public String message() {
        return message;
    }
}
