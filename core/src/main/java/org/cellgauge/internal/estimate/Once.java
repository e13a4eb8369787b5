package org.cellgauge.internal.estimate;

import java.util.Objects;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * A value that is worked out when it is first asked for, once, and kept from then on; safe for any threads.
 *
 * @param <T> of the value, which must not be null
 */
public final class Once<T> implements Supplier<T> {
    /** Given up with the value, and with it all that it holds. */
    private @Nullable Supplier<T> source;
    private @Nullable T value;

    /**
     * A value.
     *
     * @param source what works it out
     */
    public Once(Supplier<T> source) {
        this.source = source;
    }

    @Override
    public synchronized T get() {
        T known = value;
        if (known == null) {
            known = Objects.requireNonNull(source, "a source gives a value").get();
            value = known;
            source = null;
        }
        return known;
    }
}
