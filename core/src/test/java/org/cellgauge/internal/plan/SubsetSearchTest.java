package org.cellgauge.internal.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;

/** Choices against all there are, and bounds against the best of these. */
class SubsetSearchTest {
    private static final int UNKNOWNS = 6;
    private static final int CANDIDATES = 14;
    private static final int TAKEN = 4;

    private static SubsetSearch search(long seed) {
        RandomGenerator random = new Well19937c(seed);
        double[][] rows = new double[4][UNKNOWNS];
        double[] own = new double[4];
        for (int a = 0; a < rows.length; a++) {
            own[a] = 0.01 * random.nextDouble();
            for (int i = 0; i < UNKNOWNS; i++) {
                rows[a][i] = random.nextGaussian();
            }
        }
        double[][][] candidates = new double[CANDIDATES][1][];
        for (double[][] candidate : candidates) {
            candidate[0] = information(random, 2);
        }
        return new SubsetSearch(List.of(new Design(UNKNOWNS, rows, own)), new double[][] {information(random, 7)},
                candidates, (a, b) -> a != b);
    }

    private static double[] information(RandomGenerator random, int observations) {
        double[] sum = new double[UNKNOWNS * UNKNOWNS];
        for (int k = 0; k < observations; k++) {
            double[] row = new double[UNKNOWNS];
            for (int i = 0; i < UNKNOWNS; i++) {
                row[i] = random.nextGaussian();
            }
            for (int i = 0; i < UNKNOWNS; i++) {
                for (int j = 0; j < UNKNOWNS; j++) {
                    sum[i * UNKNOWNS + j] += row[i] * row[j];
                }
            }
        }
        return sum;
    }

    @Test
    void exchangesFindTheBestOfAllAndBoundsLieBelowIt() {
        int best = 0;
        double gaps = 0;
        for (long seed = 1; seed <= 50; seed++) {
            SubsetSearch search = search(seed);
            SubsetSearch.Choice found = search.best(TAKEN);
            SubsetSearch.Choice all = search.exhaustive(TAKEN);
            assertNotNull(found);
            assertNotNull(all);
            assertTrue(found.worst() >= all.worst() * (1 - 1e-12));
            best += Math.sqrt(found.worst() / all.worst()) < 1.02 ? 1 : 0;
            double bound = search.bound(TAKEN, 400);
            assertTrue(bound <= all.worst() * (1 + 1e-12), "seed " + seed);
            gaps += Math.sqrt(all.worst() / bound) - 1;
        }
        assertTrue(gaps / 50 < 0.03, "mean gap " + gaps / 50);
        assertTrue(best >= 48, best + " of 50");
    }

    @Test
    void whatStandsInTheWayIsNotTaken() {
        RandomGenerator random = new Well19937c(3);
        double[][][] candidates = new double[6][1][];
        for (double[][] candidate : candidates) {
            candidate[0] = information(random, 2);
        }
        double[][] rows = {{1, 0, 0, 0, 0, 0}};
        SubsetSearch search = new SubsetSearch(List.of(new Design(UNKNOWNS, rows, new double[1])),
                new double[][] {information(random, 7)}, candidates, (a, b) -> a % 2 == b % 2);
        SubsetSearch.Choice found = search.best(3);
        assertNotNull(found);
        assertEquals(found.members().get(0) % 2, found.members().get(1) % 2);
        assertEquals(found.members().get(0) % 2, found.members().get(2) % 2);
    }
}
