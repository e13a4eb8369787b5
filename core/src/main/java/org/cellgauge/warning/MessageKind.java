package org.cellgauge.warning;

import java.util.Locale;

/** What a message, or a part of one, says; constants of an enum, so that a translation can be complete. */
public interface MessageKind {
    /**
     * What programs know the message by. It stays the same in later versions, whatever becomes of the sentence.
     *
     * @return words in lower case with hyphens, such as {@code references-not-seen}
     */
    default String code() {
        return ((Enum<?>) this).name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /**
     * The sentence in English.
     *
     * @return a pattern of {@link String#format}, with one {@code %s} for each argument, in order
     */
    String english();
}
