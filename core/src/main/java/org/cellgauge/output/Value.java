package org.cellgauge.output;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/** A part of a result: two are equal where a file would hold the same of them. */
abstract class Value {
    /** All that a file holds of it; numbers that are not finite as NaN. */
    abstract @Nullable Object[] figures();

    @Override
    // a part of one kind is none of another, whatever they hold
    public final boolean equals(@Nullable Object other) {
        return other != null && getClass() == other.getClass()
                && Arrays.deepEquals(figures(), ((Value) other).figures());
    }

    @Override
    public final int hashCode() {
        return Arrays.deepHashCode(figures());
    }
}
