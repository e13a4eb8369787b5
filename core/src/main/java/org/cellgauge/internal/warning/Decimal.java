package org.cellgauge.internal.warning;

import java.math.BigDecimal;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/** A number as it is written, with so many decimals; immutable. Numbers are equal that are written alike. */
public final class Decimal {
    /**
     * For numbers with a point in {@link String#format}: written as of the root locale, but of this one alone Java
     * knows the signs by heart. Of others it loads tables of all languages, and asks them for every number.
     */
    public static final Locale POINT = Locale.US;

    private final double exact;
    private final int decimals;
    /** Written when it is first asked for, on whatever thread: all would write the same. */
    private @Nullable String text;

    private Decimal(double value, int decimals) {
        this.exact = value;
        this.decimals = decimals;
    }

    private String text() {
        String written = text;
        if (written == null) {
            // rounds halves up; all that is told is the rounded number, so that no other way of writing can round it
            // otherwise
            written = String.format(POINT, "%." + decimals + "f", exact);
            text = written;
        }
        return written;
    }

    /**
     * A number rounded.
     *
     * @param value any number; NaN and infinities are kept
     * @param decimals digits after the point, at least 0
     * @return the number
     */
    public static Decimal of(double value, int decimals) {
        return new Decimal(value, decimals);
    }

    /**
     * A number with as many decimals as it takes to tell it from its neighbours.
     *
     * @param value finite
     * @return the number
     */
    public static Decimal shortest(double value) {
        return new Decimal(value, Math.max(0, BigDecimal.valueOf(value).stripTrailingZeros().scale()));
    }

    /**
     * The number.
     *
     * @return rounded to {@link #decimals()}
     */
    public double value() {
        return Double.parseDouble(text());
    }

    /**
     * Digits after the point.
     *
     * @return at least 0
     */
    public int decimals() {
        return decimals;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Decimal && text().equals(((Decimal) other).text());
    }

    @Override
    public int hashCode() {
        return text().hashCode();
    }

    /** The number with a point and without grouping. */
    @Override
    public String toString() {
        return text();
    }
}
