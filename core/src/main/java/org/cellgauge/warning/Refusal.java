package org.cellgauge.warning;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/**
 * Why an input cannot be used and what to do about it, with the place where it is seen, or a part of such a sentence;
 * immutable. Refusals are equal where place, kind and arguments are.
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
        return new Refusal(null, kind, Arrays.asList(arguments));
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
        return new Refusal(place, kind, Arrays.asList(arguments));
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
