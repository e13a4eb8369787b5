package org.cellgauge.internal.overlay;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.text.DecimalFormatSymbols;
import java.util.Arrays;
import java.util.Collections;
import java.util.Locale;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;

class LabelWordsTest {
    private static LabelWords words(Locale locale) {
        return new LabelWords(locale, "l", "m", "n", "o", "p", "q", "r", "s");
    }

    @Test
    void numbersAreWrittenAsTheLocaleWritesThem() {
        RandomGenerator random = new Well19937c(5);
        for (Locale locale : new Locale[] {Locale.ROOT, Locale.GERMAN, Locale.forLanguageTag("ar-EG")}) {
            String between = DecimalFormatSymbols.getInstance(locale).getDecimalSeparator() == ',' ? "; " : ", ";
            for (int i = 0; i < 2000; i++) {
                // two digits that count, from below a hundredth to beyond a hundred, now and then halfway between two
                double small = 0.0995 * random.nextDouble();
                double middle = 0.1 + Math.rint(890 * random.nextDouble()) / 1000;
                double large = 10 + Math.rint(2000 * random.nextDouble()) / 2;
                assertEquals("7: \u03c3 " + String.format(locale, "%.3f", small) + between
                        + String.format(locale, "%.2f", middle) + between
                        + String.format(locale, "%.0f", large) + " mm",
                        words(locale).deviations(7, new double[] {small, middle, large}));
            }
            assertEquals("7: r, " + String.format(locale, "%.0f %% / %.0f %%", 62.5, 37.5),
                    words(locale).ambiguous(7, Arrays.asList(0.625, 0.375)));
        }
        assertEquals("7: r", words(Locale.ROOT).ambiguous(7, Collections.emptyList()));
        assertEquals("s: \u03c3 ?, ?, 1.0 mm", words(Locale.ROOT).gripDeviations(
                new double[] {Double.NaN, Double.POSITIVE_INFINITY, 1}));
    }
}
