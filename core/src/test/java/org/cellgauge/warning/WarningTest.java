package org.cellgauge.warning;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import org.cellgauge.internal.warning.Decimal;
import org.cellgauge.internal.warning.Listing;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

@Isolated("changes the default locale")
class WarningTest {
    private static final Locale USUAL = Locale.getDefault();

    /** Sentences with places, with none, and with a per cent sign. */
    private enum Kind implements WarningKind {
        TWO("marker %s is %s px wide"),
        SHARE("%s %% of it"),
        ROW("not seen: %s"),
        BARE("nothing to say");

        private final String english;

        Kind(String english) {
            this.english = english;
        }

        @Override
        public String english() {
            return english;
        }
    }

    @AfterEach
    void usualLocale() {
        Locale.setDefault(USUAL);
    }

    @Test
    void sentenceIsEnglishWhateverTheMachineSpeaks() {
        Locale.setDefault(Locale.GERMANY);
        assertEquals("marker 12345 is 1234.6 px wide", Warning.of(Kind.TWO, 12345, Decimal.of(1234.56, 1)).toString());
        assertEquals("7 % of it", Warning.of(Kind.SHARE, Decimal.of(6.7, 0)).toString());
        assertEquals("nothing to say", Warning.of(Kind.BARE).toString());
    }

    @Test
    void partsOfASentenceStandInIt() {
        Warning part = Warning.of(Kind.TWO, 5, Decimal.of(3, 1));
        assertEquals("not seen: marker 5 is 3.0 px wide", Warning.of(Kind.ROW, part).toString());
        assertEquals("not seen: marker 5 is 3.0 px wide, 7",
                Warning.of(Kind.ROW, Listing.comma(Arrays.asList(part, 7))).toString());
        assertEquals("not seen: ", Warning.of(Kind.ROW, "").toString());
    }

    @Test
    void rowsHaveAWordBeforeTheLast() {
        List<Integer> ids = Arrays.asList(5, 20, 30);
        assertEquals("5, 20 and 30", Listing.and(ids).toString());
        assertEquals("5, 20 or 30", Listing.or(ids).toString());
        assertEquals("5, 20, 30", Listing.comma(ids).toString());
        assertEquals("5 or 20", Listing.or(ids.subList(0, 2)).toString());
        assertEquals("5", Listing.and(ids.subList(0, 1)).toString());
        assertEquals("", Listing.and(Collections.emptyList()).toString());
    }

    @Test
    void equalWhereKindAndArgumentsAre() {
        Warning one = Warning.of(Kind.TWO, 5, Decimal.of(0.31, 1));
        assertEquals(one, Warning.of(Kind.TWO, 5, Decimal.of(0.29, 1)), "written alike");
        assertEquals(one.hashCode(), Warning.of(Kind.TWO, 5, Decimal.of(0.29, 1)).hashCode());
        assertNotEquals(one, Warning.of(Kind.TWO, 6, Decimal.of(0.31, 1)));
        assertNotEquals(one, Warning.of(Kind.TWO, 5, Decimal.of(0.31, 2)));
        assertNotEquals(Warning.of(Kind.ROW, "a"), Warning.of(Kind.SHARE, "a"));
        assertNotEquals(Listing.and(Arrays.asList(1, 2)), Listing.or(Arrays.asList(1, 2)));
        assertEquals(Listing.or(Arrays.asList(1, 2)), Listing.or(Arrays.asList(1, 2)));
    }

    @Test
    void numbersAreRoundedOnceAndForAll() {
        assertEquals("0.3", Decimal.of(0.25, 1).toString(), "halves up");
        assertEquals(0.3, Decimal.of(0.25, 1).value());
        assertEquals(3, Decimal.of(2.5, 0).value(), "also where another way of writing would round halves to even");
        assertEquals("-1.50", Decimal.of(-1.5, 2).toString());
        assertEquals(2, Decimal.of(-1.5, 2).decimals());
        assertEquals("NaN", Decimal.of(Double.NaN, 1).toString());
        assertEquals(Double.POSITIVE_INFINITY, Decimal.of(Double.POSITIVE_INFINITY, 1).value());
    }

    @Test
    void shortestNumberHasNoDigitToSpare() {
        assertEquals("2", Decimal.shortest(2).toString());
        assertEquals("0.1", Decimal.shortest(0.1).toString());
        assertEquals("100", Decimal.shortest(100).toString());
        assertEquals("0.0005", Decimal.shortest(0.0005).toString());
    }

    @Test
    void argumentsMustFitThePattern() {
        assertThrows(IllegalArgumentException.class, () -> Warning.of(Kind.TWO, 5));
        assertThrows(IllegalArgumentException.class, () -> Warning.of(Kind.BARE, 5));
        assertThrows(IllegalArgumentException.class, () -> Warning.of(Kind.SHARE, 0.5), "rounded by nobody");
        assertThrows(IllegalArgumentException.class, () -> Listing.and(Collections.singletonList(0.5)));
        assertThrows(IllegalArgumentException.class, () -> Warning.of(Kind.ROW, (Object) null));
    }
}
