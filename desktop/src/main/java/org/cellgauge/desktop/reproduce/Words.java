package org.cellgauge.desktop.reproduce;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** Figures as people read them, and the figures of a set of chains. */
final class Words {
    private static final double QUARTER_DIGIT = 0.005;

    private Words() {
    }

    /** A setting: no more digits than it has. */
    static String number(double value) {
        return value == Math.rint(value) ? Long.toString(Math.round(value)) : Double.toString(value);
    }

    /** A deviation: two or three digits. */
    static String std(double value) {
        double size = Math.abs(value);
        if (!Double.isFinite(value)) {
            return "–";
        }
        return size < 1 - QUARTER_DIGIT ? fixed(value, 2) : size < 10 - 10 * QUARTER_DIGIT ? fixed(value, 1)
                : fixed(value, 0);
    }

    /** A number with so many decimals, the same in every language. */
    static String fixed(double value, int decimals) {
        String text = String.format(Locale.ROOT, "%." + decimals + "f", value);
        return text.matches("-0(\\.0*)?") ? text.substring(1) : text;
    }

    /** A share in per cent. */
    static String percent(double share) {
        return fixed(100 * share, 0) + " %";
    }

    /** A factor, as in {@code 3.2 times}. */
    static String times(double factor) {
        return std(factor) + " times";
    }

    static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2;
    }

    static double min(double[] values) {
        return Arrays.stream(values).min().orElse(Double.NaN);
    }

    static double max(double[] values) {
        return Arrays.stream(values).max().orElse(Double.NaN);
    }

    static double rms(double[] values) {
        return Math.sqrt(Arrays.stream(values).map(v -> v * v).average().orElse(Double.NaN));
    }

    static double geometricMean(double[] values) {
        return Math.exp(Arrays.stream(values).map(Math::log).average().orElse(Double.NaN));
    }

    /** Words as a list with {@code and} before the last. */
    static String and(List<String> words) {
        int last = words.size() - 1;
        return last < 1 ? String.join("", words)
                : String.join(", ", words.subList(0, last)) + " and " + words.get(last);
    }
}
