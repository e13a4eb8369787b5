package org.cellgauge.desktop;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What became of a batch.
 *
 * @param count how many inputs it had
 * @param done how many of them were done: all, unless it was stopped or the folder took no more
 * @param kept of how many of these an earlier run had the result
 * @param byWord how many ended with which word ({@link InputOutcome#word()}), in the order of the first of each
 * @param reportFolder where {@code report.html} and {@code summary.csv} are: the folder for results or, where that took
 *     them no more, one for temporary files; empty where there are none
 * @param unwritable why the folder took no more results; empty where it took all
 */
public record BatchOutcome(int count, int done, int kept, Map<String, Integer> byWord, Optional<Path> reportFolder,
        Optional<ResultFolder.UnwritableException> unwritable) {
    /**
     * The whole in a line.
     *
     * @return such as {@code 3 photos: 2 pass, 1 refused}
     */
    public String total() {
        String photos = done < count ? done + " of " + count + " photos" : count == 1 ? "1 photo" : count + " photos";
        return photos + (byWord.isEmpty() ? "" : ": " + words(byWord)) + (kept == 0 ? ""
                : " (" + kept + " kept from an earlier run)");
    }

    /** Numbers by word in a row. */
    static String words(Map<String, Integer> byWord) {
        List<String> parts = new ArrayList<>();
        byWord.forEach((word, number) -> parts.add(number + " " + word));
        return String.join(", ", parts);
    }
}
