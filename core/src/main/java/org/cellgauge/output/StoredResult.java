package org.cellgauge.output;

import org.jspecify.annotations.Nullable;

/** A result as a file keeps it: what it says, and what it is of; immutable. */
public final class StoredResult extends Value {
    private final ResultView view;
    private final ResultRecord record;

    /**
     * A result to be kept.
     *
     * @param view what it says; not preliminary
     * @param record what it is of
     */
    public StoredResult(ResultView view, ResultRecord record) {
        this.view = view;
        this.record = record;
    }

    /**
     * What it says.
     *
     * @return never null
     */
    public ResultView view() {
        return view;
    }

    /**
     * What it is of.
     *
     * @return never null
     */
    public ResultRecord record() {
        return record;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {view, record};
    }
}
