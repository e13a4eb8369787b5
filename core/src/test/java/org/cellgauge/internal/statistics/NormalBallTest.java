package org.cellgauge.internal.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Distances of normal vectors. */
class NormalBallTest {
    /** Quantiles of the chi-square distribution with 1 and 3 degrees of freedom, of tables. */
    @ParameterizedTest
    @CsvSource({"0.9, 2.7055434541, 6.2513886311", "0.95, 3.8414588207, 7.8147279033",
        "0.99, 6.6348966010, 11.3448667301"})
    void tablesOfChiSquareAreMet(double probability, double ofOne, double ofThree) {
        double[] line = {4, 0, 0, 0, 0, 0, 0, 0, 0};
        double[] ball = {4, 0, 0, 0, 4, 0, 0, 0, 4};
        assertEquals(probability, NormalBall.within(ball, 2 * Math.sqrt(ofThree)), 1e-9);
        assertEquals(2 * Math.sqrt(ofThree), NormalBall.distance(ball, probability), 1e-6);
        // of a line what lies across is 0: the integral is no longer smooth there
        assertEquals(probability, NormalBall.within(line, 2 * Math.sqrt(ofOne)), 2e-3);
        assertEquals(probability, NormalBall.within(Math.sqrt(ofOne)), 1e-9);
        assertEquals(Math.sqrt(ofOne), NormalBall.deviations(probability), 1e-9);
    }

    @Test
    void drawsOfASkewDistributionAgree() {
        double[][] root = {{1, 0, 0}, {-0.5, 0.4, 0}, {2, 0.3, 0.7}};
        double[] covariance = new double[9];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                for (int k = 0; k < 3; k++) {
                    covariance[3 * i + j] += root[i][k] * root[j][k];
                }
            }
        }
        double distance = NormalBall.distance(covariance, 0.95);
        Random random = new Random(7);
        int within = 0;
        int draws = 400_000;
        for (int d = 0; d < draws; d++) {
            double[] z = {random.nextGaussian(), random.nextGaussian(), random.nextGaussian()};
            double square = 0;
            for (double[] row : root) {
                double x = row[0] * z[0] + row[1] * z[1] + row[2] * z[2];
                square += x * x;
            }
            within += square <= distance * distance ? 1 : 0;
        }
        assertEquals(0.95, (double) within / draws, 4 * Math.sqrt(0.95 * 0.05 / draws));
    }
}
