package org.cellgauge.warning;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.function.Function;
import org.cellgauge.internal.warning.Listing;
import org.jspecify.annotations.Nullable;

/**
 * Why an input cannot be used and what to do about it, with the place where it is seen, or a part of such a sentence;
 * immutable. Refusals are equal where place, kind and arguments are.
 *
 * <p>Texts among the arguments mostly come from files; control characters in them, which could command a terminal, are
 * kept as spaces.
 */
public final class Refusal extends Message {
    private final @Nullable Place place;

    private Refusal(@Nullable Place place, RefusalKind kind, List<?> arguments) {
        super(kind, arguments);
        this.place = place;
    }

    /**
     * A refusal that names no place, or a part of one.
     *
     * @param kind why
     * @param arguments what stands in the places of the kind's pattern, each of a type that {@link Message} names
     * @return the refusal
     * @throws IllegalArgumentException if an argument is of another type, or their number does not fit the pattern
     */
    public static Refusal of(RefusalKind kind, Object... arguments) {
        return new Refusal(null, kind, printable(Arrays.asList(arguments)));
    }

    /**
     * A refusal.
     *
     * @param place where the fault is seen
     * @param kind why
     * @param arguments what stands in the places of the kind's pattern, each of a type that {@link Message} names
     * @return the refusal
     * @throws IllegalArgumentException if an argument is of another type, or their number does not fit the pattern
     */
    public static Refusal at(Place place, RefusalKind kind, Object... arguments) {
        return new Refusal(place, kind, printable(Arrays.asList(arguments)));
    }

    private static List<Object> printable(List<?> arguments) {
        List<Object> clean = new ArrayList<>();
        for (Object argument : arguments) {
            if (argument instanceof Listing) {
                clean.add(((Listing) argument).withItems(printable(((Listing) argument).items())));
            } else {
                clean.add(argument instanceof String ? printable((String) argument) : argument);
            }
        }
        return clean;
    }

    static String printable(String text) {
        return text.replaceAll("\\p{Cntrl}", " ");
    }

    @Override
    public RefusalKind kind() {
        return (RefusalKind) super.kind();
    }

    /**
     * Where the fault is seen.
     *
     * @return null where no place is named
     */
    public @Nullable Place place() {
        return place;
    }

    /**
     * The same, seen at a place.
     *
     * @param where the place
     * @return a refusal in place of this one
     */
    public Refusal withPlace(Place where) {
        return new Refusal(where, kind(), arguments());
    }

    @Override
    public String english(Function<MessageKind, String> patterns) {
        String sentence = super.english(patterns);
        return place == null ? sentence : place + ": " + sentence;
    }

    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof Refusal && super.equals(other) && Objects.equals(place, ((Refusal) other).place);
    }

    @Override
    public int hashCode() {
        return 31 * super.hashCode() + Objects.hashCode(place);
    }
}
