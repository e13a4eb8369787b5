package org.cellgauge.internal.overlay;

import java.math.BigDecimal;
import java.util.Locale;
import org.cellgauge.internal.warning.Decimal;

/** What the legend of a picture says, in the language of whoever looks at it; immutable. */
public final class LegendWords {
    /** English words, numbers with a point. */
    public static final LegendWords ENGLISH = new LegendWords(Decimal.POINT, "reference",
            "where the camera pose puts it", "95 % of positions, true size", "95 %% of positions, magnified %s\u00d7",
            "not converged", "gripping point", "second pose", "\u03c3 = standard deviation in x, y, z",
            "grid %s mm on z = 0", "grid %1$s mm on z = 0, axes %1$s mm", "no marker was found");

    private final Locale locale;
    private final String reference;
    private final String expected;
    private final String ellipseTrueSize;
    private final String ellipseMagnified;
    private final String notConverged;
    private final String grip;
    private final String secondPose;
    private final String deviations;
    private final String grid;
    private final String gridAndAxes;
    private final String nothing;

    /**
     * Words. Letters that {@link StrokeFont} lacks are drawn as an empty box. What is called a pattern is one of
     * {@link String#format} with one argument, the number, as a text.
     *
     * @param locale how numbers are written
     * @param reference the outline of a reference
     * @param expected the outline where the camera pose puts a reference
     * @param ellipseTrueSize an ellipse that holds 95 % of an object's positions, as large as it is
     * @param ellipseMagnified pattern: the same, drawn so many times as large
     * @param notConverged what an ellipse is whose figures have not converged
     * @param grip the mark of a gripping point
     * @param secondPose the outline of an object's second pose
     * @param deviations what the figures with a sigma in labels are
     * @param grid pattern: the grid on the plane z = 0, with so many mm between its lines
     * @param gridAndAxes pattern: the same, with the axes of the world, which are as long
     * @param nothing there is nothing to explain because no marker was found
     */
    public LegendWords(Locale locale, String reference, String expected, String ellipseTrueSize,
            String ellipseMagnified, String notConverged, String grip, String secondPose, String deviations,
            String grid, String gridAndAxes, String nothing) {
        this.locale = locale;
        this.reference = reference;
        this.expected = expected;
        this.ellipseTrueSize = ellipseTrueSize;
        this.ellipseMagnified = ellipseMagnified;
        this.notConverged = notConverged;
        this.grip = grip;
        this.secondPose = secondPose;
        this.deviations = deviations;
        this.grid = grid;
        this.gridAndAxes = gridAndAxes;
        this.nothing = nothing;
    }

    String reference() {
        return reference;
    }

    String expected() {
        return expected;
    }

    String ellipse(double magnification, boolean converged) {
        String text = magnification == 1 ? ellipseTrueSize
                : String.format(locale, ellipseMagnified, plain(magnification));
        return converged ? text : text + ", " + notConverged;
    }

    String grip() {
        return grip;
    }

    String secondPose() {
        return secondPose;
    }

    String deviations() {
        return deviations;
    }

    String grid(double spacingMm, boolean withAxes) {
        return String.format(locale, withAxes ? gridAndAxes : grid, plain(spacingMm));
    }

    String nothing() {
        return nothing;
    }

    /** A number without digits that say nothing. */
    private String plain(double value) {
        int decimals = Math.max(0, BigDecimal.valueOf(value).stripTrailingZeros().scale());
        return String.format(locale, "%." + decimals + "f", value);
    }
}
