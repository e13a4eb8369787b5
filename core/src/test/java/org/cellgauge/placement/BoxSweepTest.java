package org.cellgauge.placement;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.apache.commons.math3.random.RandomGenerator;
import org.apache.commons.math3.random.Well19937c;
import org.junit.jupiter.api.Test;

class BoxSweepTest {
    @Test
    void findsThePairsThatComparingAllWithAllFindsInThatOrder() {
        RandomGenerator random = new Well19937c(1);
        for (int axes = 2; axes <= 3; axes++) {
            List<double[]> least = new ArrayList<>();
            List<double[]> most = new ArrayList<>();
            for (int i = 0; i < 60; i++) {
                double[] low = new double[axes];
                double[] high = new double[axes];
                for (int axis = 0; axis < axes; axis++) {
                    low[axis] = random.nextDouble();
                    high[axis] = low[axis] + 0.3 * random.nextDouble();
                }
                least.add(low);
                most.add(high);
            }
            List<int[]> expected = new ArrayList<>();
            for (int b = 0; b < 60; b++) {
                for (int a = 0; a < b; a++) {
                    boolean apart = false;
                    for (int axis = 0; axis < axes; axis++) {
                        apart |= most.get(a)[axis] < least.get(b)[axis] || most.get(b)[axis] < least.get(a)[axis];
                    }
                    if (!apart) {
                        expected.add(new int[] {a, b});
                    }
                }
            }
            assertTrue(expected.size() > 20 && expected.size() < 1000);
            assertArrayEquals(expected.toArray(), BoxSweep.touching(least, most).toArray());
        }
    }

    @Test
    void boxesThatShareAnEdgeTouchAndNoneIsNoPair() {
        List<double[]> least = List.of(new double[] {1, 0}, new double[] {0, 0});
        List<double[]> most = List.of(new double[] {2, 1}, new double[] {1, 1});
        assertEquals(1, BoxSweep.touching(least, most).size());
        assertEquals(0, BoxSweep.touching(Collections.emptyList(), Collections.emptyList()).size());
    }
}
