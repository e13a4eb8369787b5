package org.cellgauge.cell;

import org.jspecify.annotations.Nullable;

/** What a cell file says of the camera; immutable. */
public final class StatedCamera {
    /** How a cell file states the camera. */
    public enum Kind {
        /** Its keys stand in the cell file. */
        INLINE,
        /** The cell file names a camera file. */
        FILE,
        /** Not at all. */
        NONE
    }

    private final Kind kind;
    private final @Nullable String fileName;
    private final @Nullable String cameraName;

    StatedCamera(Kind kind, @Nullable String fileName, @Nullable String cameraName) {
        this.kind = kind;
        this.fileName = fileName;
        this.cameraName = cameraName;
    }

    /**
     * How the camera is stated.
     *
     * @return the kind
     */
    public Kind kind() {
        return kind;
    }

    /**
     * The name after {@code camera:}.
     *
     * @return relative to the cell file; null unless a file is named
     */
    public @Nullable String fileName() {
        return fileName;
    }

    /**
     * Which of several cameras in that file.
     *
     * @return its name there; null where none is named
     */
    public @Nullable String cameraName() {
        return cameraName;
    }
}
