package org.cellgauge.cli;

import java.util.Optional;
import org.cellgauge.desktop.CheckText;

/** Two numbers with a comma between, as options have them. */
record NumberPair(double first, double second) {
    /**
     * Reads a pair.
     *
     * @param text as typed
     * @return the pair; empty if the text is none of two finite numbers
     */
    static Optional<NumberPair> of(String text) {
        String[] parts = text.split(",", -1);
        try {
            if (parts.length == 2) {
                NumberPair pair = new NumberPair(Double.parseDouble(parts[0].trim()),
                        Double.parseDouble(parts[1].trim()));
                return Double.isFinite(pair.first + pair.second) ? Optional.of(pair) : Optional.empty();
            }
        } catch (NumberFormatException e) {
            // no pair
        }
        return Optional.empty();
    }

    @Override
    public String toString() {
        return CheckText.plain(first) + "," + CheckText.plain(second);
    }
}
