package org.cellgauge.desktop;

/** Is told how a batch goes on, in the thread that runs it and in the order of the inputs. */
public interface BatchListener {
    /**
     * An input is done, its files are written.
     *
     * @param outcome what became of it
     */
    void finished(InputOutcome outcome);

    /**
     * How long a stage of the work on an input took, whatever went on beside it.
     *
     * @param name such as {@code detection}
     * @param seconds of one thread
     */
    default void stage(String name, double seconds) {
    }
}
