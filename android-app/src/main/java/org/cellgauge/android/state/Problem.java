package org.cellgauge.android.state;

/** Why something that the user asked for was not done; immutable. */
public final class Problem {
    /** What kind of thing went wrong. */
    public enum Kind {
        /** The cell file, or a calibration file chosen with it, was refused: {@link Problem#message()}. */
        CELL_REFUSED,
        /** The photo cannot be read or checked: {@link Problem#message()}. */
        PHOTO_REFUSED,
        /** The photo is of another size than the camera's calibration: {@link Problem#message()}. */
        PHOTO_SIZE,
        /** The cell has no camera of its own and the device's is not known yet, so no photo can be checked. */
        PHOTO_WITHOUT_CAMERA,
        /** There is no room for the result: {@link Problem#message()}. */
        STORAGE_FULL,
        /** The result could not be written: {@link Problem#message()}. */
        NOT_SAVED,
        /** A fault of the program: {@link Problem#message()}. */
        INTERNAL
    }

    private final Kind kind;
    private final String message;

    /**
     * A problem.
     *
     * @param kind what kind of thing
     * @param message what, where and what to do, in English as it comes from the library; may be empty
     */
    public Problem(Kind kind, String message) {
        this.kind = kind;
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
     * @return in English; empty where the kind says all
     */
    public String message() {
        return message;
    }
}
