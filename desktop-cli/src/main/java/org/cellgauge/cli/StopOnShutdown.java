package org.cellgauge.cli;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.cellgauge.desktop.StopSignal;

/**
 * Stops a batch where the process is told to end, by Ctrl-C, SIGTERM or SIGHUP, and has Java wait until what is done is
 * written; it then ends with 128 and the signal's number, as shells expect.
 */
final class StopOnShutdown implements AutoCloseable {
    /** The longest wait, s: a photo cannot be given up in the midst of everything. */
    private static final int MOST_S = 60;

    private final CountDownLatch ended = new CountDownLatch(1);
    private final Thread hook;

    /**
     * Begins to listen.
     *
     * @param stop is given on the way down
     */
    StopOnShutdown(StopSignal stop) {
        hook = new Thread(() -> {
            stop.stop();
            try {
                ended.await(MOST_S, TimeUnit.SECONDS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }, "cellgauge-stop");
        Runtime.getRuntime().addShutdownHook(hook);
    }

    /** All is written: Java need not wait any longer. */
    @Override
    public void close() {
        ended.countDown();
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException e) {
            // it is on the way down
        }
    }
}
