package org.cellgauge.settings;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.cellgauge.internal.warning.Listing;
import org.cellgauge.warning.Refusal;
import org.cellgauge.warning.RefusalKind;
import org.jspecify.annotations.Nullable;

/**
 * How values of one type are written and read back; immutable.
 *
 * @param <T> the values' type
 */
public final class SettingForm<T> {
    private final String placeholder;
    private final List<String> words;
    private final Function<String, T> reader;
    private final Function<T, @Nullable Object> plain;
    private final @Nullable Function<T, String> text;
    private final @Nullable T open;

    private SettingForm(String placeholder, List<String> words, Function<String, T> reader,
            Function<T, @Nullable Object> plain, @Nullable T open) {
        this(placeholder, words, reader, plain, null, open);
    }

    private SettingForm(String placeholder, List<String> words, Function<String, T> reader,
            Function<T, @Nullable Object> plain, @Nullable Function<T, String> text, @Nullable T open) {
        this.placeholder = placeholder;
        this.words = words;
        this.reader = reader;
        this.plain = plain;
        this.text = text;
        this.open = open;
    }

    /**
     * A form of its own.
     *
     * @param placeholder what stands for a value where none is given, for instance {@code MM,DEG}
     * @param reader value of a text, or {@link UnreadableException}
     * @param plain value as files hold it: a String, a Number, a Boolean, or null for none
     * @param text what {@code reader} makes the same value of; empty where nothing is to be written
     * @param <T> the values' type
     * @return the form
     */
    public static <T> SettingForm<T> of(String placeholder, Function<String, T> reader,
            Function<T, @Nullable Object> plain, Function<T, String> text) {
        return new SettingForm<>(placeholder, List.of(), reader, plain, text, null);
    }

    /**
     * Something to ask for by its name alone.
     *
     * @return a form without a placeholder, whose texts are {@code true} and {@code false}
     */
    public static SettingForm<Boolean> flag() {
        SettingForm<Boolean> form = yesOrNo();
        return new SettingForm<>("", form.words, form.reader, form.plain, null);
    }

    /**
     * Whether it is asked for by its name alone.
     *
     * @return true for {@link #flag}
     */
    public boolean isFlag() {
        return placeholder.isEmpty();
    }

    /**
     * One of the constants of an enum, by its word.
     *
     * @param values the constants
     * @param <E> the enum
     * @return the form
     */
    public static <E extends Enum<E> & Word> SettingForm<E> choice(E[] values) {
        List<E> all = Arrays.asList(values.clone());
        List<String> words = all.stream().map(Word::word).collect(Collectors.toList());
        return new SettingForm<>(String.join("|", words), words, text -> {
            int at = words.indexOf(text);
            if (at < 0) {
                throw notKnown(text, words);
            }
            return all.get(at);
        }, Word::word, null);
    }

    /** Yes or no. */
    static SettingForm<Boolean> yesOrNo() {
        List<String> words = List.of("true", "false");
        return new SettingForm<>("true|false", words, text -> {
            if (!words.contains(text)) {
                throw notKnown(text, words);
            }
            return Boolean.valueOf(text);
        }, value -> value, null);
    }

    /**
     * A whole number of 32 bits.
     *
     * @param placeholder what stands for a value where none is given
     * @return the form
     */
    public static SettingForm<Integer> whole(String placeholder) {
        return new SettingForm<>(placeholder, List.of(), SettingForm::readInt, value -> value, null);
    }

    /**
     * A whole number of 32 bits, or none.
     *
     * @param placeholder what stands for a value where none is given
     * @return the form
     */
    public static SettingForm<OptionalInt> wholeOrOpen(String placeholder) {
        return new SettingForm<>(placeholder, List.of(), text -> OptionalInt.of(readInt(text)),
                value -> value.isPresent() ? value.getAsInt() : null, OptionalInt.empty());
    }

    /** A whole number of 64 bits. */
    static SettingForm<Long> longWhole(String placeholder) {
        return new SettingForm<>(placeholder, List.of(), text -> {
            try {
                return Long.valueOf(text.trim());
            } catch (NumberFormatException e) {
                throw notWhole(text);
            }
        }, value -> value, null);
    }

    /**
     * A number.
     *
     * @param placeholder what stands for a value where none is given
     * @return the form
     */
    public static SettingForm<Double> number(String placeholder) {
        return new SettingForm<>(placeholder, List.of(), SettingForm::readDouble, value -> value, null);
    }

    /**
     * A number, or none.
     *
     * @param placeholder what stands for a value where none is given
     * @return the form
     */
    public static SettingForm<OptionalDouble> numberOrOpen(String placeholder) {
        return new SettingForm<>(placeholder, List.of(), text -> OptionalDouble.of(readDouble(text)),
                value -> value.isPresent() ? value.getAsDouble() : null, OptionalDouble.empty());
    }

    /** A number, or a word for +infinity. */
    static SettingForm<Double> numberOr(String placeholder, String infinity) {
        return new SettingForm<>(placeholder + "|" + infinity, List.of(infinity),
                text -> text.equals(infinity) ? Double.POSITIVE_INFINITY : readDouble(text),
                value -> Double.isInfinite(value) ? null : value, Double.POSITIVE_INFINITY);
    }

    private static int readInt(String text) {
        try {
            return Integer.parseInt(text.trim());
        } catch (NumberFormatException e) {
            throw notWhole(text);
        }
    }

    private static UnreadableException notWhole(String text) {
        return new UnreadableException(SettingRefusal.NOT_WHOLE, text);
    }

    private static UnreadableException notKnown(String text, List<String> words) {
        return new UnreadableException(SettingRefusal.NOT_KNOWN, text, Listing.or(words));
    }

    private static double readDouble(String text) {
        try {
            double value = Double.parseDouble(text.trim());
            if (Double.isFinite(value)) {
                return value;
            }
        } catch (NumberFormatException e) {
            // said below, as for what is not finite
        }
        throw new UnreadableException(SettingRefusal.NOT_A_NUMBER, text);
    }

    /**
     * What stands for a value where none is given.
     *
     * @return the words to choose from with bars between, or for instance {@code N}
     */
    public String placeholder() {
        return placeholder;
    }

    /** A text that is no value of a form. */
    public static final class UnreadableException extends RuntimeException {
        private static final long serialVersionUID = 1L;

        private final transient Refusal refusal;

        /**
         * A text that is no value.
         *
         * @param kind why: a sentence without its subject, which is the setting
         * @param arguments what stands in the places of its pattern
         */
        public UnreadableException(RefusalKind kind, Object... arguments) {
            this.refusal = Refusal.of(kind, arguments);
        }

        Refusal refusal() {
            return refusal;
        }

        @Override
        public String getMessage() {
            return refusal.toString();
        }
    }

    /** Value of a text; its refusal names the text alone, not the setting. */
    T read(String text) {
        return reader.apply(text);
    }

    /** Value as files hold it: a String, a Number, a Boolean, or null for what {@link #open} stands for. */
    @Nullable Object plain(T value) {
        return plain.apply(value);
    }

    /** What a file's null means; null where it means nothing. */
    @Nullable T open() {
        return open;
    }

    /** Text that {@link #read} makes the same value of; empty where nothing is to be written. */
    String text(T value) {
        if (text != null) {
            return text.apply(value);
        }
        Object written = plain(value);
        if (written == null) {
            return words.isEmpty() ? "" : words.get(words.size() - 1);
        }
        // every digit it takes, never with an exponent
        return written instanceof Double && Double.isFinite((Double) written)
                ? BigDecimal.valueOf((Double) written).stripTrailingZeros().toPlainString() : written.toString();
    }
}
