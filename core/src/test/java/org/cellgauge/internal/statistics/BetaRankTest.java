package org.cellgauge.internal.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.apache.commons.math3.distribution.BetaDistribution;
import org.junit.jupiter.api.Test;

class BetaRankTest {
    private static final double[] PROBABILITIES = {0.1586553, 0.8413447};

    @Test
    void rankIsWhereTheSolverFindsThePoint() {
        Random random = new Random(1);
        for (int i = 0; i < 2000; i++) {
            double size = Math.exp(random.nextDouble() * 10);
            double p = 0.005 + 0.99 * random.nextDouble();
            int total = 1 + random.nextInt(i % 2 == 0 ? 50_000 : 20);
            double alpha = size * p + 1;
            double beta = size * (1 - p) + 1;
            for (double probability : PROBABILITIES) {
                double point = new BetaDistribution(null, alpha, beta, 1e-13)
                        .inverseCumulativeProbability(probability);
                // wherever the search begins
                for (int deviations = -2; deviations <= 2; deviations++) {
                    assertEquals((int) Math.floor(point * total),
                            new BetaRank(alpha, beta, total).floor(probability, deviations),
                            "Beta(" + alpha + ", " + beta + ") of " + total);
                }
            }
        }
    }
}
