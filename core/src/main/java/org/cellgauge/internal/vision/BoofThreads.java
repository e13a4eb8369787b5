package org.cellgauge.internal.vision;

import boofcv.concurrency.BoofConcurrency;

/**
 * How BoofCV uses threads: a setting of the whole process, so it belongs to the program and not to a detector.
 *
 * <p>BoofCV keeps it in a static field that every one of its operations reads, from any thread. A library that changed
 * it when a class is loaded or per call would change it under others' hands; so nothing here does. A program calls
 * {@link #useOne()} first thing, before it makes a detector. Results are the same either way.
 */
public final class BoofThreads {
    private BoofThreads() {
    }

    /**
     * Keeps BoofCV on the calling thread: batches run one detector per thread instead, short commands start no pool,
     * and Android before API level 24 lacks the classes that BoofCV's pool needs.
     */
    public static void useOne() {
        BoofConcurrency.USE_CONCURRENT = false;
    }
}
