package org.cellgauge.estimate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Collections;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class VarianceBudgetTest {
    @Test
    void aBudgetIsWorkedOutOnceWhenItIsAskedFor() {
        Map<VarianceSource, double[]> variances = new HashMap<>();
        variances.put(VarianceSource.placementOf(7), new double[] {1, 2, 3});
        variances.put(VarianceSource.CORNER_NOISE_OF_REFERENCES, new double[] {3, 2, 1});
        AtomicInteger times = new AtomicInteger();
        VarianceBudget budget = VarianceBudget.whenAsked(() -> {
            times.incrementAndGet();
            return new VarianceBudget(variances,
                    Collections.singletonMap(VarianceSource.placementOf(7), new double[] {1, 2, 3}));
        });
        assertEquals(0, times.get());
        IntStream.range(0, 8).parallel().forEach(i -> assertEquals(0.25,
                budget.shares(0).get(VarianceSource.placementOf(7))));
        assertEquals(0.5, budget.workedOut().gains(0).get(VarianceSource.placementOf(7)));
        assertEquals(1, times.get());
    }
}
