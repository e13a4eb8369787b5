package org.cellgauge.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** What is read of the report, and what its figures over many photos are. */
class HtmlReportTest {
    private static final Pattern COLOUR = Pattern.compile("--(\\w+):#([0-9a-f]{3,6})");

    /** Text and links stand out from their ground as WCAG 2.1, success criterion 1.4.3, asks for. */
    @Test
    void everyColourOfTextStandsOutInLightAndDark() {
        String style = HtmlReport.STYLE;
        int dark = style.indexOf("prefers-color-scheme:dark");
        for (String part : new String[] {style.substring(0, dark), style.substring(dark, style.indexOf("}}", dark))}) {
            Map<String, String> colours = new HashMap<>();
            Matcher matcher = COLOUR.matcher(part);
            while (matcher.find()) {
                colours.put(matcher.group(1), matcher.group(2));
            }
            for (String text : new String[] {"ink", "link", "pass", "fail", "doubt", "none"}) {
                double contrast = contrast(luminance(colours.get(text)), luminance(colours.get("paper")));
                assertTrue(contrast >= 4.5, text + " on " + colours.get("paper") + ": " + contrast);
            }
        }
        assertTrue(style.contains("a{color:var(--link)}"));
        // no colour but these
        assertEquals(style.split("#[0-9a-f]{3,6}", -1).length - 1,
                style.split("--\\w+:#", -1).length - 1);
    }

    private static double contrast(double a, double b) {
        return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    }

    /** Relative luminance of an sRGB colour, WCAG 2.1. */
    private static double luminance(String hex) {
        String six = hex.length() == 6 ? hex : hex.replaceAll(".", "$0$0");
        double[] weights = {0.2126, 0.7152, 0.0722};
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            double c = Integer.parseInt(six.substring(2 * i, 2 * i + 2), 16) / 255.0;
            sum += weights[i] * (c <= 0.03928 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4));
        }
        return sum;
    }

    /** Anscombe's first set (The American Statistician 27, 1973), whose line is in many textbooks. */
    @Test
    void aDriftIsTheSlopeOfTheLeastSquaresLine() {
        double[] x = {4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};
        double[] y = {4.26, 5.68, 7.24, 4.82, 6.95, 8.81, 8.04, 8.33, 10.84, 7.58, 9.96};
        PhotoTrend.Line line = new PhotoTrend.Line();
        for (int i = 0; i < x.length; i++) {
            line.add(x[i], y[i]);
        }
        assertEquals(7.5009, line.mean(), 1e-4);
        assertEquals(2.0316, line.scatter(), 1e-4);
        assertEquals(10 * 0.5001, line.drift(), 1e-3);
        assertEquals(10 * 0.1179, line.driftStd(), 1e-3);
        PhotoTrend.Line two = new PhotoTrend.Line();
        two.add(1, 3);
        two.add(2, 5);
        assertEquals(Math.sqrt(2), two.scatter(), 1e-12);
        assertTrue(Double.isNaN(two.drift()) && Double.isNaN(two.driftStd()));
    }
}
