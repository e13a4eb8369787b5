package org.cellgauge.android.screen;

/** Numbers as people type them. */
final class Decimals {
    private Decimals() {
    }

    /**
     * Reads a number with a point or a comma before its decimals; keyboards do not always have the language's own.
     *
     * @param text what was typed; groups of thousands are not expected
     * @return the number, or NaN where it is none
     */
    static double parse(String text) {
        String plain = text.trim().replace(',', '.');
        if (!plain.matches("\\d*\\.?\\d*") || !plain.matches(".*\\d.*")) {
            return Double.NaN;
        }
        return Double.parseDouble(plain);
    }
}
