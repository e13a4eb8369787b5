package org.cellgauge.output;

import org.jspecify.annotations.Nullable;

/** A warning of a result; immutable. */
public final class WarningView extends Value {
    private final String code;
    private final String text;

    WarningView(String code, String text) {
        this.code = code;
        this.text = text;
    }

    /**
     * What programs know it by.
     *
     * @return as {@link org.cellgauge.warning.MessageKind#code()}
     */
    public String code() {
        return code;
    }

    /**
     * What it says.
     *
     * @return a sentence in English without a full stop
     */
    public String text() {
        return text;
    }

    @Override
    @Nullable Object[] figures() {
        return new @Nullable Object[] {code, text};
    }
}
