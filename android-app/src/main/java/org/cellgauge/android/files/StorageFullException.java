package org.cellgauge.android.files;

import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.warning.Refusal;

/** There is no room for a result; nothing of it was written. */
public final class StorageFullException extends NotSavedException {
    private static final long serialVersionUID = 1;

    /**
     * No room.
     *
     * @param neededBytes what was to be written
     * @param freeBytes what there is room for
     */
    public StorageFullException(long neededBytes, long freeBytes) {
        super(Refusal.of(FileRefusal.STORAGE_FULL, Decimal.of(neededBytes / 1e6, 1), Decimal.of(freeBytes / 1e6, 1)),
                null);
    }
}
