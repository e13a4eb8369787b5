package org.cellgauge.cell;

/**
 * An input cannot be used: the message names the file, the place in it and the remedy, in words for the user.
 *
 * <p>It is the one exception by which every package refuses files, images and detections; a program that meets it shows
 * its message and nothing else.
 */
public final class InputRefusedException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /**
     * A refusal.
     *
     * @param message one sentence or two: file, place, what is wrong, remedy
     */
    public InputRefusedException(String message) {
        super(message);
    }

    /**
     * A refusal with the error that led to it.
     *
     * @param message one sentence or two: file, place, what is wrong, remedy
     * @param cause the error behind it
     */
    public InputRefusedException(String message, Throwable cause) {
        super(message, cause);
    }
}
