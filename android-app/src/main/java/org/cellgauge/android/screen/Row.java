package org.cellgauge.android.screen;

import java.util.Objects;
import java.util.OptionalInt;

/** One row of the list, ready to be shown; immutable. Parts that are null take no room. */
final class Row {
    private final int mark;
    private final int colour;
    private final String title;
    private final String figures;
    private final String text;
    private final Action action;
    private double bar = Double.NaN;
    private OptionalInt objectId = OptionalInt.empty();
    private String barText;

    /**
     * A row.
     *
     * @param mark its drawable
     * @param colour the mark's colour resource
     * @param title a few words
     * @param figures numbers, or null
     * @param text what else there is to say, or null
     * @param action what can be done, or null
     */
    Row(int mark, int colour, String title, String figures, String text, Action action) {
        this.mark = mark;
        this.colour = colour;
        this.title = title;
        this.figures = figures;
        this.text = text;
        this.action = action;
    }

    int mark() {
        return mark;
    }

    int colour() {
        return colour;
    }

    String title() {
        return title;
    }

    String figures() {
        return figures;
    }

    String text() {
        return text;
    }

    Action action() {
        return action;
    }

    /** The same row with a bar: how much of what is asked is taken, 1 at the limit; NaN for none. */
    Row withBar(double share, String words) {
        Row row = new Row(mark, colour, title, figures, text, action);
        row.bar = share;
        row.barText = words;
        return row;
    }

    /** The same row, which leads to all that is known of an object. */
    Row ofObject(int id) {
        Row row = withBar(bar, barText);
        row.objectId = OptionalInt.of(id);
        return row;
    }

    /** The same row with another text, or null, which leads nowhere. */
    Row telling(String other) {
        Row row = new Row(mark, colour, title, figures, other, action);
        row.bar = bar;
        row.barText = barText;
        return row;
    }

    OptionalInt objectId() {
        return objectId;
    }

    double bar() {
        return bar;
    }

    String barText() {
        return barText;
    }

    @Override
    public boolean equals(Object other) {
        if (!(other instanceof Row)) {
            return false;
        }
        Row o = (Row) other;
        return mark == o.mark && colour == o.colour && title.equals(o.title) && Objects.equals(figures, o.figures)
                && Objects.equals(text, o.text) && action == o.action
                && Double.compare(bar, o.bar) == 0 && Objects.equals(barText, o.barText)
                && objectId.equals(o.objectId);
    }

    @Override
    public int hashCode() {
        return Objects.hash(mark, colour, title, figures, text, action, bar, barText, objectId);
    }
}
