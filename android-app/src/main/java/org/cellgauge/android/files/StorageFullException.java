package org.cellgauge.android.files;

import java.io.IOException;

/** There is no room for a result; nothing of it was written. */
public final class StorageFullException extends IOException {
    private static final long serialVersionUID = 1;

    /**
     * No room.
     *
     * @param message what was to be written and how much was missing
     */
    public StorageFullException(String message) {
        super(message);
    }
}
