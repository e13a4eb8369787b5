package org.cellgauge.warning;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Function;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.internal.warning.Printable;
import org.jspecify.annotations.Nullable;

/**
 * What is said to people, or a part of such a sentence, as data of which any language can make words: a kind and its
 * arguments; immutable.
 *
 * <p>An argument is one of
 * <ul>
 * <li>{@link Integer}: a marker id, a line, a pixel or a count, written without grouping;
 * <li>{@link Decimal}: a number that is written with so many decimals;
 * <li>{@link String}: what is the same in every language, such as the name of a file, an axis or a parameter, or what
 * stands or could stand in a file; empty where an optional part is left out;
 * <li>{@link Listing}: several arguments in a row;
 * <li>{@link Message}: a part of the sentence; a {@link MessageKind} without places stands for the part it makes.
 * </ul>
 *
 * <p>Texts mostly come from files. Control characters in them, which could command a terminal, are kept as spaces, and
 * a message stays as long as people read: long texts are cut, and long rows end with the number of what is left out.
 */
public abstract class Message {
    private final MessageKind kind;
    private final List<Object> arguments;

    Message(MessageKind kind, List<?> arguments) {
        int places = places(kind.english());
        if (places != arguments.size()) {
            throw new IllegalArgumentException(kind + " has " + places + " places, not " + arguments.size());
        }
        List<Object> checked = new ArrayList<>();
        for (Object argument : arguments) {
            checked.add(checked(argument));
        }
        this.kind = kind;
        this.arguments = Collections.unmodifiableList(checked);
    }

    private static int places(String pattern) {
        int places = 0;
        for (int i = pattern.indexOf('%'); i >= 0; i = pattern.indexOf('%', i + 2)) {
            if (!pattern.startsWith("%s", i) && !pattern.startsWith("%%", i)) {
                throw new IllegalArgumentException("no pattern of a message: " + pattern);
            }
            places += pattern.startsWith("%s", i) ? 1 : 0;
        }
        return places;
    }

    /**
     * An argument as it is kept.
     *
     * @param argument what stands in a place of a pattern
     * @return a message for a kind that stands alone; what is kept as it is
     * @throws IllegalArgumentException if it is of a type that no language makes words of
     */
    public static Object checked(Object argument) {
        if (argument instanceof WarningKind) {
            return Warning.of((WarningKind) argument);
        }
        if (argument instanceof RefusalKind) {
            return Refusal.of((RefusalKind) argument);
        }
        if (argument instanceof String) {
            return Printable.shortened((String) argument);
        }
        if (argument instanceof Integer || argument instanceof Decimal || argument instanceof Listing
                || argument instanceof Message) {
            return argument;
        }
        throw new IllegalArgumentException("no argument of a message: " + argument);
    }

    /**
     * What it says.
     *
     * @return the kind
     */
    public MessageKind kind() {
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

    /**
     * The message in English, parts of it in other words than the kinds': those of a program that can say more
     * precisely what to do.
     *
     * @param patterns the pattern of a kind, with as many places as {@link MessageKind#english()}
     * @return a sentence without a full stop, or a part of one
     */
    public String english(Function<MessageKind, String> patterns) {
        Object[] words = new Object[arguments.size()];
        for (int i = 0; i < words.length; i++) {
            words[i] = english(arguments.get(i), patterns);
        }
        return String.format(Decimal.POINT, patterns.apply(kind), words);
    }

    /**
     * An argument in words.
     *
     * @param argument one of {@link #arguments()}
     * @param patterns the pattern of a kind, with as many places as {@link MessageKind#english()}
     * @return in English
     */
    public static String english(Object argument, Function<MessageKind, String> patterns) {
        if (argument instanceof Message) {
            return ((Message) argument).english(patterns);
        }
        return argument instanceof Listing ? ((Listing) argument).english(patterns) : argument.toString();
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return other != null && getClass() == other.getClass() && kind.equals(((Message) other).kind)
                && arguments.equals(((Message) other).arguments);
    }

    @Override
    public int hashCode() {
        return 31 * kind.hashCode() + arguments.hashCode();
    }

    /**
     * The message in English.
     *
     * @return a sentence without a full stop, or a part of one
     */
    @Override
    public String toString() {
        return english(MessageKind::english);
    }
}
