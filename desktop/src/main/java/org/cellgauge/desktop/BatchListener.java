package org.cellgauge.desktop;

/** Is told how a batch goes on, in the thread that runs it. */
public interface BatchListener {
    /**
     * An input is done, its files are written.
     *
     * @param outcome what became of it
     */
    void finished(InputOutcome outcome);

    /**
     * A stage of the work on an input is done.
     *
     * @param name such as {@code detection}
     */
    default void stage(String name) {
    }
}
