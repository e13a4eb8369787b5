package org.cellgauge.cell;

import org.cellgauge.warning.Place;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.RefusalKind;
import org.jspecify.annotations.Nullable;

/**
 * An input cannot be used: the refusal names the file, the place in it and the remedy.
 *
 * <p>It is the one exception by which every package refuses files, images and detections; a program that meets it shows
 * its message, or the refusal in the user's language, and nothing else.
 */
public final class InputRefusedException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final transient Refusal refusal;

    /**
     * A refusal.
     *
     * @param refusal file, place, what is wrong, remedy
     */
    public InputRefusedException(Refusal refusal) {
        this(refusal, null);
    }

    /**
     * A refusal with the error that led to it.
     *
     * @param refusal file, place, what is wrong, remedy
     * @param cause the error behind it, or null
     */
    public InputRefusedException(Refusal refusal, @Nullable Throwable cause) {
        super(refusal.toString(), cause);
        this.refusal = refusal;
    }

    /**
     * A refusal of a file or photo as a whole.
     *
     * @param file its name as people know it
     * @param kind why
     * @param arguments what stands in the places of the kind's pattern
     */
    public InputRefusedException(String file, RefusalKind kind, Object... arguments) {
        this(Refusal.at(Place.of(file), kind, arguments));
    }

    /**
     * File, place, what is wrong and the remedy, as data; {@link #getMessage()} is the same in English.
     *
     * @return the refusal
     */
    public Refusal refusal() {
        return refusal;
    }
}
