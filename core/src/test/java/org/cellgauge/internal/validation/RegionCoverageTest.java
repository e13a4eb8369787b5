package org.cellgauge.internal.validation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class RegionCoverageTest {
    @Test
    void regionHoldsATruthThatFewerDrawsThanItsShareAreNearerThan() {
        RegionCoverage region = new RegionCoverage("x", 2, new double[] {0.1, 0.5, 0.94, 0.96}, new double[4], 0.99);
        assertEquals(2, region.hits(0.5));
        assertEquals(3, region.hits(0.95));
    }

    /** For two dimensions the chi-square distribution is 1 - exp(-x / 2). */
    @Test
    void gaussianRegionIsSizedByTheChiSquareQuantile() {
        double edge = -2 * Math.log(0.05);
        double[] distances = {edge - 1e-6, edge + 1e-6};
        RegionCoverage region = new RegionCoverage("x", 2, new double[2], distances, 0.99);
        assertEquals(1, region.gaussianHits(0.95));
    }

    @Test
    void withoutTrialsNothingIsCovered() {
        RegionCoverage region = new RegionCoverage("x", 3, new double[0], new double[0], 0.99);
        assertFalse(region.covers(0.95));
        assertEquals(0, region.hits(0.95));
    }

    @Test
    void tooManyHitsAreAsDishonestAsTooFew() {
        double[] inside = new double[200];
        RegionCoverage always = new RegionCoverage("x", 3, inside, inside, 0.99);
        assertFalse(always.covers(0.8));
        double[] spread = new double[200];
        for (int i = 0; i < 200; i++) {
            spread[i] = (i + 0.5) / 200;
        }
        assertTrue(new RegionCoverage("x", 3, spread, inside, 0.99).covers(0.8));
    }
}
