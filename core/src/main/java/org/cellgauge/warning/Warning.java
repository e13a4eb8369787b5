package org.cellgauge.warning;

import java.util.Arrays;

/**
 * What the user should know besides the figures, or a part of such a sentence; immutable. Warnings are equal where kind
 * and arguments are.
 */
public final class Warning extends Message {
    private Warning(WarningKind kind, Object[] arguments) {
        super(kind, Arrays.asList(arguments));
    }

    /**
     * A warning.
     *
     * @param kind what it says
     * @param arguments what stands in the places of the kind's pattern, each of a type that {@link Message} names
     * @return the warning
     * @throws IllegalArgumentException if an argument is of another type, or their number does not fit the pattern
     */
    public static Warning of(WarningKind kind, Object... arguments) {
        return new Warning(kind, arguments);
    }

    @Override
    public WarningKind kind() {
        return (WarningKind) super.kind();
    }
}
