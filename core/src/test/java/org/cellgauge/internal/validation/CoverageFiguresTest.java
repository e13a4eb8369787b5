package org.cellgauge.internal.validation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class CoverageFiguresTest {
    private static CoverageStudy.Outcome outcome(double squared, boolean severalModes) {
        CoverageStudy.Standing standing = new CoverageStudy.Standing("camera");
        standing.regions.add("pose");
        standing.dimensions.add(6);
        standing.shares.add(0.5);
        standing.squared.add(squared);
        standing.severalModes = severalModes;
        CoverageStudy.Outcome outcome = new CoverageStudy.Outcome();
        outcome.standings.add(standing);
        return outcome;
    }

    @Test
    void squaredDistancesAreOfOneModeAndRegionsOfAll() {
        List<CoverageStudy.Outcome> outcomes = new ArrayList<>();
        outcomes.add(outcome(4, false));
        outcomes.add(outcome(9000, true));
        outcomes.add(outcome(10, false));

        CoverageFigures.Region region = CoverageFigures.of(outcomes).regions().get(0);

        assertEquals(3, region.trials());
        assertEquals(3, region.held());
        assertEquals(1, region.severalModes());
        assertEquals(2, region.squaredDistance().count());
        assertEquals(7, region.squaredDistance().value(), 1e-12);
    }
}
