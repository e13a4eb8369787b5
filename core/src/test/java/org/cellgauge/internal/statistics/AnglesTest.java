package org.cellgauge.internal.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class AnglesTest {
    private static final double PI = Math.PI;

    @ParameterizedTest
    @CsvSource({"0, 0, 0", "0.5, 0.5, 0.5", "1, 1, 1", "-1, 1, 1", "1.5, -0.5, 1.5", "-0.5, -0.5, 1.5", "2, 0, 0",
        "-2, 0, 0", "3, 1, 1", "-3, 1, 1", "2.25, 0.25, 0.25", "-7.75, 0.25, 0.25"})
    void multiplesOfPiWrapToBothIntervals(double turns, double toPi, double toTwoPi) {
        assertEquals(toPi * PI, Angles.wrapToPi(turns * PI), 1e-14);
        assertEquals(toTwoPi * PI, Angles.wrapToTwoPi(turns * PI), 1e-14);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void wrappedAnglesLieInTheirIntervalsAndPointTheSameWay(long seed) {
        RandomGenerator random = new Well19937c(seed);
        for (int i = 0; i < 1000; i++) {
            double angle = 100 * (random.nextDouble() - 0.5);
            double p = Angles.wrapToPi(angle);
            double t = Angles.wrapToTwoPi(angle);
            assertTrue(p > -PI && p <= PI);
            assertTrue(t >= 0 && t < 2 * PI);
            assertEquals(Math.cos(angle), Math.cos(p), 1e-13);
            assertEquals(Math.sin(angle), Math.sin(p), 1e-13);
            assertEquals(Math.cos(angle), Math.cos(t), 1e-13);
            assertEquals(Math.sin(angle), Math.sin(t), 1e-13);
        }
    }

    @Test
    void endsOfTheIntervalsAreHalfOpen() {
        assertEquals(PI, Angles.wrapToPi(PI), 0);
        assertEquals(PI, Angles.wrapToPi(-PI), 0);
        assertEquals(0.0, Angles.wrapToTwoPi(2 * PI), 0);
        assertEquals(0.0, Angles.wrapToTwoPi(-1e-300), 0, "2 pi minus almost nothing rounds to 2 pi, which is 0");
        assertEquals(0, Double.compare(0.0, Angles.wrapToTwoPi(-0.0)));
        assertTrue(Double.isNaN(Angles.wrapToPi(Double.POSITIVE_INFINITY)));
        assertTrue(Double.isNaN(Angles.wrapToTwoPi(Double.NEGATIVE_INFINITY)));
        assertTrue(Double.isNaN(Angles.wrapToPi(Double.NaN)));
    }

    @Test
    void differenceIsTheShortestTurn() {
        assertEquals(2 * PI - 6.26, Angles.difference(0.01, 6.27), 1e-14);
        assertEquals(6.26 - 2 * PI, Angles.difference(6.27, 0.01), 1e-14);
        assertEquals(0.2, Angles.difference(-PI + 0.1, PI - 0.1), 1e-14);
        assertEquals(PI, Angles.difference(0, PI), 0);
    }

    @Test
    void drawsAcrossTheSeamStayTogetherWhenUnrolled() {
        ReferenceAngle reference = new ReferenceAngle(-PI + 0.05);
        assertEquals(-PI + 0.1, reference.unroll(-PI + 0.1), 1e-15);
        assertEquals(-PI - 0.1, reference.unroll(PI - 0.1), 1e-14);
        assertEquals(0.2, reference.unroll(-PI + 0.1) - reference.unroll(PI - 0.1), 1e-14);
        assertEquals(0.1 - PI, new ReferenceAngle(PI + 0.1).referenceRad(), 1e-15);
        assertThrows(IllegalArgumentException.class, () -> new ReferenceAngle(Double.NaN));
    }
}
