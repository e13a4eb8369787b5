package org.cellgauge.warning;

/** What a message, or a part of one, says; constants of an enum, so that a translation can be complete. */
public interface MessageKind {
    /**
     * The sentence in English.
     *
     * @return a pattern of {@link String#format}, with one {@code %s} for each argument, in order
     */
    String english();
}
