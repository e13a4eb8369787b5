package org.cellgauge.internal.overlay;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.text.DecimalFormatSymbols;
import java.util.List;
import java.util.Locale;

/** What the labels beside the markers say, in the language of whoever looks at them; immutable. */
public final class LabelWords {
    /** English words, numbers with a point. */
    public static final LabelWords ENGLISH = new LabelWords('.', '0', "left out", "seems off", "not seen",
            "not in the cell file", "not converged", "not converged yet", "ambiguous", "grip");

    private final char decimalSeparator;
    private final char zero;
    private final String leftOut;
    private final String misplaced;
    private final String notSeen;
    private final String notInCell;
    private final String notConverged;
    private final String notConvergedYet;
    private final String ambiguous;
    private final String grip;

    /**
     * Words. Letters that {@link StrokeFont} lacks are drawn as an empty box.
     *
     * @param locale how numbers are written
     * @param leftOut of a reference that the camera pose does not rest on
     * @param misplaced of a reference that does not stand where the others say
     * @param notSeen of a reference that was expected in view
     * @param notInCell of a marker that the cell file does not name
     * @param notConverged of an object whose chains ended without converging
     * @param notConvergedYet of figures whose chains are still running
     * @param ambiguous of an object with two poses
     * @param grip before the figures of a gripping point
     */
    public LabelWords(Locale locale, String leftOut, String misplaced, String notSeen, String notInCell,
            String notConverged, String notConvergedYet, String ambiguous, String grip) {
        this(DecimalFormatSymbols.getInstance(locale), leftOut, misplaced, notSeen, notInCell, notConverged,
                notConvergedYet, ambiguous, grip);
    }

    private LabelWords(DecimalFormatSymbols symbols, String leftOut, String misplaced, String notSeen,
            String notInCell, String notConverged, String notConvergedYet, String ambiguous, String grip) {
        this(symbols.getDecimalSeparator(), symbols.getZeroDigit(), leftOut, misplaced, notSeen, notInCell,
                notConverged, notConvergedYet, ambiguous, grip);
    }

    private LabelWords(char decimalSeparator, char zero, String leftOut, String misplaced, String notSeen,
            String notInCell, String notConverged, String notConvergedYet, String ambiguous, String grip) {
        this.decimalSeparator = decimalSeparator;
        this.zero = zero;
        this.leftOut = leftOut;
        this.misplaced = misplaced;
        this.notSeen = notSeen;
        this.notInCell = notInCell;
        this.notConverged = notConverged;
        this.notConvergedYet = notConvergedYet;
        this.ambiguous = ambiguous;
        this.grip = grip;
    }

    String leftOut(int id) {
        return id + " " + leftOut;
    }

    String misplaced(int id) {
        return id + " " + misplaced;
    }

    String notSeen(int id) {
        return id + " " + notSeen;
    }

    String notInCell(int id) {
        return id + " " + notInCell;
    }

    String notConverged(int id) {
        return id + ": " + notConverged;
    }

    String notConvergedYet() {
        return notConvergedYet;
    }

    /** With the shares of the poses, where the object itself has several. */
    String ambiguous(int id, List<Double> shares) {
        StringBuilder text = new StringBuilder(id + ": " + ambiguous);
        for (int i = 0; i < shares.size(); i++) {
            text.append(i == 0 ? ", " : " / ").append(rounded(100 * shares.get(i), 0)).append(" %");
        }
        return text.toString();
    }

    String deviations(int id, double[] stdMm) {
        return id + ": \u03c3 " + figures(stdMm);
    }

    String gripDeviations(double[] stdMm) {
        return grip + ": \u03c3 " + figures(stdMm);
    }

    private String figures(double[] std) {
        // a comma cannot both part decimals and figures
        String between = decimalSeparator == ',' ? "; " : ", ";
        return figure(std[0]) + between + figure(std[1]) + between + figure(std[2]) + " mm";
    }

    /** Two digits that count: more would say more than a standard deviation is known to. */
    private String figure(double value) {
        int decimals = value >= 9.95 ? 0 : value >= 0.995 ? 1 : value >= 0.0995 ? 2 : 3;
        return rounded(value, decimals);
    }

    /** As {@link String#format} writes it in the locale, which looks the locale up for each number anew. */
    private String rounded(double value, int decimals) {
        if (!Double.isFinite(value)) {
            return "?";
        }
        String plain = BigDecimal.valueOf(value).setScale(decimals, RoundingMode.HALF_UP).toPlainString();
        if (decimalSeparator == '.' && zero == '0') {
            return plain;
        }
        StringBuilder text = new StringBuilder(plain);
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            text.setCharAt(i, c == '.' ? decimalSeparator : Character.isDigit(c) ? (char) (c - '0' + zero) : c);
        }
        return text.toString();
    }
}
