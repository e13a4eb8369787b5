package org.cellgauge.warning;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;

/**
 * What the user should know besides the figures, or a part of such a sentence: a kind and its arguments; immutable.
 * Warnings are equal where kind and arguments are.
 *
 * <p>An argument is one of
 * <ul>
 * <li>{@link Integer}: a marker id, a pixel or a count, written without grouping;
 * <li>{@link Decimal}: a number that is written with so many decimals;
 * <li>{@link String}: a name that is the same in every language, such as that of an axis, a parameter or an option;
 * empty where an optional part is left out;
 * <li>{@link Listing}: several arguments in a row;
 * <li>{@link Warning}: a part of the sentence.
 * </ul>
 */
public final class Warning {
    private final WarningKind kind;
    private final List<Object> arguments;

    private Warning(WarningKind kind, Object[] arguments) {
        this.kind = kind;
        this.arguments = Collections.unmodifiableList(new ArrayList<>(Arrays.asList(arguments)));
    }

    /**
     * A warning.
     *
     * @param kind what it says
     * @param arguments what stands in the places of the kind's pattern, each of a type named above
     * @return the warning
     * @throws IllegalArgumentException if an argument is of another type, or their number does not fit the pattern
     */
    public static Warning of(WarningKind kind, Object... arguments) {
        int places = places(kind.english());
        if (places != arguments.length) {
            throw new IllegalArgumentException(kind + " has " + places + " places, not " + arguments.length);
        }
        for (Object argument : arguments) {
            checkType(argument);
        }
        return new Warning(kind, arguments);
    }

    private static int places(String pattern) {
        int places = 0;
        for (int i = pattern.indexOf('%'); i >= 0; i = pattern.indexOf('%', i + 2)) {
            places += pattern.startsWith("%s", i) ? 1 : 0;
        }
        return places;
    }

    static void checkType(Object argument) {
        if (!(argument instanceof Integer || argument instanceof Decimal || argument instanceof String
                || argument instanceof Listing || argument instanceof Warning)) {
            throw new IllegalArgumentException("no argument of a warning: " + argument);
        }
    }

    /**
     * What it says.
     *
     * @return the kind
     */
    public WarningKind kind() {
        return kind;
    }

    /**
     * What stands in the places of the kind's pattern.
     *
     * @return unmodifiable, each of a type named above
     */
    public List<Object> arguments() {
        return arguments;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Warning && kind.equals(((Warning) other).kind)
                && arguments.equals(((Warning) other).arguments);
    }

    @Override
    public int hashCode() {
        return 31 * kind.hashCode() + arguments.hashCode();
    }

    /**
     * The warning in English.
     *
     * @return a sentence without a full stop, or a part of one
     */
    @Override
    public String toString() {
        return String.format(Locale.ROOT, kind.english(), arguments.toArray());
    }
}
