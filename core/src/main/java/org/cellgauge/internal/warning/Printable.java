package org.cellgauge.internal.warning;

import java.util.regex.Pattern;

/**
 * Texts of files and names of files as they may be shown: without characters that command a terminal, break a line or
 * turn the direction of writing, which could make a message say what nobody meant.
 */
public final class Printable {
    /** Longest text of a file that a message repeats, in characters. */
    public static final int MAX_LENGTH = 500;

    private static final String CUT = "...";
    // control characters of C0 and C1, separators of lines and paragraphs, marks and overrides of direction (Unicode
    // Standard Annex 9, 2.1 to 2.6), halves of pairs
    private static final Pattern UNSAFE = Pattern.compile(
            "[\\p{Cc}\\u2028\\u2029\\u061C\\u200E\\u200F\\u202A-\\u202E\\u2066-\\u2069]|\\p{Cs}");

    private Printable() {
    }

    /**
     * A text with spaces in place of what must not be shown.
     *
     * @param text any text
     * @return as many characters, each safe
     */
    public static String of(String text) {
        return UNSAFE.matcher(text).replaceAll(" ");
    }

    /**
     * The same, cut where it is longer than {@value #MAX_LENGTH} characters.
     *
     * @param text any text
     * @return its beginning, ended by three dots where something was left out
     */
    public static String shortened(String text) {
        if (text.length() <= MAX_LENGTH) {
            return of(text);
        }
        return of(text.substring(0, MAX_LENGTH - CUT.length())) + CUT;
    }
}
