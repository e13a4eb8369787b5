package org.cellgauge.android.files;

import java.io.IOException;
import org.cellgauge.warning.Refusal;

/** A result is not kept, for a reason that the app can say in the user's language; nothing of it was written. */
public class NotSavedException extends IOException {
    private static final long serialVersionUID = 1;

    private final transient Refusal refusal;

    /**
     * A result that is not kept.
     *
     * @param refusal why, and what to do
     * @param cause the error behind it, or null
     */
    public NotSavedException(Refusal refusal, Throwable cause) {
        super(refusal.toString(), cause);
        this.refusal = refusal;
    }

    /**
     * Why, and what to do.
     *
     * @return without a place
     */
    public Refusal refusal() {
        return refusal;
    }
}
