package org.cellgauge.cell;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Locale;
import org.cellgauge.internal.cell.CellPhrase;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.warning.Refusal;

/** Finds what a mistyped word was meant to be. */
final class Suggestions {
    private Suggestions() {
    }

    /**
     * The remedy for an unknown word.
     *
     * @param word what stands in the file
     * @param known what could stand there
     * @return {@link CellPhrase#DID_YOU_MEAN} where one is near, else {@link CellPhrase#KNOWN_HERE}
     */
    static Refusal remedy(String word, Collection<String> known) {
        String best = null;
        int bestDistance = Integer.MAX_VALUE;
        String given = normalise(word);
        for (String k : known) {
            // "grip" for "grip_mm": a forgotten unit is one fault, however many letters it has
            int d = normalise(k).startsWith(given + "_") ? 1 : distance(given, normalise(k));
            if (d < bestDistance) {
                bestDistance = d;
                best = k;
            }
        }
        // a third of the letters may differ: beyond that a suggestion misleads more often than it helps
        if (best != null && bestDistance <= Math.max(1, Math.max(given.length(), best.length()) / 3)) {
            return Refusal.of(CellPhrase.DID_YOU_MEAN, best);
        }
        return Refusal.of(CellPhrase.KNOWN_HERE, Listing.comma(new ArrayList<>(known)));
    }

    private static String normalise(String word) {
        return word.toLowerCase(Locale.ROOT).replace('-', '_').replace(' ', '_');
    }

    /** Edit distance (insertions, deletions, replacements) of V. I. Levenshtein, 1966, by dynamic programming. */
    static int distance(String a, String b) {
        int[] previous = new int[b.length() + 1];
        int[] current = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            previous[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            current[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int replaced = previous[j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                current[j] = Math.min(replaced, 1 + Math.min(previous[j], current[j - 1]));
            }
            int[] swap = previous;
            previous = current;
            current = swap;
        }
        return previous[b.length()];
    }
}
