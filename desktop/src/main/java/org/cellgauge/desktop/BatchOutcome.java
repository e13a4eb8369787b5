package org.cellgauge.desktop;

import java.util.Map;

/**
 * What became of a batch.
 *
 * @param count how many inputs it had
 * @param byWord how many of them ended with which word ({@link InputOutcome#word()}), in the order of the first of each
 * @param reported whether {@code report.html} and {@code summary.csv} were written
 */
public record BatchOutcome(int count, Map<String, Integer> byWord, boolean reported) {
    /**
     * The whole in a line.
     *
     * @return such as {@code 3 photos: 2 pass, 1 refused}
     */
    public String total() {
        return BatchCheck.total(count, byWord);
    }
}
