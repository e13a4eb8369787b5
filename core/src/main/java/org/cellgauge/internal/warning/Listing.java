package org.cellgauge.internal.warning;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Function;
import org.cellgauge.warning.Message;
import org.cellgauge.warning.MessageKind;

/**
 * Several things in a row, as in "5, 20 and 30"; immutable. Of more than {@value #MAX_ITEMS} the last says how many
 * more there are.
 */
public final class Listing {
    /** Longest row. */
    public static final int MAX_ITEMS = 60;

    /** What stands before the last of them. */
    public enum Join {
        /** All of them. */
        AND(" and "),
        /** One of them. */
        OR(" or "),
        /** No word. */
        COMMA(", "),
        /** No word, between things that have commas of their own. */
        SEMICOLON("; ");

        private final String english;

        Join(String english) {
            this.english = english;
        }
    }

    private final Join join;
    private final List<Object> items;

    private Listing(Join join, List<?> items) {
        List<Object> checked = new ArrayList<>();
        int named = items.size() <= MAX_ITEMS ? items.size() : MAX_ITEMS - 1;
        items.subList(0, named).forEach(item -> checked.add(Message.checked(item)));
        if (named < items.size()) {
            checked.add("... (+" + (items.size() - named) + ")");
        }
        this.join = join;
        this.items = Collections.unmodifiableList(checked);
    }

    /**
     * All of several things.
     *
     * @param items as arguments of a {@link Message}
     * @return the row
     * @throws IllegalArgumentException if one is none
     */
    public static Listing and(List<?> items) {
        return new Listing(Join.AND, items);
    }

    /**
     * One of several things.
     *
     * @param items as arguments of a {@link Message}
     * @return the row
     * @throws IllegalArgumentException if one is none
     */
    public static Listing or(List<?> items) {
        return new Listing(Join.OR, items);
    }

    /**
     * Several things with nothing but commas between them.
     *
     * @param items as arguments of a {@link Message}
     * @return the row
     * @throws IllegalArgumentException if one is none
     */
    public static Listing comma(List<?> items) {
        return new Listing(Join.COMMA, items);
    }

    /**
     * Several sentences or the like, with nothing but semicolons between them.
     *
     * @param items as arguments of a {@link Message}
     * @return the row
     * @throws IllegalArgumentException if one is none
     */
    public static Listing semicolon(List<?> items) {
        return new Listing(Join.SEMICOLON, items);
    }

    /**
     * What stands before the last of them.
     *
     * @return never null
     */
    public Join join() {
        return join;
    }

    /**
     * The things.
     *
     * @return unmodifiable, in order
     */
    public List<Object> items() {
        return items;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Listing && join == ((Listing) other).join && items.equals(((Listing) other).items);
    }

    @Override
    public int hashCode() {
        return 31 * join.hashCode() + items.hashCode();
    }

    /** Other things in such a row. */
    public Listing withItems(List<?> others) {
        return new Listing(join, others);
    }

    public String english(Function<MessageKind, String> patterns) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < items.size(); i++) {
            boolean ownWord = i == items.size() - 1 || join == Join.SEMICOLON;
            text.append(i == 0 ? "" : ownWord ? join.english : ", ")
                    .append(Message.english(items.get(i), patterns));
        }
        return text.toString();
    }

    /** The row in English. */
    @Override
    public String toString() {
        return english(MessageKind::english);
    }
}
