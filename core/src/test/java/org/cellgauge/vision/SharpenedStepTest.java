package org.cellgauge.vision;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SharpenedStepTest {
    private static final double DARK = 50;
    private static final double CONTRAST = 150;
    private static final double BLUR = 0.9;

    /** Blurred by a Gaussian, a Gaussian edge is one of the summed variance: so overshoot has a closed form. */
    private static double step(double x, double radius) {
        return DARK + CONTRAST * EdgeProfile.cumulative(x / Math.sqrt(BLUR * BLUR + radius * radius));
    }

    private static SharpenedStep tables(double amount, double radius) {
        SharpenedStep tables = new SharpenedStep();
        int nodes = tables.prepare(5 * (BLUR + radius));
        for (int i = 0; i < nodes; i++) {
            tables.put(i, step(tables.distance(i), 0));
        }
        tables.solve(amount, radius);
        return tables;
    }

    /** Change of the residual by the amount and by the logarithm of the radius. */
    private static double[] at(SharpenedStep tables, double x) {
        double[] byAmount = new double[1];
        double[] byLogRadius = new double[1];
        tables.at(new double[] {x}, 1, byAmount, byLogRadius);
        return new double[] {byAmount[0], byLogRadius[0]};
    }

    @ParameterizedTest
    @CsvSource({"0.6, 1", "1, 0.7", "0.3, 2"})
    void overshootIsThatOfTwoGaussians(double amount, double radius) {
        double most = 0;
        for (double x = 0; x < 8; x += 0.01) {
            most = Math.max(most, step(x, 0) + amount * (step(x, 0) - step(x, radius)));
        }
        assertEquals((most - DARK - CONTRAST) / CONTRAST, tables(amount, radius).overshoot, 1e-3);
    }

    /** Without a mask the change by its amount is the edge less the blurred edge, and its radius changes nothing. */
    @ParameterizedTest
    @CsvSource({"1", "0.7", "2"})
    void changeByTheAmountIsTheDifferenceToTheBlurredEdge(double radius) {
        SharpenedStep tables = tables(0, radius);
        for (double x = -3; x <= 3; x += 0.5) {
            assertEquals(step(x, 0) - step(x, radius), at(tables, x)[0], 0.02);
            assertEquals(0, at(tables, x)[1], 1e-9);
        }
    }

    /**
     * With one, by differences of the residual {@code m - K s}, s the masked edge, K from the series
     * {@code K = (1 + q + q² + ...) / (1 + a)} with q = a G / (1 + a), whose Gaussians have closed forms.
     */
    @ParameterizedTest
    @CsvSource({"0.6, 1", "1, 0.8", "0.4, 1.6"})
    void changesAreThoseOfTheUndoneEdge(double amount, double radius) {
        SharpenedStep tables = tables(amount, radius);
        double h = 1e-3;
        for (double x = -3; x <= 3; x += 0.5) {
            double byAmount = left(x, amount + h, radius, amount, radius) - left(x, amount - h, radius, amount, radius);
            double byRadius = left(x, amount, radius * Math.exp(h), amount, radius)
                    - left(x, amount, radius * Math.exp(-h), amount, radius);
            // tables in steps of a quarter of a pixel, against changes of up to 10 grey levels
            assertEquals(byAmount / (2 * h), at(tables, x)[0], 0.15);
            assertEquals(byRadius / (2 * h), at(tables, x)[1], 0.15);
        }
    }

    /** m - K(a', r') (m + a (m - G m)), the mask undone being another one than the one that was there. */
    private static double left(double x, double undoneAmount, double undoneRadius, double amount, double radius) {
        double sum = 0;
        double weight = 1 / (1 + undoneAmount);
        for (int n = 0; n < 60; n++) {
            double variance = n * undoneRadius * undoneRadius;
            double edge = step(x, Math.sqrt(variance));
            double blurred = step(x, Math.sqrt(variance + radius * radius));
            sum += weight * (edge + amount * (edge - blurred));
            weight *= undoneAmount / (1 + undoneAmount);
        }
        return step(x, 0) - sum;
    }
}
