package org.cellgauge.internal.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CircularMomentsTest {
    @Test
    void anglesOnBothSidesOfZeroAverageToZeroAndNotToPi() {
        CircularMoments m = of(0.01, 6.27);
        // Two unit vectors: the mean bisects the shortest turn, and R is the cosine of half of it
        double half = (2 * Math.PI - 6.26) / 2;
        assertEquals(0.01 - half, m.meanDirectionRad(), 1e-14);
        assertEquals(Math.cos(half), m.resultantLength(), 1e-15);
        assertEquals(Math.sqrt(-2 * Math.log(Math.cos(half))), m.stdRad(), 1e-12);
        assertEquals(0, m.meanDirectionRad(), 0.002);
        assertEquals(2, m.count());
    }

    @Test
    void anglesOnBothSidesOfPiAverageToPi() {
        assertEquals(Math.PI, Math.abs(of(Math.PI - 0.3, -Math.PI + 0.3).meanDirectionRad()), 1e-14);
        assertEquals(Math.PI, of(Math.PI).meanDirectionRad(), 0);
        assertEquals(Math.PI, of(-Math.PI).meanDirectionRad(), 0);
        assertEquals(Math.PI, of(Math.PI, -Math.PI).meanDirectionRad(), 0);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 5, 6, 7, 12, 360, 1000})
    void directionsSpreadEvenlyHaveNoMean(int n) {
        CircularMoments m = new CircularMoments();
        for (int i = 0; i < n; i++) {
            m.add(2 * Math.PI * i / n);
        }
        assertTrue(Double.isNaN(m.meanDirectionRad()));
        assertEquals(0, m.resultantLength(), 1e-15);
        assertEquals(Double.POSITIVE_INFINITY, m.stdRad(), 0);
    }

    @Test
    void directionsThatAlmostCancelStillHaveAMean() {
        // The mean bisects the angle between two; its unit vectors sum to 2 sin(5e-6)
        CircularMoments m = of(0.5, 0.5 + Math.PI - 1e-5);
        assertEquals(0.5 + (Math.PI - 1e-5) / 2, m.meanDirectionRad(), 1e-10);
        assertEquals(Math.sin(5e-6), m.resultantLength(), 1e-15);
    }

    @Test
    void emptyAndNonFiniteStreamsAreNaN() {
        for (CircularMoments m : new CircularMoments[] {of(), of(0.1, Double.NaN), of(Double.POSITIVE_INFINITY)}) {
            assertTrue(Double.isNaN(m.meanDirectionRad()));
            assertTrue(Double.isNaN(m.resultantLength()));
            assertTrue(Double.isNaN(m.stdRad()));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 0.1, 1.0, 1.5})
    void stdOfWrappedNormalIsTheStdBeforeWrapping(double sigma) {
        // Midpoints of n equally probable slices would be biased in the tails; random draws with a bound from their
        // own Monte Carlo error: var(mean cos) <= (1 - rho^2)^2 / (2 n) for rho = exp(-sigma^2/2), and
        // d(std)/d(rho) = -1/(rho sigma), hence 5 standard errors below.
        int n = 40000;
        RandomGenerator random = new Well19937c(5);
        CircularMoments m = new CircularMoments();
        for (int i = 0; i < n; i++) {
            m.add(3 + sigma * random.nextGaussian());
        }
        double rho = Math.exp(-sigma * sigma / 2);
        double standardError = (1 - rho * rho) / Math.sqrt(2.0 * n) / (rho * sigma);
        assertEquals(sigma, m.stdRad(), 5 * standardError);
        double meanError = Math.sqrt((1 - Math.pow(rho, 4)) / (2 * n)) / rho;
        assertEquals(0, Angles.difference(m.meanDirectionRad(), 3), 5 * meanError);
    }

    @Test
    void narrowStdAgreesWithLinearStd() {
        double[] angles = {2e-5, -1e-5, -1e-5, 0};
        // mean 0, mean square 6e-10 / 4; the next term of the series is of relative size sigma^2
        assertEquals(1, of(angles).stdRad() / Math.sqrt(1.5e-10), 1e-5);
        assertEquals(0, of(0.3, 0.3, 0.3).stdRad(), 3e-8);
    }

    @Test
    void turnByAConstantTurnsTheMeanAndKeepsTheSpread() {
        RandomGenerator random = new Well19937c(8);
        CircularMoments a = new CircularMoments();
        CircularMoments b = new CircularMoments();
        for (int i = 0; i < 1000; i++) {
            double angle = random.nextGaussian();
            a.add(angle);
            b.add(angle + 40);
        }
        assertEquals(0, Angles.difference(b.meanDirectionRad(), a.meanDirectionRad() + 40), 1e-13);
        assertEquals(a.stdRad(), b.stdRad(), 1e-13);
    }

    @Test
    void mergedPartsEqualTheWholeAndCopiesAreIndependent() {
        RandomGenerator random = new Well19937c(9);
        CircularMoments all = new CircularMoments();
        CircularMoments first = new CircularMoments();
        CircularMoments second = new CircularMoments();
        for (int i = 0; i < 1000; i++) {
            double angle = 0.01 * random.nextGaussian();
            all.add(angle);
            (i < 300 ? first : second).add(angle);
        }
        CircularMoments copy = first.copy();
        first.merge(second);
        assertEquals(1000, first.count());
        assertEquals(300, copy.count());
        assertEquals(all.meanDirectionRad(), first.meanDirectionRad(), 1e-16);
        assertEquals(all.stdRad(), first.stdRad(), 1e-13);
        assertTrue(copy.meanDirectionRad() != first.meanDirectionRad());
    }

    private static CircularMoments of(double... angles) {
        CircularMoments m = new CircularMoments();
        for (double angle : angles) {
            m.add(angle);
        }
        return m;
    }
}
