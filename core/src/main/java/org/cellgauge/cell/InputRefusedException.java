package org.cellgauge.cell;

/**
 * An input cannot be used: the message names the file, the place in it and the remedy, in words for the user.
 *
 * <p>It is the one exception by which every package refuses files, images and detections; a program that meets it shows
 * its message and nothing else. Control characters that the message repeats from a file are shown as spaces.
 */
public final class InputRefusedException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /**
     * A refusal.
     *
     * @param message one sentence or two: file, place, what is wrong, remedy
     */
    public InputRefusedException(String message) {
        super(printable(message));
    }

    /**
     * A refusal with the error that led to it.
     *
     * @param message one sentence or two: file, place, what is wrong, remedy
     * @param cause the error behind it
     */
    public InputRefusedException(String message, Throwable cause) {
        super(printable(message), cause);
    }

    /** Messages repeat what stands in files; a control character there must not reach a terminal. */
    private static String printable(String message) {
        return message.replaceAll("\\p{Cntrl}", " ");
    }
}
