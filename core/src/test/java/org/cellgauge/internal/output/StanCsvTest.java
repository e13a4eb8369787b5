package org.cellgauge.internal.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

class StanCsvTest {
    /** A camera that looks straight down has psi at half a turn, and draws to both sides of it. */
    @Test
    void drawsToBothSidesOfHalfATurnStayTogether() {
        Random random = new Random(1);
        for (double direction : new double[] {Math.PI, -Math.PI, Math.PI - 5e-4, 5e-4 - Math.PI}) {
            double sum = 0;
            double squares = 0;
            for (int i = 0; i < 1000; i++) {
                double off = 1e-3 * random.nextGaussian();
                double drawn = direction + off;
                // as it comes from a rotation: in (-pi, pi]
                drawn = drawn > Math.PI ? drawn - 2 * Math.PI : drawn <= -Math.PI ? drawn + 2 * Math.PI : drawn;
                double written = StanCsv.unwrapped(drawn, direction);
                sum += written;
                squares += off * off;
                assertEquals(0, Math.sin((written - drawn) / 2), 1e-15, "the same direction");
            }
            // the mean of a thousand is within four of its own deviations
            double mean = sum / 1000;
            assertEquals(Math.PI, Math.abs(mean), 5e-4 + 4 * Math.sqrt(squares) / 1000, direction + "");
        }
    }

    @Test
    void anglesAwayFromHalfATurnKeepTheirDigits() {
        for (double angle : new double[] {0, 0.1, -3, 3.0821286410472109, Math.PI}) {
            assertEquals(angle, StanCsv.unwrapped(angle, angle - 0.05));
        }
        assertTrue(StanCsv.unwrapped(-3.1, 3.1) > Math.PI);
        assertTrue(StanCsv.unwrapped(3.1, -3.1) < -Math.PI);
    }
}
