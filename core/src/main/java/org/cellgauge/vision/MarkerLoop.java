package org.cellgauge.vision;

import java.util.function.IntConsumer;
import java.util.stream.IntStream;

/**
 * Does the same to each of the markers of a photo, one after another or several at once. Their fits share the photo and
 * its light, which stand still meanwhile, and nothing else, so results are the same either way.
 */
final class MarkerLoop {
    private boolean parallel;

    /** From now on several at once, on the threads of the Java machine's common pool beside the calling one. */
    void spread() {
        parallel = true;
    }

    /**
     * Does the work for each.
     *
     * @param count how many markers
     * @param work to be done with the number of each, from 0; what it throws is thrown
     */
    void each(int count, IntConsumer work) {
        if (parallel && count > 1) {
            IntStream.range(0, count).parallel().forEach(work);
            return;
        }
        for (int i = 0; i < count; i++) {
            work.accept(i);
        }
    }
}
